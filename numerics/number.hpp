// Numbers as text and back, the same in every locale: the shortest text that gives the same double again.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace ikbench::numerics {

// What is not finite is NaN, Inf or -Inf, as R and Python read it.
std::string text_of(double value);

// The whole text as a number, blanks around it ignored; nothing where it is none or too large or small for a double.
std::optional<double> number_from(std::string_view text);

}  // namespace ikbench::numerics
