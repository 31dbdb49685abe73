#include "analysis/inference/together.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "analysis/inference/evidence.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::inference;
using namespace ikbench::results;

namespace {

Observations of_groups(std::vector<Group> groups, std::vector<std::string> blocks = {}) {
  Observations result{.name = "error", .quantity = "position error [cm]", .unit = "cm"};
  result.groups = std::move(groups);
  result.blocks = std::move(blocks);
  result.block_noun = "targets";
  result.replicate = "the only solve of a target";
  return result;
}

std::vector<double> values_of(const Observations& observations, const std::string& name) {
  for (const Group& group : observations.groups) {
    if (group.name == name) return group.values;
  }
  return {};
}

}  // namespace

TEST_CASE("a run of several studies is the mean of its values in each", "[together]") {
  const Observations all = together({{"helix", of_groups({{"x", {1, 2, 3}}, {"y", {2, 3, 4}}})},
                                     {"arm", of_groups({{"y", {4, 4, 4}}, {"z", {9, 9, 9}}, {"x", {3, 2, 1}}})}});
  REQUIRE(all.groups.size() == 2);  // not z, which the helix has not
  CHECK(values_of(all, "x") == std::vector<double>{2, 2, 2});
  CHECK(values_of(all, "y") == std::vector<double>{3, 3.5, 4});
  CHECK(all.blocks.empty());
  CHECK(all.replicate == "the mean over 2 studies of a run");
  CHECK(all.notes.back() == "Left out, because not every study has them: z.");
}

TEST_CASE("of logarithms the mean is that of logarithms, so a study of large errors does not decide alone",
          "[together]") {
  Observations small = of_groups({{"x", {-3, -3}}, {"y", {-2, -2}}}), large = of_groups({{"x", {1, 3}}, {"y", {1, 1}}});
  small.scale = large.scale = ValueScale::log10;
  const Observations all = together({{"small", small}, {"large", large}});
  CHECK(values_of(all, "x") == std::vector<double>{-1, 0});
  CHECK(values_of(all, "y") == std::vector<double>{-0.5, -0.5});
  CHECK(all.scale == ValueScale::log10);
}

TEST_CASE("a solver that repeats itself has its one value in every run", "[together]") {
  const Group exact{.name = "x", .values = {5}, .copies = 3}, other{.name = "y", .values = {1, 2, 3}};
  const Observations mixed =
      together({{"a", of_groups({exact, other})}, {"b", of_groups({{"x", {1, 2, 3}}, {"y", {1, 1, 1}}})}});
  CHECK(values_of(mixed, "x") == std::vector<double>{3, 3.5, 4});
  CHECK(mixed.groups[0].copies == 0);
  const Group exact_too{.name = "x", .values = {7}, .copies = 2};
  const Observations known = together({{"a", of_groups({exact, other})}, {"b", of_groups({exact_too, other})}});
  CHECK(values_of(known, "x") == std::vector<double>{6});
  CHECK(known.groups[0].copies == 2);
}

TEST_CASE("runs that only one study has count nowhere", "[together]") {
  const Observations all = together(
      {{"a", of_groups({{"x", {1, 2, 3}}, {"y", {1, 1, 1}}})}, {"b", of_groups({{"x", {3, 4}}, {"y", {1, 1, 1}}})}});
  CHECK(values_of(all, "x") == std::vector<double>{2, 3});
  CHECK(values_of(all, "y").size() == 3);
  CHECK(all.notes == std::vector<std::string>{"Only runs that every study has count, the first of each: x (2 runs)."});
}

TEST_CASE("blocks of several studies are blocks of one, and the engine judges them as such", "[together]") {
  const Observations one = of_groups({{"x", {1, 2, 4}}, {"y", {1.5, 2.5, 4.25}}}, {"run 1", "run 2", "run 3"});
  const Observations two = of_groups({{"x", {10, 30}}, {"y", {11, 32}}}, {"run 1", "run 2"});
  const Observations all = together({{"one", one}, {"two", two}});
  CHECK(all.blocks == std::vector<std::string>{"one: run 1", "one: run 2", "one: run 3", "two: run 1", "two: run 2"});
  CHECK(values_of(all, "x") == std::vector<double>{1, 2, 4, 10, 30});
  CHECK(values_of(all, "y") == std::vector<double>{1.5, 2.5, 4.25, 11, 32});
  CHECK(all.block_noun == "targets");
  CHECK(all.notes == std::vector<std::string>{"The targets of all studies count alike: 3 of one, 2 of two."});
  // By hand: the same numbers as one study of five targets.
  const Observations by_hand = of_groups({{"x", {1, 2, 4, 10, 30}}, {"y", {1.5, 2.5, 4.25, 11, 32}}}, all.blocks);
  const Finding found = evidence(all, {}).contrasts.at(0), expected = evidence(by_hand, {}).contrasts.at(0);
  CHECK(found.p == expected.p);
  CHECK(found.estimate.value == expected.estimate.value);
  CHECK(std::abs(found.estimate.value + 0.85) < 1e-12);  // the mean of -0.5, -0.5, -0.25, -1 and -2
}

