// The freedoms that a goal fixes. An arm with as many joints has finitely many answers to most targets, which `run`
// counts and reports show (docs/explanation/methods.md#all-answers).
#pragma once

#include <cstddef>

#include "results/study.hpp"

namespace ikbench::results {

// Returns how many freedoms the goal of a search fixes; 0 for a search that is not for all joints.
constexpr std::size_t goal_freedoms(Search search) {
  switch (search) {
    case Search::pose:
      return 6;
    case Search::axis:
      return 5;
    case Search::all_joints:
      return 3;
    case Search::wrist:
    case Search::flange:
      break;
  }
  return 0;
}

}  // namespace ikbench::results
