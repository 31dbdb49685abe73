#include "analysis/papers/published.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "numerics/number.hpp"
#include "results/published.hpp"

namespace ikbench::papers {

using results::CsvTable;

namespace {

double parsed(std::string_view text) {
  if (const auto number = numerics::number_from(text)) return *number;
  throw std::invalid_argument(fmt::format("'{}' is no number", text));
}

bool has_column(const CsvTable& table, std::string_view column) {
  return std::ranges::find(table.header, column) != table.header.end();
}

// Columns such as mean_ms.
PrintedRow read_row(const CsvTable& table, std::size_t row, std::string solver, std::string_view unit) {
  PrintedRow printed{.solver = std::move(solver), .numbers = {.n = static_cast<int>(table.number(row, "n"))}};
  for (std::size_t s = 0; s < statistics.size(); ++s) {
    const std::string column = fmt::format("{}{}", statistics[s].column, unit);
    if (!has_column(table, column)) continue;
    printed.numbers.*statistics[s].of = table.number(row, column);
    printed.digits[s] = table.rows[row][table.column(column)];
  }
  return printed;
}

}  // namespace

double half_unit(std::string_view printed) {
  parsed(printed);
  const std::size_t e = std::min(printed.find_first_of("eE"), printed.size());
  const std::string_view mantissa = printed.substr(0, e);
  const std::size_t point = mantissa.find('.');
  const std::size_t decimals = point == std::string_view::npos ? 0 : mantissa.size() - point - 1;
  return parsed(fmt::format("0.5e-{}", decimals)) * parsed(fmt::format("1{}", printed.substr(e)));
}

bool agrees(double ours, std::string_view printed) {
  constexpr double room = 1 + 1e-9;  // 2.5 printed as 2 is half a unit off, and doubles are not exact
  return std::abs(ours - parsed(printed)) <= half_unit(printed) * room;
}

bool can_be(const compare::Interval& of, std::string_view printed) {
  const double number = parsed(printed), half = half_unit(printed);
  return of.low <= number + half && number - half <= of.high;
}

std::string in_thousandths(std::string_view printed) {
  const auto decimals = static_cast<int>(std::lround(-std::log10(2 * half_unit(printed))));
  return fmt::format("{:.{}f}", 1000 * parsed(printed), std::max(0, decimals - 3));
}

const PrintedRow* row_of(const PrintedRows& rows, std::string_view solver) {
  const auto row = std::ranges::find(rows, solver, &PrintedRow::solver);
  return row == rows.end() ? nullptr : &*row;
}

CsvTable printed_table(std::string_view paper, std::string_view name) {
  const auto names = results::published::tables(paper);
  return std::ranges::find(names, name) == names.end() ? CsvTable() : results::published::table(paper, name);
}

PrintedRows printed_means(std::string_view paper, std::string_view name, std::string_view metric) {
  PrintedRows rows;
  const CsvTable table = printed_table(paper, name);
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const auto& cells = table.rows[i];
    if (cells[table.column("metric")] == metric)
      rows.push_back(read_row(table, i, cells[table.column("algorithm")], ""));
  }
  return rows;
}

PrintedRows printed_times(std::string_view paper, std::string_view name) {
  PrintedRows rows;
  const CsvTable table = printed_table(paper, name);
  for (std::size_t i = 0; i < table.rows.size(); ++i)
    rows.push_back(read_row(table, i, fmt::format("{} {}", table.rows[i][0], table.header[0]), "_ms"));
  return rows;
}

compare::Observations observations_of(const PrintedRows& rows, const compare::Observations& ours) {
  compare::Observations of = ours;
  of.is_paired = false;
  of.groups.clear();
  for (const auto& [solver, numbers, digits] : rows)
    of.groups.push_back({.name = solver, .summary = compare::Summary{numbers.n, numbers.mean, numbers.sd}});
  return of;
}

show::Cell beside(double ours, const PrintedRow* row, std::size_t statistic) {
  if (row == nullptr || row->digits[statistic].empty()) return ours;
  return show::Printed{ours, row->digits[statistic]};
}

}  // namespace ikbench::papers
