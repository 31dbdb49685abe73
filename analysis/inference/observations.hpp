// The input of the statistics: observations of one quantity in groups, from a store or a user's CSV, or published
// summaries of them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/inference/doubt.hpp"
#include "analysis/statistics/descriptive.hpp"

namespace ikbench::inference {

enum class Better { smaller, larger };

// log10: values are logarithms; reports show their means as geometric means, and differences of means as ratios.
// share: values are shares from 0 to 1; a difference and its margin are percentage points.
enum class ValueScale { plain, log10, share };

struct Group {
  std::string name;
  std::vector<double> values = {};
  // Decades that the averaged single values span (statistics::decades); not defined if `values` are single values.
  double decades = statistics::not_defined;
  // Number of runs that all gave this one value, because the solver repeats its answers; 0 if values vary. Such a value
  // is known exactly.
  int copies = 0;
  std::size_t bits = 0;           // groups with one number have the same bits in every solve; 0 if no other group has
  std::optional<int> style = {};  // a solver's line style in figures; else by its place
  // All that is known of a group where only its summary was published; `values` are empty then.
  std::optional<statistics::GroupSummary> summary = {};
};

// The group of that name; null if there is none.
template <class AnyGroup>
const AnyGroup* group_named(const std::vector<AnyGroup>& groups, std::string_view name) {
  const auto found = std::ranges::find(groups, name, &AnyGroup::name);
  return found == groups.end() ? nullptr : &*found;
}

// Returns whether no chance is in the difference of two groups: both are known, or they have the same bits.
template <class AnyGroup>
bool is_fact(const AnyGroup& first, const AnyGroup& second) {
  return (first.copies > 0 && second.copies > 0) || (first.bits > 0 && first.bits == second.bits);
}

// Gives groups with the same bits one number; `are_same` compares an earlier group with a later one.
template <class AreSame>
void mark_same_bits(std::vector<Group>& groups, AreSame are_same) {
  for (std::size_t i = 0; i < groups.size(); ++i) {
    for (std::size_t other = 0; other < i && groups[i].bits == 0; ++other) {
      if (are_same(groups[other], groups[i])) groups[i].bits = groups[other].bits = other + 1;
    }
  }
}

struct Observations {
  std::string name;       // of files and anchors: "error", "variation"; lower-case letters, digits and '-'
  std::string quantity;   // with its unit in brackets: "position error [cm]"
  std::string unit = {};  // unit of the values; empty if none or unknown
  Better better = Better::smaller;
  ValueScale scale = ValueScale::plain;
  std::vector<Group> groups = {};  // values may be infinite, or NaN if a solver diverged
  // Names of the blocks (targets, problems) that all groups share: values[i] of each group belongs to blocks[i]. Empty
  // if groups are independent samples.
  std::vector<std::string> blocks = {};
  std::string replicate = {};              // one observation in words: "a run's mean over its 20 points"
  std::string block = {};                  // one block in words; empty if there are none
  std::string block_noun = "blocks";       // plural for sentences: "targets"
  std::vector<std::string> counting = {};  // how failures and small values count
  std::vector<std::string> notes = {};     // missing values, incomplete blocks left out, times that are not clean, ...
  double margin = 0;                       // absolute, in the unit of the values; 0: the plan's margin only
  Doubts flaws = {};  // reasons to doubt them: no replicates, missing values, times that are not clean

  bool are_summaries() const {
    return std::ranges::any_of(groups, [](const Group& group) { return group.summary.has_value(); });
  }
};

}  // namespace ikbench::inference
