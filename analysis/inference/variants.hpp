// A candidate B and its baseline A: the solves of both make a study of two solvers, which is judged like any study
// (variant_comparison.hpp).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "analysis/inference/doubt.hpp"
#include "analysis/inference/study.hpp"
#include "results/store.hpp"

namespace ikbench::inference {

// One label of a study.
struct Variant {
  results::StudyEntry study;
  results::Series series;
  std::vector<results::Session> sessions = {};  // sessions of the store that has the label
  // Passes each solve of the label to `take`, ordered by run and point.
  std::function<void(const std::function<void(results::SolveRecord)>& take)> each_solve;
};

// Returns one variant per label, in the order of the study. `store` must outlive them.
std::vector<Variant> variants(const results::Store& store, const results::StudyEntry& study);

// The solves of both, as solvers "A" and "B", and the reasons not to compare their times.
struct VariantStudy {
  std::string label;
  bool is_of_two = false;  // A and B have different labels: "B against A"
  StudyResults study;
  Doubts times_differ;      // reasons not to compare times; empty if they are comparable
  std::string differences;  // settings, program and machine that differ between A and B
};

// Takes the definition and plan of A, but margins, significance and estimands from `plan`. Throws
// std::invalid_argument if one side has no complete run, or if robot, targets or start configurations differ.
VariantStudy study_of_both(const Variant& a, const Variant& b, const results::AnalysisPlan& plan);

}  // namespace ikbench::inference
