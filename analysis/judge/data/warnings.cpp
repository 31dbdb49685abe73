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

using Warnings = std::vector<Warning>;

// Adds a warning if the warning names a solver.
void add(Warnings& warnings, Warning warning) {
  if (!warning.solvers.empty()) warnings.push_back(std::move(warning));
}

// Adds one warning about all solvers with a count above 0. `counted` returns count and total of a solver.
template <class Counted>
void add_counts(Warnings& warnings, const StudyResults& study, Warning warning, Counted counted) {
  for (const std::string& solver : study.labels) {
    const auto [count, total] = counted(solver);
    if (count <= 0) continue;
    warning.solvers.push_back(solver);
    warning.count += static_cast<double>(count);
    warning.total += static_cast<double>(total);
  }
  add(warnings, std::move(warning));
}

// Adds one warning about all solves that `is_meant`, with the solvers that made them.
template <class IsMeant>
void add(Warnings& warnings, const StudyResults& study, Warning warning, IsMeant is_meant) {
  add_counts(warnings, study, std::move(warning), [&](const std::string& solver) {
    const Solves solves = study.of(solver);
    return std::pair(std::ranges::count_if(solves, is_meant), std::ssize(solves));
  });
}

// Returns why no time of a study can be compared: solves ran in parallel or in a debug build. Empty if none did.
std::string unusable_timing(const StudyResults& study) {
  const auto is_any = [&](Timing timing) {
    return std::ranges::count(study.solves, timing, &SolveSummary::timing) > 0;
  };
  if (is_any(Timing::parallel)) return "solved in parallel";
  return is_any(Timing::debug_build) ? "a debug build" : "";
}

// Adds what `run` found about answers: the sentences of the last session that has one.
void add_answer_warnings(Warnings& warnings, const StudyResults& study) {
  constexpr std::size_t most = 400;  // bytes of a sentence, which a stranger's store may have
  for (const auto& [kind, prefix] :
       {std::pair(WarningKind::wrong_answers, cause_fact), {WarningKind::answer_anomalies, answers_fact}}) {
    for (const Series& series : study.series) {
      std::string sentence;
      for (const Session& session : study.sessions)
        if (const auto fact = session.environment.find(prefix + series.key); fact != session.environment.end())
          sentence = one_line(front(fact->second, most));
      if (!sentence.empty()) warnings.push_back({.kind = kind, .solvers = {series.label}, .detail = sentence});
    }
  }
}

