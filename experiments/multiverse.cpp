#include "experiments/multiverse.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "experiments/study_writer.hpp"

namespace ikbench::experiments {

using namespace results;

namespace {

constexpr double most_combinations = 1e5, most_readings = 1e15;

const Alternative& alternative_of(const std::vector<Dimension>& dimensions, const Choice& choice) {
  return dimensions[choice.dimension].alternatives[choice.alternative];
}

bool is_excepted(const Alternative& alternative, const std::vector<Dimension>& dimensions, const Chosen& chosen) {
  return std::ranges::any_of(chosen, [&](const Choice& each) {
    const std::string& set = alternative_of(dimensions, each).set;
    return std::ranges::find(alternative.except, set) != alternative.except.end();
  });
}

void refuse_too_many(const std::vector<Dimension>& dimensions, std::string_view what, double count, double most) {
  if (count <= most) return;
  throw std::invalid_argument(fmt::format("{} dimensions make more than {:g} {}; choose fewer with --dimensions",
                                          dimensions.size(), most, what));
}

// Lists all choices that are possible together.
struct Combinations {
  const std::vector<Dimension>& dimensions;

  // The choices in the dimensions of one owner (a solver, or "" for the study), given others, which are not repeated.
  std::vector<Chosen> of(std::string_view owner, const Chosen& given) const {
    std::vector<Chosen> all{{}};
    for (std::size_t d = 0; d < dimensions.size(); ++d) {
      if (dimensions[d].solver != owner) continue;
      std::vector<Chosen> larger;
      for (const Chosen& chosen : all) {
        const Chosen possible = alternatives(d, given, chosen);
        if (possible.size() < 2) {  // nothing to choose
          larger.push_back(chosen);
          continue;
        }
        for (const Choice& each : possible) {
          larger.push_back(chosen);
          larger.back().push_back(each);
        }
        refuse_too_many(dimensions, "choices", static_cast<double>(larger.size()), most_combinations);
      }
      all = std::move(larger);
    }
    return all;
  }

 private:
  Chosen alternatives(std::size_t dimension, Chosen known, const Chosen& more) const {
    known.insert(known.end(), more.begin(), more.end());
    const std::vector<Alternative>& all = dimensions[dimension].alternatives;
    Chosen possible;
    for (std::size_t a = 0; a < all.size(); ++a) {
      if (!is_excepted(all[a], dimensions, known)) possible.push_back({dimension, a});
    }
    return possible;
  }
};

// A list of needed series, each once.
class SeriesList {
 public:
  // Adds one solver of the study; returns its place in `parts`.
  std::size_t add(const Study& study, std::size_t solver) {
    const auto [found, is_new] = known_.try_emplace(series_key(study, study.solvers[solver]), parts.size());
    if (is_new) {
      parts.push_back(study);
      parts.back().solvers = {study.solvers[solver]};
    }
    return found->second;
  }
  std::vector<Study> parts;

 private:
  std::map<std::string, std::size_t> known_;  // series key to place
};

// Adds defaults too: a solver's own default may differ from what the study's choice implies for it.
void add_overrides(Overrides& overrides, const std::vector<Dimension>& dimensions, const Chosen& chosen) {
  for (const Choice& each : chosen) overrides.push_back(alternative_of(dimensions, each).set);
}

}  // namespace

void refuse_varied(const Overrides& overrides, const std::vector<Dimension>& dimensions) {
  for (const std::string& text : overrides) {
    const std::string key = text.substr(0, text.find('='));
    if (key == "seed")
      throw std::invalid_argument(fmt::format("--set {}: the multiverse uses the seeds 1 to --seeds", text));
    if (std::ranges::find(dimensions, key, &Dimension::name) == dimensions.end()) continue;
    throw std::invalid_argument(fmt::format(
        "--set {}: {} is a dimension that varies; leave this out, or choose other dimensions with --dimensions", text,
        key));
  }
}

MultiverseSize size_of(const std::vector<Dimension>& dimensions, const std::vector<std::string>& solvers) {
  const Combinations combinations{dimensions};
  MultiverseSize size;
  double readings = 0;
  for (const Chosen& chosen : combinations.of("", {})) {
    double of_solvers = 1;
    for (const std::string& solver : solvers) {
      const std::size_t own = combinations.of(solver, chosen).size();
      size.series += static_cast<std::int64_t>(own);
      of_solvers *= static_cast<double>(own);
    }
    readings += of_solvers;
    ++size.studies;
    refuse_too_many(dimensions, "solver settings for a seed", static_cast<double>(size.series), most_combinations);
    refuse_too_many(dimensions, "readings", readings, most_readings);
  }
  size.readings = static_cast<std::int64_t>(readings);
  return size;
}

MultiversePlan plan_multiverse(const std::string& name, const std::vector<Dimension>& dimensions,
                               const MultiverseRequest& request) {
  refuse_varied(request.overrides, dimensions);
  MultiversePlan plan;
  plan.dimensions = dimensions;
  plan.solvers = labels_of(load_study(name, request.overrides));
  size_of(dimensions, plan.solvers);
  const Combinations combinations{dimensions};
  SeriesList needed;
  for (const Chosen& chosen : combinations.of("", {})) {
    MultiversePlan::OfStudy& of_study = plan.studies.emplace_back();
    of_study.chosen = chosen;
    Overrides all = request.overrides;
    add_overrides(all, dimensions, chosen);
    for (std::size_t s = 0; s < plan.solvers.size(); ++s) {
      std::vector<MultiversePlan::ChosenSolver>& of_solver = of_study.solvers.emplace_back();
      for (const Chosen& own : combinations.of(plan.solvers[s], chosen)) {
        of_solver.push_back({.chosen = own, .parts = {}});
        Overrides of_own = all;
        add_overrides(of_own, dimensions, own);
        Study study = load_study(name, of_own);
        for (int seed = 1; seed <= request.seeds; ++seed) {
          if (request.cancelled != nullptr && *request.cancelled) return plan;
          study.seed = static_cast<std::uint64_t>(seed);
          of_solver.back().parts.push_back(needed.add(study, s));
        }
      }
    }
  }
  plan.parts = std::move(needed.parts);
  return plan;
}

}  // namespace ikbench::experiments
