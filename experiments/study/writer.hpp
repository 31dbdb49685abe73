// Writes a study as text: TOML to edit and run, JSON for the store. The reader (reader.hpp) makes the same study of
// either. The keys of stored solves are made in series_key.hpp.
#pragma once

#include <string>

#include "base/json.hpp"
#include "experiments/study/study.hpp"
#include "results/store.hpp"

namespace ikbench::experiments {

// Returns the whole study as a file; parse_study gives the same study again.
std::string to_toml(const Study& study);
// Returns a path as the table [path] of a study.
std::string to_toml(Path path);
// Returns a look of figures as the table [figures].
std::string to_toml(results::FigureStyle style);
// Returns the study without its solvers, with its number of points and its arm, as the store keeps it.
std::string to_json(const Study& study);
// Returns an arm as the definition has it at "/arm".
base::Json arm_json(const Robot& arm);
// Returns a plan as the definition has it at "/analysis".
std::string to_json(results::AnalysisPlan plan);

// Returns the study as the store keeps it, with its series. This makes the keys of all series, which takes time, so a
// run calls it once. Throws std::invalid_argument if a value of the study is impossible.
results::StoredStudy to_stored(const Study& study);

}  // namespace ikbench::experiments
