// The printed numbers of a paper (results/published), and the ranges that the same numbers of new studies would have.
// repeated.cpp compares our numbers with both.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/judge/statistics/descriptives.hpp"
#include "analysis/judge/statistics/two_sample_tests.hpp"

namespace ikbench::papers {

// Returns whether our number rounds to the printed digits.
bool agrees(double ours, std::string_view printed);
// Returns whether a number in the interval rounds to the printed digits.
bool can_be(const judge::Interval& interval, std::string_view printed);

// A statistic that a table of means may have, with the name of the column.
struct Statistic {
  std::string_view column;
  double judge::Descriptives::*of;
};
constexpr std::array<Statistic, 5> statistics{{{"mean", &judge::Descriptives::mean},
                                               {"median", &judge::Descriptives::median},
                                               {"std", &judge::Descriptives::sd},
                                               {"max", &judge::Descriptives::largest},
                                               {"min", &judge::Descriptives::smallest}}};

// The printed statistics of one solver and metric.
struct PrintedRow {
  std::string solver;
  judge::Descriptives numbers = {};
  std::array<std::string, statistics.size()> digits = {};
};
using PrintedRows = std::vector<PrintedRow>;

// Returns the row of a solver; null if there is none.
const PrintedRow* row_of(const PrintedRows& rows, std::string_view solver);

// Returns the rows of one metric from the table `name` with the columns algorithm, metric, n and the statistics.
PrintedRows printed_means(std::string_view paper, std::string_view name, std::string_view metric);

// The range of each statistic, in the order of `statistics`.
using Ranges = std::array<judge::Interval, statistics.size()>;
// Returns the range of each statistic in most new studies of so many runs, by Hill's A(n) (JASA 63 (1968) 677) on the
// logarithms of the values. The next value is equally likely in each gap of the known values, and then is a known
// value, too. Beyond the last value there is an exponential tail of Hill's slope (Annals of Statistics 3 (1975) 1163).
// The ranges hold about 95 % of studies, and fewer where a rare run is far off: about 89 % if one run in 150 is 10 to
// 400 times as large (tests/papers/published.test.cpp). The statistics of a study are one sample: they lie inside or
// outside together. Returns nullopt for fewer than five values, or if a value is not above 0.
std::optional<Ranges> predicted_ranges(const std::vector<double>& values, int runs);

// Returns whether our statistic rounds to the printed digits, or whether a new study's statistic in `range` may.
bool repeats(double ours, const judge::Interval& range, std::string_view printed);
// Returns how many statistics of ours repeat those of the printed row.
int repeated_statistics(const judge::Descriptives& ours, const Ranges& ranges, const PrintedRow& row);
// Returns whether the range is wider than a factor of ten. That a number lies in such a range says little.
bool is_wide(const judge::Interval& range);

}  // namespace ikbench::papers
