#include "experiments/multiverse.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "experiments/series_key.hpp"

namespace ikbench::experiments {

namespace {

constexpr double most_combinations = 1e5, most_universes = 1e15;

const Alternative& alternative_of(const std::vector<Dimension>& dimensions, const Choice& choice) {
  return dimensions[choice.dimension].alternatives[choice.alternative];
}

bool is_excepted(const Alternative& alternative, const std::vector<Dimension>& dimensions, const Chosen& chosen) {
  return std::ranges::any_of(chosen, [&](const Choice& each) {
    const std::string& set = alternative_of(dimensions, each).set;
    return std::ranges::find(alternative.except, set) != alternative.except.end();
  });
}

// With its share where the alternatives of a dimension have equal parts of what was chosen before it.
struct Branch {
  Chosen chosen = {};
  double weight = 1;
};

// Every choice in the dimensions of one owner (a solver, or "" for the study), beside those that are given. What is in
// `given` is not repeated.
std::vector<Branch> every_choice(const std::vector<Dimension>& dimensions, std::string_view owner,
                                 const Chosen& given) {
  std::vector<Branch> all{{}};
  for (std::size_t d = 0; d < dimensions.size(); ++d) {
    if (dimensions[d].solver != owner) continue;
    std::vector<Branch> larger;
    for (const Branch& branch : all) {
      Chosen known = given;
      known.insert(known.end(), branch.chosen.begin(), branch.chosen.end());
      Chosen possible;
      for (std::size_t a = 0; a < dimensions[d].alternatives.size(); ++a) {
        if (!is_excepted(dimensions[d].alternatives[a], dimensions, known)) possible.push_back({d, a});
      }
      if (possible.size() < 2) possible.clear();  // nothing to choose
      if (possible.empty()) larger.push_back(branch);
      for (const Choice& each : possible) {
        larger.push_back({branch.chosen, branch.weight / static_cast<double>(possible.size())});
        larger.back().chosen.push_back(each);
      }
    }
    all = std::move(larger);
  }
  return all;
}

void refuse_too_many(const std::vector<Dimension>& dimensions, std::string_view what, double count, double most) {
  if (count <= most) return;
  throw std::invalid_argument(
      fmt::format("{} dimensions make up to {:.3g} {}; expected at most {:g}; choose fewer with "
                  "--dimensions",
                  dimensions.size(), count, what, most));
}

double every_choice_counted(const std::vector<Dimension>& dimensions, std::string_view owner) {
  double count = 1;
  for (const Dimension& each : dimensions) {
    if (each.solver == owner) count *= static_cast<double>(each.alternatives.size());
  }
  return count;
}

// The defaults among them too: a solver's own may differ from what the study's choice would make of it.
void add_overrides(Overrides& overrides, const std::vector<Dimension>& dimensions, const Chosen& chosen) {
  for (const Choice& each : chosen) overrides.push_back(alternative_of(dimensions, each).set);
}

void refuse_varied(const Overrides& overrides, const std::vector<Dimension>& dimensions) {
  for (const std::string& text : overrides) {
    const std::string key = text.substr(0, text.find('='));
    if (std::ranges::find(dimensions, key, &Dimension::name) == dimensions.end()) continue;
    throw std::invalid_argument(fmt::format(
        "--set {}: {} is a dimension that varies; leave this out, or choose other dimensions with --dimensions", text,
        key));
  }
}

}  // namespace

std::size_t SeriesList::add(const Study& study, std::size_t solver) {
  const auto [found, is_new] = known_.try_emplace(series_key(study, study.solvers[solver]), parts.size());
  if (is_new) {
    parts.push_back(study);
    parts.back().solvers = {study.solvers[solver]};
  }
  return found->second;
}

void refuse_seed(const Overrides& overrides) {
  for (const std::string& text : overrides) {
    if (!text.starts_with("seed=")) continue;
    throw std::invalid_argument(fmt::format("--set {}: interpretations use the seeds 1 to --seeds", text));
  }
}

MultiverseSize size_of(const std::vector<Dimension>& dimensions, const std::vector<std::string>& solvers) {
  double bound = 0;
  for (const std::string& solver : solvers) bound += every_choice_counted(dimensions, solver);
  refuse_too_many(dimensions, "choices for the study", every_choice_counted(dimensions, ""), most_combinations);
  refuse_too_many(dimensions, "series for a seed", every_choice_counted(dimensions, "") * bound, most_combinations);
  MultiverseSize size;
  double universes = 0;
  for (const Branch& branch : every_choice(dimensions, "", {})) {
    double of_solvers = 1;
    for (const std::string& solver : solvers) {
      const std::size_t own = every_choice(dimensions, solver, branch.chosen).size();
      size.series += static_cast<std::int64_t>(own);
      of_solvers *= static_cast<double>(own);
    }
    universes += of_solvers;
    ++size.studies;
  }
  refuse_too_many(dimensions, "universes", universes, most_universes);
  size.universes = static_cast<std::int64_t>(universes);
  return size;
}

MultiversePlan plan_multiverse(const std::string& name, const std::vector<Dimension>& dimensions, int seeds,
                               const Overrides& overrides) {
  refuse_seed(overrides);
  refuse_varied(overrides, dimensions);
  MultiversePlan plan{.dimensions = dimensions};
  for (const SolverEntry& entry : load_study(name, overrides).solvers) plan.solvers.push_back(entry.label);
  size_of(dimensions, plan.solvers);
  SeriesList needed;
  for (const auto& [chosen, weight] : every_choice(dimensions, "", {})) {
    MultiversePlan::OfStudy& of_study = plan.studies.emplace_back();
    of_study.chosen = chosen;
    of_study.weight = weight;
    Overrides all = overrides;
    add_overrides(all, dimensions, chosen);
    of_study.out_of_reach = static_cast<int>(unreachable(load_study(name, all)).size());
    for (std::size_t s = 0; s < plan.solvers.size(); ++s) {
      std::vector<MultiversePlan::Own>& of_solver = of_study.solvers.emplace_back();
      for (const Branch& own : every_choice(dimensions, plan.solvers[s], chosen)) {
        of_solver.push_back({.chosen = own.chosen, .parts = {}});
        Overrides of_own = all;
        add_overrides(of_own, dimensions, own.chosen);
        of_own.emplace_back();
        for (int seed = 1; seed <= seeds; ++seed) {
          of_own.back() = fmt::format("seed={}", seed);
          of_solver.back().parts.push_back(needed.add(load_study(name, of_own), s));
        }
      }
    }
  }
  plan.parts = std::move(needed.parts);
  return plan;
}

}  // namespace ikbench::experiments
