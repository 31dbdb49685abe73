// The names of the tests that a plan may choose. The tests themselves are in analysis/inference/methods/.
#pragma once

#include <span>
#include <string_view>

namespace ikbench::results {

// What a test has to know of its groups: means, standard deviations and sizes; every value; values in common blocks.
enum class Needs { summaries, values, blocks };

struct DecidingTest {
  std::string_view name;
  Needs needs;
  std::string_view meaning;
};

// In the order of deciding_tests.inc.
std::span<const DecidingTest> deciding_tests();
// std::invalid_argument where there is none of that name.
const DecidingTest& deciding_test(std::string_view name);

// The plan chooses by the design, before it sees data.
constexpr std::string_view by_design = "by_design";

// Of a plan's test; the design never chooses what it does not have.
bool needs_blocks(std::string_view test);

}  // namespace ikbench::results
