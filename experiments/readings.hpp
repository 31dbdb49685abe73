// The readings of a paper that says less than a program needs: its multiverse (multiverse.hpp) in one dimension, each
// alternative beside the default.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/multiverse.hpp"

namespace ikbench::experiments {

// One alternative, known by what --set takes: "path.tool=eq27".
struct Reading {
  std::string set;
  std::string section;  // of the paper's notes
  std::string sentence;
};

// Those of a built-in study: the alternatives of all its dimensions but the defaults.
std::vector<Reading> readings(std::string_view study);

// Readings that are tried together; none of them is the default.
using Combination = std::vector<Reading>;

// The default, then each reading by itself.
std::vector<Combination> one_at_a_time(const std::vector<Reading>& readings);
// Every combination of the named readings, the default first; of readings that set the same thing at most one. An
// unknown or repeated name, and more than 256 combinations, are std::invalid_argument.
std::vector<Combination> full_grid(const std::vector<Reading>& readings, const std::vector<std::string>& names);

// Every combination over several seeds. The numbers of a solver are decided by its series key, so each is solved once,
// whatever combinations it is part of.
struct ReadingsPlan {
  struct Row {
    Combination readings;
    int out_of_reach = 0;                         // targets that no configuration reaches
    std::vector<std::vector<std::size_t>> parts;  // by solver, by seed; indices of `parts` below
  };
  std::vector<std::string> solvers;
  std::vector<Row> rows;
  std::vector<Study> parts;  // one solver, one seed each, in the order in which rows need them
};

// `overrides` hold for the default and all combinations; the seeds are 1 to `seeds`.
ReadingsPlan plan_readings(const std::string& study, const std::vector<Combination>& combinations, int seeds,
                           const Overrides& overrides = {});

}  // namespace ikbench::experiments
