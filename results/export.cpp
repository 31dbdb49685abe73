// CSV and JSON from records; both follow for_each_column.
#include "results/export.hpp"

#include <algorithm>
#include <type_traits>

#include "numerics/json.hpp"
#include "numerics/number.hpp"
#include "results/csv.hpp"
#include "results/files.hpp"

namespace ikbench::results {

using namespace numerics;

namespace {

using Json = nlohmann::ordered_json;

template <class Value>
constexpr bool is_list = std::is_same_v<Value, std::vector<double>>;

template <class Value>
constexpr std::string_view type_name() {
  if constexpr (std::is_enum_v<Value>) return "name";
  if constexpr (std::is_integral_v<Value>) return "integer";
  if constexpr (std::is_floating_point_v<Value>) return "number";
  if constexpr (is_list<Value>) return "list of numbers";
  return "text";
}

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

// True if nobody counted the evaluations.
bool is_empty(std::string_view column, const SolveRecord& record) {
  return column == "evaluations" && record.counted_by == CountedBy::nobody;
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

// True if no list of a solve is longer than its width; grows the widths that are too small.
bool fits(const SolveRecord& record, Widths& widths) {
  bool is_within = true;
  std::size_t column = 0;
  for_each_csv_column([&]<class Value>(std::string_view, Value SolveRecord::*member) {
    std::size_t cells = 1;
    if constexpr (is_list<Value>) cells = (record.*member).size();
    if (widths.size() == column) widths.push_back(cells);
    is_within &= cells <= widths[column];
    widths[column] = std::max(widths[column], cells);
    ++column;
  });
  return is_within;
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
      cells.push_back(is_empty(name, record) ? std::string() : cell_of(record.*member));
    }
    ++width;
  });
  append_csv_row(text, cells);
}

Json json_of(const SolveRecord& record) {
  Json object = Json::object();
  for_each_column([&]<class Value>(std::string_view name, Value SolveRecord::*member, std::string_view) {
    if constexpr (std::is_enum_v<Value>)
      object[std::string(name)] = name_of(record.*member);
    else if (is_empty(name, record))
      object[std::string(name)] = nullptr;
    else
      object[std::string(name)] = record.*member;
  });
  return object;
}

}  // namespace

std::vector<ColumnInfo> columns() {
  std::vector<ColumnInfo> list;
  for_each_column([&]<class Value>(std::string_view name, Value SolveRecord::*, std::string_view meaning) {
    list.push_back({name, type_name<Value>(), meaning});
  });
  return list;
}

std::string to_csv(const std::vector<SolveRecord>& records) {
  Widths widths;
  for (const SolveRecord& record : records) fits(record, widths);
  std::string text;
  append_header(text, widths);
  for (const SolveRecord& record : records) append_row(text, record, widths);
  return text;
}

void write_csv(const std::filesystem::path& file, const PassSolves& pass) {
  constexpr std::size_t part = 1 << 20;
  Widths widths;
  for (bool is_whole = false; !is_whole;) {
    is_whole = true;
    write_file(file, [&](const Write& write) {
      std::string text;
      if (!widths.empty()) append_header(text, widths);
      pass([&](const SolveRecord& record) {
        const bool is_first = widths.empty(), is_within = fits(record, widths);
        if (is_first) append_header(text, widths);
        is_whole &= is_first || is_within;
        append_row(text, record, widths);
        if (text.size() < part) return;
        write(text);
        text.clear();
      });
      if (widths.empty()) append_header(text, widths);
      write(text);
    });
  }
}

std::string to_json(const StudyEntry& study, const std::vector<Session>& sessions,
                    const std::vector<SolveRecord>& records) {
  Json head;
  head["note"] = "null stands for a number that is not finite";
  head["columns"] = Json::array();
  for (const ColumnInfo& column : columns())
    head["columns"].push_back({{"name", column.name}, {"type", column.type}, {"meaning", column.meaning}});
  head["study"] = study.name;
  head["definition"] = numerics::parsed_ordered_json(study.definition);
  head["series"] = Json::array();
  for (const Series& series : study.series)
    head["series"].push_back({{"key", series.key},
                              {"label", series.label},
                              {"algorithm", series.algorithm},
                              {"options", numerics::parsed_ordered_json(series.options)}});
  head["sessions"] = Json::array();
  for (const Session& session : sessions)
    head["sessions"].push_back({{"id", session.id}, {"environment", session.environment}});

  // Solves follow one by one, so that only one is an object at a time.
  std::string text = numerics::text_of(head);
  text.pop_back();
  text += ",\"solves\":[";
  for (const SolveRecord& record : records) {
    text += &record == &records.front() ? "\n" : ",\n";
    text += numerics::text_of(json_of(record));
  }
  text += "]}\n";
  return text;
}

}  // namespace ikbench::results
