#include "results/deciding_tests.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace ikbench::results {

namespace {

constexpr std::array tests{
#define IKBENCH_DECIDING_TEST(name, needs) DecidingTest{#name, Needs::needs},
#include "results/deciding_tests.inc"
#undef IKBENCH_DECIDING_TEST
};

}  // namespace

std::span<const DecidingTest> deciding_tests() { return tests; }

const DecidingTest& deciding_test(std::string_view name) {
  const auto found = std::ranges::find(tests, name, &DecidingTest::name);
  if (found == tests.end()) throw std::invalid_argument("unknown test '" + std::string(name) + "'");
  return *found;
}

}  // namespace ikbench::results
