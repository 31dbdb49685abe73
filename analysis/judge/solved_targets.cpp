#include "analysis/judge/solved_targets.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>

namespace ikbench::judge {

namespace {

using Bits = std::vector<std::uint64_t>;  // a bit per target

constexpr std::size_t most_solvers_of_triples = 50;

// Returns all targets of a study, without outcomes.
std::vector<SolvedTarget> targets_of(const StudyResults& study) {
  const bool has_own_targets = study.definition.draws_targets && study.definition.runs > 1;
  std::vector<std::pair<int, int>> places;
  for (const SolveSummary& solve : study.solves) places.emplace_back(has_own_targets ? solve.run : 0, solve.point);
  std::ranges::sort(places);
  places.erase(std::unique(places.begin(), places.end()), places.end());
  std::vector<SolvedTarget> targets;
  for (const auto& [run, point] : places) targets.push_back({.run = run, .point = point});
  return targets;
}

// Adds a solve that solved the target.
void add_success(SolvedTarget& target, const SolveSummary& solve, std::size_t solver, bool is_imported) {
  const auto is_less = [](const auto& best, auto value) { return !best || value < best->second; };
  const bool is_counted = solve.counted_by != results::CountedBy::none;
  if (is_counted && is_less(target.fewest_evaluations, solve.evaluations))
    target.fewest_evaluations.emplace(solver, solve.evaluations);
  const bool is_timed = results::is_timed_alone(solve.timing);
  if (!is_imported && is_timed && std::isfinite(solve.seconds) && is_less(target.least_seconds, solve.seconds))
    target.least_seconds.emplace(solver, solve.seconds);
}

// Finds the set of solvers that together solve most targets.
class LargestUnion {
 public:
  explicit LargestUnion(const std::vector<Bits>& solved) : solved_(solved) {}

  // Returns the first of the largest sets of so many solvers, and the number of targets that the set solves.
  std::pair<std::vector<std::size_t>, std::size_t> of(std::size_t solvers) {
    most_ = 0;
    chosen_.clear();
    extend(0, solvers, Bits(solved_.front().size()));
    return {best_, most_};
  }

 private:
  const std::vector<Bits>& solved_;
  std::vector<std::size_t> chosen_ = {}, best_ = {};
  std::size_t most_ = 0;

  void extend(std::size_t first, std::size_t missing, const Bits& before) {
    for (std::size_t solver = first; solver + missing <= solved_.size(); ++solver) {
      Bits now = before;
      std::size_t count = 0;
      for (std::size_t i = 0; i < now.size(); ++i) {
        now[i] |= solved_[solver][i];
        count += static_cast<std::size_t>(std::popcount(now[i]));
      }
      chosen_.push_back(solver);
      if (missing > 1) extend(solver + 1, missing - 1, now);
      if (missing == 1 && count > most_) {
        most_ = count;
        best_ = chosen_;
      }
      chosen_.pop_back();
    }
  }
};

// Returns the targets that each of these solvers solves.
std::vector<Bits> bits_of(const SolvedTargets& all, const std::vector<std::size_t>& solvers) {
  std::vector<Bits> solved(solvers.size(), Bits((all.targets.size() + 63) / 64));
  for (std::size_t s = 0; s < solvers.size(); ++s) {
    for (std::size_t target = 0; target < all.targets.size(); ++target)
      if (all.solves(solvers[s], target)) solved[s][target / 64] |= std::uint64_t{1} << target % 64;
  }
  return solved;
}

}  // namespace

SolvedTargets solved_targets(const StudyResults& study) {
  SolvedTargets all;
  if (!study.definition.has_tolerance()) return all;
  all.targets = targets_of(study);
  all.are_repeated = !study.definition.draws_targets && study.definition.runs > 1;
  std::set<std::size_t> counts;
  for (const std::string& label : study.labels) {
    const std::size_t count = study.of(label).size();
    if (count == 0) continue;
    all.solvers.push_back(label);
    counts.insert(count);
  }
  const std::size_t solves =
      static_cast<std::size_t>(study.definition.runs) * static_cast<std::size_t>(study.definition.points);
  all.is_complete = counts == std::set{solves};
  all.is_solved.resize(all.targets.size() * all.solvers.size());
  const auto place_of = [](const SolvedTarget& target) { return std::pair(target.run, target.point); };
  for (std::size_t solver = 0; solver < all.solvers.size(); ++solver) {
    const bool is_imported = study.imported.has(all.solvers[solver]);
    for (const SolveSummary& solve : study.of(all.solvers[solver])) {
      if (solve.status != results::Status::ok) continue;
      const int run = all.targets.front().run == 0 ? 0 : solve.run;
      const auto target = std::ranges::lower_bound(all.targets, std::pair(run, solve.point), {}, place_of);
      const auto cell = static_cast<std::size_t>(target - all.targets.begin()) * all.solvers.size() + solver;
      if (!all.is_solved[cell]) ++target->solvers;
      all.is_solved[cell] = true;
      add_success(*target, solve, solver, is_imported);
    }
  }
  return all;
}

bool do_solvers_differ(const SolvedTargets& targets) {
  return std::ranges::any_of(targets.targets, [&](const SolvedTarget& target) {
    return target.solvers > 0 && target.solvers < targets.solvers.size();
  });
}

std::optional<HardTargets> hard_targets(const SolvedTargets& all, const std::vector<std::string>& order) {
  if (!all.is_complete || !do_solvers_differ(all)) return std::nullopt;
  HardTargets hard{.targets = all.targets.size(), .are_repeated = all.are_repeated};
  hard.unsolved = static_cast<std::size_t>(std::ranges::count(all.targets, std::size_t{0}, &SolvedTarget::solvers));
  const std::size_t solvable = hard.targets - hard.unsolved;
  std::vector<std::size_t> solvers;
  for (const std::string& label : order) {
    const auto found = std::ranges::find(all.solvers, label);
    if (found != all.solvers.end()) solvers.push_back(static_cast<std::size_t>(found - all.solvers.begin()));
  }
  const std::vector<Bits> solved = bits_of(all, solvers);
  LargestUnion unions(solved);
  for (std::size_t i = 0; i < solvers.size(); ++i) {
    std::size_t count = 0;
    for (const std::uint64_t word : solved[i]) count += static_cast<std::size_t>(std::popcount(word));
    if (count == solvable) hard.alone.push_back(all.solvers[solvers[i]]);
  }
  if (!hard.alone.empty()) return hard.unsolved > 0 ? std::optional(hard) : std::nullopt;
  auto [together, count] = unions.of(2);
  if (count < solvable && solvers.size() >= 3 && solvers.size() <= most_solvers_of_triples) {
    auto [three, solved_by_three] = unions.of(3);
    if (solved_by_three == solvable) {
      together = std::move(three);
      count = solved_by_three;
    }
  }
  for (const std::size_t i : together) hard.together.push_back(all.solvers[solvers[i]]);
  hard.solved_together = count;
  return hard;
}

}  // namespace ikbench::judge
