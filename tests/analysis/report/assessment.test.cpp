#include "analysis/report/assessment.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "analysis/inference/method.hpp"
#include "analysis/inference/observations_csv.hpp"
#include "analysis/report/assessment_words.hpp"
#include "results/csv.hpp"
#include "results/published.hpp"
#include "tests/catch.hpp"
#include "tests/contains.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::statistics;
using namespace ikbench::inference;
using namespace ikbench::report;

namespace {

// R's data set PlantGrowth.
Observations plant_growth() {
  return {.name = "weight",
          .quantity = "weight",
          .better = Better::larger,
          .groups = {{"ctrl", {4.17, 5.58, 5.18, 6.11, 4.50, 4.61, 5.17, 4.53, 5.33, 5.14}},
                     {"trt1", {4.81, 4.17, 4.41, 3.59, 5.87, 3.83, 6.03, 4.89, 4.32, 4.69}},
                     {"trt2", {6.31, 5.12, 5.54, 5.50, 5.37, 5.29, 4.92, 6.15, 5.80, 5.26}}}};
}

// Demsar, J. Machine Learning Research 7 (2006) 1, Table 6: AUC of four classifiers on 14 data sets. In the 13th two
// are printed alike that he ranked 2 and 3; the tie is broken here as he did.
Observations demsar() {
  return {.name = "auc",
          .quantity = "AUC",
          .better = Better::larger,
          .groups = {{"C4.5", {.763, .599, .954, .628, .882, .936, .661, .583, .775, 1, .940, .619, .972, .957}},
                     {"C4.5+m", {.768, .591, .971, .661, .888, .931, .668, .583, .838, 1, .962, .666, .981, .978}},
                     {"C4.5+cf", {.771, .590, .968, .654, .886, .916, .609, .563, .866, 1, .965, .614, .9751, .946}},
                     {"C4.5+m+cf", {.798, .569, .967, .657, .898, .931, .685, .625, .875, 1, .962, .669, .975, .970}}},
          .blocks = {"1", "2", "3", "4", "5", "6", "7", "8", "9", "10", "11", "12", "13", "14"},
          .block = "a data set"};
}

Observations printed_table_3(const std::string& metric) {
  for (Observations& summaries : read_summaries(to_csv(published::table("slim2023", "table-3")), "table-3.csv")) {
    if (summaries.quantity == metric) return summaries;
  }
  FAIL("no such metric");
  return {};
}

const Finding& contrast(const Evidence& found, const std::string& first, const std::string& second) {
  const auto is_it = [&](const Finding& c) {
    return found.groups[c.first].name == first && found.groups[c.second].name == second;
  };
  const auto it = std::ranges::find_if(found.contrasts, is_it);
  REQUIRE(it != found.contrasts.end());
  return *it;
}

}  // namespace

TEST_CASE("PlantGrowth is judged as R judges it", "[assessment]") {
  const Evidence found = evidence(plant_growth(), {});
  CHECK(found.plan.test == "bootstrap");
  const auto p_of = [&](const std::string& test) {
    const TestResult* result = found.test(test);
    REQUIRE(result);
    return result->p;
  };
  // R 4.2.2: oneway.test, aov, kruskal.test
  CHECK(evidence(plant_growth(), {.test = "tamhane"}).test("Welch's ANOVA")->p == Approx(0.01739282149).epsilon(1e-9));
  CHECK(p_of("One-way ANOVA") == Approx(0.01591).epsilon(1e-3));
  CHECK(p_of("Kruskal-Wallis test") == Approx(0.01842375573147).epsilon(1e-9));
  CHECK(contrast(found, "trt1", "trt2").p == Approx(0.05).margin(4 * 0.0022));  // of 9999 resamples
  CHECK(contrast(found, "ctrl", "trt1").relation == Relation::undecided);
}

