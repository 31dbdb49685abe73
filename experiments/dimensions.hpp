// The open points of a built-in study, from the file of its name in multiverse/.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/study_reader.hpp"
#include "results/dimension.hpp"

namespace ikbench::experiments {

// The dimensions of a built-in study, read from multiverse/NAME.toml in the program; none if there is no such file.
std::vector<results::Dimension> dimensions(std::string_view study);
// Parses them from a text; std::invalid_argument says where it is wrong. `labels` are the labels of the study's
// solvers.
std::vector<results::Dimension> parse_dimensions(std::string_view toml, std::string_view source,
                                                 const std::vector<std::string>& labels);

// The dimensions that a multiverse varies: each keeps its default and the alternatives of that scope; one without such
// alternatives is left out.
std::vector<results::Dimension> within(results::Scope scope, std::vector<results::Dimension> dimensions);
// The named dimensions with all their alternatives; std::invalid_argument if a name is unknown or stands twice.
std::vector<results::Dimension> named(const std::vector<std::string>& names,
                                      const std::vector<results::Dimension>& dimensions);

}  // namespace ikbench::experiments
