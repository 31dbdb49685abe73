// The independent trials that an interval of a share may count.
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/inference/study.hpp"

namespace ikbench::inference {

// A deterministic solver that gets a target again, as in the runs of a fixed path, only repeats itself: its solves are
// not trials.
enum class Trials { runs, targets, solves };
Trials trials_of(const StudyResults& study);

// Numbers the targets of the study's solves from 0. Solves with equal position and rotation have equal numbers.
std::vector<std::uint32_t> target_numbers(const StudyResults& study);

}  // namespace ikbench::inference
