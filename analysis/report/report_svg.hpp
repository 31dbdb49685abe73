// A picture for the inside of a page.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace ikbench::report {

// The SVG of a file with the elements and attributes of a list and no others (no scripts, styles, links, comments),
// without its white paper and what shows nothing, and with `prefix` before every id. Nothing where the text is not such
// an SVG.
std::optional<std::string> inline_svg(std::string_view file, std::string_view prefix);

}  // namespace ikbench::report
