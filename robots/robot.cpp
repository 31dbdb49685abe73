#include "robots/robot.hpp"

#include <algorithm>
#include <numbers>
#include <stdexcept>

#include "robots/names.hpp"
#include "robots/units.hpp"

namespace ikbench {

namespace {

JointLimits symmetric_limits(const Configuration& degrees) { return {-degrees * degree, degrees * degree}; }

// Slim et al. 2023, Table 2; the lengths, which the paper does not print, are the manufacturer's.
Robot kuka_iiwa14() {
  constexpr double quarter = std::numbers::pi / 2;
  return {"kuka_iiwa14", "KUKA LBR iiwa 14 R820: 7 joints, spherical wrist",
          Chain({{.alpha = -quarter, .d = 0.360},
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
          Chain(std::vector<DhLink>(count, DhLink{.a = 0.5})), symmetric_limits(Configuration::Constant(joints, 180))};
}

}  // namespace

double JointLimits::violation(const ConfigurationRef& q) const {
  return std::max({0.0, (lower - q).maxCoeff(), (q - upper).maxCoeff()});
}

std::vector<Robot> robots() { return {kuka_iiwa14(), planar(2), planar(3)}; }

Robot robot(std::string_view name) {
  std::vector<std::string> names;
  for (Robot& candidate : robots()) {
    if (candidate.name == name) return std::move(candidate);
    names.push_back(candidate.name);
  }
  throw std::invalid_argument(unknown_name("robot", name, names));
}

}  // namespace ikbench
