// A path of poses from a CSV file.
#include "experiments/pose_csv.hpp"
#include "tests/fuzz/fuzz.hpp"

using namespace ikbench;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  read_or_refuse([&] { experiments::poses_from_csv(text_of(data, size), "fuzzed.csv"); });
  return 0;
}
