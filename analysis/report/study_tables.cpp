#include "analysis/report/study_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <utility>

#include "analysis/inference/times.hpp"
#include "analysis/statistics/descriptive.hpp"

namespace ikbench::report {

using namespace results;
using namespace statistics;
using namespace inference;

namespace {

std::string_view unit_note(Unit unit, std::span<const Metric> metrics) {
  if (unit == Unit::point) {
    return "One observation is one point. Points of one run depend on each other, so p-values and standard deviations "
           "are too optimistic.";
  }
  const auto is_time = [](Metric metric) { return info_of(metric).kind == Kind::time; };
  if (std::ranges::none_of(metrics, is_time)) return "One observation is the mean of a run over its points.";
  if (std::ranges::all_of(metrics, is_time)) return "One observation is the median of a run over its points.";
  return "One observation is the mean of a run over its points; of times it is the median.";
}

void add_notes(Table& table, const StudyResults& study, std::span<const Metric> metrics) {
  table.notes.emplace_back(unit_note(study.plan.unit, metrics));
  for (std::string& note : status_notes(study)) table.notes.push_back(std::move(note));
}

void add_timing_notes(Table& table, const StudyResults& study) {
  for (const std::string& note : {timing_note(study), outliers_note(study)}) {
    if (!note.empty()) table.notes.push_back(note);
  }
}

Cell count(std::int64_t number) { return number; }

void leave_out_test(Table& table) {
  for (const char* name : {"F", "p"}) {
    const auto column = std::ranges::find(table.columns, name, &Column::name) - table.columns.begin();
    for (auto& row : table.rows) row[static_cast<std::size_t>(column)] = {};
  }
}

}  // namespace

Table results_table(const StudyResults& study, std::span<const Metric> metrics) {
  Table table{
      .name = "results",
      .caption = "What was reached",
      .columns = {
          {"algorithm", Align::left}, {"metric", Align::left}, {"mean"}, {"median"}, {"std"}, {"max"}, {"min"}}};
  for (const Metric metric : metrics) {
    for (const Sample& sample : samples(study, metric)) {
      const Description of = statistics::describe(sample.values);
      table.rows.push_back({sample.solver, std::string(name_of(metric)), of.mean, of.median, of.std, of.max, of.min});
    }
  }
  add_notes(table, study, metrics);
  add_timing_notes(table, study);
  return table;
}

StudyAnova anova(const StudyResults& study, Metric metric) {
  StudyAnova result;
  std::vector<std::vector<double>> groups;
  for (Sample& sample : samples(study, metric)) {
    const Description description = statistics::describe(sample.values);
    if (description.n == 0) {
      result.left_out.push_back(fmt::format("Left out of the ANOVA: {} (no observations).", sample.solver));
    } else if (description.not_finite > 0) {
      result.left_out.push_back(fmt::format("Left out of the ANOVA: {} ({} of {} observations not finite).",
                                            sample.solver, description.not_finite, description.n));
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
              .columns = {{"source", Align::left}, {"SS"}, {"df"}, {"MS"}, {"F"}, {"p"}}};
  const StudyAnova ours = anova(study, metric);
  const auto cells = anova_cells(ours.table);
  for (std::size_t i = 0; i < anova_sources.size(); ++i) {
    std::vector<Cell>& row = table.rows.emplace_back(1, std::string(anova_sources[i]));
    row.insert(row.end(), cells[i].begin(), cells[i].end());
  }
  const bool is_judged = is_comparable(study, metric);
  if (!is_judged) leave_out_test(table);
  if (is_judged && !ours.table.undefined.empty())
    table.notes.push_back("F and p are not defined: " + ours.table.undefined + ".");
  table.notes.insert(table.notes.end(), ours.left_out.begin(), ours.left_out.end());
  add_notes(table, study, std::span(&metric, 1));
  if (!is_judged) table.notes.push_back(timing_note(study) + " So our F and p are left out.");
  return table;
}

Table status_table(const StudyResults& study) {
  Table table{.name = "status",
              .caption = "Outcome of every solve, checked by the independent verifier",
              .columns = {{"algorithm", Align::left}}};
  for (const std::string_view name : status_names) table.columns.push_back({std::string(name)});
  for (const char* name :
       {"solves", "expected", "complete_runs", "incomplete_runs", "outside_limits", "worst_outside_deg"}) {
    table.columns.push_back({name});
  }
  for (const std::string_view name : timing_names) {
    table.columns.push_back({"timing_" + std::string(name)});
    if (name == name_of(Timing::clean)) table.columns.push_back({"timing_disturbed"});
  }
  const bool disturbed = times_were_disturbed(study);
  for (const SolverCounts& solver : counts(study)) {
    std::vector<Cell> row{solver.solver};
    for (const int number : solver.by_status) row.push_back(count(number));
    for (const std::int64_t number : std::initializer_list<std::int64_t>{
             solver.solves, solver.expected, solver.complete_runs, solver.incomplete_runs, solver.outside_limits}) {
      row.push_back(count(number));
    }
    row.emplace_back(solver.worst_outside_deg);
    const int alone = solver.of(Timing::clean);
    for (const int number :
         {disturbed ? 0 : alone, disturbed ? alone : 0, solver.of(Timing::parallel), solver.of(Timing::debug_build)}) {
      row.push_back(count(number));
    }
    table.rows.push_back(std::move(row));
  }
  table.notes = status_notes(study);
  table.notes.emplace_back(
      "A solve has the first status that applies: not_finite, claimed_but_wrong, refused, limit_violated, "
      "tolerance_missed, ok. So ok means finite, as claimed, inside the joint limits and within the tolerance, if the "
      "study has one. outside_limits counts all answers with a joint outside its limits, whatever their status; "
      "worst_outside_deg is the largest such violation. timing_disturbed: solved one by one, but while other programs "
      "were running.");
  add_timing_notes(table, study);
  return table;
}

}  // namespace ikbench::report
