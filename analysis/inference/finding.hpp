// What was found of two: a row of plain data, whatever was compared and whichever method did.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "analysis/inference/relation.hpp"
#include "analysis/statistics/descriptive.hpp"

namespace ikbench::inference {

// A number with its interval; the interval may be not defined where the number is.
struct Estimate {
  double value = statistics::not_defined;
  double low = statistics::not_defined;
  double high = statistics::not_defined;
};

struct Finding {
  std::string quantity;
  std::string first, second;
  bool is_ratio = false;               // the estimate is first / second, else first - second
  Estimate estimate = {};              // its interval holds for all pairs of the family together
  double p = statistics::not_defined;  // corrected for the family; not defined where the interval decides
  std::string method = {};
  Relation relation = Relation::undefined;
  std::string why = {};  // what the relation follows from where it is not the interval; empty where it is
};

// The same of the second to the first.
Finding reversed(Finding finding);

// The row of a quantity and two, in this order. std::out_of_range where there is none.
Finding finding_of(std::span<const Finding> findings, std::string_view quantity, std::string_view first,
                   std::string_view second);

}  // namespace ikbench::inference
