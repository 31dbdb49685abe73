#include "analysis/inference/comparable.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "analysis/inference/study_facts.hpp"
#include "analysis/statistics/descriptive.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

using SolverLabels = std::vector<std::string>;
using SolvesOfOne = std::span<const Solve>;

// The solvers whose solves are so.
template <class Are>
SolverLabels those(const StudyResults& study, Are are) {
  SolverLabels labels;
  std::ranges::copy_if(study.solvers, std::back_inserter(labels),
                       [&](const std::string& solver) { return are(solves_of(study, solver)); });
  return labels;
}

// The doubt of these solvers; none if there are none.
Doubts doubts_of(DoubtKind kind, SolverLabels labels) {
  return labels.empty() ? Doubts() : Doubts{{.kind = kind, .who = std::move(labels)}};
}

std::ptrdiff_t timed(SolvesOfOne solves, Timing how) { return std::ranges::count(solves, how, &Solve::timing); }
bool are_of_program(SolvesOfOne solves) { return timed(solves, Timing::process) > 0; }
bool are_counted(SolvesOfOne solves, CountedBy by) {
  return std::ranges::find(solves, by, &Solve::counted_by) != solves.end();
}

// A single disturbed solve does not count.
bool are_disturbed(SolvesOfOne solves) {
  const auto disturbed = std::ranges::count(solves, true, [](const Solve& solve) { return solve.is_disturbed; });
  return disturbed > 1 && 10 * disturbed > timed(solves, Timing::clean);
}

// If solves end by wall time, errors depend on the machine too.
bool errors_too(const StudyResults& study) { return study.facts.stop.seconds > 0; }

Doubt disturbed_doubt(const StudyResults& study, const SolverLabels& labels) {
  Doubt doubt{.kind = DoubtKind::times_disturbed, .who = labels, .errors_too = errors_too(study)};
  for (const std::string& label : labels) {
    const SolvesOfOne own = solves_of(study, label);
    for (const Solve& solve : own) doubt.count += solve.is_disturbed ? 1 : 0;
    doubt.of += static_cast<double>(timed(own, Timing::clean));
  }
  return doubt;
}

Doubts times_left_out(const StudyResults& study) {
  Doubts doubts;
  if (const SolverLabels disturbed = those(study, are_disturbed); !disturbed.empty()) {
    doubts.push_back(disturbed_doubt(study, disturbed));
  }
  const auto are_of_this_program = [](SolvesOfOne solves) { return !solves.empty() && !are_of_program(solves); };
  if (those(study, are_of_this_program).empty() || study.plan.program_times == ProgramTimes::compared) return doubts;
  return doubts + doubts_of(DoubtKind::times_of_programs, those(study, are_of_program));
}

Doubts evaluations_left_out(const StudyResults& study) {
  const auto by = [&](CountedBy whom) {
    return those(study, [whom](SolvesOfOne solves) {
      return are_counted(solves, whom) && (whom == CountedBy::nobody || !are_counted(solves, CountedBy::nobody));
    });
  };
  const Doubts uncounted = doubts_of(DoubtKind::evaluations_uncounted, by(CountedBy::nobody));
  if (by(CountedBy::suite).empty()) return uncounted;
  return uncounted + doubts_of(DoubtKind::evaluations_claimed, by(CountedBy::solver));
}

// Doubts of the whole study's times, for all solvers.
Doubts machine_doubts(const StudyResults& study) {
  const auto parallel = timed(study.solves, Timing::parallel), debug = timed(study.solves, Timing::debug_build);
  Doubts doubts = cpu_doubts(study.cpus);
  if (parallel + debug > 0) {
    doubts = {{.kind = DoubtKind::solved_in_parallel,
               .count = static_cast<double>(parallel),
               .of = static_cast<double>(study.solves.size()),
               .other = static_cast<double>(debug),
               .is_of_all = true}};
  }
  for (Doubt& doubt : doubts) doubt.errors_too = errors_too(study);
  return doubts;
}

}  // namespace

Doubts left_out(const StudyResults& study, Metric metric) {
  if (metric == Metric::evaluations) return evaluations_left_out(study);
  return info_of(metric).kind == Kind::time ? times_left_out(study) : Doubts();
}

std::set<std::string, std::less<>> solvers_left_out(const StudyResults& study, Metric metric) {
  std::set<std::string, std::less<>> solvers;
  for (const Doubt& doubt : left_out(study, metric)) solvers.insert(doubt.who.begin(), doubt.who.end());
  return solvers;
}

StudyResults compared_in(StudyResults study, Metric metric) {
  const auto without = solvers_left_out(study, metric);
  if (without.empty()) return study;
  return of_solvers(std::move(study), [&](std::string_view solver) { return !without.contains(solver); });
}

Doubts timing_doubts(const StudyResults& study) {
  if (Doubts doubts = machine_doubts(study); !doubts.empty()) return doubts;
  const std::size_t number = solvers_left_out(study, Metric::seconds).size();
  if (number == 0 || number + 2 <= study.solvers.size()) return {};
  Doubts doubts = times_left_out(study);
  for (Doubt& doubt : doubts) {
    if (doubt.who.size() == study.solvers.size()) doubt.who.clear();  // then it needs no names
    doubt.is_of_all = true;
  }
  return doubts;
}

