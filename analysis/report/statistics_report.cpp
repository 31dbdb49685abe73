#include "analysis/report/statistics_report.hpp"

#include <algorithm>
#include <iterator>

namespace ikbench::report {

Report write_statistics(const std::vector<Assessment>& assessments, const StatisticsRequest& request) {
  Publication publication{.content = {.study = request.source,
                                      .kind = "Statistics of the file",
                                      .title = request.title,
                                      .command = request.command},
                          .assessments = assessments};
  publication.content.summary = headlines_of(assessments);
  for (const Assessment& assessment : assessments) {
    std::ranges::copy(assessment.flaws, std::back_inserter(publication.content.warnings));
  }
  return publish(std::move(publication), request.folder, request.figures);
}

}  // namespace ikbench::report
