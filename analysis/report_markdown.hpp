// The report as Markdown.
#pragma once

#include <string>

#include "analysis/report_content.hpp"

namespace ikbench {

std::string to_markdown(const ReportContent& content);

}  // namespace ikbench
