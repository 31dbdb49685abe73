// The templates that pages share, and data for them.
#pragma once

#include <kainjow/mustache.hpp>
#include <string>
#include <string_view>

#include "analysis/report/json.hpp"

namespace ikbench::report {

// A file of templates/, which the build carries in the program.
std::string_view template_named(std::string_view name);

// Data of a page's template, which escapes texts. What is null or an empty text is false; "has_NAME" says that the list
// NAME is not empty.
kainjow::mustache::data page_data(const Json& json);

// Makes a name safe as an id, in a link and as a file, even if a foreign table brings it.
std::string id_of(std::string_view name);

}  // namespace ikbench::report
