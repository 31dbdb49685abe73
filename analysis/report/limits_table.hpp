// What is left of a study's findings where the joint limits are enforced: a study beside the one that enforces them.
#pragma once

#include <optional>

#include "analysis/inference/judged_study.hpp"
#include "analysis/report/table.hpp"

namespace ikbench::report {

// Of studies with the same targets, the reported one first: it and the first other with which it makes a pair, one of
// them with limits enforced and one without, that have a solver in common. Nothing where there is none.
std::optional<Table> limits_table(const inference::JudgedStudies& studies);

}  // namespace ikbench::report
