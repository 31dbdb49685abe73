#include "analysis/inference/clusters.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "analysis/figures/convergence_figures.hpp"
#include "analysis/inference/costs.hpp"
#include "analysis/inference/make_study.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::statistics;
using namespace ikbench::inference;

namespace {

const char* const drawn_targets =
    R"({"stop": {"tolerance_cm": 0.1, "evaluations": 1000}, "path": {"kind": "random"}, "start": "initial"})";
const char* const fixed_targets =
    R"({"stop": {"tolerance_cm": 0.1, "evaluations": 1000}, "path": {"kind": "helix"}, "start": "initial"})";
const char* const chained = R"({"stop": {"tolerance_cm": 0.1}, "path": {"kind": "helix"}, "start": "previous"})";

struct Spent {
  std::int64_t evaluations;
  bool reached = true;
};

// Solver A, B, ...: by run and point. Every point has its own target; with `drawn_targets` every run too.
StudyResults clustered_study(const std::vector<std::vector<std::vector<Spent>>>& solvers, const char* definition) {
  std::vector<SolveRecord> solves;
  for (std::size_t s = 0; s < solvers.size(); ++s) {
    for (std::size_t run = 0; run < solvers[s].size(); ++run) {
      for (std::size_t point = 0; point < solvers[s][run].size(); ++point) {
        const auto& [evaluations, reached] = solvers[s][run][point];
        SolveRecord solve;
        solve.solver = std::string(1, static_cast<char>('A' + s));
        solve.run = static_cast<int>(run) + 1;
        solve.point = static_cast<int>(point) + 1;
        solve.evaluations = evaluations;
        solve.seconds = solve.cpu_seconds = 1e-6 * static_cast<double>(evaluations);
        solve.position_error_cm = reached ? 0.05 : 5;
        solve.status = reached ? Status::ok : Status::tolerance_missed;
        solve.target_position_m = {0.1 * static_cast<double>(point),
                                   definition == drawn_targets ? 0.1 * solve.run : 0.0, 0};
        solves.push_back(std::move(solve));
      }
    }
  }
  StudyResults study = make_study("made up", std::move(solves));
  study.facts = facts_of(definition);
  return study;
}

using Runs = std::vector<std::vector<Spent>>;

// Twenty runs of one point.
Runs twenty(const std::function<Spent(int)>& spent) {
  Runs runs;
  for (int run = 0; run < 20; ++run) runs.push_back({spent(run)});
  return runs;
}

double width(const Estimate& interval) { return interval.high - interval.low; }

// Evenly from -1 to 1; std::mt19937_64's sequence is fixed by the C++ standard.
double symmetric(std::mt19937_64& engine) { return 0x1p-52 * static_cast<double>(engine() >> 11) - 1; }

Spent about(double evaluations) { return {std::llround(evaluations)}; }

constexpr int repetitions = 200;
// Three binomial standard errors below 0.95.
const double least_coverage = 0.95 - 3 * std::sqrt(0.95 * 0.05 / repetitions);

// The share of intervals of the expected running time that contain the true one.
double coverage(double truth, const char* definition, const std::function<Runs(std::mt19937_64&)>& sample) {
  std::mt19937_64 engine(3);
  int covered = 0;
  for (int i = 0; i < repetitions; ++i) {
    const StudyResults study = clustered_study({sample(engine)}, definition);
    const Clusters clusters(study);
    const Estimate interval = costs_of(study, Metric::evaluations, clusters)[0].expected(clusters);
    covered += interval.low <= truth && truth <= interval.high ? 1 : 0;
  }
  return static_cast<double>(covered) / repetitions;
}

}  // namespace

TEST_CASE("chained solves are drawn by run, others by target", "[clusters]") {
  const Runs runs(12, {{100}, {200}});
  const StudyResults by_run = clustered_study({runs, runs}, chained),
                     by_target = clustered_study({runs, runs}, drawn_targets);
  const Clusters of_runs(by_run), of_targets(by_target);
  CHECK(of_runs.noun() == "runs");
  CHECK(of_runs.drawn_at_once() == 12);
  CHECK(of_runs.of(by_run.solves[0]) == of_runs.of(by_run.solves[1]));   // points of a run
  CHECK(of_runs.of(by_run.solves[0]) == of_runs.of(by_run.solves[24]));  // the same run of the other solver
  CHECK(of_targets.noun() == "targets");
  CHECK(of_targets.drawn_at_once() == 24);
  CHECK(of_targets.of(by_target.solves[0]) != of_targets.of(by_target.solves[1]));
  CHECK(of_targets.of(by_target.solves[0]) == of_targets.of(by_target.solves[24]));
  CHECK(of_runs.replicates().size() == 1000);
}

