// The inputs of `ikbench stats`: one value per row, one group per column, published summaries.
#include "analysis/inference/observations_csv.hpp"
#include "tests/fuzz/fuzz.hpp"

using namespace ikbench;
using namespace ikbench::inference;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = text_of(data, size);
  read_or_refuse([&] { read_observations(text, "fuzzed.csv", {.value = "value", .block = "block", .run = "run"}); });
  read_or_refuse([&] { read_observations(text, "fuzzed.csv", {.value = "value"}); });
  read_or_refuse([&] { read_observations(text, "fuzzed.csv", {.is_wide = true, .value = "value"}); });
  read_or_refuse([&] { read_summaries(text, "fuzzed.csv"); });
  return 0;
}
