// A judged study prepared for display: in readers' units, comparisons ordered by the solvers' places, the better solver
// of each comparison first. Tables, headline, page and JSON are made of this.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "analysis/judge/judge.hpp"
#include "analysis/show/statements.hpp"
#include "analysis/show/table.hpp"

namespace ikbench::show {

struct ReportModel {
  std::vector<judge::JudgedMetric> metrics;  // the first is that of the headline
  std::vector<std::size_t> order;            // its groups, best first
  std::vector<judge::Warning> warnings;      // of all
  std::string noun = "values";               // what observations are
  std::string within = {};                   // " within 1 ms", where time alone ends what is not solved
  std::size_t named_metrics = 1;             // that share the significance: those that the plan names
  std::vector<std::string> notes;            // of the table of results
  std::string study_text = {};               // of a study: what its solvers did, and when a solve ended, as sentences
  std::string rejections_text = {};          // of answers that the study's check refused; empty: none
  std::string verdict = {};    // of `compare`, in place of the headline; labels and metrics share its significance
  std::string direction = {};  // of a file: "smaller is better"
  std::vector<std::string> tie_breakers = {};    // of the plan, in their order; empty: no second question
  std::vector<HeadlineQuestion> questions = {};  // one or two, which the headline answers
  // The further tables of a study with their headings: the control loop, the times of imported solvers, the times in
  // batches. A table without rows is not shown.
  std::vector<std::pair<std::string, Table>> extra_tables = {};

  const judge::JudgedMetric& primary() const { return metrics.front(); }
  std::vector<std::string> solvers() const;                      // in the order
  bool is_in_headline(const judge::JudgedMetric& judged) const;  // one of `metrics`, about which a question is
  // Removes the metrics of a kind, which must not be the first's, and asks the questions again.
  void remove_metrics(judge::QuantityKind kind);
  // Returns the warnings of the study and of all metrics. Those that several metrics share are merged.
  std::vector<judge::Warning> all_warnings() const;
};

// Shares in percent; of studies times in ms, and errors in mm, but in cm where a paper's study is repeated. With a
// control it is the second of each pair.
ReportModel make_report_model(std::vector<judge::JudgedMetric> metrics, std::size_t primary = 0,
                              std::vector<std::string> tie_breakers = {});
ReportModel make_report_model(const judge::JudgedStudy& judged);

bool is_success_rate(const judge::JudgedMetric& judged);
// A group's average for display. `is_bound`: the true value is this or smaller, because it lies below the tolerance or
// the metric's floor.
struct BoundedValue {
  double value;
  bool is_bound = false;
};
BoundedValue displayed(const judge::JudgedMetric& judged, std::size_t group, double value);
BoundedValue displayed_average(const judge::JudgedMetric& judged, std::size_t group);  // by which it is tested
std::vector<double> percent_boundaries(const judge::JudgedMetric& judged);  // 99.97 % is not 100; of others none

// Returns the word for observations of a metric: "targets" or "runs", for times "sessions".
std::string observation_noun(const ReportModel& model, const judge::JudgedMetric& judged);
bool has_failed(const judge::StudyResults& study, const judge::SolveSummary& solve);  // without a tolerance: to answer
std::string reference_of(const ReportModel& model);  // the control, else the first of the table of results

}  // namespace ikbench::show
