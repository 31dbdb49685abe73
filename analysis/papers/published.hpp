// The printed numbers of a paper (results/published), and the ranges that such numbers of new studies have.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/judge/statistics/descriptives.hpp"
#include "analysis/judge/statistics/two_sample_tests.hpp"

namespace ikbench::papers {

bool agrees(double ours, std::string_view printed);                      // our number rounds to the printed digits
bool can_be(const judge::Interval& interval, std::string_view printed);  // a number in it does

// A statistic that a table of means may have, by its column.
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

const PrintedRow* row_of(const PrintedRows& rows, std::string_view solver);  // null if there is none

// Returns the rows of one metric from a table with the columns algorithm, metric, n and the statistics.
PrintedRows printed_means(std::string_view paper, std::string_view table, std::string_view metric);

// The range of each statistic in most studies of so many runs, by Hill's A(n) (JASA 63 (1968) 677) on the logarithms of
// the values: the next one is equally likely in each gap of the known ones, and then is known itself; beyond the last
// there is an exponential tail of Hill's slope (Annals of Statistics 3 (1975) 1163). It is made for 95 % of studies,
// and holds 92 % (tests/papers/published.test.cpp). None for fewer than five values, or one that is not above 0.
using Ranges = std::array<judge::Interval, statistics.size()>;
std::optional<Ranges> predicted_ranges(const std::vector<double>& values, int runs);

// Whether a statistic of ours rounds to the printed digits, or a new study's may.
bool repeats(double ours, const judge::Interval& range, std::string_view printed);

}  // namespace ikbench::papers
