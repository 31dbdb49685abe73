#include "results/export.hpp"

#include <fmt/format.h>

#include <array>
#include <stdexcept>
#include <type_traits>

#include "base/csv.hpp"
#include "base/number.hpp"

namespace ikbench::results {

using namespace base;

namespace {

template <class Value>
constexpr std::string_view type_name() {
  if constexpr (std::is_enum_v<Value>) return "name";
  if constexpr (std::is_integral_v<Value>) return "integer";
  if constexpr (std::is_floating_point_v<Value>) return "number";
  if constexpr (std::is_same_v<Value, std::vector<double>>) return "list of numbers";
  return "text";
}

template <class Value>
constexpr bool is_list = std::is_same_v<Value, std::vector<double>>;

template <class Value>
void append(std::string& text, const Value& value) {
  if constexpr (std::is_same_v<Value, std::string>) {
    base::append_csv_cell(text, value);
  } else if constexpr (std::is_enum_v<Value>) {
    text += name_of(value);
  } else if constexpr (std::is_integral_v<Value>) {
    text += std::to_string(value);
  } else {
    base::append(text, value);
  }
}

constexpr std::array<std::string_view, 4> lists_of_any_length{"trace_cm", "improved_at", "improved_to_cm",
                                                              "all_answers_rad"};

// Calls visit(name, member) for each column of CSV: all but the lists that only the store has.
template <class Visit>
void for_each_csv_column(Visit&& visit) {
  for_each_column([&](std::string_view name, auto member, std::string_view) {
    if (std::ranges::count(lists_of_any_length, name) == 0) visit(name, member);
  });
}

// The number of cells of each column. A list has a cell for each element in the first solve.
using Widths = std::vector<std::size_t>;

Widths widths_of(const SolveRecord& record) {
  Widths widths;
  for_each_csv_column([&]<class Value>(std::string_view, Value SolveRecord::*member) {
    widths.push_back(1);
    if constexpr (is_list<Value>) widths.back() = (record.*member).size();
  });
  return widths;
}

void append_header(std::string& text, const Widths& widths, const std::vector<std::string>& extras) {
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
  for (const std::string& name : extras) cells.push_back("extra_" + name);
  base::append_csv_row(text, cells);
}

void append_row(std::string& text, const SolveRecord& record, const Widths& widths,
                const std::vector<std::string>& extras) {
  auto width = widths.begin();
  for_each_csv_column([&]<class Value>(std::string_view name, Value SolveRecord::*member) {
    const Value& value = record.*member;
    if constexpr (is_list<Value>) {
      if (value.size() > *width)
        throw std::invalid_argument(
            fmt::format("run {}, point {} of {} has {} numbers as {}, the first solve {}; read the store", record.run,
                        record.point, record.label, value.size(), name, *width));
      for (const double element : value) {
        append(text, element);
        text += ',';
      }
      text.append(*width - value.size(), ',');
    } else {
      if (name != "evaluations" || record.counted_by != CountedBy::none) append(text, value);
      text += ',';
    }
    ++width;
  });
  for (const std::string& name : extras) {
    if (const auto extra = record.extras.find(name); extra != record.extras.end()) append(text, extra->second);
    text += ',';
  }
  text.back() = '\n';
}

}  // namespace

std::vector<ColumnInfo> columns() {
  std::vector<ColumnInfo> list;
  for_each_column([&]<class Value>(std::string_view name, Value SolveRecord::*, std::string_view meaning) {
    list.push_back({name, type_name<Value>(), meaning});
  });
  return list;
}

void write_csv(const SolveSource& pass, const base::Write& write, const std::vector<std::string>& extras) {
  constexpr std::size_t part = 1 << 20;  // bytes that are written at a time
  Widths widths;
  std::string text;
  pass([&](const SolveRecord& record) {
    if (widths.empty()) {
      widths = widths_of(record);
      append_header(text, widths, extras);
    }
    append_row(text, record, widths, extras);
    if (text.size() < part) return;
    write(text);
    text.clear();
  });
  if (widths.empty()) append_header(text, widths, extras);
  write(text);
}

}  // namespace ikbench::results
