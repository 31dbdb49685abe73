#include "analysis/statistics/mean_ratio.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "analysis/statistics/rounding.hpp"
#include "analysis/statistics/t_distribution.hpp"
#include "analysis/statistics/tails.hpp"

namespace ikbench::statistics {
namespace {

void check(const RatioQuestion& question) {
  if (!(question.margin >= 0 && question.margin < 1)) {
    throw std::invalid_argument(fmt::format("margin {}: expected 0 to 1, without 1", question.margin));
  }
  if (!(question.absolute_margin >= 0)) {
    throw std::invalid_argument(fmt::format("absolute margin {}: expected 0 or more", question.absolute_margin));
  }
  check_level(question.level);
}

// An estimate of mean(b) - theta mean(a) - offset.
struct Contrast {
  double estimate = 0;
  double error = 0;  // its standard error
  double df = 0;
};

// Without spread, a difference that rounding alone can make of values of this size is none.
Contrast exact(Contrast contrast, double size) {
  contrast.error = without_rounding(contrast.error, size);
  if (contrast.error == 0) contrast.estimate = without_rounding(contrast.estimate, size);
  return contrast;
}

// P(such an estimate or a larger one) where the truth is 0. Without spread it is a fact.
double chance_above(const Contrast& contrast) {
  if (contrast.error > 0) return t_upper_tail(contrast.estimate / contrast.error, contrast.df);
  return contrast.estimate > 0 ? 0 : 1;
}

double chance_below(const Contrast& contrast) {
  return chance_above({.estimate = -contrast.estimate, .error = contrast.error, .df = contrast.df});
}

// The theta, from the ratio outwards in the direction of `step`, at which a one-sided test with the tail `alpha` turns.
template <class ContrastAt>
double bound(ContrastAt contrast_at, double ratio, double step, double alpha) {
  const auto excess = [&](double theta) {  // rises from negative where theta leaves the ratio
    const Contrast contrast = contrast_at(theta);
    return std::min(std::abs(contrast.estimate) / contrast.error, 1e100) + t_quantile(alpha, contrast.df);
  };
  double inner = ratio, at_inner = excess(ratio);
  if (at_inner >= 0) return ratio;  // a level so low that rounding is all of the interval
  for (; std::isfinite(step); step *= 2) {
    const double outer = ratio + step, at_outer = excess(outer);
    if (at_outer >= 0) {
      std::uintmax_t evaluations = 200;
      const boost::math::tools::eps_tolerance<double> enough(48);
      const auto [low, high] =
          outer > inner
              ? boost::math::tools::toms748_solve(excess, inner, outer, at_inner, at_outer, enough, evaluations)
              : boost::math::tools::toms748_solve(excess, outer, inner, at_outer, at_inner, enough, evaluations);
      return (low + high) / 2;
    }
    inner = outer;
    at_inner = at_outer;
  }
  return not_defined;
}

// The tests and the interval of a family of contrasts; `a_alone` is the mean of a itself.
template <class ContrastAt>
RatioComparison compare(ContrastAt contrast_at, const Contrast& a_alone, const RatioQuestion& question) {
  RatioComparison result;
  const Contrast same = contrast_at(1);
  if (!std::isfinite(same.estimate) || !std::isfinite(same.error) || !std::isfinite(a_alone.error)) {
    result.undefined = "the values are too large for double precision";
    return result;
  }
  result.df = same.error > 0 ? same.df : not_defined;
  result.p_difference = same.error > 0       ? 2 * std::min(chance_above(same), chance_below(same))
                        : same.estimate == 0 ? 1
                                             : 0;
  if (question.absolute_margin > 0) {
    const Contrast above = contrast_at(1, question.absolute_margin), below = contrast_at(1, -question.absolute_margin);
    result.p_above = chance_above(above);
    result.p_below = chance_below(below);
    result.p_equivalent = std::max(chance_below(above), chance_above(below));
  }
  if (!(a_alone.estimate > 0)) {
    result.undefined = "the mean of the first sample is not positive, so there is no ratio to it";
    return result;
  }
  const double ratio = contrast_at(0).estimate / a_alone.estimate;
  if (!std::isfinite(ratio)) {
    result.undefined = "the ratio is too large for double precision";
    return result;
  }
  result.ratio = ratio;
  const Contrast above = contrast_at(1 + question.margin), below = contrast_at(1 - question.margin);
  result.p_above = std::fmax(result.p_above, chance_above(above));  // NaN without an absolute margin
  result.p_below = std::fmax(result.p_below, chance_below(below));
  result.p_equivalent = std::fmin(result.p_equivalent, std::max(chance_below(above), chance_above(below)));
  const double alpha = (1 - question.level) / 2;
  const Contrast at_ratio = contrast_at(result.ratio);
  if (!(at_ratio.error > 0)) {  // every ratio but this one is refuted
    result.low = result.high = result.ratio;
  } else if (a_alone.estimate > -t_quantile(alpha, a_alone.df) * a_alone.error) {
    const double step = at_ratio.error / a_alone.estimate;
    result.low = bound(contrast_at, result.ratio, -step, alpha);
    result.high = bound(contrast_at, result.ratio, step, alpha);
    if (std::isnan(result.low) || std::isnan(result.high)) result.low = result.high = not_defined;
  }
  return result;
}

bool all_finite(std::span<const double> values) {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

// Why two samples cannot be compared; empty where they can.
std::string obstacle(std::span<const double> a, std::span<const double> b) {
  if (a.size() < 2 || b.size() < 2) return "a sample of fewer than two values has no spread";
  if (!all_finite(a) || !all_finite(b)) return "a value is not finite";
  return {};
}

Contrast of_sample(std::span<const double> values) {
  return {.estimate = mean(values), .error = standard_error(values), .df = static_cast<double>(values.size()) - 1};
}

}  // namespace

RatioComparison mean_ratio(std::span<const double> a, std::span<const double> b, const RatioQuestion& question) {
  check(question);
  if (std::string reason = obstacle(a, b); !reason.empty()) return {.undefined = reason};
  const Contrast of_a = of_sample(a), of_b = of_sample(b);
  const auto contrast_at = [&](double theta, double offset = 0) {
    const double a_error = std::abs(theta) * of_a.error;
    const double error = std::hypot(a_error, of_b.error);
    const double a_part = error > 0 ? std::pow(a_error / error, 4) : 1;
    const double b_part = error > 0 ? std::pow(of_b.error / error, 4) : 1;
    const double df = 1 / (a_part / of_a.df + b_part / of_b.df);
    const double of_theta_a = theta * of_a.estimate;
    return exact({.estimate = of_b.estimate - of_theta_a - offset, .error = error, .df = df},
                 std::max(std::abs(of_b.estimate), std::abs(of_theta_a)));
  };
  RatioComparison result = compare(contrast_at, of_a, question);
  if (of_a.error == 0 && of_b.error == 0) result.exact = "both samples are constant";
  return result;
}

RatioComparison paired_mean_ratio(std::span<const double> a, std::span<const double> b, const RatioQuestion& question) {
  check(question);
  if (a.size() != b.size()) {
    throw std::invalid_argument(fmt::format("pairs of {} and {} values: expected equally many", a.size(), b.size()));
  }
  if (std::string reason = obstacle(a, b); !reason.empty()) return {.undefined = reason};
  std::vector<double> rest(a.size());
  const auto contrast_at = [&](double theta, double offset = 0) {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      rest[i] = b[i] - theta * a[i] - offset;
      largest = std::max({largest, std::abs(b[i]), std::abs(theta * a[i])});
    }
    return exact(of_sample(rest), largest);
  };
  const Contrast same = contrast_at(1);
  RatioComparison result = compare(contrast_at, of_sample(a), question);
  if (same.error == 0) result.exact = same.estimate == 0 ? "all pairs are equal" : "all pairs differ by the same";
  return result;
}

}  // namespace ikbench::statistics
