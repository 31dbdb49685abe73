// Judged metrics as readers see them: in their units, pairs of the best first, and of a pair the better one.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/judge/judge.hpp"
#include "analysis/show/block.hpp"

namespace ikbench::show {

struct Answer {
  std::vector<judge::JudgedMetric> metrics;  // first that of the headline
  std::vector<std::size_t> order;            // its groups, best first
  std::vector<judge::Doubt> doubts;          // of all
  std::string noun = "values";               // what observations are
  std::vector<std::string> notes;            // of the table of results
  std::string studied = {};                  // of a study: what its solvers did, and when a solve ended, as sentences
  std::string verdict = {};    // of `compare`, in place of the headline; labels and metrics share its significance
  std::string direction = {};  // of a file: "smaller is better"
  results::TableStyle::Show show = results::TableStyle::Show::tested;  // of the table of results
  Table loop = {};                                                     // of a control loop; without rows if it is none
  bool are_in_turn = false;                                            // so an observation of time is a turn

  const judge::JudgedMetric& decisive() const { return metrics.front(); }
  // Those of all and of each metric, each once; what several metrics have alike, as one.
  std::vector<judge::Doubt> all_doubts() const;
};

// Shares in percent; of studies times in ms, and errors in mm, but in cm where a paper's study is repeated. With a
// control it is the second of each pair.
Answer answer_of(std::vector<judge::JudgedMetric> metrics, std::size_t deciding = 0);
Answer answer_of(const judge::JudgedStudy& judged);

// With names of solvers that fit a line (base::short_names).
constexpr std::size_t longest_name = 24;  // in a table
Answer with_short_names(Answer answer, std::size_t length);

bool is_share(const judge::JudgedMetric& judged);
// A group's average as readers see it: at most the tolerance, or the floor that ratios know nothing below.
struct Shown {
  double value;
  bool is_bound = false;
};
Shown shown(const judge::JudgedMetric& judged, std::size_t group, double value);
Shown shown_average(const judge::JudgedMetric& judged, std::size_t group);  // by which it is tested
std::vector<double> ends_of_shares(const judge::JudgedMetric& judged);      // 99.97 % is not 100; of others none

// What observations of a metric are: "targets", of time perhaps "turns".
std::string noun_of(const Answer& answer, const judge::JudgedMetric& judged);
std::string reference_of(const Answer& answer);  // the control, else the first of the table of results

// The tables of every report, in study_tables.cpp. Their numbers are those of the sentences and of results.json.
Table results_table(const Answer& answer);   // a row a solver
Table warned_results(const Answer& answer);  // the same, with the warnings below it
// Solvers by studies: of each study its deciding column, in the order of the first. Each study is judged alone.
Table studies_table(const std::vector<Answer>& studies, const std::vector<std::string>& names);
// "a and b: DLS is best.\nc: Not decided." What the headline of each begins with.
std::string found_in_studies(const std::vector<Answer>& studies, const std::vector<std::string>& names);
std::optional<figures::Figure> studies_figure(const Table& studies, const std::vector<Answer>& answers);  // its shares
Table without_intervals(Table studies);
Table with_a_row_a_study(const Table& studies);  // of one unit, without intervals
Table pairs_table(const Answer& answer);         // a row a pair
Table told_pairs(const Answer& answer);          // of those the decided, and of many else those of the reference
Table pairs_of_article(const Answer& answer);    // of the deciding metric
std::string what_decides(const Answer& answer);  // what a verdict on another metric is worth; empty if there is none
std::string of_pairs(const Answer& answer);  // what estimates are of, where they are not those of the averages shown
Table descriptives_table(const Answer& answer);
Table anova_table(const Answer& answer);
// Times of single solves up to the rarest, and how many failed, whatever an observation is made of.
Table solves_table(const judge::StudyResults& study, const std::vector<std::string>& solvers);
// Medians of the solvers' own numbers.
Table extras_table(const judge::StudyResults& study, const std::vector<std::string>& solvers);
// Of a control loop; without rows if the study has none.
Table loop_table(const judge::StudyResults& study, const std::vector<std::string>& solvers);

// The answer as data: headline, groups, tests, findings and doubts.
nlohmann::ordered_json to_json(const Answer& answer);

const std::string& title_of(const judge::StudyResults& study);  // or its name
// "ur5e, 20 runs of 5 targets (random)"
std::string what_is_solved(const judge::StudyResults& study);
// A paragraph for an article, without the last point; `program` made what is of no study. And one of results.
std::string methods_of(const Answer& answer, const judge::StudyResults& study, const std::string& program = {});
std::vector<std::string> results_of(const Answer& answer);
std::string stops_of(const judge::StudyResults& study);  // "0.01 mm or 10000 evaluations"
// "What ended unsolved solves: evaluations (DLS); gave up or iterations (PSO and DE)."; empty if all are solved.
std::string ends_of_unsolved(const judge::StudyResults& study);

// How it was made. They have no files.
Table study_table(const judge::StudyResults& study);
Table options_table(const judge::StudyResults& study);
Table machine_table(const judge::StudyResults& study);

}  // namespace ikbench::show
