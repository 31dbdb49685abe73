// Encodes bytes for the text of a page.
#pragma once

#include <string>
#include <string_view>

namespace ikbench::report {

std::string base64(std::string_view bytes);

// The hash by which a Content-Security-Policy allows an inline script or style.
std::string sha256_in_base64(std::string_view bytes);

}  // namespace ikbench::report