TEST_CASE("the plan decides which test has the word", "[assessment]") {
  const auto p_with = [](const std::string& test) {
    return contrast(evidence(plant_growth(), {.test = test}), "trt1", "trt2").p;
  };
  // mpmath; SciPy's brunnermunzel, the larger beside mannwhitneyu, times 3 as Holm's smallest of three
  CHECK(p_with("tamhane") == Approx(0.02763663710409).epsilon(1e-9));
  CHECK(p_with("kruskal_wallis") == Approx(3 * 0.011244179779992036).epsilon(1e-9));
  CHECK(p_with("bootstrap") == p_with("by_design"));
  CHECK_THROWS_AS(evidence(plant_growth(), {.control = "nobody"}), std::invalid_argument);
  CHECK_THROWS_AS(evidence(printed_table_3("seconds"), {.test = "kruskal_wallis"}), std::invalid_argument);
}

TEST_CASE("the printed Table 3 is judged by Tamhane's test", "[assessment]") {
  const Evidence found = evidence(printed_table_3("position_error_cm"), {});
  CHECK(found.test("One-way ANOVA")->statistic == Approx(40.7736).epsilon(1e-5));
  CHECK(found.test("Welch's ANOVA")->statistic == Approx(141.791).epsilon(1e-5));
  CHECK(contrast(found, "IK-BA", "DE").p == Approx(0.00035549252).epsilon(1e-6));  // by mpmath
}

TEST_CASE("on the printed Table 3 IK-BA and MO-PSO do not differ in variation, and PSO is faster than IK-BA",
          "[assessment]") {
  const Evidence variation = evidence(printed_table_3("variation_deg"), {});
  CHECK(contrast(variation, "IK-BA", "MO-PSO").relation == Relation::undecided);
  const Evidence time = evidence(printed_table_3("seconds"), {});
  CHECK(contrast(time, "IK-BA", "PSO").relation == Relation::worse);
}

TEST_CASE("in blocks means decide, against a control its pairs alone", "[assessment]") {
  CHECK(evidence(demsar(), {}).plan.test == "bootstrap");
  const Evidence against = evidence(demsar(), {.control = "C4.5", .significance = 0.05});
  CHECK(against.contrasts.size() == 3);
  CHECK(against.reference == 0u);
}

TEST_CASE("groups that differ by less than the margin for certain are the same within it", "[assessment]") {
  Observations near = plant_growth();
  near.groups.resize(2);
  near.groups[0].values = {100.0, 100.1, 99.9, 100.05, 99.95};
  near.groups[1].values = {100.1, 100.2, 99.8, 100.0, 99.9};
  CHECK(evidence(near, {.margin = 0.05}).contrasts[0].relation == Relation::same);
  CHECK(evidence(near, {.margin = 0.0001}).contrasts[0].relation == Relation::undecided);
}

TEST_CASE("a difference that is found and lies within the margin is said to be that small", "[assessment]") {
  Observations near{
      .name = "x",
      .quantity = "x",
      .groups = {{"A", {100.0, 100.1, 99.9, 100.05, 99.95}}, {"B", {101.0, 101.1, 100.9, 101.05, 100.95}}}};
  const Evidence found = evidence(near, {.test = "tamhane", .margin = 0.05});
  CHECK(found.contrasts[0].relation == Relation::better);
  CHECK(found.contrasts[0].is_within_margin());
  CHECK(found.contrasts[0].estimate.low == Approx(-1.12).epsilon(0.01));
  CHECK(found.contrasts[0].estimate.high == Approx(-0.885).epsilon(0.01));
  // Welch's interval is 1 -+ 2.306 sqrt(0.00625 * 2 / 5): 0.885 to 1.115, of 100.
  const auto verdict_at = [&](double margin) {
    const Evidence at = evidence(near, {.test = "tamhane", .margin = margin});
    return verdict_words(at, at.contrasts[0]);
  };
  CHECK(verdict_at(0.05) == "A is better by less than 5 %");
  CHECK(verdict_at(0.005) == "A is better by more than 0.5 %");
  CHECK(verdict_at(0.01) == "A is better by 0.885 % to 1.12 % (margin 1 %)");
  CHECK(verdict_at(0) == "A is better");
}

