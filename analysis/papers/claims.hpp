// The claims of a paper, judged: blocks of its report, and what `reproduce` prints.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/papers/repeated.hpp"
#include "analysis/papers/rules.hpp"
#include "analysis/show/block.hpp"

namespace ikbench::papers {

// In the order of the paper's file, with what each does in readings, by its id. A claim that the report cannot judge is
// not tested; our own questions are left out instead.
std::vector<JudgedClaim> judged_claims(const Repeated& repeated,
                                       const std::map<std::string, InReadings>& in_readings = {});

const JudgedClaim* claim_named(const std::vector<JudgedClaim>& claims, std::string_view id);  // null if it is not there

// The sentences, which paper it is, and the table.
show::Blocks beginning(const Paper& paper, const std::vector<std::string>& sentences, const show::Table& table);
// Grouped by verdict: the claims, then our own questions.
show::Blocks claims_section(const std::vector<JudgedClaim>& claims);
// Returns the last screen of `reproduce`: sentences, the printed table beside ours, and a line per claim of the paper.
std::string screen(const std::vector<std::string>& sentences, const show::Table& table,
                   const std::vector<JudgedClaim>& claims);

}  // namespace ikbench::papers
