#include "analysis/report/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "analysis/inference/metrics.hpp"
#include "analysis/inference/text.hpp"
#include "numerics/number.hpp"
#include "results/csv.hpp"

namespace ikbench::report {

using namespace numerics;
using namespace results;
using namespace inference;

namespace {

constexpr int digits_to_read = 5;
constexpr double smallest_p = 1e-300;  // below, the tails of distributions underflow

template <class... Visitors>
struct Overloaded : Visitors... {
  using Visitors::operator()...;
};
template <class... Visitors>
Overloaded(Visitors...) -> Overloaded<Visitors...>;  // clang++ 14 wants the guide spelled out

// "mean_reached_ms" as "mean reached [ms]"; a metric's column has its name, but for a word, such as "solved".
NameWithUnit named(std::string_view id) {
  for (const Metric metric : all_metrics()) {
    const bool is_word = info_of(metric).unit.empty() && id.find('_') == std::string_view::npos;
    if (name_of(metric) == id && !is_word) return with_unit(metric);
  }
  NameWithUnit words = split_unit(id);
  constexpr std::string_view percent = "_percent";
  if (words.name.ends_with(percent)) words = {words.name.substr(0, words.name.size() - percent.size()), "%"};
  words.name = in_words(words.name);
  return words;
}

bool is_of_times(std::string_view id) {
  return std::ranges::any_of(
      all_metrics(), [id](Metric metric) { return name_of(metric) == id && info_of(metric).kind == Kind::time; });
}

bool has_times(const std::vector<Cell>& row) {
  return std::ranges::any_of(row, [](const Cell& cell) {
    const auto* id = std::get_if<Id>(&cell);
    return id != nullptr && is_of_times(id->id);
  });
}

// The numbers of a cell that may be times; null for one with printed digits, which stay as they are.
std::vector<double*> numbers_in(Cell& cell) {
  if (auto* value = std::get_if<double>(&cell)) return {value};
  if (auto* range = std::get_if<Range>(&cell)) return {&range->low, &range->high};
  if (std::holds_alternative<OursAndPrinted>(cell)) return {nullptr};
  return {};
}

// Turns seconds into milliseconds if all of them are short. Returns the unit.
std::string_view with_short_times(const std::vector<double*>& seconds) {
  constexpr double ms_per_second = 1000, longest_in_ms = 0.1;
  if (std::ranges::count(seconds, nullptr) > 0) return "s";
  double longest = 0;
  for (const double* each : seconds) longest = std::isfinite(*each) ? std::max(longest, std::abs(*each)) : longest;
  if (!(longest > 0 && longest < longest_in_ms)) return "s";
  for (double* each : seconds) *each *= ms_per_second;
  return "ms";
}

template <class Kind>
bool has_any(const Table& table, std::size_t column) {
  return std::ranges::any_of(
      table.rows, [column](const std::vector<Cell>& row) { return std::holds_alternative<Kind>(row[column]); });
}

}  // namespace

std::string numbered_caption(const Table& table) {
  return table.number == 0 ? table.caption : fmt::format("Table {}: {}", table.number, table.caption);
}

Cell or_nothing(double value) { return std::isfinite(value) ? Cell(value) : Cell(); }
Cell or_nothing(PValue p) { return std::isfinite(p.value) ? Cell(p) : Cell(); }

bool is_empty(const Cell& cell) {
  const auto* range = std::get_if<Range>(&cell);
  return std::holds_alternative<std::monostate>(cell) || (range && std::isnan(range->low));
}

std::string readable(const Cell& cell) {
  if (is_empty(cell)) return "";
  return std::visit(
      Overloaded{
          [](std::monostate) { return std::string(); }, [](const std::string& text) { return text; },
          [](std::int64_t count) { return fmt::to_string(count); },
          [](double value) { return std::isfinite(value) ? rounded_number(value, digits_to_read) : "not defined"; },
          [](PValue p) {
            if (!std::isfinite(p.value)) return std::string("not defined");
            if (p.value < smallest_p) return std::string("< 1e-300");
            return rounded_number(p.value, digits_to_read);
          },
          [](Range range) { return fmt::format("{} to {}", readable_end(range.low), readable_end(range.high)); },
          [](const OursAndPrinted& beside) {
            return fmt::format("{} (printed {})", short_number(beside.ours), beside.printed);
          },
          [](const Id& id) { return text_of(named(id.id)); }},
      cell);
}

Range range_of(const statistics::Estimate& of) {
  return std::isfinite(of.low) && std::isfinite(of.high) ? Range{of.low, of.high} : Range{};
}

std::string readable_end(double of_range) { return rounded_number(of_range, 3); }

bool is_number(const Cell& cell) {
  if (const auto* value = std::get_if<double>(&cell)) return std::isfinite(*value);
  if (const auto* p = std::get_if<PValue>(&cell)) return std::isfinite(p->value);
  return std::holds_alternative<std::int64_t>(cell);
}

bool is_left(const Table& table, std::size_t column) {
  return std::ranges::any_of(table.rows, [column](const std::vector<Cell>& row) {
    const auto* text = std::get_if<std::string>(&row[column]);
    return text ? !number_from(*text) : std::holds_alternative<Id>(row[column]);
  });
}

std::string computable(const Cell& cell) {
  const auto number = [](double value) { return std::isfinite(value) ? text_of(value) : std::string(); };
  if (const auto* value = std::get_if<double>(&cell)) return number(*value);
  if (const auto* p = std::get_if<PValue>(&cell)) return number(p->value);
  if (const auto* range = std::get_if<Range>(&cell); range && !is_empty(cell))
    return text_of(range->low) + " to " + text_of(range->high);
  if (const auto* beside = std::get_if<OursAndPrinted>(&cell)) return number(beside->ours);
  if (const auto* id = std::get_if<Id>(&cell)) return id->id;
  return readable(cell);
}

Table for_people(Table table) {
  const auto is_time = [&](const std::string& column) {
    return is_of_times(column) || std::ranges::count(table.times, column) > 0;
  };
  std::vector<double*> seconds;
  for (std::vector<Cell>& row : table.rows) {
    const bool is_all = has_times(row);
    for (std::size_t c = 0; c < row.size(); ++c) {
      if (is_all || is_time(table.columns[c])) std::ranges::copy(numbers_in(row[c]), std::back_inserter(seconds));
    }
  }
  const std::string_view unit = with_short_times(seconds);
  const auto words = [&](std::string_view id, bool of_times) {
    NameWithUnit name = named(id);
    if (of_times) name.unit = unit;
    return text_of(name);
  };
  for (std::vector<Cell>& row : table.rows) {
    for (Cell& cell : row) {
      if (const auto* id = std::get_if<Id>(&cell)) cell = words(id->id, is_of_times(id->id));
    }
  }
  for (std::string& column : table.columns) column = words(column, is_time(column));
  table.times.clear();
  return table;
}

std::vector<std::size_t> columns_in_use(const Table& table) {
  std::vector<std::size_t> used;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const auto filled = [c](const std::vector<Cell>& row) { return !is_empty(row[c]); };
    if (table.rows.empty() || std::ranges::any_of(table.rows, filled)) used.push_back(c);
  }
  return used;
}

