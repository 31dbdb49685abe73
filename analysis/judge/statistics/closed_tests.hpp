// Closed tests of paired groups with few blocks, where no pair could decide by itself after Bonferroni's correction, at
// the levels of Ryan, Einot, Gabriel and Welsch. A pair is decided if its own test and Friedman's test of every set of
// groups that has both are each below the level of their set. The levels hold the error where groups form several sets
// of alike ones, which the closure alone (Marcus, Peritz and Gabriel, Biometrika 63 (1976) 655) does not by plain
// levels. `compare_pairs` calls these functions. Costs 2^groups tests of Friedman, about 20 ms for twelve groups.
// docs/explanation/methods.md has the simulated error rates.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace ikbench::judge {

constexpr std::string_view closed_tests_name =
    "closed tests of Friedman and signed ranks at the levels of Ryan, Einot, Gabriel and Welsch";

// Returns whether closed tests are made of so many groups: of four to twelve. With three groups Bonferroni's pairs need
// as few blocks, because Friedman's approximate test of three groups in six blocks errs in 5.2 %.
bool may_be_closed(std::size_t groups);

// Returns the level of a set of `size` of the groups, by Ryan, Einot, Gabriel and Welsch (Welsch, J. Am. Stat. Assoc.
// 72 (1977) 566): the significance of all groups and of all but one; otherwise 1 - (1 - significance)^(size / groups).
double level_of_set(std::size_t size, std::size_t groups, double significance);
// Returns p, scaled so that it is below the significance if and only if p is below the level of its set.
double scaled_p(double p, std::size_t size, std::size_t groups);

// Returns for each pair, at [first * groups + second], the largest scaled p of Friedman's test of all sets of at least
// three groups that have both. Each group has one value for each block, in the order of the blocks.
std::vector<double> largest_p_of_sets(const std::vector<std::span<const double>>& groups);

}  // namespace ikbench::judge
