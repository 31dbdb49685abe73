// The verdict on two groups, shared by all comparisons.
#pragma once

#include <string_view>

namespace ikbench::inference {

// Relation of the first to the second. same: the difference is within the margin. undefined: no test could be made.
enum class Relation { better, worse, same, undecided, undefined };
std::string_view name_of(Relation relation);

constexpr bool is_difference(Relation relation) { return relation == Relation::better || relation == Relation::worse; }

// Returns the relation of the second to the first.
constexpr Relation reversed(Relation relation) {
  return relation == Relation::better ? Relation::worse : relation == Relation::worse ? Relation::better : relation;
}

}  // namespace ikbench::inference
