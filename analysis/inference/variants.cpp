#include "analysis/inference/variants.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "analysis/inference/comparable.hpp"
#include "analysis/inference/design.hpp"
#include "analysis/inference/make_study.hpp"
#include "analysis/inference/study_facts.hpp"
#include "analysis/inference/text.hpp"
#include "numerics/json.hpp"
#include "results/same_solves.hpp"

namespace ikbench::inference {

using namespace results;

namespace {

constexpr const char* name_of_a = "A";
constexpr const char* name_of_b = "B";

std::invalid_argument refused(std::string_view what) {
  return std::invalid_argument(
      fmt::format("cannot compare A and B: they have {}; run both with the same robot, path and seed", what));
}

std::string place_of(std::span<const double> metres) {
  std::vector<std::string> texts;
  for (const double value : metres) texts.push_back(fmt::format("{:.4g}", 100 * value));
  return fmt::format("{} cm", fmt::join(texts, " "));
}

int complete_runs(const StudyResults& study, const std::string& solver) {
  for (const SolverCounts& count : counts(study)) {
    if (count.solver == solver) return count.complete_runs;
  }
  return 0;
}

// Refuses different targets or starts at any place that both have solved. In chained solves only the first start of a
// run counts: the others depend on the solver.
void refuse_other_tasks(const StudyResults& study, const Variant& a, const Variant& b) {
  for (const auto& [side, of] : {std::pair(name_of_a, &a), std::pair(name_of_b, &b)}) {
    if (complete_runs(study, side) > 0) continue;
    throw std::invalid_argument(
        fmt::format("{} has no complete run of {}, so there is nothing to compare", side, of->series.label));
  }
  const std::span<const Solve> of_b = solves_of(study, name_of_b);
  bool is_shared = false;
  for (const Solve& one : solves_of(study, name_of_a)) {
    const Solve* const other = solve_at(of_b, {one.run, one.point});
    if (other == nullptr) continue;
    is_shared = true;
    const Problem asked = problem_of(study, one), asked_other = problem_of(study, *other);
    if (!same_target(asked, asked_other)) {
      throw refused(fmt::format("different targets (run {}, point {}: {} and {})", one.run, one.point,
                                place_of(asked.target_position_m), place_of(asked_other.target_position_m)));
    }
    if ((one.point == 1 || study.facts.starts_anew()) && !same_start(asked, asked_other)) {
      throw refused(fmt::format("different start configurations (run {}, point {})", one.run, one.point));
    }
  }
  if (!is_shared) throw refused("different targets (they have no run in common)");
}

// Refuses different arms of one name: users may give two files the same name.
void refuse_other_arm(const Variant& a, const Variant& b) {
  const nlohmann::json one = facts_of(a.study.definition).arm, other = facts_of(b.study.definition).arm;
  if (!one.is_object() || !other.is_object()) return;
  for (const char* part : {"links", "base", "tool"}) {
    if (one.value(part, nlohmann::json()) == other.value(part, nlohmann::json())) continue;
    throw refused(fmt::format("arms of one name, whose {} differ", part));
  }
}

// The study of both sides while they are read.
struct BothSides {
  StudyMaker maker;
  std::vector<Session> sessions = {};
  std::string robot = {};
  int points = 0;
};

// Adds the solves of a side as those of the solver `name`. Returns the sessions of its store that solved the label.
std::vector<Session> add_side(BothSides& both, const Variant& variant, const std::string& name) {
  std::map<std::int64_t, std::int64_t> used;  // by the sessions' numbers in the study of both
  int points = 0;
  variant.each_solve([&](SolveRecord solve) {
    if (both.robot.empty()) both.robot = solve.robot;
    if (solve.robot != both.robot) throw refused(fmt::format("different robots ({} and {})", both.robot, solve.robot));
    points = std::max(points, solve.point);
    solve.solver = name;
    solve.session = used.try_emplace(solve.session, std::ssize(both.sessions) + std::ssize(used) + 1).first->second;
    both.maker.add(solve);
  });
  if (both.points > 0 && points > 0 && points != both.points) {
    throw refused(fmt::format("different targets ({} and {} points per run)", both.points, points));
  }
  both.points = points;
  std::vector<Session> result;
  for (const Session& session : variant.sessions) {
    const auto found = used.find(session.id);
    if (found == used.end()) continue;
    result.push_back(session);
    both.sessions.push_back(session);
    both.sessions.back().id = found->second;
  }
  return result;
}

using Facts = std::map<std::string, std::string>;

constexpr std::size_t longest_value = 60;
constexpr std::size_t most_named = 20;

// Returns whether a key decides or describes numbers. A name does neither; the arm, departures and points out of reach
// follow from other keys.
bool counts(std::string_view key) {
  constexpr std::array<std::string_view, 7> others{"name",       "title",           "published", "trace",
                                                   "departures", "missing_solvers", "arm"};
  const std::string_view part = key.substr(0, key.find('.'));
  return std::ranges::find(others, part) == others.end() &&
         std::ranges::find(decide_no_solve, part) == decide_no_solve.end();
}

// {"stop": {"iterations": 200}} as stop.iterations: 200. An option that is named like a key of the study is told apart.
void add_values(Facts& facts, const std::string& json) {
  const nlohmann::json parsed = numerics::parsed_json(json);
  if (!parsed.is_object() || parsed.empty()) return;  // flat, an empty one would be a value without a name
  const nlohmann::json flat = parsed.flatten();       // named: it has to outlive the loop
  for (const auto& [pointer, value] : flat.items()) {
    std::string key = pointer.empty() ? pointer : pointer.substr(1);
    std::ranges::replace(key, '/', '.');
    if (!counts(key)) continue;
    if (facts.contains(key)) key = "option " + key;
    facts[key] = value.is_string() ? value.get<std::string>() : numerics::text_of(value);
  }
}

std::set<std::string> values_of(const std::vector<Session>& sessions, const std::string& fact) {
  std::set<std::string> values;
  for (const Session& session : sessions) {
    const auto found = session.environment.find(fact);
    values.insert(found == session.environment.end() ? "unknown" : found->second);
  }
  return values;
}

Facts known_of(const Variant& of, const std::vector<Session>& sessions) {
  Facts facts{{"solver", of.series.algorithm}};
  add_values(facts, of.study.definition);
  add_values(facts, of.series.options);
  facts["source of the solver"] =
      fmt::format("{}", fmt::join(values_of(sessions, "source." + of.series.algorithm), " and "));
  for (const char* fact :
       {"version", "commit", "source", "compiler", "flags", "build_type", "instruction_set", "cpu"}) {
    facts[fact] = fmt::format("{}", fmt::join(values_of(sessions, fact), " and "));
  }
  return facts;
}

// Reasons not to compare times: several CPUs, unknown CPUs, or separate sessions, whose differences no number of runs
// shows. Empty if times are comparable.
Doubts why_times_differ(const std::vector<Session>& a, const std::vector<Session>& b) {
  std::set<std::string> cpus = values_of(a, "cpu");
  cpus.merge(values_of(b, "cpu"));
  if (a.empty() || b.empty() || cpus.contains("unknown")) {
    return {{.kind = DoubtKind::unknown_machine, .is_of_all = true}};
  }
  std::vector<Session> sessions = a;
  std::ranges::copy(b, std::back_inserter(sessions));
  if (Doubts doubts = cpu_doubts(machines_of(sessions)); !doubts.empty()) return doubts;
  const auto is_same = [](const Session& one, const Session& other) {
    return one.id == other.id && one.environment == other.environment;
  };
  if (std::ranges::equal(a, b, is_same)) return {};
  return {{.kind = DoubtKind::separate_sessions, .is_of_all = true}};
}

// "B differs from A in stop.iterations (200, 100), commit (1a2b3c, 4d5e6f)." or a sentence that the stores show no
// difference. The sessions are those that solved the study.
std::string differences(const Variant& a, const std::vector<Session>& of_a, const Variant& b,
                        const std::vector<Session>& of_b) {
  const Facts facts_of_a = known_of(a, of_a), facts_of_b = known_of(b, of_b);
  std::set<std::string> keys;
  for (const Facts* facts : {&facts_of_a, &facts_of_b}) {
    for (const auto& [key, value] : *facts) keys.insert(key);
  }
  const auto value_in = [](const Facts& facts, const std::string& key) {
    const auto found = facts.find(key);
    return found == facts.end() || found->second.empty() ? std::string("none")
                                                         : shortened(found->second, longest_value);
  };
  std::vector<std::string> found;
  for (const std::string& key : keys) {
    const std::string one = value_in(facts_of_a, key), other = value_in(facts_of_b, key);
    if (one != other) found.push_back(fmt::format("{} ({}, {})", key, one, other));
  }
  if (found.empty()) return "The stores show no difference between A and B except their sessions.";
  const std::size_t named = std::min(found.size(), most_named);
  const std::string more = found.size() == named ? "" : fmt::format(" and {} more", found.size() - named);
  return fmt::format("B differs from A in {}{}.",
                     fmt::join(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(named), ", "), more);
}

}  // namespace

std::vector<Variant> variants(const Store& store, const StudyEntry& study) {
  const std::vector<Session> sessions = store.sessions();
  std::vector<Variant> result;
  for (const Series& series : study.series) {
    StudyEntry alone = study;
    alone.series = {series};
    result.push_back({.study = study,
                      .series = series,
                      .sessions = sessions,
                      .each_solve = [&store, alone](const std::function<void(SolveRecord)>& take) {
                        store.each_of_study(alone, take);
                      }});
  }
  return result;
}

VariantStudy study_of_both(const Variant& a, const Variant& b, const AnalysisPlan& plan) {
  refuse_other_arm(a, b);
  StudyEntry entry = a.study;
  entry.series = {a.series, b.series};
  entry.series[0].label = name_of_a;
  entry.series[1].label = name_of_b;
  BothSides both{.maker = StudyMaker(entry)};
  const std::vector<Session> of_a = add_side(both, a, name_of_a), of_b = add_side(both, b, name_of_b);
  VariantStudy result{.label = a.series.label == b.series.label
                                   ? b.series.label
                                   : fmt::format("{} against {}", b.series.label, a.series.label),
                      .is_of_two = a.series.label != b.series.label,
                      .study = both.maker.finish(both.sessions),
                      .times_differ = why_times_differ(of_a, of_b),
                      .differences = differences(a, of_a, b, of_b)};
  AnalysisPlan& judged = result.study.plan;
  judged.control.clear();
  judged.margin = plan.margin;
  judged.margin_cm = plan.margin_cm;
  judged.significance = plan.significance;
  judged.estimands = plan.estimands;
  refuse_other_tasks(result.study, a, b);
  return result;
}

}  // namespace ikbench::inference
