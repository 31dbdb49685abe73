// Puts the statements of a report model's questions into words: the headline of reports, screens and articles. No other
// file makes sentences of comparisons. Numbers are those of the table of results.
#pragma once

#include <string>

#include "analysis/show/report_model.hpp"

namespace ikbench::show {

// Returns the answer to all questions: "DLS is best: it solved all 100 targets, PSO 88 and mine 54." or "LM and DLS
// solved all 100 targets, SLSQP 99 (inconclusive); Newton (77) is worse. LM is fastest; DLS takes 1.2x as
// long." A model with a verdict of its own has that as its headline.
std::string headline(const ReportModel& model);
// Returns the answer to the second question; empty if there is none.
std::string tie_breaker_sentence(const ReportModel& model);
// Returns "Ranked by targets solved, then time"; empty if no solver is better in another metric than the first.
std::string ranking_note(const ReportModel& model);

}  // namespace ikbench::show
