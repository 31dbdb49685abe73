#include "analysis/arms/paper.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/figures/rates_figure.hpp"
#include "analysis/inference/outcomes.hpp"
#include "analysis/report/study_pieces.hpp"

namespace ikbench::arms {

using namespace inference;
using namespace report;

namespace {

constexpr double level = 0.95;  // of intervals

// By arm, then by solver.
struct Rates {
  std::vector<std::string> arms;
  std::vector<figures::RateSeries> solvers;
};

Rates rates(const Reported& reported) {
  Rates rates;
  for (const std::string& solver : reported.study.solvers) {
    rates.solvers.push_back({.name = solver, .colour = static_cast<int>(rates.solvers.size()) + 1, .shares = {}});
  }
  std::vector<std::reference_wrapper<const JudgedStudy>> studies{reported.study};
  studies.insert(studies.end(), reported.companions.begin(), reported.companions.end());
  for (const JudgedStudy& study : studies) {
    if (study.solves.empty()) continue;
    rates.arms.push_back(study.gathered->robot);
    for (figures::RateSeries& solver : rates.solvers) {
      solver.shares.push_back(solve_rate(study, solver.name, level));
    }
  }
  return rates;
}

Table rates_table(const Rates& rates) {
  Table table{.name = "arms",
              .caption = "Solved poses [%] by arm and solver, with 95 % intervals",
              .columns = {{"arm", Align::left}}};
  for (const figures::RateSeries& solver : rates.solvers) {
    table.columns.push_back({solver.name});
    table.columns.push_back({fmt::format("{}, interval", solver.name)});
  }
  for (std::size_t arm = 0; arm < rates.arms.size(); ++arm) {
    std::vector<Cell>& row = table.rows.emplace_back(std::vector<Cell>{rates.arms[arm]});
    for (const figures::RateSeries& solver : rates.solvers) {
      const statistics::Proportion& share = solver.shares[arm];
      row.emplace_back(100 * share.estimate);
      row.emplace_back(Range{100 * share.low, 100 * share.high});
    }
  }
  return table;
}

StudyPieces pieces(const Reported& reported) {
  StudyPieces all = study_pieces(reported.study);
  const Rates found = rates(reported);
  if (found.arms.empty()) return all;
  all.tables.push_back(rates_table(found));
  all.figures.push_back(figures::rates_figure(
      found.arms, found.solvers,
      {.name = "arms-figure",
       .quantity = "solved poses",
       .caption = "Solved poses, the same of an arm for all solvers, with 95 % intervals and one budget."}));
  all.results = "arms";
  return all;
}

}  // namespace

Paper paper() {
  Paper paper{.name = "arms",
              .in_short = "no paper, but seven solvers on random poses of every arm",
              .pieces = pieces,
              .sections = {.first = {{"All arms", "", {"arms-figure", "arms"}}}}};
  for (const char* study :
       {"arms", "arms-iiwa7", "arms-ur3e", "arms-ur5", "arms-ur5e", "arms-ur10e", "arms-panda", "arms-fr3", "arms-gen3",
        "arms-irb120", "arms-puma560", "arms-stanford", "arms-jaco2", "arms-baxter"}) {
    paper.studies.push_back({study, {"seed"}});
  }
  return paper;
}

}  // namespace ikbench::arms
