// Bytes as a page has them within its text.
#pragma once

#include <string>
#include <string_view>

namespace ikbench::report {

std::string base64(std::string_view bytes);

// As a Content-Security-Policy names the inline scripts and styles that may run.
std::string sha256_in_base64(std::string_view bytes);

}  // namespace ikbench::report
