// The one place where findings become sentences: first facts, in the order in which they are told, then their words.
#pragma once

#include <string>
#include <vector>

#include "analysis/show/report_model.hpp"

namespace ikbench::show {

// What is said of each of some solvers, or of each pair of them.
struct Statement {
  enum class StatementKind {
    no_comparison,  // nothing is compared
    best,           // each pair of who is the same or equal; each is better than each of against
    equivalent,     // each pair; with against each with that one, as all below
    inconclusive,   // each pair
    none_better,    // nobody is shown to be better than one of who
    better,         // than against
    worse,          // than against
    not_tested,     // against; without one: each pair
    cyclic          // each is worse than another
  };
  StatementKind kind = StatementKind::no_comparison;
  std::vector<std::string> solvers, against = {};
  bool is_below_margin = false;  // a difference, of each pair less than the margin
};
// Of a metric, among these, which are in the order of the table.
std::vector<Statement> statements_of(const judge::JudgedMetric& judged, const std::vector<std::string>& among);

// What the headline asks: the deciding metric of all solvers; then, of a study without a control of several, among
// those whom it leaves open, the first metric of its plan that is judged. Pairs and p are those of all solvers, so that
// the first question chooses none, and the second has a significance of its own.
struct HeadlineQuestion {
  const judge::JudgedMetric* metric = nullptr;
  std::vector<Statement> statements;
  std::string preface = {};  // "Time is not judged (the machine was busy). "
};
std::vector<HeadlineQuestion> headline_questions(const ReportModel& answer);

// "DLS (solved 100 of 100 targets) is best; PSO (88) is worse." "LM and DLS solved all 100 targets, SLSQP 99 (not
// decided); Newton (77) is worse. LM is the fastest; DLS takes 1.2 times as long."
std::string headline(const ReportModel& answer);
std::string tie_breaker_sentence(const ReportModel& answer);  // of it alone; empty if there is none
std::string ranking_note(const ReportModel& answer);  // "Judged by solved, then time"; empty if nothing else is won

}  // namespace ikbench::show
