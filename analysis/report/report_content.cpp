#include "analysis/report/report_content.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace ikbench::report {

namespace {

bool asks_for(std::string_view asked, std::string_view name) {
  return asked.ends_with('*') ? name.starts_with(asked.substr(0, asked.size() - 1)) : name == asked;
}

// Moves the named pieces out of `pieces`.
std::vector<Piece> taken(const std::vector<std::string>& names, std::vector<Piece>& pieces) {
  std::vector<Piece> result;
  for (const std::string& asked : names) {
    const std::size_t bar = asked.find('|');
    const std::string first = asked.substr(0, bar);
    const auto others = std::stable_partition(pieces.begin(), pieces.end(),
                                              [&](const Piece& p) { return asks_for(first, name_of(p)); });
    const bool is_there = others != pieces.begin();
    std::move(pieces.begin(), others, std::back_inserter(result));
    pieces.erase(pieces.begin(), others);
    if (is_there || bar == std::string::npos) continue;
    std::ranges::move(taken({asked.substr(bar + 1)}, pieces), std::back_inserter(result));
  }
  return result;
}

Section section(const SectionPlan& plan, std::vector<Piece>& pieces) {
  return {.heading = plan.heading,
          .paragraph = plan.paragraph,
          .sentences = {},
          .pieces = taken(plan.names, pieces),
          .folded = taken(plan.folded, pieces)};
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

const Piece* piece_named(const ReportContent& content, std::string_view name) {
  for (const std::vector<Section>* part : {&content.results, &content.circumstances}) {
    for (const Section& section : *part) {
      for (const std::vector<Piece>* pieces : {&section.pieces, &section.folded}) {
        const auto found = std::ranges::find_if(*pieces, [&](const Piece& piece) { return name_of(piece) == name; });
        if (found != pieces->end()) return &*found;
      }
    }
  }
  return nullptr;
}

std::string seen_at(const Piece& piece, const ReportContent& content) {
  const auto seen = content.seen.find(name_of(piece));
  return seen != content.seen.end() && piece_named(content, name_of(piece)) == &piece ? seen->second : "";
}

std::vector<std::string> answers_of(const ReportContent& content) {
  return content.claims.empty() ? words_of(content.answer) : std::vector{tally(content.claims)};
}

void arrange(std::vector<Piece> pieces, ReportContent& content) {
  const auto fill = [&](const std::vector<SectionPlan>& plans, std::vector<Section>& sections) {
    for (const SectionPlan& plan : plans) {
      Section filled = section(plan, pieces);
      if (filled.pieces.empty() && !filled.folded.empty()) {  // its first piece's sentence stands for it
        const auto seen = content.seen.find(name_of(filled.folded.front()));
        if (seen != content.seen.end()) content.seen[plan.heading] = seen->second;
      }
      if (!filled.pieces.empty() || !filled.folded.empty()) sections.push_back(std::move(filled));
    }
  };
  fill({{"Study",
         "What was solved, by which options, and how it is judged.",
         {},
         {"definition", "options", "analysis-plan"}},
        {"Environment", "The machine, the compiler and the load.", {}, {"environment"}},
        {"Outcome of every solve", "How the solves ended, and what was wrong with them.", {}, {"status"}}},
       content.circumstances);
  fill({{"Solve rates", "", {"solve-rates-figure", "solve-rates"}}}, content.results);
  fill(content.plan.results, content.results);
  fill(content.plan.further, content.results);
  fill({{"Multiverse: what the paper leaves open", "", {"multiverse"}, {"multiverse-*"}}}, content.results);
  const bool are_all = content.results.empty();  // a report of data only shows them
  for (const Assessment& assessment : content.assessments) {
    SectionPlan own{heading_of(assessment), "", {}};
    std::vector<std::string>& names = are_all ? own.names : own.folded;
    for (const Table& table : assessment.tables) names.push_back(table.name);
    for (const figures::Figure& figure : assessment.figures) names.push_back(figure.name);
    Section& filled = content.results.emplace_back(section(own, pieces));
    filled.sentences = assessment.sentences;
    if (!assessment.answer.empty()) content.seen[own.heading] = assessment.answer.front() + '.';
  }
  fill({{"Convergence",
         "How the error falls with the evaluations. The curves describe single solves and need traces, trace = "
         "\"best_error\" in the study. The share solved needs a tolerance.",
         {},
         {"statistics-convergence", "statistics-solved-evaluations"}},
        {"Joint limits", "The same study with all joint limits enforced, including the wrist's.", {}, {"limits"}},
        {"Baselines", "Other solvers on the same targets.", {}, {"baselines"}}},
       content.results);
  if (pieces.empty()) return;
  content.results.push_back(
      {.heading = "Further", .paragraph = "", .sentences = {}, .pieces = {}, .folded = std::move(pieces)});
}

}  // namespace ikbench::report
