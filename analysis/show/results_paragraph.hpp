// The paragraph of a report on its results, as sentences that can be pasted into an article: no options, warnings or
// lists. The article (article.hpp) and the report (report.hpp) call results_sentences. The rules of the paragraph are
// documented in docs/figures.md.
#pragma once

#include <string>
#include <vector>

#include "analysis/show/report_model.hpp"

namespace ikbench::show {

constexpr std::size_t max_result_sentences = 7;  // beside the one that names the table of pairs

// Returns at most max_result_sentences sentences: the averages of the first metric, then the pairs that the headline
// names, with estimate, interval, effect size and p, at most four in a sentence.
std::vector<std::string> results_sentences(const ReportModel& model);
// Returns the predicate of the sentence on the table of pairs: "has all 28 comparisons". Empty if no pair was
// compared.
std::string pairs_predicate(const ReportModel& model);

}  // namespace ikbench::show
