#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "analysis/inference/method.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/statistics/welch.hpp"

namespace ikbench::inference {

using namespace statistics;

namespace {

// Tests the groups that have a weight; names the others.
std::optional<TestResult> welch_of_all(const Evidence& evidence, const Groups& groups) {
  const std::span summaries = groups.summaries;
  constexpr std::size_t longest_shown = 60, most_shown = 3;
  TestResult result{{}, std::string(welch_name), "F"};
  std::vector<GroupSummary> usable;
  std::vector<std::string> others;
  for (std::size_t i = 0; i < summaries.size(); ++i) {
    const bool weighed = summaries[i].n >= 2 && summaries[i].std > 0 && std::isfinite(summaries[i].mean);
    if (weighed) {
      usable.push_back(summaries[i]);
    } else {
      others.push_back(row_label(evidence.groups[i].name, longest_shown));
    }
  }
  if (usable.size() < 2) {
    result.undefined = "fewer than two groups have a variance";
    return result;
  }
  static_cast<Test&>(result) = welch_anova(usable);
  if (!std::isfinite(result.p)) result.undefined = "the variances are too large or too far apart for double precision";
  if (!others.empty()) {
    result.without = fmt::format("without {}, whose variance is 0 or not defined",
                                 others.size() > most_shown ? fmt::format("{} groups", others.size())
                                                            : fmt::format("{}", fmt::join(others, ", ")));
  }
  return result;
}

std::vector<Finding> tamhane_pairs(const Evidence& evidence, const Groups& groups) {
  return of_means(evidence, tamhane(groups.summaries, 1 - evidence.plan.significance, evidence.reference));
}

}  // namespace

const Method tamhane_method{.name = "tamhane",
                            .title = "Welch's ANOVA with Tamhane's test",
                            .of_pair = "Tamhane's test",
                            .of_two = "Welch's test",
                            .interval = "Tamhane, separate variances",
                            .corrects_all_pairs = true,
                            .pairs = tamhane_pairs,
                            .all = welch_of_all};

}  // namespace ikbench::inference
