// Predicts what another study of the same thing would print: ranges of its mean, median, standard deviation, largest
// and smallest value, from the values that we have. Hill's A(n), JASA 63 (1968) 677: the next value is equally likely
// to lie in each of the n + 1 gaps between the known ones, and then is known itself; so the range includes our own
// error of sampling.
#pragma once

#include <array>
#include <span>

#include "analysis/statistics/descriptive.hpp"
#include "analysis/statistics/draw.hpp"

namespace ikbench::statistics {

constexpr std::size_t fewest_predicting = 5;  // values

// Mean, median, standard deviation, largest, smallest.
constexpr std::size_t predicted_statistics = 5;
using PredictedRanges = std::array<Estimate, predicted_statistics>;

// For positive values, by their logarithms: within a gap each place is equally likely; beyond the last value there is
// an exponential tail of Hill's (Annals of Statistics 3 (1975) 1163) slope. NaN if a value is not positive and finite,
// or for fewer than `fewest_predicting` values.
PredictedRanges predicted_ranges(std::span<const double> values, std::size_t runs, const Resampling& settings);

}  // namespace ikbench::statistics
