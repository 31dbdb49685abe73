// What is measured, and in which unit.
#pragma once

#include <string>
#include <string_view>

namespace ikbench::inference {

struct NameWithUnit {
  std::string name, unit;  // no unit: empty
};

// Of a column or a quantity as a user names it: "error_cm", "error [cm]".
NameWithUnit split_unit(std::string_view name);
std::string text_of(const NameWithUnit& quantity);  // "error [cm]"

}  // namespace ikbench::inference
