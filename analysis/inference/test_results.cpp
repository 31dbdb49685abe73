#include "analysis/inference/test_results.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "analysis/inference/text.hpp"
#include "analysis/statistics/effect_size.hpp"
#include "analysis/statistics/mann_whitney.hpp"
#include "analysis/statistics/sign_test.hpp"
#include "analysis/statistics/welch.hpp"

namespace ikbench::inference {

using namespace statistics;

namespace {

std::string in_brackets(const std::string& text) { return text.empty() ? "" : fmt::format(" ({})", text); }

}  // namespace

TestResult of_bartlett(const Bartlett& test) {
  return {.test = std::string(bartlett_name),
          .role = Role::assumption,
          .symbol = "chi^2",
          .statistic = test.chi_squared,
          .df = static_cast<double>(test.df),
          .p = test.p,
          .undefined = test.undefined};
}

TestResult of_brown_forsythe(const BrownForsythe& test) {
  return {.test = std::string(brown_forsythe_name),
          .role = Role::assumption,
          .symbol = "F",
          .statistic = test.F,
          .df = static_cast<double>(test.df_between),
          .df_within = static_cast<double>(test.df_within),
          .p = test.p,
          .undefined = test.undefined};
}

TestResult of_kruskal_wallis(const KruskalWallis& test) {
  return {.test = std::string(kruskal_wallis_name),
          .symbol = "H",
          .statistic = test.H,
          .df = static_cast<double>(test.df),
          .p = test.p,
          .effect_symbol = "epsilon^2",
          .effect = test.epsilon_squared,
          .undefined = test.undefined};
}

TestResult of_anova(const AnovaTable& table) {
  return {.test = std::string(anova_name),
          .role = Role::paper,
          .symbol = "F",
          .statistic = table.F,
          .df = static_cast<double>(table.df_between),
          .df_within = static_cast<double>(table.df_within),
          .p = table.p,
          .effect_symbol = "omega^2",
          .effect = omega_squared(table),
          .undefined = table.undefined};
}

TestResult of_welch(const std::vector<GroupEvidence>& groups, std::span<const GroupSummary> summaries) {
  TestResult result{.test = std::string(welch_name), .role = Role::robust, .symbol = "F"};
  std::vector<GroupSummary> usable;
  std::vector<std::string> others;
  for (std::size_t i = 0; i < summaries.size(); ++i) {
    const bool weighed = summaries[i].n >= 2 && summaries[i].std > 0 && std::isfinite(summaries[i].mean);
    if (weighed) {
      usable.push_back(summaries[i]);
    } else {
      others.push_back(row_label(groups[i].name, longest_group_name));
    }
  }
  if (usable.size() < 2) {
    result.undefined = "fewer than two groups have a variance";
    return result;
  }
  const WelchAnova test = welch_anova(usable);
  result.statistic = test.F;
  result.df = test.df_between;
  result.df_within = test.df_within;
  result.p = test.p;
  if (!std::isfinite(test.p)) result.undefined = "the variances are too large or too far apart for double precision";
  if (!others.empty()) {
    constexpr std::size_t most_named = 3;
    result.without = fmt::format("without {}, whose variance is 0 or not defined",
                                 others.size() > most_named ? fmt::format("{} groups", others.size())
                                                            : fmt::format("{}", fmt::join(others, ", ")));
  }
  return result;
}

TestResult of_two(const std::vector<double>& first, const std::vector<double>& second, const Evidence& evidence) {
  if (evidence.blocks > 0) {
    const SignTest test = sign_test(first, second);
    return {.test = "Sign test within blocks",
            .symbol = "blocks above",
            .statistic = static_cast<double>(test.above),
            .p = test.p,
            .undefined = test.undefined};
  }
  const MannWhitney test = mann_whitney(first, second);
  return {.test = "Mann-Whitney test" + in_brackets(test.method),
          .symbol = "U",
          .statistic = test.U,
          .p = test.p,
          .undefined = test.undefined};
}

}  // namespace ikbench::inference
