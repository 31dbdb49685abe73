// The examples of docs/adding-anything.md and docs/adding-a-solver.md at work: a solver, a kind of path, an option of a
// study, a column of the record, an arm. Every test of paths runs here as well (CMakeLists.txt).
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "experiments/study_writer.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/samples.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::experiments;

namespace {

constexpr double degree = std::numbers::pi / 180;

// Two runs of the example's solver along the example's stroke, with the example's arm.
Study study_with(const Overrides& overrides) {
  const ScratchFolder folder;
  std::filesystem::copy_file("tests/examples/robots/arms/long_and_short.toml", folder.path / "long_and_short.toml");
  const auto file = folder.path / "study.toml";
  write_text(file, R"(
robot = "long_and_short.toml"
search = "all_joints"
runs = 2
population = 20
stop.iterations = 200
path = { kind = "stroke", from_cm = [60, -30, 0], to_cm = [60, 30, 0], points = 4 }
solvers = [{ label = "climber", solver = "hill_climb" }]
)");
  return load_study(file.string(), overrides);
}

Eigen::Vector2d tip(const std::vector<double>& q) {  // [m]
  return {0.6 * std::cos(q[0]) + 0.3 * std::cos(q[0] + q[1]), 0.6 * std::sin(q[0]) + 0.3 * std::sin(q[0] + q[1])};
}

}  // namespace

TEST_CASE("the example of a solver reaches the targets of the example of a path with the example of an arm",
          "[examples]") {
  const std::vector<SolveRecord> solves = solves_of(study_with({}));
  REQUIRE(solves.size() == 8);
  for (const SolveRecord& solve : solves) {
    const Eigen::Vector2d target(0.6, -0.3 + 0.2 * (solve.point - 1));
    CHECK(solve.target_position_m[0] == Approx(target.x()));
    CHECK(solve.target_position_m[1] == Approx(target.y()));
    CHECK(solve.robot == "long_and_short");
    CHECK((tip(solve.answer_rad) - target).norm() < 1e-3);
  }
}

TEST_CASE("the example of a column has the distance before each solve", "[examples]") {
  for (const SolveRecord& solve : solves_of(study_with({}))) {
    const Eigen::Vector2d target(solve.target_position_m[0], solve.target_position_m[1]);
    CHECK(solve.start_error_cm == Approx(100 * (tip(solve.start_rad) - target).norm()));
  }
}

TEST_CASE("the example of an option rounds the start of every solve, and decides the key", "[examples]") {
  const Study exact = study_with({}), rounded = study_with({"encoder_deg=2"});
  CHECK(configuration_key(exact, exact.solvers[0]) != configuration_key(rounded, rounded.solvers[0]));
  CHECK_THAT(to_toml(rounded), ContainsSubstring("encoder_deg = 2"));
  CHECK_THROWS_WITH(study_with({"encoder_deg=11"}), ContainsSubstring("encoder_deg is 11"));
  std::vector<double> before;
  for (const SolveRecord& solve : solves_of(rounded)) {
    for (std::size_t j = 0; j < solve.start_rad.size(); ++j) {
      const double steps = solve.start_rad[j] / (2 * degree);
      CHECK(steps == Approx(std::round(steps)).margin(1e-9));
      if (solve.point > 1) CHECK(std::abs(solve.start_rad[j] - before[j]) <= 1.000001 * degree);
    }
    before = solve.answer_rad;
  }
}

TEST_CASE("the example of a solver that looks ahead gives the bits of the one that does not", "[examples]") {
  Study study = study_with({"climber.bounds=clamp"});
  std::vector<SolveRecord> plain = solves_of(study);
  study.solvers[0].solver = "hill_climb_ahead";
  std::vector<SolveRecord> ahead = solves_of(study);
  for (auto* solves : {&plain, &ahead})
    for (SolveRecord& solve : *solves) solve.series.clear();
  CHECK(same_numbers(plain, ahead));
}

TEST_CASE("the example of a paper's study is compared with that paper", "[examples]") {
  CHECK(load_study("tests/examples/experiments/studies/tiny.toml").published == "tiny");
}

TEST_CASE("the entries of docs/adding-a-solver.md are two solvers of a study", "[examples]") {
  const Study study = load_study("tests/examples/experiments/studies/two-climbers.toml");
  REQUIRE(study.solvers.size() == 2);
  CHECK(effective_options(study, study.solvers[0]).at("shrink") == "0.97");
  CHECK(effective_options(study, study.solvers[1]).at("shrink") == "0.99");
}
