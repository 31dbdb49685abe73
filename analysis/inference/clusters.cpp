#include "analysis/inference/clusters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <compare>
#include <limits>
#include <numeric>
#include <utility>

#include "analysis/statistics/bootstrap.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

constexpr std::size_t fewest_clusters = 10;
constexpr std::size_t most_clusters = 1000;
constexpr Resampling resampling{.resamples = 1000};

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

Clusters::Clusters(const StudyResults& study, const Clusters* other) : study_(study) {
  const auto count_of = [](const std::vector<std::uint32_t>& numbers) {
    return numbers.empty() ? std::size_t{0} : std::size_t{std::ranges::max(numbers)} + 1;
  };
  of_solve_ = target_numbers(study);
  are_runs_ = is_chained(study) || count_of(of_solve_) == 1;
  if (are_runs_) of_solve_ = numbered(study, [](const Solve& solve) { return static_cast<std::uint32_t>(solve.run); });
  const std::size_t count = count_of(of_solve_);
  drawn_at_once_ = std::min(count, most_clusters);
  for (std::uint32_t& cluster : of_solve_) cluster %= most_clusters;
  if (count < fewest_clusters) {
    undefined_ = fmt::format("{} {}, and intervals need {}", count, noun(), fewest_clusters);
  } else if (other != nullptr && other->drawn_at_once_ == drawn_at_once_) {
    replicates_ = other->replicates_;
  } else {
    replicates_ = std::make_shared<const Replicates>(resampled_clusters(drawn_at_once_, resampling));
  }
}

std::size_t Clusters::of(const Solve& solve) const {
  return of_solve_[static_cast<std::size_t>(&solve - study_.solves.data())];
}

std::vector<std::size_t> Clusters::of(const Solves& solves) const {
  std::vector<std::size_t> result;
  for (const Solve* solve : solves) result.push_back(of(*solve));
  return result;
}

std::string_view Clusters::noun() const { return are_runs_ ? "runs" : "targets"; }

double Clusters::level() const { return 1 - study_.plan.significance; }

Estimate Clusters::estimate(double value, std::vector<double> replicates) const {
  return expanded_percentiles(value, std::move(replicates), drawn_at_once_, level());
}

bool Clusters::are_copies(std::size_t solver) const {
  return are_runs_ && repeats_itself(study_, study_.solvers[solver]);
}

void judge(std::vector<Finding>& family, std::span<const std::vector<double>> replicates, Better better,
           const Clusters& clusters) {
  std::vector<double> values;
  for (const Finding& finding : family) values.push_back(finding.estimate.value);
  const std::vector<Estimate> estimates =
      simultaneous_intervals(values, replicates, clusters.drawn_at_once(), clusters.level());
  for (std::size_t i = 0; i < family.size(); ++i) {
    Finding& finding = family[i];
    finding.estimate = estimates[i];
    const auto& [value, low, high] = finding.estimate;
    if (std::isnan(low)) {
      finding.why = clusters.undefined().empty() ? "not every sample has a value" : clusters.undefined();
    } else if (clusters.are_copies(finding.first) && clusters.are_copies(finding.second)) {
      finding.relation = Relation::undecided;
      finding.why = "all runs of each are copies of one";
    } else if (low > 0 || high < 0) {
      finding.relation = (low > 0) == (better == Better::larger) ? Relation::better : Relation::worse;
    } else {
      finding.relation = Relation::undecided;
    }
  }
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
  std::vector<std::vector<double>> result(positions.size());
  std::vector<double> shares;
  for (const std::vector<double>& drawn : clusters.replicates()) {
    shares.assign(positions.size(), 0);
    double all = 0, within = 0;
    for (std::size_t c = 0; c < drawn.size(); ++c) {
      if (drawn[c] == 0) continue;
      all += drawn[c] * counted[c].all;
      for (std::size_t p = 0; p < positions.size(); ++p) shares[p] += drawn[c] * counted[c].at_position[p];
    }
    for (std::size_t p = 0; p < positions.size(); ++p) result[p].push_back((within += shares[p]) / all);
  }
  return result;
}

std::vector<Share> banded_shares(const ClusteredValues& of, const Clusters& clusters) {
  std::vector<Share> shares = shares_within(of.values);
  std::vector<double> positions;
  for (const Share& share : shares) positions.push_back(share.at);
  std::vector<std::vector<double>> replicates = resampled_shares(of, clusters, positions);
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const Estimate share = clusters.estimate(shares[i].share, std::move(replicates[i]));
    shares[i].low = share.low;
    shares[i].high = share.high;
  }
  return shares;
}

}  // namespace ikbench::inference