TEST_CASE("a margin in the unit of the values has no percent beside it", "[assessment]") {
  Observations drift{
      .name = "drift",
      .quantity = "drift [K]",
      .unit = "K",
      .groups = {{"A", {100.0, 100.1, 99.9, 100.05, 99.95}}, {"B", {101.0, 101.1, 100.9, 101.05, 100.95}}}};
  const auto verdict = [&](double margin) {
    drift.margin = margin;
    const Evidence found = evidence(drift, {.test = "tamhane", .margin = 0});
    return verdict_words(found, found.contrasts[0]);
  };
  CHECK(verdict(2) == "A is better by less than 2");
  CHECK(verdict(1) == "A is better by perhaps less than 1");
  CHECK(verdict(0.5) == "A is better by more than 0.5");
}

TEST_CASE("a test that does not use the blocks finds less", "[assessment]") {
  // Within blocks B is always 1 above A, and C 2; between the blocks lie thousands.
  Observations sets{.name = "x", .quantity = "x", .groups = {{"A"}, {"B"}, {"C"}}};
  for (int i = 0; i < 10; ++i) {
    for (std::size_t group = 0; group < 3; ++group) {
      sets.groups[group].values.push_back(1000 * i + 100 + static_cast<double>(group) + 0.01 * ((3 * i) % 7));
    }
    sets.blocks.push_back(fmt::format("{}", i));
  }
  const Evidence blocked = evidence(sets, {});
  REQUIRE(std::ranges::all_of(blocked.contrasts, is_decided));
  REQUIRE(blocked.test(anova_name)->p > 0.99);
  const Evidence unblocked = evidence(sets, {.test = "tamhane"});
  CHECK(std::ranges::none_of(unblocked.contrasts, is_decided));
}

TEST_CASE("a margin in cm is for what is in cm, and what is within either margin does not matter", "[assessment]") {
  Observations near{
      .name = "x",
      .quantity = "error [cm]",
      .unit = "cm",
      .groups = {{"A", {0.0010, 0.0011, 0.0009, 0.00105, 0.00095}}, {"B", {0.003, 0.0031, 0.0029, 0.003, 0.003}}}};
  const auto verdict = [&](const AnalysisPlan& plan) {
    const Evidence found = evidence(near, plan);
    return verdict_words(found, found.contrasts[0]);
  };
  CHECK(verdict({}) == "A is better by more than 5 %");
  CHECK(verdict({.margin_cm = 0.01}) == "A is better by less than 0.01 cm");  // 5 % of 0.001 cm is less
  CHECK(verdict({.margin_cm = 0.001}) == "A is better by more than 0.001 cm");
  CHECK(verdict({.margin_cm = 1e-5}) == "A is better by more than 5 %");
  CHECK(verdict({.margin = 0, .margin_cm = 0.01}) == "A is better by less than 0.01 cm");
  near.unit = "s";
  CHECK(verdict({.margin_cm = 0.01}) == "A is better by more than 5 %");
  // The same is what is within either: here not shown to differ.
  Observations same{.name = "x",
                    .quantity = "error",
                    .unit = "cm",
                    .groups = {{"A", {1e-9, 3e-9, 2e-9, 5e-9}}, {"B", {2e-9, 6e-9, 3e-9, 4e-9}}}};
  CHECK(evidence(same, {}).contrasts[0].relation == Relation::undecided);
  CHECK(evidence(same, {.margin_cm = 0.01}).contrasts[0].relation == Relation::same);
}

TEST_CASE("the table of tests has every digit, as numbers", "[assessment]") {
  const Assessment found = assess(plant_growth(), {});
  const std::string csv = to_csv(found.tables.at(1));
  INFO(csv);
  // R 4.2.2: kruskal.test's p; 12 digits are more than a reader is shown.
  CHECK(csv.find("part,test,statistic,value,df,df within,p,effect,size,verdict") == 0);
  const std::size_t row = csv.find("Kruskal-Wallis test,H,7.98");
  REQUIRE(row != std::string::npos);
  CHECK(csv.find(",0.0184237557", row) != std::string::npos);
}

