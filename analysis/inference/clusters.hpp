// Clusters are solves that depend on each other, so the bootstrap draws them together. A cluster is a run if each solve
// starts from the answer of the one before or all have the same target; else it is a target. A replicate draws the same
// clusters for all solvers, because they share the targets.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/inference/convergence.hpp"
#include "analysis/inference/finding.hpp"
#include "analysis/inference/observations.hpp"
#include "analysis/inference/study.hpp"

namespace ikbench::inference {

// The independent trials that an interval may count. A deterministic solver that gets a target again, as in the runs of
// a fixed path, only repeats itself: its solves are not trials.
enum class Trials { runs, targets, solves };
Trials trials_of(const StudyResults& study);

// Numbers the targets of the study's solves from 0. Solves with equal position and rotation have equal numbers.
std::vector<std::uint32_t> target_numbers(const StudyResults& study);

// The clusters of a study, and replicates that have drawn them. More than a thousand are drawn in a thousand groups.
class Clusters {
 public:
  // The study must outlive it. It shares the replicates of `other` if that has as many clusters: a thousand replicates
  // of a thousand clusters take 8 MB.
  explicit Clusters(const StudyResults& study, const Clusters* other = nullptr);

  std::size_t of(const Solve& solve) const;  // one of the study's
  std::vector<std::size_t> of(const Solves& solves) const;

  std::size_t drawn_at_once() const { return drawn_at_once_; }  // clusters, or groups of them
  // Empty where undefined() says why there are too few for intervals.
  const std::vector<std::vector<double>>& replicates() const { return *replicates_; }
  const std::string& undefined() const { return undefined_; }
  std::string_view noun() const;  // "runs"

  double level() const;  // of intervals, as the plan of the study has it
  // Returns whether the clusters are runs, and those of the solver are copies of one.
  bool are_copies(std::size_t solver) const;

  // A statistic with the expanded_percentiles of its replicates.
  Estimate estimate(double value, std::vector<double> replicates) const;

 private:
  const StudyResults& study_;
  bool are_runs_ = false;
  std::vector<std::uint32_t> of_solve_;
  std::size_t drawn_at_once_ = 0;
  using Replicates = std::vector<std::vector<double>>;
  std::shared_ptr<const Replicates> replicates_ = std::make_shared<const Replicates>();
  std::string undefined_;
};

// Judges a family of pairs by the replicates of their estimates, with intervals that hold for all together: better or
// worse where 0 is outside. An interval without width is a difference that every cluster has; of runs that are copies
// of one it says nothing.
void judge(std::vector<Finding>& family, std::span<const std::vector<double>> replicates, Better better,
           const Clusters& clusters);

// Values that come in clusters.
struct ClusteredValues {
  std::vector<double> values = {};
  std::vector<std::size_t> clusters = {};
};

// Takes the values that each solve has.
template <class ValuesOf>
ClusteredValues clustered(const Solves& solves, const Clusters& clusters, ValuesOf values_of) {
  ClusteredValues result;
  for (const Solve* solve : solves) {
    const std::vector<double> values = values_of(*solve);
    result.values.insert(result.values.end(), values.begin(), values.end());
    result.clusters.insert(result.clusters.end(), values.size(), clusters.of(*solve));
  }
  return result;
}

// The share of values at or below each position (ascending), in every replicate: [position][replicate].
std::vector<std::vector<double>> resampled_shares(const ClusteredValues& of, const Clusters& clusters,
                                                  std::span<const double> positions);

// shares_within(), with intervals.
std::vector<Share> banded_shares(const ClusteredValues& of, const Clusters& clusters);

}  // namespace ikbench::inference
