// The text that a command prints about a report model.
#pragma once

#include <string>

#include "analysis/show/report_model.hpp"

namespace ikbench::show {

// Returns the last screen of `run`, `report`, `compare` and `stats`: the headline, the table of results with notes, the
// further tables, and the warnings. With a `page` there is one warning of each kind, and the place of the page. Without
// a page there are all warnings, and the tested pairs if the first metric has at most max_pairs pairs (phrases.hpp).
std::string terminal_report(const ReportModel& model, const std::string& page = {});

}  // namespace ikbench::show