TEST_CASE("degenerate data are explained and never a crash", "[assessment]") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const auto with = [](std::vector<std::vector<double>> values) {
    Observations observations{.name = "x", .quantity = "x"};
    for (std::size_t i = 0; i < values.size(); ++i) {
      observations.groups.push_back({fmt::format("g{}", i), std::move(values[i])});
    }
    return observations;
  };
  CHECK(evidence(with({{7, 7, 7, 7}, {7, 7, 7, 7}}), {}).contrasts[0].relation == Relation::same);
  CHECK(evidence(with({{1}, {2}, {3}}), {}).contrasts[0].relation == Relation::undefined);
  for (const auto& values : std::vector<std::vector<std::vector<double>>>{{{1}, {2, 3}},
                                                                          {{}, {1, 2}},
                                                                          {{nan, 1, 2}, {1, 2, 3}},
                                                                          {{inf, -inf, 2}, {1, 2, 3}},
                                                                          {{1, 2, 3}},
                                                                          {{1, 1, 1}, {2, 2, 2}},
                                                                          {{1e308, -1e308, 1e308}, {1, 2, 3}},
                                                                          {{1, 1, 1}, {1, 2, 3}},
                                                                          {{5, 5}, {5, 5}, {5, 6}},
                                                                          {{1e-320, 2e-320}, {3e-320, 4e-320}}}) {
    const Assessment seen = assess(with(values), {});
    CHECK_FALSE(seen.sentences.empty());
    CHECK_FALSE(seen.tables.empty());
    CHECK_FALSE(nlohmann::json::parse(seen.json, nullptr, false).is_discarded());
  }
}

TEST_CASE("a value of any size makes no test of means call its group the worse for certain", "[assessment]") {
  const double huge = GENERATE(1e150, 1e200, 1e300, 1.7e308);
  const auto test = GENERATE("tamhane", "bootstrap");
  const Evidence found = evidence(
      Observations{.name = "x", .quantity = "x", .groups = {{"a", {0.5, huge, 1, 2}}, {"b", {0.1, 0.2, 5, 2}}}},
      {.test = test});
  CAPTURE(huge, test, found.contrasts[0].p);
  CHECK_FALSE(is_decided(found.contrasts[0]));
  CHECK(std::abs(found.contrasts[0].g) < 1);  // a mean of huge / 4 has a standard error of the same size
}

TEST_CASE("what the bootstrap cannot judge is decided where all values of one group lie beyond those of the other",
          "[assessment]") {
  const std::vector<double> cheap(12, 7), between{30, 34, 36, 33, 38, 35, 31, 37, 39, 32, 40, 29};
  std::vector<double> dear(12, 10007);
  dear[3] = 9000;  // alone: a third of its resamples have no spread
  const auto of = [&](const std::vector<double>& third) {
    return evidence(
        Observations{.name = "x", .quantity = "x", .groups = {{"cheap", cheap}, {"between", between}, {"dear", third}}},
        {});
  };
  const Evidence found = of(dear);
  const Finding& extremes = found.contrasts[1];
  CHECK(extremes.relation == Relation::better);
  CHECK(extremes.p == Approx(3 * 2 / 2704156.0));  // of C(24, 12) orders two, for three pairs
  CHECK(found.contrasts[0].p == extremes.p);       // beside a single value, too, however far the third group varies
  // One value of the dear group among those of the cheap one: nothing tells.
  dear[3] = 6;
  CHECK(of(dear).contrasts[1].relation == Relation::undecided);
}

