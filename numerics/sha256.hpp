// SHA-256 (FIPS 180-4) as a page's Content-Security-Policy wants it: the inline scripts and styles that may run.
#pragma once

#include <string>
#include <string_view>

namespace ikbench::numerics {

std::string sha256_in_base64(std::string_view bytes);

}  // namespace ikbench::numerics
