// What a study says before its data are seen about how they will be judged. It decides no number of a solve; it is kept
// with the study and with every session, so that a later change shows.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "results/deciding_tests.hpp"

namespace ikbench::results {

// How p-values of several contrasts are corrected for being several, where the method does not do so itself
// (those of means do).
enum class Adjustment { holm, hochberg, bonferroni, benjamini_hochberg };

// What one observation is: a run's mean over its points, or a single solve. Points of one run depend on each other.
enum class Unit { run, point };

// What of the single values an observation is made of. mean: their mean, which the worst cases decide where they span
// decades. typical: the mean of their logarithms, so the geometric mean. reliability: the share within a distance.
enum class Estimand { mean, typical, reliability };

// Whether times of programs, which have messages and another language in them, are ranked with those taken here.
enum class ProgramTimes { apart, compared };

constexpr std::array<std::string_view, 4> adjustment_names{"holm", "hochberg", "bonferroni", "benjamini_hochberg"};
constexpr std::array<std::string_view, 2> unit_names{"run", "point"};
constexpr std::array<std::string_view, 3> estimand_names{"mean", "typical", "reliability"};

constexpr std::array<std::string_view, 2> program_times_names{"apart", "compared"};

constexpr std::string_view name_of(Adjustment adjustment) {
  return adjustment_names[static_cast<std::size_t>(adjustment)];
}
constexpr std::string_view name_of(Unit unit) { return unit_names[static_cast<std::size_t>(unit)]; }
constexpr std::string_view name_of(Estimand estimand) { return estimand_names[static_cast<std::size_t>(estimand)]; }
constexpr std::string_view name_of(ProgramTimes times) { return program_times_names[static_cast<std::size_t>(times)]; }

struct AnalysisPlan {
  // Which test decides, by its name (deciding_tests.hpp). by_design: the studentized bootstrap of the means, within
  // blocks where the same targets are given to all, or Tamhane's test where only summaries are known; of times ranks.
  // The data have no say in it.
  std::string test{by_design};
  Adjustment adjustment = Adjustment::holm;
  std::string control;         // label that the others are held against; empty: every pair is compared
  double significance = 0.05;  // of a test; intervals have the level 1 - significance
  double margin = 0.05;        // relative difference that matters: below it two solvers count as the same
  double margin_cm = 0;        // the same in cm, for what is measured in cm; within either margin is within
  double power = 0.8;          // with which a difference of that size should be found
  int quartiles = 5;           // Hyndman-Fan type; 5 is MATLAB's
  Unit unit = Unit::run;
  std::vector<Estimand> estimands{Estimand::mean, Estimand::typical, Estimand::reliability};  // in this order
  double within_cm = 0.01;  // distance of reliability in a study without a tolerance; 0.1 mm, an arm's repeatability
  double jump_deg = 30;     // a joint that moves farther between two points of a path has jumped
  ProgramTimes program_times = ProgramTimes::apart;
};

}  // namespace ikbench::results
