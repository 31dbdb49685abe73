// The audit of Slim et al. (2023): what its printed numbers say about each other. Nothing is solved.
#pragma once

#include <string_view>
#include <vector>

#include "analysis/report/audit.hpp"

namespace ikbench::slim2023 {

// By the items of docs/paper-notes.md, section 3. std::invalid_argument where the paper is not among the published.
std::vector<report::AuditItem> audit(std::string_view paper);

}  // namespace ikbench::slim2023