// Returns the solvers that share fewer sessions than a test needs with the sessions that most solvers have.
std::vector<std::string> measured_apart(const StudyResults& study, const std::vector<std::set<int>>& sessions) {
  std::map<std::set<int>, std::size_t> solvers_of;
  for (const std::set<int>& of_solver : sessions) ++solvers_of[of_solver];
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

// The evaluations that a solver may make in a solve.
struct Budget {
  bool is_limited = false;  // a limit of the study ended at least a tenth of the solves
  double evaluations = 0;   // mean of the solves that a limit ended; if not limited, the largest number of a solve
};

Budget budget_of(Solves solves) {
  double limited = 0, total = 0, largest = 0;
  for (const SolveSummary& solve : solves) {
    const auto evaluations = static_cast<double>(solve.evaluations);
    largest = std::max(largest, evaluations);
    if (solve.stop_reason != StopReason::iterations && solve.stop_reason != StopReason::evaluations) continue;
    ++limited;
    total += evaluations;
  }
  if (limited >= 0.1 * static_cast<double>(solves.size()) && total > 0) return {true, total / limited};
  return {false, largest};
}

// Adds a warning if some solver may make 1.5 times as many evaluations as the solver that the study limits most.
void add_budget_warning(Warnings& warnings, const StudyResults& study) {
  if (study.definition.stop.seconds > 0) return;
  const auto is_counted_here = [](const SolveSummary& solve) { return solve.counted_by == CountedBy::ikbench; };
  std::string fewest, most;
  double few = std::numeric_limits<double>::infinity(), many = 0;
  for (const std::string& solver : study.labels) {
    if (!std::ranges::all_of(study.of(solver), is_counted_here)) continue;
    const Budget budget = budget_of(study.of(solver));
    if (budget.is_limited && budget.evaluations < few) {
      few = budget.evaluations;
      fewest = solver;
    }
    if (budget.evaluations > many) {
      many = budget.evaluations;
      most = solver;
    }
  }
  if (many < 1.5 * few) return;
  warnings.push_back({.kind = WarningKind::budgets_differ,
                      .solvers = {most, fewest},
                      .count = many,
                      .total = few,
                      .detail = fmt::format("budgets differ: {:.0f} and {:.0f} evaluations per solve", many, few)});
}

// Adds a warning about solves that were made under another plan. The stored plan counts, because a command may judge by
// another plan.
void add_plan_warning(Warnings& warnings, const StudyResults& study) {
  const base::Json definition = base::parsed_json(study.definition.json);
  const base::Json plan = definition.value("analysis", base::Json::object());  // a foreign store may have no plan
  std::set<std::int64_t> others;                                               // sessions under another plan
  std::set<std::string> fields;
  for (const Session& session : study.sessions) {
    const auto recorded = session.environment.find("analysis");
    if (recorded == session.environment.end()) continue;
    const base::Json recorded_plan = base::parsed_json(recorded->second);
    for (const auto& [field, value] : recorded_plan.items()) {
      if (plan.value(field, value) == value) continue;  // a field that the plan no longer has counts as equal
      others.insert(session.id);
      fields.insert(field);
    }
  }
  add(warnings, study, {.kind = WarningKind::plan_changed, .detail = fmt::format("{}", fmt::join(fields, ", "))},
      [&](const SolveSummary& solve) { return others.contains(solve.session); });
}

// Returns why no time of a study is compared; empty if times are compared.
std::string reason_against_times(const StudyResults& study, const SessionSets& sessions) {
  const bool is_sequential =
      study.batch_timings.empty() || environment_values(study, "jobs") == std::set<std::string>{"1"};
  if (!is_sequential) return "solved in parallel";
  if (std::string reason = unusable_timing(study); !reason.empty()) return reason;
  const auto compared = std::ssize(sessions.comparable);
  if (compared >= min_sessions) return "";
  return fmt::format("only {}; at least {} are needed", base::counted(compared, "sessions"), min_sessions);
}

// Returns whether more than a tenth of the solves of an external solver have no self-reported time.
bool reports_no_times(Solves solves) {
  const auto has_no_own_time = [](const SolveSummary& solve) {
    return is_of_process(solve.timing) && !solve.is_self_timed && has_answer(solve);
  };
  return 10 * std::ranges::count_if(solves, has_no_own_time) > std::ssize(solves);
}

// Returns the solvers whose answers were made elsewhere, with or without times.
std::vector<std::string> solved_elsewhere(const StudyResults& study, bool has_times) {
  std::vector<std::string> solvers;
  for (const std::string& solver : study.labels) {
    const Solves solves = study.of(solver);
    const auto is_timed = [](const SolveSummary& solve) { return std::isfinite(solve.seconds); };
    const bool is_elsewhere = std::ranges::count(solves, Timing::elsewhere, &SolveSummary::timing) > 0;
    if (is_elsewhere && std::ranges::any_of(solves, is_timed) == has_times) solvers.push_back(solver);
  }
  return solvers;
}

// Returns the solvers with an answer that was made elsewhere and has no time.
std::vector<std::string> untimed_elsewhere(const StudyResults& study) {
  const auto is_untimed = [](const SolveSummary& solve) {
    return solve.timing == Timing::elsewhere && has_answer(solve) && !std::isfinite(solve.seconds);
  };
  std::vector<std::string> solvers;
  for (const std::string& solver : study.labels)
    if (std::ranges::any_of(study.of(solver), is_untimed)) solvers.push_back(solver);
  return solvers;
}

// Returns the circumstances in which a time limit gave solvers different chances, whatever each solver did: "on several
// machines"; empty if the chances were equal.
std::string unequal_circumstances(const StudyResults& study) {
  if (std::string timing = unusable_timing(study); !timing.empty()) return fmt::format("({})", timing);
  // Machines differ if their processors do, or both name and start: a machine that starts again keeps its name, and
  // containers on a machine have names of their own.
  const auto differ = [&](const char* fact) { return environment_values(study, fact).size() > 1; };
  if (differ("cpu") || (differ("host") && differ("boot"))) return "on several machines";
  const std::vector<std::set<int>> sessions = session_sets(study).all;
  std::set<std::set<int>> different(sessions.begin(), sessions.end());
  different.erase(std::set<int>());  // a solver without solves has no session
  return different.size() > 1 ? "in different sessions" : "";
}

// Returns whether more than a tenth of the solves, and more than one, were preempted.
bool is_disturbed(Solves solves) {
  const auto disturbed = std::ranges::count_if(solves, &SolveSummary::was_preempted);
  return disturbed > 1 && 10 * disturbed > std::ssize(solves);
}

}  // namespace