TEST_CASE("fewer than ten clusters have no intervals, and more than a thousand are drawn in groups", "[clusters]") {
  const StudyResults few = clustered_study({Runs(9, {{100}})}, chained);
  const Clusters of_few(few);
  CHECK(of_few.undefined() == "9 runs, and intervals need 10");
  CHECK(of_few.replicates().empty());
  CHECK(std::isnan(of_few.estimate(0, {}).low));
  const StudyResults many = clustered_study({Runs(1500, {{100}})}, drawn_targets);
  const Clusters of_many(many);
  CHECK(of_many.drawn_at_once() == 1000);
  CHECK(of_many.of(many.solves[1200]) == 200);
}

TEST_CASE("an interval by targets covers where the same targets are solved in every run", "[clusters][simulation]") {
  // A target is as hard in every run, and a run has no part in it: all its solves start anew.
  const auto sample = [](std::mt19937_64& engine) {
    Runs runs(4);
    for (int target = 0; target < 20; ++target) {
      const double hard = 500 * symmetric(engine);
      for (auto& run : runs) run.push_back(about(1000 + hard + 300 * symmetric(engine)));
    }
    return runs;
  };
  CHECK(coverage(1000, fixed_targets, sample) > least_coverage);
}

TEST_CASE("an interval by runs covers where a run chains a fixed path", "[clusters][simulation]") {
  // The path stays, so that its hard points are no chance; what a run starts with goes through all its points.
  const auto sample = [](std::mt19937_64& engine) {
    Runs runs(20);
    for (auto& run : runs) {
      const double own = 500 * symmetric(engine);
      for (const double hard : {-600, -200, 200, 600})
        run.push_back(about(1000 + hard + own + 100 * symmetric(engine)));
    }
    return runs;
  };
  CHECK(coverage(1000, chained, sample) > least_coverage);
}

TEST_CASE("an interval of expected running time covers but where no failure is in the sample",
          "[clusters][simulation]") {
  // Ten targets; a solve spends 100 evaluations and fails, after 1000, with probability 0.1: (90 + 100) / 0.9 = 211.
  // Each solved once, 0.9^10 = 0.35 of the samples hold no failure, and no replicate can then have one.
  int without_failure = 0;
  const auto solves = [&](std::size_t times) {
    return [&, times](std::mt19937_64& engine) {
      Runs runs(times, std::vector<Spent>(10, Spent{100}));
      bool fails = false;
      for (auto& run : runs) {
        for (Spent& solve : run) {
          if (symmetric(engine) < 0.8) continue;
          solve = {1000, false};
          fails = true;
        }
      }
      without_failure += fails ? 0 : 1;
      return runs;
    };
  };
  CHECK(coverage(190 / 0.9, fixed_targets, solves(10)) > least_coverage);
  without_failure = 0;
  const double of_one = coverage(190 / 0.9, fixed_targets, solves(1));
  CHECK(of_one == Approx(1 - static_cast<double>(without_failure) / repetitions));
  CHECK(without_failure > 40);
}

TEST_CASE("where all runs are alike the band is the curve", "[clusters]") {
  const StudyResults study = clustered_study({Runs(15, {{100}, {300}, {700}})}, chained);
  const Clusters clusters(study);
  ClusteredValues values{.values = {}, .clusters = clusters.of(solves_by_solver(study)[0])};
  for (const Solve& solve : study.solves) values.values.push_back(static_cast<double>(solve.evaluations));
  const std::vector<Share> shares = banded_shares(values, clusters);
  REQUIRE(shares.size() == 3);
  for (const Share& share : shares) {
    CHECK(share.low == Approx(share.share));
    CHECK(share.high == Approx(share.share));
  }
}

