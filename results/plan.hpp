// How a study will be judged, said before its data are seen. It decides no number of a solve.
#pragma once

#include <string>

namespace ikbench::results {

struct Plan {
  enum class Test { ranks, means } test = Test::ranks;
  std::string metric = {};   // of the headline; empty: solved where there is a tolerance, else the error
  std::string control = {};  // compares with this group alone; empty: all pairs
  double significance = 0.05;
  double margin = 0.05;  // that matters: relative, 1 / 1.05 to 1.05; of shares points
  double margin_cm = 0;  // the same of errors; within either, a difference does not matter

  bool operator==(const Plan&) const = default;
};

}  // namespace ikbench::results
