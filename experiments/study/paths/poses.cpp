// Single poses: from a study file or a program, or from a CSV file beside the study.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <initializer_list>
#include <stdexcept>
#include <string>

#include "base/inputs.hpp"
#include "base/names.hpp"
#include "base/number.hpp"
#include "base/sheet.hpp"
#include "base/units.hpp"
#include "experiments/study/path.hpp"
#include "robots/arm_fields.hpp"
#include "robots/rotation.hpp"

namespace ikbench::experiments {

using namespace base;
using namespace robots;

namespace {

constexpr std::string_view expected_columns =
    "x, y and z with _m, _cm or _mm, such as x_cm; qw, qx, qy, qz, or roll, pitch and yaw with _deg or _rad; or, "
    "without a header, 12 or 16 columns for the rows of a 4 x 4 matrix";
constexpr std::size_t max_rows = 100'000;

using Group = std::vector<std::size_t>;  // columns
using Parts = std::initializer_list<std::string_view>;

// The name of a column in its parts: "pose.position.x [mm]" is x of "pose.position.", in mm.
struct ColumnName {
  std::string whole, part, unit;
  std::string other_unit;  // a unit that no pose has

  explicit ColumnName(std::string_view text) {
    const Title title(lower_case(text));
    whole = title.name;
    (is_one_of(title.unit, {"m", "cm", "mm", "deg", "rad"}) ? unit : other_unit) = title.unit;
    for (const std::string_view known : {"roll", "pitch", "yaw", "x", "y", "z", "w"}) {
      if (!part.empty() || !whole.ends_with(known)) continue;
      part = known;
      whole.resize(whole.size() - known.size());
    }
  }
};

// The columns of a file, found by the structure of their names: w, x, y and z of one thing are a quaternion.
class PoseColumns {
 public:
  // `columns` replaces the names of the header, unless it is empty.
  PoseColumns(Sheet& sheet, const std::vector<std::string>& columns) : sheet_(sheet), are_given_(!columns.empty()) {
    const std::vector<std::string>& titles = are_given_ ? columns : sheet.titles();
    if (titles.size() != sheet.titles().size())
      sheet.refuse(fmt::format("it has {} columns, but `columns` names {}", sheet.titles().size(), titles.size()));
    for (const std::string& title : titles) names_.emplace_back(title);
    quaternion_ = the_only({"w", "x", "y", "z"}, "");
    rpy_ = the_only({"roll", "pitch", "yaw"}, "deg rad");
    position_ = the_only({"x", "y", "z"}, "m cm mm");
    for (std::size_t column = 0; column < titles.size(); ++column) {
      if (titles[column] == std::to_string(matrix_.size() + 1)) matrix_.push_back(column);
    }
    const std::ptrdiff_t left_out = std::ranges::count(titles, "");
    if ((matrix_.size() != 12 && matrix_.size() != 16) || std::ssize(matrix_) + left_out != std::ssize(titles))
      matrix_.clear();
    else
      position_ = {matrix_[3], matrix_[7], matrix_[11]};
    check_names();
  }

  Pose pose_in(std::size_t row) {
    Pose pose = Pose::Identity();
    pose.linear() = rotation_in(row);
    for (std::size_t i = 0; i < 3; ++i) pose.translation()[static_cast<Eigen::Index>(i)] = length(row, position_[i]);
    return pose;
  }

 private:
  Sheet& sheet_;
  bool are_given_;  // the names, by the study
  std::vector<ColumnName> names_;
  Group position_, quaternion_, rpy_;
  Group matrix_;  // the elements of a matrix, row by row

  double number(std::size_t row, std::size_t column) {
    const double value = sheet_.number(row, column);
    // An empty cell has no number, and so no first letter.
    if (!std::isfinite(value) || std::isalpha(static_cast<unsigned char>(sheet_.cell(row, column).front())) != 0)
      sheet_.refuse(row, column, "is not a number");
    return value;
  }

  // Returns the unit [m] of a column with lengths.
  double unit_of_length(std::size_t column) const {
    const std::string& unit = names_[column].unit;
    if (unit == "mm") return 1e-3;
    return unit == "cm" ? centimetre : 1;
  }

  // Returns a length [m].
  double length(std::size_t row, std::size_t column) {
    const double value = number(row, column) * unit_of_length(column);
    const double limit = names_[column].unit.empty() ? 10 : lengths_m.second;
    if (std::abs(value) <= limit) return value;
    sheet_.refuse(row, column,
                  fmt::format("is {:g} m; expected at most {:g} m, or the unit in the name: x_mm, x_cm", value, limit));
  }

