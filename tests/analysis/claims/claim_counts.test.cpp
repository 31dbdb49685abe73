#include "analysis/claims/claim_counts.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <utility>

#include "analysis/statistics/multiple_comparisons.hpp"
#include "analysis/statistics/studentized_range.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::claims;
using namespace ikbench::inference;
using namespace ikbench::results;
using namespace ikbench::statistics;

namespace {

const AnalysisPlan usual_plan;

// "A is best", or better than a rival.
ClaimEntry claim_of_a(const std::string& rival = "") {
  return {.id = "best",
          .sentence = "A is best",
          .solver = "A",
          .against = rival,
          .metrics = {Metric::position_error_cm},
          .universes = {Estimand::mean}};
}

std::vector<double> runs_around(double centre, std::mt19937_64& engine) {
  std::vector<double> values;
  for (int run = 0; run < 6; ++run) {
    const double uniform = static_cast<double>(engine() >> 11) / 9007199254740992.0;  // 2^53
    values.push_back(centre * (0.6 + 0.8 * uniform));
  }
  return values;
}

// Two dimensions of the study, of which the second has a choice with the first one's default only; A has two choices, B
// two times two, C one; two seeds.
Multiverse small_multiverse() {
  const auto alternative = [](const std::string& set) { return Multiverse::Alternative{set, "it is " + set}; };
  Multiverse multiverse{.dimensions = {{"x", "2.1", "", {alternative("x=0"), alternative("x=1"), alternative("x=2")}},
                                       {"y", "2.1", "", {alternative("y=0"), alternative("y=1")}},
                                       {"A.k", "2.2", "A", {alternative("A.k=0"), alternative("A.k=1")}},
                                       {"B.k", "2.3", "B", {alternative("B.k=0"), alternative("B.k=1")}},
                                       {"B.l", "2.3", "B", {alternative("B.l=0"), alternative("B.l=1")}}},
                        .solvers = {"A", "B", "C"},
                        .studies = {}};
  std::mt19937_64 engine(7);
  const auto own = [&](std::vector<Multiverse::Choice> chosen, double centre) {
    Multiverse::ChosenSolver one{.chosen = std::move(chosen), .error_cm = {}, .variation_deg = {}};
    for (int seed = 0; seed < 2; ++seed) {
      one.error_cm.push_back(runs_around(centre, engine));
      one.variation_deg.push_back(runs_around(10 * centre, engine));
    }
    return one;
  };
  const std::vector<std::vector<Multiverse::Choice>> studies{{{0, 0}, {1, 0}}, {{0, 0}, {1, 1}}, {{0, 1}}, {{0, 2}}};
  for (std::size_t g = 0; g < studies.size(); ++g) {
    Multiverse::OfStudy study{
        .chosen = studies[g], .weight = g < 2 ? 1.0 / 6 : 1.0 / 3, .out_of_reach = 0, .solvers = {}};
    const double shift = 0.3 * static_cast<double>(g);
    study.solvers.push_back({own({{2, 0}}, 0.6 + shift), own({{2, 1}}, 1.4)});
    study.solvers.push_back({});
    for (std::size_t k = 0; k < 2; ++k) {
      for (std::size_t l = 0; l < 2; ++l) {
        study.solvers[1].push_back(
            own({{3, k}, {4, l}}, 1 + 0.4 * static_cast<double>(k) - 0.5 * static_cast<double>(l) * shift));
      }
    }
    study.solvers.push_back({own({}, 1.2)});
    multiverse.studies.push_back(std::move(study));
  }
  return multiverse;
}

// Any two to eight printed numbers are explained by each choice.
Fit some_fit(const Multiverse& multiverse) {
  std::mt19937_64 engine(11);
  Fit fit{.least = 16};
  for (const Multiverse::OfStudy& study : multiverse.studies) {
    auto& of_study = fit.explained.emplace_back();
    for (const auto& of_solver : study.solvers) {
      auto& explained = of_study.emplace_back();
      for (std::size_t a = 0; a < of_solver.size(); ++a)
        explained.emplace_back((1ull << (2 + (engine() >> 11) % 7)) - 1);
    }
  }
  return fit;
}

using ByAlternative = std::map<std::pair<std::size_t, std::size_t>, UniverseCounts>;

// Universe by universe, each judged by Games and Howell's test of all pairs.
ByAlternative listed(const Multiverse& multiverse, const std::vector<std::string>& own, const std::string& rival,
                     const Fit& fit, UniverseCounts& all, UniverseCounts& fitting) {
  ByAlternative counts;
  const StudentizedRange range(3);
  for (std::size_t g = 0; g < multiverse.studies.size(); ++g) {
    const Multiverse::OfStudy& study = multiverse.studies[g];
    const auto explains = [&](std::size_t s, const Multiverse::ChosenSolver& of) {
      return fit.explained[g][s][static_cast<std::size_t>(&of - study.solvers[s].data())].count();
    };
    for (const Multiverse::ChosenSolver& a : study.solvers[0]) {
      for (const Multiverse::ChosenSolver& b : study.solvers[1]) {
        for (const Multiverse::ChosenSolver& c : study.solvers[2]) {
          for (std::size_t seed = 0; seed < 2; ++seed) {
            const std::vector<GroupSummary> groups{summarise(a.error_cm[seed]), summarise(b.error_cm[seed]),
                                                   summarise(c.error_cm[seed])};
            int better = 0, worse = 0, rivals = 0;
            for (const MeanDifference& pair : tamhane(groups, 1 - usual_plan.significance)) {
              const std::string &first = multiverse.solvers[pair.first], &second = multiverse.solvers[pair.second];
              if (std::ranges::count(own, first) == 0 || std::ranges::count(own, second) > 0) continue;
              if (!rival.empty() && second != rival) continue;
              ++rivals;
              if (range.upper_tail(pair.q, pair.df) < usual_plan.significance)
                ++(pair.difference.value < 0 ? better : worse);
            }
            const double weight = study.weight / (2 * 4);
            const UniverseCounts one{.holds = better == rivals ? weight : 0,
                                     .fails = worse > 0 ? weight : 0,
                                     .undecided = better < rivals && worse == 0 ? weight : 0};
            all += one;
            if (explains(0, a) + explains(1, b) + explains(2, c) >= static_cast<std::size_t>(fit.least)) fitting += one;
            for (const auto* chosen : {&study.chosen, &a.chosen, &b.chosen, &c.chosen}) {
              for (const Multiverse::Choice& each : *chosen) counts[{each.dimension, each.alternative}] += one;
            }
          }
        }
      }
    }
  }
  return counts;
}

bool are_same(const UniverseCounts& one, const UniverseCounts& other) {
  return one.holds == Approx(other.holds) && one.fails == Approx(other.fails) &&
         one.undecided == Approx(other.undecided);
}

}  // namespace

