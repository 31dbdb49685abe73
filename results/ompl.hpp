// A study as OMPL's benchmarks have it (Moll, Sucan and Kavraki 2015), for Planner Arena and OMPL's own script: the
// study is the experiment, a series a planner, a solve a run, the trace of a solve its progress.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "results/store.hpp"

namespace ikbench::results {

// What is exported: solves are those of the study.
struct ExportedStudy {
  StudyEntry study;
  std::vector<Session> sessions;
  std::vector<SolveRecord> solves;
};

// The log that ompl_benchmark_statistics reads. Times within a trace share the solve's time evenly. std::logic_error
// where the definition is not JSON.
std::string to_ompl_log(const ExportedStudy& exported);
// The database that it makes of that log, table by table. A file that is there is replaced. std::invalid_argument where
// it cannot be written.
void write_ompl_database(const std::filesystem::path& file, const ExportedStudy& exported);

}  // namespace ikbench::results
