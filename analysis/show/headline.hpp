// Puts the statements of a report model's questions into words: the headline of reports, screens and articles. No other
// file makes sentences of comparisons. Numbers are those of the table of results.
#pragma once

#include <string>

#include "analysis/show/report_model.hpp"

namespace ikbench::show {

// Returns the answer to all questions: "DLS (solved 100 of 100 targets) is best; PSO (88) is worse." or "LM and DLS
// solved all 100 targets, SLSQP 99 (not decided); Newton (77) is worse. LM is the fastest; DLS takes 1.2 times as
// long." A model with a verdict of its own has that as its headline.
std::string headline(const ReportModel& model);
// Returns the answer to the second question; empty if there is none.
std::string tie_breaker_sentence(const ReportModel& model);
// Returns "Judged by solved, then time"; empty if no solver is better in another metric than the first.
std::string ranking_note(const ReportModel& model);

}  // namespace ikbench::show
