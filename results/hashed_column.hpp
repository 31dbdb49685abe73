// Adds a column's value to a hash that takes words of 64 bits, texts and doubles.
#pragma once

#include <cstdint>
#include <string_view>
#include <type_traits>
#include <vector>

#include "results/record.hpp"

namespace ikbench::results {

// -0.0 outside of lists counts as 0.0, because a store cannot tell them apart.
template <class Hash, class Value>
void add_column(Hash& hash, const Value& value) {
  if constexpr (std::is_enum_v<Value>) {
    hash.add(name_of(value));
  } else if constexpr (std::is_integral_v<Value>) {
    hash.add(static_cast<std::uint64_t>(value));
  } else if constexpr (std::is_floating_point_v<Value>) {
    hash.add(value == 0 ? 0.0 : value);
  } else if constexpr (std::is_same_v<Value, std::vector<double>>) {
    hash.add(std::uint64_t{value.size()});
    for (const double number : value) hash.add(number);
  } else {
    hash.add(std::string_view(value));
  }
}

}  // namespace ikbench::results
