// Common parts of figures with one row per label: the labels at the left, the values along the x axis.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/figures/axis.hpp"
#include "analysis/figures/figure.hpp"

namespace ikbench::figures {

constexpr std::size_t most_rows = 200;      // in a picture; captions say if there are more
constexpr double largest_drawable = 1e300;  // gnuplot works in doubles

// True for a value that is finite and not too large for an axis.
bool is_drawable(double value);

// Approximate width of a label in 7 pt text.
double label_cm(std::string_view label);

// Adds rows 1, 2, ... from the top, and sets the figure's size.
void add_rows(Figure& figure, std::span<const std::string> labels, double row_cm);

struct RowAxis {
  bool logarithmic = false;
  bool shows_at_edge = false;  // values of zero, which a logarithmic axis cannot show
  double low = 0;
  double high = 1;
  std::string settings = {};  // sets label, range and ticks of x, and shown(x), the drawn place of x
};

// An axis around the drawable values. Scale::by_spread is linear if a value is negative.
// Small seconds become [ms] or [µs].
RowAxis row_axis(std::span<const double> values, const inference::NameWithUnit& quantity, Scale scale);
// A logarithmic axis of ratios, with ticks such as 0.5, 1, 2.
RowAxis ratio_axis(std::span<const double> ratios, const std::string& quantity);

}  // namespace ikbench::figures
