#include "analysis/show/report.hpp"

#include <algorithm>
#include <iterator>

#include "analysis/show/words.hpp"

namespace ikbench::show {

using namespace judge;

Report report_of(JudgedStudy judged, std::vector<figures::Figure> figures) {
  Report report{.answer = answer_of(judged), .figures = std::move(figures)};
  report.study = std::move(judged.study);
  return report;
}

std::vector<Blocks> sections_of(const Report& report) {
  std::vector<Blocks> sections{report.first};
  const bool is_of_study = !report.study.series.empty();  // else of a user's file
  if (report.first.empty()) {
    sections[0] = {Heading{headline(report.answer)}};
    if (is_of_study) sections[0].emplace_back(report.answer.studied);
    Table results = warned_results(report.answer);
    results.in_article = {warned_results(with_short_names(report.answer, 2 * longest_name))};  // a narrow table
    sections[0].emplace_back(std::move(results));
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
  std::vector<std::string> solvers;
  for (const std::size_t i : report.answer.order)
    solvers.push_back(report.answer.decisive().observations.groups[i].name);
  add("Control loop", {report.answer.loop});
  std::ranges::copy(report.additions, std::back_inserter(sections));
  const Answer brief = with_short_names(report.answer, longest_name);
  Table pairs = pairs_table(report.answer), numbers = descriptives_table(report.answer);
  pairs.on_page = {told_pairs(report.answer)};
  pairs.in_article = {pairs_of_article(brief)};
  numbers.in_article = {descriptives_table(brief)};
  add("Who is better?", {std::move(pairs)});
  if (!report.has_own_numbers) {
    add("All numbers", {std::move(numbers), solves_table(report.study, solvers), extras_table(report.study, solvers)});
    Table all = anova_table(report.answer), first = all;  // on the page those of one metric
    std::erase_if(first.rows, [&](const auto& row) {
      return std::get<std::string>(row[0]) != std::get<std::string>(all.rows.front()[0]);
    });
    all.on_page = {std::move(first)};
    add("All solvers at once", {std::move(all)});
  }
  Blocks warnings;
  if (!report.first.empty()) {
    for (const Doubt& doubt : report.answer.all_doubts()) warnings.emplace_back(warning_of(doubt));
  }
  warnings.insert(warnings.end(), report.warnings.begin(), report.warnings.end());
  add("Warnings", std::move(warnings));
  if (is_of_study)
    add("Set-up", {methods_of(report.answer, report.study) + ". For LaTeX, with what to cite: article/methods.tex.",
                   study_table(report.study), options_table(report.study), machine_table(report.study)});
  return sections;
}

}  // namespace ikbench::show
