// The key `wrap`: answers turned by whole turns.
#include "tests/experiments/samples.hpp"

namespace {

constexpr double turn = 2 * std::numbers::pi;

// Newton without limits: near singular configurations it takes joints far around.
Study study_without_limits(WrapPolicy wrap) {
  Study study = small_study();
  study.path = path_of({"kind=random", "points=40"});
  study.search = Search::all_joints;
  study.start = Start::random;
  study.wrap = wrap;
  study.stop.iterations = 50;
  study.solvers = {{"A", "newton", {{"bounds", "initial"}, {"restarts", "none"}}}};
  return study;
}

}  // namespace

TEST_CASE("an angle outside the limits comes back by the fewest whole turns, if a turn brings it inside", "[wrap]") {
  CHECK(turned_inside(1.5, -2, 2) == 1.5);
  CHECK(turned_inside(2.0, -2, 2) == 2.0);
  CHECK(turned_inside(turn - 1, -2, 2) == Approx(-1).margin(1e-15));
  CHECK(turned_inside(-3 * turn + 1, -2, 2) == Approx(1).margin(1e-14));
  CHECK(turned_inside(3 * turn, -turn - 1, turn + 1) == Approx(turn));       // not by three turns to 0
  CHECK(turned_inside(-2 + 100 * turn, -2, 2) == Approx(-2).margin(1e-12));  // on a limit, but for rounding
  CHECK(turned_inside(2.5, -2, 2) == 2.5);                                   // 2.5 - 2 pi is outside too
  CHECK(std::isnan(turned_inside(std::nan(""), -2, 2)));
}

TEST_CASE("wrapped answers differ by whole turns, reach the same and are outside the limits less often", "[wrap]") {
  const std::vector<SolveRecord> plain = solve_all(study_without_limits(WrapPolicy::no)),
                                 wrapped = solve_all(study_without_limits(WrapPolicy::into_limits));
  REQUIRE(plain.size() == wrapped.size());
  int outside = 0, outside_wrapped = 0, turned = 0;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    CHECK(wrapped[i].position_error_cm == Approx(plain[i].position_error_cm).margin(1e-7));
    CHECK(wrapped[i].evaluations == plain[i].evaluations);
    for (std::size_t j = 0; j < plain[i].answer_rad.size(); ++j) {
      const double turns = (wrapped[i].answer_rad[j] - plain[i].answer_rad[j]) / turn;
      CHECK(turns == Approx(std::round(turns)).margin(1e-9));
      turned += std::abs(turns) > 0.5 ? 1 : 0;
    }
    outside += plain[i].limit_violation_deg > 0 ? 1 : 0;
    outside_wrapped += wrapped[i].limit_violation_deg > 0 ? 1 : 0;
  }
  CAPTURE(outside, outside_wrapped, turned);
  CHECK(turned > 0);
  CHECK(outside_wrapped < outside);
}

TEST_CASE("the nearest answers differ by whole turns, move no farther, and no turn inside the limits is nearer",
          "[wrap]") {
  Study study = study_without_limits(WrapPolicy::into_limits);
  study.robot = "ur5e";  // two turns for each joint
  study.initial = Eigen::VectorXd::Zero(6);
  const std::vector<SolveRecord> wrapped = solve_all(study);
  study.wrap = WrapPolicy::nearest;
  const std::vector<SolveRecord> nearest = solve_all(study);
  const JointLimits limits = robot("ur5e").limits;
  int nearer = 0;
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    CHECK(nearest[i].position_error_cm == Approx(wrapped[i].position_error_cm).margin(1e-7));
    CHECK(nearest[i].variation_deg <= wrapped[i].variation_deg + 1e-6);
    nearer += nearest[i].variation_deg < wrapped[i].variation_deg - 1 ? 1 : 0;
    for (std::size_t j = 0; j < nearest[i].answer_rad.size(); ++j) {
      const auto at = static_cast<Eigen::Index>(j);
      const double q = nearest[i].answer_rad[j], start = nearest[i].start_rad[j];
      const double turns = (q - wrapped[i].answer_rad[j]) / turn, other = q + (q < start ? turn : -turn);
      CHECK(turns == Approx(std::round(turns)).margin(1e-9));
      const bool is_possible = other >= limits.lower[at] && other <= limits.upper[at];
      CHECK((!is_possible || std::abs(q - start) <= std::abs(other - start) + 1e-9));
    }
  }
  CHECK(nearer > 0);
}

TEST_CASE("where the whole pose is searched, answers are turned to the nearest, if the study says nothing", "[wrap]") {
  const auto wrap_of = [](const std::string& search) {
    return read("robot = 'ur5e'\n" + search + "path.kind = 'random'\nsolvers = [{ solver = 'newton' }]\n").wrap;
  };
  CHECK(wrap_of("search = 'pose'\n") == WrapPolicy::nearest);
  CHECK(wrap_of("search = 'pose'\nwrap = 'no'\n") == WrapPolicy::no);
  CHECK(wrap_of("search = 'axis'\n") == Study().wrap);
}
