// One row per solve: everything that is remembered of it. The columns are listed once, in for_each_column;
// the store's schema, its reader, CSV, JSON and `ikbench list columns` derive from that list.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ikbench::results {

// Why a solve ended.
enum class StopReason { iterations, tolerance, evaluations, time, not_finite };

// What the verifier says of an answer; the first that applies, in the order of severity
// not_finite, claimed_but_wrong, refused, limit_violated, tolerance_missed, ok. Where a study enforces the joint
// limits, an answer that violates them is refused: the arm stays where it was, and the record's answer is that.
enum class Status { ok, tolerance_missed, limit_violated, refused, claimed_but_wrong, not_finite };

// Under what circumstances the times were taken; only `clean` times are comparable.
enum class Timing { clean, parallel, debug_build };

constexpr std::array<std::string_view, 5> stop_reason_names{"iterations", "tolerance", "evaluations", "time",
                                                            "not_finite"};
constexpr std::array<std::string_view, 6> status_names{"ok",      "tolerance_missed",  "limit_violated",
                                                       "refused", "claimed_but_wrong", "not_finite"};
constexpr std::array<std::string_view, 3> timing_names{"clean", "parallel", "debug_build"};

constexpr const auto& names_of(StopReason) { return stop_reason_names; }
constexpr const auto& names_of(Status) { return status_names; }
constexpr const auto& names_of(Timing) { return timing_names; }

template <class Enum>
constexpr std::string_view name_of(Enum value) {
  return names_of(value)[static_cast<std::size_t>(value)];
}

// The key of a series is CONFIGURATION@SOURCE: a hash of what the study asks for, and one of the code that solved it.
// The first stores have the configuration alone.
constexpr char before_source = '@';
constexpr std::string_view configuration_of(std::string_view series) {
  return series.substr(0, series.find(before_source));
}

struct SolveRecord {
  std::string study;
  std::string robot;
  std::string solver;                      // the label under which the solver takes part in the study
  std::string series;                      // key of everything that decides the numbers of this solver in this study
  int run = 1;                             // from 1
  int point = 1;                           // from 1, in the order of the path
  std::vector<double> target_position_m;   // x, y, z
  std::vector<double> target_rotation;     // 9 elements of the rotation matrix, row by row
  std::vector<double> start_rad;           // Theta_s, all joints
  std::vector<double> answer_rad;          // all joints
  std::vector<double> reached_position_m;  // x, y, z of the tool with that answer, by the verifier
  double position_error_cm = 0;            // Eq. 1, by the verifier
  double claimed_error_cm = 0;             // the solver's own word
  double orientation_error = 0;            // Eq. 3, by the verifier
  double variation_deg = 0;                // Eq. 12, over all joints
  double largest_move_deg = 0;             // largest move of a single joint
  double limit_violation_deg = 0;          // how far the worst joint is outside its limits; 0 inside
  std::int64_t evaluations = 0;
  std::int64_t iterations = 0;
  StopReason stop_reason = StopReason::iterations;
  Status status = Status::ok;
  double seconds = 0;      // steady clock, around the solve only
  double cpu_seconds = 0;  // CPU time of the thread, around the solve only
  Timing timing = Timing::clean;
  std::int64_t session = 0;      // the run of the program that solved it (table `sessions`)
  std::vector<double> trace_cm;  // best error after each iteration, where the study asked for it; else empty
};

template <class Visit>
void for_each_column(Visit&& visit) {
  visit("study", &SolveRecord::study, "name of the study");
  visit("robot", &SolveRecord::robot, "name of the robot");
  visit("solver", &SolveRecord::solver, "label of the solver in the study");
  visit("series", &SolveRecord::series,
        "hashes of everything that decides the numbers of this solver in this study, as CONFIGURATION@SOURCE");
  visit("run", &SolveRecord::run, "independent repetition, from 1");
  visit("point", &SolveRecord::point, "target within the run, from 1");
  visit("target_position_m", &SolveRecord::target_position_m, "target x, y, z [m]");
  visit("target_rotation", &SolveRecord::target_rotation, "target rotation matrix, row by row");
  visit("start_rad", &SolveRecord::start_rad, "configuration before the solve, all joints [rad]");
  visit("answer_rad", &SolveRecord::answer_rad, "configuration found, all joints [rad]");
  visit("reached_position_m", &SolveRecord::reached_position_m,
        "x, y, z of the tool with that configuration, by the verifier [m]");
  visit("position_error_cm", &SolveRecord::position_error_cm,
        "Euclidean distance to the target, recomputed by the verifier [cm] (Eq. 1)");
  visit("claimed_error_cm", &SolveRecord::claimed_error_cm, "position error that the solver reported [cm]");
  visit("orientation_error", &SolveRecord::orientation_error,
        "||R - Rd|| / ||Rd||, recomputed by the verifier (Eq. 3)");
  visit("variation_deg", &SolveRecord::variation_deg,
        "Euclidean norm of the joint move over all joints [deg] (Eq. 12)");
  visit("largest_move_deg", &SolveRecord::largest_move_deg, "largest move of a single joint [deg]");
  visit("limit_violation_deg", &SolveRecord::limit_violation_deg,
        "how far the worst joint is outside its limits; 0 inside [deg]");
  visit("evaluations", &SolveRecord::evaluations, "candidates evaluated");
  visit("iterations", &SolveRecord::iterations, "iterations done");
  visit("stop_reason", &SolveRecord::stop_reason,
        "why the solve ended: iterations, tolerance, evaluations, time, not_finite");
  visit(
      "status", &SolveRecord::status,
      "ok, tolerance_missed, limit_violated, refused (outside limits that the study enforces: the arm stayed where it "
      "was), claimed_but_wrong, not_finite");
  visit("seconds", &SolveRecord::seconds, "wall time of the solve [s]");
  visit("cpu_seconds", &SolveRecord::cpu_seconds, "CPU time of the solving thread [s]");
  visit("timing", &SolveRecord::timing,
        "clean, parallel (several solves at once) or debug_build; only clean times are comparable");
  visit("session", &SolveRecord::session, "which run of the program solved it");
  visit("trace_cm", &SolveRecord::trace_cm, "best error after each iteration [cm], where the study asked for a trace");
}

}  // namespace ikbench::results
