// A repetition of our study, beside the printed numbers of the paper.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "analysis/inference/make_study.hpp"
#include "analysis/slim2023/paper_tables.hpp"
#include "analysis/statistics/predictive_study.hpp"
#include "tests/analysis/cells.hpp"
#include "tests/analysis/synthetic.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::statistics;
using namespace ikbench::inference;
using namespace ikbench::report;
using namespace ikbench::slim2023;

namespace {

// IK-BA with that error in run 1 and 3 times as much in run 2.
StudyResults study_with(double error_cm) {
  std::vector<SolveRecord> solves = synthetic::solves({.solvers = {"IK-BA"}, .runs = 2});
  for (SolveRecord& solve : solves) solve.position_error_cm = solve.run == 1 ? error_cm : 3 * error_cm;
  StudyResults study = make_study("s", std::move(solves));
  study.facts.published = "slim2023";
  return study;
}

// Seeds 1 to 50; of seed s two runs of (s - 0.5) and (s + 0.5) times so much: their mean is s times as much, and their
// standard deviation sqrt(1/2) of it, whatever the seed.
std::vector<RepeatedSolver> repetitions_of(double unit) {
  RepeatedSolver solver{.label = "IK-BA", .error_cm = {}, .variation_deg = {}};
  for (int seed = 1; seed <= 50; ++seed) {
    solver.error_cm.push_back({unit * (seed - 0.5), unit * (seed + 0.5)});
    solver.variation_deg.push_back({87, 88});
  }
  return {solver};
}

const Agreement& of(const std::vector<Agreement>& all, Metric metric, const std::string& statistic) {
  const auto found = std::ranges::find_if(
      all, [&](const Agreement& each) { return each.metric == metric && each.statistic == statistic; });
  REQUIRE(found != all.end());
  return *found;
}

}  // namespace

TEST_CASE("the predictive interval of one more value is by order statistics", "[agreement]") {
  std::vector<double> values(50);
  std::iota(values.begin(), values.end(), 1);
  std::ranges::reverse(values);
  // 0.025 x 51 = 1.275 and 0.975 x 51 = 49.725; R: quantile(1:50, c(0.025, 0.975), type = 6).
  const auto [value, low, high] = predictive_interval(values, 0.95);
  CHECK(low == Approx(1.275));
  CHECK(high == Approx(49.725));
  // The outermost of 39 values: each is passed by one in 40.
  values.resize(39);
  std::iota(values.begin(), values.end(), 1);
  CHECK(predictive_interval(values, 0.95).low == Approx(1));
  CHECK(predictive_interval(values, 0.95).high == Approx(39));
}

TEST_CASE("of 100 seeds the predictive interval of 50 holds the 95 that it says", "[agreement]") {
  // 2000 times 50 and one more, of an asymmetric distribution; three standard errors of a share of 0.95 are 0.015.
  synthetic::Noise noise;
  int inside = 0;
  for (int i = 0; i < 2000; ++i) {
    std::vector<double> values;
    for (int k = 0; k < 50; ++k) values.push_back(-std::log(1 - noise.next()));
    const double next = -std::log(1 - noise.next());
    const auto [value, low, high] = predictive_interval(values, 0.95);
    inside += low <= next && next <= high ? 1 : 0;
  }
  CHECK(inside / 2000.0 == Approx(0.95).margin(0.015));
}

