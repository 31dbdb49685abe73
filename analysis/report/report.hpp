// The report of a study: report.html, report.md, tables/ (Markdown, CSV, LaTeX) and figures/ in one folder.
#pragma once

#include <cstdint>
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

// Reads solves, judges quantities, draws figures.
enum class ReportStep { reading, judging, drawing };

struct ReportRequest {
  std::string study;
  std::filesystem::path folder;  // created if missing; files of the same names are replaced
  std::optional<results::AnalysisPlan> plan =
      {};  // replaces the study's own plan, and its companions'; the report says so
  std::optional<results::FigureStyle> style = {};   // replaces the look of the study's figures
  figures::RenderOptions figures = {};              // without a look
  std::span<const Paper> papers = {};               // the study's own, if among them, shapes the report
  std::vector<Table> extra_tables = {};             // written and shown with the others (report_content.cpp says where)
  std::vector<figures::Figure> extra_figures = {};  // likewise
  std::vector<ClaimShares> shares = {};             // shares of the paper's claims over all interpretations
  // Told how far a step is. May be empty.
  std::function<void(ReportStep step, std::int64_t done, std::int64_t all)> progress = {};
};

// Throws std::invalid_argument for an unknown study or a folder that cannot be written. Writes tables even without
// gnuplot.
Report write_report(const results::Store& store, const ReportRequest& request);

}  // namespace ikbench::report
