// Lists what differs between a variant and its baseline: settings, options, program and machine, as their stores record
// them; and decides whether their times are comparable.
#pragma once

#include <string>
#include <vector>

#include "analysis/inference/doubt.hpp"
#include "results/store.hpp"

namespace ikbench::inference {

struct Provenance {
  const results::StudyEntry& study;
  const results::Series& series;
  const std::vector<results::Session>& sessions;  // sessions that solved the study
};

// Reasons not to compare times: several CPUs, unknown CPUs, or separate sessions, whose differences no number of runs
// shows. Empty if times are comparable.
Doubts why_times_differ(const std::vector<results::Session>& a, const std::vector<results::Session>& b);

// "B differs from A in stop.iterations (200, 100), commit (1a2b3c, 4d5e6f)." or a sentence that the stores show no
// difference.
std::string differences(const Provenance& a, const Provenance& b);

}  // namespace ikbench::inference
