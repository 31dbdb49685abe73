#include "analysis/beeson2015/solve_rates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "analysis/figures/rates_figure.hpp"
#include "analysis/inference/outcomes.hpp"
#include "results/published.hpp"

namespace ikbench::beeson2015 {

using namespace results;
using namespace inference;
using namespace report;
using namespace statistics;

namespace {

constexpr std::string_view kdl = "KDL", kdl_rr = "KDL-RR";
constexpr double level = 0.99;  // of our intervals

// Our arms, as the table calls them.
constexpr std::array<std::pair<std::string_view, std::string_view>, 5> table_arms{
    {{"abb_irb120", "ABB IRB120"},
     {"franka_panda", "Franka Emika Panda"},
     {"baxter_left", "Baxter arm"},
     {"kinova_jaco2", "Jaco2"},
     {"kuka_iiwa14", "KUKA LBR iiwa 14 R820"}}};

Cell percentage(double share) { return std::isfinite(share) ? Cell(100 * share) : Cell(); }

Range percentages(const Proportion& of) { return {100 * of.low, 100 * of.high}; }

Proportion rate_within(const StudyResults& study, std::string_view solver, int iterations) {
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

Rate rate_of(const JudgedStudy& study, std::string_view solver, double printed) {
  Rate rate{.printed = printed, .ours = solve_rate(study, solver, level)};
  const int most = most_iterations(study);
  for (std::size_t i = 0; i < budgets.size(); ++i) {
    if (budgets[i] <= most) rate.within[i] = rate_within(study, solver, budgets[i]);
  }
  for (int iterations = 1; iterations <= std::min(most, budgets.back()); ++iterations) {
    if (!agrees({.printed = printed, .ours = rate_within(study, solver, iterations)})) continue;
    if (rate.first == 0) rate.first = iterations;
    rate.last = iterations;
  }
  return rate;
}

}  // namespace

std::vector<ArmRates> solve_rates(const Reported& reported) {
  const CsvTable printed = published::table("beeson2015", "solve-rates");
  const auto share = [&](std::size_t row, std::string_view column) { return printed.number(row, column) / 100; };
  std::vector<std::reference_wrapper<const JudgedStudy>> studies{reported.study};
  studies.insert(studies.end(), reported.companions.begin(), reported.companions.end());

  std::vector<ArmRates> rates;
  for (const JudgedStudy& study : studies) {
    if (study.solves.empty()) continue;
    const auto arm = std::ranges::find(table_arms, study.gathered->robot, &decltype(table_arms)::value_type::first);
    if (arm == table_arms.end()) continue;
    for (std::size_t row = 0; row < printed.rows.size(); ++row) {
      if (printed.rows[row][printed.column("arm")] != arm->second) continue;
      ArmRates& one = rates.emplace_back();
      one.arm = arm->second;
      one.kdl = rate_of(study, kdl, share(row, "kdl_percent"));
      one.kdl_rr = rate_of(study, kdl_rr, share(row, "kdl_rr_percent"));
      one.iterations = most_iterations(study);
      one.trac_ik = share(row, "trac_ik_percent");
      const bool has_both = std::ranges::count(study.solvers, kdl) + std::ranges::count(study.solvers, kdl_rr) == 2;
      if (has_both) one.restarts = judge(study.evidence(Metric::solved), kdl_rr, kdl);
    }
  }
  return rates;
}

bool agrees(const Rate& rate) { return rate.ours.low <= rate.printed && rate.printed <= rate.ours.high; }

Table solve_rates_table(const std::vector<ArmRates>& arms) {
  Table table{.name = "solve-rates",
              .caption = "Solved poses [%], as printed and here, with 99 % intervals",
              .columns = {{"arm", Align::left},
                          {"KDL, printed"},
                          {"KDL, here"},
                          {"interval"},
                          {"KDL-RR, printed"},
                          {"KDL-RR, here"},
                          {"interval of KDL-RR"},
                          {"TRAC-IK, printed"}},
              .notes = {"Printed: as many iterations as fit into 5 ms on the authors' machine."}};
  int iterations = 0;
  for (const ArmRates& one : arms) {
    iterations = std::max(iterations, one.iterations);
    table.rows.push_back({one.arm, percentage(one.kdl.printed), percentage(one.kdl.ours.estimate),
                          percentages(one.kdl.ours), percentage(one.kdl_rr.printed),
                          percentage(one.kdl_rr.ours.estimate), percentages(one.kdl_rr.ours), percentage(one.trac_ik)});
  }
  table.notes.push_back(fmt::format("Here: at most {} iterations.", iterations));
  return table;
}

Table iterations_table(const std::vector<ArmRates>& arms) {
  Table table{
      .name = "solve-rates-iterations",
      .caption = "Solved poses [%], by iterations",
      .columns = {{"arm", Align::left}, {"solver", Align::left}, {"printed"}},
      .notes = {"Printed: as many iterations as fit into 5 ms on the authors' machine; how many is not known."}};
  for (const int iterations : budgets) table.columns.push_back({fmt::format("{} iterations", iterations)});
  table.columns.push_back({"as printed within", Align::left});
  for (const ArmRates& one : arms) {
    for (const auto& [solver, rate] : {std::pair(kdl, one.kdl), std::pair(kdl_rr, one.kdl_rr)}) {
      std::vector<Cell> row{one.arm, std::string(solver), percentage(rate.printed)};
      for (const Proportion& ours : rate.within) row.push_back(percentage(ours.estimate));
      row.emplace_back(rate.first == 0 ? std::string("none of these")
                                       : fmt::format("{} to {} iterations", rate.first, rate.last));
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

figures::Figure solve_rates_figure(const std::vector<ArmRates>& arms) {
  std::vector<std::string> rows;
  figures::RateSeries kdl_here{.name = "KDL", .colour = 1, .shares = {}},
      kdl_printed{.name = "KDL, printed", .colour = 1, .is_ring = true, .shares = {}},
      rr_here{.name = "KDL-RR", .colour = 2, .shares = {}},
      rr_printed{.name = "KDL-RR, printed", .colour = 2, .is_ring = true, .shares = {}};
  for (const ArmRates& one : arms) {
    rows.push_back(one.arm);
    kdl_here.shares.push_back(one.kdl.ours);
    kdl_printed.shares.push_back({.estimate = one.kdl.printed, .undefined = {}});
    rr_here.shares.push_back(one.kdl_rr.ours);
    rr_printed.shares.push_back({.estimate = one.kdl_rr.printed, .undefined = {}});
  }
  return figures::rates_figure(rows, {kdl_here, kdl_printed, rr_here, rr_printed},
                               {.name = "solve-rates-figure",
                                .quantity = "solved poses",
                                .caption = "Solved poses, with 99 % intervals. RR: with random restarts."});
}

}  // namespace ikbench::beeson2015
