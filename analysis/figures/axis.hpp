// The value axes of figures as gnuplot commands.
#pragma once

#include <span>
#include <string>

#include "analysis/inference/text.hpp"

namespace ikbench::figures {

constexpr double largest_drawable = 1e300;  // gnuplot works in doubles

// True for a value that is finite and not too large for an axis.
bool is_drawable(double value);

// The smallest of 1, 2 and 5 times a power of ten that marks no more than `places` places of an axis.
double round_step(double span, double places);

// by_spread: logarithmic if values differ by more than 30 times and none is negative.
enum class Scale { linear, logarithmic, by_spread };

struct Axis {
  bool logarithmic = false;
  bool shows_at_edge = false;  // values <= `least`, which a logarithmic axis cannot show
  double least = 0;
  double low = 0, high = 1;   // its range
  std::string quantity = {};  // with its drawn unit: small seconds become [ms] or [µs]
  std::string settings = {};  // label, range, ticks, and the function shown(), the drawn place of a value
};

// The y axis: linear from zero, or logarithmic with whole decades. A logarithmic axis cannot show values up to `least`,
// unless all are.
Axis value_axis(std::span<const double> values, const inference::NameWithUnit& quantity, Scale scale, double least = 0);
// The x axis: linear around the values, or logarithmic with whole decades.
Axis row_axis(std::span<const double> values, const inference::NameWithUnit& quantity, Scale scale);
// A logarithmic x axis of ratios or costs, with round ticks: 0.5, 1, 2. Its functions shown() and shown_x() give the
// drawn place of a value; shown_x() draws values outside at the ends. No ticks unless both are positive numbers.
Axis ratio_axis(double smallest, double largest, const inference::NameWithUnit& quantity);

}  // namespace ikbench::figures
