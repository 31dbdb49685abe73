// An arm by name: its chain and its joint limits, from robots/arms/ or from a user's file.
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

struct JointLimits {
  Configuration lower, upper;  // [rad], or [m] if it slides; Eq. 4; infinite if it turns without end

  // Violation of the worst joint, in its unit; 0 inside.
  double violation(const ConfigurationRef& q) const;
  // Limits that are finite for every joint: one that turns without end gets `each_way` on both sides of its value in
  // `middle`. Half a turn is for drawing. A whole turn is for methods that need limits: it contains every direction of
  // the joint at least half a turn from both ends.
  JointLimits around(const ConfigurationRef& middle, double each_way = half_turn) const;
};

// True if a joint with these limits turns without end.
inline bool is_endless(double lower, double upper) { return !std::isfinite(upper - lower); }

struct Robot {
  std::string name;
  std::string summary;
  std::string source;  // of the numbers
  Chain chain;
  JointLimits limits;
  Configuration velocity = {};                // the largest of each joint [rad/s, m/s]; 0, or empty: not known
  Description description = {};               // as in a URDF file; empty: the chain says all
  std::vector<std::string> notes = {};        // parts of its file that were not taken as they stand
  std::string base_link = {}, tip_link = {};  // of a URDF file
  std::string other_tip = {};                 // that moves with tip_link, which was chosen between them

  int joints() const { return chain.joints(); }
};

// "6 joints, reach 0.95 m, tool 0.1 m from the last joint; --tip flange for another".
std::string size_of(const Robot& arm);
// What hints at other units than metres and radians.
std::vector<std::string> doubts_of(const Robot& arm);

// The built-in arms, by name.
std::vector<Robot> all_robots();
// One of them; std::invalid_argument lists the names.
Robot robot(std::string_view name);

// The choices that a URDF file leaves open.
struct UrdfChoice {
  enum class Limits { hard, soft };  // <limit>, or the tighter of it and <safety_controller>

  std::string base;  // a link; empty: the root of the tree, or the link after the last joint that floats
  std::string tip;   // a link; empty: the end behind the most joints, without a hand
  Limits limits = Limits::hard;
};

// True if a name means a file, by its ending: .toml, or a URDF file (urdf.hpp).
bool is_arm_file(std::string_view name);
// All throw std::invalid_argument with the place, the mistake, and what is expected. The arm gets the name of the file
// without its ending.
Robot parse_robot(std::string_view text, const std::filesystem::path& file);
std::string text_of_arm_file(const std::filesystem::path& file);
Robot load_robot(const std::filesystem::path& file, const UrdfChoice& choice = {});

// The arm in the definition of a stored study, to the rounding of its degrees; empty if no arm file can be it.
std::optional<Robot> stored_arm(std::string_view json);

}  // namespace ikbench::robots
