// The targets of a study as a table, and a sentence about those that some solvers do not solve, which screen, page and
// JSON share. docs/reference/report.md says when a target counts as solved.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "analysis/judge/solved_targets.hpp"
#include "analysis/show/table.hpp"

namespace ikbench::show {

// Returns a row per target, the hardest first: who solves it, and the least that this takes. Without rows if the study
// has fewer than two targets, or no tolerance. At most 10 000 targets are listed.
Table targets_table(const judge::SolvedTargets& all);
// Returns "No solver solves 12 of the 30 targets; DE and IK-BA together solve the other 18."
std::string hard_targets_sentence(const judge::HardTargets& hard);
// Returns the sentence with its numbers: targets, unsolved, solvers, solved.
nlohmann::ordered_json hard_targets_json(const judge::HardTargets& hard);

}  // namespace ikbench::show
