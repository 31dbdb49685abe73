// A study in the format of IOHprofiler (Doerr, Wang, Ye, van Rijn and Baeck 2018), for IOHanalyzer and IOHinspector. A
// target of the path is a function, a run an instance, the number of searched joints the dimension, and the error [cm]
// the objective. Each solve lists the evaluations at which its best error became smaller.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "results/store.hpp"

namespace ikbench::results {

// Writes a folder for each solver: IOHprofiler_f1_target.json, data_f1_target/IOHprofiler_f1_DIM7.dat and so on. If a
// program gave no answer, evaluation 1 has the error at the start and is the last. Returns the solvers that are left
// out because ikbench did not count their evaluations. Throws std::invalid_argument if no solver has traces, if points
// or runs exceed IOHprofiler's numbers, or if the folder is not empty or cannot be written.
std::vector<std::string> write_iohprofiler(const std::filesystem::path& folder, const StudyEntry& study,
                                           const std::vector<SolveRecord>& solves);

}  // namespace ikbench::results
