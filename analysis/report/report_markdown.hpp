// The report as Markdown.
#pragma once

#include <string>

#include "analysis/report/report_content.hpp"

namespace ikbench::report {

std::string to_markdown(const ReportContent& content);

}  // namespace ikbench::report
