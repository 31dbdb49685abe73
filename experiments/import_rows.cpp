#include "experiments/import_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "numerics/names.hpp"
#include "numerics/number.hpp"
#include "numerics/toml_table.hpp"
#include "results/csv.hpp"
#include "results/export.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace results;

namespace {

using ColumnNames = std::vector<std::string>;

ColumnNames numbered(std::string_view name, Eigen::Index count) {
  ColumnNames names;
  for (Eigen::Index i = 1; i <= count; ++i) names.push_back(fmt::format("{}_{}", name, i));
  return names;
}

// True for a column of `ikbench export`: its name, or the name of a list with a number.
bool is_exported(std::string_view name) {
  const std::size_t end = name.find_last_not_of("0123456789");
  const bool is_numbered = end != std::string_view::npos && end + 1 < name.size() && name[end] == '_';
  const std::string_view stem = is_numbered ? name.substr(0, end) : name;
  const std::vector<ColumnInfo> all = columns();
  return std::ranges::any_of(
      all, [&](const ColumnInfo& each) { return each.name == name || (is_numbered && each.name == stem); });
}

class RowReader {
 public:
  RowReader(const std::string& text, const std::string& source, const robots::Configuration& joint_units)
      : table_(parse_csv(text, source)), source_(source), joint_units_(joint_units) {
    const Eigen::Index joints = joint_units.size();
    const bool in_degrees = has("answer_deg_1");
    answer_ = numbered(in_degrees ? "answer_deg" : "answer_rad", joints);
    target_ = numbered("target_position_m", 3);
    if (!in_degrees) joint_units_.setOnes();
    known_ = {"run", "point", "solver", "position_error_cm", "orientation_error_deg", "evaluations", "seconds"};
    known_.insert(known_.end(), answer_.begin(), answer_.end());
    known_.insert(known_.end(), target_.begin(), target_.end());
    check_columns(in_degrees);
  }

  ColumnNames unread() const {
    ColumnNames names;
    std::ranges::copy_if(table_.header, std::back_inserter(names), [&](const auto& name) { return !is_known(name); });
    return names;
  }

  std::vector<ImportedRow> rows(const std::string& label) {
    std::vector<ImportedRow> rows;
    for (row_ = 0; row_ < table_.rows.size(); ++row_) rows.push_back(row(label));
    if (rows.empty()) throw std::invalid_argument(source_ + ": no row below the header; expected a row for each solve");
    return rows;
  }

 private:
  bool has(std::string_view name) const { return std::ranges::find(table_.header, name) != table_.header.end(); }
  bool is_known(const std::string& name) const { return std::ranges::find(known_, name) != known_.end(); }

  [[noreturn]] void refuse_header(const std::string& what) const {
    throw std::invalid_argument(fmt::format("{}:1: {}", source_, what));
  }

  void check_columns(bool in_degrees) const {
    for (const std::string& name : table_.header) {
      if (!is_known(name) && !is_exported(name)) refuse_header(unknown_name("column", name, known_));
      if (std::ranges::count(table_.header, name) > 1)
        refuse_header(fmt::format("two columns '{}'; expected one", name));
    }
    if (in_degrees && has("answer_rad_1"))
      refuse_header("columns answer_deg_1 and answer_rad_1; expected the answers in degrees or in radians");
    for (const char* name : {"run", "point"}) {
      if (!has(name))
        refuse_header(fmt::format("no column '{}'; expected run and point, as ikbench export has them", name));
    }
    const bool has_answers = has(answer_.front());
    for (const ColumnNames* list : {&answer_, &target_}) {
      for (const std::string& name : *list) {
        if (has(list->front()) && !has(name))
          refuse_header(fmt::format("no column '{}'; expected {} to {}", name, list->front(), list->back()));
      }
    }
    const std::string further = fmt::format("{}_{}", in_degrees ? "answer_deg" : "answer_rad", answer_.size() + 1);
    if (has(further)) refuse_header(fmt::format("column '{}', but the arm has {} joints", further, answer_.size()));
    if (!has_answers && !has("position_error_cm")) {
      refuse_header(fmt::format("neither answers nor errors; expected columns {} to {}, or position_error_cm",
                                answer_.front(), answer_.back()));
    }
  }

  std::string where() const { return fmt::format("{}:{}", source_, table_.lines[row_]); }

  // The text of a cell; empty if there is no such column.
  std::string cell(std::string_view name) const {
    return has(name) ? table_.rows[row_][table_.column(name)] : std::string();
  }

  [[noreturn]] void refuse(std::string_view name, const std::string& expected) const {
    throw std::invalid_argument(
        fmt::format("{}: {} is '{}'; expected {}", where(), name, front(cell(name), 40), expected));
  }

  // A finite number; nothing if the cell is empty or NaN.
  std::optional<double> number(std::string_view name) const {
    const std::string text = cell(name);
    if (text.empty()) return std::nullopt;
    const std::optional<double> value = number_from(text);
    if (!value) refuse(name, "a number, or nothing");
    if (std::isnan(*value)) return std::nullopt;
    if (std::isinf(*value)) refuse(name, "a finite number, or nothing");
    return value;
  }

  std::optional<double> not_negative(std::string_view name, double most, const std::string& expected) const {
    const std::optional<double> value = number(name);
    if (value && (*value < 0 || *value > most)) refuse(name, expected);
    return value;
  }

  int whole(std::string_view name) const {
    const std::optional<double> value = number(name);
    if (!value || *value < 1 || *value > 1e6 || *value != std::floor(*value)) refuse(name, "a whole number from 1");
    return static_cast<int>(*value);
  }

  // Either all values or none.
  std::vector<double> list(const ColumnNames& names) const {
    std::vector<double> values;
    for (const std::string& name : names) {
      if (const std::optional<double> value = number(name)) values.push_back(*value);
    }
    const auto is_missing = [&](const std::string& name) { return !number(name); };
    if (!values.empty() && values.size() < names.size()) {
      refuse(*std::ranges::find_if(names, is_missing),
             fmt::format("a number, as in the others of {} to {}", names.front(), names.back()));
    }
    return values;
  }

  ImportedRow row(const std::string& label) const {
    constexpr double most = std::numeric_limits<double>::max();
    ImportedRow row{.where = where(), .label = has("solver") ? cell("solver") : label};
    if (row.label.empty() || !TomlReader::is_plain(row.label)) refuse("solver", "the name of a solver");
    row.run = whole("run");
    row.point = whole("point");
    row.answer = list(answer_);
    for (std::size_t j = 0; j < row.answer.size(); ++j) row.answer[j] *= joint_units_[static_cast<Eigen::Index>(j)];
    row.target_position_m = list(target_);
    row.position_error_cm = not_negative("position_error_cm", most, "a number from 0");
    row.orientation_error_deg = not_negative("orientation_error_deg", 180, "a number from 0 to 180");
    row.seconds = not_negative("seconds", most, "a number from 0");
    if (const auto value = not_negative("evaluations", 9e15, "a whole number from 0")) {
      if (*value != std::floor(*value)) refuse("evaluations", "a whole number from 0");
      row.evaluations = static_cast<std::int64_t>(*value);
    }
    return row;
  }

  CsvTable table_;
  std::string source_;
  robots::Configuration joint_units_;
  ColumnNames answer_, target_, known_;
  std::size_t row_ = 0;
};

}  // namespace

ImportedRows read_imported_rows(const std::string& text, const std::string& source, const std::string& label,
                                const robots::Configuration& joint_units) {
  RowReader reader(text, source, joint_units);
  return {.rows = reader.rows(label), .unread = reader.unread()};
}

}  // namespace ikbench::experiments
