#include "analysis/show/map_sentence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "analysis/show/text.hpp"
#include "base/json.hpp"

namespace ikbench::show {

using namespace judge;

namespace {

// A solver with the number of targets that it solves.
using Reached = std::pair<std::string, std::size_t>;

std::vector<Reached> reached_by(const SolvedTargets& all, const std::vector<std::string>& solvers) {
  std::vector<Reached> reached;
  for (const std::string& name : solvers) {
    const auto solver = static_cast<std::size_t>(std::ranges::find(all.solvers, name) - all.solvers.begin());
    if (solver == all.solvers.size()) continue;
    std::size_t count = 0;
    for (std::size_t target = 0; target < all.targets.size(); ++target)
      if (all.solves(solver, target)) ++count;
    reached.emplace_back(name, count);
  }
  return reached;
}

// Returns "Newton misses 2, DE 5 and KDL 523", of many solvers only the first.
std::string misses_text(const std::vector<Reached>& reached, std::size_t solvable) {
  std::vector<std::string> parts;
  for (const auto& [name, count] : reached) {
    if (count == solvable) continue;
    parts.push_back(fmt::format("{} {}{}", name, parts.empty() ? "misses " : "", solvable - count));
  }
  return parts.size() == 2 ? fmt::format("{}, {}", parts[0], parts[1]) : names_of(parts);
}

// Returns "LM reaches 26 poses, DLS 26 and Newton 25".
std::string counts_text(const std::vector<Reached>& reached, const std::string& noun) {
  std::vector<std::string> parts;
  for (const auto& [name, count] : reached)
    parts.push_back(parts.empty() ? fmt::format("{} reaches {} {}", name, count, noun)
                                  : fmt::format("{} {}", name, count));
  return names_of(parts);
}

// Returns who reaches how many of the solvable targets.
std::string reached_text(const SolvedTargets& all, const std::vector<Reached>& reached, const std::string& noun) {
  const auto solvable = all.targets.size() - static_cast<std::size_t>(std::ranges::count(all.targets, std::size_t{0},
                                                                                         &SolvedTarget::solvers));
  const bool is_alone = reached.size() == 1;
  if (solvable == 0 && is_alone)
    return fmt::format("{} reaches none of the {} {}", reached.front().first, all.targets.size(), noun);
  if (solvable == 0) return fmt::format("No solver reaches any of the {} {}", all.targets.size(), noun);
  std::vector<std::string> complete;
  for (const auto& [name, count] : reached)
    if (count == solvable) complete.push_back(name);
  if (is_alone) return fmt::format("{} reaches {} {}", reached.front().first, solvable, noun);
  if (complete.size() == reached.size())
    return fmt::format("{} reach the same {} {}", names_of(complete), solvable, noun);
  const std::string misses = misses_text(reached, solvable);
  if (complete.empty())
    return fmt::format("No solver reaches all {} {} that any solver reaches: {}", solvable, noun, misses);
  return fmt::format("{} {} all {} {} that any solver reaches; {}", names_of(complete),
                     complete.size() == 1 ? "reaches" : "reach", solvable, noun, misses);
}

}  // namespace

std::string map_sentence(const JudgedStudy& judged, const std::vector<std::string>& solvers) {
  const SolvedTargets& all = judged.targets;
  const results::StudyDefinition& definition = judged.study.definition;
  const std::string noun = definition.has_direction() ? "poses" : "positions";
  const auto unsolved = std::ranges::count(all.targets, std::size_t{0}, &SolvedTarget::solvers);
  const std::vector<Reached> reached = reached_by(all, solvers);
  const std::string grid = as_sentence(definition.grid_text());
  if (!all.is_complete) return fmt::format("Solves are missing. So far, {}. {}.", counts_text(reached, noun), grid);
  const std::string who = reached_text(all, reached, noun);
  if (unsolved == 0 || unsolved == std::ssize(all.targets)) return fmt::format("{}. {}.", who, grid);
  return fmt::format("{}. {}; {} within reach {} solved by none.", who, grid,
                     unsolved == 1 ? "one other" : fmt::format("{} others", unsolved), unsolved == 1 ? "is" : "are");
}

std::vector<std::string> map_notes(const StudyResults& study) {
  std::vector<std::string> notes{
      "The targets are a grid, not a random sample: there are no intervals, tests or ranks."};
  const int left_out = study.definition.grid.left_out;
  if (left_out > 0)
    notes.push_back(fmt::format("{} certainly out of reach, and {} not solved for.",
                                left_out == 1 ? "One more target is" : fmt::format("{} more targets are", left_out),
                                left_out == 1 ? "was" : "were"));
  for (const results::Series& series : study.series) {
    const auto options = base::parsed_ordered_json(series.options);
    const auto iterations = options.is_object() ? options.find("iterations") : options.end();
    const bool is_limit =
        options.is_object() && iterations != options.end() && iterations->is_number() && iterations->get<double>() > 0;
    if (is_limit)
      notes.push_back(fmt::format("{} stops after its own {} iterations.", series.label, base::text_of(*iterations)));
  }
  return notes;
}

}  // namespace ikbench::show
