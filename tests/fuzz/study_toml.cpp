// A study file.
#include "experiments/study_reader.hpp"
#include "tests/fuzz/fuzz.hpp"

using namespace ikbench;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  read_or_refuse([&] { experiments::parse_study(text_of(data, size), "fuzzed.toml"); });
  return 0;
}