TEST_CASE("a band is wider where the points of a run depend on each other", "[clusters]") {
  // Every other run reaches all of its ten points: one run is one trial, not ten.
  Runs runs;
  for (int run = 0; run < 20; ++run) runs.emplace_back(10, Spent{run % 2 == 0 ? 100 : 900});
  const auto width_with = [&](const char* definition) {
    const StudyResults study = clustered_study({runs}, definition);
    const Clusters clusters(study);
    ClusteredValues values{.values = {}, .clusters = clusters.of(solves_by_solver(study)[0])};
    for (const Solve& solve : study.solves) values.values.push_back(static_cast<double>(solve.evaluations));
    const Share share = banded_shares(values, clusters).front();
    CHECK(share.share == 0.5);
    return share.high - share.low;
  };
  // By hand: 2 (2.093 sqrt(20 / 19)) sqrt(0.25 / 20) = 0.480 and 2 (1.972) sqrt(0.25 / 200) = 0.139.
  CHECK(width_with(chained) == Approx(0.48).margin(0.06));
  CHECK(width_with(drawn_targets) == Approx(0.139).margin(0.02));
}

TEST_CASE("of two that share their targets the ratio is known better than either mean", "[clusters]") {
  // B takes one and a half times as long as A at every target, and targets differ much.
  const Runs a = twenty([](int run) { return Spent{100 * (run + 1)}; });
  const Runs b = twenty([](int run) { return Spent{150 * (run + 1)}; });
  const StudyResults study = clustered_study({a, b}, drawn_targets);
  const Clusters clusters(study);
  const std::vector<SolverCost> costs = costs_of(study, Metric::evaluations, clusters);
  CHECK(costs[0].time.expected() == Approx(1050));
  CHECK(width(costs[0].expected(clusters)) > 400);
  const std::vector<Finding> pairs = compare_costs(study, Metric::evaluations, clusters);
  REQUIRE(pairs.size() == 1);
  CHECK(pairs[0].relation == Relation::better);
  CHECK(pairs[0].is_ratio);
  CHECK(pairs[0].estimate.value == Approx(1 / 1.5));
  CHECK(pairs[0].estimate.low == Approx(1 / 1.5));
  CHECK(pairs[0].estimate.high == Approx(1 / 1.5));
  CHECK(pairs[0].why.empty());
  const Finding turned = finding_of(pairs, 1, 0).value();
  CHECK(turned.relation == Relation::worse);
  CHECK(turned.estimate.value == Approx(1.5));
  CHECK(!finding_of(pairs, 0, 2));
}

TEST_CASE("running times of two that are alike are undecided", "[clusters]") {
  const Runs a = twenty([](int run) { return Spent{100 * (run % 5 + 1)}; });
  const Runs b = twenty([](int run) { return Spent{100 * ((run + 2) % 5 + 1)}; });
  const StudyResults study = clustered_study({a, b}, drawn_targets);
  const Finding pair = compare_costs(study, Metric::evaluations, Clusters(study)).front();
  CHECK(pair.relation == Relation::undecided);
  CHECK(pair.estimate.low < 1);
  CHECK(pair.estimate.high > 1);
}

TEST_CASE("who solves nothing costs infinitely much, and is worse than who surely solves something", "[clusters]") {
  // B tries long, C gives up at once, and D costs nothing: it cannot even be started. None of them solves anything.
  const auto study_with = [](int solved_by_a) {
    const Runs a = twenty([&](int run) { return Spent{100 + run, run < solved_by_a}; });
    const auto never = [](std::int64_t evaluations) {
      return twenty([evaluations](int) { return Spent{evaluations, false}; });
    };
    return clustered_study({a, never(1000), never(1), never(0)}, drawn_targets);
  };
  const auto pairs_of = [](const StudyResults& study) {
    return compare_costs(study, Metric::evaluations, Clusters(study));
  };
  for (const int solved : {20, 12, 7}) {
    const std::vector<Finding> pairs = pairs_of(study_with(solved));
    for (std::size_t other = 1; other < 4; ++other) {
      CAPTURE(solved, other);
      const Finding pair = finding_of(pairs, 0, other).value();
      CHECK(pair.relation == Relation::better);
      CHECK(pair.estimate.value == 0);
      CHECK(std::isnan(pair.estimate.low));
      CHECK(pair.why == "shares solved decide");
    }
    const Finding neither = finding_of(pairs, 1, 2).value();
    CHECK(neither.relation == Relation::undecided);
    CHECK(neither.why == "neither solves anything");
  }
  // Fisher's exact test of 2 of 20 and 0 of 20: p = 0.49.
  for (const Finding& pair : pairs_of(study_with(2))) CHECK(pair.relation == Relation::undecided);
  const StudyResults study = study_with(20);
  const Clusters clusters(study);
  const SolverCost of_b = costs_of(study, Metric::evaluations, clusters)[1];
  CHECK(std::ranges::all_of(of_b.replicates, [](const RunningTime& sample) { return sample.expected() == censored; }));
}

