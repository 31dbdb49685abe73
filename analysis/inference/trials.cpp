#include "analysis/inference/trials.hpp"

#include <algorithm>
#include <compare>
#include <limits>
#include <numeric>

#include "analysis/inference/convergence.hpp"

namespace ikbench::inference {

using namespace results;

namespace {

// Numbers the study's solves by `key_of`, from 0 in the order in which they first have each key.
template <class KeyOf>
std::vector<std::uint32_t> numbered(const StudyResults& study, KeyOf key_of) {
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> known, result;
  std::uint32_t count = 0;
  result.reserve(study.solves.size());
  for (const Solve& solve : study.solves) {
    const std::size_t key = key_of(solve);
    if (key >= known.size()) known.resize(key + 1, none);
    if (known[key] == none) known[key] = count++;
    result.push_back(known[key]);
  }
  return result;
}

// Orders whatever numbers a target has, NaN too.
bool is_less(const Problem& a, const Problem& b) {
  const auto compare = [](std::span<const double> x, std::span<const double> y) {
    return std::lexicographical_compare_three_way(x.begin(), x.end(), y.begin(), y.end(),
                                                  [](double p, double q) { return std::strong_order(p, q); });
  };
  const auto position = compare(a.target_position_m, b.target_position_m);
  return position != 0 ? position < 0 : compare(a.target_rotation, b.target_rotation) < 0;
}

}  // namespace

std::vector<std::uint32_t> target_numbers(const StudyResults& study) {
  const Problems& problems = study.solve_data->problems;
  std::vector<std::uint32_t> order(problems.size()), target(problems.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) { return is_less(problems[a], problems[b]); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_same = i > 0 && !is_less(problems[order[i - 1]], problems[order[i]]);
    target[order[i]] = is_same ? target[order[i - 1]] : order[i];
  }
  return numbered(study, [&](const Solve& solve) { return target[solve.problem]; });
}

Trials trials_of(const StudyResults& study) {
  if (is_chained(study)) return Trials::runs;
  const std::vector<std::uint32_t> targets = target_numbers(study);
  std::vector<std::int32_t> last(targets.size(), -1);  // the solver that was given it last
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const auto solver = static_cast<std::int32_t>(study.solves[i].solver);
    if (last[targets[i]] == solver) return Trials::targets;
    last[targets[i]] = solver;
  }
  return Trials::solves;
}

}  // namespace ikbench::inference
