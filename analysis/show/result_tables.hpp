// The tables of a report model, and a report model as JSON. The tables have the numbers
// of the headline's sentences. Pages, screens and files are made of these tables. The columns are documented in
// docs/reference/report.md.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>
#include <vector>

#include "analysis/show/report_model.hpp"
#include "analysis/show/table.hpp"

namespace ikbench::show {

// Returns the table of results: a row per solver, best first, and a column per metric. A brief table has only the notes
// that explain its marks and numbers.
Table results_table(const ReportModel& model, bool is_brief = false);
// Returns "* worse and + better than DLS, ! not tested", of the marks that occur in a table of results.
std::string marks_text(const std::set<std::string>& marks, const std::string& reference,
                       const std::string& why_not_tested = "");
// Returns the solver that the marks of the deciding metric compare with: "LM", "the control LM", "some other solver".
std::string reference_of_marks(const ReportModel& model);
// Returns a row per pair and metric. The visible rows are the pairs in the metrics of the headline; of more than 15
// pairs only those with the reference.
Table pairs_table(const ReportModel& model);
// Returns the tested pairs of the first metric, or of all metrics if there are only two groups.
Table tested_pairs_table(const ReportModel& model);
// Returns the descriptives: a row per metric and solver.
Table descriptives_table(const ReportModel& model);
// Returns the omnibus tests of all metrics. Without rows if no metric has such a test.
Table omnibus_table(const ReportModel& model);

// Returns the report as data: headline, groups, tests, comparisons and warnings.
nlohmann::ordered_json to_json(const ReportModel& model);

}  // namespace ikbench::show
