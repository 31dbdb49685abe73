// The specification curve of a multiverse (Simonsohn, Simmons and Nelson, Nature Human Behaviour 4 (2020) 1208):
// universes sorted by their estimate, and below each its choices.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/figures/figure.hpp"

namespace ikbench::figures {

struct SpecificationCurve {
  struct Universe {
    double estimate, low, high;     // log10 of a ratio, with its interval
    std::vector<std::size_t> rows;  // indices of its choices' rows
  };
  std::string name, caption;
  std::string quantity;                          // "IK-BA's mean error / best rival's"
  std::string below, above;                      // the meaning of an interval below 1, and above
  std::vector<std::vector<std::string>> groups;  // the alternatives of each dimension
  std::vector<Universe> universes;               // sorted by estimate
};

Figure specification_curve(const SpecificationCurve& curve);

}  // namespace ikbench::figures
