// The result of one comparison of two, as plain data, for every quantity and method.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "analysis/inference/relation.hpp"
#include "analysis/statistics/descriptive.hpp"

namespace ikbench::inference {

using statistics::Estimate;

struct Finding {
  std::string quantity;
  std::string first, second;
  bool is_ratio = false;               // true: the estimate is first / second; false: first - second
  Estimate estimate = {};              // its interval holds for all pairs of the family together
  double p = statistics::not_defined;  // corrected for the family; not defined where the interval decides
  std::string method = {};
  Relation relation = Relation::undefined;
  std::string why = {};  // the reason for the relation if not the interval; else empty
};

// Returns the same finding with first and second swapped.
Finding reversed(Finding finding);

// The finding on a quantity and two names, in this order. Throws std::out_of_range if there is none.
Finding finding_of(std::span<const Finding> findings, std::string_view quantity, std::string_view first,
                   std::string_view second);

}  // namespace ikbench::inference
