// Is one metric of a solver's variant better, the same or worse than its baseline's, by more than a margin that
// matters? Tests of the ratio of means against the margin, equivalence too (analysis/statistics/mean_ratio.hpp).
#pragma once

#include <array>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/inference/metrics.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "analysis/statistics/effect_size.hpp"
#include "analysis/statistics/mean_ratio.hpp"

namespace ikbench::inference {

// Of b held against a, by more than the margin, or by less than it. not_worse: shown not to be worse by more than the
// margin, but neither shown better by more than it nor the same within it. not_counted: evaluations that nobody counted
// in one of the two; nothing can be done about that, so that it is no failure of a comparison.
enum class Outcome {
  better,
  better_by_less,
  same,
  worse_by_less,
  not_worse,
  undecided,
  worse,
  not_compared,
  not_counted
};
constexpr std::array<std::string_view, 9> outcome_names{"better",        "better by less", "same",
                                                        "worse by less", "not worse",      "undecided",
                                                        "worse",         "not compared",   "not compared"};
constexpr std::string_view name_of(Outcome outcome) { return outcome_names[static_cast<std::size_t>(outcome)]; }

// Within the ranges of results/analysis_plan_fields.hpp.
struct MarginQuestion {
  double margin = 0.05;        // relative difference that matters
  double margin_cm = 0;        // the same in cm, of errors in cm; a difference within either does not matter
  double significance = 0.05;  // of all tests for worse together, and for better; intervals: 1 - 2 significance
  double power = 0.8;          // of the numbers of observations that would decide
};

// As it is about one metric, by its column: without a margin in cm where that is in another unit.
MarginQuestion question_about(std::string_view metric, const MarginQuestion& question);

struct MetricSamples {
  Metric metric;
  std::span<const double> a;
  std::span<const double> b;
  std::string_view observation = "run";  // what one value is of: "run" or "target"
  bool paired = false;                   // a[i] and b[i] had the same targets, and those of i other than those of j
  bool same_bits = false;                // every solve has the same value in both; of a share, the same error too
  bool are_copies = false;               // the runs of a repeat each other to the bit, and so do those of b
  int tests = 1;                         // how many are decided together, of all labels and metrics
  std::string not_compared = {};         // why the two cannot be compared; empty where they can
  bool is_counted = true;                // of evaluations: somebody counted them in every solve of both
};

struct MetricComparison {
  std::string_view metric;
  std::string_view observation = "run";
  Outcome outcome = Outcome::undecided;
  bool is_fact = false;  // there is no chance in it, and no p
  std::string remark;    // what the numbers beside it do not say; may be empty
  statistics::GroupSummary a;
  statistics::GroupSummary b;
  statistics::RatioComparison ratio;  // b / a, of the finite observations; p = 0 of no spread is an exact test's p here
  int mean_favours = 0;               // 1: the mean of b is the better, -1: the worse; of the finite observations
  double p_worse =
      statistics::not_defined;  // H0: not worse by more than the margin; as `decide` leaves it, corrected by Holm
  double p_better = statistics::not_defined;     // H0: not better by more than the margin; likewise
  double p_not_worse = statistics::not_defined;  // H0: worse by the margin or more
  statistics::EffectSize b_better;  // Vargha and Delaney's A12: P(one of b is better) + P(as good) / 2, of any two
  double p_ranks = statistics::not_defined;      // the sign test where paired, else Mann-Whitney; two-sided
  int ranks_favour = 0;                          // 1: the ranks are for b, -1: for a
  double n_to_decide = statistics::not_defined;  // observations a side that show a difference of the margin, or none
};

// Everything but the outcome, which is undecided here unless it is a fact. A fact is what is the same to the bit, or
// rounding, or a constant count within the margin; what is worse is never a fact, but a test's finding. Where some
// answers are not finite, how many there are (Fisher's exact test) and the means of the others are tested together:
// either may be worse, and better has neither against it. std::invalid_argument where the question is out of range, or
// pairs are not equally many.
MetricComparison compare_metric(const MetricSamples& samples, const MarginQuestion& question);

}  // namespace ikbench::inference
