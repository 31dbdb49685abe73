// The sections of a report as a page, and as Markdown.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/show/block.hpp"

namespace ikbench::show {

// They show the pictures that stand in `figures` of the report's folder. The page also has the moving arm, if
// there is one and a library that draws it.
std::string to_html_page(const std::string& title, const std::vector<Blocks>& sections,
                         const std::optional<std::string>& arm, const std::filesystem::path& folder,
                         const std::string& program);
std::string to_markdown(const std::vector<Blocks>& sections, const std::filesystem::path& folder);

// A template with each {{name}} replaced.
std::string fill_template(std::string_view name, const std::map<std::string, std::string, std::less<>>& values);

}  // namespace ikbench::show
