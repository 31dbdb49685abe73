// Lists what differs between a variant and its baseline: settings, options, program and machine, as their stores record
// them; and decides whether their times are comparable.
#pragma once

#include <string>
#include <vector>

#include "analysis/inference/doubt.hpp"
#include "analysis/inference/variants.hpp"
#include "results/store.hpp"

namespace ikbench::inference {

// Reasons not to compare times: several CPUs, unknown CPUs, or separate sessions, whose differences no number of runs
// shows. Empty if times are comparable.
Doubts why_times_differ(const std::vector<results::Session>& a, const std::vector<results::Session>& b);

// "B differs from A in stop.iterations (200, 100), commit (1a2b3c, 4d5e6f)." or a sentence that the stores show no
// difference. The sessions are those that solved the study.
std::string differences(const Variant& a, const std::vector<results::Session>& of_a, const Variant& b,
                        const std::vector<results::Session>& of_b);

}  // namespace ikbench::inference
