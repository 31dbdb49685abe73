// Imported results: solves of the same study that another machine made, from a store or from the archive of libraries
// (results/published/libraries, docs/which-library.md), for which nothing has to be installed. Proportions of imported
// solvers are compared if no time limit ended their solves. Their times are shown, but never compared.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/judge/data/study_results.hpp"

namespace ikbench::judge {

constexpr std::string_view archive_name = "libraries";
// Returns the settings of the archive's study without the arm, as --set has them.
std::vector<std::string> archive_settings();
// Returns the archived solves of an arm. The definition of the study is left empty: callers read it from
// `archive_settings`. Throws std::invalid_argument for an arm that the archive does not have.
StudyResults read_archive(const std::string& robot);

// Throws std::invalid_argument, which says what differs, if `theirs` has other targets, tolerances or limits.
void require_same_study(const StudyResults& theirs, const results::StoredStudy& study);
// Adds the imported solvers to the study. LM with the same options as the study's own is not added: the times of LM on
// both machines give the unit in which imported times are shown. If the plan has no control, the study's first solver
// becomes the control. Throws std::invalid_argument if no solver is added, or if targets differ.
void add_imported(StudyResults& study, const StudyResults& theirs);

}  // namespace ikbench::judge