TEST_CASE("a third solver that gives up at once changes no verdict on the cost of two others", "[clusters]") {
  const Runs a = twenty([](int run) { return Spent{100 + run}; });
  const Runs b = twenty([](int run) { return Spent{150 + run}; });
  const Runs at_once = twenty([](int) { return Spent{1, false}; });
  const StudyResults study = clustered_study({a, b, at_once}, drawn_targets);
  const std::vector<Finding> pairs = compare_costs(study, Metric::evaluations, Clusters(study));
  CHECK(finding_of(pairs, 0, 1).value().relation == Relation::better);
}

TEST_CASE("where some samples have no success, the shares are weighed by what each spends", "[clusters]") {
  // A solves 4 of 20 at 100 each, 500 a success. B solves all at 2000: a better share, and four times the cost.
  const Runs a = twenty([](int run) { return Spent{100, run % 5 == 0}; });
  const Runs b = twenty([](int run) { return Spent{2000 + run}; });
  const StudyResults study = clustered_study({a, b}, drawn_targets);
  const Finding pair = compare_costs(study, Metric::evaluations, Clusters(study)).front();
  CHECK(pair.estimate.value == Approx(500 / 2009.5));
  CHECK(std::isnan(pair.estimate.low));
  CHECK(pair.why == "shares solved decide");
  CHECK(pair.relation != Relation::worse);
}

TEST_CASE("of two that cost the same in another way few are called different", "[clusters][simulation]") {
  // A solves a quarter at 50 a solve, B half at 100: 200 a success. In three of four samples A has no ratio.
  std::mt19937_64 engine(28);
  const auto sample = [&](double share, double most) {
    return twenty([&](int) {
      const bool is_solved = (1 + symmetric(engine)) / 2 < share;
      return Spent{std::llround(most * (1 + symmetric(engine)) / 2), is_solved};
    });
  };
  int different = 0;
  for (int i = 0; i < repetitions; ++i) {
    const Runs a = sample(0.25, 100), b = sample(0.5, 200);
    const StudyResults study = clustered_study({a, b}, drawn_targets);
    const Finding pair = compare_costs(study, Metric::evaluations, Clusters(study)).front();
    different += is_difference(pair.relation) ? 1 : 0;
  }
  CHECK(static_cast<double>(different) / repetitions < 1 - least_coverage);
}

