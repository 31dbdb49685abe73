// An arm by name: its chain and its joint limits, from a file of robots/arms/ or of one's own.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "robots/chain.hpp"
#include "robots/description.hpp"

namespace ikbench::robots {

struct JointLimits {
  Configuration lower, upper;  // [rad], or [m] where a joint slides; Eq. 4; infinite where it turns without end

  // How far the worst joint is outside, in its unit; 0 inside.
  double violation(const ConfigurationRef& q) const;
  // What to draw joints from: a joint that turns without end gets half a turn each way of its value in `middle`.
  JointLimits around(const ConfigurationRef& middle) const;
};

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
