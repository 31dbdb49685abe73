#include "analysis/report/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <string_view>

#include "analysis/figures/convergence_figures.hpp"
#include "analysis/figures/figure_parts.hpp"
#include "analysis/inference/analysis_plan.hpp"
#include "analysis/inference/convergence.hpp"
#include "analysis/inference/definition.hpp"
#include "analysis/inference/design.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/assessment.hpp"
#include "analysis/report/cost_tables.hpp"
#include "analysis/report/limits_table.hpp"
#include "analysis/report/moving_arm.hpp"
#include "analysis/report/provenance.hpp"
#include "analysis/report/report_content.hpp"
#include "analysis/report/summary.hpp"
#include "analysis/slim2023/paper_figures.hpp"
#include "analysis/slim2023/paper_tables.hpp"
#include "analysis/slim2023/published_numbers.hpp"
#include "results/published.hpp"

namespace ikbench::report {

using namespace slim2023;
using namespace results;
using namespace statistics;
using namespace inference;
using namespace figures;

namespace {

// Other studies of the store that were given the same targets, after the reported one.
std::vector<StudyResults> with_same_targets(const Store& store, const StudyResults& study) {
  std::vector<StudyResults> result{study};
  for (const StudyEntry& entry : store.studies()) {
    if (entry.name == study.name) continue;
    StudyResults other = make_study(entry, store.solves(entry.name));
    if (same_targets(study, other)) result.push_back(std::move(other));
  }
  return result;
}

// Those that treat joint limits as the first does: where they are not, numbers cannot be put side by side. The others
// have a table of their own.
std::vector<StudyResults> with_same_limits(const std::vector<StudyResults>& studies) {
  const auto are_enforced = [](const StudyResults& study) {
    return Definition(study.definition).text("/limits") == "enforced";
  };
  std::vector<StudyResults> result;
  std::ranges::copy_if(studies, std::back_inserter(result),
                       [&](const StudyResults& study) { return are_enforced(study) == are_enforced(studies.front()); });
  return result;
}

// The paper's other experiments, where the store has them: studies named after the reported one.
std::vector<StudyResults> companions_of(const Store& store, const StudyResults& study) {
  std::vector<StudyResults> result;
  for (const StudyEntry& entry : store.studies()) {
    for (const char* part : {"-time", "-dobot", "-limits", "-context"}) {
      if (entry.name == study.name + part) result.push_back(make_study(entry, store.solves(entry.name)));
    }
  }
  return result;
}

// What only a companion has.
void add_pieces(const StudyResults& companion, const AnalysisPlan& plan, std::vector<Table>& tables,
                std::vector<Figure>& figures) {
  const auto is_its_own = [](const std::string& name) {
    constexpr std::array<std::string_view, 7> names{"table-7",   "table-8",   "figure-14", "figure-15",
                                                    "figure-16", "figure-17", "figure-18"};
    return std::ranges::find(names, name) != names.end();
  };
  for (Table& table : paper_tables(companion, plan.unit)) {
    if (is_its_own(table.name)) tables.push_back(std::move(table));
  }
  for (Figure& figure : paper_figures(companion, plan.unit, quantile_type(plan.quartiles))) {
    if (is_its_own(figure.name)) figures.push_back(std::move(figure));
  }
}

// What the paper's tables say of themselves where points are the observations.
Table flagged(Table table, const AnalysisPlan& plan) {
  if (plan.unit == Unit::point) table.notes.push_back(capitalised(points_flaw) + '.');
  return table;
}

// "computing time, as printed [s]"
std::string as_printed(std::string_view quantity) {
  const std::size_t unit = std::min(quantity.find(" ["), quantity.size());
  return fmt::format("{}, as printed{}", quantity.substr(0, unit), quantity.substr(unit));
}

// What the paper printed, by the same methods.
std::vector<Assessment> printed_assessments(const StudyResults& study, const AnalysisPlan& plan) {
  std::vector<Assessment> result;
  for (const Metric metric : paper_metrics) {
    Summaries printed{.name = fmt::format("printed-{}", info_of(metric).slug),
                      .quantity = as_printed(quantity(metric))};
    for (const PrintedRow& row : printed_table_3(study, metric)) printed.groups.push_back({row.algorithm, row.summary});
    if (printed.groups.size() < 2) continue;
    result.push_back(assess(printed, feasible(plan, printed)));
  }
  return result;
}

std::vector<Assessment> assessments_of(const StudyResults& study, const AnalysisPlan& plan) {
  if (study.solves.empty()) return {};
  std::vector<Assessment> result;
  for (const Metric metric : reported_metrics()) {
    Observations observed = observations(study, metric, plan.unit);
    const AnalysisPlan possible = feasible(plan, observed);
    if (is_comparable(study, metric)) {
      result.push_back(assess(observed, possible));
      continue;
    }
    observed.flaw = timing_note(study);
    result.push_back(describe(observed, possible));
  }
  std::ranges::move(printed_assessments(study, plan), std::back_inserter(result));
  return result;
}

// As the program found it before it solved the study.
std::string out_of_reach_warning(const StudyResults& study) {
  const Definition definition(study.definition);
  const auto of = [&](const char* name) { return definition.number(fmt::format("/out_of_reach/{}", name)); };
  const double points = of("points"), all = of("farthest_point") + of("farthest_cm") + of("reach_cm");
  const bool is_count = points >= 1 && points <= study.points && points == std::floor(points);
  if (!is_count || !std::isfinite(all)) return "";  // nothing, or somebody's own
  const bool is_one = points == 1;
  return fmt::format(
      "{} of the {} targets of a run {} out of the arm's reach ({}point {}: {} {} cm from the shoulder; the reach "
      "is {} cm). No solver can reach {}, so errors there say nothing about the solvers.",
      points, study.points, is_one ? "is" : "are", is_one ? "" : "the farthest is ", of("farthest_point"),
      definition.text("/search") == "wrist" ? "the wrist's centre would be" : "it is",
      rounded_number(of("farthest_cm"), 4), rounded_number(of("reach_cm"), 4), is_one ? "it" : "them");
}

std::vector<std::string> warnings_of(const StudyResults& study, const std::vector<StudyResults>& companions) {
  std::vector<std::string> warnings;
  if (std::string warning = out_of_reach_warning(study); !warning.empty()) warnings.push_back(std::move(warning));
  const auto papers = published::papers();
  if (!study.published.empty() && std::ranges::find(papers, study.published) == papers.end()) {
    warnings.push_back(fmt::format("no published tables of '{}' to compare with; there are: {}", study.published,
                                   fmt::join(papers, ", ")));
  }
  for (const SolverCounts& count : counts(study)) {
    if (count.solves >= count.expected) continue;
    warnings.push_back(
        fmt::format("{}: {} of {} solves are there", one_line(count.solver), count.solves, count.expected));
  }
  if (std::string note = timing_note(study); !note.empty()) warnings.push_back(std::move(note));
  for (const StudyResults& companion : companions) {
    for (const std::string& warning : {out_of_reach_warning(companion), timing_note(companion)}) {
      if (!warning.empty()) warnings.push_back(fmt::format("{}: {}", companion.name, warning));
    }
  }
  return warnings;
}

}  // namespace

Report write_report(const Store& store, const ReportRequest& request) {
  const StudyEntry entry = store.study(request.study);
  StudyResults study = make_study(entry, store.solves(request.study));
  study.plan = request.plan.value_or(plan_of(entry));
  const std::vector<Session> sessions = store.sessions();
  const std::vector<StudyResults> together = with_same_targets(store, study);
  const std::vector<StudyResults> companions = companions_of(store, study);
  const AnalysisPlan plan = study.plan;

  std::vector<Table> tables{definition_table(entry), options_table(entry),
                            plan_table(entry, plan, plan_notes(entry, sessions, study.solves)),
                            environment_table(study, sessions)};
  std::vector<Figure> figures = paper_figures(study, plan.unit, quantile_type(plan.quartiles));
  std::ranges::move(paper_tables(study, plan.unit), std::back_inserter(tables));
  const std::vector<StudyResults> beside = with_same_limits(together);
  if (beside.size() > 1) tables.push_back(flagged(perspective_table(beside, plan.unit), plan));
  if (std::optional<Table> table = limits_table(together, plan.unit))
    tables.push_back(flagged(std::move(*table), plan));
  for (const StudyResults& companion : companions) add_pieces(companion, plan, tables, figures);
  std::ranges::copy(request.extra_tables, std::back_inserter(tables));
  std::ranges::copy(request.extra_figures, std::back_inserter(figures));

  ReportContent content{.study = study.name,
                        .title = study.title.empty() ? study.name : study.title,
                        .findings = findings(study, companions, plan.unit),
                        .summary = summary(study, plan.unit),
                        .warnings = warnings_of(study, companions),
                        .command = command_of(study, sessions)};
  std::ranges::copy(plan_changes(entry, sessions, study.solves), std::back_inserter(content.warnings));
  if (plan.test == DecidingTest::friedman && !blocked_observations(study, Metric::position_error_cm)) {
    content.warnings.push_back(
        fmt::format("Friedman's test was planned and cannot be made; Welch's ANOVA with Games and "
                    "Howell's test decides instead. {}",
                    why_not_blocked(study)));
  }
  if (plan.unit == Unit::point) content.warnings.insert(content.warnings.begin(), capitalised(points_flaw) + '.');
  for (std::size_t i = 1; i < beside.size(); ++i) content.summary.push_back(perspective(beside[i], plan.unit));
  std::ranges::move(cost_tables(study), std::back_inserter(tables));
  std::ranges::move(convergence_figures(study), std::back_inserter(figures));
  if (std::string closest = closest_point_by_point(study); !closest.empty()) {
    content.summary.push_back(std::move(closest));
  }
  std::vector<Assessment> assessments = assessments_of(study, plan);
  for (const Assessment& assessment : assessments) {
    if (!assessment.warnings.empty()) continue;  // of flawed observations there is no headline
    std::ranges::copy(assessment.headlines, std::back_inserter(content.summary));
  }
  const Table results = *std::ranges::find(tables, "table-3", &Table::name);
  Report report = publish({.content = std::move(content),
                           .tables = std::move(tables),
                           .figures = std::move(figures),
                           .assessments = std::move(assessments),
                           .motion = moving_arm(entry, study)},
                          request.folder, request.figures);
  report.results = results;
  return report;
}

}  // namespace ikbench::report
