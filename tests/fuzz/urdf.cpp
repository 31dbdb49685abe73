// A URDF file, and the tool where all joints are 0. What a file leaves open is left open.
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
