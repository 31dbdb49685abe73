#include "analysis/inference/variant_design.hpp"

#include <stdexcept>

#include "analysis/inference/make_study.hpp"
#include "analysis/inference/variant_decision.hpp"
#include "tests/analysis/inference/variant_samples.hpp"
#include "tests/catch.hpp"
#include "tests/results/samples.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::statistics;
using namespace ikbench::inference;
using namespace ikbench::variant_samples;

// The definition of a study, as far as the design needs it.
namespace {

const char* const path_from_initial = R"({"path": {"kind": "helix"}, "start": "initial"})";
const char* const chained_path = R"({"path": {"kind": "helix"}, "start": "previous"})";
const char* const drawn_from_initial = R"({"path": {"kind": "random"}, "start": "initial"})";
const char* const chained_drawn = R"({"path": {"kind": "random"}, "start": "previous"})";

double first_error(int run, int point) { return point + 0.01 * run; }
double second_error(int run, int point) { return 1.2 * point + 0.02 * run * run; }

}  // namespace

TEST_CASE("targets of a path that are each solved from the same configuration are pairs", "[variants]") {
  const VariantComparison comparison = compared(
      variant({.runs = 3, .points = 10, .definition = path_from_initial}, first_error),
      variant({.runs = 2, .points = 10, .definition = path_from_initial}, second_error), {"position_error_cm"});
  const MetricComparison& error = comparison.metrics.front();
  CHECK(comparison.paired);
  CHECK(error.a.n == 10);
  CHECK(error.b.n == 10);
  CHECK(error.a.mean == Approx(5.5 + 0.02));        // of runs 1, 2 and 3
  CHECK(error.b.mean == Approx(1.2 * 5.5 + 0.05));  // of runs 1 and 2: (0.02 + 0.08) / 2
  CHECK(error.outcome == Outcome::worse);
  CHECK(
      comparison.design ==
      "10 pairs of targets, one observation is the mean (of times the median) of a target over the 3 runs of A and the 2 of B: A and B "
      "solve each target of the path from the same configuration.");
  CHECK(comparison.notes.size() == 1);  // nothing is left out
}

TEST_CASE("the pairs of a comparison are the blocks of a report", "[variants]") {
  for (const char* definition : {path_from_initial, drawn_from_initial, chained_drawn}) {
    const bool is_path = definition == path_from_initial;
    const auto change = is_path ? Change() : Change(draw_target);
    const Variant a = variant({.runs = 3, .points = 4, .definition = definition}, first_error, change);
    Variant b = variant({.runs = 3, .points = 4, .definition = definition}, second_error, change);
    const VariantDesign design = variant_design(a, b);
    std::vector<SolveRecord> solves = records({.runs = 3, .points = 4}, first_error, change);
    for (SolveRecord& solve : records({.runs = 3, .points = 4}, second_error, change)) {
      solve.solver = "other";
      solves.push_back(std::move(solve));
    }
    const StudyResults both =
        make_study(StudyEntry{.name = "both", .definition = definition, .series = {}}, std::move(solves));
    const auto reported = blocked_observations(both, Metric::position_error_cm);
    REQUIRE(reported);
    const Metric error = Metric::position_error_cm;
    CHECK(values_of(both, design.a, error) == reported->groups[0].values);
    CHECK(values_of(both, design.b, error) == reported->groups[1].values);
  }
}

TEST_CASE("drawn targets are pairs by run where they are chained, else each for itself", "[variants]") {
  const auto comparison_of = [](const char* definition) {
    return compared(variant({.runs = 3, .points = 4, .definition = definition}, first_error, draw_target),
                    variant({.runs = 2, .points = 4, .definition = definition}, second_error, draw_target),
                    {"position_error_cm"});
  };
  const VariantComparison alone = comparison_of(drawn_from_initial), chained = comparison_of(chained_drawn);
  CHECK(alone.metrics.front().a.n == 8);
  CHECK(alone.design.starts_with("8 pairs of targets, one observation is the only solve of a target: "));
  CHECK(alone.notes.front().starts_with("A: 1 of 3 runs are left out"));
  CHECK(chained.metrics.front().a.n == 2);
  CHECK(chained.design.starts_with(
      "2 pairs of runs, one observation is the mean (of times the median) of a run over its 4 points: "));
}

TEST_CASE("runs that are chained along a path, or have a single target, are independent", "[variants]") {
  for (const Solved& shape : {Solved{.runs = 3, .points = 4, .definition = chained_path},
                              Solved{.runs = 3, .points = 1, .definition = path_from_initial}}) {
    const VariantComparison comparison = compared(variant(shape, first_error), variant(shape, second_error));
    CHECK_FALSE(comparison.paired);
    CHECK(comparison.metrics.front().a.n == 3);
    CHECK(comparison.design.starts_with("Independent runs, 3 of A and 3 of B"));
  }
}

TEST_CASE("a store whose runs have targets of their own has pairs of runs, whatever it says", "[variants]") {
  const Solved shape{.runs = 3, .points = 4, .definition = path_from_initial};
  const VariantComparison comparison =
      compared(variant(shape, first_error, draw_target), variant(shape, second_error, draw_target));
  CHECK(comparison.design.starts_with("3 pairs of runs"));
}

