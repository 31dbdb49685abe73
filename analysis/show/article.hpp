// The tables and paragraphs of a report for an article, in LaTeX. write_report (publish.hpp) calls these functions. The
// files are documented in docs/reference/report.md.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/show/report.hpp"

namespace ikbench::show {

// Returns a table for an article, with the name of the study in the table's name and caption. Rows behind the visible
// ones are left out, unless no row is visible.
Table article_table(const Table& whole, const Report& report);
// Writes the folder article/ of `folder`: methods.tex, results.tex, references.bib if the report cites anything, and
// the example main.tex, which inputs these tables and figures.
void write_article(const Report& report, const std::vector<std::string>& tables,
                   const std::vector<figures::Figure>& figures, const std::filesystem::path& folder,
                   const std::string& program);

}  // namespace ikbench::show
