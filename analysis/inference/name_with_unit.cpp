#include "analysis/inference/name_with_unit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace ikbench::inference {

NameWithUnit split_unit(std::string_view name) {
  constexpr std::array<std::string_view, 6> units{"cm", "deg", "rad", "ms", "s", "m"};
  const bool is_bracketed = name.ends_with(']');
  const std::size_t at = name.rfind(is_bracketed ? '[' : '_');
  if (at == std::string_view::npos || at == 0) return {std::string(name), ""};
  const std::string_view unit = name.substr(at + 1, name.size() - at - (is_bracketed ? 2 : 1));
  if (!is_bracketed && std::ranges::find(units, unit) == units.end()) return {std::string(name), ""};
  name = name.substr(0, at);
  return {std::string(name.substr(0, name.find_last_not_of(' ') + 1)), std::string(unit)};
}

std::string text_of(const NameWithUnit& quantity) {
  return quantity.unit.empty() ? quantity.name : fmt::format("{} [{}]", quantity.name, quantity.unit);
}

}  // namespace ikbench::inference
