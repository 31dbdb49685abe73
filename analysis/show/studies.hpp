// Several studies side by side: a sweep over keys of a study, or the studies of several stores. The commands `run` and
// `report` make one table of them, with a column per study. Each study is judged by itself. The files are documented in
// docs/reference/report.md.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/show/publish.hpp"
#include "analysis/show/report_model.hpp"
#include "analysis/show/table.hpp"

namespace ikbench::show {

// A study in a column.
struct StudyColumn {
  std::string name;   // the value of a sweep, or the study, arm or folder of a store
  std::string study;  // the study's name in its store
  ReportModel model;
};

struct StudiesReport {
  std::string title;
  std::vector<std::string> keys;  // swept keys; empty: the studies of several stores
  std::vector<StudyColumn> columns;
  std::vector<figures::Figure> figures = {};
};

// Returns which differences are decided in which studies: "On my_arm, mine (71 %) is worse than LM (94 %) in targets
// solved; on ur5e and franka_panda, no difference is shown." Pairs whose order changes from one study to another are
// named.
std::string headline(const StudiesReport& report);
// Returns a row per solver and a column per study, which is the first metric's column in that study's table of results.
// The rows are in the order of the first study. More than max_study_columns studies have a row each.
Table studies_table(const StudiesReport& report);
constexpr std::size_t max_study_columns = 6;

// Returns a sentence per check of a requirement, which begins with the name of the study.
std::vector<std::string> requirement_sentences(const StudiesReport& report);
// Returns the screen of the report. `page` is the place of the page.
std::string terminal_report(const StudiesReport& report, const std::string& page);
// Returns the report as data: the headline, and the report of each study.
nlohmann::ordered_json to_json(const StudiesReport& report);
// Writes report.html, report.md, results.json, tables/ and figures/, as write_report of one study does.
WrittenReport write_report(const StudiesReport& report, const std::filesystem::path& folder,
                           const figures::RenderOptions& options, const std::string& program = {});

}  // namespace ikbench::show
