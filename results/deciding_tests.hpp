// The names of the tests that a plan may choose. analysis/inference/methods/ has the tests themselves.
#pragma once

#include <span>
#include <string_view>

namespace ikbench::results {

// The data that a test needs of its groups: means, standard deviations and sizes; or every value.
enum class Needs { summaries, values };

struct DecidingTest {
  std::string_view name;
  Needs needs;
};

// The tests in the order of deciding_tests.inc.
std::span<const DecidingTest> deciding_tests();
// Throws std::invalid_argument if there is no test of that name.
const DecidingTest& deciding_test(std::string_view name);

// The plan leaves the choice to the design, before it sees data.
constexpr std::string_view by_design = "by_design";

}  // namespace ikbench::results
