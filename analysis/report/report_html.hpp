// The report as one HTML file that needs no network: figures, styles and scripts are inside.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/report/report_content.hpp"

namespace ikbench::report {

struct PageFiles {
  std::filesystem::path figures;                    // folder of the drawn SVG files
  std::optional<std::string> motion = {};           // moving_arm(); without it the page has no animated view
  std::optional<std::string> drawing_library = {};  // without it the view says what is missing
  std::vector<std::string> downloads = {};          // files beside the page that it links to
};

std::string to_html(const ReportContent& content, const PageFiles& files);

}  // namespace ikbench::report
