#include "analysis/inference/finding.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace ikbench::inference {

Finding reversed(Finding finding) {
  std::swap(finding.first, finding.second);
  const auto turned = [&](double value) { return finding.is_ratio ? 1 / value : -value; };
  const Estimate before = finding.estimate;
  finding.estimate = {.value = turned(before.value), .low = turned(before.high), .high = turned(before.low)};
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
