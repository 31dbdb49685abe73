// The multiverse of a paper: the points that the paper leaves open (multiverse/NAME.toml), all combinations of their
// alternatives, and the solves by which claims are judged in each. Only `ikbench reproduce` uses it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/runner.hpp"
#include "experiments/study/reader.hpp"
#include "results/dimension.hpp"

namespace ikbench::experiments {

// Returns the dimensions of a built-in study, read from multiverse/NAME.toml in the program; none if there is no such
// file.
std::vector<results::Dimension> read_dimensions(std::string_view study);

// The interpretations of a study (`readings`) and the solves that they need.
struct MultiversePlan : results::Multiverse {
  // Studies of one solver and one seed each, each series once, in the order of first need. Interpretations whose
  // settings do not change the key of a series share a part.
  std::vector<Study> parts;
};

// Plans all interpretations of the study `name` with the seeds 1, 2, ... `seeds`. The overrides apply in every
// interpretation. Throws std::invalid_argument as load_study does.
MultiversePlan plan_multiverse(const std::string& name, const std::vector<results::Dimension>& dimensions, int seeds,
                               const Overrides& overrides);

// The means of each run over its points, one value per run. A value is not finite if an answer is not.
struct SeriesMeans {
  std::vector<double> error_cm, variation_deg;
};

// Solves the parts of a plan. Returns the means of each part, in the order of the parts; none if the request was
// cancelled. Of the request, only `jobs` (parts at once), `progress` and `cancelled` are used.
std::vector<SeriesMeans> solve_multiverse(const std::vector<Study>& parts, const RunRequest& request);

}  // namespace ikbench::experiments
