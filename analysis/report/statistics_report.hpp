// The report of assessments alone, of data from anywhere: report.html, report.md, statistics.json, tables/ and
// figures/.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/report/assessment.hpp"
#include "analysis/report/publish.hpp"

namespace ikbench::report {

struct StatisticsRequest {
  std::string title;
  std::string source;   // whose data they are: the file's name
  std::string command;  // gives the report again
  std::filesystem::path folder;
  figures::RenderOptions figures = {};
};

Report write_statistics(const std::vector<Assessment>& assessments, const StatisticsRequest& request);

}  // namespace ikbench::report
