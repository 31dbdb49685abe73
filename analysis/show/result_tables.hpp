// The tables of an answer, of several studies' answers, and an answer as JSON. Their numbers are those of the
// sentences.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "analysis/show/report_model.hpp"
#include "analysis/show/table.hpp"

namespace ikbench::show {

// A row a solver; brief: with what its marks and numbers are alone.
Table results_table(const ReportModel& model, bool is_brief = false);
// Solvers by studies: of each study its deciding column, in the order of the first. Each study is judged alone.
Table studies_table(const std::vector<ReportModel>& studies, const std::vector<std::string>& names);
Table transposed(const Table& studies);              // of one unit: of so many that they do not stand across
Table pairs_table(const ReportModel& model);         // a row a pair; first those that the headline names
Table tested_pairs_table(const ReportModel& model);  // of the deciding metric; of two groups of all
Table descriptives_table(const ReportModel& model);
Table omnibus_table(const ReportModel& model);

// Returns the report as data: headline, groups, tests, comparisons and warnings.
nlohmann::ordered_json to_json(const ReportModel& model);

}  // namespace ikbench::show
