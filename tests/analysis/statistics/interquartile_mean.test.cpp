#include "analysis/statistics/interquartile_mean.hpp"

#include <cmath>
#include <stdexcept>
#include <vector>

#include "tests/analysis/statistics/samples.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::statistics;
using namespace ikbench::samples;

namespace {

// Each value a run of its own on one target.
std::vector<Stratum> one_target(const std::vector<double>& values) {
  Stratum runs;
  for (const double value : values) runs.push_back({value});
  return {runs};
}

}  // namespace

TEST_CASE("the interquartile mean leaves a quarter out at either end, rounded down", "[interquartile_mean]") {
  CHECK(interquartile_mean(one_target({100, 1, 2, 3, -50, 4, 5, 6}), 0.95).estimate == 3.5);  // of 2 3 4 5
  CHECK(interquartile_mean(one_target({9, 1, 2, 3, 4}), 0.95).estimate == 3);                 // SciPy: trim_mean
  CHECK(interquartile_mean(one_target({1, 2, 6}), 0.95).estimate == 3);
  CHECK(interquartile_mean(one_target({7}), 0.95).estimate == 7);
}

TEST_CASE("a few failed runs leave the interquartile mean, a half does not", "[interquartile_mean]") {
  CHECK(interquartile_mean(one_target({1, 2, 3, HUGE_VAL}), 0.95).estimate == 2.5);
  CHECK(interquartile_mean(one_target({1, 2, 3, NAN}), 0.95).estimate == 2.5);
  const InterquartileMean lost = interquartile_mean(one_target({1, NAN, 3, HUGE_VAL}), 0.95);
  CHECK(std::isnan(lost.estimate));
  CHECK(says(lost.undefined, "not finite"));
}

TEST_CASE("the interval is that of the resamples", "[interquartile_mean]") {
  // Of two runs with 0 and 1 a resample has the mean 0, 1/2 or 1 with chances 1/4, 1/2 and 1/4.
  const InterquartileMean half = interquartile_mean(one_target({0, 1}), 0.4);
  CHECK(half.low == 0.5);
  CHECK(half.high == 0.5);
  const InterquartileMean wide = interquartile_mean(one_target({0, 1}), 0.6);
  CHECK(wide.low == 0);
  CHECK(wide.high == 1);
}

TEST_CASE("targets are drawn from one by one, so what sets them apart does not widen the interval",
          "[interquartile_mean]") {
  const std::vector<Stratum> targets{{{1}, {1}, {1}}, {{5}, {5}, {5}}, {{9}, {9}, {9}}, {{7}, {7}, {7}}};
  const InterquartileMean by_target = interquartile_mean(targets, 0.95);
  CHECK(by_target.estimate == 6);  // the middle six of 1 1 1 5 5 5 7 7 7 9 9 9
  CHECK(by_target.low == 6);
  CHECK(by_target.high == 6);
  const InterquartileMean mixed = interquartile_mean(one_target({1, 1, 1, 5, 5, 5, 9, 9, 9, 7, 7, 7}), 0.95);
  CHECK(mixed.low < 5.5);
  CHECK(mixed.high > 6.5);
}

TEST_CASE("the values of a run are drawn together", "[interquartile_mean]") {
  // Three runs of four alike values: as uncertain as three values, not as twelve.
  const std::vector<Stratum> runs{{{0, 0, 0, 0}, {6, 6, 6, 6}, {12, 12, 12, 12}}};
  const InterquartileMean found = interquartile_mean(runs, 0.9);
  CHECK(found.estimate == 6);
  CHECK(found.low <= 1);
  CHECK(found.high >= 11);
}

TEST_CASE("where the interquartile mean has no interval it says why", "[interquartile_mean]") {
  CHECK(says(interquartile_mean({}, 0.95).undefined, "no values"));
  const InterquartileMean single = interquartile_mean(std::vector<Stratum>{{{1, 2}}, {{3}}}, 0.95);
  CHECK(says(single.undefined, "only one run"));
  CHECK(single.estimate == 2);
  const InterquartileMean many = interquartile_mean(one_target(std::vector<double>(20'001, 1.0)), 0.95);
  CHECK(says(many.undefined, "more than 20000"));
  CHECK(many.estimate == 1);
  CHECK_THROWS_AS(interquartile_mean(one_target({1, 2}), 1), std::invalid_argument);
}