TEST_CASE("a finding on costs never contradicts its estimate, and the other order says the opposite",
          "[clusters][property]") {
  std::mt19937_64 engine(28);
  const auto below = [&](int n) { return static_cast<int>(engine() % static_cast<std::uint64_t>(n)); };
  int decided = 0, without_ratio = 0, decided_by_budget = 0;
  for (int i = 0; i < 100; ++i) {
    const char* const definition =
        std::array{drawn_targets, fixed_targets, chained}[static_cast<std::size_t>(below(3))];
    const int runs = 3 + below(20), points = 1 + below(3), solvers = 2 + below(3);
    std::vector<Runs> all;
    for (int s = 0; s < solvers; ++s) {
      const int level = 1 + below(500), percent_solved = 10 * below(11);
      Runs& own = all.emplace_back(static_cast<std::size_t>(runs));
      for (auto& run : own) {
        for (int point = 0; point < points; ++point) run.push_back({below(2 * level), below(100) < percent_solved});
      }
    }
    const StudyResults study = clustered_study(all, definition);
    std::ranges::reverse(all);
    StudyResults turned = clustered_study(all, definition);
    const auto turned_place = [&](std::size_t solver) { return static_cast<std::size_t>(solvers) - 1 - solver; };
    const Clusters clusters(study), of_turned(turned);
    std::vector<Finding> findings = compare_costs(study, Metric::evaluations, clusters);
    const std::vector<Finding> other_way = compare_costs(turned, Metric::evaluations, of_turned);
    for (const Finding& finding : findings) {
      CAPTURE(i, finding.first, finding.second, finding.estimate.value);
      if (finding.relation == Relation::better) CHECK(finding.estimate.value < 1);
      if (finding.relation == Relation::worse) CHECK(finding.estimate.value > 1);
      const Finding swapped = finding_of(other_way, turned_place(finding.second), turned_place(finding.first)).value();
      CHECK(swapped.relation == reversed(finding.relation));
      if (std::isfinite(finding.estimate.low)) CHECK(swapped.estimate.low == Approx(1 / finding.estimate.high));
      CHECK(reversed(reversed(finding)).relation == finding.relation);
      decided += is_difference(finding.relation) ? 1 : 0;
      without_ratio += std::isnan(finding.estimate.low) ? 1 : 0;
    }
    const std::optional<Anytime> shares = anytime(study, clusters), shares_other_way = anytime(turned, of_turned);
    REQUIRE(shares.has_value() == shares_other_way.has_value());
    if (!shares) continue;
    for (std::size_t k = 0; k < budget_parts.size(); ++k) {
      for (std::size_t s = 0; s < shares->standings[k].size(); ++s) {
        const AtBudget& here = shares->standings[k][s];
        const AtBudget& there = shares_other_way->standings[k][shares->standings[k].size() - 1 - s];
        decided_by_budget += is_difference(here.relation) ? 1 : 0;
        if (here.relation == Relation::better) CHECK(there.relation == Relation::better);
        if (here.relation == Relation::worse) CHECK(there.relation != Relation::better);
        if (here.relation == Relation::worse) CHECK(here.leader->estimate.value > 0);
      }
    }
  }
  CHECK(decided > 50);
  CHECK(without_ratio > 50);
  CHECK(decided_by_budget > 50);
}

TEST_CASE("of more than twenty solvers the best in cost is who solves for the least, not who solves nothing",
          "[clusters]") {
  std::vector<Runs> solvers;
  for (int s = 0; s < 20; ++s) solvers.push_back(twenty([s](int run) { return Spent{200 - 5 * s + run}; }));
  solvers.push_back(twenty([](int) { return Spent{1, false}; }));
  StudyResults study = clustered_study(solvers, drawn_targets);
  study.solvers.emplace_back("without solves");
  const std::vector<Finding> pairs = compare_costs(study, Metric::evaluations, Clusters(study));
  CHECK(pairs.size() == 21);
  for (const Finding& pair : pairs) {
    CAPTURE(pair.first, pair.second);
    CHECK((pair.first == 19 || pair.second == 19));  // the twentieth
    if (pair.second == 21) {
      CHECK(pair.relation == Relation::undefined);
      CHECK(pair.why == "there are no trials");
    } else {
      CHECK(pair.relation == (pair.first == 19 ? Relation::better : Relation::worse));
    }
  }
}

TEST_CASE("who is ahead depends on the budget", "[anytime]") {
  // Budget 1000. A: all at 80 evaluations or, every tenth, never. B: all at 250 to 290.
  const Runs a = twenty([](int run) { return run % 10 == 9 ? Spent{1000, false} : Spent{80}; });
  const Runs b = twenty([](int run) { return Spent{250 + 2 * run}; });
  const StudyResults study = clustered_study({a, b}, drawn_targets);
  const std::optional<Anytime> found = anytime(study, Clusters(study));
  REQUIRE(found);
  CHECK(found->budget == 1000);
  CHECK(found->is_of_study);
  const auto at = [&](std::size_t budget, std::size_t solver) { return found->standings[budget][solver]; };
  CHECK(at(0, 0).share.value == 0);  // 10 evaluations
  CHECK(at(0, 0).relation == Relation::undecided);
  CHECK(at(2, 0).share.value == Approx(0.9));  // 100
  CHECK(at(2, 0).relation == Relation::better);
  CHECK(at(2, 1).relation == Relation::worse);
  CHECK(at(2, 1).leader->estimate.value == Approx(0.9));
  CHECK(at(2, 1).leader->estimate.low > 0.5);
  CHECK(at(2, 0).share.low < 0.8);
  CHECK(at(3, 0).share.value == Approx(0.9));  // 300: 2 of 20 more, and nothing is shown
  CHECK(at(3, 1).share.value == 1);
  CHECK(at(3, 0).leader->estimate.value == Approx(0.1));
  CHECK(at(3, 0).relation == Relation::undecided);
  CHECK(at(3, 0).leader->estimate.low < 0);
}

