#include "analysis/report/limits_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "analysis/inference/design.hpp"
#include "analysis/inference/judge.hpp"
#include "analysis/inference/ranking.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/assessment_words.hpp"
#include "analysis/report/words.hpp"
#include "analysis/statistics/descriptive.hpp"

namespace ikbench::report {

using namespace results;
using namespace statistics;
using namespace inference;
using namespace fmt::literals;

namespace {

// Results of one solver in one study.
struct Side {
  std::string solver;
  Description error_cm;
  Description variation_deg;
  // Means over accepted answers. After a refused answer the arm stays, so its variation is 0.
  double accepted_error_cm = not_defined;
  double accepted_variation_deg = not_defined;
  std::vector<double> accepted_variation_of_runs;  // mean per run with an accepted answer
  SolverCounts counts;
  Placing error_placing = {};  // among the solvers of both studies; place 0 without a mean
  Placing variation_placing = {};
};

// The study that enforces the limits.
struct Enforced {
  std::vector<Side> sides;
  Evidence error, variation;
};

// A quantity that places solvers, and the evidence that tests places.
struct Measure {
  const char* name;
  Placing Side::*placing;
  Evidence Enforced::*tested;
};
constexpr Measure by_error{"error", &Side::error_placing, &Enforced::error};
constexpr Measure by_variation{"variation", &Side::variation_placing, &Enforced::variation};

bool has_solver(const StudyResults& study, const std::string& solver) {
  return std::ranges::find(study.solvers, solver) != study.solvers.end();
}

template <class Mean>
void place(std::vector<Side>& sides, Placing Side::*placing, Mean&& mean_of) {
  std::vector<RankedSolver> standings;
  for (const Side& side : sides) standings.push_back({side.solver, mean_of(side)});
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (std::isfinite(standings[i].mean)) sides[i].*placing = placing_of(standings[i], standings);
  }
}

std::vector<Side> sides_of(const StudyResults& study, const StudyResults& other) {
  const std::vector<Sample> errors = samples(study, Metric::position_error_cm);
  const std::vector<Sample> variations = samples(study, Metric::variation_deg);
  const std::vector<SolverCounts> all_counts = counts(study);
  std::vector<Side> sides;
  for (std::size_t i = 0; i < study.solvers.size(); ++i) {
    if (!has_solver(other, study.solvers[i])) continue;
    std::vector<double> accepted_errors, accepted_variations, means_of_runs;
    std::map<int, std::vector<double>> variations_of_run;
    for (const Solve& solve : solves_of(study, study.solvers[i])) {
      if (stays(solve.status)) continue;
      accepted_errors.push_back(solve.position_error_cm);
      accepted_variations.push_back(solve.variation_deg);
      variations_of_run[solve.run].push_back(solve.variation_deg);
    }
    for (const auto& [run, values] : variations_of_run) means_of_runs.push_back(mean(values));
    sides.push_back({.solver = study.solvers[i],
                     .error_cm = statistics::describe(errors[i].values),
                     .variation_deg = statistics::describe(variations[i].values),
                     .accepted_error_cm = statistics::describe(accepted_errors).mean,
                     .accepted_variation_deg = statistics::describe(accepted_variations).mean,
                     .accepted_variation_of_runs = means_of_runs,
                     .counts = all_counts[i]});
  }
  place(sides, &Side::error_placing, [](const Side& of) { return of.error_cm.mean; });
  place(sides, &Side::variation_placing, [](const Side& of) { return of.accepted_variation_deg; });
  return sides;
}

Enforced enforced_of(const JudgedStudy& study, const StudyResults& other) {
  Enforced result{.sides = sides_of(study, other), .error = study.evidence(Metric::position_error_cm)};
  Observations accepted{.name = "accepted-variation", .quantity = quantity(Metric::variation_deg), .unit = "deg"};
  if (study.plan.unit == Unit::point) accepted.flaws = {{DoubtKind::points_as_observations}};
  for (const Side& side : result.sides) {
    accepted.groups.push_back({.name = side.solver, .values = side.accepted_variation_of_runs});
  }
  AnalysisPlan plan = feasible(study.plan, accepted);
  if (!has_solver(other, plan.control)) plan.control.clear();
  result.variation = tested(accepted, plan);
  return result;
}

const Side& side_of(const std::vector<Side>& sides, const std::string& solver) {
  return *std::ranges::find(sides, solver, &Side::solver);
}

// "First by error: IK-BA; with enforced limits DE, which is undecided (Games-Howell test, p = 0.766)": names who ranks
// first alone in each study, and the test of the two.
std::string first_words(const std::vector<Side>& free, const Enforced& enforced, const Measure& measure) {
  const auto first_of = [&](const std::vector<Side>& sides) {
    const auto is_first = [&](const Side& side) {
      const Placing& of = side.*measure.placing;
      return of.place == 1 && !of.shared;
    };
    const auto first = std::ranges::find_if(sides, is_first);
    return first == sides.end() ? std::string("none") : first->solver;
  };
  const std::string before = first_of(free), after = first_of(enforced.sides);
  std::string test;
  if (before != after && before != "none" && after != "none") {
    const Finding found = judge(enforced.*measure.tested, after, before);
    if (std::isfinite(found.p)) {
      test = fmt::format(words::limits_test, "other"_a = before, "relation"_a = name_of(found.relation),
                         "test"_a = pair_test_words(enforced.*measure.tested), "p"_a = p_words(found.p));
    }
  }
  return fmt::format(words::limits_first, "measure"_a = measure.name, "before"_a = before, "after"_a = after,
                     "test"_a = test);
}

Table table_of(const JudgedStudy& free, const JudgedStudy& enforced) {
  Table table{.name = "limits",
              .caption = "Results with enforced joint limits",
              .columns = {"algorithm", "study", "limits", "observations", "mean_position_error_cm",
                          "median_position_error_cm", "mean_accepted_error_cm", "mean_variation_deg",
                          "mean_accepted_variation_deg", "rank_error", "rank_variation", "outside_limits"}};
  std::set<Status> statuses;
  for (const StudyResults* study :
       {static_cast<const StudyResults*>(&free), static_cast<const StudyResults*>(&enforced)}) {
    for (const Status status : shown_statuses(*study)) statuses.insert(status);
  }
  for (const Status status : statuses) table.columns.push_back(std::string(name_of(status)));
  const std::vector<Side> before = sides_of(free, enforced);
  const Enforced after = enforced_of(enforced, free);
  const auto add_row = [&](const Side& side, const StudyResults& study, const char* limits) {
    const auto rank = [](Placing of) { return of.place == 0 ? Cell(not_defined) : Cell(std::int64_t{of.place}); };
    std::vector<Cell> row{side.solver,
                          study.name,
                          std::string(limits),
                          std::int64_t{side.error_cm.n},
                          side.error_cm.mean,
                          side.error_cm.median,
                          side.accepted_error_cm,
                          side.variation_deg.mean,
                          side.accepted_variation_deg,
                          rank(side.error_placing),
                          rank(side.variation_placing),
                          std::int64_t{side.counts.outside_limits}};
    for (const Status status : statuses) row.emplace_back(std::int64_t{side.counts.of(status)});
    table.rows.push_back(std::move(row));
  };
  for (const Side& side : before) {
    add_row(side, free, "recorded");
    add_row(side_of(after.sides, side.solver), enforced, "enforced");
  }
  for (const Measure& measure : {by_error, by_variation}) {
    table.notes.push_back(first_words(before, after, measure));
  }
  table.notes.emplace_back(words::limits);
  table.notes.emplace_back(words::limits_refused);
  for (const StudyResults* const study : {&free, &enforced}) {
    for (const std::string& note : status_notes(*study)) table.notes.push_back(study->name + ": " + note);
  }
  return table;
}

}  // namespace

std::optional<Table> limits_table(const JudgedStudies& studies) {
  if (studies.empty()) return std::nullopt;
  const JudgedStudy& reported = studies.front();
  for (const JudgedStudy& other : studies) {
    const bool in_common =
        std::ranges::any_of(reported.solvers, [&](const std::string& solver) { return has_solver(other, solver); });
    if (other.facts.enforces_limits == reported.facts.enforces_limits || !in_common) continue;
    return other.facts.enforces_limits ? table_of(reported, other) : table_of(other, reported);
  }
  return std::nullopt;
}

}  // namespace ikbench::report
