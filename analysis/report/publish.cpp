#include "analysis/report/publish.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "results/files.hpp"

namespace ikbench::report {

using namespace results;
using namespace figures;
using namespace inference;

namespace {

// Merges equal messages of several figures into one warning.
Doubts failures_of(const std::vector<FigureOutcome>& outcomes) {
  Doubts failures;
  for (const FigureOutcome& outcome : outcomes) {
    if (outcome.error.empty()) continue;
    auto same = std::ranges::find(failures, outcome.error, &Doubt::what);
    if (same == failures.end()) {
      same = failures.insert(same, {.kind = DoubtKind::figure_not_drawn, .what = outcome.error});
    }
    same->who.push_back(outcome.name);
  }
  return failures;
}

std::string json_of(const std::vector<Assessment>& assessments) {
  std::vector<std::string> objects;
  for (const Assessment& assessment : assessments) objects.push_back(assessment.json);
  return fmt::format("[\n{}\n]\n", fmt::join(objects, ",\n"));
}

std::string latex_comment(const std::string& program) {
  return program.empty() ? "" : fmt::format("% Made by {}\n", program);
}

}  // namespace

void write_table(const Table& table, const std::filesystem::path& folder, const std::string& program) {
  write_file(folder / (table.name + ".md"), to_markdown(table));
  write_file(folder / (table.name + ".csv"), to_csv(table));
  write_file(folder / (table.name + ".tex"), to_latex(table) + latex_comment(program));
}

Report publish(ReportContent content, std::vector<Table> tables, std::vector<Figure> figures,
               const std::filesystem::path& folder, const RenderOptions& options) {
  content.program = options.program;
  for (const Assessment& assessment : content.assessments) {
    std::ranges::copy(assessment.tables, std::back_inserter(tables));
    std::ranges::copy(assessment.figures, std::back_inserter(figures));
  }
  for (const std::filesystem::path& place : {folder, folder / "tables", folder / "figures"}) remove_litter(place);
  for (const Table& table : tables) write_table(table, folder / "tables", options.program);
  if (!content.assessments.empty()) write_file(folder / "statistics.json", json_of(content.assessments));
  const std::vector<FigureOutcome> outcomes = write_figures(figures, folder / "figures", options);
  std::ranges::move(failures_of(outcomes), std::back_inserter(content.warnings));

  std::vector<Piece> pieces(tables.begin(), tables.end());
  for (std::size_t i = 0; i < figures.size(); ++i) {
    ReportFigure piece{.figure = std::move(figures[i])};
    if (options.style.width_cm > 0) piece.figure.width_cm = options.style.width_cm;
    if (outcomes[i].rendered) {
      for (const Picture type : options.style.formats) piece.types.push_back(name_of(type));
    }
    pieces.emplace_back(std::move(piece));
  }
  arrange(std::move(pieces), content);

  Report report{.page = folder / "report.html",
                .file = folder / "report.md",
                .verdict = answers_of(content),
                .claims = content.claims,
                .summary = content.summary,
                .warnings = list_of(content.warnings)};
  const std::vector<std::string> answer = words_of(content.answer);
  report.summary.insert(report.summary.begin(), answer.begin(), answer.end());
  write_file(report.file, to_markdown(content));
  write_file(report.page, to_html(content, folder));
  return report;
}

Report write_statistics(ReportContent content, const std::filesystem::path& folder, const RenderOptions& options) {
  for (const Assessment& assessment : content.assessments) {
    if (!assessment.answer.empty()) {
      content.summary.push_back(fmt::format("{}{}: {}.", assessment.quantity,
                                            assessment.flaws.empty() ? "" : " (flawed)",
                                            fmt::join(assessment.answer, ". ")));
    }
    std::ranges::copy(assessment.flaws, std::back_inserter(content.warnings));
  }
  return publish(std::move(content), {}, {}, folder, options);
}

}  // namespace ikbench::report