TEST_CASE("p does not depend on the level that it is held against", "[assessment]") {
  const std::vector<std::vector<double>> few{{1, 2, 3}, {11, 12, 14}, {2, 3, 11.5}},
      constant{{7, 7, 7, 7, 7}, {8, 9, 12, 8.5, 10}}, alike{{1, 1, 1, 1, 1, 2}, {3, 3, 3, 3, 3, 3}},
      single{{1}, {2, 3, 4}};
  for (const auto& sets : {few, constant, alike, single}) {
    for (const bool in_blocks : {false, true}) {
      if (in_blocks && sets[0].size() != sets[1].size()) continue;
      Observations given{.name = "x", .quantity = "x"};
      for (const auto& values : sets)
        given.groups.push_back({std::string(1, static_cast<char>('A' + given.groups.size())), values});
      for (std::size_t i = 0; in_blocks && i < sets[0].size(); ++i) given.blocks.push_back(std::to_string(i));
      const auto p_at = [&](double level) {
        std::vector<std::string> all;
        for (const Finding& pair : evidence(given, {.significance = level}).contrasts)
          all.push_back(std::to_string(pair.p));
        return all;
      };
      for (const double level : {0.01, 0.12, 0.4}) CHECK(p_at(level) == p_at(0.05));
    }
  }
}

TEST_CASE("two small groups are told apart by the exact test alone", "[assessment]") {
  const Observations three{.name = "x", .quantity = "x", .groups = {{"A", {1, 2, 3}}, {"B", {4, 5, 6}}}};
  const Evidence found = evidence(three, {.test = "kruskal_wallis"});
  CHECK(found.contrasts[0].p == Approx(0.1));  // Mann-Whitney, exact: 2 of 20 arrangements
  CHECK(found.contrasts[0].relation == Relation::undecided);
}

TEST_CASE("groups of one value each differ as far as Fisher's exact test says", "[assessment]") {
  const auto constants = [](std::size_t n) {
    return Observations{.name = "x",
                        .quantity = "x",
                        .groups = {{"A", std::vector<double>(n, 1.0)}, {"B", std::vector<double>(n, 2.0)}}};
  };
  CHECK(evidence(constants(2), {}).contrasts[0].p == Approx(1.0 / 3));  // 2 of 6 arrangements
  CHECK(evidence(constants(2), {}).contrasts[0].relation == Relation::undecided);
  CHECK(evidence(constants(20), {}).contrasts[0].relation == Relation::better);
}

TEST_CASE("in blocks, what decides, its p, its interval and its words go together", "[assessment]") {
  CHECK(evidence(demsar(), {.test = "tamhane"}).method->interval.starts_with("Tamhane"));
  const Evidence by_ranks = evidence(demsar(), {.test = "kruskal_wallis"});
  CHECK(by_ranks.contrasts[0].p > 0.5);  // the ranks of all values together, whatever the blocks
  CHECK(evidence(demsar(), {}).method->interval == "studentized bootstrap of the differences within blocks");
}

TEST_CASE("equivalence does not depend on the order of the groups", "[assessment]") {
  const std::vector<double> a{1, 2, 3, 4, 5, 6}, b{2, 3, 5, 4, 6, 8};
  const Observations one{.name = "x", .quantity = "x", .groups = {{"a", a}, {"b", b}}};
  const Observations other{.name = "x", .quantity = "x", .groups = {{"b", b}, {"a", a}}};
  CHECK(evidence(one, {.margin = 0.9}).contrasts[0].relation == evidence(other, {.margin = 0.9}).contrasts[0].relation);
}

TEST_CASE("two hundred groups are compared with the best, corrected for all pairs", "[assessment]") {
  Observations many{.name = "x", .quantity = "x"};
  for (int i = 0; i < 200; ++i) {
    many.groups.push_back(
        {fmt::format("group {}", i), {1.0 + i, 2.0 + i, 3.5 + i, 2.5 + i, 1.5 + i, 3.0 + i, 2.2 + i, 1.7 + i}});
  }
  const Evidence found = evidence(many, {});
  CHECK(found.pairs == 19900);
  CHECK(found.reference == 0u);
  CHECK(found.contrasts.size() == 199);
  CHECK(found.contrasts.back().relation == Relation::better);
}

TEST_CASE("names from anywhere stay within the JSON, and numbers that are not defined are null", "[assessment]") {
  Observations odd = plant_growth();
  odd.groups[0].name = "a\"b\\<script>\n\xff";
  odd.groups[1].values = {1};
  const auto json = nlohmann::json::parse(assess(odd, {}).json);
  CHECK(json["groups"].size() == 3);
  CHECK(json["groups"][1]["sd"].is_null());
}
