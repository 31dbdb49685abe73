// The report of a study: report.html, report.md, tables/ (Markdown, CSV, LaTeX) and figures/ in one folder.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/inference/study.hpp"
#include "analysis/report/paper.hpp"
#include "analysis/report/publish.hpp"
#include "analysis/report/table.hpp"
#include "results/analysis_plan.hpp"
#include "results/store.hpp"

namespace ikbench::report {

// Looks at solves one after another, and says in sentences what is wrong with them, the first warnings, and what cannot
// be known of them.
struct SolveCheck {
  std::function<void(const results::SolveRecord&)> look_at;
  std::function<std::vector<std::string>()> damages;
  std::function<std::string()> unknown = {};  // empty where all is known
};

struct ReportRequest {
  std::string study;
  std::filesystem::path folder;  // made where missing; files of the same names are replaced
  std::optional<results::AnalysisPlan> plan =
      {};  // instead of the study's own, which the report says; for its companions too
  figures::RenderOptions figures = {};
  std::span<const Collection> collections = {};     // of which the study's, if it is there, has its say
  std::vector<Table> extra_tables = {};             // written and shown with the others (report_content.cpp says where)
  std::vector<figures::Figure> extra_figures = {};  // likewise
  std::vector<RepeatedSolver> repetitions = {};     // of the study, with other seeds
  std::vector<ClaimShares> shares = {};             // of the paper's claims over all interpretations
  // Looks at the solves of a study of the store. May be empty.
  std::function<SolveCheck(const results::StudyEntry&)> check = {};
};

// An unknown study, or a folder that cannot be written to, is std::invalid_argument. Tables are there even where
// gnuplot is not.
Report write_report(const results::Store& store, const ReportRequest& request);

}  // namespace ikbench::report
