// The task of a study, read once from its definition (JSON in the store). A text is empty and a number not defined if
// the definition lacks it or has another type.
#pragma once

#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::inference {

using statistics::not_defined;

struct StudyFacts {
  struct Stop {
    double tolerance_cm = not_defined;
    double tolerance_deg = not_defined;
    double iterations = not_defined;
    double evaluations = not_defined;
    double seconds = not_defined;
  };
  // Targets out of reach, as the program found before it solved the study.
  struct OutOfReach {
    double points = not_defined;
    double farthest_point = not_defined;
    double farthest_cm = not_defined;
    double reach_cm = not_defined;
  };

  std::string json = {};  // the whole definition; empty if there is none
  std::string title = {};
  std::string published = {};  // paper whose printed tables it is compared with (results/published), or empty
  std::string robot = {};
  std::string start = {};
  std::vector<std::string> departures = {};       // changes to the published study's definition
  std::vector<std::string> missing_solvers = {};  // solvers of the published study that are missing
  bool enforces_limits = false;
  bool draws_targets = false;         // targets are drawn anew for every run; else they form a path
  bool orientation = true;            // the solver searches for orientation too
  bool pose = false;                  // the solver searches for the pose with all joints
  bool wrist = false;                 // the solver searches for the wrist's centre
  std::set<std::size_t> slides = {};  // indices of prismatic joints, from 0
  double seed = not_defined;
  double deadline_ms = not_defined;
  Stop stop = {};
  std::string path = {};  // kind of path, or empty
  OutOfReach out_of_reach = {};
  nlohmann::json arm = {};  // null if there is none

  // Returns whether each solve has its own start, the same for all solvers, rather than the previous answer.
  bool starts_anew() const { return !start.empty() && start != "previous"; }
};

StudyFacts facts_of(std::string json);
StudyFacts facts_of(const nlohmann::json& parsed, std::string json);  // for JSON that is already parsed

// A text option of a series (JSON); empty if there is none.
std::string text_option(std::string_view options, const std::string& name);

}  // namespace ikbench::inference
