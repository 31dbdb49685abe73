// The claims of a paper as they are declared: claims.toml, an entry a claim (docs/adding-anything.md).
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/inference/metrics.hpp"
#include "analysis/inference/multiverse.hpp"
#include "analysis/report/claims.hpp"
#include "analysis/report/rates.hpp"

namespace ikbench::claims {

// Whose numbers come from the companion that a claim names; the others' are of the study itself.
enum class Take { all, solver, others };

struct ClaimEntry {
  std::string id, sentence, section, decides;
  report::By by = report::By::paper;
  std::string rule;     // that judges it (rules.hpp)
  std::string solver;   // of whom it is; empty: the paper's own
  std::string against;  // one solver; empty: all others
  std::vector<inference::Metric> metrics;
  std::string study;  // "limits" of the companion NAME-limits; empty: the study itself
  Take take = Take::all;
  // The numbers by which every universe of what the paper leaves open judges it too (docs/multiverse.md); none: it is
  // not judged there. Only "smallest" and "has_effect" can be, of one solver and one metric that universes have.
  std::vector<inference::JudgedBy> universes;
  std::string dimension;  // of "has_effect" in universes: the one that is without it, "IK-BA.f_max"
  std::string table;      // or figure of the report, with its numbers; empty: the table of means
  std::string note;       // what the evidence says besides, where the rule has a place for it
  // Of some rules alone.
  std::vector<std::string> solvers;            // of whom it is
  double limit_ms = 0;                         // of a solve that is in time
  std::string row;                             // the solver that a row of a printed table is of: "{bats} bats"
  std::string path;                            // the kind of path that it is about
  std::vector<std::string> joints;             // what a joint is where it is straight; "" of no account
  std::map<std::string, std::string> reasons;  // why "KDL on the Baxter arm" may differ
};

struct ClaimsFile {
  std::string paper;
  std::string solver;                         // the paper's own
  std::string means;                          // its table of means (printed.hpp); empty: none is printed
  std::vector<std::string> not_on;            // kinds of path that this table is not about
  std::string implementation;                 // of the printed times: "MATLAB"
  std::map<std::string, std::string> anovas;  // the printed table of each metric's
  std::vector<ClaimEntry> entries;
  report::RatesPlan rates = {};
};

// From the text of a file. Whatever is missing, unknown or twice is std::invalid_argument with `source` and the line.
ClaimsFile read_claims(std::string_view paper, std::string_view text, std::string_view source);

}  // namespace ikbench::claims
