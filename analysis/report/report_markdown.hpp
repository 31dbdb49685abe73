// The report as Markdown: all of it, and what the page shows first.
#pragma once

#include <string>

#include "analysis/report/report_content.hpp"

namespace ikbench::report {

std::string to_markdown(const ReportContent& content);
// The verdict, the claims with the first sentence of what decided each, and the shown tables and figures with what is
// to be seen in them; pictures as SVG.
std::string verdict_markdown(const ReportContent& content);

}  // namespace ikbench::report
