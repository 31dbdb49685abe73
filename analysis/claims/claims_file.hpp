// The claims of a paper, declared in claims.toml, one entry per claim (docs/adding-anything.md).
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

// The solvers whose numbers come from the companion that a claim names; those of the rest come from the study itself.
enum class FromCompanion { all, solver, others };

struct ClaimEntry {
  std::string id, sentence, section, decides;
  report::Claimant by = report::Claimant::paper;
  std::string rule;     // the rule that judges it (rules.hpp)
  std::string solver;   // its solver; empty: the paper's own
  std::string against;  // one solver; empty: all others
  std::vector<inference::Metric> metrics;
  std::string study;  // "limits" of the companion NAME-limits; empty: the study itself
  FromCompanion take = FromCompanion::all;
  // The numbers by which every universe of the paper's open points judges it too (docs/multiverse.md); none: not judged
  // there. Only "smallest" can be, with one metric that universes have.
  std::vector<results::Estimand> universes;
  std::string table;  // table or figure of the report with its numbers; empty: the table of means
  std::string note;   // addition to the evidence, if the rule has a place for it
  // For some rules only.
  std::vector<std::string> solvers;            // its solvers, instead of the one; of "has_effect" the companion's
  double limit_ms = 0;                         // limit of a solve in time
  std::string row;                             // names a printed row's solver: "{bats} bats"
  std::string path;                            // the kind of path that it is about
  std::map<std::string, std::string> reasons;  // why "KDL on the Baxter arm" may differ

  // Those that it says something of: its solvers or the one.
  std::vector<std::string> own() const { return solvers.empty() ? std::vector{solver} : solvers; }
};

struct ClaimsFile {
  std::string paper;
  std::string solver;                         // the paper's own
  std::string means;                          // its table of means (printed.hpp); empty: none is printed
  std::vector<std::string> not_on;            // kinds of path that this table is not about
  std::string implementation;                 // of the printed times: "MATLAB"
  std::map<std::string, std::string> anovas;  // the printed table, by metric
  int fitting = 0;                            // an interpretation that fits explains so many printed numbers
  std::vector<ClaimEntry> entries;
  report::RatesPlan rates = {};
};

// Reads the text of a file. Throws std::invalid_argument with `source` and the line for anything missing, unknown or
// repeated.
ClaimsFile read_claims(std::string_view paper, std::string_view text, std::string_view source);

}  // namespace ikbench::claims
