#include "results/store_codec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <system_error>
#include <type_traits>

#include "base/names.hpp"
#include "base/number.hpp"

namespace ikbench::results {

using namespace base;

namespace {

// Returns a list of numbers as a JSON array. JSON has neither NaN nor infinity, so NaN becomes null, and infinity
// becomes 1e999, which every reader rounds to infinity.
constexpr std::string_view json_nan = "null";
constexpr std::string_view json_infinity = "1e999";
constexpr std::string_view json_minus_infinity = "-1e999";

void write_numbers(std::string& text, const std::vector<double>& numbers) {
  text = "[";
  for (const double number : numbers) {
    if (text.size() > 1) text += ',';
    if (std::isfinite(number)) {
      append(text, number);
    } else if (std::isnan(number)) {
      text += json_nan;
    } else {
      text += number > 0 ? json_infinity : json_minus_infinity;
    }
  }
  text += ']';
}

double json_number(std::string_view text) {
  if (text == json_nan) return std::numeric_limits<double>::quiet_NaN();
  if (text == json_infinity) return std::numeric_limits<double>::infinity();
  if (text == json_minus_infinity) return -std::numeric_limits<double>::infinity();
  if (const auto number = base::number_from(text)) return *number;
  throw CorruptValue(fmt::format("{} in a list of numbers", in_quotes(text)));
}

void read_numbers(std::string_view array, std::vector<double>& numbers) {
  if (array.size() < 2 || array.front() != '[' || array.back() != ']')
    throw CorruptValue(fmt::format("{} is not a list of numbers", in_quotes(array)));
  numbers.clear();
  const char *at = array.data() + 1, *const end = array.data() + array.size() - 1;
  for (const char* next = at; at < end; at = next + 1) {
    double& number = numbers.emplace_back();
    const auto [stop, error] = base::read_number(at, end, number);
    next = stop;
    if (error == std::errc{} && (next == end || *next == ',')) continue;
    next = std::find(at, end, ',');
    number = json_number({at, next});
  }
  if (array.ends_with(",]")) throw CorruptValue("an empty place in a list of numbers");
}

// Returns the SQL type of a member of the record. SQLite has no NaN, so NULL stands for NaN.
template <class Value>
constexpr std::string_view sql_type() {
  if constexpr (std::is_integral_v<Value>) return "INTEGER NOT NULL";
  if constexpr (std::is_floating_point_v<Value>) return "REAL";
  return "TEXT NOT NULL";
}

// Binds a text without a copy: names are literals, and the record outlives the insertion.
template <class Value>
void bind(SQLite::Statement& insert, int index, const Value& value, std::string& list) {
  if constexpr (std::is_arithmetic_v<Value>) {
    insert.bind(index, value);
  } else if constexpr (std::is_enum_v<Value>) {
    insert.bindNoCopy(index, name_of(value).data());
  } else if constexpr (std::is_same_v<Value, std::vector<double>>) {
    write_numbers(list, value);
    insert.bindNoCopy(index, list);
  } else {
    insert.bindNoCopy(index, value);
  }
}

// Returns the text of a column, which is valid as long as its row.
std::string_view text_in(const SQLite::Column& column) {
  const char* const text = column.getText();  // has to be called before getBytes
  return {text, static_cast<std::size_t>(column.getBytes())};
}

template <class Value>
void read(const SQLite::Column& column, Value& value) {
  if constexpr (std::is_floating_point_v<Value>) {
    value = column.isNull() ? std::numeric_limits<double>::quiet_NaN() : column.getDouble();
  } else if constexpr (std::is_integral_v<Value>) {
    const std::int64_t number = column.getInt64();
    if (!std::in_range<Value>(number)) throw CorruptValue(fmt::to_string(number));
    value = static_cast<Value>(number);
  } else if constexpr (std::is_enum_v<Value>) {
    const auto& names = names_of(value);
    const auto found = std::find(names.begin(), names.end(), text_in(column));
    if (found == names.end()) throw CorruptValue(in_quotes(text_in(column)));
    value = static_cast<Value>(found - names.begin());
  } else if constexpr (std::is_same_v<Value, std::vector<double>>) {
    read_numbers(text_in(column), value);
  } else {
    value = text_in(column);
  }
}

// Returns all columns, each through `format`, separated by commas.
template <class Format>
std::string listed(Format&& format) {
  std::string text;
  for_each_column([&]<class Value>(std::string_view name, Value SolveRecord::*, std::string_view) {
    text += text.empty() ? "" : ", ";
    text += format(name, sql_type<Value>());
  });
  return text;
}

}  // namespace

std::string text_of_list(const std::vector<double>& numbers) {
  std::string text;
  write_numbers(text, numbers);
  return text;
}

std::vector<double> list_in_text(std::string_view text) {
  std::vector<double> numbers;
  read_numbers(text, numbers);
  return numbers;
}

std::string solve_columns() {
  return listed([](std::string_view name, std::string_view) { return name; });
}

std::string solve_declarations() {
  return listed([](std::string_view name, std::string_view type) { return fmt::format("{} {}", name, type); });
}

SolveInsert::SolveInsert(SQLite::Database& store)
    : insert_(store, fmt::format("INSERT INTO solves ({}) VALUES ({})", solve_columns(),
                                 listed([](std::string_view, std::string_view) { return "?"; }))),
      lists_(static_cast<std::size_t>(insert_.getBindParameterCount())) {}

void SolveInsert::operator()(const SolveRecord& record) {
  insert_.tryReset();  // the statement may have failed before
  int index = 0;
  for_each_column([&](std::string_view, auto member, std::string_view) {
    std::string& list = lists_[static_cast<std::size_t>(index)];
    bind(insert_, ++index, record.*member, list);
  });
  insert_.exec();
}

void read_solve(SQLite::Statement& row, SolveRecord& record) {
  int index = 0;
  for_each_column([&](std::string_view name, auto member, std::string_view) {
    try {
      read(row.getColumn(index++), record.*member);
    } catch (const CorruptValue& error) {
      throw CorruptValue(fmt::format("{}: {}", name, error.what()));
    }
  });
  if (const std::string wrong = wrong_number(record); !wrong.empty())
    throw CorruptValue(fmt::format("{}, which no solve has", wrong));
}

}  // namespace ikbench::results
