#include "analysis/slim2023/paper_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include "analysis/inference/judge.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/slim2023/circle.hpp"
#include "analysis/slim2023/published_numbers.hpp"
#include "analysis/slim2023/time_assessment.hpp"
#include "results/published.hpp"

namespace ikbench::slim2023 {

using namespace results;
using namespace statistics;
using namespace inference;
using namespace report;

namespace {

std::string_view unit_note(Unit unit) {
  return unit == Unit::run ? "One observation is one run's mean over its points."
                           : "One observation is one point. Points of one run depend on each other, so p-values and "
                             "standard deviations claim more than the data say; verdicts go by the ratio alone.";
}

void add_notes(Table& table, const StudyResults& study, Unit unit) {
  table.notes.emplace_back(unit_note(unit));
  for (std::string& note : status_notes(study)) table.notes.push_back(std::move(note));
}

Cell text(std::string_view words) { return std::string(words); }
Cell count(std::int64_t number) { return number; }

Agreement by_ratio(double ratio) {
  if (!std::isfinite(ratio)) return Agreement::none;
  return ratio >= 0.5 && ratio <= 2 ? Agreement::close : Agreement::differs;
}

double mean_of(const std::vector<Comparison>& rows, std::string_view solver, Metric metric) {
  for (const Comparison& row : rows) {
    if (row.solver == solver && row.metric == metric) return row.ours.mean;
  }
  return not_defined;
}

void hold_against_printed(Comparison& row, const PrintedRow& printed, const AnalysisPlan& plan) {
  row.paper_mean = printed.summary.mean;
  row.ratio = row.ours.mean / row.paper_mean;
  row.agreement = by_ratio(row.ratio);
  if (plan.unit == Unit::point) return;
  const Judgement found =
      judge({.first = {.mean = row.ours.mean, .std = row.ours.std, .n = row.ours.n}, .second = printed.summary}, plan);
  const bool differs = found.answer == Answer::better || found.answer == Answer::worse;
  if (std::isfinite(found.p) && !differs) row.agreement = Agreement::agrees;
}

// The printed times are of another machine and language: only their ratio to IK-BA's can be compared.
void hold_against_printed_time(Comparison& row, double our_reference, const StudyResults& study) {
  const auto printed = printed_row(study, row.solver, Metric::seconds);
  const auto printed_reference = printed_row(study, time_reference, Metric::seconds);
  if (!printed || !printed_reference) return;
  row.paper_mean = printed->summary.mean;
  row.ratio = (row.ours.mean / our_reference) / (row.paper_mean / printed_reference->summary.mean);
  row.agreement = by_ratio(row.ratio);
}

Comparison without_agreement(Comparison row) {
  row.ratio = not_defined;
  row.agreement = Agreement::not_comparable;
  return row;
}

Cell verdict(const Comparison& row) {
  if (!std::isfinite(row.paper_mean)) return {};
  if (row.metric != Metric::seconds) {
    if (row.agreement == Agreement::none) return text("not defined");
    return rests_on_spread(row) ? "agrees, for its spread only" : text(name_of(row.agreement));
  }
  if (row.agreement == Agreement::not_comparable) return text(name_of(row.agreement));
  if (row.agreement == Agreement::none) return fmt::format("no time of {} to relate to", time_reference);
  if (row.solver == time_reference) return text("relative only: the reference");
  return fmt::format("relative only: {}", name_of(row.agreement));
}

// The three rows of an ANOVA as cells SS, df, MS, F, p.
std::array<std::vector<Cell>, 3> anova_cells(const AnovaTable& table) {
  return {{{table.ss_between, count(table.df_between), table.ms_between, table.F, PValue{table.p}},
           {table.ss_within, count(table.df_within), table.ms_within, {}, {}},
           {table.ss_total, count(table.df_total()), {}, {}, {}}}};
}

constexpr std::array<std::string_view, 3> sources{"between", "within", "total"};

void add_anova_rows(Table& table, const AnovaTable& ours, const std::optional<AnovaTable>& printed,
                    const std::vector<Cell>& before = {}) {
  const auto our_cells = anova_cells(ours);
  for (std::size_t i = 0; i < sources.size(); ++i) {
    std::vector<Cell> row = before;
    row.push_back(text(sources[i]));
    row.insert(row.end(), our_cells[i].begin(), our_cells[i].end());
    const std::vector<Cell> beside = printed ? anova_cells(*printed)[i] : std::vector<Cell>(our_cells[i].size());
    row.insert(row.end(), beside.begin(), beside.end());
    table.rows.push_back(std::move(row));
  }
}

// Our F and p; the printed ones stay.
void leave_out_test(Table& table) {
  for (const char* name : {"F", "p"}) {
    const auto column = std::ranges::find(table.columns, name, &Column::name) - table.columns.begin();
    for (auto& row : table.rows) row[static_cast<std::size_t>(column)] = {};
  }
}

std::vector<Column> anova_columns() {
  return {{"source", Align::left},
          {"SS"},
          {"df"},
          {"MS"},
          {"F"},
          {"p"},
          {"paper_SS"},
          {"paper_df"},
          {"paper_MS"},
          {"paper_F"},
          {"paper_p"}};
}

}  // namespace

std::string_view name_of(Agreement agreement) {
  constexpr std::array<std::string_view, 5> names{"", "agrees", "close", "differs", times_not_judged};
  return names[static_cast<std::size_t>(agreement)];
}

bool rests_on_spread(const Comparison& row) {
  return row.agreement == Agreement::agrees && by_ratio(row.ratio) == Agreement::differs;
}

std::vector<Comparison> compare(const StudyResults& study, Unit unit) {
  std::vector<Comparison> rows;
  for (const Metric metric : paper_metrics) {
    for (const Sample& sample : samples(study, metric, unit)) {
      rows.push_back({.solver = sample.solver, .metric = metric, .ours = describe(sample.values)});
    }
  }
  if (study.published.empty()) return rows;
  const double our_reference = mean_of(rows, time_reference, Metric::seconds);
  const bool has_comparable_times = times_are_comparable(study);
  AnalysisPlan plan = study.plan;
  plan.unit = unit;
  for (Comparison& row : rows) {
    if (row.metric == Metric::seconds) {
      hold_against_printed_time(row, our_reference, study);
      if (!has_comparable_times) row = without_agreement(row);
    } else if (const auto printed = printed_row(study, row.solver, row.metric)) {
      hold_against_printed(row, *printed, plan);
    }
  }
  return rows;
}

StudyAnova anova(const StudyResults& study, Metric metric, Unit unit) {
  StudyAnova result;
  std::vector<std::vector<double>> groups;
  for (Sample& sample : samples(study, metric, unit)) {
    const Description description = describe(sample.values);
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

std::optional<AnovaTable> comparable_printed_anova(const StudyResults& study, Metric metric, Unit unit) {
  std::set<std::string> ours(study.solvers.begin(), study.solvers.end()), printed;
  for (const PrintedRow& row : printed_table_3(study, metric)) printed.insert(row.algorithm);
  return unit == Unit::run && ours == printed ? printed_anova(study.published, metric) : std::nullopt;
}

Table table_3(const StudyResults& study, Unit unit) {
  Table table{.name = "table-3",
              .caption = "Table 3: position error, angles variation and computing time",
              .columns = {{"algorithm", Align::left},
                          {"metric", Align::left},
                          {"mean"},
                          {"median"},
                          {"std"},
                          {"max"},
                          {"min"},
                          {"paper_mean"},
                          {"ratio"},
                          {"verdict", Align::left}}};
  for (const Comparison& row : compare(study, unit)) {
    const bool printed = std::isfinite(row.paper_mean);
    table.rows.push_back({row.solver, text(name_of(row.metric)), row.ours.mean, row.ours.median, row.ours.std,
                          row.ours.max, row.ours.min, printed ? Cell(row.paper_mean) : Cell(),
                          printed ? Cell(row.ratio) : Cell(), verdict(row)});
  }
  add_notes(table, study, unit);
  if (!printed_table_3(study, Metric::position_error_cm).empty()) {
    table.notes.push_back(fmt::format(
        "Verdict: agrees, {} of our mean against the printed one has p >= {} (for its spread only: their "
        "ratio is nevertheless not within 0.5 to 2); close, their ratio is within 0.5 to 2; differs otherwise. "
        "Computing time is compared relative to {} only: (t / t_{}) ours by (t / t_{}) "
        "printed.",
        study.plan.test == DecidingTest::anova ? "Student's test" : "Welch's test",
        rounded_number(study.plan.significance, 3), time_reference, time_reference, time_reference));
  }
  if (std::string note = timing_note(study); !note.empty()) table.notes.push_back(std::move(note));
  return table;
}

Table table_3_as_printed(std::string_view paper) {
  Table table{.name = "table-3-as-printed", .caption = "Table 3 as printed"};
  const CsvTable printed = published::table(paper, "table-3");
  for (const std::string& name : printed.header) {
    table.columns.push_back({name, name == "algorithm" || name == "metric" ? Align::left : Align::right});
  }
  for (const std::vector<std::string>& row : printed.rows) table.rows.emplace_back(row.begin(), row.end());
  return table;
}

Table anova_table(const StudyResults& study, Metric metric, Unit unit) {
  const int number = paper_numbers(metric).anova_table;
  Table table{.name = fmt::format("table-{}", number),
              .caption = fmt::format("Table {}: one-way ANOVA of the {}", number, quantity(metric)),
              .columns = anova_columns()};
  const StudyAnova ours = anova(study, metric, unit);
  const bool is_judged = is_comparable(study, metric);
  add_anova_rows(table, ours.table, comparable_printed_anova(study, metric, unit));
  if (!is_judged) leave_out_test(table);
  if (is_judged && !ours.table.undefined.empty())
    table.notes.push_back("F and p are not defined: " + ours.table.undefined + ".");
  table.notes.insert(table.notes.end(), ours.left_out.begin(), ours.left_out.end());
  add_notes(table, study, unit);
  if (!is_judged) table.notes.push_back(timing_note(study) + " So our F and p are left out.");
  return table;
}

Table anova_from_printed_table_3(std::string_view paper) {
  Table table{.name = "anova-from-printed-table-3",
              .caption = "Tables 4-6 recomputed from the means and standard deviations printed in Table 3",
              .columns = anova_columns()};
  table.columns.insert(table.columns.begin(), {"metric", Align::left});
  table.columns.push_back({"p_of_paper_F"});
  for (const Metric metric : paper_metrics) {
    std::vector<GroupSummary> groups;
    for (const PrintedRow& row : printed_table_3(paper, metric)) groups.push_back(row.summary);
    const std::optional<AnovaTable> printed = printed_anova(paper, metric);
    add_anova_rows(table, anova_from_summaries(groups), printed, {text(name_of(metric))});
    for (auto row = table.rows.end() - sources.size(); row != table.rows.end(); ++row)
      row->resize(table.columns.size());
    if (printed) {
      const double p = f_upper_tail(printed->F, printed->df_between, printed->df_within);
      table.rows[table.rows.size() - sources.size()].back() = PValue{p};
    }
  }
  table.notes.emplace_back(
      "No solve enters this table: it checks the printed tables against each other. Differences are those of the "
      "printed numbers' rounding. p_of_paper_F is the upper tail of the F distribution at the printed F.");
  return table;
}

Table status_table(const StudyResults& study) {
  Table table{.name = "status",
              .caption = "What became of every solve, by the independent verifier",
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
      "A solve counts under the first status that applies: not_finite, claimed_but_wrong, refused, "
      "limit_violated, tolerance_missed, ok. So ok means: finite, as claimed, inside the joint limits, and within the "
      "tolerance where the study has one. outside_limits counts every answer with a joint outside its limits, whatever "
      "its status; worst_outside_deg is how far the worst of them is. timing_disturbed: run one by one, while other "
      "programs were at work on the machine.");
  if (std::string note = timing_note(study); !note.empty()) table.notes.push_back(std::move(note));
  return table;
}

std::vector<Table> paper_tables(const StudyResults& study, Unit unit) {
  const bool is_published = !printed_table_3(study, Metric::position_error_cm).empty();
  std::vector<Table> tables{table_3(study, unit)};
  if (is_published) tables.push_back(table_3_as_printed(study.published));
  for (const Metric metric : paper_metrics) tables.push_back(anova_table(study, metric, unit));
  if (is_published) tables.push_back(anova_from_printed_table_3(study.published));
  if (std::optional<Table> table = table_7(study)) tables.push_back(std::move(*table));
  if (std::optional<Table> table = table_8(study)) tables.push_back(std::move(*table));
  tables.push_back(status_table(study));
  return tables;
}

}  // namespace ikbench::slim2023