TEST_CASE("solves that start where the one before ended are not held against those from one configuration",
          "[variants]") {
  const Variant a = variant({.runs = 2, .points = 3, .definition = path_from_initial}, first_error);
  const Variant b = variant({.runs = 2, .points = 3, .definition = chained_path}, second_error,
                            [](SolveRecord& solve) { solve.start_rad[0] = 0.1 * (solve.point - 1); });
  for (const auto& sides : {std::pair(a, b), std::pair(b, a)}) {
    CHECK_THAT(complaint<std::invalid_argument>([&] { compared(sides.first, sides.second); }),
               ContainsSubstring("different start configurations (run 1 and 1, point 2)"));
  }
}

TEST_CASE("where targets are the observations, as many targets are needed", "[variants]") {
  const Solved shape{.runs = 2, .points = 12, .definition = path_from_initial};
  const auto wide = [](int run, int point) { return 1 + 0.3 * ((point * 5 + 3 * run) % 12) / 12.0; };
  const auto other = [](int run, int point) { return 1.06 + 0.3 * ((point * 7 + 5 * run) % 12) / 12.0; };
  const MetricComparison comparison =
      compared(variant(shape, wide), variant(shape, other), {"position_error_cm"}).metrics.front();
  REQUIRE(comparison.outcome == Outcome::undecided);
  CHECK_THAT(comparison.remark, ContainsSubstring(" targets a side show a difference of the margin"));
}

TEST_CASE("pairs show what independent runs do not", "[variants]") {
  std::vector<double> a, b;
  for (int run = 1; run <= 10; ++run) {
    a.push_back(run);
    b.push_back(1.2 * run + (run % 2 == 0 ? 0.01 : -0.01));
  }
  const VariantComparison paired = compared(variant(a, draw_target), variant(b, draw_target), {"position_error_cm"});
  CHECK(paired.paired);
  CHECK(paired.metrics.front().outcome == Outcome::worse);
  CHECK_THAT(paired.design, ContainsSubstring("10 pairs of runs"));
  CHECK(paired.metrics.front().p_ranks == Approx(2 / 1024.0));  // all ten differences of one sign: 2 / 2^10
  const VariantComparison independent = compared(variant(a), variant(b), {"position_error_cm"});
  CHECK_FALSE(independent.paired);
  CHECK(independent.metrics.front().outcome == Outcome::undecided);
  CHECK_THAT(independent.design, ContainsSubstring("Independent runs, 10 of A and 10 of B"));
}

TEST_CASE("solvers that were given other things to do are not compared", "[variants]") {
  const Variant a = variant(about(1, 0.1));
  const auto complaint_of = [](const Variant& one, const Variant& other) {
    return complaint<std::invalid_argument>([&] { compared(one, other); });
  };
  CHECK_THAT(complaint_of(a, variant(about(1, 0.1), [](SolveRecord& solve) { solve.target_position_m[1] = 0.3; })),
             ContainsSubstring("different targets (run 1 and 1, point 1: 60 20 10 cm and 60 30 10 cm)"));
  CHECK_THAT(complaint_of(a, variant(about(1, 0.1), [](SolveRecord& solve) { solve.target_rotation[0] = -1; })),
             ContainsSubstring("different targets"));
  CHECK_THAT(complaint_of(a, variant(about(1, 0.1), [](SolveRecord& solve) { solve.robot = "leg"; })),
             ContainsSubstring("different robots (arm and leg)"));
  CHECK_THAT(complaint_of(a, variant(about(1, 0.1), [](SolveRecord& solve) { solve.start_rad[1] = 1; })),
             ContainsSubstring("different start configurations"));
  CHECK_THAT(complaint_of(a, variant(about(1, 0.1), draw_target)), ContainsSubstring("different targets"));
  CHECK_THAT(complaint_of(a, variant({})), ContainsSubstring("B has no complete run of mine"));
  CHECK_THAT(complaint_of(variant({}), a), ContainsSubstring("A has no complete run of mine"));
  const auto shift = [](SolveRecord& solve) {
    draw_target(solve);
    solve.run += 100;
  };
  CHECK_THAT(complaint_of(variant(about(1, 0.1), draw_target), variant(about(1, 0.1), shift)),
             ContainsSubstring("no run in common"));
}

TEST_CASE("drawn targets pair the runs that both have, and the others are counted", "[variants]") {
  const Variant a = variant(about(1, 0.1), draw_target), b = variant({1, 1.1, 0.9}, draw_target);
  const VariantComparison comparison = compared(a, b, {"position_error_cm"});
  CHECK(comparison.paired);
  CHECK(comparison.metrics.front().a.n == 3);
  CHECK_THAT(comparison.notes.front(), ContainsSubstring("A: 17 of 20 runs are left out"));
}

TEST_CASE("a run with points missing gives no observation", "[variants]") {
  std::vector<SolveRecord> solves;
  for (int run = 1; run <= 3; ++run) {
    for (int point = 1; point <= (run == 2 ? 1 : 2); ++point) {
      solves.push_back(solve_of(run, 10.0 * run + point));
      solves.back().point = point;
    }
  }
  Variant a = variant({1});
  a.study = make_study(StudyEntry{.name = "study", .definition = R"({"points": 2, "runs": 3})", .series = {a.series}},
                       solves);
  const VariantComparison comparison = compared(a, a, {"position_error_cm"});
  CHECK(comparison.metrics.front().a.n == 2);
  CHECK(comparison.metrics.front().a.mean == Approx((11.5 + 31.5) / 2));
  CHECK_THAT(comparison.notes.front(), ContainsSubstring("A: 1 of 3 runs are left out"));
}
