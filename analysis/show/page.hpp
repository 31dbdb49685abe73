// The sections of a report as a page of HTML, and as Markdown. write_report (publish.hpp) calls these functions after
// the pictures are drawn. The page loads nothing from elsewhere.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/show/block.hpp"

namespace ikbench::show {

// Returns the page. `folder` is the folder of the report, whose pictures in figures/ are shown. `arm` is the text of
// animation_json (moving_arm.hpp); a page without `arm` has no moving arm. `program` is the name and version of the
// program.
std::string to_html_page(const std::string& title, const std::vector<Blocks>& sections,
                         const std::optional<std::string>& arm, const std::filesystem::path& folder,
                         const std::string& program);
// Returns the report in Markdown, with links to the pictures in figures/ of `folder`.
std::string to_markdown(const std::vector<Blocks>& sections, const std::filesystem::path& folder);

// Returns the template of this name with each {{name}} replaced by the value of that name.
std::string fill_template(std::string_view name, const std::map<std::string, std::string, std::less<>>& values);

}  // namespace ikbench::show
