// Arms by name: a chain with joint limits, from robots/arms/ or from a user's file.
#pragma once

#include <cmath>
#include <filesystem>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robots/chain.hpp"
#include "robots/description.hpp"

namespace ikbench::robots {

constexpr double half_turn = std::numbers::pi, whole_turn = 2 * std::numbers::pi;  // [rad]

// The limits of an arm's joints, Eq. 4.
struct JointLimits {
  Configuration lower, upper;  // [rad], or [m] of prismatic joints; infinite of continuous joints

  // Returns how far the worst joint is outside its limits, in its unit; 0 if all joints are inside.
  double violation(const ConfigurationRef& q) const;
  // Returns limits that are finite for every joint: a continuous joint gets `each_way` [rad] on both sides of its value
  // in `middle`. Half a turn is for drawing. A whole turn is for methods that need limits: every direction of the joint
  // is then at least half a turn from both ends.
  JointLimits around(const ConfigurationRef& middle, double each_way = half_turn) const;
};

// Returns true if a joint with these limits is continuous.
inline bool is_endless(double lower, double upper) { return !std::isfinite(upper - lower); }

// An arm.
struct Robot {
  std::string name;
  std::string summary;
  std::string source;  // where the numbers are from
  Chain chain;
  JointLimits limits;
  Configuration velocity = {};                // largest velocity per joint [rad/s, m/s]; 0, or empty: not known
  Description description = {};               // as in a URDF file; empty: the chain says all
  std::vector<std::string> notes = {};        // parts of the file that were not taken as they stand
  std::string base_link = {}, tip_link = {};  // links of a URDF file
  std::string other_tip = {};                 // link that moves with tip_link and could be the end, too; empty: none

  int joints() const { return chain.joints(); }
};

// Returns "6 joints, reach 0.95 m, tool 0.1 m from the last joint; --tip flange for another".
std::string size_of(const Robot& arm);
// Returns sentences on numbers that hint at other units than metres and radians; empty if none does.
std::vector<std::string> doubts_of(const Robot& arm);

// Returns the built-in arms, ordered by name.
std::vector<Robot> all_robots();
// Returns the built-in arm of this name. Throws std::invalid_argument, which lists the names.
Robot robot(std::string_view name);

// The choices that a URDF file leaves to its user.
struct UrdfChoice {
  enum class Limits { hard, soft };  // <limit>, or the tighter of it and <safety_controller>

  std::string base;  // a link; empty: the root of the tree, or the link after the last joint that floats
  std::string tip;   // a link; empty: the end behind the most joints, without a hand
  Limits limits = Limits::hard;
};

// Returns true if a name is that of a file, by its ending: .toml, or a URDF file (urdf.hpp).
bool is_arm_file(std::string_view name);
// The next three throw std::invalid_argument with the place in the file, the mistake, and what is expected. An arm gets
// the name of its file without the ending.
// Reads an arm from the text of a TOML file.
Robot parse_robot(std::string_view text, const std::filesystem::path& file);
// Returns the text of a file that the user named.
std::string text_of_arm_file(const std::filesystem::path& file);
// Reads an arm from a TOML or URDF file.
Robot load_robot(const std::filesystem::path& file, const UrdfChoice& choice = {});

// Returns the arm in the definition of a stored study, to the rounding of its degrees; nullopt if the JSON is no arm.
std::optional<Robot> stored_arm(std::string_view json);

}  // namespace ikbench::robots
