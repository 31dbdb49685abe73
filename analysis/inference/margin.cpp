#include "analysis/inference/margin.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/inference/text.hpp"

namespace ikbench::inference {

using namespace statistics;

bool is_in_cm(std::string_view quantity) { return quantity.ends_with("[cm]") || quantity.ends_with("_cm"); }

bool has_absolute_margin(const Evidence& evidence) {
  return evidence.plan.margin_cm > 0 && is_in_cm(evidence.quantity) && evidence.scale == ValueScale::plain;
}

std::string margin_words(double margin, double margin_cm) {
  if (margin_cm == 0) return percent(margin);
  const std::string absolute = short_number(margin_cm) + " cm";
  return margin > 0 ? fmt::format("{} or {}", percent(margin), absolute) : absolute;
}

double margin_of(const Evidence& evidence, const Contrast& contrast) {
  if (evidence.of_outcomes) return evidence.plan.margin;
  if (evidence.scale == ValueScale::log10) return std::log10(1 + evidence.plan.margin);
  const double smaller = std::min(std::abs(evidence.groups[contrast.first].described.mean),
                                  std::abs(evidence.groups[contrast.second].described.mean));
  const double relative = evidence.plan.margin * smaller;
  return has_absolute_margin(evidence) ? std::max(relative, evidence.plan.margin_cm) : relative;
}

Extent extent_of(const Evidence& evidence, const Contrast& contrast) {
  const auto [value, low, high] = contrast.difference;
  const double room = margin_of(evidence, contrast);
  if (!std::isfinite(low) || !std::isfinite(high) || std::isnan(room)) return Extent::unknown;
  if (std::abs(low) <= room && std::abs(high) <= room) return Extent::within;
  const int favours = evidence.better == Better::smaller ? -sign_of(value) : sign_of(value);
  if (sign_of(low) != sign_of(high) || favours != contrast.ahead) return Extent::unknown;
  return std::min(std::abs(low), std::abs(high)) > room ? Extent::beyond : Extent::across;
}

}  // namespace ikbench::inference
