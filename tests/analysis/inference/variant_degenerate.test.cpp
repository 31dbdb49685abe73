// Variants whose answers are not finite, constant, too few, zero or too large.
#include <cmath>
#include <limits>

#include "analysis/inference/variant_metric.hpp"
#include "tests/analysis/inference/variant_samples.hpp"
#include "tests/catch.hpp"
#include "tests/results/samples.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::statistics;
using namespace ikbench::inference;
using namespace ikbench::variant_samples;

TEST_CASE("counts that are constant in both are the same within the margin, and beyond it so many runs can show it",
          "[variants]") {
  const auto comparison_of = [](std::size_t runs, std::int64_t count) {
    const auto evaluations = [&](std::int64_t number) {
      return variant(std::vector<double>(runs, 1.0), [number](SolveRecord& solve) { solve.evaluations = number; });
    };
    return compared(evaluations(100), evaluations(count), {"evaluations"}).metrics.front();
  };
  for (const std::int64_t count : {100, 105, 95}) {  // at the margin, not beyond it
    CHECK(comparison_of(20, count).outcome == Outcome::same);
    CHECK(comparison_of(20, count).is_fact);
  }
  CHECK(comparison_of(20, 106).outcome == Outcome::worse);
  CHECK(comparison_of(20, 94).outcome == Outcome::better);
  CHECK_FALSE(comparison_of(20, 106).is_fact);
  CHECK(comparison_of(2, 106).outcome == Outcome::undecided);
  CHECK(comparison_of(4, 106).p_worse == Approx(2 / 70.0));
}

TEST_CASE("what is constant in few runs differs in these runs, and shows no more", "[variants]") {
  const auto solved = [](std::size_t runs, Status status, const Change& design) {
    return variant(std::vector<double>(runs, 1.0), [=](SolveRecord& solve) {
      solve.status = status;
      if (design) design(solve);
    });
  };
  const auto comparison_of = [&](std::size_t runs, const Change& design) {
    return compared(solved(runs, Status::ok, design), solved(runs, Status::tolerance_missed, design), {"solved"})
        .metrics.front();
  };
  const MetricComparison two = comparison_of(2, {});
  CHECK(two.outcome == Outcome::undecided);
  CHECK_FALSE(two.is_fact);
  CHECK(two.remark == "differs in these 2 runs, but they are too few to decide");
  CHECK(two.p_worse == Approx(1 / 3.0));  // 2 of the 6 ways to choose two of four
  CHECK(two.p_ranks == Approx(1 / 3.0));
  CHECK(comparison_of(3, {}).outcome == Outcome::undecided);  // 2 of 20
  CHECK(comparison_of(4, {}).outcome == Outcome::worse);      // 2 of 70
  CHECK(comparison_of(4, {}).p_worse == Approx(2 / 70.0));
  CHECK(comparison_of(5, draw_target).outcome == Outcome::undecided);  // pairs: 2 of the 32 ways to have five signs
  CHECK(comparison_of(6, draw_target).outcome == Outcome::worse);
  CHECK(comparison_of(6, draw_target).p_worse == Approx(2 / 64.0));
  const MetricComparison from_none =
      compared(solved(2, Status::tolerance_missed, {}), solved(2, Status::ok, {}), {"solved"}).metrics.front();
  CHECK(from_none.outcome == Outcome::undecided);
  CHECK(from_none.remark == "differs in these 2 runs, but they are too few to decide");
  CHECK(compared(solved(4, Status::tolerance_missed, {}), solved(4, Status::ok, {}), {"solved"})
            .metrics.front()
            .outcome == Outcome::better);
}

TEST_CASE("errors that are constant are tested too, and so is that they are the same", "[variants]") {
  const auto outcome = [](std::size_t runs, double error) {
    return error_of(variant(std::vector<double>(runs, 1.0)), variant(std::vector<double>(runs, error))).outcome;
  };
  CHECK(outcome(3, 2) == Outcome::undecided);
  CHECK(outcome(4, 2) == Outcome::worse);
  CHECK(outcome(4, 0.5) == Outcome::better);
  CHECK(outcome(3, 1.04) == Outcome::undecided);
  CHECK(outcome(4, 1.04) == Outcome::worse_by_less);
}

