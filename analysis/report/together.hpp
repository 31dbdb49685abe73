// A user's collection in a report: one table of all its studies, and one test over them.
#pragma once

#include <vector>

#include "analysis/report/assessment.hpp"
#include "analysis/report/paper.hpp"

namespace ikbench::report {

// Adds the table "together", a row a solver and columns a study, and who is better over all studies. Nothing without
// companions.
void add_together(StudyPieces& pieces, const Reported& reported);

// The statistics over all studies, of each metric that all judge.
std::vector<Assessment> together_assessments(const Reported& reported);

}  // namespace ikbench::report
