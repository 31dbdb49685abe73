#include "analysis/papers/multiverse.hpp"

#include <set>

#include "analysis/papers/rules.hpp"
#include "tests/papers/studies.hpp"

using namespace ikbench;
using namespace ikbench::compare;
using namespace ikbench::papers;

namespace {

constexpr int few_runs = 5;

// Runs around a middle.
std::vector<double> around(double middle, int runs) {
  std::vector<double> values;
  for (int run = 0; run < runs; ++run) values.push_back(middle * (1 + 0.02 * ((run * 3) % runs)));
  return values;
}

Multiverse::ChosenSolver chosen(results::Chosen choices, double error, double variation, int runs) {
  return {.chosen = std::move(choices),
          .means = {{{{.values = around(error, runs)}}, {{.values = around(variation, runs)}}}}};
}

results::Dimension dimension(std::string name, std::string solver) {
  return {
      .name = name,
      .section = "",
      .solver = std::move(solver),
      .alternatives = {{.set = name + "=0", .where = name + " is 0"}, {.set = name + "=1", .where = name + " is 1"}},
      .open = "the " + name};
}

// 2 choices for the study, and 2 for each of four solvers: 32 readings.
Multiverse small(int runs) {
  Multiverse multiverse{.dimensions = {dimension("way", ""), dimension("a", "IK-BA"), dimension("b", "BA"),
                                       dimension("c", "DE"), dimension("d", "MO-PSO")},
                        .solvers = {"IK-BA", "BA", "DE", "MO-PSO"},
                        .studies = {}};
  for (std::size_t way : {0U, 1U}) {
    auto& study = multiverse.studies.emplace_back();
    study.chosen = {{0, way}};
    study.weight = way == 0 ? 0.75 : 0.25;
    const double farther = way == 0 ? 1 : 1.5;
    study.solvers = {{chosen({{1, 0}}, 1, 10, runs), chosen({{1, 1}}, 3, 40, runs)},
                     {chosen({{2, 0}}, 2 * farther, 30, runs), chosen({{2, 1}}, 0.5, 30, runs)},
                     {chosen({{3, 0}}, 1.02, 35, runs), chosen({{3, 1}}, 4, 9, runs)},
                     {chosen({{4, 0}}, 5, 20, runs), chosen({{4, 1}}, 6, 10.2, runs)}};
  }
  return multiverse;
}

// Every reading by itself: the pairs of the claim, each at its part of the significance.
Shares by_hand(const Multiverse& multiverse, const Claim& claim) {
  Shares shares;
  const std::size_t metric = claim.metrics.front()->column == metrics_of_readings[0] ? 0 : 1;
  const double pairs = 6;
  for (const auto& study : multiverse.studies) {
    for (std::size_t reading = 0; reading < 16; ++reading) {
      Observations of{.metric = "x", .quantity = "x", .rounding = claim.metrics.front()->rounding, .groups = {}};
      for (std::size_t s = 0; s < 4; ++s) {
        of.groups.push_back({.name = multiverse.solvers[s],
                             .values = study.solvers[s][(reading >> s) & 1].means[metric].front().values});
      }
      if (claim.of == Of::spread) of = deviations(of);
      Tally tally;
      for (const std::string& own : claim.solvers) {
        for (std::size_t s = 0; s < 4; ++s) {
          const std::string& rival = multiverse.solvers[s];
          const bool is_asked = claim.against.empty() || claim.against.front() == rival;
          if (!is_asked || std::ranges::count(claim.solvers, rival) > 0) continue;
          Observations two = of;
          std::erase_if(two.groups, [&](const Group& group) { return group.name != own && group.name != rival; });
          const Judged judged = judge(two, {.test = compare::Plan::Test::means, .significance = 0.05 / pairs});
          tally.add(verdict_between(judged, own, rival));
        }
      }
      const double weight = study.weight / 16;
      const Holds holds = holds_of(tally);
      (holds == Holds::holds ? shares.holds : holds == Holds::fails ? shares.fails : shares.undecided) += weight;
    }
  }
  return shares;
}

}  // namespace

