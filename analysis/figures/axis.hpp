// The value axis of a figure as gnuplot commands: linear from zero, or logarithmic with whole decades.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace ikbench::figures {

enum class Scale {
  linear,
  logarithmic,
  by_spread
};  // by_spread: logarithmic where values differ by more than 30 times

struct Axis {
  bool logarithmic = false;
  bool has_values = false;     // finite ones
  bool shows_at_edge = false;  // values of `least` or below, which a logarithmic axis does not have
  double least = 0;
  std::string quantity = {};  // with the unit in which it is drawn
  // Sets label, range and ticks of y, and the function shown(y): what is drawn for y.
  std::string settings = {};
};

// `quantity` with its unit in brackets; seconds "[s]" become [ms] or [us] where they are small. `least`: up to here a
// value is none on a logarithmic axis, unless all are.
Axis value_axis(std::span<const double> values, std::string_view quantity, Scale scale, double least = 0);

}  // namespace ikbench::figures
