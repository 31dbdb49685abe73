// Words and tables for outcomes of 0 and 1: shares with intervals replace means.
#pragma once

#include <string>

#include "analysis/inference/evidence.hpp"
#include "analysis/report/sentence.hpp"
#include "analysis/report/table.hpp"

namespace ikbench::report {

// "Shares of solved: IK-BA 18 of 20 (90 %, 70 to 97 %); BA ..."
Sentence shares_words(const inference::Evidence& evidence);
Sentence outcome_methods_words(const inference::Evidence& evidence);
// "statistics-NAME-groups": one row per group.
Table outcomes_table(const inference::Evidence& evidence);

}  // namespace ikbench::report
