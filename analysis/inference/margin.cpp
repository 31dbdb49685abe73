#include "analysis/inference/margin.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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

double margin_of(const Evidence& evidence, const Contrast& contrast) {
  if (evidence.of_outcomes) return evidence.plan.margin;
  if (evidence.scale == ValueScale::log10) return std::log10(1 + evidence.plan.margin);
  const double smaller = std::min(std::abs(evidence.groups[contrast.first].described.mean),
                                  std::abs(evidence.groups[contrast.second].described.mean));
  const double relative = evidence.plan.margin * smaller;
  return has_absolute_margin(evidence) ? std::max(relative, evidence.margin) : relative;
}

namespace {

void refuse_negative(bool has_negative, std::string_view quantity, double absolute, const AnalysisPlan& plan) {
  if (!has_negative || plan.margin == 0 || absolute > 0) return;
  throw std::invalid_argument(
      fmt::format("{} has negative values, and {} of a mean that may be 0 means nothing; expected --margin-absolute "
                  "DIFFERENCE, in its unit, or --margin 0",
                  one_line(quantity), percent(plan.margin)));
}

bool is_negative(double value) { return std::isfinite(value) && value < 0; }

}  // namespace

void check_margin(const Observations& observations, const AnalysisPlan& plan) {
  if (observations.margin > 0 && are_outcomes(observations)) {
    throw std::invalid_argument(
        "all values are 0 or 1, whose margin is a difference of shares; expected --margin 5% for 5 percentage points, and "
        "no --margin-absolute");
  }
  const bool has_negative =
      observations.scale == ValueScale::plain && std::ranges::any_of(observations.groups, [](const Group& group) {
        return std::ranges::any_of(group.values, is_negative);
      });
  refuse_negative(has_negative, observations.quantity, observations.margin, plan);
}

void check_margin(const Summaries& summaries, const AnalysisPlan& plan) {
  const auto is_below = [](const SummaryGroup& group) { return is_negative(group.summary.mean); };
  refuse_negative(std::ranges::any_of(summaries.groups, is_below), summaries.quantity, summaries.margin, plan);
}

namespace {

// Extent of an interval on a scale where 0 is no difference.
Extent extent_of(const Estimate& interval, double room, Better better, int ahead) {
  const auto [value, low, high] = interval;
  if (!std::isfinite(low) || !std::isfinite(high) || std::isnan(room)) return Extent::unknown;
  if (std::abs(low) <= room && std::abs(high) <= room) return Extent::within;
  const int favours = better == Better::smaller ? -sign_of(value) : sign_of(value);
  if (sign_of(low) != sign_of(high) || favours != ahead) return Extent::unknown;
  return std::min(std::abs(low), std::abs(high)) > room ? Extent::beyond : Extent::across;
}

}  // namespace

Extent extent_of(const Evidence& evidence, const Contrast& contrast) {
  if (!evidence.ranks_decide()) {
    return extent_of(contrast.difference, margin_of(evidence, contrast), evidence.better, contrast.ahead);
  }
  // Ranks compare no means, and within blocks they have no scale: their margin is a ratio.
  const auto [value, low, high] = contrast.ratio;
  return extent_of({.value = std::log(value), .low = std::log(low), .high = std::log(high)},
                   std::log1p(evidence.plan.margin), evidence.better, contrast.ahead);
}

}  // namespace ikbench::inference