TEST_CASE("claims counted by products are those counted universe by universe", "[multiverse]") {
  const Multiverse multiverse = small_multiverse();
  const Fit fit = some_fit(multiverse);
  const std::vector<std::string> alone{"A"}, both{"A", "B"};
  for (const auto& [own, rival] :
       {std::pair(alone, ""), std::pair(alone, "B"), std::pair(alone, "C"), std::pair(both, "")}) {
    CAPTURE(own, rival);
    UniverseCounts all, fitting;
    ByAlternative expected = listed(multiverse, own, rival, fit, all, fitting);
    ClaimEntry claim = claim_of_a(rival);
    claim.solvers = own;
    const ClaimCounts counts = counted(multiverse, {claim}, usual_plan, fit).front();
    CHECK(counts.all.all() == Approx(2));  // seeds
    CHECK(are_same(counts.all, all));
    CHECK(are_same(counts.fitting, fitting));
    CHECK(fitting.holds > 0);
    CHECK(fitting.fails > 0);
    CHECK(fitting.undecided > 0);
    CHECK(fitting.all() < 1.5);
    // Some of every kind, or this shows little.
    CHECK(all.holds > 0);
    CHECK(all.fails > 0);
    CHECK(all.undecided > 0);
    for (std::size_t d = 0; d < multiverse.dimensions.size(); ++d) {
      for (std::size_t a = 0; a < multiverse.dimensions[d].alternatives.size(); ++a) {
        CAPTURE(d, a);
        CHECK(are_same(counts.alternatives[d][a], expected[{d, a}]));
      }
    }
    CHECK(counts.seeds.size() == 2);
    CHECK(counts.seeds[0].holds + counts.seeds[1].holds == Approx(all.holds));
    CHECK(counts.seeds[0].all() == Approx(1));
    CHECK(counts.seeds[1].all() == Approx(1));
  }
}

