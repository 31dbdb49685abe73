// Numbers as text and back, the same in every locale: the shortest text that gives the same double again.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace ikbench::numerics {

// Writes NaN, Inf or -Inf for values that are not finite, as R and Python read them.
std::string text_of(double value);

// The whole text as a number, ignoring blanks around it; nothing if it is no number, or too large or too small for a
// double.
std::optional<double> number_from(std::string_view text);

}  // namespace ikbench::numerics
