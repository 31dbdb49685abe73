#include "analysis/report/report_content.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>

#include "analysis/inference/metrics.hpp"

namespace ikbench::report {

namespace {

const std::vector<SectionPlan>& circumstances() {
  static const std::vector<SectionPlan> plans{{"Study", "", {"definition", "options", "analysis-plan"}},
                                              {"Environment", "", {"environment"}},
                                              {"Outcome of every solve", "", {"status"}}};
  return plans;
}

// Of a study without a paper.
std::vector<SectionPlan> results() {
  std::vector<std::string> names{"results", "path"};
  const std::vector<inference::Metric> metrics = inference::reported_metrics();
  for (const inference::Metric metric : metrics)
    names.push_back(fmt::format("{}-boxes", inference::info_of(metric).slug));
  for (const inference::Metric metric : metrics) names.emplace_back(inference::info_of(metric).slug);
  names.emplace_back("joints");
  return {{"Results", "", names}, {"Analysis of variance", "", {"anova-*"}}};
}

SectionPlan convergence() {
  return {
      "Convergence and cost",
      "How the error falls with the cost. The curves describe single solves; intervals and bands draw runs as a whole "
      "where each solve starts from the previous answer. Convergence and runtimes need traces, trace = "
      "\"best_error\" in the study. Costs and survival need a tolerance.",
      {"statistics-convergence", "statistics-ecdf-*", "statistics-profile-*", "statistics-survival-*",
       "statistics-cost*"}};
}

const std::vector<SectionPlan>& last() {
  static const std::vector<SectionPlan> plans{
      {"Audit of the printed numbers", "Whether the paper's printed numbers agree with each other.", {"audit*"}},
      {"Interpretations of what the paper leaves open", "What each choice would have given.", {"readings*"}},
      {"Joint limits", "The same study with all joint limits enforced, including the wrist's.", {"limits"}},
      {"Baselines", "", {"baselines"}}};
  return plans;
}

bool asks_for(std::string_view asked, std::string_view name) {
  return asked.ends_with('*') ? name.starts_with(asked.substr(0, asked.size() - 1)) : name == asked;
}

// Takes what the plan asks for out of the pieces.
Section section(const SectionPlan& plan, std::vector<Piece>& pieces) {
  Section result{.heading = plan.heading, .paragraph = plan.paragraph, .sentences = {}, .pieces = {}};
  for (const std::string& asked : plan.names) {
    const auto others = std::stable_partition(pieces.begin(), pieces.end(),
                                              [&](const Piece& p) { return asks_for(asked, name_of(p)); });
    std::move(pieces.begin(), others, std::back_inserter(result.pieces));
    pieces.erase(pieces.begin(), others);
  }
  return result;
}

}  // namespace

std::string title_of(std::string name) {
  std::ranges::replace(name, '-', ' ');
  name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return name;
}

const std::string& name_of(const Piece& piece) {
  const auto* table = std::get_if<Table>(&piece);
  return table ? table->name : std::get<ReportFigure>(piece).figure.name;
}

void arrange(std::vector<Piece> pieces, const std::vector<Assessment>& assessments, ReportContent& content) {
  const auto fill = [&](const std::vector<SectionPlan>& plans, std::vector<Section>& sections) {
    for (const SectionPlan& plan : plans) {
      Section filled = section(plan, pieces);
      if (!filled.pieces.empty()) sections.push_back(std::move(filled));
    }
  };
  fill(circumstances(), content.circumstances);
  fill(content.plan.results.empty() ? results() : content.plan.results, content.results);
  for (const Assessment& assessment : assessments) {
    SectionPlan own{assessment.heading, "", {}};
    for (const Table& table : assessment.tables) own.names.push_back(table.name);
    for (const figures::Figure& figure : assessment.figures) own.names.push_back(figure.name);
    Section& filled = content.results.emplace_back(section(own, pieces));
    filled.sentences = assessment.sentences;
  }
  fill({convergence()}, content.results);
  fill(content.plan.further, content.results);
  fill(last(), content.results);
  if (pieces.empty()) return;
  content.results.push_back({.heading = "Further", .paragraph = "", .sentences = {}, .pieces = std::move(pieces)});
}

}  // namespace ikbench::report
