#include "analysis/inference/comparable.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "analysis/inference/run_metrics.hpp"
#include "analysis/inference/study_facts.hpp"
#include "analysis/statistics/descriptive.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

using SolverLabels = std::vector<std::string>;

template <class Is>
SolverLabels those(const StudyResults& study, Is is) {
  SolverLabels labels;
  std::ranges::copy_if(study.solvers, std::back_inserter(labels), is);
  return labels;
}

std::ptrdiff_t timed(const StudyResults& study, Timing how) {
  return std::ranges::count(study.solves, how, &Solve::timing);
}

bool has(std::span<const Solve> solves, CountedBy by) {
  return std::ranges::find(solves, by, &Solve::counted_by) != solves.end();
}

struct Disturbed {
  std::ptrdiff_t solves = 0, timed = 0;
};

Disturbed disturbed(std::span<const Solve> solves) {
  const auto is_timed = [](const Solve& solve) {
    return solve.timing == Timing::clean || solve.timing == Timing::process;
  };
  return {std::ranges::count_if(solves, [](const Solve& solve) { return solve.is_disturbed; }),
          std::ranges::count_if(solves, is_timed)};
}

// If solves end by wall time, errors depend on the machine too.
bool errors_too(const StudyResults& study) { return study.facts.stop.seconds > 0; }

Doubt imported_doubt(const StudyResults& study, const SolverLabels& labels) {
  return {.kind = DoubtKind::times_imported,
          .who = labels,
          .count = static_cast<double>(timed(study, Timing::imported)),
          .of = static_cast<double>(study.solves.size())};
}

Doubt disturbed_doubt(const StudyResults& study, const SolverLabels& labels) {
  Doubt doubt{.kind = DoubtKind::times_disturbed, .who = labels, .errors_too = errors_too(study)};
  for (const std::string& label : labels) {
    const Disturbed own = disturbed(solves_of(study, label));
    doubt.count += static_cast<double>(own.solves);
    doubt.of += static_cast<double>(own.timed);
    doubt.has_programs |= is_program(study, label);
  }
  return doubt;
}

Doubts times_left_out(const StudyResults& study) {
  Doubts doubts;
  const SolverLabels imported = those(study, [&](const std::string& solver) { return is_imported(study, solver); });
  if (!imported.empty()) doubts.push_back(imported_doubt(study, imported));
  const SolverLabels disturbed =
      those(study, [&](const std::string& solver) { return times_were_disturbed(study, solver); });
  if (!disturbed.empty()) doubts.push_back(disturbed_doubt(study, disturbed));
  const bool is_mixed = std::ranges::any_of(study.solvers, [&](const std::string& solver) {
    return !solves_of(study, solver).empty() && !is_imported(study, solver) && !is_program(study, solver);
  });
  if (!is_mixed || study.plan.program_times == ProgramTimes::compared) return doubts;
  const SolverLabels programs = those(study, [&](const std::string& solver) {
    return is_program(study, solver) && !times_were_disturbed(study, solver);
  });
  if (!programs.empty()) doubts.push_back({.kind = DoubtKind::times_of_programs, .who = programs});
  return doubts;
}

Doubts evaluations_left_out(const StudyResults& study) {
  const SolverLabels nobody =
      those(study, [&](const std::string& solver) { return has(solves_of(study, solver), CountedBy::nobody); });
  const bool is_counted_here = std::ranges::any_of(study.solvers, [&](const std::string& solver) {
    const std::span<const Solve> solves = solves_of(study, solver);
    return has(solves, CountedBy::suite) && !has(solves, CountedBy::nobody);
  });
  const SolverLabels claimed = those(study, [&](const std::string& solver) {
    const std::span<const Solve> solves = solves_of(study, solver);
    return is_counted_here && has(solves, CountedBy::solver) && !has(solves, CountedBy::nobody);
  });
  Doubts doubts;
  if (!nobody.empty()) doubts.push_back({.kind = DoubtKind::evaluations_uncounted, .who = nobody});
  if (!claimed.empty()) doubts.push_back({.kind = DoubtKind::evaluations_claimed, .who = claimed});
  return doubts;
}

Doubts instructions_left_out(const StudyResults& study) {
  const SolverLabels uncounted = those(study, [&](const std::string& solver) {
    return std::ranges::any_of(solves_of(study, solver), [](const Solve& solve) {
      return !is_without_answer(solve.status) && std::isnan(instructions(solve));
    });
  });
  if (uncounted.empty()) return {};
  return {{.kind = DoubtKind::instructions_uncounted, .who = uncounted}};
}

// Doubts of the whole study's times, for all solvers.
Doubts machine_doubts(const StudyResults& study) {
  const auto parallel = timed(study, Timing::parallel), debug = timed(study, Timing::debug_build);
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
  if (metric == Metric::instructions) return instructions_left_out(study);
  return info_of(metric).kind == Kind::time ? times_left_out(study) : Doubts{};
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
    if (doubt.kind == DoubtKind::times_disturbed) doubt = disturbed_doubt(study, study.solvers);
    doubt.is_of_all = true;
  }
  return doubts;
}

Doubts timing_doubts(const StudyResults& study, std::string_view solver) {
  if (Doubts doubts = machine_doubts(study); !doubts.empty()) return doubts;
  return timing_doubts(of_solvers(study, [&](std::string_view name) { return name == solver; }));
}

Doubts times_doubts(const StudyResults& study) {
  Doubts doubts = timing_doubts(study);
  return doubts.empty() ? left_out(study, Metric::seconds) : doubts;
}

