#include "analysis/report/rates.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "analysis/figures/row_figures.hpp"
#include "analysis/inference/judge.hpp"
#include "analysis/inference/outcomes.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/assessment_words.hpp"
#include "analysis/report/paper.hpp"
#include "analysis/report/words.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "analysis/statistics/tails.hpp"
#include "results/published.hpp"

namespace ikbench::report {

using namespace results;
using namespace inference;
using namespace statistics;
using namespace fmt::literals;

namespace {

Cell percentage(double share) { return std::isfinite(share) ? Cell(100 * share) : Cell(); }

Estimate rate_within(const StudyResults& study, std::string_view solver, int iterations, double level) {
  Successes count;
  for (const Solve& solve : solves_of(study, solver)) {
    ++count.trials;
    if (solve.status == Status::ok && static_cast<int>(solve.iterations) <= iterations) ++count.successes;
  }
  return wilson(count, level);
}

int most_iterations(const StudyResults& study) {
  std::uint32_t most = 0;
  for (const Solve& solve : study.solves) most = std::max(most, solve.iterations);
  return static_cast<int>(most);
}

Rate rate_of(const StudyResults& study, const std::string& solver, double printed, const RatesPlan& plan) {
  Rate rate{.solver = solver, .printed = printed, .ours = solve_rate(study, solver, plan.level)};
  const int most = most_iterations(study);
  const int longest = plan.iterations.empty() ? 0 : std::min(most, plan.iterations.back());
  for (int iterations = 1; iterations <= longest; ++iterations) {
    const Rate shorter{
        .solver = solver, .printed = printed, .ours = rate_within(study, solver, iterations, plan.level)};
    if (!shorter.is_as_printed()) continue;
    if (rate.first == 0) rate.first = iterations;
    rate.last = iterations;
  }
  return rate;
}

std::optional<std::size_t> row_of(const CsvTable& printed, const std::string& arm) {
  for (std::size_t row = 0; row < printed.rows.size(); ++row) {
    if (printed.rows[row][printed.column("arm")] == arm) return row;
  }
  return std::nullopt;
}

// Returns whether any arm has solves of the solver with this index.
bool is_here(const std::vector<RatesOfArm>& arms, std::size_t solver) {
  return std::ranges::any_of(arms, [&](const RatesOfArm& arm) { return !std::isnan(arm.rates[solver].ours.value); });
}

Table rates_table(const std::vector<RatesOfArm>& arms, const RatesPlan& plan) {
  const bool is_printed = !plan.table.empty();
  Table table{.name = "solve-rates",
              .caption = fmt::format("Solved poses [%], {}with {} intervals", is_printed ? "as printed and here, " : "",
                                     percent(plan.level)),
              .columns = {"arm"}};
  int iterations = 0;
  for (const RatesOfArm& arm : arms) {
    iterations = std::max(iterations, arm.iterations);
    table.rows.push_back({arm.arm});
  }
  for (std::size_t i = 0; i < arms.front().rates.size(); ++i) {
    const std::string& solver = arms.front().rates[i].solver;
    if (is_printed) table.columns.push_back(solver + ", printed");
    if (is_here(arms, i)) {
      table.columns.insert(table.columns.end(), {solver + (is_printed ? ", here" : ""), solver + ", interval"});
    }
    for (std::size_t row = 0; row < arms.size(); ++row) {
      const Rate& rate = arms[row].rates[i];
      if (is_printed) table.rows[row].push_back(percentage(rate.printed));
      if (!is_here(arms, i)) continue;
      table.rows[row].push_back(percentage(rate.ours.value));
      table.rows[row].emplace_back(Range{100 * rate.ours.low, 100 * rate.ours.high});
    }
  }
  if (!plan.note.empty()) table.notes = {plan.note, fmt::format("Here: at most {} iterations.", iterations)};
  return table;
}

// Draws a printed share in the colour of ours.
figures::Figure rates_figure(const std::vector<RatesOfArm>& arms, const RatesPlan& plan) {
  std::vector<std::string> rows;
  for (const RatesOfArm& arm : arms) rows.push_back(arm.arm);
  std::vector<figures::RateSeries> series;
  for (std::size_t i = 0; i < arms.front().rates.size(); ++i) {
    if (!is_here(arms, i)) continue;
    figures::RateSeries here{.name = arms.front().rates[i].solver,
                             .colour = inference::style_of(*arms.front().study, arms.front().rates[i].solver),
                             .shares = {}},
        printed = here;
    printed.name += ", printed";
    printed.is_ring = true;
    for (const RatesOfArm& arm : arms) {
      here.shares.push_back(arm.rates[i].ours);
      printed.shares.push_back({.value = arm.rates[i].printed});
    }
    series.push_back(std::move(here));
    if (!plan.table.empty()) series.push_back(std::move(printed));
  }
  return figures::rates_figure(
      rows, series,
      {.name = "solve-rates-figure",
       .quantity = "solved poses",
       .caption = fmt::format("Solved poses, with {} intervals. {}", percent(plan.level), plan.caption)});
}

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

// The difference of a new arm lies here with this level, if differences are normal (Hahn and Meeker 1991, Sect. 4.7);
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

// The table over-arms has a row for each pair of solvers; the sentence says who solves more, over all arms, and is
// empty if fewer than three arms have all solvers. The plan's significance, adjustment and margin count; its test does
// not, because the question is about means over arms.
struct OverArms {
  Table table;
  Sentence sentence;
};

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

}  // namespace

std::vector<RatesOfArm> solve_rates(const Reported& reported, const RatesPlan& plan) {
  const CsvTable printed = plan.table.empty() ? CsvTable() : published::table(plan.paper, plan.table);
  std::vector<std::reference_wrapper<const JudgedStudy>> studies{reported.study};
  studies.insert(studies.end(), reported.companions.begin(), reported.companions.end());
  std::vector<RatesOfArm> arms;
  for (const JudgedStudy& study : studies) {
    if (study.solves.empty()) continue;
    const auto named = plan.rows.find(study.solve_data->robot);
    const std::string arm = named == plan.rows.end() ? study.solve_data->robot : named->second;
    const std::optional<std::size_t> row = row_of(printed, arm);
    if (!plan.table.empty() && !row) continue;
    RatesOfArm& rates =
        arms.emplace_back(RatesOfArm{.arm = arm, .iterations = most_iterations(study), .rates = {}, .study = &study});
    if (row) {
      for (const auto& [solver, column] : plan.columns)
        rates.rates.push_back(rate_of(study, solver, printed.number(*row, column) / 100, plan));
    } else {
      for (const std::string& solver : reported.study.solvers)
        rates.rates.push_back(rate_of(study, solver, not_defined, plan));
    }
  }
  return arms;
}

void add_rates(StudyPieces& pieces, const Reported& reported, const RatesPlan& plan) {
  const std::vector<RatesOfArm> arms = plan.level > 0 ? solve_rates(reported, plan) : std::vector<RatesOfArm>();
  if (arms.empty()) return;
  pieces.tables.push_back(rates_table(arms, plan));
  pieces.results = pieces.tables.back().name;
  pieces.figures.push_back(rates_figure(arms, plan));
  OverArms over = over_arms(arms, reported.study.plan);
  if (over.sentence.text.empty()) return;
  pieces.tables.push_back(std::move(over.table));
  pieces.verdict.push_back(std::move(over.sentence));
}

}  // namespace ikbench::report
