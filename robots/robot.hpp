// An arm by name: its chain and its joint limits, from a file of robots/arms/ or of one's own.
#pragma once

#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "robots/chain.hpp"
#include "robots/description.hpp"

namespace ikbench::robots {

constexpr double half_turn = std::numbers::pi, whole_turn = 2 * std::numbers::pi;  // [rad]

struct JointLimits {
  Configuration lower, upper;  // [rad], or [m] where a joint slides; Eq. 4; infinite where it turns without end

  // How far the worst joint is outside, in its unit; 0 inside.
  double violation(const ConfigurationRef& q) const;
  // Finite for every joint: one that turns without end gets so much each way of its value in `middle`. Half a turn is
  // what to draw from. A whole turn is for those that need limits: every direction of the joint is in it at least half
  // a turn from both ends.
  JointLimits around(const ConfigurationRef& middle, double each_way = half_turn) const;
};

// Whether a joint with these limits turns without end.
inline bool is_endless(double lower, double upper) { return !std::isfinite(upper - lower); }

struct Robot {
  std::string name;
  std::string summary;
  std::string source;  // of the numbers
  Chain chain;
  JointLimits limits;
  Description description = {};         // as a URDF file has it; empty: the chain says all
  std::vector<std::string> notes = {};  // what was not taken from its file as it stands there

  int joints() const { return chain.joints(); }
};

// The built-in arms, by name.
std::vector<Robot> all_robots();
// One of them; std::invalid_argument names those there are.
Robot robot(std::string_view name);

// Whether a name is meant as a file, by its ending: .toml, or a URDF file (urdf.hpp).
bool is_arm_file(std::string_view name);
// All: std::invalid_argument says where, what is wrong, and what is expected. The arm has the name of the file without
// its ending.
Robot parse_robot(std::string_view text, const std::filesystem::path& file);
struct UrdfChoice;
Robot load_robot(const std::filesystem::path& file, const UrdfChoice& choice);
Robot load_robot(const std::filesystem::path& file);

}  // namespace ikbench::robots
