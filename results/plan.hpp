// How a study will be judged, said before its data are seen. It decides no number of a solve.
#pragma once

#include <string>
#include <utility>

#include "numerics/fields.hpp"

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

constexpr std::pair<double, double> margins_percent{0, 99};

// The fields, listed once for study files, the store's JSON and the command line: name, member, range and meaning.
inline void list_fields(numerics::Fields& io, Plan& plan) {
  constexpr double percent = 0.01;
  io.choice("test", plan.test, {"ranks", "means"}, "what decides: ranks, or means as papers compare them");
  io.text(
      "metric", plan.metric,
      "what decides who is best, a metric of ikbench list metrics; \"\": solved where there is a tolerance, else the error");
  io.text("control", plan.control, "label to compare the others with; \"\": compare every pair");
  io.number("significance", plan.significance, 1, {0.0001, 0.2},
            "significance level of the tests of a metric together");
  io.number("margin_percent", plan.margin, percent, margins_percent,
            "smallest relative difference that matters (of shares in points); within it two solvers count as the same");
  io.number("margin_cm", plan.margin_cm, 1, {0, 1000},
            "the same of errors in cm; a difference within either does not matter");
}

}  // namespace ikbench::results
