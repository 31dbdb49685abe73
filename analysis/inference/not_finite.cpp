#include "analysis/inference/not_finite.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/inference/margin.hpp"
#include "analysis/inference/text.hpp"

namespace ikbench::inference {

using namespace results;

namespace {

constexpr const char* contradiction = "its finite values and how many there are favour different sides";

bool is_number(double value) { return std::isfinite(value); }

// Replaces finite values by 1, others by 0.
Observations finiteness(Observations observations) {
  observations.better = Better::larger;
  observations.scale = ValueScale::plain;
  for (Group& group : observations.groups) {
    for (double& value : group.values) value = is_number(value) ? 1 : 0;
  }
  return observations;
}

// Doubles p, because each of two tests has half the level.
Finding doubled_contrast(const Observations& pair, const AnalysisPlan& plan) {
  Finding result = evidence(pair, plan).contrasts.front();
  if (!std::isnan(result.p)) result.p = std::min(1.0, 2 * result.p);
  return result;
}

}  // namespace

std::size_t count_not_finite(const Group& group) {
  return group.values.size() - static_cast<std::size_t>(std::ranges::count_if(group.values, is_number));
}

std::vector<std::string> notes_of_not_finite(const std::vector<Group>& groups) {
  std::vector<std::string> notes;
  for (const Group& group : groups) {
    const std::size_t count = count_not_finite(group);
    if (count == 0) continue;
    notes.push_back(fmt::format(
        "{}: {} of {} observations {} not finite and worse than any number; differences of means are those of "
        "finite observations.",
        one_line(group.name), count, group.values.size(), count == 1 ? "is" : "are"));
  }
  return notes;
}

Observations of_finite(const Observations& all) {
  Observations result = all;
  if (all.blocks.empty()) {
    for (Group& group : result.groups) std::erase_if(group.values, [](double value) { return !is_number(value); });
    return result;
  }
  result.blocks.clear();
  for (Group& group : result.groups) group.values.clear();
  for (std::size_t block = 0; block < all.blocks.size(); ++block) {
    if (!std::ranges::all_of(all.groups, [&](const Group& group) { return is_number(group.values[block]); })) continue;
    result.blocks.push_back(all.blocks[block]);
    for (std::size_t g = 0; g < all.groups.size(); ++g) result.groups[g].values.push_back(all.groups[g].values[block]);
  }
  return result;
}

Finding contrast_with_not_finite(const Observations& pair, const AnalysisPlan& planned) {
  AnalysisPlan plan = planned;
  plan.significance /= 2;
  Finding of_numbers = doubled_contrast(finiteness(pair), plan);
  const Observations finite = of_finite(pair);
  const bool has_values =
      std::ranges::all_of(finite.groups, [](const Group& group) { return group.values.size() > 1; });
  Finding of_values =
      has_values ? doubled_contrast(finite, plan) : Finding{.second = 1, .why = "too few values are finite"};
  const auto has_none = [](const Group& group) { return group.values.empty(); };
  if (of_values.relation == Relation::undefined && !std::ranges::all_of(finite.groups, has_none)) {
    if (!is_decided(of_numbers)) of_numbers.relation = Relation::undecided;
  } else if (!is_decided(of_numbers)) {
    const bool is_against = is_decided(of_values) && of_numbers.ahead != 0 && of_values.ahead != of_numbers.ahead;
    // The better one may have as many failures that were not seen.
    if (of_values.relation == Relation::same || is_against) of_values.relation = Relation::undecided;
    if (is_against) of_values.why = contradiction;
    return of_values;
  }
  // The level is fixed: otherwise a stricter plan could decide more.
  constexpr double level_of_conflict = 0.05;
  if (of_values.p < level_of_conflict && of_values.ahead == -of_numbers.ahead) {
    of_numbers.relation = Relation::undecided;
    of_numbers.why = contradiction;
  }
  of_numbers.estimate = {.value = of_values.estimate.value};
  put_beyond_any_margin(of_numbers);
  return of_numbers;
}

}  // namespace ikbench::inference
