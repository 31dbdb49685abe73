// The samples of one metric, one per group: the input of `compare_pairs` and `describe`. `sampling.hpp` makes them from
// solves, `csv/user_csv.hpp` from a table. What must not be compared was settled before: groups with missing or
// incomparable values arrive here as ExcludedSample.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "analysis/judge/data/warnings.hpp"

namespace ikbench::judge {

// The direction in which values are better.
enum class Better { smaller, larger };

// The effect that a comparison estimates.
enum class EffectScale {
  ratio,       // first / second
  difference,  // first - second
  share        // first - second of shares from 0 to 1
};

// The kind of quantity, for code that treats some kinds specially. A time is any metric made of times, such as the
// share of targets that were solved in time, because times are compared only where they are comparable.
enum class QuantityKind {
  other,
  solved,    // share of targets within the tolerance
  answered,  // share of solves with any answer
  position,  // position error
  angle,     // orientation error
  motion,    // motion of the joints
  time,
  evaluations
};

// The values of one group.
struct Sample {
  std::vector<double> values = {};  // +infinity stands for "no answer" and ranks behind every number
  // The block of each value, ascending, if the design is paired. Empty: values with the same place belong together.
  std::vector<int> blocks = {};
  bool is_deterministic = false;  // the only value stands for all runs
  bool is_constant = false;       // all values are equal, and nothing says whether they are repeats or copies
  double effective_n = 0;         // logarithms of costs only: effective sample size; 0: not known
  double solved_targets = 0;      // logarithms of costs only
};

// A sample as papers print it, without its values.
struct SummaryStatistics {
  int n = 0;
  double mean = 0;
  double sd = 0;  // divided by n - 1
};

// Why a group takes part in no test. If several reasons hold, the first counts.
enum class ExclusionReason {
  missing_values,   // some solves or rows have no value
  infinite_values,  // some are without an answer, which no mean can count
  not_comparable,   // timed or counted in another way, or ended by the clock
  zero_spread,      // a printed deviation of 0, which would decide everything
  nothing_solved    // no target was solved, so no answer has a cost
};

// A sample that takes part in no test. The values that the group has can be described.
struct ExcludedSample {
  ExclusionReason reason = ExclusionReason::missing_values;
  int missing = 0;  // number of missing values
  std::vector<double> values = {};
  std::optional<SummaryStatistics> printed = {};
};

// The data of a group: measured values, a printed summary, or an excluded sample.
using GroupData = std::variant<Sample, SummaryStatistics, ExcludedSample>;

// One solver, or one label of a file, with its sample.
struct Group {
  std::string name = {};
  GroupData sample = {};
  double tolerance = 0;     // errors only: smaller values count as this; 0: none (costs have Ratios::floor)
  int pooled_n = 0;         // proportions by session only: number of solves; 0: the values are described
  double pooled_share = 0;  // proportions by session only: share of these solves
};

// Returns the excluded sample of a group; null if the group takes part in tests.
inline const ExcludedSample* excluded(const Group& group) { return std::get_if<ExcludedSample>(&group.sample); }
// Returns the values of a group; null if the group is excluded or has only a printed summary.
inline const Sample* sample_of(const Group& group) { return std::get_if<Sample>(&group.sample); }
// Returns whether the solver of a group is deterministic.
inline bool is_deterministic(const Group& group) { return sample_of(group) && sample_of(group)->is_deterministic; }
// Returns whether all values of a group are equal, and may be copies of one measurement.
inline bool is_constant(const Group& group) { return sample_of(group) && sample_of(group)->is_constant; }
// Returns how many values are missing.
inline int missing_in(const Group& group) { return excluded(group) ? excluded(group)->missing : 0; }
// Returns all values that a group has: one of a deterministic solver, none of a printed summary.
inline std::span<const double> values_of(const Group& group) {
  if (const Sample* const sample = sample_of(group)) return sample->values;
  if (const ExcludedSample* const sample = excluded(group)) return sample->values;
  return {};
}

// Positive values, which are compared by their ratio.
struct Ratios {
  double floor = 0;                        // a smaller value counts as this
  bool is_conditional_on_success = false;  // costs of solved targets only, so that each group has its own targets
};
// Values of any sign, which are compared by their difference.
struct Differences {
  bool is_conditional_on_success = false;  // as for ratios
};
// Shares of successes from 0 to 1, which are compared by their difference.
struct Proportions {
  int trials_per_value = 1;  // 1: each value is 0 or 1
};
// Logarithms of costs. Their means are compared, so that the effect is a ratio.
struct LogCosts {
  bool is_per_success = false;  // expected running time: cost of all attempts / number of targets solved
};
// The kind of the values of a metric, with what only this kind has.
using SampleKind = std::variant<Ratios, Differences, Proportions, LogCosts>;

// All samples of one metric with the design: what the values are, and which belong together.
struct MetricSamples {
  std::string metric;    // name in files and anchors: "error"
  std::string quantity;  // name in text: "position error"
  std::string unit = {};
  QuantityKind quantity_kind = QuantityKind::other;
  Better better = Better::smaller;
  SampleKind kind = Ratios{};
  double absolute_margin = 0;    // margin of the plan in this unit; 0: the margin is relative
  double resolution = 0;         // values that differ by no more are equal
  bool is_random = true;         // false: of a grid of targets, which are chosen: no intervals, tests or ranks
  bool is_paired = false;        // values of one block belong together
  bool may_hold_copies = false;  // unpaired rows of a file, which nothing says are measurements of their own
  int min_blocks = 0;            // common blocks that a pair needs, if values are made by session; otherwise 0
  std::vector<Group> groups = {};
  std::vector<Warning> warnings = {};
};

inline bool is_proportion(const MetricSamples& samples) { return std::holds_alternative<Proportions>(samples.kind); }
inline bool is_log_scale(const MetricSamples& samples) { return std::holds_alternative<LogCosts>(samples.kind); }
// Returns whether the values are costs per success (expected running time).
inline bool is_cost_per_success(const MetricSamples& samples) {
  const LogCosts* const costs = std::get_if<LogCosts>(&samples.kind);
  return costs != nullptr && costs->is_per_success;
}
// Returns whether each group has values of its own solved targets only, so that numbers of two groups must not be
// compared outside of a comparison.
inline bool is_conditional_on_success(const MetricSamples& samples) {
  if (const Ratios* const ratios = std::get_if<Ratios>(&samples.kind)) return ratios->is_conditional_on_success;
  const Differences* const differences = std::get_if<Differences>(&samples.kind);
  return differences != nullptr && differences->is_conditional_on_success;
}
// Returns the value below which values are equal; 0 if the metric has none.
inline double floor_of(const MetricSamples& samples) {
  const Ratios* const ratios = std::get_if<Ratios>(&samples.kind);
  return ratios == nullptr ? 0 : ratios->floor;
}
// Returns the attempts that a value is made of, if the values are proportions; otherwise 1.
inline int trials_per_value(const MetricSamples& samples) {
  const Proportions* const proportions = std::get_if<Proportions>(&samples.kind);
  return proportions == nullptr ? 1 : proportions->trials_per_value;
}
// Returns the effect that a comparison by ranks estimates. A comparison of means estimates a difference in place of a
// ratio (Comparison::scale).
inline EffectScale effect_scale(const MetricSamples& samples) {
  if (std::holds_alternative<Differences>(samples.kind)) return EffectScale::difference;
  return is_proportion(samples) ? EffectScale::share : EffectScale::ratio;
}

// Returns the index of the group with this name; the number of groups if no group has it.
inline std::size_t index_of(const MetricSamples& samples, std::string_view name) {
  return static_cast<std::size_t>(std::ranges::find(samples.groups, name, &Group::name) - samples.groups.begin());
}

}  // namespace ikbench::judge
