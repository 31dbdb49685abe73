// Words the limit of few observations: a rare failure may not be among them, although it would change any mean.
#pragma once

#include <string>
#include <string_view>

namespace ikbench::inference {

// "20 runs do not exclude a failure in up to 14 % of them"
std::string rare_failures_words(int observations, std::string_view of_what, double significance);

}  // namespace ikbench::inference
