// The words and sentences that tables, the headline, pages and screens share. A phrase about a comparison is made here,
// so that all writers use the same one. Numbers in a phrase are formatted as in the tables (text.hpp). The words are
// explained in docs/glossary.md and docs/reference/report.md.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/show/report_model.hpp"

namespace ikbench::show {

// The most pairs of solvers that a screen or a paragraph lists.
constexpr std::size_t max_pairs = 6;

// The names for which a phrase holds, by phrase: solvers by the reason why they failed, for instance.
struct NamesByPhrase {
  std::vector<std::pair<std::string, std::vector<std::string>>> entries = {};

  // Adds a name to a phrase. A phrase or a name that is already there is not added twice.
  void add(const std::string& word, const std::string& name);
  // Returns a text per phrase. `form` is a format of fmt, in which {0} is the phrase and {1} are the names.
  std::vector<std::string> formatted(const char* form) const;
};
// Returns the verdict of a comparison for readers: "better", "same within 5 %", "inconclusive: all 20 equal",
// "not tested: values are missing".
std::string comparison_text(const judge::Comparison& comparison, const judge::JudgedMetric& judged);
// The word for a verdict in files of numbers, and the tone in which a page colours the verdict.
struct VerdictStyle {
  std::string_view key;
  Tone tone = Tone::neutral;
};
// Returns the word for a verdict in files of numbers, and the tone of the verdict.
const VerdictStyle& verdict_words(judge::Verdict verdict);
// The words for a reason why a pair is not tested: the key in JSON, the text behind the verdict of a pair, and the text
// in place of a solver's number.
struct ReasonTexts {
  std::string_view key, of_pair, of_solver;
};
// Returns the words for a reason.
ReasonTexts reason_words(judge::NotTestedReason why);
// Returns why a pair is not tested. For samples that are too small the text has numbers of `noun`: "8 runs, at least 10
// needed".
std::string reason_text(const judge::NotTested& open, std::string_view noun);
// Returns the same, and for a pair that is not comparable the reason that the metric's warnings give: "the machine was
// busy".
std::string reason_in_metric(const judge::NotTested& not_tested, const judge::JudgedMetric& judged,
                             std::string_view noun);
// Returns a warning as a sentence with a full stop. The first letter becomes a capital, except in a solver's name.
std::string warning_sentence(const judge::Warning& warning);
// Returns the unit of a comparison's estimate: "ratio", "points", or the metric's unit. Empty without an estimate.
std::string estimate_unit(const judge::Comparison& comparison, const judge::JudgedMetric& judged);
// Returns "better in 43 % and worse in 3 % of value pairs". Empty if the test shows no difference, or has no dominance.
std::string dominance_text(const judge::Comparison& comparison);
// Returns whether A12 is shown as the effect size of a test: by ranks, but not of shares.
bool shows_a12(const judge::TestResult& tested, const judge::JudgedMetric& judged);
// Returns the numbers that decide a comparison, on the scale of the estimate: no difference (1 for a ratio, otherwise
// 0), and the two ends of the margin.
std::set<double> null_and_margin(const judge::Comparison& comparison, const judge::JudgedMetric& judged);
// Returns "2.5 cm", or "1 point" for one of the "points". An empty unit adds nothing.
std::string with_unit(const std::string& text, const std::string& unit);
// Returns the margin of a metric: "5 %", "5 points", "5 % or 0.1 mm".
std::string margin_text(const judge::JudgedMetric& judged);

// Returns the title of a study, or the name of a study without a title.
const std::string& title_of(const judge::StudyResults& study);
// Returns the arm, the size and the target set of a study: "ur5e, 20 runs of 5 targets (random)".
std::string study_text(const judge::StudyResults& study);
// Returns the errors at which a solve stops: "0.01 mm and 0.06 deg". Only for a study with a tolerance.
std::string tolerance_text(const judge::StudyResults& study);
// Returns what else ends a solve: "after 100 iterations or 4000 evaluations". Empty if nothing does.
std::string effort_limits_text(const judge::StudyResults& study);
// Returns both: "at 0.01 mm, or after 10000 evaluations".
std::string budget_text(const judge::StudyResults& study);
// Returns why solves failed: "Why unsolved: evaluation limit (DLS); gave up or iteration limit (PSO and DE).".
// Empty if all solves are solved, or if the study has no tolerance.
std::string failure_reasons_text(const judge::StudyResults& study);
// Returns how often the study's check refused answers of each solver: "Rejected by the check: collision (DLS 3 and PSO
// 1).". Empty if the check refused none. More than ten faults are only counted.
std::string rejections_text(const judge::StudyResults& study);

}  // namespace ikbench::show
