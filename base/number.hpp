// Numbers as text and back, the same in every locale: the shortest text that gives the same double again.
#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <string_view>

namespace ikbench::base {

// Writes NaN, Inf or -Inf for values that are not finite, as R and Python read them.
std::string text_of(double value);
void append(std::string& text, double value);

// std::from_chars, also where the library has none of doubles.
std::from_chars_result read_number(const char* begin, const char* end, double& value);

// The whole text as a number, ignoring blanks around it; nothing if it is no number, or too large or too small for a
// double.
std::optional<double> number_from(std::string_view text);

// What the last digit of a printed number stands for: 0.01 of "2.50", 1000 of "3e3".
double last_digit(std::string_view number);

// The number x for which x * unit is `value` bit for bit, the shortest if there are several nearby; value / unit if
// there is none.
double in_unit(double value, double unit);

}  // namespace ikbench::base
