// What the definition of a study (JSON, as the store has it) says of its task, read once. A text is empty, and a number
// not defined, where the definition says nothing or something else.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/statistics/descriptive.hpp"
#include "results/same_solves.hpp"

namespace ikbench::inference {

using results::decide_no_solve;
using statistics::not_defined;

struct StudyFacts {
  struct Stop {
    double tolerance_cm = not_defined;
    double tolerance_deg = not_defined;
    double evaluations = not_defined;
    double seconds = not_defined;
  };
  struct Path {
    std::string kind = {};
    std::string phase = {};
    std::vector<double> centre_cm = {};  // none where not all of them are numbers
    double radius_cm = not_defined;
    double length_cm = not_defined;
    double turns = not_defined;
    double start_deg = not_defined;
  };
  // As the program found it before it solved the study.
  struct OutOfReach {
    double points = not_defined;
    double farthest_point = not_defined;
    double farthest_cm = not_defined;
    double reach_cm = not_defined;
  };

  std::string json = {};  // the whole definition; empty where there is none
  std::string title = {};
  std::string published = {};  // paper whose printed tables it is held against (results/published), or empty
  std::string robot = {};
  std::string start = {};
  std::vector<std::string> departures = {};       // what of the published study's definition was changed
  std::vector<std::string> missing_solvers = {};  // of the published study
  bool enforces_limits = false;
  bool draws_targets = false;         // anew for every run; else the targets of a run follow each other
  bool orientation = true;            // is searched for, and not the position alone
  bool pose = false;                  // is searched for with all joints
  bool wrist = false;                 // its centre is searched for
  std::set<std::size_t> slides = {};  // the joints that slide, from 0
  double seed = not_defined;
  double repeats = not_defined;
  double deadline_ms = not_defined;
  Stop stop = {};
  Path path = {};
  OutOfReach out_of_reach = {};
  nlohmann::json arm = {};  // null where there is none

  // Each solve has a start of its own, the same for all solvers, and not the answer before it.
  bool starts_anew() const { return !start.empty() && start != "previous"; }
};

StudyFacts facts_of(std::string json);
StudyFacts facts_of(const nlohmann::json& parsed, std::string json);  // where it was parsed before

// An option of a series (JSON) that is a text; empty where there is none.
std::string text_option(std::string_view options, const std::string& name);

}  // namespace ikbench::inference
