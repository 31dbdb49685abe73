// What so few observations cannot show: a failure that is rare enough not to be among them. Any mean may rest on it.
#pragma once

#include <string>
#include <string_view>

namespace ikbench::inference {

// "20 runs do not exclude a failure in up to 14 % of them"
std::string rare_failures_words(int observations, std::string_view of_what, double significance);

}  // namespace ikbench::inference
