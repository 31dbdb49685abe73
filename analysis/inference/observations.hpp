// What the statistics are asked about: observations of one quantity in groups, whoever made them - a store, a user's
// CSV - or what was published of them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/inference/doubt.hpp"
#include "analysis/statistics/descriptive.hpp"

namespace ikbench::inference {

enum class Better { smaller, larger };

// log10: values are logarithms, their means are told as geometric means and differences of means as ratios.
enum class ValueScale { plain, log10 };

struct Group {
  std::string name;
  std::vector<double> values = {};
  // What the single values span of which these are means (statistics::decades); not defined where these are single
  // themselves.
  double decades = statistics::not_defined;
  // The number of runs that all gave this one value, because the solver repeats its answers; 0 where values vary. Such
  // a value is known without chance.
  int copies = 0;
};

struct Observations {
  std::string name;       // of files and anchors: "error", "variation"; lower-case letters, digits and '-'
  std::string quantity;   // with its unit in brackets: "position error [cm]"
  std::string unit = {};  // of the values; empty where there is none, or nobody says
  Better better = Better::smaller;
  ValueScale scale = ValueScale::plain;
  std::vector<Group> groups = {};  // values may be infinite, and NaN where a solver diverged
  // Names of the blocks (targets, problems) where every group was given the same: values[i] of each group is of
  // blocks[i]. Empty where groups are independent samples.
  std::vector<std::string> blocks = {};
  std::string replicate = {};           // what one observation is, in words: "a run's mean over its 20 points"
  std::string block = {};               // what one block is, in words; empty where there are none
  std::string block_noun = "blocks";    // as they are called in sentences: "targets"
  std::vector<std::string> notes = {};  // missing values, incomplete blocks left out, times that are not clean, ...
  double margin = 0;                    // absolute, in the unit of the values; 0: none but the plan's
  Doubts flaws = {};  // why not to take them at their word: no replicates, values missing, times that are not clean
};

struct SummaryGroup {
  std::string name;
  statistics::GroupSummary summary;
};

struct Summaries {
  std::string name;
  std::string quantity;
  std::string unit = {};
  Better better = Better::smaller;
  std::vector<SummaryGroup> groups = {};
  std::vector<std::string> notes = {};
  double margin = 0;  // as of Observations
};

}  // namespace ikbench::inference
