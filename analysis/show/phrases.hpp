// The few sentences of reports and screens. Numbers are those of the tables.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/show/report_model.hpp"

namespace ikbench::show {

constexpr std::size_t max_pairs = 6;  // that a screen or paragraph lists

// Each word once, with the names that have it, each once.
struct NamesByPhrase {
  std::vector<std::pair<std::string, std::vector<std::string>>> entries = {};

  void add(const std::string& word, const std::string& name);
  std::vector<std::string> formatted(const char* form) const;  // by fmt: {0} is the word, {1} its names
};
// "better", "same within 5 %", "not decided: all 20 equal", "not decided", "not tested: no values"
std::string comparison_text(const judge::Comparison& comparison, const judge::JudgedMetric& judged);
// A verdict in files of numbers, and its colour.
struct VerdictStyle {
  std::string_view key;
  Tone tone = Tone::neutral;
};
const VerdictStyle& verdict_words(judge::Verdict verdict);
// Why a pair is not tested: in JSON, behind its verdict, and in place of a solver's number.
struct ReasonTexts {
  std::string_view key, of_pair, of_solver;
};
ReasonTexts reason_words(judge::NotTestedReason why);
std::string reason_text(const judge::NotTested& open, std::string_view noun);  // "8 runs are too few, 10 are needed"
std::string warning_sentence(const judge::Warning& warning);                   // a sentence
// "times", "points", or the metric's unit.
std::string estimate_unit(const judge::Comparison& comparison, const judge::JudgedMetric& judged);
// "better in 43 %, worse in 3 % of comparisons"; empty where nothing is decided, or no shares are known.
std::string dominance_text(const judge::Comparison& comparison);
// No difference and the margin's ends, as the finding's numbers are.
std::set<double> null_and_margin(const judge::Comparison& comparison, const judge::JudgedMetric& judged);
std::string with_unit(const std::string& text, const std::string& unit);  // "1 point", "2.5 cm"
// "5 %", "5 points", "5 % or 0.1 mm"
std::string margin_text(const judge::JudgedMetric& judged);

// Returns the title of a study; its name if it has no title.
const std::string& title_of(const judge::StudyResults& study);
// "ur5e, 20 runs of 5 targets (random)"
std::string study_text(const judge::StudyResults& study);
std::string budget_text(const judge::StudyResults& study);  // "0.01 mm or 10000 evaluations"
// "Unsolved: limit of evaluations (DLS); it gave up or limit of iterations (PSO and DE)."; empty if all are solved.
std::string failure_reasons_text(const judge::StudyResults& study);
std::string rejections_text(const judge::StudyResults& study);  // of answers that reached, by the study's check

}  // namespace ikbench::show
