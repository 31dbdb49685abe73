// "The same within 5 %" is a finding, and takes as many observations as any other.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "analysis/report/assessment.hpp"
#include "tests/analysis/synthetic.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::inference;
using namespace ikbench::report;

namespace {

Observations with(std::vector<std::vector<double>> values) {
  Observations observations{.name = "x", .quantity = "x"};
  for (std::size_t i = 0; i < values.size(); ++i) {
    observations.groups.push_back({fmt::format("g{}", i), std::move(values[i])});
  }
  return observations;
}

Observations in_blocks(std::vector<std::vector<double>> values) {
  Observations observations = with(std::move(values));
  observations.block = "a problem";
  for (std::size_t i = 0; i < observations.groups[0].values.size(); ++i) {
    observations.blocks.push_back(fmt::format("{}", i));
  }
  return observations;
}

bool is_same(const Evidence& found) { return found.contrasts.at(0).relation == Relation::same; }

bool any_is_the_same(const Evidence& found) {
  return std::ranges::any_of(found.contrasts, [](const Finding& c) { return c.relation == Relation::same; });
}

}  // namespace

TEST_CASE("equal values are the same within the margin where so many are not equal by chance",
          "[assessment][equivalence]") {
  // All of the one on one side and all of the other on the other: 2 of 6, 20 and 70 arrangements.
  const Evidence two = evidence(with({{7, 7}, {7, 7}}), {});
  CHECK(two.contrasts[0].relation == Relation::undecided);
  CHECK(two.contrasts[0].p == 1);
  CHECK(std::isnan(two.contrasts[0].size.high));
  CHECK_FALSE(is_same(evidence(with({{7, 7, 7}, {7, 7, 7}}), {})));
  CHECK(is_same(evidence(with({{7, 7, 7, 7}, {7, 7, 7, 7}}), {})));
  // Three groups make three pairs: 3 * 2 / 70 is not below 0.05, 3 * 2 / 252 is.
  CHECK_FALSE(is_same(evidence(with({{7, 7, 7, 7}, {7, 7, 7, 7}, {2, 2, 2, 2}}), {})));
  CHECK(is_same(evidence(with({{7, 7, 7, 7, 7}, {7, 7, 7, 7, 7}, {2, 2, 2, 2, 2}}), {})));
  // Nor is a difference that is not found a small one.
  CHECK(std::isnan(evidence(with({{100, 100}, {101, 101}}), {}).contrasts[0].size.high));
  CHECK(evidence(with({{100, 100, 100, 100}, {101, 101, 101, 101}}), {}).contrasts[0].is_within_margin());
}

TEST_CASE("what is equal in every block is the same where there are enough blocks", "[assessment][equivalence]") {
  // n differences have one sign, or none, by chance 2 / 2^n; of three pairs, three times that.
  const auto equal_in = [](std::size_t blocks) {
    std::vector<double> one, other;
    for (std::size_t i = 0; i < blocks; ++i) {
      one.push_back(10.0 + static_cast<double>(i));
      other.push_back(40.0 - 3 * static_cast<double>(i));
    }
    return evidence(in_blocks({one, one, other}), {});
  };
  CHECK_FALSE(is_same(equal_in(2)));
  CHECK_FALSE(is_same(equal_in(6)));  // 6 / 64
  CHECK(is_same(equal_in(7)));        // 6 / 128

  const auto two_equal_in = [](std::size_t blocks) {
    std::vector<double> values;
    for (std::size_t i = 0; i < blocks; ++i) values.push_back(10.0 + static_cast<double>(i));
    return evidence(in_blocks({values, values}), {});
  };
  CHECK(two_equal_in(5).contrasts[0].relation == Relation::undecided);  // 2 / 32
  CHECK(is_same(two_equal_in(6)));                                      // 2 / 64
  CHECK(two_equal_in(6).contrasts[0].p == 1);
  CHECK_FALSE(is_same(evidence(in_blocks({{7, 7, 7, 7, 7}, {7, 7, 7, 7, 7}}), {})));  // constants too
  CHECK(is_same(evidence(in_blocks({{7, 7, 7, 7, 7, 7}, {7, 7, 7, 7, 7, 7}}), {})));
}

