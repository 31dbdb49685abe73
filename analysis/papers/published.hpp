// The numbers that papers print (results/published), with their digits.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/compare/describe.hpp"
#include "analysis/show/block.hpp"
#include "results/csv.hpp"

namespace ikbench::papers {

// These throw std::invalid_argument for a text that is no number.
double half_unit(std::string_view printed);                          // of the last digit: 5e-9 of "1.7824e-4"
bool agrees(double ours, std::string_view printed);                  // our number rounds to the printed digits
bool can_be(const compare::Interval& of, std::string_view printed);  // a number in it does

std::string in_thousandths(std::string_view printed);  // "243.9" of "0.2439"

// What a table of means may have, by its columns.
struct Statistic {
  std::string_view column;
  double compare::Description::*of;
};
constexpr std::array<Statistic, 5> statistics{{{"mean", &compare::Description::mean},
                                               {"median", &compare::Description::median},
                                               {"std", &compare::Description::sd},
                                               {"max", &compare::Description::largest},
                                               {"min", &compare::Description::smallest}}};

// Of one solver and metric.
struct PrintedRow {
  std::string solver;
  compare::Description numbers = {};  // unknown where the table has no such column
  std::array<std::string, statistics.size()> digits = {};
};
using PrintedRows = std::vector<PrintedRow>;

const PrintedRow* row_of(const PrintedRows& rows, std::string_view solver);  // null if there is none

// As printed; without rows if the paper has no such table.
results::CsvTable printed_table(std::string_view paper, std::string_view name);
// Of a table with the columns algorithm, metric, n and the statistics.
PrintedRows printed_means(std::string_view paper, std::string_view table, std::string_view metric);
// Of a table with n, mean_ms, median_ms and so on; its solvers are named "12 bats" from its first column, bats.
PrintedRows printed_times(std::string_view paper, std::string_view table);

// The range of each statistic in most studies of so many runs, by Hill's A(n) (JASA 63 (1968) 677) on the logarithms of
// the values: the next one is equally likely in each gap of the known ones, and then is known itself; beyond the last
// there is an exponential tail of Hill's slope (Annals of Statistics 3 (1975) 1163). It is made for 95 % of studies,
// and holds 92 % (tests/papers/published.test.cpp). None for fewer than five values, or one that is not above 0.
using Ranges = std::array<compare::Interval, statistics.size()>;
std::optional<Ranges> predicted_ranges(const std::vector<double>& values, int runs);

// Groups that are compared by their means, of the same quantity as ours.
compare::Observations observations_of(const PrintedRows& rows, const compare::Observations& ours);

// Ours beside the printed digits, if there are any.
show::Cell beside(double ours, const PrintedRow* row, std::size_t statistic);

}  // namespace ikbench::papers
