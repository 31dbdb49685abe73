// A judged study prepared for display: numbers in readers' units, comparisons ordered by the solvers' places, the
// better solver of each comparison first. Commands make a model once with make_report_model. Tables, headline, page and
// JSON are made of the model.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/judge/judge.hpp"
#include "analysis/show/statements.hpp"
#include "analysis/show/table.hpp"

namespace ikbench::show {

struct ReportModel {
  std::vector<judge::JudgedMetric> metrics;  // the first is the primary metric, which the headline is about
  std::vector<std::size_t> order;            // groups of the primary metric, best first
  std::vector<judge::Warning> warnings;      // about the whole study
  std::string noun = "values";               // what the values of a sample are: "runs", "targets"
  std::string time_limit = {};               // "1 ms" if only a time limit ends unsolved solves; otherwise empty
  std::size_t named_metrics = 1;             // metrics that the plan names, which share the significance
  std::vector<std::string> notes;            // below the table of results
  std::string study_text = {};               // what was solved, and what ended a solve; empty for a file
  std::string rejections_text = {};          // answers that the study's check refused; empty: none
  std::string answers_text = {};             // why all answers are not counted; empty if they are, or are not given
  std::vector<judge::RequirementCheck> requirements = {};  // of the study, in their order
  std::vector<std::string> without_answer = {};            // solvers that gave no answer in any solve
  std::string verdict = {};                      // the answer of `compare`, in place of the headline; otherwise empty
  std::string direction = {};                    // "smaller is better" for a user's file; empty for a study
  std::vector<std::string> tie_breakers = {};    // of the plan, in order; empty: no second question
  std::vector<HeadlineQuestion> questions = {};  // one or two, answered by the headline
  // The further tables of a study with their headings: the control loop, the times of imported solvers, the times in
  // batches. A table without rows is not shown.
  std::vector<std::pair<std::string, Table>> extra_tables = {};

  Table targets = {};                                   // who solves which target; without rows for a file
  std::optional<judge::HardTargets> hard_targets = {};  // nullopt: nothing to say of them

  const judge::JudgedMetric& primary() const { return metrics.front(); }
  // Returns the names of the solvers, best first.
  std::vector<std::string> solvers() const;
  // Returns whether a question of the headline is about this metric, which must be an element of `metrics`.
  bool is_in_headline(const judge::JudgedMetric& judged) const;
  // Removes the metrics of a kind and makes the questions again. The first metric must be of another kind.
  void remove_metrics(judge::QuantityKind kind);
  // Returns the warnings of the study and of all metrics, ordered by kind. A warning that several metrics share occurs
  // once.
  std::vector<judge::Warning> all_warnings() const;
};

// Returns the names of the metrics whose pairs closed tests decide, because their blocks are few.
std::vector<std::string> closed_metrics(const ReportModel& model);
// Returns the model of these metrics, with shares solved in percent. `primary` is the place of the metric that becomes
// the first. With a control, the control is the second solver of each pair.
ReportModel make_report_model(std::vector<judge::JudgedMetric> metrics, std::size_t primary = 0,
                              std::vector<std::string> tie_breakers = {});
// Returns the model of a study, with times in ms and errors in mm, but in cm if a paper's study is repeated.
ReportModel make_report_model(const judge::JudgedStudy& judged);

// Returns whether the metric is a share of successes.
bool is_success_rate(const judge::JudgedMetric& judged);
// A group's value for display. If `is_bound`, the true value is `value` or smaller: `value` is then the tolerance or
// the metric's floor.
struct BoundedValue {
  double value;
  bool is_bound = false;
};
// Returns a value of a group for display.
BoundedValue displayed(const judge::JudgedMetric& judged, std::size_t group, double value);
// Returns the average by which a group is tested, for display.
BoundedValue displayed_average(const judge::JudgedMetric& judged, std::size_t group);
// Returns 0 and 100 for a share of successes, so that 99.97 % is not shown as 100 %. Empty for other metrics.
std::vector<double> percent_boundaries(const judge::JudgedMetric& judged);

// Returns the word for the values of a metric's samples: "sessions" for times, otherwise the model's noun.
std::string observation_noun(const ReportModel& model, const judge::JudgedMetric& judged);
// Returns whether a solve is not solved. In a study without a tolerance a solve has failed if there is no answer.
bool has_failed(const judge::StudyResults& study, const judge::SolveSummary& solve);
// Returns the reference: the control, otherwise the first solver of the table of results.
std::string reference_of(const ReportModel& model);

}  // namespace ikbench::show