bool times_are_comparable(const StudyResults& study) { return timing_doubts(study).empty(); }

bool is_comparable(const StudyResults& study, Metric metric) {
  return info_of(metric).kind != Kind::time || times_are_comparable(study);
}

bool times_were_disturbed(const StudyResults& study, std::string_view solver) {
  const Disturbed found = disturbed(solves_of(study, solver));
  return found.solves > 1 && 10 * found.solves > found.timed;
}

bool is_program(const StudyResults& study, std::string_view solver) {
  const std::span<const Solve> solves = solves_of(study, solver);
  return std::ranges::find(solves, Timing::process, &Solve::timing) != solves.end();
}

Doubts cpu_doubts(const std::set<std::string>& cpus) {
  if (cpus.size() < 2) return {};
  return {{.kind = DoubtKind::several_machines, .who = {cpus.begin(), cpus.end()}, .is_of_all = true}};
}

Doubts transport_doubts(const StudyResults& study) {
  const SolverLabels found = those(study, [&](const std::string& solver) {
    const std::vector<double>& shares = solver_facts(study, solver).transport_shares;
    return !shares.empty() && median(shares) >= 0.5;
  });
  if (found.empty()) return {};
  return {{.kind = DoubtKind::mostly_transport, .who = found}};
}

Doubts batch_doubts(const StudyResults& study) {
  int largest = 1;
  const SolverLabels found = those(study, [&](const std::string& solver) {
    const int batch = solver_facts(study, solver).largest_batch;
    largest = std::max(largest, batch);
    return batch > 1;
  });
  if (found.empty()) return {};
  return {{.kind = DoubtKind::solved_in_batches, .who = found, .count = static_cast<double>(largest)}};
}

Doubts evaluation_doubts(const StudyResults& measured) {
  if (!times_are_comparable(measured)) return {};
  const StudyResults study = compared_in(measured, Metric::seconds);
  if (study.external.empty() || study.external.size() == study.solvers.size()) return {};
  return {{.kind = DoubtKind::evaluated_one_by_one, .who = study.external}};
}

std::set<std::string> machines_of(std::span<const Session> sessions) {
  const auto fact = [](const Session& session, const char* name) {
    const auto found = session.environment.find(name);
    return found == session.environment.end() ? std::string() : found->second;
  };
  std::set<std::string> hosts, boots, machines;
  for (const Session& session : sessions) {
    if (fact(session, "host").empty()) continue;
    hosts.insert(fact(session, "host"));
    boots.insert(fact(session, "boot"));
  }
  const bool are_several = hosts.size() > 1 && boots.size() > 1;
  for (const Session& session : sessions) {
    const std::string cpu = fact(session, "cpu"), host = fact(session, "host");
    if (!cpu.empty()) machines.insert(are_several && !host.empty() ? cpu + " on " + host : cpu);
  }
  return machines;
}

namespace {

// Mean evaluations of a solver whose solves the limit of iterations ends, nearly all; else not defined.
double evaluations_of_iterations(const StudyResults& study, const std::string& solver) {
  constexpr double nearly_all = 0.9;
  double sum = 0, limited = 0, count = 0;
  for (const Solve& solve : solves_of(study, solver)) {
    if (solve.counted_by != CountedBy::suite || is_without_answer(solve.status)) return not_defined;
    sum += static_cast<double>(solve.evaluations);
    limited += solve.stop_reason == StopReason::iterations ? 1 : 0;
    ++count;
  }
  return limited >= nearly_all * count && count > 0 ? sum / count : not_defined;
}

Doubts effort_doubts(const StudyResults& study) {
  constexpr double much = 2;
  if (study.facts.stop.evaluations > 0 || study.facts.stop.seconds > 0) return {};
  std::string fewest, most;
  double few = not_defined, many = not_defined;
  for (const std::string& solver : study.solvers) {
    const double mean = evaluations_of_iterations(study, solver);
    if (std::isnan(mean)) continue;
    if (!(mean >= few)) few = mean, fewest = solver;
    if (!(mean <= many)) many = mean, most = solver;
  }
  if (!(many >= much * few && few > 0)) return {};
  return {{.kind = DoubtKind::unequal_evaluations, .who = {most}, .count = few, .of = many, .what = fewest}};
}

// Evaluations of an iteration; not defined without iterations, where the suite did not count, and for a library or
// program, one of whose iterations may be a whole search.
double evaluations_per_iteration(const StudyResults& study, const std::string& solver) {
  double evaluations = 0, iterations = 0;
  if (std::ranges::find(study.external, solver) != study.external.end()) return not_defined;
  for (const Solve& solve : solves_of(study, solver)) {
    if (solve.counted_by != CountedBy::suite) return not_defined;
    evaluations += static_cast<double>(solve.evaluations);
    iterations += static_cast<double>(solve.iterations);
  }
  return iterations > 0 ? evaluations / iterations : not_defined;
}

// A method that follows the gradient evaluates one or a few candidates in an iteration; a population many.
Doubts baseline_doubts(const StudyResults& study, const JudgedStudies& companions) {
  constexpr double many = 8;
  double fewest = not_defined;
  const auto has_populations_only = [&](const StudyResults& each) {
    return std::ranges::all_of(each.solvers, [&](const std::string& solver) {
      const double here = evaluations_per_iteration(each, solver);
      if (!(here >= fewest)) fewest = here;
      return here >= many;
    });
  };
  if (study.solvers.empty() || !has_populations_only(study)) return {};
  const double of_study = fewest;
  const bool have_companions_too = std::ranges::all_of(companions, has_populations_only);
  if (!have_companions_too) return {};
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
