// The family of an arm, by which of its axes are parallel or meet in a point, and what closed form of its inverse
// kinematics is known. Only what holds for every configuration counts.
#pragma once

#include <string>

#include "robots/chain.hpp"

namespace ikbench::robots {

struct Family {
  std::string name;         // "three parallel axes (2 to 4), offset wrist"
  std::string closed_form;  // whether one is known, with the source
  bool has_closed_form = false;
};

// Axes are parallel if the sine between them, and meet if the distance between them [m], is at most 1e-9.
Family family_of(const Chain& arm);

}  // namespace ikbench::robots
