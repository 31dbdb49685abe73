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

struct Report {
  std::filesystem::path page;             // report.html
  std::filesystem::path file;             // report.md
  Table results = {};                     // a study's table of results
  std::vector<std::string> verdict = {};  // what the page says first
  std::vector<Claim> claims = {};         // of a paper
  Findings findings = {};                 // of a study: the quantity that decides
  std::vector<std::string> summary;       // its first sentences
  std::vector<std::string> warnings;      // figures not drawn, an incomplete study, ...
  std::vector<std::string> answers = {};  // solvers without an answer
  std::vector<std::string> further = {};  // studies of the store that the report is not about
};

// Replaces files of the same names. Throws std::invalid_argument if the folder cannot be written. Writes tables even
// without gnuplot.
Report publish(ReportContent content, std::vector<Table> tables, std::vector<figures::Figure> figures,
               const std::filesystem::path& folder, const figures::RenderOptions& options);

// Writes one table as NAME.md, NAME.csv and NAME.tex, which names the program at its end.
void write_table(const Table& table, const std::filesystem::path& folder, const std::string& program);

// The report of assessments only, for data from anywhere: report.html, report.md, statistics.json, tables/ and
// figures/.
// `content` has its title, source, command and assessments.
Report write_statistics(ReportContent content, const std::filesystem::path& folder,
                        const figures::RenderOptions& options);

}  // namespace ikbench::report
