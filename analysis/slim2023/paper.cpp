#include "analysis/slim2023/paper.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "analysis/inference/comparable.hpp"
#include "analysis/inference/estimand.hpp"
#include "analysis/report/summary.hpp"
#include "analysis/slim2023/paper_figures.hpp"
#include "analysis/slim2023/paper_tables.hpp"

namespace ikbench::slim2023 {

using namespace results;
using namespace inference;
using namespace report;

namespace {

std::map<std::string, std::string> seen(const JudgedStudy& study) {
  std::map<std::string, std::string> sentences{{"figure-9", limits_sentence(study)}};
  for (const auto& [metric, anova, curves, boxes] : paper_metrics) {
    const bool is_judged = is_comparable(study, metric);
    sentences[fmt::format("figure-{}", boxes)] =
        is_judged ? words_of(leader_sentence(study, metric, average_estimand(metric))) : times_sentence(study);
  }
  return sentences;
}

// Adds pieces that only a companion study has.
template <class Piece>
void add_of_companion(std::vector<Piece> pieces, std::vector<Piece>& all) {
  constexpr std::array<std::string_view, 7> names{"table-7",   "table-8",   "figure-14", "figure-15",
                                                  "figure-16", "figure-17", "figure-18"};
  for (Piece& piece : pieces) {
    if (std::ranges::count(names, piece.name) > 0) all.push_back(std::move(piece));
  }
}

StudyPieces pieces(const Reported& reported, const decltype(Paper::claims)& claims_of) {
  StudyPieces all{.tables = paper_tables(reported.study),
                  .figures = paper_figures(reported.study),
                  .results = "table-3",
                  .path = "figure-5"};
  if (!reported.study.solves.empty()) all.seen = seen(reported.study);
  for (const JudgedStudy& companion : reported.companions) {
    if (companion.name == reported.study.name + "-all-joints") {
      const Readings readings{reported.study, companion};
      all.tables.push_back(means_by_reading(readings));
      all.tables.push_back(claims_by_reading(readings, claims_of));
    }
    add_of_companion(paper_tables(companion), all.tables);
    add_of_companion(paper_figures(companion), all.figures);
  }
  return all;
}

ReportPlan sections() {
  return {
      .results = {{"Table 3", "", {"overview", "table-3", "table-3-readings", "claims-readings"}, {}},
                  {"Figures 5 to 12",
                   "",
                   {"figure-5", "figure-6", "figure-7", "figure-8", "figure-9", "figure-10", "figure-11", "figure-12"}},
                  {"Tables 4 to 6",
                   "One-way analysis of variance of error, variation and time.",
                   {},
                   {"table-4", "table-5", "table-6"}}},
      .further = {{"Table 7: real time",
                   "How long a swarm of a given size takes to come within 0.1 cm of the target.",
                   {"table-7"},
                   {}},
                  {"Dobot Magician: Table 8, Figures 14 to 18",
                   "The paper's second arm on a circle, computed; no real arm moved.",
                   {"figure-14", "figure-15", "figure-16", "figure-17", "figure-18"},
                   {"table-8"}}}};
}

}  // namespace

void complete(Paper& paper) {
  paper.pieces = [claims = paper.claims](const Reported& reported) { return pieces(reported, claims); };
  paper.sections = sections();
}

}  // namespace ikbench::slim2023