TEST_CASE("a printed number is as expected inside the range of repetitions, up to its rounding", "[agreement]") {
  // Printed of IK-BA: mean 0.0019, std 1.7824e-4 cm. Means of the seeds: 1e-4 to 50e-4, range 1.275e-4 to 49.725e-4.
  const auto wide = agreements(study_with(0.001), repetitions_of(1e-4));
  CHECK(wide.size() == 10);  // five statistics of two metrics
  const Agreement& mean = of(wide, Metric::position_error_cm, "mean");
  CHECK(mean.printed == "0.0019");
  CHECK(mean.ours == Approx(0.002));
  CHECK(mean.ratio == Approx(0.002 / 0.0019));
  CHECK(mean.expected.low == Approx(1.275e-4));
  CHECK(mean.expected.high == Approx(49.725e-4));
  CHECK(mean.is_expected);
  CHECK(words_of(mean).empty());
  // All standard deviations are 7.07e-5: printed 1.7824e-4 is beyond.
  const Agreement& std = of(wide, Metric::position_error_cm, "std");
  CHECK(!std.is_expected);
  CHECK(words_of(std) == "7.9 times, outside our range 7.07e-05 to 7.07e-05");  // ours sqrt(2) x 0.001

  // A range from 0.00194 on: printed 0.0019 may have been 0.00195, and from 0.0022 on it may not.
  CHECK(of(agreements(study_with(0.001), repetitions_of(0.00194 / 1.275)), Metric::position_error_cm, "mean")
            .is_expected);
  const auto beyond = agreements(study_with(0.001), repetitions_of(0.0022 / 1.275));
  CHECK(words_of(of(beyond, Metric::position_error_cm, "mean")) == "1.1 times, outside our range 0.0022 to 0.0858");
}

TEST_CASE("the range beside a printed number has enough digits to tell them apart", "[agreement]") {
  Agreement just_beyond{.solver = "A", .metric = Metric::position_error_cm, .statistic = "std"};
  just_beyond.printed = "1.7824e-4";
  just_beyond.ratio = 0.98;
  just_beyond.expected = {.value = 1.5e-4, .low = 9.9e-5, .high = 1.7803e-4};
  CHECK(words_of(just_beyond) == "0.98 times, outside our range 9.9e-05 to 0.00017803");
}

TEST_CASE("a printed number outside our range is near if ours is less than 1.5 times as much or as little",
          "[agreement]") {
  // Printed of IK-BA: mean 0.0019; ours is twice the error of run 1, and the range begins far above.
  const auto nearness = [](double error_cm) {
    return std::get<OursAndPrinted>(table_3(study_with(error_cm), repetitions_of(1)).rows[0][2]).nearness;
  };
  CHECK(nearness(0.0014) == Nearness::near);  // 0.0028 / 0.0019 = 1.47
  CHECK(nearness(0.0015) == Nearness::far);   // 1.58
  CHECK(nearness(0.0007) == Nearness::near);  // 0.74
  CHECK(nearness(0.0006) == Nearness::far);   // 0.63
}

TEST_CASE("Table 3 has our numbers beside the printed digits, and a word where they do not agree", "[agreement]") {
  const auto repetitions = repetitions_of(1e-4);
  const Table table = table_3(study_with(0.001), repetitions);
  REQUIRE(table.rows.size() == 3);  // error, variation and time of IK-BA
  CHECK(readable(table.rows[0][2]) == "0.002 (printed 0.0019)");
  CHECK(readable(table.rows[0][4]) == "0.00141 (printed 1.7824e-4: 7.9 times, outside our range 7.07e-05 to 7.07e-05)");
  CHECK(readable(table.rows[1][5]).find("(printed 101.8740: ") != std::string::npos);
  CHECK(std::get<OursAndPrinted>(table.rows[0][2]).nearness == Nearness::within);
  CHECK(std::get<OursAndPrinted>(table.rows[0][4]).nearness == Nearness::far);
  CHECK(std::get<OursAndPrinted>(table.rows[2][2]).nearness == Nearness::unknown);  // another machine's time
  CHECK(has_note(table, "4 of 10 printed errors and variations lie where 95 % of our repetitions do"));
  CHECK(has_note(table, "Of our own 10 numbers, which are those of one seed, "));
  CHECK(readable(table_3(study_with(0.001)).rows[0][4]) == "0.00141 (printed 1.7824e-4)");
  CHECK(agreements(make_study("own", synthetic::solves({.solvers = {"IK-BA"}})), repetitions).empty());
  CHECK(agreement_sentence({}).empty());
}
