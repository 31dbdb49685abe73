#include "tests/papers/studies.hpp"

namespace {

constexpr int few_runs = 5;

// Runs around a middle.
std::vector<double> around(double middle, int runs) {
  std::vector<double> values;
  for (int run = 0; run < runs; ++run) values.push_back(middle * (1 + 0.02 * ((run * 3) % runs)));
  return values;
}

SolvedMultiverse::ChosenSolver chosen(SolvedMultiverse& of, results::Chosen choices, double error, double variation,
                                      int runs) {
  of.means.push_back(
      {Group{.sample = Measured{around(error, runs)}}, Group{.sample = Measured{around(variation, runs)}}});
  return {.chosen = std::move(choices), .parts = {of.means.size() - 1}};
}

results::Dimension dimension(std::string name, std::string solver) {
  return {
      .name = name,
      .label = std::move(solver),
      .alternatives = {{.set = name + "=0", .where = name + " is 0"}, {.set = name + "=1", .where = name + " is 1"}}};
}

// 2 choices for the study, and 2 for each of four solvers: 32 readings.
SolvedMultiverse small(int runs) {
  SolvedMultiverse multiverse;
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

using Readings = std::vector<std::int64_t>;  // in which it holds, fails, is not decided

// Every reading by itself: the pairs of the claim, each at its part of the significance.
Readings by_hand(const SolvedMultiverse& multiverse, const Claim& claim) {
  Readings count(3);
  const std::size_t metric = claim.metrics.front()->column == metrics_of_readings[0] ? 0 : 1;
  const double pairs = 6;
  for (const auto& study : multiverse.studies) {
    for (std::size_t reading = 0; reading < 16; ++reading) {
      Observations of{.metric = "x", .quantity = "x", .rounding = claim.metrics.front()->rounding, .groups = {}};
      for (std::size_t s = 0; s < 4; ++s)
        of.groups.push_back(
            {.name = multiverse.solvers[s],
             .sample = multiverse.means[study.solvers[s][(reading >> s) & 1].parts.front()][metric].sample});
      if (claim.of == Of::spread) of = deviations(of);
      Tally tally;
      for (const std::string& own : claim.solvers) {
        for (std::size_t s = 0; s < 4; ++s) {
          const std::string& rival = multiverse.solvers[s];
          const bool is_asked = claim.against.empty() || claim.against.front() == rival;
          if (!is_asked || std::ranges::count(claim.solvers, rival) > 0) continue;
          Observations two = of;
          std::erase_if(two.groups, [&](const Group& group) { return group.name != own && group.name != rival; });
          const JudgedMetric judged =
              judge::judge(two, {.test = judge::Plan::Test::means, .significance = 0.05 / pairs});
          tally.add(verdict_between(judged, own, rival));
        }
      }
      const Holds holds = holds_of(tally);
      ++count[holds == Holds::holds ? 0 : holds == Holds::fails ? 1 : 2];
    }
  }
  return count;
}

Readings readings_in(const std::vector<show::Cell>& row) {
  return {std::get<std::int64_t>(row[1]), std::get<std::int64_t>(row[2]), std::get<std::int64_t>(row[3])};
}

}  // namespace

TEST_CASE("products count what every reading by itself has", "[papers]") {
  const SolvedMultiverse multiverse = small(few_runs);
  const Paper& paper = paper_named("slim2023");
  const JudgedMultiverse result = judged(paper, multiverse, {.test = results::Plan::Test::means});
  std::vector<std::string> ids;
  for (const Claim& claim : paper.claims) {
    if (!result.in_readings.contains(claim.id)) continue;
    INFO(claim.id);
    CHECK(readings_in(result.table.rows[ids.size()]) == by_hand(multiverse, claim));
    ids.push_back(claim.id);
  }
  CHECK(ids == std::vector<std::string>{"most_accurate", "least_variation", "better_than_ba", "least_spread"});
  for (const std::int64_t some : readings_in(result.table.rows.front())) CHECK(some > 0);
}

TEST_CASE("the answer that most failing readings have is told, with their number", "[papers]") {
  const Paper& paper = paper_named("slim2023");
  const auto counts = [&](const SolvedMultiverse& of, const char* id) { return judged(paper, of, {}).in_readings[id]; };
  const InReadings of_ba = counts(small(few_runs), "better_than_ba");
  CHECK(of_ba.all() == 32);
  CHECK(of_ba.fail == 20);  // b=1: 16; else a=1 where BA is not farther: 4
  CHECK(of_ba.most_fail == "16 with b=1 (b is 1)");

  SolvedMultiverse by_default = small(few_runs);  // and where nothing or the default fails
  for (auto& study : by_default.studies) study.solvers[1] = {chosen(by_default, {}, 9, 50, few_runs)};
  CHECK(counts(by_default, "better_than_ba").most_fail.empty());
  CHECK(counts(by_default, "better_than_ba").hold == 16);
  for (auto& study : by_default.studies) study.solvers[1] = {chosen(by_default, {}, 0.1, 50, few_runs)};
  CHECK(counts(by_default, "better_than_ba").fail == 16);
  CHECK(counts(by_default, "better_than_ba").most_fail.starts_with("8 with "));
}

TEST_CASE("the numbers that repeat are counted by seed, row and of another seed's", "[papers]") {
  const auto between = [](double low, double high) {
    std::vector<double> values;
    for (int run = 0; run < 20; ++run) values.push_back(low + (high - low) * run / 19);
    return Group{.sample = Measured{values}};
  };
  SolvedMultiverse multiverse;
  multiverse.solvers = {"IK-BA"};
  multiverse.studies.resize(1);
  // Printed are errors of 0.0016 to 0.0022 and 73 to 102 deg. The second seed has other errors, and the third is the
  // second.
  multiverse.means = {{between(0.0016, 0.0022), between(73, 102)},
                      {between(0.1, 0.2), between(73, 102)},
                      {between(0.1, 0.2), between(73, 102)}};
  multiverse.studies[0].solvers = {{{.chosen = {}, .parts = {0, 1, 2}}}};
  const SeedCounts counts = counts_by_seed(paper_named("slim2023"), multiverse);
  CHECK(counts.all == std::vector<int>{10, 5, 5});
  CHECK(counts.rows.at("IK-BA") == counts.all);
  CHECK(counts.of == 10);
  CHECK(counts.same == std::vector<int>{5, 5, 5, 10, 5, 10});
  CHECK(span_of(counts.same) == "5 to 10");
  CHECK(span_of({7, 7}) == "7");
  for (auto& means : multiverse.means) means[1].sample = Measured{{1, 2, 3, 4}};
  CHECK(counts_by_seed(paper_named("slim2023"), multiverse).of == 0);  // so few runs have no range
}

TEST_CASE("a solver that diverges is not tested", "[papers]") {
  SolvedMultiverse multiverse = small(few_runs);
  for (auto& study : multiverse.studies) {
    for (auto& own : study.solvers[3]) {
      Group& means = multiverse.means[own.parts[0]][0];
      std::vector<double> rest = std::get<Measured>(means.sample).values;
      rest.pop_back();
      means.sample = Untold{.lost = 1, .values = rest};
    }
  }
  const JudgedMultiverse result = judged(paper_named("slim2023"), multiverse, {});
  CHECK(readings_in(result.table.rows.front())[0] == 0);
}
