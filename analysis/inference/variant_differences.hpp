// In what a variant and its baseline differ beside their numbers, by what their stores say: settings, options, program
// and machine; and whether that lets their times be compared.
#pragma once

#include <string>

#include "analysis/inference/variants.hpp"

namespace ikbench::inference {

// Why their times cannot be compared: one is not clean, or they are of several CPUs or of unknown ones, or of separate
// sessions, whose differences no number of runs shows, or of a program and of what runs here; empty where they can.
std::string why_times_differ(const Variant& a, const Variant& b);

// Why their evaluations cannot: one side claims them, and the other's were counted; empty where they can.
std::string why_counts_differ(const Variant& a, const Variant& b);

// "B differs from A in stop.iterations (200, 100), commit (1a2b3c, 4d5e6f)." or that the stores tell no difference.
std::string differences(const Variant& a, const Variant& b);

}  // namespace ikbench::inference