TEST_CASE("products count what every reading by itself has", "[papers]") {
  const Multiverse multiverse = small(few_runs);
  const Paper& paper = paper_named("slim2023");
  const JudgedMultiverse result = judged(paper, multiverse, {.test = results::Plan::Test::means});
  REQUIRE(result.claims.size() == 4);
  std::set<std::string> ids;
  for (const SharesOfClaim& of : result.claims) {
    INFO(of.id);
    ids.insert(of.id);
    const Claim& claim = *std::ranges::find(paper.claims, of.id, &Claim::id);
    const Shares expected = by_hand(multiverse, claim);
    CHECK(of.all.holds == Approx(expected.holds));
    CHECK(of.all.fails == Approx(expected.fails));
    CHECK(of.all.undecided == Approx(expected.undecided));
    CHECK(of.all.all() == Approx(1));
  }
  CHECK(ids == std::set<std::string>{"most_accurate", "least_variation", "better_than_ba", "repeatable"});
  const SharesOfClaim& accurate = result.claims.front();
  CHECK(accurate.all.holds > 0);
  CHECK(accurate.all.fails > 0);
  CHECK(accurate.all.undecided > 0);
}

TEST_CASE("what decides a claim most is named with the shares of its alternatives", "[papers]") {
  const JudgedMultiverse result = judged(paper_named("slim2023"), small(few_runs), {});
  const auto row = std::ranges::find(result.table.rows, "IK-BA is more accurate than BA",
                                     [](const auto& cells) { return std::get<std::string>(cells[0]); });
  REQUIRE(row != result.table.rows.end());
  CHECK(std::get<std::string>((*row)[7]) == "the a: 50 % where a is 0, 0 % where a is 1");
}

TEST_CASE("print is compared only where the study has the paper's number of runs", "[papers]") {
  const JudgedMultiverse few = judged(paper_named("slim2023"), small(few_runs), {});
  CHECK(few.table.notes.back() == "The paper has 20 runs, this has 5: not compared with print.");
  CHECK(few.claims.front().near.all() == 0);

  Multiverse as_printed_by_one = small(20);
  for (std::size_t run = 0; run < 20; ++run) {
    auto& means = as_printed_by_one.studies[1].solvers[0][1].means;
    means[0][0].values[run] = as_printed("IK-BA", "position_error_cm", static_cast<int>(run));
    means[1][0].values[run] = as_printed("IK-BA", "variation_deg", static_cast<int>(run));
  }
  Paper paper = paper_named("slim2023");
  paper.near = 10;  // all of IK-BA's
  const JudgedMultiverse all = judged(paper, as_printed_by_one, {});
  CHECK(contains(all.table.notes.back(), "at least 10 of the 40 printed numbers"));
  CHECK(all.claims.front().near.all() > 0);
  CHECK(all.claims.front().near.all() < 0.5);
}

TEST_CASE("the range of another study holds what such studies have, and widens with fewer runs", "[papers]") {
  const std::vector<double> values = around(1, 20);
  const Ranges ranges = *predicted_ranges(values, 20), of_five = *predicted_ranges(values, 5);
  const double mean = summarise(values).mean;
  CHECK((ranges[0].low < mean && mean < ranges[0].high));
  CHECK(of_five[0].high - of_five[0].low > 1.4 * (ranges[0].high - ranges[0].low));
  CHECK(ranges[3].high > 1.38);  // the largest may be larger than any that is known
  CHECK_FALSE(predicted_ranges({1, 2, 3, 4}, 20));
  CHECK_FALSE(predicted_ranges({1, 2, 3, 4, 0}, 20));
}

TEST_CASE("a solver that diverges is not tested", "[papers]") {
  Multiverse multiverse = small(few_runs);
  for (auto& study : multiverse.studies) {
    for (auto& own : study.solvers[3]) {
      own.means[0][0].values.pop_back();
      own.means[0][0].lost = 1;
    }
  }
  const JudgedMultiverse result = judged(paper_named("slim2023"), multiverse, {});
  CHECK(result.claims.front().all.holds == 0);
}
