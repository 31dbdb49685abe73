#include "analysis/statistics/interaction.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include "analysis/statistics/welch.hpp"
#include "tests/analysis/statistics/samples.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::statistics;

namespace {

// R's ToothGrowth (Crampton 1947): growth of teeth by supplement (OJ, VC) and dose (0.5, 1, 2).
const std::vector<std::vector<double>> tooth_growth{{15.2, 21.5, 17.6, 9.7, 14.5, 10, 8.2, 9.4, 16.5, 9.7},
                                                    {19.7, 23.3, 23.6, 26.4, 20, 25.2, 25.8, 21.2, 14.5, 27.3},
                                                    {25.5, 26.4, 22.4, 24.5, 24.8, 30.9, 26.4, 27.3, 29.4, 23},
                                                    {4.2, 11.5, 7.3, 5.8, 6.4, 10, 11.2, 11.2, 5.2, 7},
                                                    {16.5, 16.5, 15.2, 17.3, 22.5, 17.3, 13.6, 14.5, 18.8, 15.5},
                                                    {23.6, 18.5, 33.9, 25.5, 26.4, 32.5, 26.7, 21.5, 23.3, 29.5}};

using Table = std::vector<std::vector<double>>;

Table drawn(std::size_t cells, std::size_t values) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  Table table(cells, std::vector<double>(values));
  for (std::vector<double>& cell : table)
    for (double& value : cell) value = normal(random);
  return table;
}

}  // namespace

TEST_CASE("the interaction in ToothGrowth has the F of R, with fewer degrees of freedom", "[interaction]") {
  // R: summary(aov(len ~ supp * factor(dose), ToothGrowth)): supp:dose F 4.107, df 2 and 54, p 0.02186. Degrees of
  // freedom, p and corners by exact fractions from the definitions of Brunner, Dette and Munk.
  const Interaction found = interaction(tooth_growth, 3, Cells::independent, 0.95);
  CHECK(found.undefined == "");
  CHECK(found.statistic == Approx(4.106991094022519));
  CHECK(found.df == Approx(1.9822643097486128));
  CHECK(found.df_within == Approx(43.14239518123765));
  CHECK(found.p == Approx(0.02359031477958635));
  CHECK(found.corners.value == Approx(5.33));
  CHECK(found.corners.low == Approx(0.42445888170001567));
  CHECK(found.corners.high == Approx(10.235541118299984));
}

TEST_CASE("within blocks the interaction has the degrees of freedom of Greenhouse and Geisser", "[interaction]") {
  // The same numbers as if the rows were blocks, by exact fractions.
  const Interaction found = interaction(tooth_growth, 3, Cells::in_blocks, 0.95);
  CHECK(found.statistic == Approx(2.534342062733483));
  CHECK(found.df == Approx(1.8759956735077448));
  CHECK(found.df_within == Approx(16.883961061569703));
  CHECK(found.p == Approx(0.11154690346820245));
  CHECK(found.corners.value == Approx(5.33));
  CHECK(found.corners.low == Approx(-0.39166783082498213));
  CHECK(found.corners.high == Approx(11.051667830824982));
}

TEST_CASE("in a table of two by two F is the square of the t of the corners", "[interaction]") {
  const Table table = drawn(4, 6);
  for (const Cells are : {Cells::independent, Cells::in_blocks}) {
    const Interaction found = interaction(table, 2, are, 0.95);
    CHECK(found.df == Approx(1));
    const double at_edge = found.corners.low > 0 ? found.corners.low : found.corners.high;
    CHECK((found.p < 0.05) == (at_edge * found.corners.value < 0 || found.corners.low * found.corners.high > 0));
    const Interaction there = interaction(table, 2, are, 1 - found.p);  // the interval that just reaches 0
    CHECK(std::min(std::abs(there.corners.low), std::abs(there.corners.high)) < 1e-9);
  }
}

TEST_CASE("effects of rows, columns and blocks, the unit, and the order of factors change no interaction",
          "[interaction]") {
  const Table table = drawn(6, 5);
  for (const Cells are : {Cells::independent, Cells::in_blocks}) {
    const Interaction before = interaction(table, 3, are, 0.9);
    Table moved = table, turned(6);
    for (std::size_t c = 0; c < 6; ++c) {
      for (std::size_t i = 0; i < 5; ++i) {
        const double of_block = are == Cells::in_blocks ? static_cast<double>(i) : 0;
        moved[c][i] =
            1e150 * (table[c][i] + 3 * static_cast<double>(c / 3) - 2 * static_cast<double>(c % 3) + of_block);
      }
      turned[(c % 3) * 2 + c / 3] = table[c];
    }
    const Interaction after = interaction(moved, 3, are, 0.9), other = interaction(turned, 2, are, 0.9);
    CHECK(after.statistic == Approx(before.statistic));
    CHECK(after.p == Approx(before.p));
    CHECK(after.corners.low == Approx(1e150 * before.corners.low));
    CHECK(other.p == Approx(before.p));
    CHECK(other.corners.high == Approx(before.corners.high));
  }
}

TEST_CASE("without an interaction, p is below a level about as often as it says, also with unequal spreads",
          "[interaction]") {
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  for (const Cells are : {Cells::independent, Cells::in_blocks}) {
    int found = 0;
    constexpr int studies = 2000;
    for (int study = 0; study < studies; ++study) {
      Table table(6, std::vector<double>(8));
      for (std::size_t c = 0; c < 6; ++c)
        for (double& value : table[c]) value = static_cast<double>(c % 3) + (c == 0 ? 4 : 1) * normal(random);
      found += interaction(table, 3, are, 0.95).p < 0.05;
    }
    CHECK(found < 0.07 * studies);
    CHECK(found > 0.02 * studies);
  }
}

TEST_CASE("an interaction needs two levels of both factors, and spread", "[interaction]") {
  const auto reason = [](const Table& table, std::size_t columns) {
    const Interaction found = interaction(table, columns, Cells::independent, 0.95);
    CHECK(std::isnan(found.p));
    return ikbench::samples::numbered(found.undefined);
  };
  CHECK(reason({{1, 2}, {1, 2}}, 2) == "a factor has fewer than two levels");
  CHECK(reason({{1, 2}, {1, 2}}, 1) == "a factor has fewer than two levels");
  CHECK(reason({{1, 2}, {1, 2}, {3}, {4, 5}}, 2) == "group 3 has fewer than two values, so no spread");
  CHECK(reason({{1, 2}, {1, HUGE_VAL}, {3, 4}, {4, 5}}, 2) == "group 2 has values that are not finite");
  CHECK(reason({{1, 1}, {2, 2}, {3, 3}, {0.1, 0.1}}, 2) == "there is no spread to compare with");
  CHECK_THROWS_AS(interaction(Table{{1, 2}, {1, 2}, {1, 2}}, 2, Cells::independent, 0.95), std::invalid_argument);
  CHECK_THROWS_AS(interaction(Table{{1, 2}, {1, 2}, {1, 2}, {1}}, 2, Cells::in_blocks, 0.95), std::invalid_argument);
  CHECK_THROWS_AS(interaction(drawn(4, 3), 2, Cells::independent, 1), std::invalid_argument);
}
