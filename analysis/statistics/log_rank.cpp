#include "analysis/statistics/log_rank.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "analysis/statistics/tails.hpp"

namespace ikbench::statistics {
namespace {

struct Trial {
  double spent = 0;
  bool reached = false;
  std::size_t group = 0;
};

using Matrix = std::vector<std::vector<double>>;

std::string wrong_with_groups(std::span<const std::vector<CensoredCost>> groups) {
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const std::string wrong = wrong_with(groups[i]);
    if (!wrong.empty()) return fmt::format("group {}: {}", i + 1, wrong);
  }
  if (groups.size() > 1) return {};
  return fmt::format("{} to compare; two or more are needed", groups.empty() ? "no group" : "one group");
}

// x' A^-1 x of a symmetric positive definite A, by Cholesky's decomposition; NaN where A is not.
double quadratic_form(Matrix A, const std::vector<double>& x) {
  std::vector<double> y(x.size());  // L y = x
  double form = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    double pivot = A[i][i], rest = x[i];
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t m = 0; m < j; ++m) A[i][j] -= A[i][m] * A[j][m];
      A[i][j] /= A[j][j];
      pivot -= A[i][j] * A[i][j];
      rest -= A[i][j] * y[j];
    }
    if (!(pivot > 1e-12 * A[i][i])) return not_defined;
    A[i][i] = std::sqrt(pivot);
    y[i] = rest / A[i][i];
    form += y[i] * y[i];
  }
  return form;
}

}  // namespace

LogRank log_rank(std::span<const std::vector<CensoredCost>> groups) {
  LogRank test{.undefined = wrong_with_groups(groups)};
  if (!test.undefined.empty()) return test;
  const std::size_t k = groups.size();
  std::vector<Trial> trials;
  std::vector<double> at_risk(k);
  for (std::size_t g = 0; g < k; ++g) {
    at_risk[g] = static_cast<double>(groups[g].size());
    for (const CensoredCost& cost : groups[g]) trials.push_back({cost.spent, cost.reached, g});
  }
  std::ranges::sort(trials, {}, &Trial::spent);

  test.observed.assign(k, 0);
  test.expected.assign(k, 0);
  Matrix covariance(k, std::vector<double>(k, 0.0));
  for (std::size_t first = 0, end = 0; first < trials.size(); first = end) {
    const auto n = static_cast<double>(trials.size() - first);
    double reached = 0;
    for (; end < trials.size() && trials[end].spent == trials[first].spent; ++end) {
      if (!trials[end].reached) continue;
      ++reached;
      ++test.observed[trials[end].group];
    }
    if (reached > 0) {  // hypergeometric: `reached` of n drawn without regard to the group
      const double scale = n > 1 ? reached * (n - reached) / (n * n * (n - 1)) : 0.0;
      for (std::size_t g = 0; g < k; ++g) {
        test.expected[g] += reached * at_risk[g] / n;
        covariance[g][g] += scale * at_risk[g] * n;
        for (std::size_t h = 0; h < k; ++h) covariance[g][h] -= scale * at_risk[g] * at_risk[h];
      }
    }
    for (std::size_t i = first; i < end; ++i) --at_risk[trials[i].group];
  }

  std::vector<std::size_t> compared;  // a group that nobody was left of when the first trial got there says nothing
  for (std::size_t g = 0; g < k; ++g) {
    if (test.expected[g] > 0) compared.push_back(g);
  }
  if (compared.size() < 2) {
    test.undefined = compared.empty() ? "no trial reached the tolerance" : "only one group was tried for long enough";
    return test;
  }
  compared.pop_back();  // the differences add up to zero, so the last follows from the others
  std::vector<double> differences;
  Matrix reduced;
  for (const std::size_t g : compared) {
    differences.push_back(test.observed[g] - test.expected[g]);
    std::vector<double>& row = reduced.emplace_back();
    for (const std::size_t h : compared) row.push_back(covariance[g][h]);
  }
  test.chi_squared = quadratic_form(std::move(reduced), differences);
  if (std::isnan(test.chi_squared)) {
    test.undefined = "all trials reached the tolerance at one cost, so there is no spread to compare with";
    return test;
  }
  test.df = static_cast<int>(compared.size());
  test.p = chi_squared_upper_tail(test.chi_squared, test.df);
  return test;
}

}  // namespace ikbench::statistics
