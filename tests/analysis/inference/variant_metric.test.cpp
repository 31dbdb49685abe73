#include "analysis/inference/variant_metric.hpp"

#include <cmath>

#include "analysis/inference/variant_decision.hpp"
#include "tests/analysis/inference/variant_samples.hpp"
#include "tests/analysis/synthetic.hpp"
#include "tests/catch.hpp"
#include "tests/results/samples.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::statistics;
using namespace ikbench::inference;
using namespace ikbench::variant_samples;

TEST_CASE("a variant twice as far from its targets is worse, one half as far is better", "[variants]") {
  const Variant a = variant(about(1, 0.1)), b = variant(about(2, 0.2));
  const MetricComparison worse = error_of(a, b), better = error_of(b, a);
  CHECK(worse.outcome == Outcome::worse);
  CHECK(worse.ratio.ratio == Approx(2));
  CHECK(worse.p_worse < 1e-10);
  CHECK(worse.b_better.value == 0);  // every run of b is above every run of a
  CHECK(worse.remark.empty());
  CHECK(better.outcome == Outcome::better);
  CHECK(better.remark == "as far as 20 runs can show: a failure in up to 14 % of them is not excluded");
  CHECK(better.ratio.ratio == Approx(0.5));
  CHECK(better.b_better.value == 1);
}

TEST_CASE("of values that may be negative a share says nothing", "[variants]") {
  const std::vector<double> a{-0.2, 0.1, 0.3, 0.2}, b{0.2, 0.1, 0.3, 0.2};
  const std::vector<Metric> all = all_metrics();
  const auto limit_margin = std::ranges::find(all, "limit_margin", [](Metric metric) { return name_of(metric); });
  REQUIRE(limit_margin != all.end());
  const auto compare = [&](double margin) {
    return compare_metric({.metric = *limit_margin, .a = a, .b = b}, {.margin = margin});
  };
  CHECK(compare(0.05).outcome == Outcome::not_compared);
  CHECK(compare(0.05).remark.starts_with("negative values"));
  CHECK(compare(0).outcome != Outcome::not_compared);
}

TEST_CASE("a and b the other way round, what was worse is better", "[variants]") {
  synthetic::Noise noise;
  int decided = 0;
  for (int repetition = 0; repetition < 100; ++repetition) {
    std::vector<double> a, b;
    const double factor = std::exp(2 * noise.next() - 1);
    for (int run = 0; run < 8; ++run) {
      a.push_back(0.5 + noise.next());
      b.push_back(factor * (0.5 + noise.next()));
    }
    const auto is_drawn = repetition % 2 == 0 ? Change(draw_target) : Change();
    const MetricComparison there = error_of(variant(a, is_drawn), variant(b, is_drawn), {.margin = 0});
    const MetricComparison back = error_of(variant(b, is_drawn), variant(a, is_drawn), {.margin = 0});
    CHECK((there.outcome == Outcome::worse) == (back.outcome == Outcome::better));
    CHECK((there.outcome == Outcome::better) == (back.outcome == Outcome::worse));
    CHECK(there.ranks_favour == -back.ranks_favour);
    CHECK(there.p_worse == Approx(back.p_better).margin(1e-12));
    decided += there.outcome == Outcome::worse || there.outcome == Outcome::better ? 1 : 0;
  }
  CHECK(decided > 20);
  CHECK(decided < 100);
}

TEST_CASE("a margin is to be exceeded: 8 % more is worse by more than 5 %, and by less than 10 %", "[variants]") {
  const Variant a = variant(about(1, 0.01)), b = variant(about(1.08, 0.01));
  CHECK(error_of(a, b, {.margin = 0.05}).outcome == Outcome::worse);
  CHECK(error_of(a, b, {.margin = 0.10}).outcome == Outcome::worse_by_less);
}

