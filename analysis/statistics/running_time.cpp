#include "analysis/statistics/running_time.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>

namespace ikbench::statistics {

std::string wrong_with(std::span<const CensoredCost> costs) {
  if (costs.empty()) return "there are no trials";
  for (std::size_t i = 0; i < costs.size(); ++i) {
    const double spent = costs[i].spent;
    if (!std::isfinite(spent) || spent < 0) return fmt::format("the cost of trial {} is {}", i + 1, spent);
  }
  return {};
}

RunningTime running_time(std::span<const CensoredCost> costs) {
  RunningTime result{.undefined = wrong_with(costs)};
  if (!result.undefined.empty()) return result;
  double of_all = 0, of_successes = 0;
  for (const CensoredCost& cost : costs) {
    ++result.trials;
    of_all += cost.spent;
    if (!cost.reached) continue;
    ++result.successes;
    of_successes += cost.spent;
  }
  result.success_rate = static_cast<double>(result.successes) / result.trials;
  if (result.successes == 0) {
    result.undefined = "no trial reached the tolerance";
  } else if (!std::isfinite(of_all)) {
    result.undefined = "the costs are too large for double precision";
  } else {
    result.expected = of_all / result.successes;
    result.sp1 = of_successes / result.successes / result.success_rate;
  }
  return result;
}

}  // namespace ikbench::statistics
