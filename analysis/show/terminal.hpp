// What a command prints of an answer.
#pragma once

#include <string>

#include "analysis/show/report_model.hpp"

namespace ikbench::show {

// The last screen of `run`, `report`, `compare` and `stats`: the headline, the table of results with what its marks
// are, a warning of each kind, and where `page` is. Without a page also pairs: of the metric of the headline, up to
// max_pairs (phrases.hpp); where there are only two groups, of every metric.
std::string terminal_report(const ReportModel& model, const std::string& page = {});

}  // namespace ikbench::show
