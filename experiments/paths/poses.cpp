// Single poses: from a study file or a program, or from a CSV file beside the study.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

#include "experiments/path.hpp"
#include "numerics/inputs.hpp"
#include "numerics/names.hpp"
#include "numerics/number.hpp"
#include "numerics/units.hpp"
#include "results/csv.hpp"
#include "robots/rotation.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace robots;
using namespace results;

namespace {

constexpr std::string_view expected_columns =
    "x, y and z with _m, _cm or _mm, such as x_cm; and qw, qx, qy, qz, or roll, pitch and yaw with _deg or _rad";
constexpr std::size_t most_rows = 100'000;

using ColumnNames = std::span<const std::string_view>;
constexpr std::array<std::string_view, 3> position_names{"x", "y", "z"}, rpy_names{"roll", "pitch", "yaw"};
constexpr std::array<std::string_view, 4> quaternion_names{"qw", "qx", "qy", "qz"};

using EndOfName = std::pair<std::string_view, double>;  // the end of a column's name, and the unit that it means
using Units = std::span<const EndOfName>;
constexpr std::array length_units{EndOfName{"_m", 1}, EndOfName{"_cm", centimetre}, EndOfName{"_mm", 1e-3}};
constexpr std::array angle_units{EndOfName{"_deg", degree}, EndOfName{"_rad", 1}};
constexpr std::array no_unit{EndOfName{"", 1}};

struct Column {
  std::size_t place;
  double unit;
  std::string_view name;
};

// Quotes a text for a message.
std::string shown(std::string_view text) {
  constexpr std::size_t longest = 40;
  text = text.substr(0, longest);
  return is_plain(text) ? fmt::format("\"{}\"", text) : "bytes that are no text";
}

struct Table {
  CsvTable csv;
  std::string_view file;
  std::size_t row = 0;  // from 1; 0: the names of the columns

  std::string_view cell(std::size_t place) const {
    return trimmed(row == 0 ? csv.header[place] : csv.cell(row - 1, place));
  }
  [[noreturn]] void refuse(std::string_view what) const {
    throw std::invalid_argument(fmt::format("{}:{}: {}", file, row == 0 ? 1 : csv.line(row - 1), what));
  }

  double number(const Column& column) const {
    const std::optional<double> value = number_from(cell(column.place));
    constexpr double most = 1e6;
    if (value && std::fabs(*value) <= most) return *value * column.unit;
    refuse(fmt::format("column {} ({}) is {}; expected a number from -1e6 to 1e6", column.place + 1, column.name,
                       shown(cell(column.place))));
  }
};

// Finds the columns of a group; none if the header has none of them. A group must be complete.
std::vector<Column> columns_of(ColumnNames names, Units units, const Table& table, std::vector<bool>& used) {
  std::vector<Column> found;
  std::vector<std::string_view> missing;
  for (const std::string_view name : names) {
    const std::size_t before = found.size();
    for (std::size_t place = 0; place < table.csv.header.size(); ++place) {
      for (const auto& [ending, unit] : units) {
        if (table.cell(place) != std::string(name) + std::string(ending)) continue;
        if (found.size() > before) table.refuse(fmt::format("there are two columns for {}; expected one", name));
        found.push_back({place, unit, table.cell(place)});
        used[place] = true;
      }
    }
    if (found.size() == before) missing.push_back(name);
  }
  if (!found.empty() && !missing.empty()) {
    table.refuse(fmt::format("the column for {} is missing; expected {}", fmt::join(missing, ", "), expected_columns));
  }
  return found;
}

struct Columns {
  std::vector<Column> position, quaternion, rpy;
};

Columns columns_in(const Table& table) {
  std::vector<bool> used(table.csv.header.size(), false);
  Columns columns{.position = columns_of(position_names, length_units, table, used),
                  .quaternion = columns_of(quaternion_names, no_unit, table, used),
                  .rpy = columns_of(rpy_names, angle_units, table, used)};
  if (const auto unknown = std::ranges::find(used, false); unknown != used.end()) {
    const auto place = static_cast<std::size_t>(unknown - used.begin());
    table.refuse(fmt::format("column {} is {}; expected {}", place + 1, shown(table.cell(place)), expected_columns));
  }
  if (columns.position.empty()) table.refuse(fmt::format("there is no position; expected {}", expected_columns));
  if (!columns.quaternion.empty() && !columns.rpy.empty())
    table.refuse("there are two kinds of rotation; expected a quaternion, or roll, pitch and yaw");
  return columns;
}

template <class Numbers>
Numbers numbers_in(const std::vector<Column>& columns, const Table& table) {
  Numbers values;
  for (std::size_t i = 0; i < columns.size(); ++i) values[static_cast<Eigen::Index>(i)] = table.number(columns[i]);
  return values;
}

Eigen::Matrix3d rotation_in(const Columns& columns, const Table& table) {
  if (!columns.quaternion.empty()) {
    const auto q = numbers_in<Eigen::Vector4d>(columns.quaternion, table);
    constexpr double tolerance = 0.01;
    if (!(std::fabs(q.norm() - 1) <= tolerance)) {
      table.refuse(fmt::format("the quaternion has the length {:.6g}; expected 1", q.norm()));
    }
    const Eigen::Vector4d unit = q / q.norm();
    return Eigen::Quaterniond(unit[0], unit[1], unit[2], unit[3]).toRotationMatrix();
  }
  if (!columns.rpy.empty()) return rotation_from_rpy(numbers_in<Eigen::Vector3d>(columns.rpy, table));
  return rotation(Tool::down);
}

class Poses : public PathKind {
 public:
  explicit Poses(std::vector<Pose> poses = {}) : poses_(std::move(poses)) {}
  std::unique_ptr<PathKind> copy() const override { return std::make_unique<Poses>(*this); }

