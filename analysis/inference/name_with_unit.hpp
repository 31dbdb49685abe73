// A quantity's name and its unit.
#pragma once

#include <string>
#include <string_view>

namespace ikbench::inference {

struct NameWithUnit {
  std::string name, unit;  // unit is empty if there is none
};

// Splits a user's name of a column or quantity: "error_cm", "error [cm]".
NameWithUnit split_unit(std::string_view name);
std::string text_of(const NameWithUnit& quantity);  // "error [cm]"

}  // namespace ikbench::inference
