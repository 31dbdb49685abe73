// Data that several tests of the statistical methods share.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::samples {

// R's data set PlantGrowth: ctrl, trt1, trt2.
inline const std::vector<std::vector<double>> plant_growth{
    {4.17, 5.58, 5.18, 6.11, 4.50, 4.61, 5.17, 4.53, 5.33, 5.14},
    {4.81, 4.17, 4.41, 3.59, 5.87, 3.83, 6.03, 4.89, 4.32, 4.69},
    {6.31, 5.12, 5.54, 5.50, 5.37, 5.29, 4.92, 6.15, 5.80, 5.26}};

using Groups = std::vector<std::vector<double>>;

// The words with the number of the group, from 1.
inline std::string numbered(const statistics::Reason& reason) {
  return named(reason, fmt::format("group {}", reason.group.value_or(0) + 1));
}

inline bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }
inline bool says(const statistics::Reason& reason, const std::string& part) { return says(numbered(reason), part); }

}  // namespace ikbench::samples
