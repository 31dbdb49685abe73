// Tidy CSV: one row per solve. A list becomes one column per element, numbered from 1 (answer_rad_1 ...), as many as
// the first solve has; shorter lists leave cells empty. The trace and the improvements have up to one element per
// iteration, so only JSON has them. Values that are not finite are NaN, Inf or -Inf.
#include "results/csv.hpp"

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>
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
void append(std::string& text, const Value& value) {
  if constexpr (std::is_same_v<Value, std::string>) {
    append_csv_cell(text, value);
  } else if constexpr (std::is_enum_v<Value>) {
    text += name_of(value);
  } else if constexpr (std::is_integral_v<Value>) {
    text += std::to_string(value);
  } else if (std::isfinite(value)) {
    numerics::append(text, value);
  } else {
    text += text_of(value);
  }
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

Widths widths_of(const SolveRecord& record) {
  Widths widths;
  for_each_csv_column([&]<class Value>(std::string_view, Value SolveRecord::*member) {
    widths.push_back(1);
    if constexpr (is_list<Value>) widths.back() = (record.*member).size();
  });
  return widths;
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
  auto width = widths.begin();
  for_each_csv_column([&]<class Value>(std::string_view name, Value SolveRecord::*member) {
    const Value& value = record.*member;
    if constexpr (is_list<Value>) {
      if (value.size() > *width)
        throw std::invalid_argument(
            fmt::format("run {}, point {} of {} has {} numbers as {}, the first solve {}; export "
                        "it as JSON",
                        record.run, record.point, record.solver, value.size(), name, *width));
      for (const double element : value) {
        append(text, element);
        text += ',';
      }
      text.append(*width - value.size(), ',');
    } else {
      if (!is_uncounted(name, record)) append(text, value);
      text += ',';
    }
    ++width;
  });
  text.back() = '\n';
}

void write_rows(const PassSolves& pass, const Write& write) {
  constexpr std::size_t part = 1 << 20;  // written at a time
  Widths widths;
  std::string text;
  pass([&](const SolveRecord& record) {
    if (widths.empty()) {
      widths = widths_of(record);
      append_header(text, widths);
    }
    append_row(text, record, widths);
    if (text.size() < part) return;
    write(text);
    text.clear();
  });
  if (widths.empty()) append_header(text, widths);
  write(text);
}

}  // namespace

void csv_text(const Exported& exported, const Write& write) { write_rows(exported.each_solve, write); }

void write_csv(const std::filesystem::path& file, const PassSolves& pass) {
  write_file(file, [&](const Write& write) { write_rows(pass, write); });
}

}  // namespace ikbench::results