std::vector<Warning> time_warnings(const StudyResults& study) {
  const SessionSets sessions = session_sets(study);
  if (const std::string reason = reason_against_times(study, sessions); !reason.empty())
    return {{.kind = WarningKind::times_not_comparable, .detail = reason}};
  Warnings warnings;
  std::set<std::string> named;  // one reason per solver is enough
  const auto add_for = [&](std::vector<std::string> solvers, const std::string& reason) {
    std::erase_if(solvers, [&](const std::string& solver) { return !named.insert(solver).second; });
    add(warnings, {.kind = WarningKind::times_not_comparable, .solvers = std::move(solvers), .detail = reason});
  };
  add_for(study.imported.labels, "solved " + study.imported.origin);
  add_for(solved_elsewhere(study, true), "self-reported, solved elsewhere");
  add_for(solved_elsewhere(study, false), "solved elsewhere, without times");
  std::vector<std::string> in_batches, silent;
  for (const auto& [solver, timing] : study.batch_timings) in_batches.push_back(solver);
  add_for(std::move(in_batches), "solved in batches");
  for (const std::string& solver : study.labels)
    if (reports_no_times(study.of(solver))) silent.push_back(solver);
  // If no solver reports times, all times include messages alike.
  if (silent.size() < study.labels.size()) add_for(std::move(silent), "the calls were timed with message passing");
  // If no solver is warm, all calls are cold alike.
  if (const auto [warm, through_pipe] = solvers_of_warm_study(study); !warm.empty())
    add_for(through_pipe, "asked through a pipe, not warm");
  add_for(measured_apart(study, sessions.complete),
          "too few sessions shared with the others; rerun everything with --out NEW");
  add_for(measured_apart(study, sessions.quiet), "the machine was busy");
  return warnings;
}

std::vector<Warning> clock_warnings(const StudyResults& study) {
  const double limit = study.definition.stop.seconds;
  if (limit == 0) return {};
  const std::string circumstances = unequal_circumstances(study);
  // The limit is lowered by a tenth, because external solvers stop a little before the limit.
  const auto is_ended = [&](const SolveSummary& solve) { return solve.seconds >= 0.9 * limit; };
  const std::vector<std::string> elsewhere = solved_elsewhere(study, true);
  enum Place { here, imported, given };
  const auto place_of = [&](const std::string& solver) {
    if (study.imported.has(solver)) return imported;
    return std::ranges::count(elsewhere, solver) > 0 ? given : here;
  };
  const auto add_for = [&](Warnings& warnings, Place place, const std::string& detail) {
    add_counts(warnings, study, {.kind = WarningKind::time_limit_decides, .detail = detail},
               [&](const std::string& solver) {
                 const Solves solves = study.of(solver);
                 const bool decides = place != here || !circumstances.empty() || is_disturbed(solves);
                 const bool is_counted = decides && place_of(solver) == place;
                 return std::pair(is_counted ? std::ranges::count_if(solves, is_ended) : 0, std::ssize(solves));
               });
  };
  Warnings warnings;
  add_for(warnings, here, circumstances.empty() ? "while the machine was busy" : circumstances);
  add_for(warnings, imported, study.imported.origin);
  add_for(warnings, given, "elsewhere");
  add(warnings,
      {.kind = WarningKind::budget_not_known,
       .solvers = untimed_elsewhere(study),
       .detail = "solved elsewhere, and not every answer has a time, so the time limit may not have been kept"});
  return warnings;
}

std::vector<Warning> evaluation_warnings(const StudyResults& study) {
  Warnings warnings = clock_warnings(study);
  add(warnings, study, {.kind = WarningKind::counts_not_comparable},
      [](const SolveSummary& solve) { return !has_no_answer(solve.status) && solve.counted_by != CountedBy::ikbench; });
  return warnings;
}