TEST_CASE("two pairs that differ by the same show no more than two signs", "[variants]") {
  const MetricComparison comparison =
      error_of(variant({1, 3}, draw_target), variant({1.5, 3.5}, draw_target), {.margin = 0});
  CHECK(comparison.outcome == Outcome::undecided);
  CHECK(comparison.p_worse == 0.5);  // 2 / 2^2
}

TEST_CASE("runs that all succeed show no failures as rare as their number allows", "[variants]") {
  const auto comparison_of = [](std::size_t of_a, std::size_t of_b) {
    return compared(variant(std::vector<double>(of_a, 1.0)), variant(std::vector<double>(of_b, 1.0)), {"solved"})
        .metrics.front();
  };
  const MetricComparison few = comparison_of(8, 10);
  CHECK(few.outcome == Outcome::undecided);
  CHECK(few.remark ==
        "equal in all 8 and 10 runs; about 62 runs a side show a difference of the margin, or that there is none");
  CHECK(few.ratio.p_equivalent == Approx(std::pow(1.05, -8)));
  CHECK(comparison_of(62, 59).outcome == Outcome::same);  // 1.05^-62 = 0.0486, 0.95^59 = 0.0485
  CHECK(comparison_of(61, 59).outcome == Outcome::not_worse);
  CHECK(comparison_of(62, 58).outcome == Outcome::undecided);  // 0.95^58 = 0.0510
}

TEST_CASE("one answer in eight that is not finite hides no errors ten times as large", "[variants]") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::vector<double> a{infinity, 1.0, 1.1, 0.9, 1.2, 0.8, 1.05, 0.95};
  const std::vector<double> b{10.5, 10.0, 11.0, 9.0, 12.0, 8.0, 10.5, 9.5};
  for (const Change& change : {Change(), Change(draw_target)}) {
    const MetricComparison worse = error_of(variant(a, change), variant(b, change));
    CHECK(worse.outcome == Outcome::worse);
    CHECK(worse.ratio.ratio == Approx(10).epsilon(0.02));  // 70 / 7 to 80.5 / 8, of those that are finite
    CHECK(worse.remark.starts_with("not finite: 1 of 8 runs of A, 0 of 8 of B"));
    const MetricComparison better = error_of(variant(b, change), variant(a, change));
    CHECK(better.outcome == Outcome::undecided);
    CHECK(better.p_better == 1);
    CHECK(better.remark == "not finite: 0 of 8 runs of A, 1 of 8 of B; the finite values of B are better, but fewer");
  }
}

TEST_CASE("one answer in eight that is not finite is no difference by itself", "[variants]") {
  std::vector<double> finite{1.3, 1.0, 1.1, 0.9, 1.2, 0.8, 1.05, 0.95}, diverged = finite;
  diverged[0] = not_defined;
  const MetricComparison to = error_of(variant(finite), variant(diverged));
  CHECK(to.outcome == Outcome::undecided);
  CHECK(to.remark == "not finite: 0 of 8 runs of A, 1 of 8 of B; no difference shown");
  CHECK(to.p_worse == Approx(1));  // of one such run in all, either side has it with the probability 1 / 2
  CHECK(error_of(variant(diverged), variant(finite)).outcome == Outcome::undecided);
  CHECK(error_of(variant({1}), variant({not_defined})).outcome == Outcome::undecided);
}

TEST_CASE("many answers that are not finite are worse, whatever the others are", "[variants]") {
  std::vector<double> finite = about(1, 0.1), diverged = finite;
  for (std::size_t i = 0; i < 15; ++i) diverged[i] = not_defined;
  const MetricComparison worse = error_of(variant(finite), variant(diverged));
  CHECK(worse.outcome == Outcome::worse);
  CHECK(worse.p_worse == Approx(7.70857e-07));  // both extreme tables of Fisher's test: 2 * 15504 / 40225345056
  CHECK(error_of(variant(diverged), variant(finite)).outcome == Outcome::better);
  for (double& value : diverged) value /= 10;
  CHECK(error_of(variant(finite), variant(diverged)).outcome == Outcome::worse);
  const MetricComparison opposed = error_of(variant(diverged), variant(about(0.11, 0.1)));
  CHECK(opposed.outcome == Outcome::undecided);
  CHECK_THAT(opposed.remark, ContainsSubstring("B has more finite values, but they are worse"));
  // All of four and none of four: 2 of the 70 ways to choose four of eight.
  const MetricComparison none = error_of(variant({1, 2, 3, 4}), variant(std::vector<double>(4, not_defined)));
  CHECK(none.outcome == Outcome::worse);
  CHECK(none.p_worse == Approx(2 / 70.0));
  CHECK_THAT(none.remark, ContainsSubstring("too few finite values"));
}

