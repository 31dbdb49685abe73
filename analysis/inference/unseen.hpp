// What so few observations cannot show: a failure that is rare enough not to be among them. Any mean may rest on it.
#pragma once

#include <string>

namespace ikbench::inference {

// "14 %": the largest share of failures that so many observations without one do not exclude.
std::string unseen_share_words(int observations, double significance);

}  // namespace ikbench::inference
