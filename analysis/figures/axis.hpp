// The value axis of a figure as gnuplot commands: linear from zero, or logarithmic with whole decades.
#pragma once

#include <span>
#include <string>

#include "analysis/inference/name_with_unit.hpp"

namespace ikbench::figures {

enum class Scale { linear, logarithmic, by_spread };  // by_spread: logarithmic if values differ by more than 30 times

// The unit that values are drawn in: small seconds as [ms] or [µs].
struct DrawnUnit {
  std::string unit;
  double factor = 1;  // drawn by given value
};
DrawnUnit drawn_unit(const std::string& unit, double largest);

struct Axis {
  bool logarithmic = false;
  bool has_values = false;     // any finite ones
  bool shows_at_edge = false;  // values <= `least`, which a logarithmic axis cannot show
  double least = 0;
  std::string quantity = {};  // with its drawn unit
  // Sets label, range and ticks of y, and the function shown(y), the drawn place of y.
  std::string settings = {};
};

// The axis of `quantity`; small seconds become [ms] or [µs]. A logarithmic axis cannot show values up to `least`,
// unless all are.
Axis value_axis(std::span<const double> values, const inference::NameWithUnit& quantity, Scale scale, double least = 0);

}  // namespace ikbench::figures