  std::string_view name() const override { return "poses"; }
  std::string_view summary() const override {
    return "a list of poses: { position_cm = [60, 0, 35], rpy_deg = [180, 0, 180] }";
  }

  void list_fields(Fields& io) override { io.poses("poses", poses_); }

  int points() const override { return static_cast<int>(poses_.size()); }
  std::vector<Pose> poses(const Robot&, Random&) const override { return poses_; }

 protected:
  std::vector<Pose> poses_;
};

class CsvPath final : public Poses {
 public:
  std::unique_ptr<PathKind> copy() const override { return std::make_unique<CsvPath>(*this); }

  std::string_view name() const override { return "csv"; }
  std::string_view summary() const override { return "poses from a CSV file: x_cm, y_cm, z_cm, qw, qx, qy, qz"; }

  // The key has the poses, so the file's name does not matter.
  void list_fields(Fields& io) override {
    io.text("file", file_,
            "beside the study. Columns: x, y, z in _m, _cm or _mm; then qw, qx, qy, qz, or roll, pitch, yaw in _deg or "
            "_rad; without these the tool points straight down",
            InKey::no);
  }

  void load(const std::filesystem::path& folder) override {
    const std::filesystem::path file = folder / file_;
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) {
      throw std::invalid_argument(
          fmt::format("there is no file {}; expected a CSV file of poses in the study's folder", file.string()));
    }
    const std::filesystem::path home = std::filesystem::canonical(folder.empty() ? "." : folder),
                                meant = std::filesystem::canonical(file);
    if (std::mismatch(home.begin(), home.end(), meant.begin(), meant.end()).first != home.end()) {
      throw std::invalid_argument(
          fmt::format("path.file is \"{}\", which is outside the study's folder; expected a CSV file in it", file_));
    }
    constexpr std::uintmax_t most_bytes = 16'000'000;
    poses_ = poses_from_csv(text_of_file(file, most_bytes), file.string());
  }

 private:
  std::string file_;
};

}  // namespace

std::vector<Pose> poses_from_csv(std::string_view text, std::string_view file) {
  Table table{parse_csv(text, file), file};
  const Columns columns = columns_in(table);
  std::vector<Pose> poses;
  while (table.row < table.csv.rows()) {
    ++table.row;
    if (poses.size() == most_rows) table.refuse(fmt::format("expected at most {} poses", most_rows));
    Pose pose = Pose::Identity();
    pose.linear() = rotation_in(columns, table);
    pose.translation() = numbers_in<Eigen::Vector3d>(columns.position, table);
    poses.push_back(pose);
  }
  if (poses.empty()) table.refuse("there is no pose; expected a line for each, below the names of the columns");
  return poses;
}

std::unique_ptr<PathKind> poses_path() { return std::make_unique<Poses>(); }
std::unique_ptr<PathKind> csv_path() { return std::make_unique<CsvPath>(); }

Path path_through(std::vector<Pose> poses) { return Path(std::make_unique<Poses>(std::move(poses))); }

}  // namespace ikbench::experiments
