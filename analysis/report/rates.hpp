// Shares of solved poses in a study and its companions, one row per arm, beside the printed shares.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "analysis/inference/judged_study.hpp"
#include "analysis/report/study_pieces.hpp"
#include "analysis/statistics/proportion.hpp"

namespace ikbench::report {

struct Reported;

struct RatesPlan {
  double level = 0;                                 // level of the intervals; 0: no rates are reported
  std::string caption = {};                         // caption of the figure, without the level
  std::string paper = {}, table = {};               // source of the printed shares [%], one row per arm
  std::string note = {};                            // describes the printed shares
  int iterations = 0;                               // up to how many are tried for the printed share
  std::map<std::string, std::string> rows = {};     // our arm to its name in the printed table's column `arm`
  std::map<std::string, std::string> columns = {};  // solver to its printed column
};

// The share of the poses of one arm that one solver solves.
struct Rate {
  std::string solver;
  double printed = statistics::not_defined;
  statistics::Estimate ours = {};  // in all iterations, with Wilson's interval; undefined if not solved here
  int first = 0,
      last = 0;  // first and last iteration count at which our interval contains the printed share; 0 if none

  bool is_as_printed() const { return ours.low <= printed && printed <= ours.high; }
};

struct RatesOfArm {
  std::string arm;  // name in the printed table
  int iterations;   // maximum of a solve
  std::vector<Rate> rates;
  const inference::JudgedStudy* study;
};

// One row per arm of the study and its companions, in their order. Leaves out arms without solves, and arms missing
// from the printed table.
std::vector<RatesOfArm> solve_rates(const Reported& reported, const RatesPlan& plan);

// Adds the table solve-rates and the figure solve-rates-figure; nothing if no arm is solved.
void add_rates(StudyPieces& pieces, const Reported& reported, const RatesPlan& plan);

}  // namespace ikbench::report
