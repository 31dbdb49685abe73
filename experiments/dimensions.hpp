// The open points of a built-in study, from the file of its name in multiverse/.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/study_reader.hpp"
#include "results/dimension.hpp"

namespace ikbench::experiments {

// Those of a built-in study, which the build carries in the program: the file of its name in multiverse/. None where
// there is no such file.
std::vector<results::Dimension> dimensions(std::string_view study);
// The same from a text; std::invalid_argument says where it is wrong. `labels` are those of the study's solvers.
std::vector<results::Dimension> parse_dimensions(std::string_view toml, std::string_view source,
                                                 const std::vector<std::string>& labels);

// What a multiverse varies: the default with the alternatives of that scope; dimensions without one are left out.
std::vector<results::Dimension> within(results::Scope scope, std::vector<results::Dimension> dimensions);
// The named ones with all their alternatives; std::invalid_argument where a name is unknown or stands twice.
std::vector<results::Dimension> named(const std::vector<std::string>& names,
                                      const std::vector<results::Dimension>& dimensions);

}  // namespace ikbench::experiments
