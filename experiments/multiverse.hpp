// What a paper leaves open (multiverse/NAME.toml), all combinations of it, and the solves to judge claims in each of
// them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/runner.hpp"
#include "experiments/study_reader.hpp"
#include "results/dimension.hpp"

namespace ikbench::experiments {

// The dimensions of a built-in study, read from multiverse/NAME.toml in the program; none if there is no such file.
std::vector<results::Dimension> dimensions(std::string_view study);

struct MultiversePlan : results::Multiverse {
  // One solver and one seed each, each series once, in the order of first need. Settings that do not change its key
  // share a part.
  std::vector<Study> parts;
};

// With seeds 1, 2, ...; the overrides apply in every reading.
MultiversePlan plan_multiverse(const std::string& study, const std::vector<results::Dimension>& dimensions, int seeds,
                               const Overrides& overrides);

// One value per run, the mean over its points; not finite if an answer is not.
struct PartMeans {
  std::vector<double> error_cm, variation_deg;
};

// Solves the parts of a plan. Returns the means of each, in their order; none if the request was cancelled. Of the
// request only jobs (parts at once), progress and cancelled count.
std::vector<PartMeans> solve_parts(const std::vector<Study>& parts, const RunRequest& request);

}  // namespace ikbench::experiments
