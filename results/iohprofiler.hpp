// A study as IOHprofiler's benchmarks have it (Doerr, Wang, Ye, van Rijn and Baeck 2018), for IOHanalyzer and
// IOHinspector: a target of the path is a function, a run an instance, the number of joints searched the dimension, and
// the error [cm] what is minimised. Of each solve there are the evaluations at which the best error became smaller.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "results/store.hpp"

namespace ikbench::results {

// Writes a folder for each solver: IOHprofiler_f1_target.json, data_f1_target/IOHprofiler_f1_DIM7.dat and so on. Where
// a program gave no answer, evaluation 1 has the error at the start and is the last. Gives the solvers that are left
// out, because nobody here counted their evaluations. std::invalid_argument where no solver has traces, where points or
// runs are more than IOHprofiler's numbers allow, or where the folder is not empty or cannot be written.
std::vector<std::string> write_iohprofiler(const std::filesystem::path& folder, const StudyEntry& study,
                                           const std::vector<SolveRecord>& solves);

}  // namespace ikbench::results
