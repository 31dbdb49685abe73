// Arms from URDF files (http://wiki.ros.org/urdf/XML): a chain of joints between two links of a tree.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "robots/robot.hpp"

namespace ikbench::robots {

// True if a name means a URDF file, by its ending in any case: .urdf, or .xacro, which is refused with how to expand it
// if it needs to be.
bool is_urdf_file(std::string_view name);
// The tree of a file, a line each link and the joint before it.
std::string link_tree(std::string_view text, const std::filesystem::path& file);

// Which link it is the file leaves open: the answers are options of a command.
struct LinkQuestion : std::invalid_argument {
  struct Answer {
    std::string option, link;
    int joints;
  };
  LinkQuestion(const std::string& what, std::vector<Answer> all) : invalid_argument(what), answers(std::move(all)) {}
  std::vector<Answer> answers;
};

// std::invalid_argument says where, what is wrong, and what is expected. The arm gets the name of the file without its
// ending.
Robot parse_urdf(std::string_view text, const std::filesystem::path& file, const UrdfChoice& choice);

// The arm that is judged as a URDF file's text, and nothing else: the joints of `chain`, which are its own or the first
// of them, and its limits. An arm of a URDF file has the numbers of that file. A coupled joint is followed by one that
// mimics it.
std::string urdf_of(const Robot& arm, const Chain& chain);
// The names in it: those of the arm's own file, else joint_1, ..., from "base" to "tool".
std::vector<std::string> joint_names(const Robot& arm);
inline std::string base_link_of(const Robot& arm) { return arm.base_link.empty() ? "base" : arm.base_link; }
inline std::string tip_link_of(const Robot& arm) { return arm.tip_link.empty() ? "tool" : arm.tip_link; }

}  // namespace ikbench::robots
