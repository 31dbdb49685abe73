// An arm file, and the tool with all joints in the middle.
#include "robots/robot.hpp"
#include "tests/fuzz/fuzz.hpp"

using namespace ikbench;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  read_or_refuse([&] {
    const robots::Robot arm = robots::parse_robot(text_of(data, size), "fuzzed.toml");
    arm.chain.forward(robots::Configuration::Zero(arm.joints()));
    arm.chain.reach();
  });
  return 0;
}
