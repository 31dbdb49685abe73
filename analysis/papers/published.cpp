#include "analysis/papers/published.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "base/csv.hpp"
#include "base/number.hpp"
#include "results/published.hpp"

namespace ikbench::papers {

using base::CsvTable;

namespace {

// Returns a random number between 0 and 1, without both ends. The number is the same on every machine.
double open_uniform(std::mt19937_64& engine) { return (static_cast<double>(engine() >> 32) + 0.5) * 0x1p-32; }

// Returns the mean distance of the outermost fifth of the values from the value before it.
double tail_slope(const std::vector<double>& outwards) {
  const std::size_t tail = std::max<std::size_t>(2, outwards.size() / 5);
  double sum = 0;
  for (std::size_t i = outwards.size() - tail; i < outwards.size(); ++i)
    sum += std::abs(outwards[i] - outwards[outwards.size() - tail - 1]);
  return sum / static_cast<double>(tail);
}

}  // namespace

bool can_be(const judge::Interval& interval, std::string_view printed) {
  constexpr double room = 1 + 1e-9;  // for rounding: 2.5 printed as 2 is exactly half a unit off
  const double number = base::number_from(printed).value(), half = base::last_digit(printed) / 2 * room;
  return interval.low <= number + half && number - half <= interval.high;
}

bool agrees(double ours, std::string_view printed) { return can_be({ours, ours}, printed); }

bool repeats(double ours, const judge::Interval& range, std::string_view printed) {
  return agrees(ours, printed) || can_be(range, printed);
}

int repeated_statistics(const judge::Descriptives& ours, const Ranges& ranges, const PrintedRow& row) {
  int count = 0;
  for (std::size_t s = 0; s < statistics.size(); ++s)
    count += repeats(ours.*statistics[s].of, ranges[s], row.digits[s]);
  return count;
}

bool is_wide(const judge::Interval& range) {
  constexpr double factor = 10;
  return range.high > factor * range.low;
}

const PrintedRow* row_of(const PrintedRows& rows, std::string_view solver) {
  const auto row = std::ranges::find(rows, solver, &PrintedRow::solver);
  return row == rows.end() ? nullptr : &*row;
}

PrintedRows printed_means(std::string_view paper, std::string_view name, std::string_view metric) {
  PrintedRows rows;
  const CsvTable table = results::published::table(paper, name);
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (table.cell(i, table.column("metric")) != metric) continue;
    PrintedRow& row = rows.emplace_back(PrintedRow{.solver = std::string(table.cell(i, table.column("algorithm")))});
    row.numbers.n = static_cast<int>(table.number(i, "n"));
    for (std::size_t s = 0; s < statistics.size(); ++s) {
      row.numbers.*statistics[s].of = table.number(i, statistics[s].column);
      row.digits[s] = table.cell(i, table.column(statistics[s].column));
    }
  }
  return rows;
}

std::optional<Ranges> predicted_ranges(const std::vector<double>& values, int runs) {
  constexpr std::size_t studies = 500, least = 12, most = 487;  // places of 2.5 and 97.5 % among 500
  if (values.size() < 5 || std::ranges::min(values) <= 0) return {};
  std::vector<double> logs;
  logs.reserve(values.size());
  for (const double value : values) logs.push_back(std::log(value));
  std::ranges::sort(logs);
  const double above = tail_slope(logs), below = tail_slope({logs.rbegin(), logs.rend()});
  std::mt19937_64 engine(1);
  std::array<std::vector<double>, statistics.size()> replicates;
  for (std::size_t i = 0; i < studies; ++i) {
    std::vector<double> known = logs;
    std::vector<double> study;
    for (int run = 0; run < runs; ++run) {
      const double place = open_uniform(engine) * static_cast<double>(known.size() + 1), u = open_uniform(engine);
      const auto gap = static_cast<std::size_t>(place);
      double value = 0;
      if (gap == 0)
        value = known.front() + below * std::log(u);
      else if (gap == known.size())
        value = known.back() - above * std::log(u);
      else
        value = known[gap - 1] + u * (known[gap] - known[gap - 1]);
      known.insert(known.begin() + static_cast<std::ptrdiff_t>(gap), value);
      study.push_back(std::exp(value));
    }
    const judge::Descriptives descriptives = judge::describe_values(study);
    for (std::size_t s = 0; s < statistics.size(); ++s) replicates[s].push_back(descriptives.*statistics[s].of);
  }
  Ranges ranges;
  for (std::size_t s = 0; s < statistics.size(); ++s) {
    std::ranges::sort(replicates[s]);
    ranges[s] = {replicates[s][least], replicates[s][most]};
  }
  return ranges;
}

}  // namespace ikbench::papers
