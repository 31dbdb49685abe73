// Outcomes of 0 and 1 in words and as a table: shares with their intervals, in place of means.
#pragma once

#include <string>

#include "analysis/inference/evidence.hpp"
#include "analysis/report/sentence.hpp"
#include "analysis/report/table.hpp"

namespace ikbench::report {

// "Shares of solved: IK-BA 18 of 20 (90 %, 70 to 97 %); BA ..."
Sentence shares_words(const inference::Evidence& evidence);
Sentence outcome_methods_words(const inference::Evidence& evidence);
// "statistics-NAME-groups": a row a group.
Table outcomes_table(const inference::Evidence& evidence);

}  // namespace ikbench::report
