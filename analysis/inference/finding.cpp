#include "analysis/inference/finding.hpp"

#include <array>
#include <utility>

#include "analysis/statistics/multiple_comparisons.hpp"

namespace ikbench::inference {

std::string_view name_of(Relation relation) {
  constexpr std::array<std::string_view, 5> names{"first is better", "second is better", "same within the margin",
                                                  "undecided", "not defined"};
  return names[static_cast<std::size_t>(relation)];
}

std::vector<Finding> unjudged_pairs(std::size_t groups, std::optional<std::size_t> only_with) {
  std::vector<Finding> result;
  for (const auto& pair : statistics::pairs_of(groups, only_with))
    result.push_back({.first = pair.first, .second = pair.second});
  return result;
}

Estimate reversed(const Estimate& estimate, bool is_ratio) {
  const auto turned = [&](double value) { return is_ratio ? 1 / value : 0 - value; };  // no -0
  return {.value = turned(estimate.value), .low = turned(estimate.high), .high = turned(estimate.low)};
}

Finding reversed(Finding finding) {
  std::swap(finding.first, finding.second);
  finding.relation = reversed(finding.relation);
  finding.estimate = reversed(finding.estimate, finding.is_ratio);
  finding.ratio = reversed(finding.ratio, true);
  const Estimate& ahead = finding.superiority;
  finding.superiority = {.value = 1 - ahead.value, .low = 1 - ahead.high, .high = 1 - ahead.low};
  finding.ahead = -finding.ahead;
  finding.g = -finding.g;
  return finding;
}

std::optional<Finding> finding_of(std::span<const Finding> findings, std::size_t first, std::size_t second) {
  for (const Finding& finding : findings) {
    if (finding.first == first && finding.second == second) return finding;
    if (finding.first == second && finding.second == first) return reversed(finding);
  }
  return std::nullopt;
}

}  // namespace ikbench::inference
