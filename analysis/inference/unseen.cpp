#include "analysis/inference/unseen.hpp"

#include "analysis/inference/text.hpp"
#include "analysis/statistics/proportion.hpp"

namespace ikbench::inference {

std::string unseen_share_words(int observations, double significance) {
  return rounded_number(100 * statistics::most_without_success(observations, significance), 2) + " %";
}

}  // namespace ikbench::inference
