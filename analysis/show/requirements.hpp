// Writes the checks of requirements (judge/requirement.hpp) as sentences of screens and reports, and as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "analysis/show/report_model.hpp"

namespace ikbench::show {

// Returns a sentence per check: "mine solved 97 of 100 targets: at least 95 % is inconclusive (92-99 %); about 360 more
// targets like these would show it." Empty if the study has no requirement.
std::vector<std::string> requirement_sentences(const ReportModel& model);
// Returns a list with an object per check: solver, metric, required, share, n, low, high, verdict, more_values, reason.
nlohmann::ordered_json requirements_json(const ReportModel& model);

}  // namespace ikbench::show
