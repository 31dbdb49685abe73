// The tables and paragraphs of a report as an article has them, in LaTeX.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/show/report.hpp"

namespace ikbench::show {

// A paragraph of methods, the set-up without the last point. And one of results.
std::string methods_paragraph(const Report& report, const std::string& program);
std::vector<std::string> results_sentences(const ReportModel& model);

// The table as an article has it: its name and caption say of what.
Table article_table(const Table& whole, const Report& report);
// The folder article/, with an example that inputs these tables and figures.
void write_article(const Report& report, const std::vector<std::string>& tables,
                   const std::vector<figures::Figure>& figures, const std::filesystem::path& folder,
                   const std::string& program);

}  // namespace ikbench::show
