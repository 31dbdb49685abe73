// A URDF file, read with the default choices, and the tool with all joints at 0.
#include "robots/urdf.hpp"

#include "tests/fuzz/fuzz.hpp"

using namespace ikbench;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  read_or_refuse([&] {
    const robots::Robot arm = robots::parse_urdf(text_of(data, size), "fuzzed.urdf", {});
    arm.chain.forward(robots::Configuration::Zero(arm.joints()));
    arm.chain.reach();
  });
  return 0;
}