TEST_CASE("the means of those that are finite have half the significance", "[variants]") {
  std::vector<double> a{1.0, 1.1, 0.9, 1.2, 0.8, 1.05, 0.95, 1.0}, b{1.3, 1.1, 1.2, 1.35, 1.0, 1.25, 1.15, 1.2};
  const double alone = error_of(variant(a), variant(b)).p_worse;
  a.push_back(not_defined);
  b.push_back(not_defined);
  CHECK(error_of(variant(a), variant(b)).p_worse == Approx(2 * alone));
}

TEST_CASE("where both have answers that are not finite, their numbers are compared", "[variants]") {
  std::vector<double> once = about(1, 0.1), often = once;
  once[0] = not_defined;
  for (std::size_t i = 0; i < 15; ++i) often[i] = not_defined;
  const MetricComparison worse = error_of(variant(once), variant(often));
  CHECK(worse.outcome == Outcome::worse);  // Fisher's exact test of 1 and 15 of 20: p = 1e-5
  CHECK(worse.p_worse < 1e-4);
  std::vector<double> twice = once;
  twice[1] = not_defined;
  const MetricComparison open = error_of(variant(once), variant(twice));
  CHECK(open.outcome == Outcome::undecided);
  CHECK(open.remark.starts_with("not finite: 1 of 20 runs of A, 2 of 20 of B"));
}

TEST_CASE("of a baseline whose mean is 0 there is no ratio, and the difference decides", "[variants]") {
  const auto share = [](int every) {
    return variant(about(1, 0.1), [every](SolveRecord& solve) {
      solve.status = solve.run % every == 0 ? Status::ok : Status::tolerance_missed;
    });
  };
  const VariantComparison better = compared(share(1000), share(2), {"solved"}),
                          worse = compared(share(2), share(1000), {"solved"});
  CHECK(better.metrics.front().outcome == Outcome::better);
  CHECK(std::isnan(better.metrics.front().ratio.ratio));
  CHECK(worse.metrics.front().outcome == Outcome::worse);
  CHECK(compared(share(1000), share(20), {"solved"}).metrics.front().outcome == Outcome::undecided);
}

TEST_CASE("errors that the verifier takes for rounding are the same", "[variants]") {
  CHECK(error_of(variant(about(1e-13, 1e-14)), variant(about(5e-13, 1e-14))).outcome == Outcome::same);
  CHECK(error_of(variant(about(1e-13, 1e-14)), variant(about(5e-3, 1e-4))).outcome == Outcome::worse);
}

TEST_CASE("of one run nothing can be said, and how to get more is", "[variants]") {
  for (const auto& [a, b] :
       {std::pair(about(1, 0.1), std::vector{3.0}), std::pair(std::vector{1.0}, std::vector{3.0})}) {
    const MetricComparison comparison = error_of(variant(a), variant(b));
    CHECK(comparison.outcome == Outcome::undecided);
    CHECK(comparison.remark == "a single run");
    CHECK(std::isnan(comparison.p_worse));
  }
}

TEST_CASE("values beyond double precision are undecided with a reason, not a number", "[variants]") {
  for (const std::vector<double>& huge : {std::vector{1e308, 1.5e308, 0.7e308}, std::vector{1e308, 0.0, 1e-308}}) {
    const MetricComparison comparison = error_of(variant({1, 1.1, 0.9}), variant(huge));
    CHECK_FALSE(comparison.outcome == Outcome::same);
    CHECK_FALSE(comparison.outcome == Outcome::better);
  }
}