TEST_CASE("a seed is a block, and its value is the mean over its runs", "[together]") {
  const Group exact{.name = "z", .values = {5}, .copies = 3};
  const auto seed = [&](const std::string& name, std::vector<double> x, std::vector<double> y) {
    return OfStudy{name, of_groups({{"x", std::move(x)}, {"y", std::move(y)}, exact})};
  };
  const Observations all = together(
      {seed("s-1", {1, 2, 3}, {2, 4, 6}), seed("s-2", {2, 2, 5}, {3, 3, 10.5}), seed("s-3", {0, 1, 2}, {1, 1, 4.75}),
       seed("s-4", {4, 4, 4}, {6, 7, 8}), seed("s-5", {5, 4, 6}, {8, 9, 10}), seed("s-6", {2, 2, 3.5}, {3, 3, 3})},
      true);
  CHECK(all.blocks == std::vector<std::string>{"s-1", "s-2", "s-3", "s-4", "s-5", "s-6"});
  CHECK(values_of(all, "x") == std::vector<double>{2, 3, 1, 4, 5, 2.5});
  CHECK(values_of(all, "y") == std::vector<double>{4, 5.5, 2.25, 7, 9, 3});
  CHECK(values_of(all, "z") == std::vector<double>(6, 5));
  CHECK(all.groups[2].copies == 0);
  CHECK(all.block_noun == "seeds");
  // The engine pairs them: by hand the differences are -2, -2.5, -1.25, -3, -4 and -0.5.
  const Observations by_hand = of_groups({{"x", {2, 3, 1, 4, 5, 2.5}}, {"y", {4, 5.5, 2.25, 7, 9, 3}}}, all.blocks);
  Observations two = all;
  two.groups.pop_back();
  const Finding found = evidence(two, {}).contrasts.at(0), expected = evidence(by_hand, {}).contrasts.at(0);
  CHECK(std::abs(found.estimate.value + 13.25 / 6) < 1e-12);
  CHECK(found.p == expected.p);
}

TEST_CASE("seeds with equal differences are too few, and the reason says how many decide", "[together]") {
  const std::vector<std::vector<double>> shares{
      {1, 1, 1, 1, 1, 1, 1}, {0.5, 0.25, 0.25, 0.25, 0.25, 0.25, 0.25}, {0, 0, 0, 0, 0, 0, 0}};
  const auto judged = [&](std::size_t seeds) {
    std::vector<OfStudy> all;
    for (std::size_t seed = 0; seed < seeds; ++seed) {
      const auto of = [&](std::size_t solver) { return std::vector<double>(2, shares[solver][seed]); };
      all.push_back({std::to_string(seed), of_groups({{"x", of(0)}, {"y", of(1)}, {"z", of(2)}})});
    }
    Observations seven = together(std::move(all), true);
    seven.better = Better::larger;
    return evidence(seven, AnalysisPlan()).contrasts.front();
  };
  const Finding five = judged(5), enough = judged(7);
  CHECK(five.relation == Relation::undecided);
  CHECK(
      std::string(five.why) ==
      "too few different differences within blocks: the bootstrap of 3 pairs needs 5 different ones, or 7 seeds that all "
      "favour one group");
  CHECK(enough.relation == Relation::better);
  CHECK(std::abs(enough.p - 3 * 2 / 128.0) < 1e-12);
}

TEST_CASE("solvers with the same bits have them in every study, and notes name their study", "[together]") {
  Observations one =
      of_groups({{.name = "x", .values = {1, 2}, .bits = 1}, {.name = "y", .values = {1, 2}, .bits = 1}});
  Observations two = of_groups({{"x", {3, 4}}, {"y", {3, 5}}});
  one.notes = {"shared", "of the first"};
  two.notes = {"shared"};
  one.counting = two.counting = {"how"};
  const Observations all = together({{"one", one}, {"two", two}});
  CHECK(all.groups[1].bits == 0);
  CHECK(all.notes == std::vector<std::string>{"shared", "one: of the first"});
  CHECK(all.counting == std::vector<std::string>{"how"});
  CHECK(together({{"one", one}, {"again", one}}).groups[1].bits == 1);
}
