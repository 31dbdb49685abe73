// Which looks a store has had: how many runs there were when a report or a comparison was made. Whoever adds runs and
// looks again until p is small enough finds differences that are none; a later look says so.
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

// The store to be read by who remembers a look at it: what a kill in the middle of that has left is undone first.
Store open_to_look(const std::filesystem::path& store);

// At a study, by a report or a comparison; the fewest runs first. None where the store cannot tell.
std::vector<Look> looks_at(const std::string& study, const std::filesystem::path& store);
// The rows of the table `meta` that are such looks.
std::map<std::string, std::string> looks_among(const std::map<std::string, std::string>& meta,
                                               const std::string& study);
// Once for so many runs: the same look again changes nothing. A store that may only be read forgets it.
void remember_look(const std::string& study, int runs, const std::filesystem::path& store);

}  // namespace ikbench::results
