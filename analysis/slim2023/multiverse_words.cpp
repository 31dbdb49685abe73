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

}  // namespace ikbench::slim2023
