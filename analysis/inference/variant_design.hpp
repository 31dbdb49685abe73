// What of a variant and its baseline is an observation, and which of them belong together: the blocks of
// analysis/inference/design.hpp, for two.
#pragma once

#include <string>
#include <vector>

#include "analysis/inference/design.hpp"
#include "analysis/inference/variants.hpp"

namespace ikbench::inference {

// The solves whose mean is one observation.
struct Observed {
  std::string name;  // of the block: "run 2", "point 3"
  std::vector<const Solve*> solves;
};

struct VariantDesign {
  Blocks pairs = Blocks::none;  // what a and b have in common, one by one; none: independent runs
  std::vector<Observed> a;
  std::vector<Observed> b;
  int runs_of_a = 0;  // those that the observations are made of
  int runs_of_b = 0;
};

// std::invalid_argument where one side has no complete run, or they were not given the same to do.
VariantDesign variant_design(const Variant& a, const Variant& b);

// Whether observations are compared in pairs, and why, in a sentence.
std::string sentence_of(const VariantDesign& design, int points);

// `limit`: as counted_value takes it.
std::vector<double> values_of(const StudyResults& study, const std::vector<Observed>& observed, Metric metric,
                              double limit = statistics::not_defined);
// Whether every solve, or every run of what is of runs alone, has the same value in both.
bool has_same_bits(const StudyResults& of_a, const StudyResults& of_b, const VariantDesign& design, Metric metric);

}  // namespace ikbench::inference
