#include "analysis/inference/clusters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <compare>
#include <map>
#include <set>
#include <utility>

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

constexpr std::size_t fewest_clusters = 10;
constexpr std::size_t most_clusters = 1000;
constexpr Resampling resampling{.resamples = 1000};

// Orders whatever numbers a target has, NaN too.
struct InOrder {
  bool operator()(const std::vector<double>& a, const std::vector<double>& b) const {
    return std::ranges::lexicographical_compare(a, b, [](double x, double y) { return std::strong_order(x, y) < 0; });
  }
};

std::vector<std::size_t> run_numbers(const StudyResults& study) {
  std::map<int, std::size_t> numbers;
  std::vector<std::size_t> result;
  for (const SolveRecord& solve : study.solves) {
    result.push_back(numbers.try_emplace(solve.run, numbers.size()).first->second);
  }
  return result;
}

}  // namespace

std::vector<std::size_t> target_numbers(const StudyResults& study) {
  std::map<std::vector<double>, std::size_t, InOrder> numbers;
  std::vector<std::size_t> result;
  for (const SolveRecord& solve : study.solves) {
    std::vector<double> target = solve.target_position_m;
    target.insert(target.end(), solve.target_rotation.begin(), solve.target_rotation.end());
    result.push_back(numbers.try_emplace(std::move(target), numbers.size()).first->second);
  }
  return result;
}

Trials trials_of(const StudyResults& study) {
  if (is_chained(study)) return Trials::runs;
  const std::vector<std::size_t> targets = target_numbers(study);
  std::set<std::pair<std::string_view, std::size_t>> seen;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (!seen.emplace(study.solves[i].solver, targets[i]).second) return Trials::targets;
  }
  return Trials::solves;
}

Clusters::Clusters(const StudyResults& study) : study_(study) {
  const auto count_of = [](const std::vector<std::size_t>& numbers) {
    return numbers.empty() ? 0 : std::ranges::max(numbers) + 1;
  };
  of_solve_ = target_numbers(study);
  are_runs_ = is_chained(study) || count_of(of_solve_) == 1;
  if (are_runs_) of_solve_ = run_numbers(study);
  const std::size_t count = count_of(of_solve_);
  drawn_at_once_ = std::min(count, most_clusters);
  for (std::size_t& cluster : of_solve_) cluster %= most_clusters;
  if (count < fewest_clusters) {
    undefined_ = fmt::format("{} {}, and intervals need {}", count, noun(), fewest_clusters);
  } else {
    replicates_ = resampled_clusters(drawn_at_once_, resampling);
  }
}

std::size_t Clusters::of(const SolveRecord& solve) const {
  return of_solve_[static_cast<std::size_t>(&solve - study_.solves.data())];
}

std::vector<std::size_t> Clusters::of(const Solves& solves) const {
  std::vector<std::size_t> result;
  for (const SolveRecord* solve : solves) result.push_back(of(*solve));
  return result;
}

std::string_view Clusters::noun() const { return are_runs_ ? "runs" : "targets"; }

double Clusters::level() const { return 1 - study_.plan.significance; }

Interval Clusters::interval(std::vector<double> statistic) const {
  return expanded_percentiles(std::move(statistic), drawn_at_once_, level());
}

std::vector<std::vector<double>> resampled_shares(const ClusteredValues& of, const Clusters& clusters,
                                                  std::span<const double> positions) {
  struct Counted {
    std::vector<double> at_position;  // values above the position before
    double all = 0;
  };
  std::vector<Counted> counted(clusters.drawn_at_once(), {std::vector<double>(positions.size())});
  for (std::size_t i = 0; i < of.values.size(); ++i) {
    Counted& cluster = counted[of.clusters[i]];
    ++cluster.all;
    const auto at = std::ranges::lower_bound(positions, of.values[i]);
    if (at != positions.end()) ++cluster.at_position[static_cast<std::size_t>(at - positions.begin())];
  }
  std::vector<std::vector<double>> result;
  for (const std::vector<double>& drawn : clusters.replicates()) {
    std::vector<double>& shares = result.emplace_back(positions.size());
    double all = 0;
    for (std::size_t c = 0; c < drawn.size(); ++c) {
      if (drawn[c] == 0) continue;
      all += drawn[c] * counted[c].all;
      for (std::size_t p = 0; p < positions.size(); ++p) shares[p] += drawn[c] * counted[c].at_position[p];
    }
    double within = 0;
    for (double& share : shares) share = (within += share) / all;
  }
  return result;
}

void add_bands(std::vector<Share>& shares, const Clusters& clusters,
               const std::vector<std::vector<double>>& replicates) {
  for (std::size_t i = 0; i < shares.size(); ++i) {
    std::vector<double> values;
    for (const std::vector<double>& replicate : replicates) values.push_back(replicate[i]);
    const Interval interval = clusters.interval(std::move(values));
    shares[i].low = interval.low;
    shares[i].high = interval.high;
  }
}

std::vector<Share> banded_shares(const ClusteredValues& of, const Clusters& clusters) {
  std::vector<Share> shares = shares_within(of.values);
  std::vector<double> positions;
  for (const Share& share : shares) positions.push_back(share.at);
  add_bands(shares, clusters, resampled_shares(of, clusters, positions));
  return shares;
}

}  // namespace ikbench::inference
