// The table of all answers: how many of the known answers each solver gave. Only studies with solvers that give several
// answers have it.
#pragma once

#include "analysis/judge/all_answers.hpp"
#include "analysis/show/table.hpp"

namespace ikbench::show {

// Returns the table; without rows if the answers were not counted. The caption is a sentence on which solvers are
// complete. Shares have intervals, and stars mark solvers that are worse than the most complete one.
Table answers_table(const judge::StudyResults& study);

}  // namespace ikbench::show
