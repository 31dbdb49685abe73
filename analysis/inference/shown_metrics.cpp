#include "analysis/inference/shown_metrics.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

namespace ikbench::inference {

namespace {

enum class Telling { differs, is_equal, is_undefined };

Telling telling(const StudyResults& study, Metric metric) {
  std::vector<double> values;
  for (const Sample& sample : samples(study, metric)) {
    std::ranges::copy_if(sample.values, std::back_inserter(values), [](double value) { return !std::isnan(value); });
  }
  if (values.empty()) return Telling::is_undefined;
  const auto [least, most] = std::ranges::minmax(values);
  const double rounding = info_of(metric).rounding;
  const bool is_none = std::fabs(least) <= rounding && std::fabs(most) <= rounding;
  return is_none || (values.size() > 1 && least == most) ? Telling::is_equal : Telling::differs;
}

}  // namespace

ShownMetrics shown_metrics(const StudyResults& study) {
  ShownMetrics shown{.judged = reported_metrics(), .listed = {}, .left_out = ""};
  if (!study.facts.published.empty()) return shown;
  std::vector<std::string_view> equal, undefined;
  for (const Metric metric : all_metrics()) {
    const MetricInfo& info = info_of(metric);
    if (info.shown != ShownIn::where_it_tells && info.shown != ShownIn::in_tables) continue;
    const Telling found = telling(study, metric);
    if (found == Telling::is_equal) equal.push_back(info.name);
    if (found == Telling::is_undefined) undefined.push_back(info.name);
    if (found == Telling::differs) (info.shown == ShownIn::in_tables ? shown.listed : shown.judged).push_back(metric);
  }
  std::vector<std::string> parts;
  if (!equal.empty()) parts.push_back(fmt::format("{} (always the same)", fmt::join(equal, ", ")));
  if (!undefined.empty()) parts.push_back(fmt::format("{} (no meaning in this study)", fmt::join(undefined, ", ")));
  if (!parts.empty()) shown.left_out = fmt::format("Left out: {}.", fmt::join(parts, "; "));
  return shown;
}

}  // namespace ikbench::inference
