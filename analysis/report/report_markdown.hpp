// Writes the report as Markdown: all of it, or what the page shows first.
#pragma once

#include <string>

#include "analysis/report/report_content.hpp"

namespace ikbench::report {

std::string to_markdown(const ReportContent& content);
// The verdict, each claim with the first sentence of its evidence, and the shown tables and figures with their
// sentences; pictures as SVG.
std::string verdict_markdown(const ReportContent& content);

}  // namespace ikbench::report
