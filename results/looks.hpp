// Which looks a store has had: how many runs there were when a report or a comparison was made. Whoever adds runs and
// looks again until p is small enough finds differences that are none; a later look says so.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "results/store.hpp"

namespace ikbench::results {

struct Look {
  int runs = 0;
  std::string when = {};  // date and time, UTC
};

// What is looked at: these solvers in a study, by a report or a comparison. Other solves are something else.
std::string looked_at(std::string_view by, const std::string& study, const std::vector<Series>& series);

// The fewest runs first; none where the store cannot tell.
std::vector<Look> looks_at(const std::string& what, const std::filesystem::path& store);
// Once for so many runs: the same look again changes nothing. A store that may only be read forgets it.
void remember_look(const std::string& what, int runs, const std::filesystem::path& store);

}  // namespace ikbench::results