TEST_CASE("an error that is twice as large, but by less than an arm can resolve, is worse by less", "[variants]") {
  const Variant a = variant(about(0.001, 0.0001)), b = variant(about(0.002, 0.0001));
  CHECK(error_of(a, b).outcome == Outcome::worse);
  CHECK(error_of(a, b, {.margin_cm = 0.01}).outcome == Outcome::worse_by_less);
  CHECK(error_of(b, a, {.margin_cm = 0.01}).outcome == Outcome::better_by_less);
  CHECK(error_of(a, b, {.margin_cm = 0.0005}).outcome == Outcome::worse);
  CHECK(error_of(a, variant(about(0.001, 0.0002)), {.margin = 0, .margin_cm = 0.01}).outcome == Outcome::same);
  const Change turned = [](SolveRecord& solve) { solve.variation_deg = 0.002 + 1e-5 * solve.run; };
  const VariantComparison other =
      compared(variant(about(1, 0.1), turned),
               variant(about(1, 0.1), [](SolveRecord& solve) { solve.variation_deg = 0.004 + 1e-5 * solve.run; }),
               {"variation_deg"}, {.margin_cm = 0.01});
  CHECK(other.metrics.front().outcome == Outcome::worse);  // degrees are no cm
}

TEST_CASE("of what is open within an absolute margin it says how many runs would decide", "[variants]") {
  // By hand: standard deviations 0.0249 and 0.0249, difference 0.005, 0.005 from the margin's end of 0.01.
  const MetricComparison open =
      error_of(variant(about(1, 0.04)), variant(about(1.005, 0.04)), {.margin = 0, .margin_cm = 0.01});
  CHECK(open.outcome == Outcome::undecided);
  const MetricComparison relative = error_of(variant(about(1, 0.04)), variant(about(1.005, 0.04)), {.margin = 0.01});
  CHECK(open.n_to_decide == Approx(relative.n_to_decide).epsilon(0.03));  // 1 % of 1 is 0.01
  const MetricComparison across =
      error_of(variant(about(1, 0.04)), variant(about(1.05, 0.04)), {.margin = 0.01, .margin_cm = 0.05});
  CHECK(across.remark.starts_with("worse, but perhaps by less than 0.05 cm"));
  CHECK_THROWS_WITH(error_of(variant(about(1, 0.1)), variant(about(1, 0.1)), {.margin_cm = -1}),
                    ContainsSubstring("margin in cm -1: expected 0 to 1000"));
}

TEST_CASE("equivalent is a claim that is shown, and few or wide runs do not show it", "[variants]") {
  CHECK(error_of(variant(about(1, 0.01)), variant(about(1.001, 0.01))).outcome == Outcome::same);
  const MetricComparison wide = error_of(variant(about(1, 0.5)), variant(about(1.001, 0.4)));
  CHECK(wide.outcome == Outcome::undecided);
  CHECK_THAT(wide.remark, ContainsSubstring("no difference shown; about "));
  CHECK(wide.n_to_decide > 20);
}

TEST_CASE("worse, but not shown to be by more than the margin, is undecided and says so", "[variants]") {
  // By hand: standard deviation of about(1, 0.04) 0.0249, standard error of the difference 0.0079; 0.05 is 6 of them
  // from 0, and the margin's end.
  const MetricComparison comparison = error_of(variant(about(1, 0.04)), variant(about(1.05, 0.04)));
  CHECK(comparison.outcome == Outcome::undecided);
  CHECK(comparison.remark.starts_with("worse, but perhaps by less than 5 %"));
}

TEST_CASE("what is shown not to be worse by the margin need not be shown better or the same", "[variants]") {
  const MetricComparison comparison = error_of(variant(about(1, 0.04)), variant(about(0.95, 0.04)));
  CHECK(comparison.outcome == Outcome::not_worse);
  CHECK(comparison.remark.starts_with("better, but perhaps by less than 5 %"));
}

TEST_CASE("how many runs it takes hangs on the margin and the spread, not on the difference seen", "[variants]") {
  const MetricComparison few = error_of(variant(about(1, 0.3)), variant(about(1.15, 0.3)));
  REQUIRE(few.outcome == Outcome::undecided);
  // By hand: (1.645 + 1.282)^2 2 s^2 / 0.05^2 with s = 0.3 * sqrt(665 / 19) / 9.5 = 0.18682 is 239.1; Welch's test
  // needs one more.
  CHECK(few.n_to_decide == Approx(240).margin(1));
}

