// Arms from URDF files (http://wiki.ros.org/urdf/XML): a chain of joints between two links of a tree.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "robots/robot.hpp"

namespace ikbench::robots {

// The choices that a URDF file leaves open.
struct UrdfChoice {
  enum class Limits { hard, soft };  // <limit>, or the tighter of it and <safety_controller>

  std::string base;  // a link; empty: the root of the tree, or the link after the last joint that floats
  std::string tip;   // a link; empty: the end of the tree with the most moving joints before it
  Limits limits = Limits::hard;
  double snap = least_snap;  // see snap() in description.hpp
};

// True if a name means a URDF file, by its ending in any case: .urdf, or .xacro, which is refused with how to expand it
// if it needs to be.
bool is_urdf_file(std::string_view name);
// The tree of a file, a line each link and the joint before it.
std::string link_tree(std::string_view text, const std::filesystem::path& file);

// std::invalid_argument says where, what is wrong, and what is expected. The arm gets the name of the file without its
// ending.
Robot parse_urdf(std::string_view text, const std::filesystem::path& file, const UrdfChoice& choice);

}  // namespace ikbench::robots
