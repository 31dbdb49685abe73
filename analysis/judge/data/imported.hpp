// Solvers of the same study on another machine, beside those of a study: of a store, or of the archive of libraries
// (results/published/libraries, docs/which-library.md), of which nothing has to be installed. Their shares are compared
// where no time ended one of theirs; their times are told, and never compared.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/judge/data/study_results.hpp"

namespace ikbench::judge {

constexpr std::string_view archive_name = "libraries";
std::vector<std::string> archive_settings();  // of its study but for the arm, as --set has them
// What is archived of an arm; the definition of its study is left to who reads studies. Throws std::invalid_argument
// for an arm of which nothing is.
StudyResults read_archive(const std::string& robot);

// Throws std::invalid_argument, which says what differs, if `theirs` are of other targets, tolerances or limits.
void require_same_study(const StudyResults& theirs, const results::StoredStudy& study);
// Adds their solvers to the same study, but LM, which is the unit of their times. Without a control the study's first
// solver becomes it.
void add_imported(StudyResults& study, const StudyResults& theirs);

}  // namespace ikbench::judge
