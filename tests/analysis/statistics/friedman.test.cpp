#include <cmath>

#include "analysis/statistics/anova.hpp"
#include "analysis/statistics/ranks.hpp"
#include "tests/analysis/statistics/samples.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::statistics;
using namespace ikbench::samples;

namespace {

Groups transposed(const Groups& rows) {
  Groups columns(rows.front().size());
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) columns[i].push_back(row[i]);
  }
  return columns;
}

// Demsar 2006, Table 6: the AUC of C4.5, C4.5+m, C4.5+cf, C4.5+m+cf on 14 data sets; negated, for larger is better.
Groups demsar() {
  Groups groups = transposed({{.763, .768, .771, .798},
                              {.599, .591, .590, .569},
                              {.954, .971, .968, .967},
                              {.628, .661, .654, .657},
                              {.882, .888, .886, .898},
                              {.936, .931, .916, .931},
                              {.661, .668, .609, .685},
                              {.583, .583, .563, .625},
                              {.775, .838, .866, .875},
                              {1, 1, 1, 1},
                              {.940, .962, .965, .962},
                              {.619, .666, .614, .669},
                              {.972, .981, .975, .975},
                              {.957, .978, .946, .970}});
  for (auto& group : groups) {
    for (double& value : group) value = -value;
  }
  return groups;
}

const std::vector<double> published_ranks{3.142857, 2.000000, 2.892857, 1.964286};

}  // namespace

TEST_CASE("Friedman's test of the rounding times is that of R, ties and all", "[friedman]") {
  // R's help page of friedman.test (Hollander and Wolfe 1973, p. 140): 11.143, df 2, p 0.003805; rank sums 53 47 32.
  const RankTest test = friedman(
      transposed({{5.40, 5.50, 5.55}, {5.85, 5.70, 5.75}, {5.20, 5.60, 5.50}, {5.55, 5.50, 5.40}, {5.90, 5.85, 5.70},
                  {5.45, 5.55, 5.60}, {5.40, 5.40, 5.35}, {5.45, 5.50, 5.35}, {5.25, 5.15, 5.00}, {5.85, 5.80, 5.70},
                  {5.25, 5.20, 5.10}, {5.65, 5.55, 5.45}, {5.60, 5.35, 5.45}, {5.05, 5.00, 4.95}, {5.50, 5.50, 5.40},
                  {5.45, 5.55, 5.50}, {5.55, 5.55, 5.35}, {5.45, 5.50, 5.55}, {5.50, 5.45, 5.25}, {5.65, 5.60, 5.40},
                  {5.70, 5.65, 5.55}, {6.30, 6.30, 6.25}}));
  CHECK(test.mean_ranks[0] * 22 == Approx(53));
  CHECK(test.effect == Approx(78.0 / 7 / 44));
  CHECK(test.statistic == Approx(7.121739130434782).epsilon(1e-12));  // 21 chi2 / (44 - chi2)
  CHECK(test.df_within == 42);
}

TEST_CASE("Demsar's table gives his average ranks but for a tie that he ranked by unrounded values", "[friedman]") {
  // Row 13 prints .975 twice: his ranks are 2 and 3 where the table has 2.5 and 2.5, 0.5 / 14 of an average.
  Groups data = demsar();
  CHECK(friedman(data).mean_ranks[2] == Approx(2.892857 + 0.5 / 14));
  data[2][12] -= 1e-6;
  const RankTest test = friedman(data);
  for (std::size_t i = 0; i < 4; ++i) CHECK(test.mean_ranks[i] == Approx(published_ranks[i]).epsilon(1e-6));
  CHECK(test.df == 3);
  CHECK(test.df_within == 39);
  CHECK(test.statistic > 3.68631);
  CHECK(f_upper_tail(2.84507, 3, 39) == Approx(0.05).epsilon(1e-4));  // his critical value, 2.85
}

TEST_CASE("Demsar's critical differences are those of Nemenyi and of Bonferroni and Dunn", "[friedman]") {
  // q_alpha of four groups, Demsar 2006, Table 5, with more digits.
  CHECK(critical_difference(2.569032, 4, 14) == Approx(1.25356).epsilon(1e-5));
  CHECK(critical_difference(2.291341, 4, 14) == Approx(1.11806).epsilon(1e-5));
  CHECK(critical_difference(2.393980, 4, 14) == Approx(1.16814).epsilon(1e-5));  // qnorm(1 - 0.05 / 6)
  CHECK(std::isnan(critical_difference(2, 1, 14)));
  CHECK(std::isnan(critical_difference(2, 4, 0)));
}

TEST_CASE("where all blocks agree F is infinite and its p the chance of agreement", "[friedman]") {
  // Three groups, four blocks: W = 1, chi2 = 4 * 2; each of three blocks agrees with the first by 1 of 3! orders.
  const RankTest test = friedman(Groups{{1, 2, 3, 4}, {5, 6, 7, 8}, {9, 9, 9, 9}});
  CHECK(test.effect == 1);
  CHECK(std::isinf(test.statistic));
  CHECK(test.p == Approx(1.0 / 216));
  // With the first two equal in every block there are only 3 orders.
  CHECK(friedman(Groups{{1, 1, 1, 1}, {1, 1, 1, 1}, {9, 9, 9, 9}}).p == Approx(1.0 / 27));
}

TEST_CASE("blocks that cancel have W = 0", "[friedman]") {
  const RankTest test = friedman(Groups{{1, 2}, {2, 1}});
  CHECK(test.effect == Approx(0).margin(1e-15));
  CHECK(test.p == Approx(1));
  CHECK(test.statistic == Approx(0).margin(1e-15));
}

TEST_CASE("failed solves rank last in their block", "[friedman]") {
  CHECK(friedman(Groups{{HUGE_VAL, 1}, {2, 2}, {HUGE_VAL, 3}}).mean_ranks == std::vector<double>{1.75, 1.5, 2.75});
}

TEST_CASE("where there is no Friedman test it says why", "[friedman]") {
  const auto [groups, reason] = GENERATE_COPY(table<Groups, std::string>({{Groups{}, "no group"},
                                                                          {Groups{{1, 2}}, "one group"},
                                                                          {Groups{{}, {}}, "no block"},
                                                                          {Groups{{1}, {2}}, "one block"},
                                                                          {Groups{{1, 2}, {1}}, "one a block"},
                                                                          {Groups{{1, 2}, {1, NAN}}, "block 2"},
                                                                          {Groups{{1, 2}, {1, 2}}, "equal"}}));
  CAPTURE(reason);
  const RankTest test = friedman(groups);
  CHECK(says(test.undefined, reason));
  CHECK(std::isnan(test.p));
}
