#include "analysis/slim2023/paper_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/claims/rules.hpp"
#include "analysis/inference/comparable.hpp"
#include "analysis/inference/study_facts.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/inference/times.hpp"
#include "analysis/report/study_tables.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "numerics/number.hpp"
#include "numerics/units.hpp"

namespace ikbench::slim2023 {

using namespace numerics;
using namespace claims;
using namespace results;
using namespace statistics;
using namespace inference;
using namespace report;

namespace {

constexpr double real_time_ms = 50;
constexpr double few_decide = 10;  // a mean that is so many times the median is of a few solves

Table anova_beside_printed(const StudyResults& study, const PaperMetric& paper) {
  Table table = anova_table(study, paper.metric);
  table.name = fmt::format("table-{}", paper.anova_table);
  table.number = paper.anova_table;
  table.caption = fmt::format("one-way ANOVA of the {}", quantity(paper.metric));
  for (const char* name : {"SS", "df", "MS", "F", "p"}) table.columns.push_back(fmt::format("{} printed", name));
  const auto printed = comparable_anova(study, printed_table_3(study, paper.metric), table.name);
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    if (printed) std::ranges::copy(anova_cells(*printed)[i], std::back_inserter(table.rows[i]));
    table.rows[i].resize(table.columns.size());
  }
  return table;
}

}  // namespace

std::vector<PrintedRow> printed_table_3(const StudyResults& study, Metric metric) {
  const std::string& path = study.facts.path;
  return path == "circle" || path == "random" ? std::vector<PrintedRow>()
                                              : printed_rows(study.facts.published, "table-3", metric);
}

std::optional<PrintedRow> printed_row(const StudyResults& study, std::string_view solver, Metric metric) {
  const std::vector<PrintedRow> rows = printed_table_3(study, metric);
  const auto row = std::ranges::find(rows, solver, &PrintedRow::algorithm);
  return row == rows.end() ? std::nullopt : std::optional(*row);
}

Table table_3(const StudyResults& study) {
  std::array<Metric, paper_metrics.size()> metrics;
  std::ranges::transform(paper_metrics, metrics.begin(), &PaperMetric::metric);
  Table table = results_table(study, metrics);
  table.name = "table-3";
  table.number = 3;
  table.caption = "position error, angles variation and computing time";
  for (std::vector<Cell>& cells : table.rows) {
    const std::string solver = std::get<std::string>(cells[0]);
    const Metric metric =
        *std::ranges::find(metrics, std::get<Id>(cells[1]).id, [](Metric each) { return std::string(name_of(each)); });
    const std::optional<PrintedRow> printed = printed_row(study, solver, metric);
    for (std::size_t s = 0; printed && s < printed_statistics.size(); ++s) {
      cells[2 + s] = OursAndPrinted{std::get<double>(cells[2 + s]), printed->digits[s]};
    }
  }
  if (printed_table_3(study, Metric::seconds).empty()) return table;
  table.notes.emplace_back("The printed times are of another machine and language: only their ratios can be compared.");
  return table;
}

std::optional<Table> table_7(const StudyResults& study) {
  const std::vector<PrintedRow> printed = printed_times(study.facts.published, "table-7", "{bats} bats");
  if (study.facts.path != "random" || printed.empty()) return std::nullopt;
  const double tolerance = tolerance_cm(study);
  const bool is_judged = std::isfinite(tolerance);
  Table table{.name = "table-7",
              .caption = is_judged ? fmt::format("computing time [ms] until the position error is {} cm", tolerance)
                                   : "computing time [ms]",
              .columns = {"configuration", "solves", "never_reached", "share_in_time"},
              .notes = {fmt::format(
                  "One observation is one solve. {} They include solves that do not reach the tolerance, because "
                  "an arm waits for them too; share in time counts solves that reach it in less than {} ms.",
                  median_speed_words, real_time_ms)},
              .number = 7};
  for (const auto& [name, field] : printed_statistics) table.columns.push_back(fmt::format("{}_ms", name));
  table.columns.insert(table.columns.end(), {"iterations_median", "evaluations_median"});
  for (const TimeAssessment& of : assess_times(study, real_time_ms)) {
    std::vector<Cell>& row = table.rows.emplace_back(std::vector<Cell>{of.solver, std::int64_t{of.solves}});
    row.push_back(is_judged ? Cell(std::int64_t{of.never_reached}) : Cell());
    row.emplace_back(is_judged && of.solves > 0 ? static_cast<double>(of.in_time) / of.solves : not_defined);
    const auto same = std::ranges::find(printed, of.solver, &PrintedRow::algorithm);
    for (std::size_t i = 0; i < printed_statistics.size(); ++i) {
      const double ours = of.time_ms.*printed_statistics[i].second;
      row.push_back(same == printed.end() ? Cell(ours) : OursAndPrinted{ours, same->digits[i]});
    }
    row.insert(row.end(), {of.iterations_median, of.evaluations_median});
  }
  std::ranges::move(list_of(times_doubts(study) + outlier_doubts(study)), std::back_inserter(table.notes));
  std::ranges::move(status_notes(study), std::back_inserter(table.notes));
  return table;
}