  // Returns an angle [rad].
  double angle(std::size_t row, std::size_t column) {
    const double value = number(row, column), unit = names_[column].unit == "deg" ? degree : 1;
    constexpr double limit = 1e6;  // digits of a larger angle are lost
    if (std::abs(value) > limit)
      sheet_.refuse(row, column, fmt::format("is not an angle; expected at most {:g}", limit));
    if (const std::string_view warning = doubt_of_angle(value, unit); !warning.empty())
      sheet_.refuse(row, column, warning);
    return value * unit;
  }

  Eigen::Matrix3d rotation_in(std::size_t row) {
    if (!matrix_.empty()) return rotation_of_matrix(row);
    if (!rpy_.empty()) return rotation_from_rpy({angle(row, rpy_[0]), angle(row, rpy_[1]), angle(row, rpy_[2])});
    if (quaternion_.empty()) return tool_rotation(ToolOrientation::down);
    Eigen::Vector4d q;
    for (std::size_t i = 0; i < 4; ++i) q[static_cast<Eigen::Index>(i)] = number(row, quaternion_[i]);
    constexpr double tolerance = 0.01;
    if (!(std::fabs(q.norm() - 1) <= tolerance))
      sheet_.refuse(row, quaternion_.front(),
                    fmt::format("belongs to a quaternion of length {:.6g}; expected 1", q.norm()));
    const Eigen::Vector4d unit = q / q.norm();
    return Eigen::Quaterniond(unit[0], unit[1], unit[2], unit[3]).toRotationMatrix();
  }

  // Returns the rotation of a matrix. A matrix of 12 numbers lacks the last row, which is 0 0 0 1 in every pose.
  Eigen::Matrix3d rotation_of_matrix(std::size_t row) {
    Eigen::Matrix4d T = Eigen::Matrix4d::Identity();
    for (std::size_t i = 0; i < matrix_.size(); ++i)
      T(static_cast<Eigen::Index>(i / 4), static_cast<Eigen::Index>(i % 4)) = number(row, matrix_[i]);
    const Eigen::Matrix3d R = T.topLeftCorner<3, 3>();
    if (!R.isUnitary(0.01) || R.determinant() < 0 || T.row(3) != Eigen::RowVector4d(0, 0, 0, 1))
      sheet_.refuse(row, matrix_.front(),
                    "begins a matrix that is not a pose; expected the rows of a rotation, each followed by its part of "
                    "the position, then 0 0 0 1 or nothing");
    return Eigen::Quaterniond(R).normalized().toRotationMatrix();
  }

  // Returns the columns that are these parts of one thing, in one of these units or none; empty if there are none.
  Group the_only(const Parts& parts, std::string_view units) {
    std::vector<Group> found;
    for (const ColumnName& first : names_) {
      if (first.part != *parts.begin()) continue;
      // "tx", "px" and "pose.x" belong to a position; "vx", "rx" and "qx" do not.
      if (parts.size() == 3 && first.whole.size() == 1 && !is_one_of(first.whole, {"t", "p"})) continue;
      Group group;
      for (const std::string_view part : parts) {
        const std::size_t before = group.size();
        for (std::size_t column = 0; column < names_.size(); ++column) {
          const ColumnName& name = names_[column];
          if (name.part == part && name.whole == first.whole && units.find(name.unit) != std::string_view::npos)
            group.push_back(column);
        }
        if (group.size() > before + 1)
          sheet_.refuse(fmt::format("there are two columns for {}{}; expected one", first.whole, part));
      }
      if (group.size() == parts.size() && std::ranges::count(quaternion_, group.front()) == 0) found.push_back(group);
    }
    if (found.size() > 1)
      sheet_.refuse(fmt::format("{} and {} may both be meant; remove one from the file",
                                in_quotes(sheet_.titles()[found[0].front()]),
                                in_quotes(sheet_.titles()[found[1].front()])));
    return found.empty() ? Group() : found.front();
  }

  // Returns true for columns of a stamp: "%time", "t" and all of "field.header.".
  static bool is_stamp(std::string_view name) {
    const auto has = [&](std::string_view word) { return name.find(word) != std::string_view::npos; };
    return has("stamp") || has("time") || has("header.") || is_one_of(name, {"t", "sec", "secs", "nsec", "nsecs"});
  }

