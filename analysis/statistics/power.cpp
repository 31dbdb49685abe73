#include "analysis/statistics/power.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "analysis/statistics/tails.hpp"

namespace ikbench::statistics {
namespace {

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

// The smallest whole n of at least 2 with which a test finds a shift of `one` sqrt(n). The search begins at the n of a
// normal distribution.
template <class Degrees>
double smallest_n(double one, const PowerGoal& goal, Degrees degrees_of) {
  const boost::math::normal normal;
  const double reach = quantile(normal, 1 - goal.alpha / 2) + quantile(normal, goal.power);
  return smallest_number(std::clamp(std::ceil(std::pow(reach / one, 2)), 2.0, most_runs), [&](double n) {
    return two_sided_power(one * std::sqrt(n), degrees_of(n), goal.alpha) >= goal.power;
  });
}

bool can_be_seen(double difference, double spread) {
  return std::isfinite(spread) && spread > 0 && !std::isnan(difference) && difference != 0;
}

}  // namespace

double smallest_number(double guess, const std::function<bool(double)>& is_enough) {
  double enough = guess, too_few = guess - 1;
  for (double step = 1; !is_enough(enough); step *= 2) {
    if (enough >= most_runs) return std::numeric_limits<double>::infinity();
    too_few = enough;
    enough = std::min(enough + step, most_runs);
  }
  for (double step = 1; too_few > 1 && too_few < guess && is_enough(too_few); step *= 2) {
    enough = too_few;
    too_few = std::max(1.0, enough - step);
  }
  while (enough - too_few > 1) {
    const double middle = std::floor((enough + too_few) / 2);
    (is_enough(middle) ? enough : too_few) = middle;
  }
  return enough;
}

double least_difference(int n, bool is_paired, const PowerGoal& goal) {
  check(goal);
  if (n < 2) return not_defined;
  const double size = is_paired ? n : n / 2.0, df = is_paired ? n - 1.0 : 2.0 * n - 2;
  const auto excess = [&](double apart) {
    return two_sided_power(apart * std::sqrt(size), df, goal.alpha) - goal.power;
  };
  double enough = 1;
  while (excess(enough) < 0) enough *= 2;
  std::uintmax_t evaluations = 200;
  const auto [below, above] = boost::math::tools::toms748_solve(
      excess, 0.0, enough, boost::math::tools::eps_tolerance<double>(40), evaluations);
  return (below + above) / 2;
}

double plausible_deviation(double std, int n, double probability) {
  if (n < 2 || !(std >= 0) || !std::isfinite(std)) return not_defined;
  const boost::math::chi_squared of_squares(n - 1.0);
  return std * std::sqrt((n - 1) / boost::math::quantile(boost::math::complement(of_squares, probability)));
}

double runs_to_see(const GroupSummary& a, const GroupSummary& b, double difference, const PowerGoal& goal) {
  check(goal);
  const double spread = a.n < 2 || b.n < 2 ? not_defined : std::hypot(a.std, b.std);
  if (!can_be_seen(difference, spread)) return not_defined;
  const double degrees =
      1 / (std::pow(a.std / spread, 4) + std::pow(b.std / spread, 4));  // of Welch's test, over n - 1
  return smallest_n(difference / spread, goal, [&](double n) { return degrees * (n - 1); });
}

double pairs_to_see(double std, double difference, const PowerGoal& goal) {
  check(goal);
  if (!can_be_seen(difference, std)) return not_defined;
  return smallest_n(difference / std, goal, [](double n) { return n - 1; });
}

}  // namespace ikbench::statistics
