// Numbers as text and back, the same in every locale. The text is the shortest that gives the same double again.
#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <string_view>

namespace ikbench::base {

// Returns the shortest text of a number. Values that are not finite become NaN, Inf or -Inf, as R and Python read them.
std::string text_of(double value);
void append(std::string& text, double value);

// Does what std::from_chars does, also where the library has none for doubles.
std::from_chars_result read_number(const char* begin, const char* end, double& value);

// Returns the whole text as a number, without blanks around it. Returns nothing if it is no number, or too large or too
// small for a double.
std::optional<double> number_from(std::string_view text);

// Returns the value of one unit in the last printed digit: 0.01 for "2.50", 1000 for "3e3".
double last_digit(std::string_view number);

// Returns the number x for which x * unit is `value` bit for bit, the shortest if several are near; value / unit if
// there is none.
double in_unit(double value, double unit);

}  // namespace ikbench::base