  // Refuses columns that are no part of a pose, except stamps and those that `columns` renames; these are left out.
  void check_names() {
    for (std::size_t column = 0; column < names_.size() && matrix_.empty(); ++column) {
      const bool is_used = std::ranges::any_of(std::array{&position_, &quaternion_, &rpy_}, [&](const Group* group) {
        return std::ranges::count(*group, column) > 0;
      });
      const bool may_be_out = are_given_ || is_stamp(names_[column].whole);
      if (is_used && !names_[column].other_unit.empty() && std::ranges::count(quaternion_, column) == 0)
        sheet_.refuse(fmt::format("{} has no unit of a length or an angle; expected m, cm, mm, deg or rad",
                                  in_quotes(sheet_.titles()[column])));
      if (!is_used && !(may_be_out && names_[column].part.empty()))
        sheet_.refuse(fmt::format(
            "{}{} is not part of a position or rotation; to ignore it, name it \"\" in path.columns; otherwise expected {}",
            number_from(sheet_.titles()[0]) ? "there is no header, and column " : "",
            in_quotes(sheet_.titles()[column]), expected_columns));
    }
    if (position_.empty()) sheet_.refuse(fmt::format("there is no position; expected {}", expected_columns));
    if (!quaternion_.empty() && !rpy_.empty())
      sheet_.refuse("there are two kinds of rotation; expected a quaternion, or roll, pitch and yaw");
    for (const std::size_t column : rpy_) {
      if (names_[column].unit.empty())
        sheet_.refuse(fmt::format("{0} has no unit; name it {1}_deg or {1}_rad", in_quotes(sheet_.titles()[column]),
                                  names_[column].part));
    }
  }
};

class Poses : public TargetSet {
 public:
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
  std::string_view name() const override { return "csv"; }
  std::string_view summary() const override { return "poses from a CSV file: x_cm, y_cm, z_cm, qw, qx, qy, qz"; }

  // The key of a series has the poses, so the file's name does not enter the key.
  void list_fields(Fields& io) override {
    io.text(
        "file", file_,
        {"beside the study, or a full path. Columns: x, y, z in _m, _cm or _mm; then qw, qx, qy, qz, or roll, pitch, yaw in _deg or "
         "_rad; without these the tool points straight down. Or, without a header, the 12 or 16 numbers of a matrix",
         InKey::no});
    io.texts(
        "columns", columns_,
        {"names in place of the header's, \"\" for a column that is not part of a pose: [\"\", \"x\", \"y\", \"z\"]",
         InKey::no});
  }

  // Throws std::invalid_argument if lengths in cm or mm seem to be taken for metres.
  void check(const Robot& arm) const override {
    const Chain::Ball reach = arm.chain.reach();
    std::vector<double> distances;  // in multiples of the reach
    for (const Pose& pose : poses_) distances.push_back((pose.translation() - reach.centre).norm() / reach.radius);
    const auto middle = distances.begin() + std::ssize(distances) / 2;
    std::ranges::nth_element(distances, middle);
    if (*middle > 10)
      throw std::invalid_argument(fmt::format(
          "{}: half of the points are {:.0f} times as far as the arm reaches, or more; x_m, x_cm and x_mm name units",
          file_, *middle));
  }

  void load(const std::filesystem::path& folder) override {
    const std::filesystem::path file = folder / file_;
    constexpr std::uintmax_t max_bytes = 16'000'000;
    const std::string text = text_of_file(file, max_bytes);
    const std::filesystem::path home = std::filesystem::canonical(folder.empty() ? "." : folder),
                                meant = std::filesystem::canonical(file);
    if (std::filesystem::path(file_).is_relative() &&
        std::mismatch(home.begin(), home.end(), meant.begin(), meant.end()).first != home.end()) {
      throw std::invalid_argument(fmt::format(
          "path.file is \"{}\", which is outside the study's folder; write its full path, {}", file_, meant.string()));
    }
    poses_ = poses_from_csv(text, file.string(), columns_);
  }

 private:
  std::string file_;
  std::vector<std::string> columns_;
};

}  // namespace

std::vector<Pose> poses_from_csv(std::string_view text, std::string_view file, const std::vector<std::string>& names) {
  Sheet sheet(text, file, 0, Sheet::Header::optional);
  sheet.advise_on_numbers("each pose needs all its numbers");
  if (sheet.rows().size() > max_rows) sheet.refuse(fmt::format("expected at most {} poses", max_rows));
  PoseColumns columns(sheet, names);
  std::vector<Pose> poses;
  for (const std::size_t row : sheet.rows()) poses.push_back(columns.pose_in(row));
  return poses;
}

std::unique_ptr<TargetSet> poses_path() { return std::make_unique<Poses>(); }
std::unique_ptr<TargetSet> csv_path() { return std::make_unique<CsvPath>(); }

}  // namespace ikbench::experiments
