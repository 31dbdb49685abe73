// A study from TOML: every mistake in one sentence with file, line, column, value and what was expected.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/study.hpp"

namespace ikbench::experiments {

// "key=value" over what the study says: `runs=5`, `path.tool=eq27`, or an option of the solvers with that label or
// solver: `IK-BA.bounds=clamp`.
using Overrides = std::vector<std::string>;

// Whether points of a run may be the observations of the analysis (analysis.unit = "point").
enum class PointsAsObservations { refused, forced };
constexpr std::string_view why_points_are_refused =
    "points of one run depend on each other and are no replicates; a study of several runs has them; to insist: "
    "--force";

// Both: std::invalid_argument says where, what is wrong, and what is expected; an unknown key names the nearest known.
Study parse_study(std::string_view toml, std::string_view source, const Overrides& overrides = {},
                  PointsAsObservations points_as_observations = PointsAsObservations::refused);
// The built-in studies by name: the files of studies/, which the build carries in the program (embed.cmake).
std::vector<Study> studies();
// A built-in study by name, or else a file.
Study load_study(const std::string& name_or_file, const Overrides& overrides = {},
                 PointsAsObservations points_as_observations = PointsAsObservations::refused);

}  // namespace ikbench::experiments
