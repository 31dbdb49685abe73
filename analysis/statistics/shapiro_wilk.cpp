#include "analysis/statistics/shapiro_wilk.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "analysis/statistics/tails.hpp"

namespace ikbench::statistics {
namespace {

constexpr std::size_t fewest = 3, most = 5000;

// c0 + c1 x + c2 x^2 + ...
template <std::size_t count>
double polynomial(const double (&coefficients)[count], double x) {
  double sum = 0;
  for (std::size_t i = count; i-- > 0;) sum = sum * x + coefficients[i];
  return sum;
}

// The weights of the upper half of the ordered sample, the largest value's first; those of the lower half are their
// negatives. Blom's scores of the normal, the outermost one or two replaced by Royston's polynomials, of unit length.
std::vector<double> weights(std::size_t n) {
  if (n == 3) return {std::numbers::sqrt2 / 2};
  const auto count = static_cast<double>(n);
  std::vector<double> weight(n / 2);
  double squares = 0;
  for (std::size_t i = 0; i < weight.size(); ++i) {
    weight[i] = -normal_quantile((static_cast<double>(i) + 0.625) / (count + 0.25));
    squares += 2 * weight[i] * weight[i];
  }
  const double u = 1 / std::sqrt(count);
  const double length = std::sqrt(squares);
  const double outer[] = {weight[0] / length + polynomial({0, 0.221157, -0.147981, -2.071190, 4.434685, -2.706056}, u),
                          weight[1] / length + polynomial({0, 0.042981, -0.293762, -1.752461, 5.682633, -3.582633}, u)};
  const std::size_t replaced = n > 5 ? 2 : 1;
  double outer_squares = 0;
  for (std::size_t i = 0; i < replaced; ++i) {
    squares -= 2 * weight[i] * weight[i];
    outer_squares += 2 * outer[i] * outer[i];
  }
  const double rest = std::sqrt(squares / (1 - outer_squares));
  for (std::size_t i = 0; i < weight.size(); ++i) weight[i] = i < replaced ? outer[i] : weight[i] / rest;
  return weight;
}

// Royston's normal transform of ln(1 - W); for three values the distribution is known (Shapiro and Wilk).
double upper_tail(double one_less_w, std::size_t n) {
  if (n == 3) {
    const double W = std::clamp(1 - one_less_w, 0.75, 1.0);
    return 6 / std::numbers::pi * (std::asin(std::sqrt(W)) - std::asin(std::sqrt(0.75)));
  }
  const auto count = static_cast<double>(n);
  double y = std::log(one_less_w), location = 0, scale = 0;
  if (n <= 11) {
    y = -std::log(polynomial({-2.273, 0.459}, count) - y);
    location = polynomial({0.5440, -0.39978, 0.025054, -0.0006714}, count);
    scale = std::exp(polynomial({1.3822, -0.77857, 0.062767, -0.0020322}, count));
  } else {
    location = polynomial({-1.5861, -0.31082, -0.083751, 0.0038915}, std::log(count));
    scale = std::exp(polynomial({-0.4803, -0.082676, 0.0030302}, std::log(count)));
  }
  return std::erfc((y - location) / scale / std::numbers::sqrt2) / 2;
}

}  // namespace

Test shapiro_wilk(std::span<const double> values) {
  Test test;
  const std::size_t n = values.size();
  if (n < fewest || n > most) {
    test.undefined = fmt::format("{} values; the test is for {} to {}", n, fewest, most);
  } else if (!all_finite(values)) {
    test.undefined = "a value is not finite";
  } else if (std::ranges::min(values) == std::ranges::max(values)) {
    test.undefined = "all values are equal";
  }
  if (!test.undefined.empty()) return test;

  std::vector<double> sorted(values.begin(), values.end());
  std::ranges::sort(sorted);
  const double middle = sorted[n / 2];  // W depends on neither place nor unit: 1e9 + 1 and 1e308 are no worse than 1
  const double unit = std::isfinite(sorted.back() - sorted.front()) ? 1.0 : 0.5;
  const double range = sorted.back() * unit - sorted.front() * unit;
  for (double& value : sorted) value = (value * unit - middle * unit) / range;

  const std::vector<double> weight = weights(n);
  const double centre = mean(sorted);
  const double length = std::sqrt(sum_of_squares(sorted));
  double one_less_w = 0;  // 1 - W = |direction - weight|^2 (1 + product) / 2, both of unit length: nothing cancels
  double product = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t from_end = std::min(i, n - 1 - i);
    const double size = from_end < weight.size() ? weight[from_end] : 0.0;
    const double own = i < n / 2 ? -size : size;
    const double direction = (sorted[i] - centre) / length;
    one_less_w += (direction - own) * (direction - own);
    product += direction * own;
  }
  one_less_w *= (1 + product) / 2;
  test.statistic = 1 - one_less_w;
  // For three values p would be 0 whatever they are: rounding, no evidence.
  if (n == fewest && (sorted[0] == sorted[1] || sorted[1] == sorted[2])) {
    test.undefined = "two of three values are equal";
    return test;
  }
  test.p = upper_tail(one_less_w, n);
  return test;
}

}  // namespace ikbench::statistics
