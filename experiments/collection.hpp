// A user's collection: studies that are run into one store and judged together, listed by one file. With seeds it is
// one study, once with each seed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/study_reader.hpp"

namespace ikbench::experiments {

struct StudyCollection {
  std::string name;  // results go to out/<name>/
  std::string title;
  std::vector<Study> studies;  // two at least
  bool are_seeds = false;      // they are one study with several seeds: NAME-seed-1, ...
};

// Reads a TOML file that has the key `studies`: built-in studies, and files in its folder; with the key `seeds` only
// one. Nothing if the file has no such key, or there is no such file. Overrides are those of every study. Throws
// std::invalid_argument as parse_study does, and if the studies cannot be judged by one test: their plans differ, no
// two solvers are in all of them, or runs are the observations and their numbers differ.
std::optional<StudyCollection> load_collection(const std::string& file, const Overrides& overrides = {});

}  // namespace ikbench::experiments
