// A table as LaTeX that fits its page: scaled into the line, turned on its side, or, where it is long, over several
// pages. Its first line says which packages it needs.
#pragma once

#include <string>

#include "analysis/report/table.hpp"

namespace ikbench::report {

// Fits an A4 page with margins of 2 cm. Columns that are empty in every row are left out; their names are words.
std::string to_latex(const Table& table);

}  // namespace ikbench::report
