// The printed tables of a paper (results/published), for claims and a paper's own tables.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/inference/study.hpp"
#include "analysis/statistics/anova.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "results/csv.hpp"

namespace ikbench::claims {

// The functions of printed digits throw std::runtime_error for a text that is no number.
// Half a unit of the last printed digit: the possible rounding error of "1.7824e-4".
double half_unit(std::string_view printed);
// Returns whether our number rounds to the printed digits.
bool agrees(double ours, std::string_view printed);
// Returns whether a number of the range rounds to the printed digits.
bool can_be(double low, double high, std::string_view printed);

// A table as printed; without rows if the paper has none of that name.
results::CsvTable printed_table(std::string_view paper, std::string_view name);

// The statistics that a table of means may have, by their columns.
constexpr std::array<std::pair<std::string_view, double statistics::Description::*>, 5> printed_statistics{
    {{"mean", &statistics::Description::mean},
     {"median", &statistics::Description::median},
     {"std", &statistics::Description::std},
     {"max", &statistics::Description::max},
     {"min", &statistics::Description::min}}};

// The printed numbers of one metric of one solver.
struct PrintedRow {
  std::string algorithm;
  statistics::Description printed = {};  // not defined if the table has no such column
  std::array<std::string, printed_statistics.size()> digits = {};

  statistics::GroupSummary summary() const { return {printed.mean, printed.std, printed.n}; }
};

// The rows of one metric in a table of means (columns algorithm, metric, n and the statistics), in their order.
std::vector<PrintedRow> printed_rows(std::string_view paper, std::string_view table, inference::Metric metric);
// The rows of a table of times (columns n, mean_ms, median_ms and so on). `name` names a row's solver: "{bats} bats"
// with its column bats.
std::vector<PrintedRow> printed_times(std::string_view paper, std::string_view table, const std::string& name);

// A printed analysis of variance (rows between, within and total); nothing if it answers another question than the
// study's: about other solvers than those of these rows, or about points.
std::optional<statistics::AnovaTable> comparable_anova(const inference::StudyResults& study,
                                                       const std::vector<PrintedRow>& rows, std::string_view table);

// Fills the names in "{word} of {n}"; throws std::runtime_error for an unknown name.
using Words = std::map<std::string, std::string, std::less<>>;
std::string filled(const std::string& text, const Words& words);

}  // namespace ikbench::claims
