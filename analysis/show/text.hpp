// Texts and numbers for the writers of tables and pages: escapes, digits, and lines that break between words. Labels
// and titles come from files of users. Writers therefore pass every text through one of the escapes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/names.hpp"

namespace ikbench::show {

using base::character_count, base::listed, base::max_named, base::names_of, base::one_line, base::shortened;

// Returns the text on one line with the characters escaped that mean something in HTML.
std::string html_text(std::string_view text);
// Returns the text on one line with the characters escaped that mean something in Markdown, also within a table.
std::string markdown_text(std::string_view text);
// Returns the text on one line with the characters escaped that mean something in LaTeX. Opening quotes, minus signs
// and powers of ten ("1e-05") are set as such.
std::string latex_text(std::string_view text);
// Returns the name with a blank for each "_".
std::string with_spaces(std::string_view name);
// Returns the text with a capital first letter.
std::string as_sentence(std::string text);
// Returns the name of a solver as it stands in a sentence: in quotes if it has a comma.
std::string name_in_sentence(const std::string& name);
// Returns "A, B and C". Unlike base::listed it takes texts with commas in brackets or quotes.
std::string enumerated(const std::vector<std::string>& texts);
// Returns "nine" for 9, and the digits of a number above twelve.
std::string number_word(std::size_t number);
// Returns the letters and digits of a name, with "-" for what stands between: an anchor, a link or a label of LaTeX.
std::string anchor_id(std::string_view name);

// Returns a number with so many significant digits. Below 1e7 all digits before the point are written: 2430, not
// 2.43e+03. NaN is "-", and infinity "inf".
std::string number_text(double value, int digits = 3);
// Returns "8.1 times", or "1.04 times" for a ratio near 1, which has three digits.
std::string ratio_text(double ratio);
// Numbers that decide something, such as a significance or the ends of a margin: no other number may look like one.
using Boundaries = std::vector<double>;
// Returns the number as number_text does, but "< 100" or "> 100" for another number that would be rounded onto 100, if
// 100 is one of `ends`.
std::string number_within(double value, const Boundaries& ends, int digits = 3);
// Returns a p: "0.0005", "< 0.0001", or "< 0.05" for a p that would be rounded onto 0.05, if that is one of `ends`.
std::string p_text(double p, const Boundaries& ends);

// Returns the words of a text in lines: the first of at most `first` characters, the rest of at most `others`. Longer
// words stay whole, and so do a number and the word behind the number.
std::vector<std::string> wrap_words(std::string_view text, std::size_t first, std::size_t others);

// Returns the rows as lines with padded columns, `gap` blanks apart. If the lines are wider than `width`, the gaps
// become two blanks, and then the words of the widest columns are wrapped.
std::string align_columns(const std::vector<std::vector<std::string>>& rows, std::size_t gap = 3,
                          std::size_t width = 100);

// Returns a text as lines of a screen, of at most 100 columns, which break between words. The first line begins with
// `first`, and every other line with `indent`.
std::string wrapped_paragraph(const std::string& text, const std::string& indent, const std::string& first = {});

}  // namespace ikbench::show
