// What the headline says, as data: statements about the solvers of a metric, and the one or two questions that a report
// answers. `make_report_model` makes the questions once. headline.hpp puts them into words, and tables take their marks
// and their order from them. Costs one table of all pairs of a metric per question.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/judge/judge.hpp"

namespace ikbench::show {

// The comparisons among some solvers of a metric, by pair. Refers to the metric, which must outlive the index.
class PairIndex {
 public:
  PairIndex(const judge::JudgedMetric& judged, const std::vector<std::string>& solvers);

  bool is_empty() const { return is_empty_; }
  bool is_beaten(const std::string& name) const { return beaten_.contains(name); }
  int tested_pairs(const std::string& name) const;
  // Finds the comparison of two solvers in either order; null if they are no pair.
  const judge::Comparison* find(std::string_view first, std::string_view second) const;
  // Returns the verdict on `first` against `second`; not_tested if they are no pair.
  judge::Verdict verdict(std::string_view first, std::string_view second) const;
  bool is_better(std::string_view first, std::string_view second) const {
    return verdict(first, second) == judge::Verdict::better;
  }

 private:
  // Returns the index of a solver's group; the number of groups, which no pair has, for a name that is not indexed.
  std::size_t index(std::string_view name) const;

  judge::ComparisonTable table_;
  std::size_t groups_;
  std::map<std::string_view, std::size_t> indices_ = {};
  bool is_empty_ = true;
  std::map<std::string_view, int> tested_pairs_ = {};
  std::set<std::string> beaten_ = {};
};

// One clause of the headline, about each of some solvers or about each pair of them.
struct Statement {
  enum class StatementKind {
    no_comparison,  // nothing is compared
    best,           // each of `solvers` is better than each of `against`; pairs of `solvers` are equivalent or equal
    equivalent,     // each pair of `solvers`; if `against` is not empty, each of `solvers` with that one
    inconclusive,   // as for equivalent
    none_better,    // no solver is shown to be better than one of `solvers`
    better,         // each of `solvers` than `against`
    worse,          // each of `solvers` than `against`
    not_tested,     // each of `solvers` against `against`; if that is empty, each pair
    cyclic          // each of `solvers` is worse than another
  };
  StatementKind kind = StatementKind::no_comparison;
  std::vector<std::string> solvers, against = {};
  bool is_below_margin = false;  // each difference between `solvers` and `against` is
};
// Returns the statements about `solvers`, which must be in the order of the table, in the order of the sentence.
std::vector<Statement> make_statements(const judge::JudgedMetric& judged, const std::vector<std::string>& solvers);

// A question that the headline answers.
struct HeadlineQuestion {
  std::size_t metric = 0;            // place in the metrics of the report model
  std::vector<std::string> solvers;  // that it is about, in the order of the table
  std::vector<Statement> statements;
  std::string tie_breaker = {};            // the plan's word for the metric, such as "time"; empty: the first question
  std::vector<std::size_t> untested = {};  // places of the tie-breakers before this one, in which no pair was tested
};

// Returns one question or two. The first is about all solvers in the first metric. The second is about the solvers that
// the first leaves unseparated, in the first of the tie-breakers in which any of their pairs is tested. A plan with a
// control has no second question, unless there are only two solvers.
//
// Comparisons and p of both questions are those of all solvers. So the first question does not select the second one's
// family, which has a significance of its own.
std::vector<HeadlineQuestion> make_headline_questions(const std::vector<judge::JudgedMetric>& metrics,
                                                      const std::vector<std::string>& solvers,
                                                      const std::vector<std::string>& tie_breakers);

// Returns the names for which `is_so` holds, in their order.
std::vector<std::string> names_that(const std::vector<std::string>& names, auto is_so) {
  std::vector<std::string> kept;
  for (const std::string& name : names)
    if (is_so(name)) kept.push_back(name);
  return kept;
}

// True if `is_so` holds for each pair of one of `firsts` and another one of `seconds`.
bool holds_for_pairs(const std::vector<std::string>& firsts, const std::vector<std::string>& seconds, auto is_so) {
  for (const std::string& first : firsts)
    for (const std::string& second : seconds)
      if (first != second && !is_so(first, second)) return false;
  return true;
}

// True for a tested difference that is below the margin; false for null.
bool is_below_margin(const judge::Comparison* comparison);

}  // namespace ikbench::show
