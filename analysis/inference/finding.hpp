// A finding: the result of comparing two, as a row of plain data, for every quantity and method. Reports, comparisons
// of variants and claims read the same rows.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::inference {

using statistics::Estimate;

// Relation of the first to the second. same: the difference is within the margin. undefined: no test could be made.
enum class Relation { better, worse, same, undecided, undefined };
std::string_view name_of(Relation relation);

constexpr bool is_difference(Relation relation) { return relation == Relation::better || relation == Relation::worse; }

// Returns the relation of the second to the first.
constexpr Relation reversed(Relation relation) {
  return relation == Relation::better ? Relation::worse : relation == Relation::worse ? Relation::better : relation;
}

struct Finding {
  std::size_t first = 0, second = 0;         // of the evidence's groups, or of the study's solvers
  double p = statistics::not_defined;        // corrected for the family; not defined where the interval decides
  double p_alone = statistics::not_defined;  // the same for this pair alone
  int ahead = 0;                             // direction of the deciding test: 1 favours first, -1 second
  bool is_ratio = false;                     // true: the estimate is first / second; false: first - second
  Estimate estimate = {};                    // its interval holds for all pairs of the family together
  Relation relation = Relation::undefined;
  statistics::Reason why = {};  // the reason for the relation, or why there is no test; else empty
  bool is_fact = false;         // both values are known, so that no chance is in the relation
  // The groups do not overlap, and an exact rank test decides (within blocks, or against a known value, the sign test),
  // because a group has one value only or the bootstrap has no spread to judge by.
  bool is_by_order = false;
  bool lacks_spread = false;  // the test has no p because the values are too alike: undecided
  Estimate superiority = {};  // A12: the chance that an observation of first is better than one of second
  // Typical ratio first / second, defined if ranks decide and all values have one sign: Hodges and Lehmann's estimate,
  // with the interval of Mann and Whitney's test.
  Estimate ratio = {};
  double g = statistics::not_defined;  // Hedges' g; positive if the mean of first is larger
  // The sizes that the interval holds, beside the plan's margin. `low` is not defined if the interval does not favour
  // the better group.
  Estimate size = {};
  double margin = statistics::not_defined;

  bool is_within_margin() const { return size.high <= margin; }
  bool is_beyond_margin() const { return size.low > margin; }
  // Its interval favours the better group, and lies on both sides of the margin.
  bool is_across_margin() const { return size.low <= margin && size.high > margin; }
};

// Pairs with first < second, in order; `only_with` keeps the pairs with that group.
std::vector<Finding> unjudged_pairs(std::size_t groups, std::optional<std::size_t> only_with);
constexpr std::size_t most_groups_in_pairs = 20;  // of more groups, those with the best are compared alone

// Returns whether one of the two is better.
inline bool is_decided(const Finding& finding) { return is_difference(finding.relation); }

// Returns second - first from first - second, or second / first from first / second.
Estimate reversed(const Estimate& estimate, bool is_ratio);
// Returns the same finding with first and second swapped.
Finding reversed(Finding finding);

// The finding on two, in this order; nullopt if they are not compared.
std::optional<Finding> finding_of(std::span<const Finding> findings, std::size_t first, std::size_t second);

}  // namespace ikbench::inference
