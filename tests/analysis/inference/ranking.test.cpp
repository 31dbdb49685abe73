#include "analysis/inference/ranking.hpp"

#include <cmath>

#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::inference;

TEST_CASE("a ranking begins with the smallest mean and ends with those that are not finite", "[ranking]") {
  CHECK(order_words(ranked({{"A", 3}, {"B", NAN}, {"C", 1}, {"D", INFINITY}})) == "C, A, B = D");
}

TEST_CASE("means that are equal to the bit are written as equal, and others as an order", "[ranking]") {
  CHECK(order_words(ranked({{"A", 2}, {"B", 2}, {"C", 2}})) == "A = B = C");
  CHECK(order_words(ranked({{"A", 2}, {"B", 1}, {"C", 2}})) == "B, A = C");
  CHECK(order_words(ranked({{"A", std::nextafter(2, 3)}, {"B", 2}})) == "B, A");
  CHECK(order_words({}).empty());
}

TEST_CASE("equal means share a place, and the next place is behind all of them", "[ranking]") {
  const std::vector<RankedSolver> all{{"A", 2}, {"B", 1}, {"C", 2}, {"D", 3}};
  const auto is = [&](std::size_t i, int place, bool shared) {
    const Placing found = placing_of(all[i], all);
    CHECK(found.place == place);
    CHECK(found.shared == shared);
  };
  is(0, 2, true);
  is(1, 1, false);
  is(2, 2, true);
  is(3, 4, false);
}
