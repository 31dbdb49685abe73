// The margin of a plan: a difference of two means that is within it does not matter.
//
// It is relative, a share of the smaller of the two means, and for what is measured in cm, or as the user says, also
// absolute. A difference is within the margin if it is within either: near 0 a share means nothing, and far from 0 a
// length that an arm cannot resolve is nothing beside the share. So the larger of the two is what counts. Of outcomes,
// whose means are shares themselves, it is the difference of two shares. Of logarithms the margin is relative: a ratio
// up to 1 + margin.
#pragma once

#include <string>
#include <string_view>

#include "analysis/inference/evidence.hpp"

namespace ikbench::inference {

bool has_absolute_margin(const Evidence& evidence);

// "5 %", "5 % or 0.01 cm", "0.01 cm"; 0: there is no absolute one.
std::string margin_words(double margin, double absolute_margin, std::string_view unit = " cm");

// A relative margin of what has negative values, so that a mean may be 0, is std::invalid_argument.
void check_margin(const Observations& observations, const results::AnalysisPlan& plan);
void check_margin(const Summaries& summaries, const results::AnalysisPlan& plan);

// As a difference of the two means of a pair; NaN where one of these is.
double margin_of(const Evidence& evidence, const Contrast& contrast);

// Of the contrast's interval, for the one that is ahead.
Extent extent_of(const Evidence& evidence, const Contrast& contrast);

}  // namespace ikbench::inference
