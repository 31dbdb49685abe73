#include "analysis/show/map_sentence.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "analysis/show/text.hpp"
#include "base/json.hpp"
#include "base/names.hpp"

namespace ikbench::show {

using namespace judge;

namespace {

// Solvers, each with a number of targets.
using Numbers = std::vector<std::pair<std::string, std::size_t>>;

// The words for one target, or one solver, and for several.
struct Words {
  std::string one, many;
};

// Returns how many targets each solver solves.
Numbers reached_by(const SolvedTargets& all, const std::vector<std::string>& solvers) {
  Numbers reached;
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

// Returns the range of the numbers from `first` on: "2 other solvers miss 5 to 523".
std::string others_text(const Numbers& numbers, std::size_t first, const Words& verb) {
  std::size_t fewest = numbers[first].second, most = fewest;
  for (std::size_t i = first; i < numbers.size(); ++i) {
    fewest = std::min(fewest, numbers[i].second);
    most = std::max(most, numbers[i].second);
  }
  const std::string range = fewest == most ? fmt::format("{} each", most) : fmt::format("{} to {}", fewest, most);
  return fmt::format("{} other solvers {} {}", numbers.size() - first, verb.many, range);
}

// Returns "LM reaches 26 poses, DLS 26 and Newton 25"; of many solvers the first are named, and the others have a
// range. Without nouns the first number has none.
std::string numbers_text(const Numbers& numbers, const Words& verb, const std::optional<Words>& nouns = {}) {
  const std::size_t named = numbers.size() > base::max_named ? base::max_named - 1 : numbers.size();
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < named; ++i) {
    const auto& [name, number] = numbers[i];
    std::string part = fmt::format("{} {}{}", name, i == 0 ? verb.one + ' ' : "", number);
    if (i == 0 && nouns) part += ' ' + (number == 1 ? nouns->one : nouns->many);
    parts.push_back(std::move(part));
  }
  if (named < numbers.size()) return fmt::format("{}; {}", fmt::join(parts, ", "), others_text(numbers, named, verb));
  const bool are_two_misses = parts.size() == 2 && !nouns;
  return are_two_misses ? fmt::format("{}, {}", parts[0], parts[1]) : listed(parts);
}

// Returns who reaches how many of the solvable targets.
std::string reached_text(const SolvedTargets& all, const Numbers& reached, const Words& nouns) {
  const auto solvable = all.targets.size() - static_cast<std::size_t>(std::ranges::count(all.targets, std::size_t{0},
                                                                                         &SolvedTarget::solvers));
  const bool is_alone = reached.size() == 1;
  const std::string& first = reached.front().first;
  if (solvable == 0 && all.targets.size() == 1)
    return is_alone ? fmt::format("{} does not reach the only {}", first, nouns.one)
                    : fmt::format("No solver reaches the only {}", nouns.one);
  if (solvable == 0)
    return is_alone ? fmt::format("{} reaches none of the {} {}", first, all.targets.size(), nouns.many)
                    : fmt::format("No solver reaches any of the {} {}", all.targets.size(), nouns.many);
  const std::string counted = fmt::format("{} {}", solvable, solvable == 1 ? nouns.one : nouns.many);
  if (is_alone) return fmt::format("{} reaches {}", first, counted);
  std::vector<std::string> complete;
  Numbers missed;
  for (const auto& [name, count] : reached) {
    if (count == solvable)
      complete.push_back(name);
    else
      missed.emplace_back(name, solvable - count);
  }
  if (missed.empty()) return fmt::format("{} reach the same {}", names_of(complete), counted);
  const std::string misses = numbers_text(missed, {"misses", "miss"});
  if (complete.empty()) return fmt::format("No solver reaches all {} that any solver reaches: {}", counted, misses);
  return fmt::format("{} {} {} that any solver reaches; {}", names_of(complete),
                     complete.size() == 1 ? "reaches" : "reach",
                     solvable == 1 ? "the one " + nouns.one : "all " + counted, misses);
}

}  // namespace

std::string map_sentence(const JudgedStudy& judged, const std::vector<std::string>& solvers) {
  const SolvedTargets& all = judged.targets;
  const results::StudyDefinition& definition = judged.study.definition;
  const Words nouns = definition.has_direction() ? Words{"pose", "poses"} : Words{"position", "positions"};
  const auto unsolved = std::ranges::count(all.targets, std::size_t{0}, &SolvedTarget::solvers);
  const Numbers reached = reached_by(all, solvers);
  const std::string grid = as_sentence(definition.grid_text());
  if (!all.is_complete)
    return fmt::format("Solves are missing. So far, {}. {}.", numbers_text(reached, {"reaches", "reach"}, nouns), grid);
  const std::string who = reached_text(all, reached, nouns);
  if (unsolved == 0 || unsolved == std::ssize(all.targets)) return fmt::format("{}. {}.", who, grid);
  return fmt::format("{}. {}; {}, perhaps out of reach, {} solved by none.", who, grid,
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
