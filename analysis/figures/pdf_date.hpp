// The time of drawing in a PDF.
#pragma once

#include <string>

namespace ikbench::figures {

// A PDF as Cairo writes it, without the time of drawing: the same picture has the same bytes. Throws
// std::invalid_argument if the time is not found.
std::string without_date(std::string pdf);

}  // namespace ikbench::figures
