#include "analysis/inference/ranking.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ikbench::inference {
namespace {

double worth(const RankedSolver& standing) {
  return std::isfinite(standing.mean) ? standing.mean : std::numeric_limits<double>::infinity();
}

}  // namespace

std::vector<RankedSolver> ranked(std::vector<RankedSolver> standings) {
  std::ranges::stable_sort(standings, {}, worth);
  return standings;
}

}  // namespace ikbench::inference
