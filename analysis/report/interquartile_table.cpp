#include "analysis/report/interquartile_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <utility>

#include "analysis/inference/design.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/statistics/interquartile_mean.hpp"

namespace ikbench::report {

using namespace results;
using namespace statistics;
using namespace inference;

namespace {

// The values of a solver's complete runs.
Stratum complete_runs(const StudyResults& study, const std::string& solver, Metric metric) {
  std::map<int, Cluster> runs;
  for (const Solve& solve : solves_of(study, solver)) runs[solve.run].push_back(value_of(study, solve, metric));
  Stratum complete;
  for (auto& [run, values] : runs) {
    if (values.size() == static_cast<std::size_t>(study.points)) complete.push_back(std::move(values));
  }
  return complete;
}

// For each target its values, one a run.
std::vector<Stratum> by_target(const Stratum& runs) {
  std::vector<Stratum> targets;
  for (const Cluster& run : runs) {
    targets.resize(run.size());
    for (std::size_t point = 0; point < run.size(); ++point) targets[point].push_back({run[point]});
  }
  return targets;
}

}  // namespace

Table interquartile_table(const StudyResults& study, Metric metric) {
  const double level = 1 - study.plan.significance;
  Table table{.name = fmt::format("statistics-{}-interquartile", info_of(metric).slug),
              .caption = fmt::format("Interquartile mean over all solves: {}", quantity(metric)),
              .columns = {{"solver", Align::left},
                          {"solves"},
                          {"interquartile mean"},
                          {percent(level) + " interval"},
                          {"no interval because", Align::left}}};
  const bool has_strata = blocks_of(study) == Blocks::path_targets;
  for (const std::string& solver : study.solvers) {
    const Stratum runs = complete_runs(study, solver, metric);
    const InterquartileMean found =
        interquartile_mean(has_strata ? by_target(runs) : std::vector<Stratum>{runs}, level);
    table.rows.push_back({solver, static_cast<std::int64_t>(runs.size()) * study.points, found.estimate,
                          std::isfinite(found.low) ? Cell(Range{found.low, found.high}) : Cell(),
                          found.undefined.empty() ? Cell() : Cell(found.undefined)});
  }
  table.notes.push_back(fmt::format(
      "The mean of the middle half of all solves of complete runs. Its interval: percentiles of 2000 bootstrap resamples, "
      "in which {}.",
      has_strata ? "runs are drawn anew for each target" : "whole runs are drawn"));
  return table;
}

}  // namespace ikbench::report
