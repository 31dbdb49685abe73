// A solver's variant held against its baseline, label by label: what may be compared, what of it is an observation, and
// what the metrics (analysis/inference/variant_metric.hpp) say together.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/inference/study.hpp"
#include "analysis/inference/variant_metric.hpp"
#include "results/store.hpp"

namespace ikbench::inference {

// What one label of a study did.
struct Variant {
  results::Series series;
  StudyResults study;                           // its whole study's, with the solves of that label alone
  std::vector<results::Session> sessions = {};  // those that solved it
  std::string timing = {};  // why times of its whole study are not comparable, as a report has it; empty where they are
};

// One for each label of the study, in its order. std::invalid_argument as make_study.
std::vector<Variant> variants(const results::Store& store, const results::StudyEntry& study);

// One label: the candidate b, held against the baseline a.
struct VariantPair {
  const Variant& a;
  const Variant& b;
};

struct VariantComparison {
  std::string label;
  bool paired = false;
  std::string design;  // whether observations are compared in pairs, and why, in a sentence
  std::vector<MetricComparison> metrics;
  std::vector<std::string> notes;  // what is left out, and in what the two differ beside their numbers
};

// The metrics named, or where none is those of compared_metrics(), and of poses the orientation error. Observations are
// paired where both were given the same problems, as those of a report are (analysis/inference/design.hpp): targets
// drawn in every run are paired run by run, and target by target where each starts from the initial configuration; so
// are the targets of a path then, whose values are means over the runs. Runs chained along a path are independent
// samples. Runs with points missing give nothing. Times are compared only where both are clean, of one CPU and of the
// same sessions, evaluations only where they were counted. All pairs are decided together. std::invalid_argument where
// a metric is unknown, one side has no complete run, or the two were not given the same to do: another robot, other
// targets, another configuration to start from.
std::vector<VariantComparison> compare_variants(const std::vector<VariantPair>& pairs,
                                                std::span<const std::string> metrics, const MarginQuestion& question);
// The same before anything is decided: p-values uncorrected, and undecided whatever is not a fact.
std::vector<VariantComparison> examine_variants(const std::vector<VariantPair>& pairs,
                                                std::span<const std::string> metrics, const MarginQuestion& question);

int count(std::span<const VariantComparison> comparisons, Outcome outcome);

}  // namespace ikbench::inference
