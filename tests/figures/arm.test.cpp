#include "tests/figures/drawn.hpp"

namespace {

constexpr double quarter = std::numbers::pi / 2;

std::vector<Corner> corners_of_arm(const robots::Robot& arm, const std::vector<double>& angles) {
  return corners_of(arm, Eigen::Map<const Eigen::VectorXd>(angles.data(), static_cast<Eigen::Index>(angles.size())));
}

std::vector<Corner> corners_of_arm(const char* definition, const std::vector<double>& angles) {
  return corners_of_arm(robots::stored_arm(definition).value(), angles);
}

void check(const std::vector<Corner>& points, const std::vector<Corner>& expected) {
  REQUIRE(points.size() == expected.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      CAPTURE(i, axis);
      CHECK(points[i][axis] == Approx(100 * expected[i][axis]).margin(1e-10));  // cm
    }
  }
}

}  // namespace

TEST_CASE("the forearm's angle is that to the horizontal whatever the upper arm does", "[arm]") {
  // By hand: base turned to y, upper arm level, forearm straight down.
  check(corners_of_arm(robots::robot("dobot_magician"), {quarter, quarter, quarter}),
        {{0, 0, 0}, {0, 0, 0.058}, {0, 0.135, 0.058}, {0, 0.135, -0.089}, {0, 0.196, -0.089}});
}

TEST_CASE("a chain's corners are the shoulder, the elbow, the wrist and the tool", "[arm]") {
  const robots::Robot iiwa = robots::robot("kuka_iiwa14");
  check(corners_of_arm(iiwa, std::vector<double>(7, 0)),
        {{0, 0, 0}, {0, 0, 0.36}, {0, 0, 0.78}, {0, 0, 1.18}, {0, 0, 1.306}});
  // By hand: leaning forward by a quarter turn, then the elbow back up by one.
  check(corners_of_arm(iiwa, {0, quarter, 0, quarter, 0, 0, 0}),
        {{0, 0, 0}, {0, 0, 0.36}, {0.42, 0, 0.36}, {0.42, 0, 0.76}, {0.42, 0, 0.886}});
}

TEST_CASE("a link's length, offset and the tip are where Denavit and Hartenberg have them", "[arm]") {
  const char* const one = R"({"base": {"position_m": [0, 0, 0], "rpy_deg": [0, 0, 0]},
    "tool": {"position_m": [0, 0.5, 0], "rpy_deg": [0, 0, 0]},
    "links": [{"a_m": 2, "alpha_deg": 90, "d_m": 1, "offset_deg": 90}]})";
  // x turns to y; a along it; alpha then turns the tip's y up.
  check(corners_of_arm(one, {0}), {{0, 0, 0}, {0, 0, 1}, {0, 2, 1}, {0, 2, 1.5}});
}

TEST_CASE("slides, coupled links, base and tool are where the solves had them", "[arm]") {
  const char* const arm = R"({"links": [
    {"joint": "slides", "offset_deg": 90, "d_m": 0.5, "a_m": 0.2, "alpha_deg": 0, "limits_m": [0, 0.25]},
    {"joint": "coupled", "offset_deg": 0, "d_m": 0, "a_m": 0.3, "alpha_deg": 90, "limits_deg": [-90, 90]}],
    "base": {"position_m": [1, 0, 0], "rpy_deg": [0, 0, 90]}, "tool": {"position_m": [0, 0.125, 0], "rpy_deg": [0, 0, 0]}})";
  // By hand: the base turns x to y, the slide's offset to -x; the coupled link points down, and its twist turns y up.
  check(corners_of_arm(arm, {0.25, quarter}),
        {{0, 0, 0}, {1, 0, 0}, {1, 0, 0.75}, {0.8, 0, 0.75}, {0.8, 0, 0.45}, {0.8, 0, 0.575}});
}
