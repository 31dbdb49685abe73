// The report of a study: its sections of blocks (sections.cpp), as a page, as Markdown (both page.cpp) and as files.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/judge/study.hpp"
#include "analysis/show/answer.hpp"
#include "analysis/show/block.hpp"

namespace ikbench::show {

// What sections are made of.
struct Report {
  judge::StudyResults study;  // a user's file: its name alone
  Answer answer;
  std::vector<figures::Figure> figures;
  // Of a paper: instead of the sentence and the table of results; its claims; and sections of its own, each with its
  // heading.
  Blocks first = {}, claims = {};
  std::vector<Blocks> additions = {};
  bool has_own_numbers = false;            // the additions have the descriptions and the ANOVA
  std::vector<std::string> warnings = {};  // beside the study's own
  std::vector<std::string> keys = {};      // that its article cites
  std::string_view references = {};        // where they are
};
Report report_of(judge::JudgedStudy judged, std::vector<figures::Figure> figures);

// The blocks of each section, the additions after the pictures; empty ones are left out. The first begins with the
// headline.
std::vector<Blocks> sections_of(const Report& report);

// They show the pictures that stand in `figures` of the report's folder. The page also has the moving arm, if
// there is one and a library that draws it.
std::string to_page(const std::string& title, const std::vector<Blocks>& sections,
                    const std::optional<std::string>& arm, const std::filesystem::path& folder,
                    const std::string& program);
std::string to_markdown(const std::vector<Blocks>& sections, const std::filesystem::path& folder);
// The types of a figure's pictures that stand there: "svg", "pdf", "png".
std::vector<std::string> types_of(const figures::Figure& figure, const std::filesystem::path& folder);

// A template with each {{name}} replaced.
std::string filled_template(std::string_view name, const std::map<std::string, std::string, std::less<>>& values);

// The table as an article has it: its name and caption say of what.
Table for_article(const Table& whole, const Report& report);
// The folder article/, with an example that inputs these tables and figures. Returns its files.
std::vector<std::string> write_article(const Report& report, const std::vector<std::string>& tables,
                                       const std::vector<figures::Figure>& figures, const std::filesystem::path& folder,
                                       const std::string& program);
// NAME.csv, NAME.md and, of what an article shows, NAME.tex.
void write_table(const Table& table, const Table& article, const std::filesystem::path& folder,
                 const std::string& program);

struct Written {
  std::filesystem::path page;         // report.html
  std::vector<std::string> files;     // all, from the folder
  std::vector<std::string> warnings;  // figures that were not drawn
};
// Throws std::invalid_argument if the folder has a file of their names that no report wrote, as its results.json says.
void refuse_others(const std::filesystem::path& folder);
// Writes report.html, report.md, results.json, tables/ and figures/ beside the study's solves.csv, which whoever reads
// its solves has written (results/export.hpp); removes what an earlier report wrote, and this one does not. `program`
// made it, with its version. Throws std::invalid_argument if the folder cannot be written.
Written publish(const Report& report, const std::filesystem::path& folder, const figures::RenderOptions& options,
                const std::string& program = {});

// The last screen of `run`, `report`, `compare` and `stats` (screen.cpp): the headline, the table of results, pairs,
// warnings; where `page` is, if it is not empty. Pairs are those of the metric of the headline, up to most_pairs
// (words.hpp); where there are only two groups, those of every metric.
std::string screen(const Answer& answer, const std::string& page = {});

// Of the page's moving arm (moving_arm.cpp). JSON, safe inside a script element: the arm, and targets, starts and
// answers of each solver's first run with the joints outside their limits (at most 200 points of 24 solvers, in the
// given order of labels). nullopt if the definition does not describe the arm or nothing is solved.
std::optional<std::string> moving_arm(const judge::StudyResults& study, const std::vector<std::string>& order);

// Name and meaning of each figure that some report has, whose files begin with it.
std::vector<std::pair<std::string, std::string>> all_figures();

// three.js and its OrbitControls, as they were where the program was built (moving_arm.cpp); empty without them.
std::string drawing_library();

}  // namespace ikbench::show
