#include "analysis/judge/data/warnings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "analysis/judge/data/study_results.hpp"
#include "base/json.hpp"
#include "base/names.hpp"

namespace ikbench::judge {

using namespace base;
using namespace results;

namespace {

using Doubts = std::vector<Warning>;

// Adds a doubt, if it is about some solver.
void add(Doubts& warnings, Warning warning) {
  if (!warning.solvers.empty()) warnings.push_back(std::move(warning));
}

// Adds a doubt of all solvers with a count, which stands before of how many.
template <class Counted>
void add_counts(Doubts& warnings, const StudyResults& study, Warning warning, Counted counted) {
  for (const std::string& solver : study.labels) {
    const auto [count, total] = counted(solver);
    if (count <= 0) continue;
    warning.solvers.push_back(solver);
    warning.count += static_cast<double>(count);
    warning.total += static_cast<double>(total);
  }
  add(warnings, std::move(warning));
}

// Adds a doubt of all solves that are so, and of the solvers that made them.
template <class Is>
void add(Doubts& warnings, const StudyResults& study, Warning warning, Is is_so) {
  add_counts(warnings, study, std::move(warning), [&](const std::string& solver) {
    const Solves all = study.of(solver);
    return std::pair(std::ranges::count_if(all, is_so), std::ssize(all));
  });
}

// How solves were timed, if not as one alone of an optimised build.
std::string odd_timing_of(const StudyResults& study) {
  const auto is_any = [&](Timing how) { return std::ranges::count(study.solves, how, &SolveSummary::timing) > 0; };
  return is_any(Timing::parallel) ? "solved in parallel" : is_any(Timing::debug_build) ? "a debug build" : "";
}

// Those that have fewer sessions than a test takes in common with most, who made the same ones.
std::vector<std::string> measured_apart(const StudyResults& study, const std::vector<std::set<int>>& sessions) {
  std::map<std::set<int>, std::size_t> solvers_of;
  for (const std::set<int>& its : sessions) ++solvers_of[its];
  const std::set<int> most = std::ranges::max_element(solvers_of, {}, [](const auto& each) {
                               return std::pair(each.first.size() >= min_sessions, each.second);
                             })->first;
  std::vector<std::string> apart;
  for (std::size_t i = 0; i < sessions.size(); ++i) {
    const auto common = std::ranges::count_if(sessions[i], [&](int session) { return most.contains(session); });
    if (!study.of(study.labels[i]).empty() && common < min_sessions) apart.push_back(study.labels[i]);
  }
  return apart;
}

// Whom a limit of the study gives fewest evaluations, and whom most. Of who is not limited it is what a solve took.
void add_of_budgets(Doubts& warnings, const StudyResults& study) {
  if (study.definition.stop.seconds > 0) return;
  std::string fewest, most;
  double few = std::numeric_limits<double>::infinity(), many = 0;
  for (const std::string& solver : study.labels) {
    double limited = 0, spent = 0, largest = 0;
    const Solves all = study.of(solver);
    if (!std::ranges::all_of(all, [](const SolveSummary& its) { return its.counted_by == CountedBy::ikbench; }))
      continue;
    for (const SolveSummary& solve : all) {
      const auto evaluations = static_cast<double>(solve.evaluations);
      largest = std::max(largest, evaluations);
      if (solve.stop_reason != StopReason::iterations && solve.stop_reason != StopReason::evaluations) continue;
      ++limited, spent += evaluations;
    }
    const bool is_limited = limited >= 0.1 * static_cast<double>(all.size()) && spent > 0;
    const double budget = is_limited ? spent / limited : largest;
    if (is_limited && budget < few) few = budget, fewest = solver;
    if (budget > many) many = budget, most = solver;
  }
  if (many < 1.5 * few) return;
  warnings.push_back({.kind = WarningKind::budgets_differ,
                      .solvers = {most, fewest},
                      .count = many,
                      .total = few,
                      .detail = fmt::format("budgets differ: {:.0f} and {:.0f} evaluations a solve", many, few)});
}

// By the stored plan: a command may judge by another.
void add_of_plan(Doubts& warnings, const StudyResults& study) {
  const base::Json definition = base::parsed_json(study.definition.json);
  const base::Json plan = definition.value("analysis", base::Json::object());  // a stranger's store may have none
  std::set<std::int64_t> others;                                               // sessions
  std::set<std::string> fields;
  for (const Session& session : study.sessions) {
    const auto recorded = session.environment.find("analysis");
    if (recorded == session.environment.end()) continue;
    const base::Json then = base::parsed_json(recorded->second);
    for (const auto& [field, value] : then.items())
      if (plan.value(field, value) != value) others.insert(session.id), fields.insert(field);  // a field may be gone
  }
  add(warnings, study, {.kind = WarningKind::plan_changed, .detail = fmt::format("{}", fmt::join(fields, ", "))},
      [&](const SolveSummary& solve) { return others.contains(solve.session); });
}

}  // namespace

std::vector<Warning> time_warnings(const StudyResults& study) {
  const SessionSets sessions = session_sets(study);
  const bool are_alone = study.batch_timings.empty() || environment_values(study, "jobs") == std::set<std::string>{"1"};
  const auto compared = std::ssize(sessions.comparable);
  std::string of_all = are_alone ? odd_timing_of(study) : "solved in parallel";
  if (of_all.empty() && std::ranges::none_of(study.sessions, uses_current_clock))
    of_all = "of the clock of a former version";
  else if (of_all.empty() && compared < min_sessions)
    of_all = fmt::format("{}, and {} are the fewest", base::counted(compared, "sessions"), min_sessions);
  if (!of_all.empty()) return {{.kind = WarningKind::times_not_comparable, .detail = of_all}};
  Doubts warnings;
  std::set<std::string> told;  // one reason is enough
  const auto add_of = [&](std::vector<std::string> who, const std::string& what) {
    std::erase_if(who, [&](const std::string& solver) { return !told.insert(solver).second; });
    add(warnings, {.kind = WarningKind::times_not_comparable, .solvers = std::move(who), .detail = what});
  };
  add_of(study.imported.labels, "solved " + study.imported.origin);
  std::vector<std::string> in_batches, silent;
  for (const auto& [solver, its] : study.batch_timings) in_batches.push_back(solver);
  add_of(std::move(in_batches), "asked in batches");
  for (const std::string& solver : study.labels) {
    const Solves all = study.of(solver);
    const auto tells_none = [](const SolveSummary& solve) {
      return solve.timing == Timing::process && !solve.is_self_timed && has_answer(solve);
    };
    if (10 * std::ranges::count_if(all, tells_none) > std::ssize(all)) silent.push_back(solver);
  }
  if (silent.size() < study.labels.size()) add_of(std::move(silent), "messages included");  // however often solved
  add_of(measured_apart(study, sessions.complete),
         "too few sessions in common with the others; solve all again: --out NEW");
  add_of(measured_apart(study, sessions.quiet), "the machine was busy");
  return warnings;
}

std::vector<Warning> clock_warnings(const StudyResults& study) {
  const double limit = study.definition.stop.seconds;
  if (limit == 0) return {};
  // Machines differ if their processors do, or both name and start: one that starts again keeps its name, and
  // containers on it have their own.
  const auto differ = [&](const char* fact) { return environment_values(study, fact).size() > 1; };
  const std::vector<std::set<int>> sessions = session_sets(study).all;
  std::set<std::set<int>> different(sessions.begin(), sessions.end());
  different.erase(std::set<int>());  // of who has no solves
  std::string of_all = odd_timing_of(study);
  if (of_all.empty() && (differ("cpu") || (differ("host") && differ("boot")))) of_all = "several machines";
  if (of_all.empty() && different.size() > 1) of_all = "measured in different sessions";
  Doubts warnings;
  for (const bool is_beside : {false, true}) {
    const std::string what = is_beside        ? "solved " + study.imported.origin
                             : of_all.empty() ? "the machine was busy"
                                              : of_all;
    add_counts(
        warnings, study, {.kind = WarningKind::time_limit_decides, .detail = what}, [&](const std::string& solver) {
          const Solves all = study.of(solver);
          const auto ended = std::ranges::count_if(all, [=](auto&its) { return its.seconds >= 0.9 * limit; }),
                     disturbed =
                         std::ranges::count_if(all, &SolveSummary::was_preempted);  // programs stop before the limit
          const bool decides = is_beside || !of_all.empty() || (disturbed > 1 && 10 * disturbed > std::ssize(all));
          return std::pair(decides && study.imported.has(solver) == is_beside ? ended : 0, std::ssize(all));
        });
  }
  return warnings;
}

std::vector<Warning> evaluation_warnings(const StudyResults& study) {
  Doubts warnings = clock_warnings(study);
  add(warnings, study, {.kind = WarningKind::counts_not_comparable},
      [](const SolveSummary& solve) { return !has_no_answer(solve.status) && solve.counted_by != CountedBy::ikbench; });
  return warnings;
}

std::vector<Warning> study_warnings(const StudyResults& study) {
  Doubts warnings;
  const Warning missing{.kind = WarningKind::runs_missing, .detail = "runs missing or without some targets"};
  add_counts(warnings, study, missing, [&](const std::string& solver) {
    return std::pair(study.definition.runs - std::ssize(complete_runs_of(study, solver)), study.definition.runs);
  });
  add(warnings, study, {.kind = WarningKind::no_answer, .detail = "solves gave no answer"},
      [](const SolveSummary& solve) { return !has_answer(solve); });
  add(warnings, study, {.kind = WarningKind::misreported},
      [](const SolveSummary& solve) { return solve.status == Status::misreported; });
  add(warnings, study, {.kind = WarningKind::limit_violations}, &SolveSummary::is_outside_limits);
  add_of_budgets(warnings, study);
  if (const int count = study.definition.unreachable_targets; count > 0)
    warnings.push_back({.kind = WarningKind::unreachable_targets,
                        .count = static_cast<double>(count),
                        .total = static_cast<double>(study.definition.points)});
  add_of_plan(warnings, study);
  Warning repeating{.kind = WarningKind::deterministic};
  if (!study.definition.draws_targets && study.definition.compares_runs())  // else paired
    std::ranges::copy_if(study.labels, std::back_inserter(repeating.solvers),
                         [&](const std::string& solver) { return repeats_itself(study, solver); });
  add(warnings, std::move(repeating));
  add(warnings, study.stale_solves);
  return warnings;
}

std::string warning_text(const Warning& warning) {
  // In the order of DoubtKind.
  static constexpr std::string_view sentences[]{
      "the plan was changed after {share} solves were made{of_whom}: {what}",
      "{share} {what}{of_whom}",
      "{share} {what}{of_whom}",
      "ignored: {solves} of another version ({who})",
      "{share} solves claimed an error that is wrong, and do not count as solved ({who})",
      "{who} {was} stopped by the time limit in {share} solves, so not compared: {what}{to_do}",
      "{what} ({who})",
      "evaluations are not counted by ikbench, so not compared ({who})",
      "{share} answers outside the joint limits ({who})",
      "{share} {what}{of_whom}",
      "times{of_who} are not compared: {what}{to_do}",
      "{share} targets of a run out of reach, so no solver can solve them",
      "{who} gave the same {what} {count} times, or its spread was rounded away: not tested",
      "few values decide the {what} of {who}; such pairs are left open",
      "{first} is better than {last} by ranks, though its {what} is worse",
      "leaving rows out favours {who}: solvers lack different shares of their values, {what}",
      "{who} have the same value in every block, as if one measurement had been copied"};
  std::string_view sentence = sentences[static_cast<std::size_t>(warning.kind)];
  if (warning.kind == WarningKind::deterministic && warning.detail.empty())
    sentence = "{who} gave the same answers in every run, which count as one";
  const std::string who = names_of(warning.solvers, ", "),
                    share = fmt::format("{:.0f} of {:.0f}", warning.count, warning.total);
  const auto if_any = [&](const char* before, const char* after) { return who.empty() ? "" : before + who + after; };
  return fmt::format(fmt::runtime(sentence), fmt::arg("who", who), fmt::arg("of_whom", if_any(" (", ")")),
                     fmt::arg("of_who", if_any(" of ", "")), fmt::arg("share", share), fmt::arg("what", warning.detail),
                     fmt::arg("was", warning.solvers.size() == 1 ? "was" : "were"),
                     fmt::arg("to_do", warning.detail == "the machine was busy" ? "; solve again: --out NEW" : ""),
                     fmt::arg("count", std::llround(warning.count)),
                     fmt::arg("solves", counted(std::llround(warning.count), "solves")),
                     fmt::arg("first", who.empty() ? who : warning.solvers.front()),
                     fmt::arg("last", who.empty() ? who : warning.solvers.back()));
}

}  // namespace ikbench::judge
