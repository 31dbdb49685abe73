// Writes the report as the skeleton of an article in LaTeX, which reads its tables and figures from the report's
// folder.
#pragma once

#include <string>

#include "analysis/report/report_content.hpp"

namespace ikbench::report {

std::string to_article(const ReportContent& content);

}  // namespace ikbench::report
