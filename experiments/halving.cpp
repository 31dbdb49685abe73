#include "experiments/halving.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace ikbench::experiments {

std::int64_t solves_of(const std::vector<HalvingRound>& rounds, std::int64_t points) {
  std::int64_t solves = 0, runs_before = 0;
  for (const HalvingRound& round : rounds) {
    solves += static_cast<std::int64_t>(round.candidates) * (round.runs - runs_before) * points;
    runs_before = round.runs;
  }
  return solves;
}

namespace {

std::vector<HalvingRound> shortest_rounds(std::size_t candidates) {
  std::vector<HalvingRound> rounds;
  int runs = 1;
  for (std::size_t left = candidates; left > 1; left = (left + 1) / 2, runs *= 2) rounds.push_back({left, runs});
  return rounds;
}

}  // namespace

std::int64_t least_solves(std::size_t candidates, std::int64_t points) {
  return solves_of(shortest_rounds(candidates), points);
}

std::vector<HalvingRound> halving_rounds(std::size_t candidates, std::int64_t points, std::int64_t budget) {
  std::vector<HalvingRound> rounds = shortest_rounds(candidates);
  if (rounds.empty()) return rounds;
  constexpr std::int64_t most_runs = 1'000'000;  // of a study
  const std::int64_t times = std::min(budget / solves_of(rounds, points), most_runs / rounds.back().runs);
  if (times < 1) return {};
  for (HalvingRound& round : rounds) round.runs *= static_cast<int>(times);
  return rounds;
}

std::vector<std::size_t> better_half(const std::vector<Standing>& standings) {
  const auto rank = [&](std::size_t place) {
    const auto [value, evaluations] = standings[place];
    const auto worst_if_nan = [](double number) {
      return std::pair(std::isnan(number), std::isnan(number) ? 0 : number);
    };
    return std::pair(worst_if_nan(value), worst_if_nan(evaluations));
  };
  std::vector<std::size_t> places(standings.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  std::ranges::stable_sort(places, {}, rank);
  places.resize((places.size() + 1) / 2);
  return places;
}

}  // namespace ikbench::experiments