Doubts times_doubts(const StudyResults& study) {
  Doubts doubts = timing_doubts(study);
  return doubts.empty() ? left_out(study, Metric::seconds) : doubts;
}

bool times_are_comparable(const StudyResults& study) { return timing_doubts(study).empty(); }

bool is_comparable(const StudyResults& study, Metric metric) {
  return info_of(metric).kind != Kind::time || times_are_comparable(study);
}

Doubts cpu_doubts(const std::set<std::string>& cpus) {
  if (cpus.size() < 2) return {};
  return {{.kind = DoubtKind::several_machines, .who = {cpus.begin(), cpus.end()}, .is_of_all = true}};
}

std::set<std::string> machines_of(std::span<const Session> sessions) {
  const auto facts = [&](const std::string& name) {
    std::vector<std::string> of_sessions;
    for (const Session& session : sessions) {
      const auto found = session.environment.find(name);
      of_sessions.push_back(found == session.environment.end() ? "" : found->second);
    }
    return of_sessions;
  };
  const std::vector<std::string> cpus = facts("cpu"), hosts = facts("host"), boots = facts("boot");
  std::set<std::string> all_hosts, all_boots, machines;
  for (std::size_t i = 0; i < hosts.size(); ++i) {
    if (hosts[i].empty()) continue;
    all_hosts.insert(hosts[i]);
    all_boots.insert(boots[i]);
  }
  const bool are_several = all_hosts.size() > 1 && all_boots.size() > 1;
  for (std::size_t i = 0; i < cpus.size(); ++i) {
    if (!cpus[i].empty()) machines.insert(are_several && !hosts[i].empty() ? cpus[i] + " on " + hosts[i] : cpus[i]);
  }
  return machines;
}

namespace {

// Sums what all solves of a solver took; not defined unless the suite counted its evaluations.
struct Effort {
  double evaluations = 0, iterations = 0, solves = 0;
  double limited = 0;  // number of solves that the limit of iterations ended
};

Effort effort_of(const StudyResults& study, const std::string& solver) {
  Effort effort;
  for (const Solve& solve : solves_of(study, solver)) {
    effort.evaluations += solve.counted_by == CountedBy::suite ? static_cast<double>(solve.evaluations) : not_defined;
    effort.iterations += static_cast<double>(solve.iterations);
    effort.limited += solve.stop_reason == StopReason::iterations ? 1 : 0;
    ++effort.solves;
  }
  return effort;
}

// Compares solvers whose solves the limit of iterations ends, nearly all.
Doubts effort_doubts(const StudyResults& study) {
  constexpr double nearly_all = 0.9, much = 2;
  if (study.facts.stop.evaluations > 0 || study.facts.stop.seconds > 0) return {};
  std::string fewest, most;
  double few = not_defined, many = not_defined;
  for (const std::string& solver : study.solvers) {
    const Effort effort = effort_of(study, solver);
    const double mean = effort.evaluations / effort.solves;
    if (effort.limited < nearly_all * effort.solves || std::isnan(mean)) continue;
    if (!(mean >= few)) few = mean, fewest = solver;
    if (!(mean <= many)) many = mean, most = solver;
  }
  if (!(many >= much * few && few > 0)) return {};
  return {{.kind = DoubtKind::unequal_evaluations, .who = {most}, .count = few, .of = many, .what = fewest}};
}

// A method that follows the gradient evaluates one or a few candidates in an iteration; a population many. An iteration
// of a library or program may be a whole search, so nothing is known of it.
Doubts baseline_doubts(const StudyResults& study, const JudgedStudies& companions) {
  constexpr double many = 8;
  double fewest = not_defined;
  const auto has_populations_only = [&](const StudyResults& each) {
    return std::ranges::all_of(each.solvers, [&](const std::string& solver) {
      const bool is_external = std::ranges::find(each.external, solver) != each.external.end();
      const Effort effort = effort_of(each, solver);
      const double here = is_external || effort.iterations == 0 ? not_defined : effort.evaluations / effort.iterations;
      if (!(here >= fewest)) fewest = here;
      return here >= many;
    });
  };
  if (study.solvers.empty() || !has_populations_only(study)) return {};
  const double of_study = fewest;
  if (!std::ranges::all_of(companions, has_populations_only)) return {};
  return {{.kind = DoubtKind::populations_only, .count = of_study}};
}

}  // namespace

Doubts fairness_doubts(const StudyResults& study, const JudgedStudies& companions) {
  Doubts doubts = effort_doubts(study) + baseline_doubts(study, companions);
  const bool is_single = study.points == 1 && !study.facts.path.empty() && !study.facts.draws_targets;
  if (is_single && study.solvers.size() > 1) doubts.push_back({.kind = DoubtKind::single_target});
  return doubts;
}

}  // namespace ikbench::inference
