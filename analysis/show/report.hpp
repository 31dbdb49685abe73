// The report of a study: sections of blocks, written as a page, as Markdown and as files.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "analysis/show/block.hpp"
#include "analysis/show/shown.hpp"

namespace ikbench::show {

// What sections are made of.
struct Reported {
  compare::StudyResults study;  // a user's file: its name alone
  Shown shown;
  std::vector<figures::Figure> figures;
  // Of a paper: instead of the sentence and the table of results; and sections of its own, each with its heading.
  Blocks first = {};
  std::vector<Blocks> additions = {};
  bool has_own_numbers = false;  // the additions have the descriptions and the ANOVA
};
Reported reported(compare::JudgedStudy judged, std::vector<figures::Figure> figures);

// The blocks of each section of sections.inc, and of the additions after the pictures; empty ones are left out. The
// first begins with the headline.
std::vector<Blocks> sections_of(const Reported& reported);

// A report's pictures: those that were drawn in a folder.
struct Pictures {
  std::filesystem::path folder;          // of the report
  std::vector<std::string> types;        // "svg", "pdf"
  std::set<std::string> not_drawn = {};  // names of figures
};
std::string to_page(const std::string& title, const std::vector<Blocks>& sections, const Pictures& pictures,
                    const std::string& program);
std::string to_markdown(const std::vector<Blocks>& sections, const Pictures& pictures);

// The answer as data: headline, groups, tests, findings and doubts. `files` of a report are added by publish().
numerics::OrderedJson to_json(const Shown& shown);

struct Published {
  std::filesystem::path page;         // report.html
  std::vector<std::string> files;     // all, from the folder
  std::vector<std::string> warnings;  // figures that were not drawn
};
// Writes report.html, report.md, results.json, solves.csv, tables/ and figures/; removes what an earlier report wrote,
// and this one does not. `program` made it, with its version. Throws std::invalid_argument if the folder cannot be
// written.
Published publish(const Reported& reported, const std::filesystem::path& folder, const figures::RenderOptions& options,
                  const std::string& program = {});

}  // namespace ikbench::show
