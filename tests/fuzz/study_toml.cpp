// A study file.
#include "experiments/study_reader.hpp"
#include "tests/fuzz/fuzz.hpp"

using namespace ikbench;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto text = text_of(data, size);
  // A study may name a program or a shared object, which would be started: skips made-up ones, however they are
  // written.
  for (const char* key : {"process", "shared_object", "\\"}) {
    if (text.find(key) != text.npos) return 0;
  }
  read_or_refuse([&] { experiments::parse_study(text, "fuzzed.toml"); });
  return 0;
}
