// The margin of a plan: a difference of two means within it does not matter.
//
// The margin is relative, a share of the smaller mean; for quantities in cm, or if the user says so, it is also
// absolute. The larger of the two counts: near 0 a share means nothing, and far from 0 a length that an arm cannot
// resolve is tiny beside the share. For shares the margin is a difference in percentage points. For logarithms it is a
// ratio up to 1 + margin.
#pragma once

#include <string>
#include <string_view>

#include "analysis/inference/evidence.hpp"

namespace ikbench::inference {

bool has_absolute_margin(const Evidence& evidence);

// "5 %", "5 % or 0.01 cm", "0.01 cm"; a margin of 0 is left out.
std::string margin_words(double margin, double absolute_margin, std::string_view unit = " cm");

// Throws std::invalid_argument for a relative margin if values are negative, since a mean may be 0 then.
void check_margin(const Observations& observations, const results::AnalysisPlan& plan);

// The margin as a difference of a pair's means; NaN if a mean is NaN.
double margin_of(const Evidence& evidence, const Finding& contrast);

// Sets the extent of the contrast's interval, seen from the group that is ahead.
void measure_extent(const Evidence& evidence, Finding& contrast);
// Gives the contrast an infinite size: no margin makes up for a failure.
void put_beyond_any_margin(Finding& contrast);

}  // namespace ikbench::inference
