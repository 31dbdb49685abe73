#include "analysis/inference/speeds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "analysis/inference/text.hpp"
#include "analysis/statistics/descriptive.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

constexpr std::size_t fewest = 20;    // fewest solves of a solver
constexpr double least_ratio = 1.15;  // smallest ratio of the two speeds
constexpr double least_share = 0.1;   // smallest share of solves in either group
constexpr double most_between = 0.1;  // largest share of solves in the middle half between the groups' medians

struct TwoSpeeds {
  double ratio = 1;       // slow / fast
  double slow_share = 0;  // share of slow solves
};

// Logarithms of seconds per evaluation, sorted.
std::vector<double> paces_of(const StudyResults& study, const std::string& solver) {
  std::vector<double> evaluations;
  for (const Solve& solve : solves_of(study, solver)) evaluations.push_back(static_cast<double>(solve.evaluations));
  const double usual = median(evaluations);
  std::vector<double> paces;
  for (const Solve& solve : solves_of(study, solver)) {
    const auto count = static_cast<double>(solve.evaluations);
    if (solve.timing != Timing::clean || !has_pace(study, solve) || count < usual / 2) continue;
    paces.push_back(std::log(solve.seconds / count));
  }
  std::ranges::sort(paces);
  return paces;
}

// Size of the first of two groups with the largest variance between them (Otsu 1979).
std::size_t first_group(std::span<const double> sorted) {
  double all = 0;
  for (const double value : sorted) all += value;
  const auto n = static_cast<double>(sorted.size());
  double sum = 0, most = -1;
  std::size_t best = 0;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    sum += sorted[i - 1];
    const auto k = static_cast<double>(i);
    const double apart = sum / k - (all - sum) / (n - k), between = k * (n - k) * apart * apart;
    if (between <= most) continue;
    most = between;
    best = i;
  }
  return best;
}

std::optional<TwoSpeeds> two_speeds(const std::vector<double>& paces) {
  const std::span<const double> all(paces);
  const std::size_t fast = first_group(all);
  const double low = median(all.first(fast)), high = median(all.subspan(fast)), quarter = (high - low) / 4;
  const auto between =
      std::ranges::count_if(all, [&](double pace) { return pace > low + quarter && pace < high - quarter; });
  const auto n = static_cast<double>(all.size());
  const TwoSpeeds found{.ratio = std::exp(high - low), .slow_share = 1 - static_cast<double>(fast) / n};
  const bool are_two = found.ratio >= least_ratio && static_cast<double>(between) <= most_between * n &&
                       std::min(found.slow_share, 1 - found.slow_share) >= least_share;
  return are_two ? std::optional(found) : std::nullopt;
}

}  // namespace

Doubts speed_doubts(const StudyResults& study) {
  std::vector<std::string> shares;
  std::vector<double> ratios;
  for (const std::string& solver : study.solvers) {
    const std::vector<double> paces = paces_of(study, solver);
    if (paces.size() < fewest) continue;
    const std::optional<TwoSpeeds> found = two_speeds(paces);
    if (!found) return {};
    ratios.push_back(found->ratio);
    shares.push_back(fmt::format("{} {}", one_line(solver), percent(found->slow_share)));
  }
  if (shares.size() < 2) return {};
  return {{.kind = DoubtKind::two_speeds, .who = shares, .value = median(ratios)}};
}

}  // namespace ikbench::inference
