#include "analysis/report/over_arms.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "analysis/inference/judge.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/answer.hpp"
#include "analysis/report/words.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "analysis/statistics/tails.hpp"

namespace ikbench::report {

using namespace results;
using namespace inference;
using namespace statistics;
using namespace fmt::literals;

namespace {

constexpr std::size_t fewest_arms = 3;

// Shares of solved poses by solver, in the arms that all solvers have. A solver that no arm has is left out.
Observations shares_by_arm(std::span<const RatesOfArm> arms) {
  Observations all{.name = "over-arms", .quantity = "share of solved poses", .better = Better::larger};
  all.scale = ValueScale::share;
  all.replicate = "the share of an arm's poses";
  all.block = "an arm";
  all.block_noun = "arms";
  const auto is_solved = [](const Rate& rate) { return std::isfinite(rate.ours.value); };
  std::vector<std::size_t> solvers;
  for (std::size_t i = 0; i < arms.front().rates.size(); ++i) {
    if (!std::ranges::any_of(arms, [&](const RatesOfArm& arm) { return is_solved(arm.rates[i]); })) continue;
    solvers.push_back(i);
    all.groups.push_back({.name = arms.front().rates[i].solver});
  }
  for (const RatesOfArm& arm : arms) {
    if (!std::ranges::all_of(solvers, [&](std::size_t i) { return is_solved(arm.rates[i]); })) continue;
    all.blocks.push_back(arm.arm);
    for (std::size_t i = 0; i < solvers.size(); ++i) all.groups[i].values.push_back(arm.rates[solvers[i]].ours.value);
  }
  return all;
}

Observations without(Observations all, std::size_t arm) {
  const auto at = static_cast<std::ptrdiff_t>(arm);
  all.blocks.erase(all.blocks.begin() + at);
  for (Group& group : all.groups) group.values.erase(group.values.begin() + at);
  return all;
}

// Differences of shares cannot be beyond 100 %.
Range percentages(double low, double high) { return {100 * std::max(-1.0, low), 100 * std::min(1.0, high)}; }

// Where the difference of a new arm lies with this level, if differences are normal (Hahn and Meeker 1991, Sect. 4.7);
// empty if all arms have the same difference.
Cell of_new_arm(const std::vector<double>& differences, double level) {
  const double spread = standard_deviation(differences);
  if (!(spread > 0)) return {};
  const auto n = static_cast<double>(differences.size());
  const double centre = mean(differences), reach = t_quantile((1 + level) / 2, n - 1) * spread * std::sqrt(1 + 1 / n);
  return percentages(centre - reach, centre + reach);
}

// The verdicts of a pair without each arm.
using Without = std::vector<Evidence>;

// Names the arms without which the pair's verdict is another.
std::string deciding_arms(const Observations& all, const Without& others, const Group& first, const Group& second,
                          Relation found) {
  std::vector<std::string> names;
  for (std::size_t arm = 0; arm < others.size(); ++arm) {
    if (judge(others[arm], first.name, second.name).relation != found) names.push_back(all.blocks[arm]);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

OverArms over_arms(std::span<const RatesOfArm> arms, const AnalysisPlan& plan) {
  const Observations all = shares_by_arm(arms);
  if (all.blocks.size() < fewest_arms || all.groups.size() < 2) return {};
  AnalysisPlan of_means = plan;
  of_means.test = by_design;
  of_means.control.clear();
  const Evidence found = evidence(all, of_means);
  Without others;
  for (std::size_t arm = 0; arm < all.blocks.size(); ++arm) others.push_back(evidence(without(all, arm), of_means));
  OverArms result{.table = {.name = "over-arms",
                            .caption = fmt::format(words::over_arms_caption, "arms"_a = all.blocks.size()),
                            .columns = {"first", "second", "verdict", "difference of shares [%]", "interval", "p",
                                        "a new arm", "arms where first solves more", "arms that decide"}}};
  std::vector<const Group*> order;  // the best first
  for (const Group& group : all.groups) order.push_back(&group);
  std::ranges::stable_sort(order, std::greater<>(), [](const Group* group) { return mean(group->values); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t k = i + 1; k < order.size(); ++k) {
      const Group &first = *order[i], &second = *order[k];
      std::vector<double> differences;
      int ahead = 0;
      for (std::size_t arm = 0; arm < all.blocks.size(); ++arm) {
        differences.push_back(first.values[arm] - second.values[arm]);
        ahead += differences.back() > 0 ? 1 : 0;
      }
      const Finding pair = judge(found, first.name, second.name);
      result.table.rows.push_back({first.name, second.name, std::string(name_of(pair.relation)),
                                   100 * mean(differences), percentages(pair.estimate.low, pair.estimate.high), pair.p,
                                   of_new_arm(differences, 1 - plan.significance),
                                   fmt::format("{} of {}", ahead, all.blocks.size()),
                                   deciding_arms(all, others, first, second, pair.relation)});
    }
  }
  const auto label = [&](std::size_t group) {
    return fmt::format("{} ({})", found.groups[group].name, percent(found.groups[group].described.mean));
  };
  result.sentence = {fmt::format(words::over_arms, "arms"_a = all.blocks.size()),
                     fmt::format("{}.", fmt::join(short_answer(found, label), ". "))};
  result.table.notes = {words_of(result.sentence), std::string(words::over_arms_note),
                        fmt::format(words::over_arms_population, "arms"_a = fmt::join(all.blocks, ", "))};
  return result;
}

}  // namespace ikbench::report
