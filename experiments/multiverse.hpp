// What a paper leaves open (multiverse/NAME.toml), all combinations of it, and the solves to judge claims in each of
// them.
#pragma once

#include <atomic>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/runner.hpp"
#include "experiments/study_reader.hpp"
#include "results/dimension.hpp"

namespace ikbench::experiments {

// The dimensions of a built-in study, read from multiverse/NAME.toml in the program; none if there is no such file.
std::vector<results::Dimension> dimensions(std::string_view study);

// The dimensions that a multiverse varies: each keeps its default and the alternatives of that scope; one without such
// alternatives is left out.
std::vector<results::Dimension> within(results::Scope scope, std::vector<results::Dimension> dimensions);
// The named dimensions with all their alternatives; std::invalid_argument if a name is unknown or stands twice.
std::vector<results::Dimension> named(const std::vector<std::string>& names,
                                      const std::vector<results::Dimension>& dimensions);

struct MultiversePlan : results::Multiverse {
  // One solver and one seed each, each series once, in the order of first need. The series key of a solver and
  // the plan decide its numbers, so choices that change neither share a part.
  std::vector<Study> parts;
};

// All choices, before anything is loaded or solved. Throws std::invalid_argument for more than 100000 choices or series
// per seed, or more than 10^15 readings.
results::Multiverse choices_of(const std::vector<results::Dimension>& dimensions,
                               const std::vector<std::string>& solvers);

struct MultiverseRequest {
  int seeds = 1;                                 // seeds 1, 2, ...
  Overrides overrides = {};                      // apply in every reading
  const std::atomic<bool>* cancelled = nullptr;  // set: the plan is incomplete and of no use
};

// Throws std::invalid_argument for an override of the seed or of a dimension.
void refuse_varied(const Overrides& overrides, const std::vector<results::Dimension>& dimensions);

// Checks the overrides, too.
MultiversePlan plan_multiverse(const std::string& study, const std::vector<results::Dimension>& dimensions,
                               const MultiverseRequest& request = {});

// One value per run, the mean over its points, or per point, as the plan says; not finite if an answer is not.
struct PartMeans {
  std::vector<double> error_cm, variation_deg;
};

// Solves the parts of a plan. Returns the means of each, in their order; none if the request was cancelled. Of the
// request only jobs (parts at once), progress and cancelled count.
std::vector<PartMeans> solve_parts(const std::vector<Study>& parts, const RunRequest& request);

}  // namespace ikbench::experiments
