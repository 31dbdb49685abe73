// Any text (labels and titles come from files of users) made harmless for each writer, and numbers as text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/names.hpp"

namespace ikbench::show {

using base::character_count, base::listed, base::max_named, base::names_of, base::one_line, base::shortened;

std::string html_text(std::string_view text);
std::string markdown_text(std::string_view text);
std::string latex_text(std::string_view text);
std::string with_spaces(std::string_view name);  // for _
std::string as_sentence(std::string text);       // begun by a capital letter
std::string anchor_id(std::string_view name);    // letters, digits and "-": an anchor, a link, a label of LaTeX

// 2430, not 2.4e+03: all digits before the point. "-" for a number that is not finite.
std::string number_text(double value, int digits = 3);
std::string ratio_text(double ratio);  // "8.1 times", "1.04 times"
// Numbers that decide: one that three digits would round onto an end is "< 100".
using Boundaries = std::vector<double>;
std::string number_within(double value, const Boundaries& ends, int digits = 3);
std::string p_text(double p, const Boundaries& ends);  // "0.0005", "< 0.0001", "< 0.05"

// The words of a text in lines of at most that width; longer words stay whole.
std::vector<std::string> wrap_words(std::string_view text, std::size_t first, std::size_t others);

// Rows with their columns padded. If they are wider than `width`, the words of the widest columns are wrapped.
std::string align_columns(const std::vector<std::vector<std::string>>& rows, std::size_t gap = 3,
                          std::size_t width = 100);

// Lines of a screen, at most 100 columns, which break between words; the first begins with `first`, others with
// `indent`.
std::string wrapped_paragraph(const std::string& text, const std::string& indent, const std::string& first = {});

}  // namespace ikbench::show
