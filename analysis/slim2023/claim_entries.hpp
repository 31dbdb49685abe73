// The claims of Slim et al. (2023) as they are declared: claims.toml beside this file, which the build carries in the
// program.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/inference/metrics.hpp"
#include "analysis/inference/multiverse.hpp"
#include "analysis/report/claims.hpp"

namespace ikbench::slim2023 {

// Whose numbers come from the companion that a claim names; the others' are of the study itself.
enum class Take { all, solver, others };

struct ClaimEntry {
  std::string id, sentence, section, decides;
  report::By by = report::By::paper;
  std::string test;     // the rule that judges it
  std::string solver;   // of whom it is
  std::string against;  // one solver; empty: all others
  std::vector<inference::Metric> metrics;
  std::string study;  // "limits" of the companion slim2023-limits; empty: the study itself
  Take take = Take::all;
  // The numbers by which every universe of what the paper leaves open judges it too (docs/multiverse.md); none: it is
  // not judged there. Only "smallest" and "has_effect" can be, of one solver and one metric that universes have.
  std::vector<inference::JudgedBy> universes;
  std::string dimension;  // of "has_effect" in universes: the one that is without it, "IK-BA.f_max"
};

// From the text of a file. Whatever is missing, unknown or twice is std::invalid_argument with `source` and the line;
// `tests` are the rules that there are.
std::vector<ClaimEntry> read_claims(std::string_view text, std::string_view source,
                                    const std::vector<std::string>& tests);

// Those of the paper.
std::vector<ClaimEntry> claim_entries(const std::vector<std::string>& tests);

}  // namespace ikbench::slim2023
