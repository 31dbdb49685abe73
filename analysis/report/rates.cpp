#include "analysis/report/rates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "analysis/figures/row_figures.hpp"
#include "analysis/inference/outcomes.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/assessment_words.hpp"
#include "analysis/report/paper.hpp"
#include "results/published.hpp"

namespace ikbench::report {

using namespace results;
using namespace inference;
using namespace statistics;

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
  const int longest = std::min(most, plan.iterations);
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
  Table table{.name = "solve-rates",
              .caption = fmt::format("Solved poses [%], as printed and here, with {} intervals", percent(plan.level)),
              .columns = {"arm"}};
  int iterations = 0;
  for (const RatesOfArm& arm : arms) {
    iterations = std::max(iterations, arm.iterations);
    table.rows.push_back({arm.arm});
  }
  for (std::size_t i = 0; i < arms.front().rates.size(); ++i) {
    const std::string& solver = arms.front().rates[i].solver;
    table.columns.push_back(solver + ", printed");
    if (is_here(arms, i)) table.columns.insert(table.columns.end(), {solver + ", here", solver + ", interval"});
    for (std::size_t row = 0; row < arms.size(); ++row) {
      const Rate& rate = arms[row].rates[i];
      table.rows[row].push_back(percentage(rate.printed));
      if (!is_here(arms, i)) continue;
      table.rows[row].push_back(percentage(rate.ours.value));
      table.rows[row].emplace_back(Range{100 * rate.ours.low, 100 * rate.ours.high});
    }
  }
  table.notes = {plan.note, fmt::format("Here: at most {} iterations.", iterations)};
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
    series.push_back(std::move(printed));
  }
  return figures::rates_figure(
      rows, series,
      {.name = "solve-rates-figure",
       .quantity = "solved poses",
       .caption = fmt::format("Solved poses, with {} intervals. {}", percent(plan.level), plan.caption)});
}

}  // namespace

std::vector<RatesOfArm> solve_rates(const Reported& reported, const RatesPlan& plan) {
  const CsvTable printed = published::table(plan.paper, plan.table);
  std::vector<std::reference_wrapper<const JudgedStudy>> studies{reported.study};
  studies.insert(studies.end(), reported.companions.begin(), reported.companions.end());
  std::vector<RatesOfArm> arms;
  for (const JudgedStudy& study : studies) {
    if (study.solves.empty()) continue;
    const auto named = plan.rows.find(study.solve_data->robot);
    const std::string arm = named == plan.rows.end() ? study.solve_data->robot : named->second;
    const std::optional<std::size_t> row = row_of(printed, arm);
    if (!row) continue;
    RatesOfArm& rates =
        arms.emplace_back(RatesOfArm{.arm = arm, .iterations = most_iterations(study), .rates = {}, .study = &study});
    for (const auto& [solver, column] : plan.columns)
      rates.rates.push_back(rate_of(study, solver, printed.number(*row, column) / 100, plan));
  }
  return arms;
}

void add_rates(StudyPieces& pieces, const Reported& reported, const RatesPlan& plan) {
  const std::vector<RatesOfArm> arms = plan.level > 0 ? solve_rates(reported, plan) : std::vector<RatesOfArm>();
  if (arms.empty()) return;
  pieces.tables.push_back(rates_table(arms, plan));
  pieces.results = pieces.tables.back().name;
  pieces.figures.push_back(rates_figure(arms, plan));
}

}  // namespace ikbench::report
