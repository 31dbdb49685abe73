// Arms from URDF files (http://wiki.ros.org/urdf/XML): a chain of joints between two links of a tree.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "robots/robot.hpp"

namespace ikbench::robots {

// True if a name means a URDF file, by its ending in any case: .urdf, or .xacro, which is refused with how to expand it
// if it needs to be.
bool is_urdf_file(std::string_view name);
// The tree of a file, a line each link and the joint before it.
std::string link_tree(std::string_view text, const std::filesystem::path& file);

// std::invalid_argument says where, what is wrong, and what is expected. The arm gets the name of the file without its
// ending.
Robot parse_urdf(std::string_view text, const std::filesystem::path& file, const UrdfChoice& choice);

}  // namespace ikbench::robots
