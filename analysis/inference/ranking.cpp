#include "analysis/inference/ranking.hpp"

#include <fmt/format.h>

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

std::vector<std::string> first_of(const std::vector<RankedSolver>& ranking) {
  std::vector<std::string> names;
  for (const RankedSolver& standing : ranking) {
    if (placing_of(standing, ranking).place == 1) names.push_back(standing.solver);
  }
  return names;
}

std::string first_words(const std::vector<RankedSolver>& ranking) {
  const std::vector<std::string> names = first_of(ranking);
  if (names.size() == 1) return names.front();
  return fmt::format("{} and {} (tied)", fmt::join(names.begin(), names.end() - 1, ", "), names.back());
}

PairOrder compare_pairs(const std::vector<RankedSolver>& of, const std::vector<RankedSolver>& other) {
  const auto other_worth = [&](const RankedSolver& standing) {
    return worth(*std::ranges::find(other, standing.solver, &RankedSolver::solver));
  };
  PairOrder order;
  for (std::size_t i = 0; i < of.size(); ++i) {
    for (std::size_t j = i + 1; j < of.size(); ++j) {
      if (worth(of[i]) == worth(of[j])) continue;
      ++order.pairs;
      const double first = other_worth(of[i]), second = other_worth(of[j]);
      if (first == second) ++order.tied;
      if (first != second && (first < second) == (worth(of[i]) < worth(of[j]))) ++order.same;
    }
  }
  return order;
}

std::string printed_order_words(const PairOrder& pairs) {
  return fmt::format("{} of {} pairs rank as in the paper{}", pairs.same, pairs.pairs,
                     pairs.tied > 0 ? fmt::format(", {} {} tied", pairs.tied, pairs.tied == 1 ? "is" : "are") : "");
}

}  // namespace ikbench::inference