TEST_CASE("the deciding dimension is that with the largest difference of shares", "[multiverse]") {
  const Multiverse multiverse = small_multiverse();
  const ClaimCounts counts = counted(multiverse, {claim_of_a()}, usual_plan).front();
  const std::size_t deciding = counts.deciding();
  REQUIRE(deciding < multiverse.dimensions.size());
  for (std::size_t d = 0; d < multiverse.dimensions.size(); ++d) {
    CHECK(counts.difference(d) <= counts.difference(deciding));
  }
  CHECK(counts.difference(deciding) > 0);
}

TEST_CASE("a mean that is no number is worse than one that is, in every universe", "[multiverse]") {
  Multiverse multiverse = small_multiverse();
  for (Multiverse::OfStudy& study : multiverse.studies) {
    for (Multiverse::ChosenSolver& own : study.solvers[0]) own.error_cm[0].front() = own.error_cm[1].front() = INFINITY;
  }
  const ClaimCounts counts = counted(multiverse, {claim_of_a()}, usual_plan).front();
  CHECK(counts.all.fails == counts.all.all());
}

TEST_CASE("a detail that only one choice of the study has does not change what that choice weighs", "[multiverse]") {
  // x=0, where B has three choices and A is better than each, and x=1, where B has one, which is better than A.
  const auto own = [](double value) {
    return Multiverse::ChosenSolver{.chosen = {}, .error_cm = {{value, 1.1 * value, 1.2 * value}}, .variation_deg = {}};
  };
  Multiverse multiverse{
      .dimensions = {{"x", "2.1", "", {{"x=0", "it is 0"}, {"x=1", "it is 1"}}}},
      .solvers = {"A", "B"},
      .studies = {{.chosen = {{0, 0}}, .weight = 0.5, .solvers = {{own(1)}, {own(9), own(8), own(7)}}},
                  {.chosen = {{0, 1}}, .weight = 0.5, .solvers = {{own(9)}, {own(1)}}}}};
  const ClaimCounts counts = counted(multiverse, {claim_of_a()}, usual_plan).front();
  CHECK(multiverse.universes() == 4);
  CHECK(counts.all.holds == Approx(0.5));
  CHECK(counts.all.fails == Approx(0.5));
  CHECK(counts.alternatives[0][0].holds == Approx(0.5));
  CHECK(counts.alternatives[0][1].fails == Approx(0.5));
}

TEST_CASE("pairs are judged at the level of the study's plan, and with a control only against it", "[multiverse]") {
  const Multiverse multiverse = small_multiverse();
  const auto decided = [&](const AnalysisPlan& of, const std::string& rival) {
    const UniverseCounts all = counted(multiverse, {claim_of_a(rival)}, of).front().all;
    return all.holds + all.fails;
  };
  AnalysisPlan strict, controlled;
  strict.significance = 0.001;
  controlled.control = "B";
  CHECK(decided(strict, "B") < decided(usual_plan, "B"));
  CHECK(decided(controlled, "B") == decided(usual_plan, "B"));
  CHECK(decided(controlled, "C") == 0);
  CHECK(decided(usual_plan, "C") > 0);
}
