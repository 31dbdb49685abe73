// The looks at a store: the number of runs at each report or comparison. Adding runs and looking again until p is small
// enough finds differences that do not exist; a later look warns of it.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "results/store.hpp"

namespace ikbench::results {

struct Look {
  int runs = 0;
  std::string when = {};  // date and time, UTC
};

// Opens the store for reading, by a caller who remembers a look at it; first undoes what a kill in the middle of that
// has left.
Store open_to_look(const std::filesystem::path& store);

// The looks at a study by reports and comparisons, fewest runs first. None if the store cannot tell.
std::vector<Look> looks_at(const std::string& study, const std::filesystem::path& store);
// The rows of the table `meta` that are looks at the study.
std::map<std::string, std::string> looks_among(const std::map<std::string, std::string>& meta,
                                               const std::string& study);
// Remembers a look with this number of runs; the same look again changes nothing. A read-only store remembers nothing.
void remember_look(const std::string& study, int runs, const std::filesystem::path& store);

}  // namespace ikbench::results
