#include "analysis/inference/unseen.hpp"

#include <fmt/format.h>

#include "analysis/inference/text.hpp"
#include "analysis/statistics/proportion.hpp"

namespace ikbench::inference {

std::string rare_failures_words(int observations, std::string_view of_what, double significance) {
  return fmt::format("{} {} do not exclude a failure in up to {} % of them", observations, of_what,
                     rounded_number(100 * statistics::most_without_success(observations, significance), 2));
}

}  // namespace ikbench::inference
