#include "analysis/inference/method.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "analysis/statistics/studentized_bootstrap.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

const std::array all_methods{
#define IKBENCH_DECIDING_TEST(name, needs) &name##_method,
#include "results/deciding_tests.inc"
#undef IKBENCH_DECIDING_TEST
    &bootstrap_within_blocks_method,
    &paired_t_method,
    &fisher_method,
    &mcnemar_method,
};

const Method& method_named(std::string_view name) {
  const auto found = std::ranges::find(all_methods, name, [](const Method* method) { return method->name; });
  if (found == all_methods.end()) throw std::invalid_argument(fmt::format("unknown test '{}'", name));
  return **found;
}

void refuse_missing(const Method& method, const Evidence& evidence) {
  const Needs needs = results::deciding_test(method.name).needs;
  if (needs == Needs::summaries || !evidence.from_summaries) return;
  std::vector<std::string_view> others;
  for (const DecidingTest& test : deciding_tests()) {
    if (test.needs == Needs::summaries) others.push_back(test.name);
  }
  throw std::invalid_argument(fmt::format("the {} test needs single values; expected one of these for summaries: {}",
                                          method.name, fmt::join(others, ", ")));
}

}  // namespace

std::span<const Method* const> methods() { return all_methods; }

const Method& method_for(const Evidence& evidence) {
  if (evidence.of_outcomes) return evidence.blocks > 0 ? mcnemar_method : fisher_method;
  const bool is_by_design = evidence.plan.test == by_design;
  if (is_by_design && evidence.from_summaries) return tamhane_method;
  const Method& method = is_by_design ? bootstrap_method : method_named(evidence.plan.test);
  refuse_missing(method, evidence);
  if (&method != &bootstrap_method) return method;
  const bool is_affordable = resamples_of(evidence) > 0;
  if (evidence.blocks > 0) return is_affordable ? bootstrap_within_blocks_method : paired_t_method;
  return is_affordable ? bootstrap_method : tamhane_method;
}

Compares compares(std::string_view test) { return test == by_design ? Compares::means : method_named(test).compares; }

std::vector<double> adjusted(std::span<const double> p) {
  std::vector<double> result(p.begin(), p.end());
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (std::isnan(p[i])) continue;
    if (p[i] < 0 || p[i] > 1) throw std::invalid_argument(fmt::format("p-value {}: expected 0 to 1", p[i]));
    order.push_back(i);
  }
  std::ranges::sort(order, {}, [&](std::size_t i) { return p[i]; });
  const double m = static_cast<double>(order.size());
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    double& value = result[order[rank]];
    value = std::min(1.0, (m - static_cast<double>(rank)) * value);
    // An adjusted p is never below that of a smaller p.
    if (rank > 0) value = std::max(value, result[order[rank - 1]]);
  }
  return result;
}

void correct(const Evidence& evidence, std::vector<double>& p) {
  std::vector<double> raw;
  for (const double each : p) raw.push_back(std::isnan(each) ? 1 : each);
  raw.resize(std::max(raw.size(), evidence.family()), 1);
  const std::vector<double> corrected = adjusted(raw);
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (!std::isnan(p[i])) p[i] = corrected[i];
  }
}

void correct(const Evidence& evidence, std::vector<Finding>& pairs) {
  std::vector<double> p;
  for (const Finding& pair : pairs) p.push_back(pair.p_alone);
  correct(evidence, p);
  for (std::size_t i = 0; i < p.size(); ++i) pairs[i].p = p[i];
}

std::vector<Finding> of_means(const Evidence& evidence, const std::vector<MeanDifference>& differences) {
  const int sign = evidence.better == Better::smaller ? -1 : 1;
  std::vector<Finding> result;
  for (const MeanDifference& each : differences) {
    result.push_back({.p = each.p,
                      .p_alone = each.p_alone,
                      .ahead = sign * sign_of(each.difference.value),
                      .estimate = each.difference,
                      .why = each.undefined,
                      .lacks_spread = each.lacks_spread});
  }
  return result;
}

int resamples_of(const Evidence& evidence) {
  const double level = 1 - evidence.plan.significance;
  if (evidence.blocks > 0) {
    const std::size_t pairs = evidence.groups.size() * (evidence.groups.size() - 1) / 2;
    return affordable_resamples(evidence.blocks * pairs, evidence.groups.size(), level);
  }
  std::size_t values = 0;
  for (const GroupEvidence& group : evidence.groups) values += static_cast<std::size_t>(group.described.n);
  return affordable_resamples(values, evidence.groups.size(), level);
}

}  // namespace ikbench::inference
