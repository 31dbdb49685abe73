#include "analysis/inference/pair_ranks.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "analysis/statistics/brunner_munzel.hpp"
#include "analysis/statistics/friedman.hpp"
#include "analysis/statistics/kruskal_wallis.hpp"
#include "analysis/statistics/mann_whitney.hpp"
#include "analysis/statistics/p_adjust.hpp"
#include "analysis/statistics/sign_test.hpp"
#include "analysis/statistics/studentized_range.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

using RankedValues = std::span<const std::vector<double>>;

Correction correction_of(Adjustment adjustment) {
  switch (adjustment) {
    case Adjustment::hochberg:
      return Correction::hochberg;
    case Adjustment::bonferroni:
      return Correction::bonferroni;
    case Adjustment::benjamini_hochberg:
      return Correction::benjamini_hochberg;
    default:
      return Correction::holm;
  }
}

template <class Test>
void take(const Evidence& evidence, Test test, Contrast& contrast) {
  contrast.ahead_by_ranks = -test.direction;  // the larger is the worse
  if (!evidence.ranks_decide()) return;
  contrast.ahead = contrast.ahead_by_ranks;
  contrast.undefined = std::move(test.undefined);
}

void compare_two_by_two(const Evidence& evidence, RankedValues ranked, std::vector<Contrast>& shown) {
  const bool in_blocks = evidence.ranks_within_blocks();
  for (Contrast& contrast : shown) {
    const std::vector<double>&first = ranked[contrast.first], &second = ranked[contrast.second];
    if (in_blocks) {
      const SignTest test = sign_test(first, second);
      contrast.p_ranks = test.p;
      take(evidence, test, contrast);
    } else {
      const MannWhitney test = mann_whitney(first, second);
      contrast.p_mann_whitney = test.p;
      contrast.p_brunner_munzel = brunner_munzel(first, second).p;
      take(evidence, test, contrast);
    }
  }
  if (in_blocks) {
    correct(evidence, &Contrast::p_ranks, shown);
    return;
  }
  correct(evidence, &Contrast::p_mann_whitney, shown);
  correct(evidence, &Contrast::p_brunner_munzel, shown);
  for (Contrast& contrast : shown) contrast.p_ranks = std::fmax(contrast.p_mann_whitney, contrast.p_brunner_munzel);
}

void compare_mean_ranks(const Evidence& evidence, RankedValues ranked, std::vector<Contrast>& shown) {
  const std::vector<RankComparison> all =
      evidence.ranks_within_blocks() ? compare_average_ranks(friedman(ranked)) : dunn(ranked);
  auto next = all.begin();  // both are in order
  for (Contrast& contrast : shown) {
    while (next->first != contrast.first || next->second != contrast.second) ++next;
    contrast.p_mean_ranks = next->p;
  }
  correct(evidence, &Contrast::p_mean_ranks, shown);
}

void add_nemenyi(const Evidence& evidence, std::vector<Contrast>& shown) {
  const auto k = static_cast<double>(evidence.groups.size()), n = static_cast<double>(evidence.blocks);
  const double error = std::sqrt(k * (k + 1) / (6 * n));
  const StudentizedRange range(k);
  for (Contrast& contrast : shown) {
    const double apart =
        std::abs(evidence.groups[contrast.first].average_rank - evidence.groups[contrast.second].average_rank);
    contrast.p_nemenyi = range.upper_tail(apart / error * std::sqrt(2.0), std::numeric_limits<double>::infinity());
  }
}

}  // namespace

void correct(const Evidence& evidence, double Contrast::*p, std::vector<Contrast>& shown) {
  std::vector<double> raw;
  for (const Contrast& contrast : shown) raw.push_back(std::isnan(contrast.*p) ? 1 : contrast.*p);
  raw.resize(evidence.family(), 1);
  const std::vector<double> corrected = adjusted(raw, correction_of(evidence.plan.adjustment));
  for (std::size_t i = 0; i < shown.size(); ++i) {
    if (!std::isnan(shown[i].*p)) shown[i].*p = corrected[i];
  }
}

void add_rank_tests(const Evidence& evidence, RankedValues ranked, std::vector<Contrast>& shown) {
  if (ranked.empty()) return;
  compare_two_by_two(evidence, ranked, shown);
  if (evidence.groups.size() == 2) return;
  compare_mean_ranks(evidence, ranked, shown);
  if (evidence.ranks_within_blocks() && std::isfinite(evidence.critical_difference)) add_nemenyi(evidence, shown);
}

}  // namespace ikbench::inference
