// What a report is made of: blocks, which writers turn into a page, Markdown, files and a screen.
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
// Text is plain; writers escape.
using Block = std::variant<Heading, std::string, Table, figures::Figure>;
using Blocks = std::vector<Block>;

}  // namespace ikbench::show
