// Reads arms from URDF files (http://wiki.ros.org/urdf/XML), as a chain of joints between two links of a tree, and
// writes them.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "robots/robot.hpp"

namespace ikbench::robots {

// Returns true for the name of a URDF file, by its ending in upper or lower case: .urdf or .xacro. A .xacro file that
// has to be expanded is refused when it is read, with how to expand it.
bool is_urdf_file(std::string_view name);
// Returns the tree of a file, one line per link with the joint before it.
std::string link_tree(std::string_view text, const std::filesystem::path& file);

// The exception for a file that leaves open where the arm begins or ends. The answers are options of a command.
struct LinkQuestion : std::invalid_argument {
  struct Answer {
    std::string option, link;
    int joints;  // of the arm that the answer chooses
  };
  LinkQuestion(const std::string& what, std::vector<Answer> choices)
      : invalid_argument(what), answers(std::move(choices)) {}
  std::vector<Answer> answers;
};

// Reads an arm. The arm gets the name of the file without its ending. Throws std::invalid_argument, which says where
// the mistake is, what is wrong and what is expected; and LinkQuestion.
Robot parse_urdf(std::string_view text, const std::filesystem::path& file, const UrdfChoice& choice);

// Returns the arm as the text of a URDF file, with joints and limits only. The joints are those of `chain`: all joints
// of the arm, or its first ones. An arm of a URDF file keeps the numbers of that file. A coupled joint is followed by
// one that mimics it.
std::string urdf_of(const Robot& arm, const Chain& chain);
// Returns the names of the joints in that text: those of the arm's own file, otherwise joint_1, joint_2, ...
std::vector<std::string> joint_names(const Robot& arm);
// These two return the first and the last link in that text.
inline std::string base_link_of(const Robot& arm) { return arm.base_link.empty() ? "base" : arm.base_link; }
inline std::string tip_link_of(const Robot& arm) { return arm.tip_link.empty() ? "tool" : arm.tip_link; }

}  // namespace ikbench::robots
