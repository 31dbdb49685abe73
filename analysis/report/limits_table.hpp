// Shows what remains of a study's findings if joint limits are enforced: compares it with the study that enforces them.
#pragma once

#include <optional>

#include "analysis/inference/judged_study.hpp"
#include "analysis/report/table.hpp"

namespace ikbench::report {

// `studies` have the same targets, the reported one first. Pairs it with the first other study that shares a solver and
// treats limits the other way (enforced or not). nullopt if there is none.
std::optional<Table> limits_table(const inference::JudgedStudies& studies);

}  // namespace ikbench::report
