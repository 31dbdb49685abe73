#include "robots/robot.hpp"

#include <algorithm>
#include <numbers>
#include <stdexcept>

#include "robots/dobot_magician.hpp"
#include "numerics/names.hpp"
#include "numerics/units.hpp"

namespace ikbench::robots {

using namespace numerics;

namespace {

JointLimits symmetric_limits(const Configuration& degrees) { return {-degrees * degree, degrees * degree}; }

std::shared_ptr<const Kinematics> chain_of(std::vector<DhLink> links) {
  return std::make_shared<Chain>(std::move(links));
}

// Slim et al. 2023, Table 2; the lengths, which the paper does not print, are the manufacturer's.
Robot kuka_iiwa14() {
  constexpr double quarter = std::numbers::pi / 2;
  return {"kuka_iiwa14", "KUKA LBR iiwa 14 R820: 7 joints, spherical wrist",
          chain_of({{.alpha = -quarter, .d = 0.360},
                    {.alpha = quarter},
                    {.alpha = quarter, .d = 0.420},
                    {.alpha = -quarter},
                    {.alpha = -quarter, .d = 0.400},
                    {.alpha = quarter},
                    {.d = 0.126}}),
          symmetric_limits(Eigen::Vector<double, 7>{170, 120, 170, 120, 170, 120, 175})};
}

// Closed-form answers for tests and first steps: every link 0.5 m, in the x-y plane.
Robot planar(int joints) {
  const auto count = static_cast<std::size_t>(joints);
  return {"planar_" + std::to_string(joints), std::to_string(joints) + " links of 0.5 m in the x-y plane",
          chain_of(std::vector<DhLink>(count, DhLink{.a = 0.5})),
          symmetric_limits(Configuration::Constant(joints, 180))};
}

// Slim et al. 2023, Sec. 6; the limits are the manufacturer's.
Robot dobot_magician() {
  return {"dobot_magician",
          "Dobot Magician: 3 joints that place the tool, parallelogram linkage",
          std::make_shared<DobotMagician>(),
          {Eigen::Vector3d(-90, 0, -10) * degree, Eigen::Vector3d(90, 85, 95) * degree}};
}

}  // namespace

double JointLimits::violation(const ConfigurationRef& q) const {
  return std::max({0.0, (lower - q).maxCoeff(), (q - upper).maxCoeff()});
}

std::vector<Robot> all_robots() { return {kuka_iiwa14(), dobot_magician(), planar(2), planar(3)}; }

Robot robot(std::string_view name) {
  std::vector<std::string> names;
  for (Robot& candidate : all_robots()) {
    if (candidate.name == name) return std::move(candidate);
    names.push_back(candidate.name);
  }
  throw std::invalid_argument(unknown_name("robot", name, names));
}

}  // namespace ikbench::robots
