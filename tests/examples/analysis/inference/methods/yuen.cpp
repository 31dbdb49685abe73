// Yuen's test of trimmed means (Biometrika 61 (1974) 165): the example of docs/adding-anything.md.
#include <algorithm>
#include <cmath>

#include "analysis/inference/method.hpp"

namespace ikbench::inference {

using namespace statistics;

namespace {

// Summarizes the values without a fifth on either side. With this standard deviation, Welch's test is Yuen's.
GroupSummary trimmed(std::vector<double> values) {
  std::ranges::sort(values);
  const auto cut = static_cast<std::ptrdiff_t>(values.size() / 5);
  const std::span<const double> kept(values.begin() + cut, values.end() - cut);
  const GroupSummary result{.mean = mean(kept), .n = static_cast<int>(kept.size())};
  std::fill(values.begin(), values.begin() + cut, kept.front());
  std::fill(values.end() - cut, values.end(), kept.back());
  const double freedom = (static_cast<double>(values.size()) - 1) / (result.n - 1);
  return {.mean = result.mean, .std = standard_deviation(values) * std::sqrt(freedom), .n = result.n};
}

std::vector<Contrast> yuen_pairs(const Evidence& evidence, const Groups& groups) {
  std::vector<GroupSummary> summaries;
  for (const std::vector<double>& values : groups.values) summaries.push_back(trimmed(values));
  return of_means(evidence, tamhane(summaries, 1 - evidence.plan.significance, evidence.reference));
}

}  // namespace

extern const Method yuen_method;
const Method yuen_method{.name = "yuen",
                         .title = "Yuen's test of trimmed means",
                         .of_pair = "Yuen's test",
                         .of_two = "Yuen's test",
                         .interval = "Yuen, corrected by Sidak's inequality",
                         .source = "Yuen, Biometrika 61 (1974) 165",
                         .corrects_all_pairs = true,
                         .pairs = yuen_pairs};

}  // namespace ikbench::inference
