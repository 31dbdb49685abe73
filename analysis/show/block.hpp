// The blocks of which a report consists. Writers turn blocks into a page, Markdown and files.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/show/table.hpp"

namespace ikbench::show {

struct Heading {
  std::string text;
};
// A part of a section: a heading, a paragraph, a table or a figure. Texts are plain, and the writers escape them.
using Block = std::variant<Heading, std::string, Table, figures::Figure>;
using Blocks = std::vector<Block>;

}  // namespace ikbench::show
