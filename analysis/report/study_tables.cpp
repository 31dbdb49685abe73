#include "analysis/report/study_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <set>
#include <utility>

#include "analysis/inference/clusters.hpp"
#include "analysis/inference/comparable.hpp"
#include "analysis/inference/design.hpp"
#include "analysis/inference/estimand.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/inference/times.hpp"
#include "analysis/report/words.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "analysis/statistics/proportion.hpp"
#include "analysis/statistics/quantile.hpp"

namespace ikbench::report {

using namespace results;
using namespace statistics;
using namespace inference;
using namespace fmt::literals;

namespace {

std::string_view unit_note(Unit unit, std::span<const Metric> metrics) {
  if (unit == Unit::point) {
    return words::points;
  }
  const auto is_time = [](Metric metric) { return info_of(metric).kind == Kind::time; };
  if (std::ranges::all_of(metrics, is_of_run)) return words::runs;
  if (std::ranges::none_of(metrics, is_time)) return words::means;
  if (std::ranges::all_of(metrics, is_time)) return words::medians;
  if (std::ranges::none_of(metrics, is_of_run)) {
    return words::means_and_medians;
  }
  return words::means_medians_and_runs;
}

void add_notes(Table& table, const StudyResults& study, std::span<const Metric> metrics) {
  table.notes.emplace_back(unit_note(study.plan.unit, metrics));
  for (std::string& note : status_notes(study)) table.notes.push_back(std::move(note));
}

void add_timing_notes(Table& table, const StudyResults& study) {
  const Doubts doubts = times_doubts(study) + outlier_doubts(study) + program_doubts(study);
  std::ranges::move(list_of(doubts), std::back_inserter(table.notes));
}

Cell count(std::int64_t number) { return number; }

void leave_out_test(Table& table) {
  for (const char* name : {"F", "p"}) {
    const auto column = std::ranges::find(table.columns, name) - table.columns.begin();
    for (auto& row : table.rows) row[static_cast<std::size_t>(column)] = {};
  }
}

}  // namespace

Table results_table(const StudyResults& study, std::span<const Metric> metrics) {
  Table table{.name = "results",
              .caption = "What was reached",
              .columns = {"algorithm", "metric", "mean", "median", "std", "max", "min"}};
  for (const Metric metric : metrics) {
    for (const Sample& sample : samples(study, metric)) {
      const Description of = statistics::describe(sample.values);
      table.rows.push_back({sample.solver, std::string(name_of(metric)), of.mean, of.median, of.std, of.max, of.min});
    }
  }
  add_notes(table, study, metrics);
  if (std::isfinite(tolerance_cm(study))) table.notes.push_back(fmt::format(words::as_measured, "penalty"_a = penalty));
  add_timing_notes(table, study);
  return table;
}

Table further_table(const StudyResults& study, std::span<const Metric> metrics) {
  Table table{.name = "further", .caption = "Further means over the runs", .columns = {"algorithm"}};
  for (const std::string& solver : study.solvers) table.rows.push_back({solver});
  for (const Metric metric : metrics) {
    table.columns.push_back(std::string(name_of(metric)));
    std::size_t row = 0;
    for (const Sample& sample : samples(study, metric)) {
      table.rows[row++].emplace_back(average_in(statistics::describe(sample.values), metric));
    }
    table.notes.push_back(fmt::format("{}: {}.", name_of(metric), info_of(metric).name));
  }
  return table;
}

StudyAnova anova(const StudyResults& study, Metric metric) {
  StudyAnova result;
  std::vector<std::vector<double>> groups;
  for (Sample& sample : samples(study, metric)) {
    const Description description = statistics::describe(sample.values);
    if (description.n == 0) {
      result.left_out.push_back(fmt::format(words::anova_without_observations, "solver"_a = sample.solver));
    } else if (description.not_finite > 0) {
      result.left_out.push_back(fmt::format(words::anova_without_not_finite, "solver"_a = sample.solver,
                                            "lost"_a = description.not_finite, "n"_a = description.n));
    } else {
      groups.push_back(std::move(sample.values));
    }
  }
  result.table = statistics::anova(groups);
  return result;
}

std::array<std::vector<Cell>, 3> anova_cells(const AnovaTable& table) {
  return {{{table.ss_between, count(table.df_between), table.ms_between, table.F, PValue{table.p}},
           {table.ss_within, count(table.df_within), table.ms_within, {}, {}},
           {table.ss_total, count(table.df_total()), {}, {}, {}}}};
}

Table anova_table(const StudyResults& study, Metric metric) {
  Table table{.name = fmt::format("anova-{}", info_of(metric).slug),
              .caption = fmt::format("One-way ANOVA of the {}", quantity(metric)),
              .columns = {"source", "SS", "df", "MS", "F", "p"}};
  const bool is_judged = is_comparable(study, metric);
  const StudyAnova ours = anova(is_judged ? compared_in(study, metric) : study, metric);
  const auto cells = anova_cells(ours.table);
  for (std::size_t i = 0; i < anova_sources.size(); ++i) {
    std::vector<Cell>& row = table.rows.emplace_back(1, std::string(anova_sources[i]));
    row.insert(row.end(), cells[i].begin(), cells[i].end());
  }
  if (!is_judged) leave_out_test(table);
  if (is_judged && !ours.table.undefined.empty())
    table.notes.push_back(fmt::format(words::anova_undefined, "why"_a = ours.table.undefined));
  table.notes.insert(table.notes.end(), ours.left_out.begin(), ours.left_out.end());
  add_notes(table, study, std::span(&metric, 1));
  if (!is_judged) table.notes.push_back(fmt::format(words::anova_not_judged, "why"_a = words_of(timing_doubts(study))));
  if (is_judged) std::ranges::move(list_of(left_out(study, metric)), std::back_inserter(table.notes));
  return table;
}

Table solved_table(const StudyResults& study) {
  const double level = 1 - study.plan.significance;
  const Trials trials = trials_of(study);
  Table table{.name = "solved",
              .caption = "Share of solves with the status ok",
              .columns = {"algorithm", "solves", "solved", "share", fmt::format("{} interval", percent(level))}};
  const std::vector<std::uint32_t> targets = target_numbers(study);
  for (const SolverCounts& solver : counts(study)) {
    std::set<std::uint32_t> own_targets;
    for (const Solve& solve : solves_of(study, solver.solver)) {
      own_targets.insert(targets[static_cast<std::size_t>(&solve - study.solves.data())]);
    }
    const auto independent = trials == Trials::runs      ? solver.complete_runs + solver.incomplete_runs
                             : trials == Trials::targets ? static_cast<int>(own_targets.size())
                                                         : solver.solves;
    const int solved = solver.of(Status::ok);
    const Estimate share = wilson_of_mean(static_cast<double>(solved) / solver.solves, independent, level);
    table.rows.push_back({solver.solver, count(solver.solves), count(solved), share.value,
                          std::isfinite(share.low) ? Cell(Range{share.low, share.high}) : Cell()});
  }
  table.notes.emplace_back(words::solved);
  if (trials != Trials::solves) {
    table.notes.push_back(fmt::format(words::trials, "trial"_a = trials == Trials::runs ? "run" : "target"));
  }
  table.notes.emplace_back(words::wilson);
  return table;
}

Table times_table(const StudyResults& study) {
  constexpr double ms_per_second = 1000;
  const double deadline = deadline_seconds(study);
  const bool says_solved = std::isfinite(deadline) && std::isfinite(tolerance_cm(study));
  Table table{.name = "times",
              .caption = "Computing times of all solves",
              .columns = {"algorithm", "median_ms", "p95_ms", "p99_ms", "longest_ms", "over_deadline"}};
  if (says_solved) table.columns.push_back("solved_in_time");
  for (const std::string& solver : study.solvers) {
    std::vector<double> seconds;
    std::int64_t in_time = 0;
    for (const Solve& solve : solves_of(study, solver)) {
      seconds.push_back(value_of(study, solve, Metric::seconds));
      in_time += solve.status == Status::ok && solve.seconds <= deadline ? 1 : 0;
    }
    const std::vector<double> ranked = ranked_values(seconds);
    std::vector<Cell> row{solver};
    for (const double p : {0.5, 0.95, 0.99, 1.0}) {
      row.emplace_back(ms_per_second * quantile(ranked, p, quantile_type(study.plan.quartiles)));
    }
    const auto late = std::ranges::count_if(seconds, [&](double time) { return !(time <= deadline); });
    row.push_back(std::isfinite(deadline) && !seconds.empty()
                      ? Cell(static_cast<double>(late) / static_cast<double>(seconds.size()))
                      : Cell());
    if (says_solved) row.emplace_back(static_cast<double>(in_time) / static_cast<double>(seconds.size()));
    table.rows.push_back(std::move(row));
  }
  table.notes.emplace_back(words::percentiles);
  if (std::isfinite(deadline)) {
    const std::string limit = rounded_number(ms_per_second * deadline, 6);
    table.notes.push_back(says_solved ? fmt::format(words::deadline_and_solved, "deadline"_a = limit)
                                      : fmt::format(words::deadline, "deadline"_a = limit));
  }
  add_timing_notes(table, study);
  return table;
}

Table flow_table(const StudyResults& study) {
  // What leaves no usable answer, in the order in which it happens.
  constexpr std::array<std::pair<Status, std::string_view>, 7> losses{
      {{Status::declined, "declined"},
       {Status::crashed, "crashed"},
       {Status::timed_out, "timed out"},
       {Status::broke_protocol, "broke the protocol"},
       {Status::refused, "refused"},
       {Status::not_finite, "not finite"},
       {Status::claimed_but_wrong, "claimed but wrong"}}};
  Table table{.name = "flow",
              .caption = "From planned solves to observations",
              .columns = {"solver", "planned", "not solved"},
              .notes = {std::string(words::flow)}};
  for (const auto& [status, heading] : losses) table.columns.emplace_back(heading);
  table.columns.insert(table.columns.end(), {"other answers", "observations"});
  const Observations analysed = observations(study, Metric::position_error_cm);
  for (const SolverCounts& solver : counts(study)) {
    std::vector<Cell> row{solver.solver, solver.expected, std::max<std::int64_t>(0, solver.expected - solver.solves)};
    int others = solver.solves;
    for (const auto& [status, heading] : losses) {
      row.push_back(count(solver.of(status)));
      others -= solver.of(status);
    }
    row.push_back(count(others));
    const auto group = std::ranges::find(analysed.groups, solver.solver, &Group::name);
    row.push_back(count(group == analysed.groups.end() ? 0 : static_cast<std::int64_t>(group->values.size())));
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table status_table(const StudyResults& study) {
  Table table{.name = "status",
              .caption = "Outcome of every solve, checked by the independent verifier",
              .columns = {"algorithm"}};
  const std::vector<Status> statuses = shown_statuses(study);
  for (const Status status : statuses) table.columns.push_back(std::string(name_of(status)));
  for (const char* name :
       {"solves", "expected", "complete_runs", "incomplete_runs", "outside_limits", "worst_outside_deg"}) {
    table.columns.push_back(name);
  }
  const bool has_processes = std::ranges::find(study.solves, Timing::process, &Solve::timing) != study.solves.end();
  for (const char* name : {"timing_clean", "timing_disturbed", "timing_parallel", "timing_debug_build"}) {
    table.columns.push_back(name);
  }
  if (has_processes) table.columns.push_back("timing_process");
  for (const SolverCounts& solver : counts(study)) {
    std::vector<Cell> row{solver.solver};
    for (const Status status : statuses) row.push_back(count(solver.of(status)));
    for (const std::int64_t number : std::initializer_list<std::int64_t>{
             solver.solves, solver.expected, solver.complete_runs, solver.incomplete_runs, solver.outside_limits}) {
      row.push_back(count(number));
    }
    row.emplace_back(solver.worst_outside_deg);
    const bool disturbed = times_were_disturbed(study, solver.solver);
    const int alone = solver.of(Timing::clean);
    for (const int number :
         {disturbed ? 0 : alone, disturbed ? alone : 0, solver.of(Timing::parallel), solver.of(Timing::debug_build)}) {
      row.push_back(count(number));
    }
    if (has_processes) row.push_back(count(solver.of(Timing::process)));
    table.rows.push_back(std::move(row));
  }
  table.notes = status_notes(study);
  table.notes.emplace_back(words::statuses);
  add_timing_notes(table, study);
  return table;
}

}  // namespace ikbench::report
