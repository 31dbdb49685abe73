#include "analysis/statistics/tails.hpp"

#include <fmt/format.h>

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <exception>
#include <limits>
#include <stdexcept>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::statistics {

namespace {

// Boost computes in long double by default, which takes several times as long for digits that nobody sees.
using Plain = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
using StudentsT = boost::math::students_t_distribution<double, Plain>;

}  // namespace

double normal_two_sided(double z) { return std::erfc(std::abs(z) / std::sqrt(2.0)); }

double normal_quantile(double p) {
  if (!(p >= 0 && p <= 1)) return not_defined;
  if (p == 0) return -std::numeric_limits<double>::infinity();
  if (p == 1) return std::numeric_limits<double>::infinity();
  return boost::math::quantile(boost::math::normal(), p);
}

double normal_critical(double level) {
  check_level(level);
  return -normal_quantile((1 - level) / 2);
}

double t_upper_tail(double t, double df) {
  if (std::isnan(t) || !(df > 0)) return not_defined;
  if (std::isinf(t)) return t > 0 ? 0 : 1;
  return boost::math::cdf(boost::math::complement(StudentsT(df), t));
}

double t_quantile(double p, double df) {
  if (!(p > 0 && p < 1) || !(df > 0)) return not_defined;
  try {
    return boost::math::quantile(StudentsT(df), p);
  } catch (const std::exception&) {  // overflow: a tail too small for so few degrees of freedom
    return not_defined;
  }
}

double chi_squared_upper_tail(double x, double df) {
  if (!std::isfinite(x) || x < 0 || !(df >= 1)) return not_defined;
  return boost::math::cdf(boost::math::complement(boost::math::chi_squared(df), x));
}

void check_level(double level) {
  if (!(level > 0 && level < 1)) {
    throw std::invalid_argument(fmt::format("confidence level {}: expected more than 0 and less than 1", level));
  }
}

}  // namespace ikbench::statistics