TEST_CASE("whether anybody is ahead does not depend on the order of the others", "[anytime]") {
  const Runs all = twenty([](int) { return Spent{80}; });
  Runs single = all;  // most samples have no solve of it
  single.resize(1);
  for (const auto& solvers : {std::vector{all, all, single}, std::vector{all, single, all}}) {
    const StudyResults study = clustered_study(solvers, drawn_targets);
    const std::optional<Anytime> found = anytime(study, Clusters(study));
    REQUIRE(found);
    CHECK(found->standings[2][0].relation == Relation::undefined);
  }
}

TEST_CASE("runs that are copies of one show no difference, in cost and at no budget", "[clusters][anytime]") {
  const Runs a(12, {{100}, {100}}), b(12, {{900}, {900}});
  StudyResults study = clustered_study({a, b}, chained);
  for (Solve& solve : study.solves.to_change()) solve.answer = 7;  // the same bits in every run
  const Clusters clusters(study);
  const Finding pair = compare_costs(study, Metric::evaluations, clusters).front();
  CHECK(pair.relation == Relation::undecided);
  CHECK(pair.why == "all runs of each are copies of one");
  const std::optional<Anytime> found = anytime(study, clusters);
  REQUIRE(found);
  for (const auto& standings : found->standings) {
    for (const AtBudget& standing : standings) CHECK(standing.relation == Relation::undecided);
  }
}

TEST_CASE("without a tolerance traces say who is ahead, and without traces nobody does", "[anytime]") {
  Runs runs(12, {{1000, false}});
  StudyResults study = clustered_study({runs, runs}, R"({"path": {"kind": "random"}, "start": "initial"})");
  for (Solve& solve : study.solves.to_change()) solve.iterations = 10;
  const Clusters clusters(study);
  CHECK(!anytime(study, clusters));
  std::array<RareData, 2> traces{RareData{.trace_cm = std::vector<double>(10, 5)},
                                 RareData{.trace_cm = std::vector<double>(10, 20)}};
  std::fill(traces[1].trace_cm.begin() + 2, traces[1].trace_cm.end(), 5);
  for (Solve& solve : study.solves.to_change()) solve.rare = &traces[solve.solver];
  const std::optional<Anytime> found = anytime(study, clusters);
  REQUIRE(found);
  CHECK(!found->is_of_study);
  CHECK(found->standings[2][0].relation == Relation::better);  // 100 evaluations: the first of ten iterations
  CHECK(found->standings[2][1].share.value == 0);
  CHECK(found->standings[3][0].relation == Relation::undecided);  // 300
  CHECK(found->standings[3][0].share.value == found->standings[3][1].share.value);
  const StudyResults alone = clustered_study({runs}, drawn_targets);
  CHECK(!anytime(alone, Clusters(alone)));
}

TEST_CASE("figures of enough runs have bands, of few they say why not", "[clusters]") {
  const auto data_and_caption = [](std::size_t runs) {
    std::vector<std::vector<std::vector<Spent>>> solvers;
    for (const int more : {0, 50}) {
      Runs of_solver;
      for (std::size_t run = 0; run < runs; ++run) of_solver.push_back({{100 + 7 * static_cast<int>(run) + more}});
      solvers.push_back(of_solver);
    }
    const std::vector<figures::Figure> drawn = figures::convergence_figures(clustered_study(solvers, drawn_targets));
    const auto found = std::ranges::find(drawn, "statistics-solved-evaluations", &figures::Figure::name);
    REQUIRE(found != drawn.end());
    return found->plot + found->data + found->caption;
  };
  const std::string with = data_and_caption(12), without = data_and_caption(9);
  CHECK(with.find("filledcurves") != std::string::npos);
  CHECK(with.find("1000 bootstrap samples of the targets") != std::string::npos);
  CHECK(without.find("filledcurves") == std::string::npos);
  CHECK(without.find("9 targets, and intervals need 10") != std::string::npos);
}
