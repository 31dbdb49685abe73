// What a paper leaves open, as data: each open point is a dimension, its alternatives are what --set takes.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace ikbench::results {

// Which multiverse varies an alternative: the small one and the usual one, the usual one, or none by itself.
enum class Scope { small, usual, none };

struct Alternative {
  std::string set;                       // "bounds=initial"
  std::string where;                     // a clause: "no solver is clamped"
  Scope scope = Scope::none;             // the default is in each
  std::vector<std::string> except = {};  // earlier alternatives with which it has no effect, or which it contradicts
};

struct Dimension {
  std::string name;                       // what its alternatives set: "bounds", "IK-BA.acceptance"
  std::string section;                    // of the paper's notes
  std::string solver;                     // the label whose own it is; empty: the study's
  std::vector<Alternative> alternatives;  // the first is the default
  std::string open = {};                  // what is open, in words: "who obeys limits"; else as the name
};

// An alternative by its place, in a dimension by its place.
struct Choice {
  std::size_t dimension = 0, alternative = 0;
  bool operator==(const Choice&) const = default;
};
using Chosen = std::vector<Choice>;

}  // namespace ikbench::results
