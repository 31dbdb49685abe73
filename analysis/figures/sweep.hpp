// The figures of a sweep over a number: targets solved and time, by the value. `ikbench run --sweep near_deg=1,10,45`
// draws them.
#pragma once

#include <string>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/figures/look.hpp"
#include "analysis/judge/judge.hpp"

namespace ikbench::figures {

// A study of a sweep, with the value of the swept key.
struct SweptValue {
  double value;
  const judge::JudgedStudy* judged;
};
// Returns the figures for which the studies have values, with a line per solver. Bars are 95 % intervals.
std::vector<Figure> of_sweep(const std::vector<SweptValue>& values, const std::string& key, const Look& look);

}  // namespace ikbench::figures
