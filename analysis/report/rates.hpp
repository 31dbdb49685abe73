// The solved poses of studies that are reported together, a row an arm, beside printed shares where there are some.
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
  double level = 0;                                 // of the intervals; 0: nothing is told
  std::string caption = {};                         // of the figure, besides the level
  std::string paper = {}, table = {};               // of the printed shares [%], a row an arm; empty: none are printed
  std::string note = {};                            // what is printed
  std::vector<int> iterations = {};                 // within which a share is told too: the same solves, ended earlier
  std::map<std::string, std::string> rows = {};     // by our arm, what the printed table calls it in its column `arm`
  std::map<std::string, std::string> columns = {};  // by solver, its printed column
};

// The share of the poses of one arm that one solver solves.
struct Rate {
  std::string solver;
  double printed = statistics::not_defined;
  statistics::Proportion ours = {};  // in all iterations, with Wilson's interval; undefined where it is not solved here
  std::vector<statistics::Proportion> within = {};  // so many iterations as the plan has
  int first = 0, last = 0;  // our interval contains the printed share within so many iterations; 0 if it never does

  bool is_as_printed() const { return ours.low <= printed && printed <= ours.high; }
};

struct RatesOfArm {
  std::string arm;  // as the printed table has it
  int iterations;   // most of a solve
  std::vector<Rate> rates;
  const inference::JudgedStudy* study;
};

// One row for each arm of the study and its companions, in their order. An arm without solves is left out, and so is
// one that is not in the table where there is one.
std::vector<RatesOfArm> solve_rates(const Reported& reported, const RatesPlan& plan);

// Adds the tables solve-rates and, where iterations are planned, solve-rates-iterations, and the figure
// solve-rates-figure; none where no arm is solved.
void add_rates(StudyPieces& pieces, const Reported& reported, const RatesPlan& plan);

}  // namespace ikbench::report
