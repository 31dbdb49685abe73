// In what a variant and its baseline differ beside their numbers, by what their stores say: settings, options, program
// and machine; and whether that lets their times be compared.
#pragma once

#include <string>
#include <vector>

#include "analysis/inference/doubt.hpp"
#include "results/store.hpp"

namespace ikbench::inference {

struct Provenance {
  const results::StudyEntry& study;
  const results::Series& series;
  const std::vector<results::Session>& sessions;  // those that solved it
};

// Why times of different sessions cannot be compared: they are of several CPUs or of unknown ones, or of separate
// sessions, whose differences no number of runs shows; empty where they can.
Doubts why_times_differ(const std::vector<results::Session>& a, const std::vector<results::Session>& b);

// "B differs from A in stop.iterations (200, 100), commit (1a2b3c, 4d5e6f)." or that the stores tell no difference.
std::string differences(const Provenance& a, const Provenance& b);

}  // namespace ikbench::inference
