#include "analysis/inference/finding.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace ikbench::inference {

Estimate reversed(const Estimate& estimate, bool is_ratio) {
  const auto turned = [&](double value) { return is_ratio ? 1 / value : 0 - value; };  // no -0
  return {.value = turned(estimate.value), .low = turned(estimate.high), .high = turned(estimate.low)};
}

Finding reversed(Finding finding) {
  std::swap(finding.first, finding.second);
  finding.estimate = reversed(finding.estimate, finding.is_ratio);
  finding.relation = reversed(finding.relation);
  return finding;
}

Finding finding_of(std::span<const Finding> findings, std::string_view quantity, std::string_view first,
                   std::string_view second) {
  for (const Finding& finding : findings) {
    if (finding.quantity != quantity) continue;
    if (finding.first == first && finding.second == second) return finding;
    if (finding.first == second && finding.second == first) return reversed(finding);
  }
  throw std::out_of_range(fmt::format("{} and {} are not compared in {}", first, second, quantity));
}

}  // namespace ikbench::inference