std::optional<Table> table_8(const StudyResults& study) {
  const CsvTable printed = printed_table(study.facts.published, "table-8");
  if (study.facts.path != "circle" || printed.rows.empty()) return std::nullopt;
  constexpr std::array<std::size_t, 4> joints{0, 1, 2, 0};  // theta4 is theta1
  Table table{.name = "table-8",
              .caption = "joint angles and position error along the circle",
              .columns = printed.header,
              .legend = "Coloured: an angle rounds to the printed digits, or does not.",
              .number = 8};
  std::size_t agreeing = 0;
  for (const SolveRecord& solve : study.solve_data->drawn) {
    if (solve.solver != study.solvers.front()) continue;
    std::vector<Cell>& row = table.rows.emplace_back(std::vector<Cell>{std::int64_t{solve.point}});
    const auto same =
        std::ranges::find(printed.rows, fmt::to_string(solve.point), [](const auto& of) { return of.front(); });
    const auto add = [&](double ours, Nearness nearness) {
      row.push_back(same == printed.rows.end() ? Cell(ours) : OursAndPrinted{ours, (*same)[row.size()], nearness});
    };
    const std::vector<double>& answer = solve.answer_rad;
    for (const std::size_t joint : joints) {
      const double angle = joint < answer.size() ? answer[joint] / degree : not_defined;
      const bool does_agree = same != printed.rows.end() && agrees(angle, (*same)[row.size()]);
      add(angle, does_agree ? Nearness::within : Nearness::far);
      agreeing += does_agree ? 1 : 0;
    }
    add(solve.position_error_cm, Nearness::unknown);
  }
  table.notes = {
      fmt::format(
          "{} of the {} printed angles agree with ours to the printed digit. theta4 turns the tool about the vertical; "
          "in print it equals theta1, and ours is set so.",
          agreeing, joints.size() * printed.rows.size()),
      "The paper does not print the four lengths of the arm, so we fitted them to the angles of this table. Agreement "
      "therefore tests the closed form and the solver, but not the geometry."};
  std::ranges::move(status_notes(study), std::back_inserter(table.notes));
  return table;
}

Table means_by_reading(const Readings& readings) {
  Table table{
      .name = "table-3-readings",
      .caption =
          "Means by both readings of what is searched: the joints before the wrist (Sec. 4.3), or all seven "
          "with every solver clamped (Sec. 5.1)",
      .columns = {"algorithm", "printed_error_cm", "wrist_error_cm", "all_joints_error_cm", "printed_variation_deg",
                  "wrist_variation_deg", "all_joints_variation_deg"},
      .notes = {"The paper says both, so neither is the reading. The default is argued from Sec. 4.3; which one "
                "fits better did not decide."}};
  for (const std::string& solver : readings.wrist.solvers) {
    std::vector<Cell>& row = table.rows.emplace_back(std::vector<Cell>{solver});
    for (const Metric metric : {Metric::position_error_cm, Metric::variation_deg}) {
      const std::optional<PrintedRow> printed = printed_row(readings.wrist, solver, metric);
      row.push_back(printed ? Cell(printed->digits.front()) : Cell());
      for (const JudgedStudy* study : {&readings.wrist, &readings.all_joints}) {
        const std::vector<Sample> all = samples(*study, metric);
        const auto own = std::ranges::find(all, solver, &Sample::solver);
        const Description found = own == all.end() ? Description() : describe(own->values);
        row.push_back(or_nothing(found.mean));
        if (!(found.mean > few_decide * found.median)) continue;
        table.notes.push_back(
            fmt::format("A few solves decide the {} of {} by {}: the median of its run means is {} {}.",
                        info_of(metric).name, solver, study == &readings.wrist ? "the wrist" : "all joints",
                        short_number(found.median), info_of(metric).unit));
      }
    }
  }
  return table;
}

Table claims_by_reading(const Readings& readings, const decltype(Paper::claims)& claims_of) {
  Table table{.name = "claims-readings",
              .caption = "The claims by both readings of what is searched, without times",
              .columns = {"claim", "printed", "wrist", "wrist_number", "all_joints", "all_joints_number", "id"},
              .notes = {"Only claims that need no other study. By the default in everything else."}};
  const std::vector<Claim> all = claims_of({.study = readings.all_joints, .has_times = false});
  for (const Claim& claim : claims_of({.study = readings.wrist, .has_times = false})) {
    const auto other = std::ranges::find(all, claim.id, &Claim::id);
    if (claim.verdict == Verdict::untested || other == all.end()) continue;
    table.rows.push_back({claim.statement, claim.printed ? Cell(std::string(name_of(*claim.printed))) : Cell(),
                          std::string(name_of(claim.verdict)), claim.number, std::string(name_of(other->verdict)),
                          other->number, claim.id});
  }
  return table;
}

std::vector<Table> paper_tables(const StudyResults& study) {
  std::vector<Table> tables{table_3(study)};
  for (const PaperMetric& metric : paper_metrics) tables.push_back(anova_beside_printed(study, metric));
  for (std::optional<Table>& table : std::array{table_7(study), table_8(study)}) {
    if (table) tables.push_back(std::move(*table));
  }
  return tables;
}

}  // namespace ikbench::slim2023
