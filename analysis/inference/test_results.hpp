// What each method says of all groups of an Evidence, in the form in which it is told.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "analysis/inference/evidence.hpp"
#include "analysis/statistics/anova.hpp"
#include "analysis/statistics/equal_variances.hpp"
#include "analysis/statistics/kruskal_wallis.hpp"

namespace ikbench::inference {

constexpr std::size_t longest_group_name = 60;

TestResult of_bartlett(const statistics::Bartlett& test);
TestResult of_brown_forsythe(const statistics::BrownForsythe& test);
TestResult of_kruskal_wallis(const statistics::KruskalWallis& test);
TestResult of_anova(const statistics::AnovaTable& table);
// Of those groups that Welch's test can weigh; the others are named.
TestResult of_welch(const std::vector<GroupEvidence>& groups, std::span<const statistics::GroupSummary> summaries);
// Two groups alone: by the ranks of their values, or of the differences where the same was given to both.
TestResult of_two(const std::vector<double>& first, const std::vector<double>& second, const Evidence& evidence);

}  // namespace ikbench::inference
