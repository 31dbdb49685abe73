// Puts a report into a folder: report.html, report.md, statistics.json, tables/ (Markdown, CSV, LaTeX) and figures/.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/report/assessment.hpp"
#include "analysis/report/report_content.hpp"
#include "analysis/report/table.hpp"

namespace ikbench::report {

struct Publication {
  ReportContent content;  // its sections are made here, of what follows
  std::vector<Table> tables = {};
  std::vector<figures::Figure> figures = {};
  std::vector<Assessment> assessments = {};  // a section each
  std::optional<std::string> motion = {};    // moving_arm.hpp
};

struct Report {
  std::filesystem::path page;         // report.html
  std::filesystem::path file;         // report.md
  Table results = {};                 // of a study, what was reached
  std::vector<std::string> summary;   // what it says first, sentence by sentence
  std::vector<std::string> warnings;  // figures that were not drawn, a study that is incomplete, ...
  bool is_damaged = false;            // the store has numbers that cannot be
};

// Files of the same names are replaced. A folder that cannot be written to is std::invalid_argument. Tables are there
// even where gnuplot is not.
Report publish(Publication publication, const std::filesystem::path& folder, const figures::RenderOptions& options);

// One table as NAME.md, NAME.csv and NAME.tex.
void write_table(const Table& table, const std::filesystem::path& folder);

}  // namespace ikbench::report
