// A study's plan, made before its data are seen, for judging them. It decides no number of a solve. The store keeps it
// with the study and with every session, so that a later change shows.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "results/deciding_tests.hpp"

namespace ikbench::results {

// One observation: a run's mean over its points, or a single solve. Points of one run depend on each other.
enum class Unit { run, point };

// The summary of single values in an observation. mean: the mean, which the worst cases decide if values span decades.
// typical: the mean of logarithms, so the geometric mean. reliability: the share within a distance.
enum class Estimand { mean, typical, reliability };

// Says whether times of programs, which contain messages and another language, are ranked with times of built-in
// solvers.
enum class ProgramTimes { apart, compared };

constexpr std::array<std::string_view, 2> unit_names{"run", "point"};
constexpr std::array<std::string_view, 3> estimand_names{"mean", "typical", "reliability"};

constexpr std::array<std::string_view, 2> program_times_names{"apart", "compared"};

constexpr std::string_view name_of(Unit unit) { return unit_names[static_cast<std::size_t>(unit)]; }
constexpr std::string_view name_of(Estimand estimand) { return estimand_names[static_cast<std::size_t>(estimand)]; }
constexpr std::string_view name_of(ProgramTimes times) { return program_times_names[static_cast<std::size_t>(times)]; }

struct AnalysisPlan {
  // Name of the deciding test (deciding_tests.hpp). by_design: the studentized bootstrap of the means, within blocks if
  // all solvers share targets; Tamhane's test if only summaries are known. It does not depend on the data.
  std::string test{by_design};
  std::string control;         // label to compare the others with; empty: compare every pair
  double significance = 0.05;  // of a test; intervals have the level 1 - significance
  double margin = 0.05;        // relative difference that matters; within it two solvers count as the same
  double margin_cm = 0;        // the same for errors in cm; a difference within either margin does not matter
  int quartiles = 5;           // Hyndman-Fan type; 5 is MATLAB's
  Unit unit = Unit::run;
  std::vector<Estimand> estimands{Estimand::mean, Estimand::typical, Estimand::reliability};  // in this order
  double within_cm = 0.01;  // distance for reliability if the study has no tolerance; 0.1 mm, an arm's repeatability
  ProgramTimes program_times = ProgramTimes::apart;
};

}  // namespace ikbench::results
