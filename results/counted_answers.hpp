// The counts of all answers to a study's targets: the known answers of each target, and how many of them each solver
// gave. `run` counts them once the solves are made, and reports read the counts. Definitions:
// docs/explanation/methods.md#all-answers.
#pragma once

#include <string>
#include <vector>

namespace ikbench::results {

constexpr int max_counted_targets = 2000;  // of a study, the first ones; further ones are not counted

// The known answers of a target.
struct KnownAnswers {
  int run = 1, point = 1;                 // run 1 if all runs have the same targets
  int known = 0;                          // different true answers inside the limits; 0 if one is singular
  bool is_continuum = false;              // a known answer is singular: there may be infinitely many
  std::vector<double> restarts_rad = {};  // [rad, m], answers of the restarts, one after another

  bool operator==(const KnownAnswers&) const = default;
};

// The answers that a solver gave to a target.
struct AnswerCount {
  std::string series;  // key of the solver
  int run = 1, point = 1;
  int given = 0;    // all of them
  int found = 0;    // known answers among them
  int wrong = 0;    // farther from the target than the tolerance
  int doubled = 0;  // true, but not different from an earlier one

  bool operator==(const AnswerCount&) const = default;
};

// All counts of a study.
struct CountedAnswers {
  std::string restarts_key = {};  // key of the series that the restarts would have; of other restarts, counts are old
  std::vector<KnownAnswers> targets = {};  // ordered by run and point
  std::vector<AnswerCount> counts = {};    // ordered by series, run and point

  bool operator==(const CountedAnswers&) const = default;
};

}  // namespace ikbench::results
