// Observations of one metric in groups, as `compare` and `describe` take them: what is odd was settled before.
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

enum class Better { smaller, larger };

// What a comparison estimates: first / second, first - second, or the difference of shares from 0 to 1. It belongs to
// the metric, whatever the values are.
enum class EffectScale { ratio, difference, share };

// The kind of quantity, for code that treats some kinds specially. Times are compared where they are comparable,
// whatever is made of them.
enum class QuantityKind { other, solved, answered, position, angle, motion, time, evaluations };

// What is known of a group: one of these.
struct Sample {
  std::vector<double> values = {};  // infinite: no answer, worse than any
  std::vector<int> blocks = {};     // where paired: of each value, rising; none: those of all groups are the same
  bool is_deterministic = false;    // the one value stands for all runs
  bool is_constant = false;         // all values are one, and nobody knows whether the solver repeats itself
  double effective_n = 0;           // of logarithms of costs: how many equal ones would tell as much
  double solved_targets = 0;        // of the same: the targets solved
};
struct SummaryStatistics {  // as papers print it
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
struct ExcludedSample {  // not compared; what there is can be described
  ExclusionReason reason = ExclusionReason::missing_values;
  int missing = 0;  // observations without a value
  std::vector<double> values = {};
  std::optional<SummaryStatistics> printed = {};
};
using GroupData = std::variant<Sample, SummaryStatistics, ExcludedSample>;

struct Group {
  std::string name = {};
  GroupData sample = {};
  double tolerance = 0;     // values at or below count as this, the tolerance; 0: none
  int pooled_n = 0;         // of shares by session: of all observations, whose share is
  double pooled_share = 0;  // this; 0: what is described are the values
};

// Null if it is compared.
inline const ExcludedSample* excluded(const Group& group) { return std::get_if<ExcludedSample>(&group.sample); }
inline const Sample* sample_of(const Group& group) { return std::get_if<Sample>(&group.sample); }
inline bool repeats_itself(const Group& group) { return sample_of(group) && sample_of(group)->is_deterministic; }
inline bool is_constant(const Group& group) { return sample_of(group) && sample_of(group)->is_constant; }
// Observations without a value.
inline int missing_in(const Group& group) { return excluded(group) ? excluded(group)->missing : 0; }
// All that a group has: of one that repeats itself one, of a summary none.
inline std::span<const double> values_of(const Group& group) {
  if (const Sample* const its = sample_of(group)) return its->values;
  if (const ExcludedSample* const its = excluded(group)) return its->values;
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

struct MetricSamples {
  std::string metric;    // of files and anchors: "error"
  std::string quantity;  // "position error"
  std::string unit = {};
  QuantityKind quantity_kind = QuantityKind::other;
  Better better = Better::smaller;
  SampleKind kind = Ratios{};
  double absolute_margin = 0;    // of the plan, in this unit
  double resolution = 0;         // values that differ by no more are equal
  bool is_paired = false;        // values of one block belong together; without blocks, values[i]
  bool may_hold_copies = false;  // rows of a file, of which nothing says that each is a measurement of its own
  int min_blocks = 0;            // common blocks that a pair needs
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
// Returns what a comparison of the metric estimates, if its values are not compared by means.
inline EffectScale effect_scale(const MetricSamples& samples) {
  if (std::holds_alternative<Differences>(samples.kind)) return EffectScale::difference;
  return is_proportion(samples) ? EffectScale::share : EffectScale::ratio;
}

// The place of a group; their number if there is none of this name.
inline std::size_t index_of(const MetricSamples& samples, std::string_view name) {
  return static_cast<std::size_t>(std::ranges::find(samples.groups, name, &Group::name) - samples.groups.begin());
}

}  // namespace ikbench::judge
