// The fields of an analysis plan, listed once: name, member, range and meaning. Study files and the store's JSON are
// written and read by this list (experiments/, analysis/); the command line takes the ranges from it
// (cli/plan_options.cpp).
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "results/analysis_plan.hpp"

namespace ikbench::results {

// Names and values for an Io's `choice`, and for `chosen`, whose field has some of the values, in their order.
template <class Enum, std::size_t count>
std::vector<std::pair<std::string, Enum>> choices_of(const std::array<std::string_view, count>& names) {
  std::vector<std::pair<std::string, Enum>> choices;
  for (std::size_t i = 0; i < count; ++i) choices.emplace_back(names[i], static_cast<Enum>(i));
  return choices;
}

inline std::vector<std::pair<std::string, std::string>> choices_of_tests() {
  std::vector<std::pair<std::string, std::string>> choices{{std::string(by_design), std::string(by_design)}};
  for (const DecidingTest& test : deciding_tests()) choices.emplace_back(test.name, test.name);
  return choices;
}

// Ranges for study files, the command line and comparisons.
constexpr std::pair<double, double> significances{0.0001, 0.2}, margins_percent{0, 99}, margins_cm{0, 1000};

template <class Io>
void list_fields(Io& io, AnalysisPlan& plan) {
  constexpr double percent = 0.01;
  io.choice("test", plan.test, choices_of_tests(),
            "test that decides; by_design: bootstrap, within blocks if all solvers share the same targets");
  io.text("control", plan.control, "label to compare the others with; \"\": compare every pair");
  io.number("significance", plan.significance, 1, significances,
            "significance level of a test; intervals have level 1 - significance");
  io.number("margin_percent", plan.margin, percent, margins_percent,
            "smallest relative difference that matters; within it two solvers count as the same");
  io.number("margin_cm", plan.margin_cm, 1, margins_cm,
            "the same in cm, of errors in cm; a difference within either margin does not matter");
  io.whole("quartiles", plan.quartiles, {1, 9}, "Hyndman-Fan type of quartiles; 5 as in MATLAB");
  io.choice("unit", plan.unit, choices_of<Unit>(unit_names),
            "what one observation is: the mean of a run over its points, or a point, which needs --force");
  io.chosen("estimands", plan.estimands, choices_of<Estimand>(estimand_names),
            "what is compared of error and time; mean: its worst cases, typical: geometric mean, reliability: share of "
            "solves within a distance");
  io.number("within_cm", plan.within_cm, 1, {1e-6, 1000},
            "that distance if the study has no tolerance_cm; 0.01 is 0.1 mm, the repeatability of an arm");
  io.choice("program_times", plan.program_times, choices_of<ProgramTimes>(program_times_names),
            "times of programs, which have their messages in them; apart: not held against those of built-in solvers");
}

}  // namespace ikbench::results
