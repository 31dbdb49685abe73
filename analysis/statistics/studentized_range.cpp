#include "analysis/statistics/studentized_range.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/special_functions/log1p.hpp>
#include <cmath>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::statistics {
namespace {

constexpr double largest_range = 50;  // beyond it the tail of the range is below 1e-265
constexpr double largest_k = 1000;

bool valid(double k, double df) { return k >= 2 && k <= largest_k && k == std::floor(k) && df >= 1; }

// Trapezoidal sum of a function of one peak over the whole line, outward from `start` until the terms vanish. For
// analytic functions that die out on both sides its error falls exponentially (Trefethen and Weideman, SIAM Review 56
// (2014) 385).
template <class Term>
double sum_over_the_line(double start, double step, Term term) {
  constexpr double negligible = 1e-15;
  double sum = term(start);
  for (const double direction : {step, -step}) {
    double previous = 0;
    for (int i = 1;; ++i) {
      const double value = term(start + i * direction);
      sum += value;
      if (value <= previous && value <= negligible * sum * std::min(1.0, step)) break;
      if (sum == 0 && i * step > 1) break;  // underflow
      previous = value;
    }
  }
  return step * sum;
}

double normal_cdf(double z) { return 0.5 * std::erfc(-z * boost::math::constants::one_div_root_two<double>()); }

// 1 - (1 - r)^n, by u(a + b) = u(a) + u(b) (1 - u(a)): nothing cancels if r is small.
double at_least_one(double r, int n) {
  double result = 0;
  for (double power = r; n > 0; n /= 2) {
    if (n % 2 == 1) result += power * (1 - result);
    power *= 2 - power;
  }
  return result;
}

// The range of k independent standard normal variables: P(range > w) = sum over the largest, z, of the chance that one
// of the others, all below z, is below z - w.
class NormalRange {
 public:
  explicit NormalRange(double k) : others_(static_cast<int>(k) - 1), step_(0.8 / (1 + std::log(k))) {
    usual_largest_ = boost::math::quantile(boost::math::normal(), 1 - 1 / k);
    for (int i = index(lowest); i <= index(highest); ++i) {
      const double z = i * step_;
      const double below = normal_cdf(z);
      const double density = boost::math::constants::one_div_root_two_pi<double>() * std::exp(-z * z / 2);
      largest_.push_back({.below = below, .density = k * density * std::pow(below, others_)});
    }
  }

  double tail(double w) const {
    if (w <= 0) return 1;
    if (w > largest_range) return 0;
    const double start = index(std::max(usual_largest_, w / 2)) * step_;
    const double sum = sum_over_the_line(start, step_, [&](double z) {
      if (z < lowest || z > highest) return 0.0;
      const auto& [below, density] = largest_[static_cast<std::size_t>(index(z) - index(lowest))];
      return density * at_least_one(std::min(1.0, normal_cdf(z - w) / below), others_);
    });
    return std::min(1.0, sum);
  }

 private:
  // The range of the largest: below, and above half the largest range and some, it has no share in any tail.
  static constexpr double lowest = -9;
  static constexpr double highest = largest_range / 2 + 9;

  struct Largest {
    double below = 0;    // the normal cdf at z
    double density = 0;  // of the largest of k
  };

  int index(double z) const { return static_cast<int>(std::lround(z / step_)); }

  int others_;
  double step_;  // the more groups, the sharper is the largest
  double usual_largest_ = 0;
  std::vector<Largest> largest_;  // at whole multiples of the step
};

// x - (e^2x - 1) / 2, to full relative precision for small x.
double log_density_shape(double x) {
  if (std::abs(x) < 0.1) return boost::math::log1pmx(std::expm1(2 * x)) / 2;
  return x - std::expm1(2 * x) / 2;
}

// Pieces of equal width in y, w = 4 sinh y: the tail of the range is the smoother the farther out.
constexpr int pieces = 9;
double piece_width() { return std::asinh(largest_range / 4) / pieces; }

}  // namespace

StudentizedRange::Table StudentizedRange::tabulated(int k) {
  const NormalRange range(k);
  const double n = static_cast<double>(terms);
  std::array<Piece, terms> cosines;  // of every node, which all pieces share
  for (std::size_t i = 0; i < terms; ++i) {
    const double angle = boost::math::constants::pi<double>() * (static_cast<double>(i) + 0.5) / n;
    for (std::size_t j = 0; j < terms; ++j) cosines[i][j] = std::cos(static_cast<double>(j) * angle);
  }
  Table table;
  for (int piece = 0; piece < pieces; ++piece) {
    Piece& coefficients = table.emplace_back();
    for (const Piece& node : cosines) {
      const double w = 4 * std::sinh((piece + 0.5 + 0.5 * node[1]) * piece_width());
      const double value = std::log(range.tail(w));
      for (std::size_t j = 0; j < terms; ++j) coefficients[j] += (j == 0 ? 1 : 2) / n * value * node[j];
    }
  }
  return table;
}

StudentizedRange::StudentizedRange(double k) : k_(k) {
  if (!valid(k, 1)) return;
  // Most comparisons are of few groups.
  static const std::array<Table, 5> of_few{tabulated(2), tabulated(3), tabulated(4), tabulated(5), tabulated(6)};
  const auto at = static_cast<std::size_t>(k - 2);
  table_ = at < of_few.size() ? of_few[at] : tabulated(static_cast<int>(k));
}

double StudentizedRange::range_tail(double w) const {
  if (w > largest_range) return 0;
  const double position = std::asinh(w / 4) / piece_width();
  const double piece = std::min(std::floor(position), pieces - 1.0);
  const double x = 2 * (position - piece) - 1;
  const Piece& coefficients = table_[static_cast<std::size_t>(piece)];
  double b1 = 0, b2 = 0;  // Clenshaw's recurrence
  for (std::size_t j = terms - 1; j > 0; --j) {
    const double b = 2 * x * b1 - b2 + coefficients[j];
    b2 = b1;
    b1 = b;
  }
  return std::exp(std::min(0.0, x * b1 - b2 + coefficients[0]));
}

double StudentizedRange::upper_tail(double q, double df) const {
  if (!valid(k_, df) || std::isnan(q)) return not_defined;
  if (q <= 0) return 1;
  constexpr double as_good_as_infinite = 1e15;
  if (df > as_good_as_infinite) return range_tail(q);
  if (std::isinf(q)) return 0;
  // Averages range_tail(q s) over s, the square root of chi-squared / df, summed over x = ln s.
  const double half = df / 2;
  const double scale = df * boost::math::gamma_p_derivative(half, half);
  const double step = std::min(0.16, 0.5 / (1 + std::log(k_))) / std::sqrt(1 + 2 * df / 9);
  const double start =
      -std::log(std::hypot(1.0, q / std::sqrt(df) * boost::math::constants::one_div_root_two<double>()));
  const double sum = sum_over_the_line(
      start, step, [&](double x) { return std::exp(df * log_density_shape(x)) * range_tail(q * std::exp(x)); });
  return std::min(1.0, scale * sum);
}

}  // namespace ikbench::statistics
