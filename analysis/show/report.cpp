#include "analysis/show/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "analysis/judge/statistics/closed_tests.hpp"
#include "analysis/judge/statistics/omnibus.hpp"
#include "analysis/show/hard_targets.hpp"
#include "analysis/show/headline.hpp"
#include "analysis/show/methods_paragraph.hpp"
#include "analysis/show/phrases.hpp"
#include "analysis/show/requirements.hpp"
#include "analysis/show/result_tables.hpp"
#include "analysis/show/results_paragraph.hpp"
#include "analysis/show/text.hpp"
#include "base/json.hpp"

namespace ikbench::show {

using namespace judge;

namespace {

// Returns the table of single solves: how many failed, and quantiles of their times up to rare ones. The table has the
// solves themselves, even if the samples are means of runs or targets.
Table solves_table(const Report& report) {
  const StudyResults& study = report.study;
  const std::string calls = judge::timed_calls_text(study);
  Table table{.name = "solves",
              .caption = calls.empty() ? "Single solves" : fmt::format("Single solves: {}", calls),
              .columns = named_columns({"solver", "solves", "failed"})};
  for (const char* of_times : {"median", "95 %", "99 %", "largest"}) table.columns.push_back({of_times, "ms"});
  for (const std::string& solver : report.model.solvers()) {
    const Solves all = study.of(solver);
    if (all.size() < 2 || study.imported.has(solver)) continue;
    const auto failed = std::ranges::count_if(all, [&](const SolveSummary& solve) { return has_failed(study, solve); });
    std::vector<double> times = solve_times(study, solver);
    for (double& time : times) time *= 1000;
    std::ranges::sort(times);
    auto& row = table.rows.emplace_back(std::vector<Cell>{solver, std::ssize(all), std::int64_t{failed}});
    row.push_back(times.empty() ? Cell() : Cell(quantile(times, 0.5)));
    for (const double share : {0.95, 0.99}) {
      const auto interval = judge::quantile_interval(times, share);
      if (interval && study.definition.is_grid())
        row.emplace_back(quantile(times, share));
      else
        row.push_back(interval ? Cell(ValueCell{.value = quantile(times, share), .interval = interval}) : Cell());
    }
    row.push_back(times.empty() ? Cell() : Cell(times.back()));
  }
  table.notes = {"Time of each solve that gave an answer, solved or not."};
  if (!study.definition.is_grid())
    table.notes.front() +=
        " Brackets: 95 % intervals, which need 72 solves for the 95 % quantile and 368 for the 99 % quantile.";
  return table;
}

// Returns the medians of the numbers that solvers report under names of their own.
Table extras_table(const Report& report) {
  const StudyResults& study = report.study;
  Table table{.name = "extras", .caption = "Solvers' own numbers (medians)", .columns = named_columns({"solver"})};
  for (const auto& [name, by_solver] : study.extras) table.columns.push_back({name});
  for (const std::string& solver : report.model.solvers()) {
    std::vector<Cell> row{solver};
    for (const auto& [name, by_solver] : study.extras) {
      const auto values = by_solver.find(solver);
      row.push_back(values == by_solver.end() ? Cell() : Cell(describe_values(values->second).median));
    }
    if (std::ranges::any_of(row, [](const Cell& cell) { return std::holds_alternative<double>(cell); }))
      table.rows.push_back(std::move(row));
  }
  return table;
}

Table options_table(const StudyResults& study) {
  Table table{.caption = "Options", .columns = {{"label"}, {"solver"}, {"options"}}, .visible_rows = 0};
  for (const results::Series& series : study.series) {
    std::vector<std::string> options;
    const auto json = base::parsed_ordered_json(series.options);
    for (auto option = json.begin(); json.is_object() && option != json.end(); ++option)
      options.push_back(fmt::format("{} = {}", option.key(),
                                    option->is_string() ? option->get<std::string>() : base::text_of(*option)));
    table.rows.push_back({series.label, with_spaces(series.algorithm), fmt::format("{}", fmt::join(options, ", "))});
  }
  return table;
}

}  // namespace

Report make_report(JudgedStudy judged, std::vector<figures::Figure> figures) {
  Report report{.model = make_report_model(judged), .figures = std::move(figures)};
  report.study = std::move(judged.study);
  return report;
}

std::vector<Table> setup_tables(const Report& report) {
  const StudyResults& study = report.study;
  const JudgedMetric& decisive = report.model.primary();
  const results::StudyDefinition& definition = study.definition;
  const std::vector<Column> columns{{"what"}, {"value"}};
  Table of_study{.caption = "Study", .columns = columns}, machine{.caption = "Machine", .columns = columns};
  const auto add = [](Table& table, std::string what, std::string value) {
    if (!value.empty()) table.rows.push_back({std::move(what), std::move(value)});
  };
  const auto listed_of = [](const std::set<std::string>& all) { return listed({all.begin(), all.end()}); };
  if (!study.series.empty()) {
    add(of_study, "study", definition.title.empty() ? study.name : fmt::format("{}: {}", study.name, definition.title));
    add(of_study, "arm",
        definition.tip_link.empty()
            ? definition.robot
            : fmt::format("{}, from link {} to {}", definition.robot, definition.base_link, definition.tip_link));
    for (const std::string& note : definition.arm_notes) add(of_study, "arm as read", note);
    add(of_study, "targets",
        fmt::format("{} per run, {}{}", definition.points, with_spaces(definition.path),
                    definition.draws_targets ? ", redrawn for each run" : ""));
    add(of_study, "search", with_spaces(name_of(definition.search)));
    add(of_study, "start", definition.is_chained() ? "the previous answer" : with_spaces(name_of(definition.start)));
    add(of_study, "timed calls", judge::timed_calls_text(study));
    add(of_study, "candidates outside limits", with_spaces(name_of(definition.bounds)));
    add(of_study, "answers outside limits", std::string(name_of(definition.limits)));
    add(of_study, "a solve stops", budget_text(study));
    add(of_study, "answers checked by", fmt::format("{}", fmt::join(definition.check.process, " ")));
    add(of_study, "runs", fmt::to_string(definition.runs));
    add(of_study, "seed", fmt::to_string(definition.seed));
    for (const std::string& departure : definition.departures)
      add(of_study, "differs from the published study", departure);
  }
  std::set<std::string> tests;
  for (const JudgedMetric& judged : report.model.metrics) {
    for (const Comparison& comparison : judged.comparisons)
      if (const auto* const tested = std::get_if<TestResult>(&comparison.result))
        tests.insert(std::string(tested->test));
  }
  add(of_study, "tests of pairs", listed_of(tests));
  const std::size_t metrics = report.model.named_metrics;
  if (!tests.empty())
    add(of_study, "significance",
        fmt::format("{} for all pairs{} ({}); equivalence margin {}", number_text(decisive.plan.significance),
                    metrics == 1 ? "" : fmt::format(" of the {} metrics that the plan names", metrics),
                    tests.contains(std::string(closed_tests_name)) ? "closed tests of few blocks, otherwise Bonferroni"
                                                                   : "Bonferroni",
                    margin_text(decisive)));
  for (const char* fact : {"cpu", "os", "compiler", "build_type", "version", "commit", "jobs", "date"})
    add(machine, with_spaces(fact), listed_of(environment_values(study, fact)));
  return {std::move(of_study), std::move(machine)};
}

namespace {

// Returns the set-up as tables and as a paragraph.
Blocks setup_blocks(const Report& report) {
  const std::vector<Table> tables = setup_tables(report);
  return {tables[0], options_table(report.study), tables[1],
          fmt::format("{} {}", fmt::join(methods_sentences(report), " "), methods_bracket(report, "")),
          "With references: article/methods.tex."};
}

}  // namespace

std::vector<Blocks> report_sections(const Report& report) {
  std::vector<Blocks> sections{report.lead};
  const bool is_of_study = !report.study.series.empty();  // otherwise of a user's file
  Blocks targets{report.model.targets};
  const auto add_hard_targets = [&](Blocks& blocks) {
    const auto& hard = report.model.hard_targets;
    if (hard) blocks.insert(blocks.end(), hard_targets_sentence(*hard));
  };
  if (!report.lead.empty()) add_hard_targets(targets);
  std::vector<std::string> warnings;
  for (const Warning& warning : report.model.all_warnings()) warnings.push_back(warning_sentence(warning));
  if (report.lead.empty()) {
    for (const Warning& warning : report.model.warnings)  // above the verdict, which these make void
      if (warning.kind == WarningKind::wrong_answers) sections[0].emplace_back(warning_sentence(warning));
    sections[0].emplace_back(Heading{headline(report.model)});
    add_hard_targets(sections[0]);
    for (const std::string& sentence : requirement_sentences(report.model)) sections[0].emplace_back(sentence);
    if (is_of_study) sections[0].emplace_back(report.model.study_text);
    Table results = results_table(report.model);
    if (!report.model.answers_text.empty()) results.notes.push_back(report.model.answers_text);
    results.notes.insert(results.notes.end(), warnings.begin(), warnings.end());
    warnings.clear();
    sections[0].emplace_back(std::move(results));
    sections[0].emplace_back(fmt::format("{}", fmt::join(results_sentences(report.model), " ")));
  }
  const auto add = [&](std::string heading, Blocks blocks) {
    const auto is_empty = [](const Block& block) {
      const auto* const table = std::get_if<Table>(&block);
      return table && table->rows.empty();
    };
    std::erase_if(blocks, is_empty);
    if (blocks.empty()) return;
    blocks.insert(blocks.begin(), Heading{std::move(heading)});
    sections.push_back(std::move(blocks));
  };
  if (!report.claims.empty()) sections.push_back(report.claims);
  add("Pictures", {report.figures.begin(), report.figures.end()});
  for (const auto& [heading, table] : report.model.extra_tables) add(heading, {table});
  std::ranges::copy(report.extra_sections, std::back_inserter(sections));
  add("Who is better?", {pairs_table(report.model)});
  add("Targets", std::move(targets));
  if (!report.has_own_numbers) {
    Table numbers = descriptives_table(report.model), solves = solves_table(report), all = omnibus_table(report.model);
    numbers.visible_rows = solves.visible_rows = 0;
    add("All numbers", {std::move(numbers), std::move(solves), extras_table(report)});
    const bool are_ranks = report.model.primary().plan.test == results::AnalysisPlan::Test::ranks;
    const auto is_shown = [&](const auto& row) {
      const std::string& test = std::get<std::string>(row[1]);
      const bool is_of_ranks = test == friedman_name || test == iman_davenport_name;
      return std::get<std::string>(row[0]) == report.model.primary().samples.quantity && is_of_ranks == are_ranks;
    };
    all.visible_rows = static_cast<std::size_t>(std::ranges::count_if(all.rows, is_shown));
    if (!are_ranks || all.visible_rows > 0) add("Omnibus tests", {std::move(all)});
  }
  warnings.insert(warnings.end(), report.extra_warnings.begin(), report.extra_warnings.end());
  add("Warnings", {warnings.begin(), warnings.end()});
  if (is_of_study) add("Set-up", setup_blocks(report));
  return sections;
}

}  // namespace ikbench::show
