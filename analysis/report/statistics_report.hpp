// The report of assessments only, for data from anywhere: report.html, report.md, statistics.json, tables/ and
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
  std::string source;   // source of the data: the file's name
  std::string command;  // reproduces the report
  std::filesystem::path folder;
  figures::RenderOptions figures = {};
};

Report write_statistics(const std::vector<Assessment>& assessments, const StatisticsRequest& request);

}  // namespace ikbench::report
