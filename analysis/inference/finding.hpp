// The result of one comparison of two, as plain data, for every quantity and method.
#pragma once

#include <span>
#include <string>
#include <string_view>

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
  std::string quantity;
  std::string first, second;
  bool is_ratio = false;               // true: the estimate is first / second; false: first - second
  Estimate estimate = {};              // its interval holds for all pairs of the family together
  double p = statistics::not_defined;  // corrected for the family; not defined where the interval decides
  std::string method = {};
  Relation relation = Relation::undefined;
  bool is_fact = false;  // both values are known, so that no chance is in the relation
  std::string why = {};  // the reason for the relation, or why there is no test; else empty
};

// Returns second - first from first - second, or second / first from first / second.
Estimate reversed(const Estimate& estimate, bool is_ratio);
// Returns the same finding with first and second swapped.
Finding reversed(Finding finding);

// The finding on a quantity and two names, in this order. Throws std::out_of_range if there is none.
Finding finding_of(std::span<const Finding> findings, std::string_view quantity, std::string_view first,
                   std::string_view second);

}  // namespace ikbench::inference