TEST_CASE("shares that are all 1 are the same only where so many exclude that a margin of them fails",
          "[assessment][equivalence]") {
  const auto all_succeed = [](std::size_t n, AnalysisPlan plan = {}) {
    return evidence(with({std::vector<double>(n, 1.0), std::vector<double>(n, 1.0)}), plan);
  };
  CHECK_FALSE(is_same(all_succeed(4)));
  CHECK_FALSE(is_same(all_succeed(58)));            // 0.95^58 = 0.0510
  CHECK(is_same(all_succeed(59)));                  // 0.95^59 = 0.0485
  CHECK(is_same(all_succeed(6, {.margin = 0.4})));  // 0.6^6 = 0.0467
  CHECK_FALSE(is_same(all_succeed(5, {.margin = 0.4})));
  const Finding open = all_succeed(10).contrasts[0];
  CHECK(open.p == 1);
  CHECK(open.estimate.high == Approx(1 - std::pow(0.05, 0.1)));
  CHECK(open.estimate.low == -open.estimate.high);
  std::vector<double> failures(100, 0.0);  // of none, no margin is a share
  CHECK_FALSE(is_same(evidence(with({failures, failures}), {})));
  // In blocks the third group makes them outcomes of 0 and 1; the first two agree in each.
  const auto agree_in = [](std::size_t blocks) {
    std::vector<double> half(blocks, 1.0);
    std::fill_n(half.begin(), blocks / 2, 0.0);
    return evidence(in_blocks({half, half}), {.margin = 0.4});
  };
  CHECK_FALSE(is_same(agree_in(4)));
  CHECK(is_same(agree_in(30)));
}

TEST_CASE("groups whose means differ by more than the margin are rarely called the same, however few and tied",
          "[assessment][equivalence]") {
  // Six groups with the values 1 and 2, whose means are 1.1, 1.2, ... 1.6: each pair is more than 6 % apart, so each
  // "same" is wrong. Simultaneous statements at 0.05 are wrong in at most 5 % of the sets; of 400 sets in at most 20
  // but for chance, whose standard deviation is sqrt(400 * 0.05 * 0.95) = 4.4: four of them are 18.
  synthetic::Noise noise;
  const int sets = 400;
  for (const bool blocked : {false, true}) {
    int wrong = 0;
    for (int set = 0; set < sets; ++set) {
      std::vector<std::vector<double>> values(6);
      for (std::size_t group = 0; group < values.size(); ++group) {
        const double share = 0.1 * static_cast<double>(group + 1);
        for (int i = 0; i < 2; ++i) values[group].push_back(noise.next() < share ? 2 : 1);
      }
      wrong += any_is_the_same(evidence(blocked ? in_blocks(values) : with(values), {})) ? 1 : 0;
    }
    CAPTURE(blocked);
    CHECK(wrong <= 20 + 18);
  }
}

TEST_CASE("what equals a known value is the same where so many runs are not equal to it by chance",
          "[assessment][equivalence]") {
  const auto against_known = [](std::vector<double> values, double known) {
    Observations observed = with({{known}, std::move(values)});
    observed.groups[0].copies = 20;
    return evidence(observed, {}).contrasts.at(0);
  };
  // The sign test: 2 * 2^-5 = 0.0625, 2 * 2^-6 = 0.03125.
  CHECK(against_known(std::vector<double>(5, 7.0), 7).relation == Relation::undecided);
  CHECK(against_known(std::vector<double>(6, 7.0), 7).relation == Relation::same);
  // What may be a share needs as many runs as exclude failures beyond the margin: 0.95^59 < 0.05.
  CHECK(against_known(std::vector<double>(58, 1.0), 1).relation == Relation::undecided);
  CHECK(against_known(std::vector<double>(59, 1.0), 1).relation == Relation::same);
  const Finding around = against_known({6, 6.5, 7.5, 8, 9, 9.5}, 7);
  CHECK(around.relation == Relation::undefined);
  CHECK(std::string_view(around.why).find("not all on one side") != std::string_view::npos);
}

TEST_CASE("runs on one side of a known value are undecided if they are too few", "[assessment]") {
  for (const std::string test : {"bootstrap", "tamhane"}) {
    Observations observed = with({{7}, {8, 8.5, 9.5}, {7}});
    observed.groups[0].copies = observed.groups[2].copies = 20;
    const Finding few = evidence(observed, {.test = test}).contrasts.at(0);
    CHECK(few.relation == Relation::undecided);
    CHECK(few.p_alone == Approx(0.25));  // 2 * 2^-3
    CHECK(few.p == Approx(0.75));        // Bonferroni, three pairs
  }
}

TEST_CASE("typical values near 1 are not kept apart by rounding", "[assessment][equivalence]") {
  std::vector<double> below, above;
  for (int i = 0; i < 10; ++i) {
    below.push_back(std::log10(i % 2 == 0 ? 1 : 1 - 0x1p-53));
    above.push_back(std::log10(i % 2 == 0 ? 1 : 1 + 0x1p-52));
  }
  Observations observed = with({below, above});
  observed.scale = ValueScale::log10;
  CHECK(is_same(evidence(observed, {})));
}