Table with_columns(const Table& table, std::span<const std::string_view> names) {
  Table result = table;
  result.columns.clear();
  for (auto& row : result.rows) row.clear();
  for (const std::string_view name : names) {
    const auto found = std::ranges::find(table.columns, name);
    if (found == table.columns.end()) continue;
    result.columns.push_back(*found);
    const auto c = static_cast<std::size_t>(found - table.columns.begin());
    for (std::size_t r = 0; r < table.rows.size(); ++r) result.rows[r].push_back(table.rows[r][c]);
  }
  return result;
}

std::vector<std::vector<std::string>> readable_cells(const Table& given) {
  const Table table = for_people(given);
  const std::vector<std::size_t> used = columns_in_use(table);
  std::vector<std::vector<std::string>> cells(1);
  for (const std::size_t c : used) cells[0].push_back(table.columns[c]);
  for (const auto& row : table.rows) {
    std::vector<std::string>& texts = cells.emplace_back();
    for (const std::size_t c : used) texts.push_back(readable(row[c]));
  }
  return cells;
}

std::string to_markdown(const Table& given) {
  const Table table = for_people(given);
  const std::vector<std::size_t> used = columns_in_use(table);
  std::string text = fmt::format("**{}**\n\n|", markdown_text(numbered_caption(table)));
  for (const std::size_t c : used) text += fmt::format(" {} |", markdown_text(table.columns[c]));
  text += "\n|";
  for (const std::size_t c : used) text += is_left(table, c) ? " :--- |" : " ---: |";
  text += '\n';
  for (const auto& row : table.rows) {
    text += '|';
    for (const std::size_t c : used) text += fmt::format(" {} |", markdown_text(readable(row[c])));
    text += '\n';
  }
  for (const std::string& note : table.notes) text += fmt::format("\n{}\n", markdown_text(note));
  return text;
}

std::string to_csv(const Table& table) {
  CsvTable csv;
  std::vector<bool> is_two;  // by column: it takes two in the file
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const bool has_ranges = has_any<Range>(table, c);
    is_two.push_back(has_ranges || has_any<OursAndPrinted>(table, c));
    const std::string& name = table.columns[c];
    csv.header.push_back(has_ranges ? name + " low" : name);
    if (is_two[c]) csv.header.push_back(name + (has_ranges ? " high" : " printed"));
  }
  for (const auto& row : table.rows) {
    std::vector<std::string>& cells = csv.rows.emplace_back();
    for (std::size_t c = 0; c < row.size(); ++c) {
      const Range* range = is_empty(row[c]) ? nullptr : std::get_if<Range>(&row[c]);
      const OursAndPrinted* beside = std::get_if<OursAndPrinted>(&row[c]);
      cells.push_back(range ? text_of(range->low) : computable(row[c]));
      if (is_two[c]) cells.push_back(range ? text_of(range->high) : beside ? beside->printed : "");
    }
  }
  return to_csv(csv);
}

}  // namespace ikbench::report
