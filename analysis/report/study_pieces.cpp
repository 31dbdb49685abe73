#include "analysis/report/study_pieces.hpp"

#include <algorithm>
#include <utility>

namespace ikbench::report {

using namespace inference;
using namespace figures;

#define TABLE(name, heading, place) std::vector<Table> name##_tables(const StudyResults&, const std::vector<Metric>&);
#define FIGURE(name, heading, place) \
  std::vector<Figure> name##_figures(const StudyResults&, const std::vector<Metric>&);
#define PLACE(names, heading, place)
#include "analysis/report/study_pieces.inc"
#undef TABLE
#undef FIGURE
#undef PLACE

namespace {

constexpr bool shown = true, folded = false;
constexpr StudyPiece every_piece[]{
#define TABLE(name, heading, place) {#name, heading, place, name##_tables, nullptr},
#define FIGURE(name, heading, place) {#name, heading, place, nullptr, name##_figures},
#define PLACE(names, heading, place) {names, heading, place, nullptr, nullptr},
#include "analysis/report/study_pieces.inc"
#undef TABLE
#undef FIGURE
#undef PLACE
};

SectionPlan& section_of(const StudyPiece& piece, std::vector<SectionPlan>& sections) {
  const auto found = std::ranges::find(sections, piece.heading, &SectionPlan::heading);
  return found != sections.end() ? *found : sections.emplace_back(SectionPlan{std::string(piece.heading), "", {}});
}

template <class Piece>
void add(std::vector<Piece> made, std::vector<std::string>& names, std::vector<Piece>& pieces) {
  for (Piece& piece : made) {
    names.push_back(piece.name);
    pieces.push_back(std::move(piece));
  }
}

}  // namespace

StudyPieces study_pieces(const StudyResults& study) {
  const std::vector<Metric> metrics = shown_metrics(study);
  StudyPieces pieces;
  for (const StudyPiece& piece : every_piece) {
    SectionPlan& section = section_of(piece, pieces.sections);
    std::vector<std::string>& names = piece.is_shown ? section.names : section.folded;
    if (piece.tables) add(piece.tables(study, metrics), names, pieces.tables);
    if (piece.figures && !study.solves.empty()) add(piece.figures(study, metrics), names, pieces.figures);
    if (!piece.tables && !piece.figures) names.emplace_back(piece.name);
  }
  return pieces;
}

}  // namespace ikbench::report
