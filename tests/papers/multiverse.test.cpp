#include "tests/papers/studies.hpp"

namespace {

constexpr int few_runs = 5;

// Runs around a middle.
std::vector<double> around(double middle, int runs) {
  std::vector<double> values;
  for (int run = 0; run < runs; ++run) values.push_back(middle * (1 + 0.02 * ((run * 3) % runs)));
  return values;
}

Multiverse::ChosenSolver chosen(Multiverse& of, results::Chosen choices, double error, double variation, int runs) {
  of.means.push_back({Group{.values = around(error, runs)}, Group{.values = around(variation, runs)}});
  return {.chosen = std::move(choices), .parts = {of.means.size() - 1}};
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
  Multiverse multiverse;
  multiverse.dimensions = {dimension("way", ""), dimension("a", "IK-BA"), dimension("b", "BA"), dimension("c", "DE"),
                           dimension("d", "MO-PSO")};
  multiverse.solvers = {"IK-BA", "BA", "DE", "MO-PSO"};
  const auto chosen_of = [&](std::size_t d, std::size_t a, double error, double variation) {
    return chosen(multiverse, {{d, a}}, error, variation, runs);
  };
  for (std::size_t way : {0U, 1U}) {
    auto& study = multiverse.studies.emplace_back();
    study.chosen = {{0, way}};
    const double farther = way == 0 ? 1 : 1.5;
    study.solvers = {{chosen_of(1, 0, 1, 10), chosen_of(1, 1, 3, 40)},
                     {chosen_of(2, 0, 2 * farther, 30), chosen_of(2, 1, 0.5, 30)},
                     {chosen_of(3, 0, 1.02, 35), chosen_of(3, 1, 4, 9)},
                     {chosen_of(4, 0, 5, 20), chosen_of(4, 1, 6, 10.2)}};
  }
  return multiverse;
}

// Every reading by itself: the pairs of the claim, each at its part of the significance.
Readings by_hand(const Multiverse& multiverse, const Claim& claim) {
  Readings count;
  const std::size_t metric = claim.metrics.front()->column == metrics_of_readings[0] ? 0 : 1;
  const double pairs = 6;
  for (const auto& study : multiverse.studies) {
    for (std::size_t reading = 0; reading < 16; ++reading) {
      Observations of{.metric = "x", .quantity = "x", .rounding = claim.metrics.front()->rounding, .groups = {}};
      for (std::size_t s = 0; s < 4; ++s) {
        of.groups.push_back(
            {.name = multiverse.solvers[s],
             .values = multiverse.means[study.solvers[s][(reading >> s) & 1].parts.front()][metric].values});
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
      const Holds holds = holds_of(tally);
      ++(holds == Holds::holds ? count.holds : holds == Holds::fails ? count.fails : count.undecided);
    }
  }
  return count;
}

}  // namespace

TEST_CASE("products count what every reading by itself has", "[papers]") {
  const Multiverse multiverse = small(few_runs);
  const Paper& paper = paper_named("slim2023");
  const JudgedMultiverse result = judged(paper, multiverse, {.test = results::Plan::Test::means});
  std::set<std::string> ids;
  for (const auto& [condition, count] : result.claims) {
    INFO(condition.id);
    ids.insert(condition.id);
    const Readings expected = by_hand(multiverse, *std::ranges::find(paper.claims, condition.id, &Claim::id));
    CHECK(count.holds == expected.holds);
    CHECK(count.fails == expected.fails);
    CHECK(count.undecided == expected.undecided);
    CHECK(count.holds + count.fails + count.undecided == 32);
  }
  CHECK(ids == std::set<std::string>{"most_accurate", "least_variation", "better_than_ba", "least_spread"});
  const Readings& accurate = result.claims.front().count;
  CHECK(accurate.holds > 0);
  CHECK(accurate.fails > 0);
  CHECK(accurate.undecided > 0);
}

TEST_CASE("the smallest sets of answers without which a claim does not fail are told", "[papers]") {
  const Paper& paper = paper_named("slim2023");
  const JudgedMultiverse result = judged(paper, small(few_runs), {});
  std::map<std::string, Condition> conditions;
  for (const Condition& each : result.conditions()) conditions[each.id] = each;
  CHECK(conditions["better_than_ba"].fails == "only where a=1 or b=1");
  CHECK(conditions["better_than_ba"].words == "a is 1 or b is 1");
  CHECK(conditions["least_variation"].fails == "only where a=1 or c=1");
  CHECK(conditions["most_accurate"].fails == "only where a=1 or b=1");

  Multiverse by_default = small(few_runs);  // and where nothing or the default fails
  for (auto& study : by_default.studies) study.solvers[1] = {chosen(by_default, {}, 9, 50, few_runs)};
  CHECK(judged(paper, by_default, {}).conditions()[2].fails == "nowhere");
  for (auto& study : by_default.studies) study.solvers[1] = {chosen(by_default, {}, 0.1, 50, few_runs)};
  CHECK(judged(paper, by_default, {}).conditions()[2].fails == "in some seeds of the default, too");
}

TEST_CASE("numbers of the same program by another seed are expected in the ranges of most", "[papers]") {
  const Paper& paper = paper_named("slim2023");
  CHECK_FALSE(judged(paper, small(20), {}).expected);        // one seed
  CHECK_FALSE(judged(paper, small(few_runs), {}).expected);  // and not the paper's number of runs
  Multiverse two = small(20);
  for (auto& study : two.studies) {
    for (auto& solver : study.solvers) {
      for (auto& choice : solver) choice.parts.push_back(choice.parts[0]);
    }
  }
  CHECK(judged(paper, two, {}).expected == 40.0);  // the very same numbers, of four solvers
}

TEST_CASE("a solver that diverges is not tested", "[papers]") {
  Multiverse multiverse = small(few_runs);
  for (auto& study : multiverse.studies) {
    for (auto& own : study.solvers[3]) {
      Group& means = multiverse.means[own.parts[0]][0];
      means.values.pop_back();
      means.lost = 1;
    }
  }
  const JudgedMultiverse result = judged(paper_named("slim2023"), multiverse, {});
  CHECK(result.claims.front().count.holds == 0);
}
