// What so few observations cannot show: a failure that is rare enough not to be among them. Any mean may rest on it.
#pragma once

#include <string>
#include <string_view>

namespace ikbench::inference {

// "as far as 20 runs can show: a failure in up to 14 % of them is not excluded"
std::string unseen_words(int observations, std::string_view of_what, double significance);

}  // namespace ikbench::inference
