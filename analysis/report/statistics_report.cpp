#include "analysis/report/statistics_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

namespace ikbench::report {

Report write_statistics(const std::vector<Assessment>& assessments, const StatisticsRequest& request) {
  Publication publication{.content = {.study = request.source,
                                      .kind = "Statistics of the file",
                                      .title = request.title,
                                      .command = request.command},
                          .assessments = assessments};
  for (const Assessment& assessment : assessments) {
    if (!assessment.answer.empty()) {
      publication.content.summary.push_back(fmt::format("{}{}: {}.", assessment.quantity,
                                                        assessment.flaws.empty() ? "" : " (flawed)",
                                                        fmt::join(assessment.answer, ". ")));
    }
    std::ranges::copy(assessment.flaws, std::back_inserter(publication.content.warnings));
  }
  return publish(std::move(publication), request.folder, request.figures);
}

}  // namespace ikbench::report
