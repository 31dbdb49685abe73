#include "experiments/halving.hpp"

#include <limits>
#include <utility>
#include <vector>

#include "tests/catch.hpp"

using namespace ikbench::experiments;

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

std::vector<std::pair<std::size_t, int>> pairs(const std::vector<HalvingRound>& rounds) {
  std::vector<std::pair<std::size_t, int>> all;
  for (const HalvingRound& round : rounds) all.emplace_back(round.candidates, round.runs);
  return all;
}

using Pairs = std::vector<std::pair<std::size_t, int>>;
using Standings = std::vector<Standing>;

}  // namespace

TEST_CASE("halving spends a budget on ever fewer candidates with ever more runs", "[halving]") {
  // Eight candidates: 8 x 1, 4 x (2 - 1) and 2 x (4 - 2) runs are 16. Of ten points: 160 solves.
  CHECK(pairs(halving_rounds(8, 10, 160)) == Pairs{{8, 1}, {4, 2}, {2, 4}});
  CHECK(pairs(halving_rounds(8, 10, 479)) == Pairs{{8, 2}, {4, 4}, {2, 8}});
  CHECK(pairs(halving_rounds(8, 10, 480)) == Pairs{{8, 3}, {4, 6}, {2, 12}});
  CHECK(pairs(halving_rounds(5, 1, 12)) == Pairs{{5, 1}, {3, 2}, {2, 4}});  // 5 + 3 + 4
  CHECK(pairs(halving_rounds(2, 20, 1000)) == Pairs{{2, 25}});
}

TEST_CASE("halving never exceeds its budget, and uses more than half of it", "[halving]") {
  for (std::size_t candidates = 2; candidates <= 200; ++candidates) {
    for (const std::int64_t budget : {50, 1000, 123'456}) {
      const auto rounds = halving_rounds(candidates, 7, budget);
      if (rounds.empty()) {
        CHECK(budget < static_cast<std::int64_t>(7 * candidates * 10));
        continue;
      }
      CHECK(solves_of(rounds, 7) <= budget);
      CHECK(2 * solves_of(rounds, 7) > budget);
      CHECK(rounds.front().candidates == candidates);
      CHECK(rounds.back().candidates == 2);
    }
  }
}

TEST_CASE("halving needs two candidates and a run of each, and no study has more than a million runs", "[halving]") {
  CHECK(halving_rounds(0, 10, 1000).empty());
  CHECK(halving_rounds(1, 10, 1000).empty());
  CHECK(halving_rounds(8, 10, 159).empty());
  CHECK(halving_rounds(8, 1, std::numeric_limits<std::int64_t>::max()).back().runs == 1'000'000);
}

TEST_CASE("the better half has the smaller values, then the fewer evaluations, then the first", "[halving]") {
  CHECK(better_half(Standings{{3, 0}, {1, 0}, {2, 0}, {4, 0}}) == std::vector<std::size_t>{1, 2});
  CHECK(better_half(Standings{{3, 0}, {1, 0}, {2, 0}}) == std::vector<std::size_t>{1, 2});
  CHECK(better_half(Standings{{1, 9}, {1, 5}, {1, 7}, {1, 5}}) == std::vector<std::size_t>{1, 3});
  CHECK(better_half(Standings{{unknown, 0}, {1e300, 0}}) == std::vector<std::size_t>{1});
  CHECK(better_half(Standings{{unknown, 0}, {unknown, 0}, {unknown, unknown}}) == std::vector<std::size_t>{0, 1});
  CHECK(better_half(Standings{{0, unknown}, {0, 1}}) == std::vector<std::size_t>{1});
  CHECK(better_half(Standings{}).empty());
}