std::vector<Warning> study_warnings(const StudyResults& study) {
  Warnings warnings;
  const Warning missing{.kind = WarningKind::runs_missing, .detail = "runs are missing or lack some targets"};
  add_counts(warnings, study, missing, [&](const std::string& solver) {
    return std::pair(study.definition.runs - std::ssize(complete_runs_of(study, solver)), study.definition.runs);
  });
  add(warnings, study, {.kind = WarningKind::no_answer, .detail = "solves gave no answer"},
      [](const SolveSummary& solve) { return !has_answer(solve); });
  add(warnings, study, {.kind = WarningKind::misreported},
      [](const SolveSummary& solve) { return solve.status == Status::misreported; });
  add(warnings, study, {.kind = WarningKind::limit_violations}, &SolveSummary::is_outside_limits);
  add_budget_warning(warnings, study);
  if (const int count = study.definition.unreachable_targets; count > 0)
    warnings.push_back({.kind = WarningKind::unreachable_targets,
                        .count = static_cast<double>(count),
                        .total = static_cast<double>(study.definition.points)});
  add_plan_warning(warnings, study);
  Warning repeating{.kind = WarningKind::deterministic};
  if (!study.definition.draws_targets && study.definition.compares_runs())  // in other studies values are paired
    std::ranges::copy_if(study.labels, std::back_inserter(repeating.solvers),
                         [&](const std::string& solver) { return is_deterministic(study, solver); });
  add(warnings, std::move(repeating));
  add(warnings, study.stale_solves);
  add_answer_warnings(warnings, study);
  return warnings;
}

std::string reason_not_compared(const Warning& warning) {
  if (warning.kind == WarningKind::time_limit_decides) return "the time limit stopped solves " + warning.detail;
  const bool has_reason =
      warning.kind == WarningKind::times_not_comparable || warning.kind == WarningKind::budget_not_known;
  return has_reason ? warning.detail : "";
}

std::string warning_text(const Warning& warning) {
  // The sentences stand in the order of WarningKind.
  static constexpr std::string_view sentences[]{
      "the analysis plan was changed after {share} solves had been made{of_whom}: {what}",
      "{share} {what}{of_whom}",
      "{share} {what}{of_whom}",
      "{solves} made by another version {was} ignored ({who})",
      "{share} solves of {who} reported a wrong error and count as failed",
      "{who} {are} not compared: the time limit stopped {share} solves {what}{to_do}",
      "{what} ({who})",
      "evaluations of {who} are not compared: ikbench cannot count them",
      "{share} answers of {who} violate joint limits",
      "{share} {what}{of_whom}",
      "times{of_who} are not compared: {what}{to_do}",
      "{share} targets per run are unreachable: no solver can solve them",
      "{who} {are} not tested in {what}: all {count} values are equal, or rounding removed their spread",
      "a few values dominate the {what} of {who}: pairs that these values decide are inconclusive",
      "{first} ranks better than {last} although its {what} is worse",
      "leaving rows out may favour {who}: {what} of the values are missing, depending on the group",
      "{who} each have one value in all blocks, as if one measurement had been copied",
      "{who}: {what}",
      "{who}: {what}",
      "{who} {are} not compared: {what}"};
  std::string_view sentence = sentences[static_cast<std::size_t>(warning.kind)];
  if (warning.kind == WarningKind::deterministic && warning.detail.empty())
    sentence = "{who} {are} deterministic: {its} equal runs count as one observation";
  const std::string names = names_of(warning.solvers),
                    share = fmt::format("{:.0f} of {:.0f}", warning.count, warning.total);
  const bool is_one = warning.solvers.size() == 1;
  const auto if_any = [&](const char* before, const char* after) {
    return names.empty() ? "" : before + names + after;
  };
  return fmt::format(
      fmt::runtime(sentence), fmt::arg("who", names), fmt::arg("of_whom", if_any(" (", ")")),
      fmt::arg("of_who", if_any(" of ", "")), fmt::arg("share", share), fmt::arg("what", warning.detail),
      fmt::arg("are", is_one ? "is" : "are"), fmt::arg("its", is_one ? "its" : "their"),
      fmt::arg("was", warning.count == 1 ? "was" : "were"),
      fmt::arg("to_do", warning.detail.ends_with("the machine was busy") ? "; rerun with --out NEW" : ""),
      fmt::arg("count", std::llround(warning.count)),
      fmt::arg("solves", counted(std::llround(warning.count), "solves")),
      fmt::arg("first", names.empty() ? names : warning.solvers.front()),
      fmt::arg("last", names.empty() ? names : warning.solvers.back()));
}

}  // namespace ikbench::judge
