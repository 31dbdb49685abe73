#include "analysis/inference/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/inference/comparable.hpp"
#include "analysis/inference/design.hpp"
#include "analysis/inference/estimand.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

// Adds a solver to its family; not if it was swept by other settings than the family's first.
void add_member(SweptFamily& family, const std::string& label, const SweptEntry& entry) {
  if (family.settings.empty()) {
    for (const auto& [name, value] : entry.settings) family.settings.push_back({.name = name});
  }
  const bool is_alike = std::ranges::equal(family.settings, entry.settings, {}, &SweptFamily::Setting::name,
                                           [](const auto& setting) { return setting.first; });
  if (!is_alike) return;
  SweptFamily::Member member{.label = label, .at = {}};
  for (SweptFamily::Setting& setting : family.settings) {
    const std::string& value = entry.settings.at(setting.name);
    const auto known = std::ranges::find(setting.values, value);
    member.at.push_back(static_cast<std::size_t>(known - setting.values.begin()));
    if (known == setting.values.end()) setting.values.push_back(value);
  }
  family.members.push_back(std::move(member));
}

// The observations of the members with these two values: the averages over their other settings, observation by
// observation; none if they differ in number.
std::vector<double> cell_of(const SweptFamily& family, const SweptQuantity& quantity, const SettingsInteraction& pair,
                            std::size_t first, std::size_t second) {
  std::vector<double> sums;
  double members = 0;
  for (const SweptFamily::Member& member : family.members) {
    if (member.at[pair.first] != first || member.at[pair.second] != second) continue;
    const Group* group = group_named(quantity.observations.groups, member.label);
    if (group == nullptr || (members > 0 && group->values.size() != sums.size())) return {};
    sums.resize(group->values.size());
    std::ranges::transform(sums, group->values, sums.begin(), std::plus());
    ++members;
  }
  for (double& sum : sums) sum /= members;
  return sums;
}

}  // namespace

std::vector<SweptFamily> swept_families(const StudyResults& study) {
  std::vector<SweptFamily> families;
  for (const std::string& solver : study.solvers) {
    const auto entry = study.facts.swept.find(solver);
    if (entry == study.facts.swept.end()) continue;
    auto family = std::ranges::find(families, entry->second.family, &SweptFamily::name);
    if (family == families.end()) family = families.insert(family, {.name = entry->second.family});
    add_member(*family, solver, entry->second);
  }
  return families;
}

Estimate SweptQuantity::of(const std::string& label) const {
  const GroupEvidence* const found = group_named(evidence.groups, label);
  return found == nullptr ? Estimate() : found->mean;
}

bool SweptQuantity::is_better(double one, double other) const {
  return evidence.better == Better::smaller ? one < other : one > other;
}

std::vector<SweptFamily> with_values(std::vector<SweptFamily> families, const SweptQuantity& quantity) {
  std::erase_if(families, [&](const SweptFamily& family) {
    return std::ranges::none_of(family.members, [&](const SweptFamily::Member& member) {
      return std::isfinite(quantity.of(member.label).value);
    });
  });
  return families;
}

std::vector<SweptQuantity> swept_quantities(const StudyResults& study, const std::vector<Metric>& metrics) {
  std::vector<SweptQuantity> quantities;
  const auto add = [&](Metric metric, Estimand estimand) {
    SweptQuantity quantity{.observations = observations(study, metric, estimand), .evidence = {}};
    quantity.evidence = described(quantity.observations, feasible(study.plan, quantity.observations));
    quantities.push_back(std::move(quantity));
  };
  if (primary_estimand(study) == Estimand::reliability) add(Metric::position_error_cm, Estimand::reliability);
  for (const Metric metric : metrics) {
    if (is_comparable(study, metric)) add(metric, average_estimand(metric));
  }
  std::erase_if(quantities, [families = swept_families(study)](const SweptQuantity& quantity) {
    return with_values(families, quantity).empty();
  });
  return quantities;
}

std::vector<SettingsInteraction> interactions(const SweptFamily& family, const SweptQuantity& quantity) {
  std::vector<SettingsInteraction> all;
  const bool has_blocks = !quantity.observations.blocks.empty(),
             is_log = quantity.observations.scale == ValueScale::log10;
  for (std::size_t first = 0; first < family.settings.size(); ++first) {
    for (std::size_t second = first + 1; second < family.settings.size(); ++second) {
      SettingsInteraction pair{.first = first, .second = second};
      const std::size_t rows = family.settings[first].values.size(), columns = family.settings[second].values.size();
      std::vector<std::vector<double>> cells;
      for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column < columns; ++column)
          cells.push_back(cell_of(family, quantity, pair, row, column));
      }
      const bool is_whole = std::ranges::all_of(cells, [&](const std::vector<double>& cell) {
        return !cell.empty() && (!has_blocks || cell.size() == cells.front().size());
      });
      if (is_whole) {
        pair.found = interaction(cells, columns, has_blocks ? Cells::in_blocks : Cells::independent,
                                 1 - quantity.evidence.plan.significance);
      } else {
        pair.found.undefined = "some combinations have no observations, or another number of them";
      }
      pair.depends = pair.found.p < quantity.evidence.plan.significance;
      Estimate& corners = pair.found.corners;
      for (double* end : {&corners.value, &corners.low, &corners.high}) *end = is_log ? std::pow(10, *end) : *end;
      all.push_back(std::move(pair));
    }
  }
  return all;
}

}  // namespace ikbench::inference
