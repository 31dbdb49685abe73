// Pairs by ranks: found where they differ, whoever else takes part, and rarely where they do not.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "analysis/inference/evidence.hpp"
#include "analysis/report/assessment.hpp"
#include "analysis/statistics/mann_whitney.hpp"
#include "tests/analysis/synthetic.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::inference;
using namespace ikbench::statistics;

namespace {

using Sets = std::vector<std::vector<double>>;

Observations named_sets(Sets values) {
  Observations observations{.name = "x", .quantity = "x"};
  for (std::size_t i = 0; i < values.size(); ++i) {
    observations.groups.push_back({fmt::format("g{}", i), std::move(values[i])});
  }
  return observations;
}

const AnalysisPlan by_ranks{.test = "kruskal_wallis"};

bool any_differs(const Evidence& found) { return std::ranges::any_of(found.contrasts, is_decided); }

}  // namespace

TEST_CASE("twenty values that are all below twenty others are found among six groups", "[pair_ranks]") {
  Sets values(6);
  for (int i = 0; i < 120; ++i) values[static_cast<std::size_t>(i / 20)].push_back(i);
  const Evidence found = evidence(named_sets(values), by_ranks);
  const Finding& pair = found.contrasts[0];
  CHECK(pair.superiority.value == 1);
  CHECK(pair.relation == Relation::better);
  // 2 of 40! / 20!^2 = 137846528820 arrangements, times 15 pairs: Holm's smallest, which all fifteen share.
  CHECK(pair.p == Approx(30.0 / 137846528820).epsilon(1e-9));
}

TEST_CASE("the p of two groups alone does not depend on the others", "[pair_ranks]") {
  const std::vector<double> a{1, 4, 2, 8, 5, 7, 3.5, 9}, b{2.5, 6, 9.5, 8.5, 7.5, 11, 5.5, 10};
  const std::vector<double> low{0, .1, .2, .3, .4, .5, .6, .7}, between{4.5, 4.6, 4.7, 4.8, 4.9, 5.1, 5.2, 5.3};
  const auto p_of = [&](Sets values) { return evidence(named_sets(std::move(values)), by_ranks).contrasts[0].p_alone; };
  const double alone = p_of({a, b});
  CHECK(alone < 0.3);
  CHECK(p_of({a, b, low}) == alone);
  CHECK(p_of({a, b, between}) == alone);
}

TEST_CASE("a pair that cannot be tested still counts among those that p is corrected for", "[pair_ranks]") {
  const Sets values{{1, 2, 3, 4, 5, 6, 7}, {8, 9, 10, 11, 12, 13, 14}, {}};
  const Evidence found = evidence(named_sets(values), by_ranks);
  CHECK(found.contrasts[0].p == Approx(3 * 2.0 / 3432));  // 14! / 7!^2 = 3432 arrangements
  CHECK(found.contrasts[1].relation == Relation::undefined);
}

TEST_CASE("where no outcome of so few observations could differ, it is said", "[pair_ranks]") {
  const auto says = [](const Evidence& found, const std::string& words) {
    std::string text;
    for (const std::string& sentence : report::words_of(report::sentences_of(found))) text += sentence + '\n';
    INFO(text);
    return text.find(words) != std::string::npos;
  };
  // Three pairs of four values: 3 * 2 / 70 > 0.05; of five 3 * 2 / 252 is below.
  const Sets four{{1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11, 12}};
  CHECK(says(evidence(named_sets(four), by_ranks), "It takes at least 5 observations per group, and here are 4."));
  Sets five = four;
  for (std::size_t i = 0; i < 3; ++i) five[i].push_back(5.0 + 4 * static_cast<double>(i) - 0.5);
  CHECK_FALSE(says(evidence(named_sets(five), by_ranks), "It takes at least"));
  CHECK(any_differs(evidence(named_sets(five), by_ranks)));
}

TEST_CASE("groups that differ in spread alone are rarely called better by ranks", "[pair_ranks]") {
  // Four groups of values around 0, symmetric, with spreads of 1, 2, 4 and 8; sizes that favour a false finding, the
  // most variable being the smallest. A wrong word at 0.05 may be in 5 % of 400 sets, 20, with a standard deviation
  // of 4.4; four of them are 18.
  synthetic::Noise noise;
  const auto symmetric = [&] { return noise.next() + noise.next() - noise.next() - noise.next(); };
  int wrong = 0, wrong_by_mann_whitney = 0;
  for (int set = 0; set < 400; ++set) {
    Sets values(4);
    for (std::size_t group = 0; group < 4; ++group) {
      for (std::size_t i = 0; i < 40 - 8 * group; ++i) {
        values[group].push_back(std::exp2(static_cast<double>(group)) * symmetric());
      }
    }
    const Evidence found = evidence(named_sets(values), by_ranks);
    wrong += any_differs(found) ? 1 : 0;
    const auto differ = [&](const Finding& pair) {
      return 6 * mann_whitney(values[pair.first], values[pair.second]).p < 0.05;  // six pairs, by Bonferroni
    };
    wrong_by_mann_whitney += std::ranges::any_of(found.contrasts, differ) ? 1 : 0;
  }
  CHECK(wrong <= 20 + 18);
  CHECK(wrong_by_mann_whitney > wrong);  // what Brunner and Munzel's is for
}

TEST_CASE("ties do not make ranks call the same what differs", "[pair_ranks]") {
  // The typical ratio is 1, with an interval from 1 to 1; but five of forty values are a hundred times as large.
  Sets values{std::vector<double>(40, 1.0), std::vector<double>(40, 1.0)};
  values[0][0] = 2;
  for (std::size_t i = 0; i < 5; ++i) values[1][i] = 100;
  const Finding pair = evidence(named_sets(values), by_ranks).contrasts.front();
  CHECK(pair.relation == Relation::undecided);
  CHECK(pair.ratio.value == 1);
  CHECK(std::isnan(pair.ratio.low));
}
