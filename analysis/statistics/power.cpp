#include "analysis/statistics/power.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <stdexcept>

#include "analysis/statistics/t_distribution.hpp"

namespace ikbench::statistics {
namespace {

constexpr double most_runs = 1e7;

void check(const PowerGoal& goal) {
  if (goal.alpha > 0 && goal.alpha < goal.power && goal.power < 1) return;
  throw std::invalid_argument(
      fmt::format("power {} at alpha {}: expected 0 < alpha < power < 1", goal.power, goal.alpha));
}

// The chance of |T| beyond its critical value; 1 if the shift is so large that nothing else is possible.
double two_sided_power(double shift, double df, double alpha) {
  const double critical = -t_quantile(alpha / 2, df);
  shift = std::min(std::abs(shift), 1e300);
  return noncentral_t_upper_tail(critical, df, shift) + noncentral_t_upper_tail(critical, df, -shift);
}

// The smallest whole n of at least 2 with which a test finds a shift of `one` sqrt(n); power rises with n. The search
// begins at the n of a normal distribution, and its steps double.
template <class Degrees>
RunsNeeded smallest_n(double one, const PowerGoal& goal, Degrees degrees_of) {
  const auto is_enough = [&](double n) {
    return two_sided_power(one * std::sqrt(n), degrees_of(n), goal.alpha) >= goal.power;
  };
  const boost::math::normal normal;
  const double reach = quantile(normal, 1 - goal.alpha / 2) + quantile(normal, goal.power);
  const double guess = std::clamp(std::ceil(std::pow(reach / one, 2)), 2.0, most_runs);
  double enough = guess, too_few = guess, step = 1;
  if (is_enough(guess)) {
    for (too_few = guess - step; too_few > 1 && is_enough(too_few); too_few = std::max(1.0, enough - step)) {
      enough = too_few;
      step *= 2;
    }
  } else {
    do {
      if (enough >= most_runs) return {.undefined = "more than ten million runs are needed"};
      too_few = enough;
      enough = std::min(enough + step, most_runs);
      step *= 2;
    } while (!is_enough(enough));
  }
  while (enough - too_few > 1) {
    const double middle = std::floor((enough + too_few) / 2);
    (is_enough(middle) ? enough : too_few) = middle;
  }
  return {.n = enough};
}

// The difference at which power reaches the goal; power rises with the difference.
template <class Power>
double least(double goal, Power power_at) {
  double enough = 1;
  while (power_at(enough) < goal) enough *= 2;
  double too_little = 0;
  for (int i = 0; i < 60; ++i) {
    const double middle = (too_little + enough) / 2;
    (power_at(middle) >= goal ? enough : too_little) = middle;
  }
  return enough;
}

}  // namespace

double least_difference(int n, const PowerGoal& goal) {
  check(goal);
  if (n < 2) return not_defined;
  return least(goal.power,
               [&](double apart) { return two_sided_power(apart * std::sqrt(n / 2.0), 2.0 * n - 2, goal.alpha); });
}

double least_mean_difference(int n, const PowerGoal& goal) {
  check(goal);
  if (n < 2) return not_defined;
  return least(goal.power, [&](double apart) { return two_sided_power(apart * std::sqrt(n), n - 1.0, goal.alpha); });
}

double plausible_deviation(double std, int n, double probability) {
  if (n < 2 || !(std >= 0) || !std::isfinite(std)) return not_defined;
  const boost::math::chi_squared of_squares(n - 1.0);
  return std * std::sqrt((n - 1) / boost::math::quantile(boost::math::complement(of_squares, probability)));
}

RunsNeeded runs_to_see(const GroupSummary& a, const GroupSummary& b, double difference, const PowerGoal& goal) {
  check(goal);
  if (a.n < 2 || b.n < 2) return {.undefined = "a group of fewer than two values has no spread"};
  if (!std::isfinite(a.std) || !std::isfinite(b.std)) return {.undefined = "a standard deviation is not defined"};
  if (std::isnan(difference)) return {.undefined = "the difference is not defined"};
  if (difference == 0) return {.undefined = "no number of runs shows a difference of zero"};
  const double spread = std::hypot(a.std, b.std);
  if (!(spread > 0)) return {.undefined = "both groups are constant, so any run shows a difference"};
  const double degrees =
      1 / (std::pow(a.std / spread, 4) + std::pow(b.std / spread, 4));  // of Welch's test, over n - 1
  return smallest_n(difference / spread, goal, [&](double n) { return degrees * (n - 1); });
}

RunsNeeded pairs_to_see(double std, double difference, const PowerGoal& goal) {
  check(goal);
  if (!std::isfinite(std)) return {.undefined = "the standard deviation of the differences is not defined"};
  if (std::isnan(difference)) return {.undefined = "the difference is not defined"};
  if (difference == 0) return {.undefined = "no number of pairs shows a difference of zero"};
  if (!(std > 0)) return {.undefined = "all differences are equal, so any two pairs show one"};
  return smallest_n(difference / std, goal, [](double n) { return n - 1; });
}

}  // namespace ikbench::statistics
