// The judged claims of a paper, as blocks of the paper's report and as the last screen of `reproduce`.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/papers/repeated.hpp"
#include "analysis/papers/rules.hpp"
#include "analysis/show/block.hpp"

namespace ikbench::papers {

// Returns the claims in the order of the paper's file, each with the counts of `in_readings` for the claim's id. A
// claim that the data cannot judge is not tested. A question of ours that the data cannot judge is left out.
std::vector<JudgedClaim> judged_claims(const Repeated& repeated,
                                       const std::map<std::string, InReadings>& in_readings = {});

// Returns the claim with this id; null if there is none.
const JudgedClaim* claim_named(const std::vector<JudgedClaim>& claims, std::string_view id);

// Returns the first blocks of a paper's report: the sentences, the name of the paper, and the table.
show::Blocks beginning(const Paper& paper, const std::vector<std::string>& sentences, const show::Table& table);
// Returns the section of the claims, grouped by verdict, with our own questions behind the claims.
show::Blocks claims_section(const std::vector<JudgedClaim>& claims);
// Returns the last screen of `reproduce`: sentences, the printed table beside ours, and a line per claim of the paper.
std::string screen(const std::vector<std::string>& sentences, const show::Table& table,
                   const std::vector<JudgedClaim>& claims);

}  // namespace ikbench::papers
