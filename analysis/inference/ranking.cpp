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

Placing placing_of(const RankedSolver& standing, const std::vector<RankedSolver>& all) {
  const double own = worth(standing);
  const auto count = [&](auto&& is_such) { return static_cast<int>(std::ranges::count_if(all, is_such, worth)); };
  return {.place = 1 + count([&](double other) { return other < own; }),
          .shared = count([&](double other) { return other == own; }) > 1};
}

std::string order_words(const std::vector<RankedSolver>& ranking) {
  std::string text;
  for (std::size_t i = 0; i < ranking.size(); ++i) {
    if (i > 0) text += worth(ranking[i]) == worth(ranking[i - 1]) ? " = " : ", ";
    text += ranking[i].solver;
  }
  return text;
}

}  // namespace ikbench::inference
