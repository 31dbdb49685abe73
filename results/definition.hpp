// A study as plain data, read from the definition that the store keeps (JSON): what judging needs of it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "results/figure_style.hpp"
#include "results/plan.hpp"

namespace ikbench::results {

struct Definition {
  struct Stop {
    double tolerance_cm = 0, tolerance_deg = 0, seconds = 0;  // 0: none
    std::int64_t iterations = 0, evaluations = 0;
  };
  std::string title, published, robot, search, start, path, bounds, limits;
  std::string base_link, tip_link;     // of an arm from a URDF file
  std::vector<std::string> arm_notes;  // what of the file was not taken as it stands
  int runs = 0, points = 0;
  std::int64_t seed = 0;
  bool draws_targets = false;  // for every run anew
  Stop stop;
  std::vector<std::string> departures;       // settings that differ from the published study
  std::vector<std::string> missing_solvers;  // of the published study
  int out_of_reach = 0;                      // targets that no configuration reaches
  std::string arm;                           // JSON, as robots/robot.hpp reads it
  std::string task;                          // JSON: starts, the weight of a rotation, and how targets are drawn
  Plan plan;
  FigureStyle style;

  // Each solve begins where the last one left the arm.
  bool is_chained() const { return start == "previous"; }
  // Says what is solved.
  bool has_direction() const { return search == "pose" || search == "axis"; }
  bool has_tolerance() const { return stop.tolerance_cm > 0 || stop.tolerance_deg > 0; }
};

// Members that the text lacks keep their defaults. Throws std::invalid_argument if it is no JSON object, or with the
// study's name and the member whose value cannot be.
Definition definition_of(std::string_view json);
// The part "analysis" of a definition, also as a session recorded it.
Plan plan_of(std::string_view json);

}  // namespace ikbench::results
