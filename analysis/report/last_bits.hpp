// Compares a study with copies of it whose targets differ in their last bits (`ikbench run --perturb`).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/inference/study.hpp"
#include "analysis/report/table.hpp"

namespace ikbench::report {

using PerturbedCopies = std::vector<inference::StudyResults>;

// "NAME-perturbed-2"
std::string name_of_copy(std::string_view study, int number);
// Returns whether the study is such a copy.
bool is_copy_of(const inference::StudyResults& copy, std::string_view study);

// Number of solves of the solver whose status differs in at least one copy.
std::size_t changed_statuses(const inference::StudyResults& study, const PerturbedCopies& copies,
                             std::string_view solver);

// The table last-bits: a row for each solver and metric, with its certificate and the range of rounding, from the
// smallest to the largest mean of the study and its copies. Times are left out.
Table last_bits_table(const inference::StudyResults& study, const PerturbedCopies& copies);
// Names the solvers by their worst certificate; empty without copies.
std::string last_bits_sentence(const inference::StudyResults& study, const PerturbedCopies& copies);

}  // namespace ikbench::report