TEST_CASE("pairs of runs need as many as Student's test of pairs needs", "[variants]") {
  std::vector<double> a = about(1, 0.3), b;
  synthetic::Noise noise;
  for (const double value : a) b.push_back(1.06 * value + 0.6 * (noise.next() - 0.5));
  const MetricComparison comparison = error_of(variant(a, draw_target), variant(b, draw_target));
  REQUIRE(comparison.outcome == Outcome::undecided);
  std::vector<double> rest;
  for (std::size_t i = 0; i < a.size(); ++i) rest.push_back(b[i] - a[i]);
  const GroupSummary summary = summarise(rest);
  // (z_.95 + z_.9)^2 s^2 / d^2, and z_.95^2 / 2 more for t instead of z (Guenther, The American Statistician 35 (1981)
  // 243).
  const double normal = std::pow((1.64485 + 1.28155) * summary.std / 0.05, 2);
  CHECK(comparison.n_to_decide == Approx(normal + 1.64485 * 1.64485 / 2).margin(1.5));
}

TEST_CASE("more solves that are ok are better, not worse", "[variants]") {
  const Variant all = variant(about(1, 0.1)), none = variant(about(1, 0.1), [](SolveRecord&solve) {
                                                if (solve.run % 3 != 0) solve.status = Status::tolerance_missed;
                                              });
  const MetricComparison fewer = compared(all, none, {"solved"}).metrics.front();
  CHECK(fewer.outcome == Outcome::worse);
  CHECK(fewer.a.mean == 1);
  CHECK(fewer.b.mean == Approx(0.3));  // of the runs 1 to 20, six are multiples of 3
  CHECK(fewer.b_better.value == Approx(0.15));
  CHECK(compared(none, all, {"solved"}).metrics.front().outcome == Outcome::better);
}

TEST_CASE("worse is corrected for the number of metrics that are looked at", "[variants]") {
  // The ratio's p_above is between 0.05 / 5 and 0.05.
  const Variant a = variant(about(1, 0.3), [](SolveRecord& solve) { solve.variation_deg = 10 + solve.run; });
  const Variant b = variant(about(1.17, 0.3), [](SolveRecord& solve) {
    solve.variation_deg = 30.5 - solve.run;
    solve.evaluations += solve.run;
    solve.seconds *= 1.5;
    if (solve.run == 3) solve.status = Status::refused;
  });
  const MetricComparison alone = error_of(a, b);
  REQUIRE(alone.p_worse < 0.05);
  REQUIRE(alone.p_worse > 0.02);
  CHECK(alone.outcome == Outcome::worse);
  const MetricComparison among =
      metric_of(compared(a, b, {"variation_deg", "solved", "position_error_cm"}), "position_error_cm");
  CHECK(among.p_worse > 2 * alone.p_worse);
  CHECK(among.outcome == Outcome::undecided);
  CHECK(among.remark.starts_with("worse before Holm's correction, but not after it"));
}

TEST_CASE("ranks that say other than the mean are told", "[variants]") {
  // Nineteen runs of b are a little better, one is far off: the mean cannot tell.
  std::vector<double> a = about(1, 0.01), b = about(0.9, 0.01);
  b[0] = 3;
  const MetricComparison comparison = error_of(variant(a), variant(b));
  CHECK(comparison.outcome == Outcome::undecided);
  CHECK_THAT(comparison.remark, ContainsSubstring("by ranks B is better (p "));
  // Where a third is far off, the mean is worse and most runs are better.
  for (std::size_t i = 0; i < 6; ++i) b[i] = 5;
  const MetricComparison opposed = error_of(variant(a), variant(b), {.significance = 0.1});
  CHECK(opposed.outcome == Outcome::worse);
  CHECK_THAT(opposed.remark, ContainsSubstring("ranks contradict the mean: by ranks B is better (p "));
}
