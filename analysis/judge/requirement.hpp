// Checks requirements on shares (results/requirement.hpp) by the intervals that reports show: Wilson's, with as many
// trials as there are values. If values are means of several solves, the intervals are conservative. Each solver is
// checked by itself: the level of one check is that of its interval, and is not shared with other solvers or
// comparisons. docs/explanation/methods.md has the errors of this rule.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/judge/statistics/two_sample_tests.hpp"
#include "results/requirement.hpp"

namespace ikbench::judge {

struct JudgedMetric;
struct JudgedStudy;

enum class RequirementVerdict {
  met,          // the whole interval is at or above the required share
  failed,       // the whole interval is below it
  inconclusive  // the interval holds it, or the share cannot be compared with it
};

struct RequirementCheck {
  std::string solver;
  std::string metric;   // slug: "solved"
  double required = 0;  // share, from 0 to 1
  RequirementVerdict verdict = RequirementVerdict::inconclusive;
  double share = 0;              // NaN without values
  double n = 0;                  // values: targets, or runs
  Interval interval = {0, 1};    // of the share
  bool are_counts = false;       // each value is a single solve
  bool is_exact = false;         // a deterministic solver on fixed targets: the share has no chance in it
  std::string reason = {};       // why the share cannot be compared with the required one; empty: it can
  bool is_strict = false;        // an inconclusive check fails the command
  std::int64_t more_values = 0;  // about so many further values would show it, if the share stays; 0: no number would
};

// Returns the check of one solver's share. `judged` must be a share with a group of this name.
RequirementCheck check_requirement(const JudgedMetric& judged, const std::string& solver, double required);

// Returns the checks of all requirements, in their order. A requirement without a solver is checked for each label of
// `own_solvers`, or for all labels if `own_solvers` is empty. With `is_strict`, inconclusive checks fail.
// Solvers without solves are not checked. Throws std::invalid_argument if the study lacks the share.
std::vector<RequirementCheck> check_requirements(const JudgedStudy& judged,
                                                 const std::vector<results::Requirement>& requirements,
                                                 const std::vector<std::string>& own_solvers, bool is_strict);

// Returns 3 if a requirement failed; otherwise 4 if one is inconclusive and strict; otherwise 0.
int exit_code(const std::vector<RequirementCheck>& checks);

}  // namespace ikbench::judge
