#include "analysis/report/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

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

template <class Kind>
bool has_any(const Table& table, std::size_t column) {
  return std::ranges::any_of(
      table.rows, [column](const std::vector<Cell>& row) { return std::holds_alternative<Kind>(row[column]); });
}

}  // namespace

std::string numbered_caption(const Table& table) {
  return table.number == 0 ? table.caption : fmt::format("Table {}: {}", table.number, table.caption);
}

std::string readable(const Cell& cell) {
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
            return fmt::format("{} (printed {}{}{})", own_digits(beside), beside.printed,
                               beside.words.empty() ? "" : ": ", beside.words);
          },
          [](const Graded& graded) { return graded.words; }},
      cell);
}

std::string own_digits(const OursAndPrinted& beside) {
  return beside.decimals < 0 ? short_number(beside.ours) : fmt::format("{:.{}f}", beside.ours, beside.decimals);
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
    return text ? !number_from(*text) : std::holds_alternative<Graded>(row[column]);
  });
}

std::string computable(const Cell& cell) {
  const auto number = [](double value) { return std::isfinite(value) ? text_of(value) : std::string(); };
  if (const auto* value = std::get_if<double>(&cell)) return number(*value);
  if (const auto* p = std::get_if<PValue>(&cell)) return number(p->value);
  if (const auto* range = std::get_if<Range>(&cell)) return text_of(range->low) + " to " + text_of(range->high);
  if (const auto* beside = std::get_if<OursAndPrinted>(&cell)) return number(beside->ours);
  return readable(cell);
}

std::vector<std::size_t> columns_in_use(const Table& table) {
  std::vector<std::size_t> used;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const auto filled = [c](const std::vector<Cell>& row) { return !std::holds_alternative<std::monostate>(row[c]); };
    if (table.rows.empty() || std::ranges::any_of(table.rows, filled)) used.push_back(c);
  }
  return used;
}

std::vector<std::vector<std::string>> readable_cells(const Table& table) {
  const std::vector<std::size_t> used = columns_in_use(table);
  std::vector<std::vector<std::string>> cells(1);
  for (const std::size_t c : used) cells[0].push_back(table.columns[c]);
  for (const auto& row : table.rows) {
    std::vector<std::string>& texts = cells.emplace_back();
    for (const std::size_t c : used) texts.push_back(readable(row[c]));
  }
  return cells;
}

std::string to_markdown(const Table& table) {
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
      const Range* range = std::get_if<Range>(&row[c]);
      const OursAndPrinted* beside = std::get_if<OursAndPrinted>(&row[c]);
      cells.push_back(range ? text_of(range->low) : computable(row[c]));
      if (is_two[c]) cells.push_back(range ? text_of(range->high) : beside ? beside->printed : "");
    }
  }
  return to_csv(csv);
}

}  // namespace ikbench::report
