#include "analysis/inference/unseen.hpp"

#include <fmt/format.h>

#include "analysis/inference/text.hpp"
#include "analysis/statistics/proportion.hpp"

namespace ikbench::inference {

std::string unseen_words(int observations, std::string_view of_what, double significance) {
  return fmt::format("as far as {} {} can show: a failure in up to {} % of them is not excluded", observations, of_what,
                     rounded_number(100 * statistics::most_without_success(observations, significance), 2));
}

}  // namespace ikbench::inference
