// Writes a table as LaTeX that fits its page: the package adjustbox scales it to the line. A wide table is turned on
// its side, and a long one is split over pages. The first line lists the packages it needs.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "analysis/report/table.hpp"

namespace ikbench::report {

// Columns that are empty in every row are left out. Heads are words: "mean_reached_ms" becomes "mean reached [ms]".
std::string to_latex(const Table& table);

// Text whose words may break if they are longer than this, after punctuation if there is any.
std::string breakable_latex(std::string_view text, std::size_t longest_word);

}  // namespace ikbench::report
