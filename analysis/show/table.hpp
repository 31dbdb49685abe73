// Tables: cells and columns that know what they are, and the writers of tables.
#pragma once

#include <cstdint>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "analysis/judge/data/samples.hpp"
#include "analysis/judge/statistics/two_sample_tests.hpp"

namespace ikbench::show {

// Our number beside a printed one; a column of such cells is two for readers.
struct PublishedNumber {
  double ours;
  std::string printed;
  std::string sign = {};  // "~", "x" or "?": whether ours can be it
};
// A number with a mark, "*", or its interval or standard deviation, or that is an upper bound; or what stands in its
// place: a ratio to the reference of the column, or a difference from it, which files of numbers have in a column of
// their own.
struct ValueCell {
  double value;
  std::string mark = {};
  bool is_bound = false;
  std::optional<judge::Interval> interval = {};
  std::optional<double> sd = {};
  std::optional<judge::EffectScale> relative_to_reference = {};
  int digits = 3;
};
// Why a number is not known: "too few to compare".
struct MissingCell {
  std::string reason;
};
// How a page colours a verdict.
enum class Tone { neutral, good, bad };
struct VerdictCell {
  std::string text;
  Tone tone = Tone::neutral;
  std::string key = {};  // in place of the words, in files of numbers
};
// Readers see three digits, and "-" for an empty cell (std::monostate), an absent number and one that is not finite.
using Cell = std::variant<std::monostate, std::string, std::int64_t, double, judge::Interval, PublishedNumber,
                          ValueCell, MissingCell, VerdictCell>;

inline Cell text_cell(std::string text) { return text.empty() ? Cell() : Cell(std::move(text)); }

// The role of a column, by which writers format its cells.
enum class ColumnRole {
  value,
  p,            // p-values: "0.0005", "< 0.0001"
  interval,     // of the number before it: files of numbers have "low", "high" and "excluded"
  machine_only  // which only files of numbers have
};

struct Column {
  std::string name;
  std::string unit = {};
  ColumnRole role = ColumnRole::value;
  std::string cell_unit = {};           // beside each number that is no ratio, in place of the head
  std::vector<double> boundaries = {};  // onto which no number is rounded (number_within of text.hpp)
};

// Columns with nothing but names.
std::vector<Column> named_columns(const std::vector<std::string>& names);

struct Table {
  std::string name;  // of its files and anchor, with a number perhaps; empty: it has none
  std::string caption;
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows = {};
  std::vector<std::string> notes = {};
  bool is_of_study = true;  // and of no other, so that an article's caption names it
  std::size_t visible_rows =
      std::numeric_limits<std::size_t>::max();  // rows; a page folds the others, articles lack them
};

// "0.1 to 0.8", "above 0 to 0.8"
std::string interval_text(const judge::Interval& interval, const std::vector<double>& ends);

// All escape what they are given. An interval and a printed number take two columns of CSV, and two members of JSON;
// intervals of which one excludes an end take a third, which says "low" or "high".
std::string to_csv(const Table& table);
std::string to_markdown(const Table& table);
std::string to_latex(const Table& table);  // booktabs
std::string to_html(const Table& table);
std::string to_text(const Table& table);  // of a screen: units stand at the numbers
// An object for each row; names of columns in lower case with _ for blanks.
nlohmann::ordered_json to_json(const Table& table);

}  // namespace ikbench::show
