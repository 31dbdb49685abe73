// Outcomes of 0 and 1 are compared as shares.
#include "analysis/inference/outcomes.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "analysis/inference/judge.hpp"
#include "analysis/report/assessment.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::inference;
using namespace ikbench::report;

namespace {

std::vector<double> outcomes(int ones, int all) {
  std::vector<double> values(static_cast<std::size_t>(all), 0.0);
  std::fill_n(values.begin(), ones, 1.0);
  return values;
}

Observations solved(std::vector<Group> groups) {
  return {.name = "solved", .quantity = "solved", .better = Better::larger, .groups = std::move(groups)};
}

bool has(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

bool says(const Assessment& assessment, const std::string& words) {
  return std::ranges::any_of(words_of(assessment.sentences),
                             [&](const std::string& sentence) { return has(sentence, words); });
}

}  // namespace

TEST_CASE("values of 0 and 1 are outcomes where both occur, and no others are", "[outcomes]") {
  CHECK(are_outcomes(solved({{"A", {0, 1, 1}}, {"B", {1, 1}}})));
  CHECK_FALSE(are_outcomes(solved({{"A", {0, 1, 0.5}}, {"B", {1, 1}}})));
  CHECK_FALSE(are_outcomes(solved({{"A", {1, 1}}, {"B", {1, 1}}})));  // a count of 1 may be a fact
  CHECK_FALSE(are_outcomes(solved({{"A", {0, 1}}, {"B", {}}})));
  CHECK_FALSE(are_outcomes(solved({{"A", {0, 1}}, {"B", {statistics::not_defined}}})));
}

TEST_CASE("outcomes have shares, Wilson's intervals and Fisher's exact test", "[outcomes]") {
  const Observations observed = solved({{"A", outcomes(18, 20)}, {"B", outcomes(9, 20)}});
  const Evidence found = evidence(observed, {});
  CHECK(found.groups[0].mean.value == 0.9);
  CHECK(found.groups[0].mean.low == Approx(0.6989663548).epsilon(1e-9));      // R 4.2.2, prop.test without correction
  CHECK(found.contrasts[0].p == Approx(0.005735673700078594).epsilon(1e-6));  // SciPy 1.10.1, fisher_exact
  CHECK(found.contrasts[0].relation == Relation::better);
  CHECK(judge(found, "B", "A").relation == Relation::worse);
  const Assessment assessed = assess(observed, {});
  CHECK(says(assessed, "90 % vs 45 %"));
  CHECK(says(assessed, "percentage points"));
  for (const char* other : {"Welch", "Kruskal", "Mann-Whitney", "A12", "variance"}) {
    CAPTURE(other);
    CHECK_FALSE(says(assessed, other));
    for (const Table& table : assessed.tables) CHECK_FALSE(has(to_markdown(table), other));
  }
}

TEST_CASE("pairs of outcomes are corrected as planned, and their intervals hold together", "[outcomes]") {
  const Evidence found =
      evidence(solved({{"A", outcomes(18, 20)}, {"B", outcomes(9, 20)}, {"C", outcomes(12, 20)}}), {});
  // SciPy 1.10.1: 0.005736 (A-B), 0.064833 (A-C), 0.527254 (B-C); Holm: times 3, 2 and 1.
  CHECK(found.contrasts[0].p == Approx(3 * 0.005735673700078594).epsilon(1e-6));
  CHECK(found.contrasts[1].p == Approx(2 * 0.06483316160735517).epsilon(1e-6));
  CHECK(found.contrasts[1].relation == Relation::undecided);
  const Evidence two = evidence(solved({{"A", outcomes(18, 20)}, {"B", outcomes(9, 20)}}), {});
  CHECK(found.contrasts[0].estimate.low < two.contrasts[0].estimate.low);
}

TEST_CASE("shares that differ by less than the margin for certain are the same within it", "[outcomes]") {
  const Observations observed = solved({{"A", outcomes(2500, 5000)}, {"B", outcomes(2510, 5000)}});
  CHECK(evidence(observed, {}).contrasts[0].relation == Relation::same);
  CHECK(says(assess(observed, {}), "5 percentage points"));
}

TEST_CASE("within blocks outcomes have McNemar's test", "[outcomes]") {
  Observations observed = solved({{"A", {1, 1, 1, 1, 1, 1, 1, 1, 1, 0}},
                                  {"B", {0, 0, 0, 0, 0, 0, 0, 1, 1, 0}},
                                  {"C", {1, 1, 1, 1, 1, 1, 1, 1, 0, 1}}});
  for (int block = 1; block <= 10; ++block) observed.blocks.push_back(std::to_string(block));
  observed.block = "a target";
  const Evidence found = evidence(observed, {});
  CHECK(found.contrasts[0].p == Approx(3 * 2 / 128.0));  // seven blocks tell A and B apart, all alike; Holm
  CHECK(found.contrasts[1].p == 1);                      // one block each way
  CHECK(says(assess(observed, {}), "McNemar's exact test decides"));
}

TEST_CASE("all of one group against none of the other: undecided, with the interval's method", "[outcomes]") {
  const Observations observed = solved({{"A", outcomes(3, 3)}, {"B", outcomes(0, 3)}});
  const Evidence found = evidence(observed, {});
  CHECK(found.contrasts[0].p == Approx(0.1));  // 2 of 20 arrangements
  const Assessment assessed = assess(observed, {});
  CHECK(says(assessed, "Methods: every observation is 0 or 1, so shares are compared. Fisher's exact test decides"));
  CHECK(says(assessed, "In short: A against B is undecided (p = 0.1; difference between "));
  CHECK(says(assessed, "), although the interval of the difference excludes zero."));
  CHECK(says(assessed,
             "Caution: no pair can differ by this test. It takes at least 4 observations per group, and here are 3."));
}

TEST_CASE("two that always succeed are the same where there are enough observations", "[outcomes]") {
  Observations observed = solved({{"A", outcomes(20, 20)}, {"B", outcomes(20, 20)}});
  observed.scale = ValueScale::share;
  CHECK(evidence(observed, {}).contrasts[0].relation == Relation::undecided);
  // z^2 / (n + z^2) of Wilson's interval is at most 0.05.
  observed.groups = {{"A", outcomes(73, 73)}, {"B", outcomes(73, 73)}};
  CHECK(evidence(observed, {}).contrasts[0].relation == Relation::same);
}
