#include "analysis/statistics/running_time.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <limits>

namespace ikbench::statistics {

double RunningTime::expected() const {
  if (trials == 0) return not_defined;
  return successes > 0 ? spent / successes : std::numeric_limits<double>::infinity();
}

RunningTime running_time(std::span<const CensoredCost> costs) {
  RunningTime result;
  for (const auto& [spent, reached] : costs) {
    ++result.trials;
    result.successes += reached ? 1 : 0;
    result.spent += spent;
  }
  return result;
}

std::string wrong_with(std::span<const CensoredCost> costs) {
  if (costs.empty()) return "there are no trials";
  for (std::size_t i = 0; i < costs.size(); ++i) {
    const double spent = costs[i].spent;
    if (!std::isfinite(spent) || spent < 0) return fmt::format("the cost of trial {} is {}", i + 1, spent);
  }
  return std::isfinite(running_time(costs).spent) ? "" : "the costs are too large for double precision";
}

}  // namespace ikbench::statistics
