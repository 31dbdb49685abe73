#include "base/units.hpp"

#include <fmt/format.h>

#include <cmath>

namespace ikbench::base {

std::string_view doubt_of_angle(double value, double unit) {
  constexpr double quarter = std::numbers::pi / 2, slack = 0.001;
  if (unit == 1 && std::abs(value) > 4 * quarter + slack) return "is more than a turn; expected radians, not degrees";
  const std::string text = fmt::format("{}", std::abs(value));
  const std::size_t point = text.find('.'), decimals = text.size() - std::min(point, text.size());
  for (int turns = 1; unit == degree && turns <= 4; ++turns) {
    if (decimals > 2 && text == fmt::format("{}", std::stod(fmt::format("{:.{}f}", turns * quarter, decimals - 1))))
      return "is a number of quarter turns in radians; expected degrees (if it is meant, write a digit more)";
  }
  return "";
}

}  // namespace ikbench::base
