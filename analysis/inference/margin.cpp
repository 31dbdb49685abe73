#include "analysis/inference/margin.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "analysis/inference/outcomes.hpp"
#include "analysis/inference/text.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

bool has_absolute_margin(const Evidence& evidence) {
  return evidence.margin > 0 && evidence.scale == ValueScale::plain;
}

std::string margin_words(double margin, double absolute_margin, std::string_view unit) {
  if (absolute_margin == 0) return percent(margin);
  const std::string absolute = short_number(absolute_margin) + std::string(unit);
  return margin > 0 ? fmt::format("{} or {}", percent(margin), absolute) : absolute;
}

double margin_of(const Evidence& evidence, const Finding& contrast) {
  if (evidence.scale == ValueScale::share) return evidence.plan.margin;
  if (evidence.scale == ValueScale::log10) return std::log10(1 + evidence.plan.margin);
  const double first = std::abs(evidence.groups[contrast.first].described.mean),
               second = std::abs(evidence.groups[contrast.second].described.mean);
  const double smaller = std::isnan(first) ? first : std::min(second, first);  // NaN if either mean is
  const double relative = evidence.plan.margin * smaller;
  return has_absolute_margin(evidence) ? std::fmax(relative, evidence.margin) : relative;
}

void check_margin(const Observations& observations, const AnalysisPlan& plan) {
  if (observations.margin > 0 && are_outcomes(observations)) {
    throw std::invalid_argument(
        "all values are 0 or 1, whose margin is a difference of shares; expected --margin 5% for 5 percentage points, and "
        "no --margin-absolute");
  }
  if (observations.scale != ValueScale::plain || plan.margin == 0 || observations.margin > 0) return;
  const auto is_negative = [](double value) { return std::isfinite(value) && value < 0; };
  const bool has_negative = std::ranges::any_of(observations.groups, [&](const Group& group) {
    return std::ranges::any_of(group.values, is_negative) || (group.summary && is_negative(group.summary->mean));
  });
  if (!has_negative) return;
  throw std::invalid_argument(
      fmt::format("{} has negative values, and {} of a mean that may be 0 means nothing; expected --margin-absolute "
                  "DIFFERENCE, in its unit, or --margin 0",
                  one_line(observations.quantity), percent(plan.margin)));
}

void measure_extent(const Evidence& evidence, Finding& contrast) {
  const bool is_of_ranks = evidence.ranks_decide();  // ranks compare no means, and within blocks they have no scale
  const Estimate& of = is_of_ranks ? contrast.ratio : contrast.estimate;
  const auto scaled = [&](double value) { return is_of_ranks ? std::log(value) : value; };
  const double value = scaled(of.value), low = scaled(of.low), high = scaled(of.high);
  const double margin = is_of_ranks ? std::log1p(evidence.plan.margin) : margin_of(evidence, contrast);
  contrast.size = {};
  if (!std::isfinite(low) || !std::isfinite(high) || std::isnan(margin)) return;
  contrast.size = {.value = std::abs(value), .high = std::max(std::abs(low), std::abs(high))};
  contrast.margin = margin;
  const int favours = evidence.better == Better::smaller ? -sign_of(value) : sign_of(value);
  if (sign_of(low) == sign_of(high) && favours == contrast.ahead) {
    contrast.size.low = std::min(std::abs(low), std::abs(high));
  }
}

void put_beyond_any_margin(Finding& contrast) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  contrast.size = {.value = infinite, .low = infinite, .high = infinite};
  contrast.margin = 0;
}

}  // namespace ikbench::inference
