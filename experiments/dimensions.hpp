// What a paper leaves open, as data: each open point is a dimension, its alternatives are what --set takes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/study_reader.hpp"

namespace ikbench::experiments {

// Which multiverse varies an alternative: the small one and the usual one, the usual one, or none by itself.
enum class Scope { small, usual, none };

struct Alternative {
  std::string set;                       // "bounds=initial"
  std::string where;                     // a clause: "no solver is clamped"
  Scope scope = Scope::none;             // the default is in each
  std::vector<std::string> except = {};  // earlier alternatives with which it has no effect, or which it contradicts

  std::string sentence() const;  // "No solver is clamped."
};

struct Dimension {
  std::string name;                       // what its alternatives set: "bounds", "IK-BA.acceptance"
  std::string section;                    // of the paper's notes
  std::string solver;                     // the label whose own it is; empty: the study's
  std::vector<Alternative> alternatives;  // the first is the default
};

// Those of a built-in study, which the build carries in the program: the file of its name in multiverse/. None where
// there is no such file.
std::vector<Dimension> dimensions(std::string_view study);
// The same from a text; std::invalid_argument says where it is wrong. `labels` are those of the study's solvers.
std::vector<Dimension> parse_dimensions(std::string_view toml, std::string_view source,
                                        const std::vector<std::string>& labels);

// What a multiverse varies: the default with the alternatives of that scope; dimensions without one are left out.
std::vector<Dimension> within(Scope scope, std::vector<Dimension> dimensions);
// The named ones with all their alternatives; std::invalid_argument where a name is unknown or stands twice.
std::vector<Dimension> named(const std::vector<std::string>& names, const std::vector<Dimension>& dimensions);

// An alternative by its place, in a dimension by its place.
struct Choice {
  std::size_t dimension = 0, alternative = 0;
  bool operator==(const Choice&) const = default;
};
using Chosen = std::vector<Choice>;

}  // namespace ikbench::experiments
