#include "analysis/compare/study.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace ikbench::compare {

using namespace results;

namespace {

std::ptrdiff_t place_of(const std::vector<std::string>& solvers, std::string_view solver) {
  return std::ranges::find(solvers, solver) - solvers.begin();
}

bool had_same_targets(const StudyResults& study) {
  const auto place = [](const SolveRecord& solve) { return std::pair(solve.run, solve.point); };
  const auto is_same = [&](const SolveRecord& one, const SolveRecord& other) {
    return one.target_position_m == other.target_position_m && one.target_rotation == other.target_rotation &&
           (study.definition.is_chained() || one.start_rad == other.start_rad);
  };
  const std::span<const SolveRecord> first = study.of(study.solvers.empty() ? "" : study.solvers.front());
  return std::ranges::all_of(study.solvers, [&](const std::string& solver) {
    auto here = first.begin();
    return std::ranges::all_of(study.of(solver), [&](const SolveRecord& solve) {
      while (here != first.end() && place(*here) < place(solve)) ++here;
      return here == first.end() || place(*here) != place(solve) || is_same(*here, solve);
    });
  });
}

}  // namespace

std::span<const SolveRecord> StudyResults::of(std::string_view solver) const {
  const auto place = [&](const SolveRecord& solve) { return place_of(solvers, solve.solver); };
  const std::ptrdiff_t here = place_of(solvers, solver);
  return {std::ranges::lower_bound(solves, here, {}, place), std::ranges::upper_bound(solves, here, {}, place)};
}

StudyResults study_of(const StudyEntry& entry, std::vector<SolveRecord> solves, const std::vector<Session>& sessions) {
  StudyResults study{.entry = entry, .definition = definition_of(entry.definition), .solves = std::move(solves)};
  study.runs = study.definition.runs;
  study.points = study.definition.points;
  std::set<std::int64_t> used;
  for (const Series& series : entry.series) {
    if (series.label.empty())
      throw std::invalid_argument(fmt::format("study '{}' has a solver without a label; expected one", entry.name));
    study.solvers.push_back(series.label);
  }
  for (const SolveRecord& solve : study.solves) {
    if (solve.run < 1 || solve.point < 1)
      throw std::invalid_argument(fmt::format("study '{}', solver '{}': run {}, point {}; expected them from 1",
                                              entry.name, solve.solver, solve.run, solve.point));
    if (place_of(study.solvers, solve.solver) == std::ssize(study.solvers)) study.solvers.push_back(solve.solver);
    study.runs = std::max(study.runs, solve.run);
    study.points = std::max(study.points, solve.point);
    used.insert(solve.session);
  }
  std::ranges::copy_if(sessions, std::back_inserter(study.sessions),
                       [&](const Session& session) { return used.contains(session.id); });
  const auto place = [&](const SolveRecord& solve) {
    return std::tuple(place_of(study.solvers, solve.solver), solve.run, solve.point);
  };
  if (!std::ranges::is_sorted(study.solves, {}, place)) std::ranges::stable_sort(study.solves, {}, place);
  std::string& control = study.definition.plan.control;
  if (place_of(study.solvers, control) == std::ssize(study.solvers)) control.clear();
  study.had_same_targets = had_same_targets(study);
  return study;
}

StudyResults read_study(const Store& store, const StudyEntry& entry) {
  const std::int64_t all = store.number_of_solves(entry);
  if (all > most_solves)
    throw std::invalid_argument(
        fmt::format("study '{}' has {} solves; expected at most {}", entry.name, all, most_solves));
  std::vector<SolveRecord> solves;
  solves.reserve(static_cast<std::size_t>(all));
  store.each_of_study(entry, [&](SolveRecord& solve) { solves.push_back(std::move(solve)); });
  StudyResults study = study_of(entry, std::move(solves), store.sessions());
  for (const Series& series : entry.series) {
    if (std::ssize(study.of(series.label)) >= std::int64_t{study.runs} * study.points) continue;
    std::int64_t others = 0;
    for (const auto& [key, count] : store.series_of_configuration(configuration_of(series.key)))
      others += key == series.key ? 0 : count;
    if (others == 0) continue;
    study.solvers_of_other_versions.push_back(series.label);
    study.solves_of_other_versions += others;
  }
  return study;
}

}  // namespace ikbench::compare
