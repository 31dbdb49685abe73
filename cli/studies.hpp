// The report of several studies, with a column per study: of a sweep (`run --sweep`, `report STORE`), and of several
// stores (`report STORE STORE`).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/reporting.hpp"

namespace ikbench::cli {

// A study of a store, and its name in the table.
struct NamedStudy {
  const results::Store& store;
  results::StoredStudy study;
  std::string name;
};

// The studies of a table.
struct StudiesToReport {
  std::string title;
  std::vector<std::string> keys;  // swept keys; empty: the studies of several stores
  std::vector<NamedStudy> studies;
};

// Returns the studies of a sweep in the store. The sweep must not be empty.
StudiesToReport studies_of_sweep(const results::Store& store, const std::vector<results::StoredStudy>& sweep);
// Writes the report into the folder, and prints its screen or JSON. Without a report only JSON or the checks of
// requirements are printed. Returns the exit code: 3 if a solver gave no answer in any solve of a study, otherwise the
// code of the requirements.
int report_studies(const StudiesToReport& studies, const std::filesystem::path& folder,
                   const ReportArguments& arguments, bool has_report = true);

}  // namespace ikbench::cli
