#include "analysis/inference/ranking.hpp"

#include <cmath>

#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::inference;

namespace {

const std::vector<RankedSolver> printed = ranked({{"A", 1}, {"B", 2}, {"C", 3}});

}  // namespace

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

TEST_CASE("a first place that is shared is said to be", "[ranking]") {
  CHECK(first_words(printed) == "A");
  CHECK(first_of(ranked({{"A", 2}, {"B", 1}, {"C", 1}})) == std::vector<std::string>{"B", "C"});
  CHECK(first_words(ranked({{"A", 2}, {"B", 1}, {"C", 1}})) == "B and C (tied)");
  CHECK(first_words(ranked({{"A", 1}, {"B", 1}, {"C", 1}})) == "A, B and C (tied)");
}

TEST_CASE("a tied pair counts neither for the printed order nor against it", "[ranking]") {
  const auto words = [](double a, double b, double c) {
    return printed_order_words(compare_pairs(printed, ranked({{"A", a}, {"B", b}, {"C", c}})));
  };
  CHECK(words(1, 2, 3) == "3 of 3 pairs rank as in the paper");
  CHECK(words(3, 2, 1) == "0 of 3 pairs rank as in the paper");
  CHECK(words(1, 1, 2) == "2 of 3 pairs rank as in the paper, 1 is tied");
  CHECK(words(1, 1, 1) == "0 of 3 pairs rank as in the paper, 3 are tied");
  const PairOrder of_tied = compare_pairs(ranked({{"A", 1}, {"B", 1}, {"C", 2}}), printed);
  CHECK(of_tied.pairs == 2);  // the paper does not order A and B
  CHECK(of_tied.same == 2);
}
