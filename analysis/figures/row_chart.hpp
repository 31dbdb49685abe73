// Common parts of figures with one row per label: the labels at the left, the values along the x axis.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/figures/figure.hpp"

namespace ikbench::figures {

constexpr std::size_t most_rows = 200;  // in a picture; captions say if there are more

// Approximate width of a label in 7 pt text.
double label_cm(std::string_view label);

// Adds rows 1, 2, ... from the top, and sets the figure's size.
void add_rows(Figure& figure, std::span<const std::string> labels, double row_cm);

}  // namespace ikbench::figures
