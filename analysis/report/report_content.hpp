// What a report says, in its order, whatever it is written in.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/inference/doubt.hpp"
#include "analysis/report/assessment.hpp"
#include "analysis/report/claims.hpp"
#include "analysis/report/table.hpp"

namespace ikbench::report {

struct ReportFigure {
  figures::Figure figure;
  bool drawn = false;  // else there are only its script and its data
};
std::string title_of(std::string name);  // figure-9-a is Figure 9 a

using Piece = std::variant<Table, ReportFigure>;
const std::string& name_of(const Piece& piece);

// All texts are plain: the writers escape. The page shows the pieces, and folds the rest; a section without pieces is
// folded whole, behind its heading.
struct Section {
  std::string heading;
  std::string paragraph;            // may be empty
  std::vector<Sentence> sentences;  // may be none
  std::vector<Piece> pieces;
  std::vector<Piece> folded = {};
};

// A section and the pieces that it asks for: names in order; one that ends in * stands for all that begin so, and of
// "a|b" the first that is there.
struct SectionPlan {
  std::string heading;
  std::string paragraph;
  std::vector<std::string> names;  // shown
  std::vector<std::string> folded = {};
};

// Where the pieces of a paper stand: the results of its study, and what else belongs to it.
struct ReportPlan {
  std::vector<SectionPlan> results = {};  // where empty, those of any study
  std::vector<SectionPlan> further = {};
};

struct ReportContent {
  std::string study;
  std::string kind = "Report of the study";  // what stands before its name
  std::string title;
  std::vector<Sentence> answer = {};      // its first sentences; may be none
  std::vector<std::string> studied = {};  // whose paper, what was run, what was not: sentences
  std::vector<std::string> solvers = {};  // in the order of their colours
  std::vector<Claim> claims;
  std::vector<std::string> summary;
  inference::Doubts warnings = {};
  std::string command;                 // gives the numbers again; empty where nobody knows
  std::vector<Section> circumstances;  // what was run, where, and what became of it
  std::vector<Section> results;
  ReportPlan plan = {};
  std::string path = "path";  // the figure that stands where nothing moves
  // By the name of a piece, or the heading of a section that is folded or has the verdict, what its reader sees there,
  // in a sentence.
  std::map<std::string, std::string> seen = {};
};

// The piece of that name among all sections, a table before its figure; null where there is none.
const Piece* piece_named(const ReportContent& content, std::string_view name);

// What is seen in a piece of the content, of pieces of one name in the first; may be empty.
std::string seen_at(const Piece& piece, const ReportContent& content);

// The verdict's first sentences: of claims, how many hold and what else is seen there; else the answer.
std::vector<std::string> answers_of(const ReportContent& content);

// Puts every piece into the section that asks for it by name. A section of which nothing is there is left out; pieces
// that no section asks for are in one at the end. Every assessment has a section of its own, folded where there is
// anything else.
void arrange(std::vector<Piece> pieces, const std::vector<Assessment>& assessments, ReportContent& content);

}  // namespace ikbench::report
