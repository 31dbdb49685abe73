// Swept settings: entries of a study that a sweep made of one solver, what they reached, and whether the effect of one
// setting depends on another.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/inference/evidence.hpp"
#include "analysis/inference/metrics.hpp"
#include "analysis/inference/study.hpp"
#include "analysis/statistics/interaction.hpp"

namespace ikbench::inference {

// The entries of one solver, one for each combination of values of its settings.
struct SweptFamily {
  struct Setting {
    std::string name;
    std::vector<std::string> values = {};  // in the order of the study
  };
  struct Member {
    std::string label;
    std::vector<std::size_t> at;  // its value of each setting
  };
  std::string name;
  std::vector<Setting> settings = {};
  std::vector<Member> members = {};
};

// The families of a study, in its order; none if nothing was swept.
std::vector<SweptFamily> swept_families(const StudyResults& study);

// A quantity over all solvers of a study, described only.
struct SweptQuantity {
  Observations observations;
  Evidence evidence;

  Estimate of(const std::string& label) const;  // the mean with its interval; of logarithms a geometric mean
  bool is_better(double one, double other) const;
};

// The quantities of a sweep: what decides the study, and the average of each metric.
std::vector<SweptQuantity> swept_quantities(const StudyResults& study, const std::vector<Metric>& metrics);

// The families of which the quantity has values: that of others was not counted, or is not compared.
std::vector<SweptFamily> with_values(std::vector<SweptFamily> families, const SweptQuantity& quantity);

// The interaction of two settings of a family. Of further settings the averages over their values count.
struct SettingsInteraction {
  std::size_t first, second;           // of the family's settings
  statistics::Interaction found = {};  // of logarithms if the quantity's are compared; corners are a ratio then
  bool depends = false;                // the plan's significance shows that the effect of one depends on the other
};

std::vector<SettingsInteraction> interactions(const SweptFamily& family, const SweptQuantity& quantity);

}  // namespace ikbench::inference
