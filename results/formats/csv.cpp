// Tidy CSV: one row per solve. A list becomes one column per element, numbered from 1 (answer_rad_1 ...), as many as
// the longest has; shorter lists leave cells empty. The trace and the improvements have up to one element per
// iteration, so only JSON has them. Values that are not finite are NaN, Inf or -Inf.
#include "results/csv.hpp"

#include <algorithm>
#include <type_traits>

#include "numerics/number.hpp"
#include "results/export.hpp"
#include "results/files.hpp"

namespace ikbench::results {

using namespace numerics;

namespace {

template <class Value>
constexpr bool is_list = std::is_same_v<Value, std::vector<double>>;

template <class Value>
std::string cell_of(const Value& value) {
  if constexpr (std::is_enum_v<Value>)
    return std::string(name_of(value));
  else if constexpr (std::is_integral_v<Value>)
    return std::to_string(value);
  else if constexpr (std::is_floating_point_v<Value>)
    return text_of(value);
  else
    return value;
}

// Visits the columns of CSV.
template <class Visit>
void for_each_csv_column(Visit&& visit) {
  for_each_column([&](std::string_view name, auto member, std::string_view) {
    if (name != "trace_cm" && name != "improved_at" && name != "improved_to_cm") visit(name, member);
  });
}

// Cells per column.
using Widths = std::vector<std::size_t>;

// Makes the widths as large as the lists of a solve.
void widen(Widths& widths, const SolveRecord& record) {
  std::size_t column = 0;
  for_each_csv_column([&]<class Value>(std::string_view, Value SolveRecord::*member) {
    std::size_t cells = 1;
    if constexpr (is_list<Value>) cells = (record.*member).size();
    if (widths.size() == column) widths.push_back(cells);
    widths[column] = std::max(widths[column], cells);
    ++column;
  });
}

void append_header(std::string& text, const Widths& widths) {
  std::vector<std::string> cells;
  auto width = widths.begin();
  for_each_csv_column([&]<class Value>(std::string_view name, Value SolveRecord::*) {
    const std::size_t count = width == widths.end() ? 0 : *width++;
    if constexpr (is_list<Value>) {
      for (std::size_t i = 1; i <= count; ++i) cells.push_back(std::string(name) + "_" + std::to_string(i));
    } else {
      cells.emplace_back(name);
    }
  });
  append_csv_row(text, cells);
}

void append_row(std::string& text, const SolveRecord& record, const Widths& widths) {
  std::vector<std::string> cells;
  auto width = widths.begin();
  for_each_csv_column([&]<class Value>(std::string_view name, Value SolveRecord::*member) {
    if constexpr (is_list<Value>) {
      for (const double element : record.*member) cells.push_back(text_of(element));
      cells.resize(cells.size() + *width - (record.*member).size());
    } else {
      cells.push_back(is_uncounted(name, record) ? std::string() : cell_of(record.*member));
    }
    ++width;
  });
  append_csv_row(text, cells);
}

void write_rows(const PassSolves& pass, const Write& write) {
  constexpr std::size_t part = 1 << 20;  // written at a time
  Widths widths;
  pass([&](const SolveRecord& record) { widen(widths, record); });
  std::string text;
  append_header(text, widths);
  pass([&](const SolveRecord& record) {
    append_row(text, record, widths);
    if (text.size() < part) return;
    write(text);
    text.clear();
  });
  write(text);
}

}  // namespace

void csv_text(const Exported& exported, const Write& write) { write_rows(exported.each_solve, write); }

void write_csv(const std::filesystem::path& file, const PassSolves& pass) {
  write_file(file, [&](const Write& write) { write_rows(pass, write); });
}

}  // namespace ikbench::results
