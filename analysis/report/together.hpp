// A user's collection in a report: one table of all its studies, one test over them, and the pieces of each.
#pragma once

#include <string>
#include <vector>

#include "analysis/report/assessment.hpp"
#include "analysis/report/paper.hpp"

namespace ikbench::report {

// The names of a companion's pieces begin so.
std::string prefix_of(const inference::StudyResults& companion);

// Adds the table "together", a row a solver and columns a study, and who is better over all studies; then the pieces of
// each companion. All headings and captions name their study. Nothing without companions.
void add_together(StudyPieces& pieces, const Reported& reported);

// The statistics over all studies, of each metric that all judge.
std::vector<Assessment> together_assessments(const Reported& reported);

}  // namespace ikbench::report
