// Writes a study as text: TOML to edit and run, JSON for the store. The reader (reader.hpp) makes the same study of
// either. The keys of stored solves are made in series_key.hpp.
#pragma once

#include <string>

#include "base/json.hpp"
#include "experiments/study/study.hpp"
#include "results/store.hpp"

namespace ikbench::experiments {

// Returns the whole study as a file, with a comment behind each key. parse_study makes the same study of it.
std::string to_toml(const Study& study);
// Returns a path as the table [path] of a study.
std::string to_toml(Path path);
// Returns a style of figures as the keys of [figures].
std::string to_toml(results::FigureStyle style);
// Returns the definition of the study as the store keeps it: its settings, number of points, arm, departures and reach.
std::string to_json(const Study& study);
// Returns an arm as the definition has it at "/arm", for comparisons with a stored arm.
base::Json arm_json(const Robot& arm);
// Returns a plan as the definition has it at "/analysis", which each session keeps.
std::string to_json(results::AnalysisPlan plan);

// Returns the study as the store keeps it, with its series. This makes the keys of all series, which takes time, so a
// run calls it once. Throws std::invalid_argument if a value of the study is impossible.
results::StoredStudy to_stored(const Study& study);

}  // namespace ikbench::experiments
