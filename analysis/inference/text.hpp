// Escapes any text (labels and titles come from study files) for Markdown, LaTeX and gnuplot, writes numbers as text,
// and splits names of quantities from their units.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace ikbench::inference {

// Returns one line of valid UTF-8: control characters become spaces, invalid bytes U+FFFD.
std::string one_line(std::string_view text);
// Cuts one_line(text) to `length` characters; an ellipsis marks the cut.
std::string shortened(std::string_view text, std::size_t length);
// Cuts a label to `length` characters in its middle: variants of one solver differ at the end of their names.
std::string row_label(std::string_view text, std::size_t length);
std::string capitalised(std::string_view text);
std::size_t character_count(std::string_view utf8);

std::string markdown_text(std::string_view text);
std::string latex_text(std::string_view text);
// Returns a gnuplot string expression. Quotes, backticks, @, $, \, #, braces and the like become elements of the array
// `character` of style.gp, because gnuplot 5.4 loses count of quotes when it looks for macros.
std::string gnuplot_string(std::string_view text);

std::string rounded_number(double value, int significant_digits);  // 2430, not 2.4e+03: all digits before the point
std::string short_number(double value);                            // three digits, or "not defined"
// "7.5 deg"; radians too large for a double in degrees are "more than 1e308 deg".
std::string degrees_words(double degrees);
std::string percent(double share);  // "5 %", three digits
std::string points(double share);   // "5 percentage points", three digits

struct NameWithUnit {
  std::string name, unit;  // unit is empty if there is none
};

// Splits a user's name of a column or quantity: "error_cm", "error [cm]".
NameWithUnit split_unit(std::string_view name);
std::string in_words(std::string_view id);          // "tolerance missed" for tolerance_missed
std::string text_of(const NameWithUnit& quantity);  // "error [cm]"

}  // namespace ikbench::inference
