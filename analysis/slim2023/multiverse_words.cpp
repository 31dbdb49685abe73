#include "analysis/slim2023/multiverse_words.hpp"

#include <fmt/format.h>

#include "analysis/inference/text.hpp"

namespace ikbench::slim2023 {

using namespace inference;

std::string count_words(double count) {
  if (count >= 1e9) return short_number(count / 1e9) + " billion";
  if (count >= 1e6) return short_number(count / 1e6) + " million";
  return fmt::format("{:.0f}", count);
}

std::string choice_words(const Multiverse& multiverse, std::span<const Multiverse::Choice> chosen) {
  std::string words;
  for (const Multiverse::Choice& each : chosen) {
    if (each.alternative == 0) continue;
    words += words.empty() ? "" : ", ";
    words += multiverse.dimensions[each.dimension].alternatives[each.alternative].set;
  }
  return words.empty() ? "the default" : words;
}

}  // namespace ikbench::slim2023
