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

using Doubts = std::vector<Doubt>;

// Adds a doubt, if it is about some solver.
void add(Doubts& doubts, Doubt doubt) {
  if (!doubt.who.empty()) doubts.push_back(std::move(doubt));
}

// Adds a doubt of all solvers with a count, which stands before of how many.
template <class Counted>
void add_counts(Doubts& doubts, const StudyResults& study, Doubt doubt, Counted counted) {
  for (const std::string& solver : study.labels) {
    const auto [count, total] = counted(solver);
    if (count <= 0) continue;
    doubt.who.push_back(solver);
    doubt.count += static_cast<double>(count);
    doubt.of += static_cast<double>(total);
  }
  add(doubts, std::move(doubt));
}

// Adds a doubt of all solves that are so, and of the solvers that made them.
template <class Is>
void add(Doubts& doubts, const StudyResults& study, Doubt doubt, Is is_so) {
  add_counts(doubts, study, std::move(doubt), [&](const std::string& solver) {
    const Solves all = study.of(solver);
    return std::pair(std::ranges::count_if(all, is_so), std::ssize(all));
  });
}

// How solves were timed, if not as one alone of an optimised build.
std::string odd_timing_of(const StudyResults& study) {
  const auto is_any = [&](Timing how) { return std::ranges::count(study.solves, how, &Solve::timing) > 0; };
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
void add_of_budgets(Doubts& doubts, const StudyResults& study) {
  if (study.definition.stop.seconds > 0) return;
  std::string fewest, most;
  double few = std::numeric_limits<double>::infinity(), many = 0;
  for (const std::string& solver : study.labels) {
    double limited = 0, spent = 0, largest = 0;
    const Solves all = study.of(solver);
    if (!std::ranges::all_of(all, [](const Solve& its) { return its.counted_by == CountedBy::suite; })) continue;
    for (const Solve& solve : all) {
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
  doubts.push_back({.kind = WarningKind::budgets_differ,
                    .who = {most, fewest},
                    .count = many,
                    .of = few,
                    .what = fmt::format("budgets differ: {:.0f} and {:.0f} evaluations a solve", many, few)});
}

// By the stored plan: a command may judge by another.
void add_of_plan(Doubts& doubts, const StudyResults& study) {
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
  add(doubts, study, {.kind = WarningKind::plan_changed, .what = fmt::format("{}", fmt::join(fields, ", "))},
      [&](const Solve& solve) { return others.contains(solve.session); });
}

}  // namespace

std::vector<Doubt> time_warnings(const StudyResults& study) {
  const SessionSets sessions = sessions_of(study);
  const bool are_alone = study.in_batches.empty() || environment_values(study, "jobs") == std::set<std::string>{"1"};
  const auto compared = std::ssize(sessions.compared);
  std::string of_all = are_alone ? odd_timing_of(study) : "solved in parallel";
  if (of_all.empty() && std::ranges::none_of(study.sessions, uses_current_clock))
    of_all = "of the clock of a former version";
  else if (of_all.empty() && compared < min_sessions)
    of_all = fmt::format("{}, and {} are the fewest", base::counted(compared, "sessions"), min_sessions);
  if (!of_all.empty()) return {{.kind = WarningKind::times_not_comparable, .what = of_all}};
  Doubts doubts;
  std::set<std::string> told;  // one reason is enough
  const auto add_of = [&](std::vector<std::string> who, const std::string& what) {
    std::erase_if(who, [&](const std::string& solver) { return !told.insert(solver).second; });
    add(doubts, {.kind = WarningKind::times_not_comparable, .who = std::move(who), .what = what});
  };
  add_of(study.beside.labels, "solved " + study.beside.of);
  std::vector<std::string> in_batches, silent;
  for (const auto& [solver, its] : study.in_batches) in_batches.push_back(solver);
  add_of(std::move(in_batches), "asked in batches");
  for (const std::string& solver : study.labels) {
    const Solves all = study.of(solver);
    const auto tells_none = [](const Solve& solve) {
      return solve.timing == Timing::process && !solve.is_told && gave_answer(solve);
    };
    if (10 * std::ranges::count_if(all, tells_none) > std::ssize(all)) silent.push_back(solver);
  }
  if (silent.size() < study.labels.size()) add_of(std::move(silent), "messages included");  // however often solved
  add_of(measured_apart(study, sessions.made),
         "too few sessions in common with the others; solve all again: --out NEW");
  add_of(measured_apart(study, sessions.told), "the machine was busy");
  return doubts;
}

std::vector<Doubt> clock_warnings(const StudyResults& study) {
  const double limit = study.definition.stop.seconds;
  if (limit == 0) return {};
  // Machines differ if their processors do, or both name and start: one that starts again keeps its name, and
  // containers on it have their own.
  const auto differ = [&](const char* fact) { return environment_values(study, fact).size() > 1; };
  const std::vector<std::set<int>> sessions = sessions_of(study).all;
  std::set<std::set<int>> different(sessions.begin(), sessions.end());
  different.erase(std::set<int>());  // of who has no solves
  std::string of_all = odd_timing_of(study);
  if (of_all.empty() && (differ("cpu") || (differ("host") && differ("boot")))) of_all = "several machines";
  if (of_all.empty() && different.size() > 1) of_all = "measured in different sessions";
  Doubts doubts;
  for (const bool is_beside : {false, true}) {
    const std::string what = is_beside ? "solved " + study.beside.of : of_all.empty() ? "the machine was busy" : of_all;
    add_counts(doubts, study, {.kind = WarningKind::time_limit_decides, .what = what}, [&](const std::string& solver) {
      const Solves all = study.of(solver);
      const auto ended = std::ranges::count_if(all, [=](auto&its) { return its.seconds >= 0.9 * limit; }),
                 disturbed = std::ranges::count_if(all, &Solve::was_preempted);  // programs stop before the limit
      const bool decides = is_beside || !of_all.empty() || (disturbed > 1 && 10 * disturbed > std::ssize(all));
      return std::pair(decides && study.beside.has(solver) == is_beside ? ended : 0, std::ssize(all));
    });
  }
  return doubts;
}

std::vector<Doubt> evaluation_warnings(const StudyResults& study) {
  Doubts doubts = clock_warnings(study);
  add(doubts, study, {.kind = WarningKind::counts_not_comparable},
      [](const Solve& solve) { return !is_without_answer(solve.status) && solve.counted_by != CountedBy::suite; });
  return doubts;
}

std::vector<Doubt> doubts_of(const StudyResults& study) {
  Doubts doubts;
  const Doubt missing{.kind = WarningKind::runs_missing, .what = "runs missing or without some targets"};
  add_counts(doubts, study, missing, [&](const std::string& solver) {
    return std::pair(study.definition.runs - std::ssize(complete_runs_of(study, solver)), study.definition.runs);
  });
  add(doubts, study, {.kind = WarningKind::without_answer, .what = "solves gave no answer"},
      [](const Solve& solve) { return !gave_answer(solve); });
  add(doubts, study, {.kind = WarningKind::claimed_but_wrong},
      [](const Solve& solve) { return solve.status == Status::claimed_but_wrong; });
  add(doubts, study, {.kind = WarningKind::limit_violations}, &Solve::is_outside_limits);
  add_of_budgets(doubts, study);
  if (const int count = study.definition.out_of_reach; count > 0)
    doubts.push_back({.kind = WarningKind::out_of_reach,
                      .count = static_cast<double>(count),
                      .of = static_cast<double>(study.definition.points)});
  add_of_plan(doubts, study);
  Doubt repeating{.kind = WarningKind::repeats_itself};
  if (!study.definition.draws_targets && study.definition.compares_runs())  // else paired
    std::ranges::copy_if(study.labels, std::back_inserter(repeating.who),
                         [&](const std::string& solver) { return repeats_itself(study, solver); });
  add(doubts, std::move(repeating));
  add(doubts, study.stale_solves);
  return doubts;
}

std::string words_of(const Doubt& doubt) {
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
  std::string_view sentence = sentences[static_cast<std::size_t>(doubt.kind)];
  if (doubt.kind == WarningKind::repeats_itself && doubt.what.empty())
    sentence = "{who} gave the same answers in every run, which count as one";
  const std::string who = names_of(doubt.who, ", "), share = fmt::format("{:.0f} of {:.0f}", doubt.count, doubt.of);
  const auto if_any = [&](const char* before, const char* after) { return who.empty() ? "" : before + who + after; };
  return fmt::format(
      fmt::runtime(sentence), fmt::arg("who", who), fmt::arg("of_whom", if_any(" (", ")")),
      fmt::arg("of_who", if_any(" of ", "")), fmt::arg("share", share), fmt::arg("what", doubt.what),
      fmt::arg("was", doubt.who.size() == 1 ? "was" : "were"),
      fmt::arg("to_do", doubt.what == "the machine was busy" ? "; solve again: --out NEW" : ""),
      fmt::arg("count", std::llround(doubt.count)), fmt::arg("solves", counted(std::llround(doubt.count), "solves")),
      fmt::arg("first", who.empty() ? who : doubt.who.front()), fmt::arg("last", who.empty() ? who : doubt.who.back()));
}

}  // namespace ikbench::judge
