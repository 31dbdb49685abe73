#include "analysis/statistics/ranks.hpp"

#include <cmath>

#include "analysis/statistics/multiple_comparisons.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::statistics;

TEST_CASE("equal values share the mean of their ranks", "[ranks]") {
  const Ranking ranking = midranks(std::vector<double>{30, 10, 20, 10, 30, 30});  // 10 10 20 30 30 30
  CHECK(ranking.ranks == std::vector<double>{5, 1.5, 3, 1.5, 5, 5});
  CHECK(ranking.ties == std::vector<std::size_t>{2, 3});
  CHECK(ranking.tie_sum() == 6 + 24);  // 8 - 2 and 27 - 3
}

TEST_CASE("infinite values are ranked as any other, and equal ones are ties", "[ranks]") {
  const Ranking ranking = midranks(std::vector<double>{HUGE_VAL, 1e308, -HUGE_VAL, HUGE_VAL});
  CHECK(ranking.ranks == std::vector<double>{3.5, 2, 1, 3.5});
  CHECK(ranking.ties == std::vector<std::size_t>{2});
}

TEST_CASE("minus zero is zero", "[ranks]") { CHECK(midranks(std::vector<double>{0.0, -0.0}).ties.size() == 1); }

TEST_CASE("what is not a number has no rank, and then no value has", "[ranks]") {
  const Ranking ranking = midranks(std::vector<double>{1, NAN, 2});
  CHECK(ranking.ranks.empty());
  CHECK(ranking.undefined.find("not a number") != std::string::npos);
}

TEST_CASE("no values have no ranks, which is no mistake", "[ranks]") {
  CHECK(midranks({}).ranks.empty());
  CHECK(midranks({}).undefined.empty());
  CHECK(midranks({}).tie_sum() == 0);
}

TEST_CASE("three groups make three pairs", "[ranks]") {
  const auto all = pairs_of(3);
  REQUIRE(all.size() == 3);
  CHECK((all[1].first == 0 && all[1].second == 2));
  CHECK((all[2].first == 1 && all[2].second == 2));
  CHECK(pairs_of(0).empty());
  CHECK(pairs_of(1).empty());
}
