#include "analysis/report/benchmark_json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "analysis/inference/metrics.hpp"
#include "analysis/report/json.hpp"

namespace ikbench::report {

using namespace inference;

namespace {

using TakeMean = std::function<void(const std::string& label, const MetricInfo& metric, const Estimate& mean)>;

// Visits each mean that is a number.
void each_mean(const JudgedStudy& study, const TakeMean& take) {
  for (const Metric metric : compared_metrics()) {
    for (const GroupEvidence& group : study.evidence(metric).groups) {
      if (std::isfinite(group.mean.value)) take(group.name, info_of(metric), group.mean);
    }
  }
}

// The share of what the metric does not count.
Estimate rest(const Estimate& share) {
  return {.value = 1 - share.value, .low = 1 - share.high, .high = 1 - share.low};
}

}  // namespace

std::string benchmark_json(const JudgedStudy& study) {
  Json all = Json::array();
  each_mean(study, [&](const std::string& label, const MetricInfo& metric, const Estimate& mean) {
    const bool is_turned = metric.better == Better::larger;
    const Estimate shown = is_turned ? rest(mean) : mean;
    Json entry{{"name", fmt::format("{}: {}{}", label, is_turned ? "1 - " : "", metric.name)},
               {"unit", metric.unit},
               {"value", shown.value}};
    if (std::isfinite(shown.low)) entry["range"] = fmt::format("{:.4g} to {:.4g}", shown.low, shown.high);
    all.push_back(std::move(entry));
  });
  return numerics::text_of(all) + '\n';
}

std::string bencher_json(const JudgedStudy& study) {
  Json all = Json::object();
  each_mean(study, [&](const std::string& label, const MetricInfo& metric, const Estimate& mean) {
    Json& entry = all[label][std::string(metric.slug)];
    entry["value"] = mean.value;
    if (!std::isfinite(mean.low) || !std::isfinite(mean.high)) return;
    entry["lower_value"] = mean.low;
    entry["upper_value"] = mean.high;
  });
  return numerics::text_of(all) + '\n';
}

}  // namespace ikbench::report
