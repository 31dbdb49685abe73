// The content of a report, in order, independent of its format.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
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
  std::vector<std::string_view> types = {};  // of its pictures, "svg"; none: only its script and data exist
};
std::string title_of(std::string name);  // figure-9-a is Figure 9 a

using Piece = std::variant<Table, ReportFigure>;
const std::string& name_of(const Piece& piece);

// All texts are plain: the writers escape. The page shows `pieces` and folds the rest; it folds a section without
// pieces as a whole.
struct Section {
  std::string heading;
  std::string paragraph;            // may be empty
  std::vector<Sentence> sentences;  // may be none
  std::vector<Piece> pieces;
  std::vector<Piece> folded = {};
};

// A section and the names of its pieces, in order. "a*" means all names that begin with a, "a|b" the first that exists.
struct SectionPlan {
  std::string heading;
  std::string paragraph;
  std::vector<std::string> names;  // shown
  std::vector<std::string> folded = {};
};

// Places the pieces of a study: its results, and a paper's further sections.
struct ReportPlan {
  std::vector<SectionPlan> results = {};
  std::vector<SectionPlan> further = {};
};

struct ReportContent {
  std::string study;
  std::string kind = "Report of the study";  // the words before its name
  std::string title;
  std::vector<Sentence> answer = {};      // its first sentences; may be empty
  std::vector<std::string> studied = {};  // sentences: whose paper, what was run, what was not
  std::vector<Claim> claims;
  std::vector<std::string> summary;
  inference::Doubts warnings = {};
  std::string program = {};            // that writes the report, with its version; may be empty
  std::string command;                 // reproduces the numbers; empty if unknown
  std::vector<Section> circumstances;  // what was run, where, and with which status
  std::vector<Section> results;
  ReportPlan plan = {};
  std::vector<Assessment> assessments = {};  // one section per assessment
  std::optional<std::string> motion = {};    // moving_arm.hpp
  std::string path = "path";                 // the figure that replaces the animated view
  // A sentence on what a piece shows, by its name, or by the heading of a section that is folded or has the verdict.
  std::map<std::string, std::string> seen = {};
};

// Finds a piece by name among all sections, a table before its figure; null if there is none.
const Piece* piece_named(const ReportContent& content, std::string_view name);

// The sentence of `seen` for a piece; of pieces with one name only the first has it. May be empty.
std::string seen_at(const Piece& piece, const ReportContent& content);

// The verdict's first sentences: for claims, how many hold, and the sentence of `seen`; else the answer.
std::vector<std::string> answers_of(const ReportContent& content);

// Puts every piece into the section that names it. Leaves out sections without pieces; collects unnamed pieces in a
// last section. Each assessment gets its own section, folded if there is anything else.
void arrange(std::vector<Piece> pieces, ReportContent& content);

// The writers. The page is one HTML file that needs no network: figures, styles and scripts are inside. It links to
// files beside it, and its pictures are in figures/ of the folder.
std::string to_html(const ReportContent& content, const std::filesystem::path& folder);
std::string to_markdown(const ReportContent& content);

}  // namespace ikbench::report
