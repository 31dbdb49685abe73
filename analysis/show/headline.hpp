// The one place where findings become sentences: first facts, in the order in which they are told, then their words.
#pragma once

#include <string>
#include <vector>

#include "analysis/show/report_model.hpp"

namespace ikbench::show {

// What is said of each of some solvers, or of each pair of them.
struct Said {
  enum class What {
    numbers,     // nothing is compared
    best,        // each pair of who is the same or equal; each is better than each of against
    same,        // each pair; with against each with that one, as all below
    undecided,   // each pair
    unbeaten,    // nobody is shown to be better than one of who
    better,      // than against
    worse,       // than against
    not_tested,  // against; without one: each pair
    circle       // each is worse than another
  };
  What what = What::numbers;
  std::vector<std::string> who, against = {};
  bool is_little = false;  // a difference, of each pair less than the margin
};
// Of a metric, among these, which are in the order of the table.
std::vector<Said> statements_of(const judge::JudgedMetric& judged, const std::vector<std::string>& among);

// What the headline asks: the deciding metric of all solvers; then, of a study without a control of several, among
// those whom it leaves open, the first metric of its plan that is judged. Pairs and p are those of all solvers, so that
// the first question chooses none, and the second has a significance of its own.
struct Question {
  const judge::JudgedMetric* of = nullptr;
  std::vector<Said> said;
  std::string before = {};  // "Time is not judged (the machine was busy). "
};
std::vector<Question> headline_questions(const Answer& answer);

// "DLS (solved 100 of 100 targets) is best; PSO (88) is worse." "LM and DLS solved all 100 targets, SLSQP 99 (not
// decided); Newton (77) is worse. LM is the fastest; DLS takes 1.2 times as long."
std::string headline(const Answer& answer);
std::string tie_breaker_sentence(const Answer& answer);  // of it alone; empty if there is none
std::string ranking_note(const Answer& answer);          // "Judged by solved, then time"; empty if nothing else is won

}  // namespace ikbench::show
