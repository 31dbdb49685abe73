// Static pages from the stores of many people: studies, solvers, arms. A page needs no server and no script.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "analysis/inference/judged_study.hpp"
#include "results/store.hpp"

namespace ikbench::report {

// A store as it was handed in.
struct Submission {
  std::string name;          // of the store's file or folder
  std::string refused = {};  // why nothing of it is shown; empty: every answer was computed again and fits
  std::vector<std::string> studies = {};
};

// The mean of a metric in one study of one store.
struct SiteValue {
  inference::Metric metric;
  inference::Estimate mean = {};
};

// A solver in one study of one store.
struct SiteRow {
  std::string submission, study, problem, solver, algorithm, robot, machine;
  std::int64_t solves = 0, planned = 0;
  std::vector<SiteValue> values = {};
};

// The rows of a study. `problem` says what must be the same for errors to be comparable: arm, targets, starts, limits
// and stop rule.
std::vector<SiteRow> site_rows(const std::string& submission, const results::StudyEntry& entry,
                               const inference::JudgedStudy& study, const std::string& machine);

// Writes index.html and a page for each study, solver and arm into the folder; returns their number. Errors are
// compared between rows of one problem, times within one store; a cell says with how many others. A row of which solves
// are missing is compared with none. Throws as write_file does.
std::size_t write_site(const std::vector<Submission>& submissions, const std::vector<SiteRow>& rows,
                       const std::filesystem::path& folder);

}  // namespace ikbench::report
