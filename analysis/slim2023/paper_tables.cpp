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
#include "analysis/statistics/predictive_study.hpp"
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

constexpr double predictive_level = 0.95;
constexpr double near_ratio = 1.5;  // limit of ours by the printed, in both directions
constexpr double real_time_ms = 50;

Nearness nearness_of(const Agreement& agreement) {
  if (agreement.is_expected) return Nearness::within;
  return agreement.ratio < near_ratio && agreement.ratio > 1 / near_ratio ? Nearness::near : Nearness::far;
}

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

std::string words_of(const Agreement& agreement) {
  if (agreement.is_expected) return "";
  const std::string times = std::isfinite(agreement.ratio) ? rounded_number(agreement.ratio, 2) + " times, " : "";
  const double printed = number_from(agreement.printed).value_or(not_defined);
  const auto [value, low, high] = agreement.expected;
  constexpr int fewest = 3, most = 12;
  int digits = fewest;
  const auto looks_printed = [&](double end) {
    const std::string shown = rounded_number(end, digits);
    return shown == rounded_number(printed, digits) || shown == rounded_number(printed, fewest);
  };
  while (digits < most && (looks_printed(low) || looks_printed(high))) ++digits;
  return fmt::format("{}outside our range {} to {}", times, rounded_number(low, digits), rounded_number(high, digits));
}

std::vector<Agreement> agreements(const StudyResults& study, std::span<const RepeatedSolver> repetitions) {
  std::vector<Agreement> result;
  for (const auto& [metric, of_seeds] : {std::pair(Metric::position_error_cm, &RepeatedSolver::error_cm),
                                         std::pair(Metric::variation_deg, &RepeatedSolver::variation_deg)}) {
    const std::vector<Sample> all = samples(study, metric);
    for (const PrintedRow& row : printed_table_3(study, metric)) {
      const auto repeated = std::ranges::find(repetitions, row.algorithm, &RepeatedSolver::label);
      const auto sample = std::ranges::find(all, row.algorithm, &Sample::solver);
      if (repeated == repetitions.end() || sample == all.end() || sample->values.empty()) continue;
      std::vector<Description> seeds;
      for (const std::vector<double>& runs : (*repeated).*of_seeds) seeds.push_back(describe(runs));
      const Description ours = describe(sample->values);
      for (std::size_t s = 0; s < printed_statistics.size(); ++s) {
        const auto& [name, field] = printed_statistics[s];
        std::vector<double> values;
        for (const Description& seed : seeds) values.push_back(seed.*field);
        const Estimate expected = predictive_interval(values, predictive_level);
        const double printed = row.printed.*field;
        result.push_back({.solver = row.algorithm,
                          .metric = metric,
                          .statistic = name,
                          .printed = row.digits[s],
                          .ours = ours.*field,
                          .ratio = printed == 0 ? not_defined : ours.*field / printed,
                          .expected = expected,
                          .is_expected = can_be(expected.low, expected.high, row.digits[s])});
      }
    }
  }
  return result;
}

double expected_to_agree(const std::vector<Agreement>& agreements) {
  return predictive_level * static_cast<double>(agreements.size());
}

std::string agreement_sentence(const std::vector<Agreement>& agreements) {
  if (agreements.empty()) return "";
  std::string means;
  for (const Agreement& each : agreements) {
    if (each.is_expected || each.statistic != "mean") continue;
    means +=
        fmt::format("{}{} {} ({})", means.empty() ? "" : "; ", each.solver, info_of(each.metric).slug, words_of(each));
  }
  return fmt::format(
      "{} of {} printed errors and variations lie where 95 % of our repetitions do; {:.0f} would if everything were the "
      "same. Means that do not: {}.",
      std::ranges::count(agreements, true, &Agreement::is_expected), agreements.size(), expected_to_agree(agreements),
      means.empty() ? "none" : means);
}

Table table_3(const StudyResults& study, std::span<const RepeatedSolver> repetitions) {
  std::array<Metric, paper_metrics.size()> metrics;
  std::ranges::transform(paper_metrics, metrics.begin(), &PaperMetric::metric);
  Table table = results_table(study, metrics);
  table.name = "table-3";
  table.number = 3;
  table.caption = "position error, angles variation and computing time";
  const std::vector<Agreement> agreed = agreements(study, repetitions);
  for (std::vector<Cell>& cells : table.rows) {
    const std::string solver = std::get<std::string>(cells[0]);
    const Metric metric =
        *std::ranges::find(metrics, std::get<Id>(cells[1]).id, [](Metric each) { return std::string(name_of(each)); });
    const std::optional<PrintedRow> printed = printed_row(study, solver, metric);
    for (std::size_t s = 0; printed && s < printed_statistics.size(); ++s) {
      OursAndPrinted cell{.ours = std::get<double>(cells[2 + s]), .printed = printed->digits[s]};
      const auto found = std::ranges::find_if(agreed, [&](const Agreement& each) {
        return each.solver == solver && each.metric == metric && each.statistic == printed_statistics[s].first;
      });
      if (found != agreed.end()) {
        cell.nearness = nearness_of(*found);
        cell.words = words_of(*found);
      }
      cells[2 + s] = cell;
    }
  }
  if (printed_table_3(study, Metric::seconds).empty()) return table;
  if (!agreed.empty()) {
    const auto outside = std::ranges::count_if(
        agreed, [](const Agreement& of) { return of.ours < of.expected.low || of.ours > of.expected.high; });
    table.notes.push_back(agreement_sentence(agreed));
    table.notes.push_back(fmt::format(
        "The printed digits are the paper's. Our range holds that statistic in 95 % of studies like ours: it is the "
        "predictive range of one more of them, by order statistics of {} seeds. Where the printed number lies outside, "
        "there is our number divided by the printed one, and the range; near is less than {} times as much or as little. "
        "Of our own {} numbers, which are those of one seed, {} {} outside; by chance {:.0f} would.",
        repetitions.front().error_cm.size(), near_ratio, agreed.size(), outside, outside == 1 ? "lies" : "lie",
        (1 - predictive_level) * static_cast<double>(agreed.size())));
  }
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
  constexpr std::size_t angles = 3;
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
    for (std::size_t joint = 0; joint < angles; ++joint) {
      const double angle = joint < answer.size() ? answer[joint] / degree : not_defined;
      const bool does_agree = same != printed.rows.end() && agrees(angle, (*same)[1 + joint]);
      add(angle, does_agree ? Nearness::within : Nearness::far);
      agreeing += does_agree ? 1 : 0;
    }
    add(solve.position_error_cm, Nearness::unknown);
  }
  table.notes = {
      fmt::format(
          "{} of the {} printed angles agree with ours to the printed digit. The paper prints theta4 too, which "
          "turns the tool about the vertical and equals theta1.",
          agreeing, angles * printed.rows.size()),
      "The paper does not print the four lengths of the arm, so we fitted them to the angles of this table. Agreement "
      "therefore tests the closed form and the solver, but not the geometry."};
  std::ranges::move(status_notes(study), std::back_inserter(table.notes));
  return table;
}

std::vector<Table> paper_tables(const StudyResults& study, std::span<const RepeatedSolver> repetitions) {
  std::vector<Table> tables{table_3(study, repetitions)};
  for (const PaperMetric& metric : paper_metrics) tables.push_back(anova_beside_printed(study, metric));
  for (std::optional<Table>& table : std::array{table_7(study), table_8(study)}) {
    if (table) tables.push_back(std::move(*table));
  }
  return tables;
}

}  // namespace ikbench::slim2023
