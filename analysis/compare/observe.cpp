#include "analysis/compare/observe.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "analysis/compare/describe.hpp"
#include "analysis/compare/tests_of_two.hpp"
#include "numerics/json.hpp"

namespace ikbench::compare {

using namespace results;

namespace {

std::vector<Solves> runs_of(Solves rest) {
  std::vector<Solves> runs;
  while (!rest.empty()) {
    const auto is_other = [&](const Solve& solve) { return solve.run != rest.front().run; };
    runs.push_back(rest.first(static_cast<std::size_t>(std::ranges::find_if(rest, is_other) - rest.begin())));
    rest = rest.subspan(runs.back().size());
  }
  return runs;
}

bool is_complete(const StudyResults& study, Solves run) { return std::ssize(run) == study.definition.points; }

std::vector<Solves> complete_runs_of(const StudyResults& study, std::string_view solver) {
  std::vector<Solves> runs = runs_of(study.of(solver));
  std::erase_if(runs, [&](Solves run) { return !is_complete(study, run); });
  return runs;
}

// What one observation is.
struct Design {
  bool are_runs = false;  // a run, else a target
  bool is_paired = false;
  int solves = 1;  // that make it
};

Design design_of(const StudyResults& study, bool of_run) {
  const bool is_drawn = study.definition.draws_targets;
  const bool are_runs = of_run || study.definition.compares_runs();
  return {.are_runs = are_runs,
          .is_paired = is_drawn || !are_runs,
          .solves = are_runs   ? study.definition.points
                    : is_drawn ? 1
                               : study.definition.runs};
}

// The same target, outcome and answer, bit for bit.
bool are_same(const Solve& one, const Solve& other) {
  return one.target == other.target && one.status == other.status && one.answer == other.answer;
}

// The same targets and answers in every run, bit for bit. Such runs are copies where a run is an observation.
bool repeats_itself(const StudyResults& study, std::string_view solver) {
  const std::vector<Solves> runs = complete_runs_of(study, solver);
  return runs.size() > 1 && std::ranges::all_of(runs, [&](Solves run) {
           return std::ranges::equal(run, runs.front(), [](const Solve& one, const Solve& other) {
             return one.answer != 0 && are_same(one, other);
           });
         });
}

// Below it errors are equal; 0 where the study has none.
double tolerance_of(const StudyResults& study, const Metric& metric) {
  const numerics::StopRule& stop = study.definition.stop;
  if (metric.kind != Kind::error) return 0;
  return metric.unit == "deg" ? stop.tolerance_deg() : stop.tolerance_cm();
}

// What failed has no cost of an answer; along a path it has, for the next solve starts from there.
bool is_of_solved(const StudyResults& study, const Metric& metric) {
  const bool is_cost = metric.kind == Kind::cost || metric.kind == Kind::time;
  return is_cost && !metric.is_of_run && study.definition.has_tolerance() && !study.definition.is_chained();
}

struct Value {
  int block;
  double value;
};

// Of the solves, by block; an observation is made of those of one.
std::vector<Value> values_of(const StudyResults& study, const Metric& metric, const Design& design,
                             std::string_view solver) {
  const Definition& definition = study.definition;
  const bool of_solved = is_of_solved(study, metric);
  const double least = tolerance_of(study, metric);
  // Where the arm stayed is no error of a solver that never moved it.
  const bool is_unknown = metric.kind == Kind::error && std::ranges::none_of(study.of(solver), gave_answer);
  std::vector<Value> values;
  for (const Solves run : runs_of(study.of(solver))) {
    if (design.are_runs && !is_complete(study, run)) continue;
    if (metric.is_of_run) {
      values.push_back({run.front().run, metric.value(run.back(), study)});
      continue;
    }
    for (const Solve& solve : run) {
      if (of_solved && solve.status != Status::ok) continue;
      const int block = design.are_runs            ? solve.run
                        : definition.draws_targets ? (solve.run - 1) * definition.points + solve.point
                                                   : solve.point;
      const double value = is_unknown ? unknown : metric.value(solve, study);
      values.push_back({block, value < least ? least : value});
    }
  }
  if (!std::ranges::is_sorted(values, {}, &Value::block)) std::ranges::stable_sort(values, {}, &Value::block);
  return values;
}

// The observations: the mean of each block, of times the median; NaN where a value is unknown.
std::vector<Value> means_of(const std::vector<Value>& all, bool are_medians = false) {
  std::vector<Value> means;
  std::vector<double> values;
  for (std::size_t i = 0; i < all.size();) {
    const int block = all[i].block;
    for (values.clear(); i < all.size() && all[i].block == block; ++i) values.push_back(all[i].value);
    const bool is_known = std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
    const double value = !is_known ? unknown : are_medians ? described(values).median : summarise(values).mean;
    means.push_back({block, std::isfinite(value) ? value : unknown});
  }
  return means;
}

// What attempts spent by what they solved: of each observation a logarithm, so that their mean is that of the ratio of
// the two sums, and their spread its error (the infinitesimal jackknife; Efron, The Jackknife, 1982, chapter 6).
std::vector<Value> spent_by_solved(std::vector<Value> spent, const std::vector<Value>& solved) {
  double all_spent = 0, all_solved = 0;
  for (std::size_t i = 0; i < spent.size(); ++i) all_spent += spent[i].value, all_solved += solved[i].value;
  const auto n = static_cast<double>(spent.size());
  for (std::size_t i = 0; i < spent.size(); ++i)
    spent[i].value = std::log(all_spent / all_solved) + n * (spent[i].value / all_spent - solved[i].value / all_solved);
  return spent;
}

Group group_of(const StudyResults& study, const Metric& metric, const Design& design, const std::string& solver) {
  Group group{.name = solver};
  const double least = tolerance_of(study, metric);
  const std::vector<Value> all = values_of(study, metric, design, solver);
  if (std::ranges::any_of(all, [=](const Value& each) { return each.value <= least; })) group.at_most = least;
  std::vector<Value> values = means_of(all, metric.kind == Kind::time);
  if (metric.kind == Kind::spent) {
    const std::vector<Value> solved = means_of(values_of(study, metric_named("solved"), design, solver));
    if (!solved.empty() && std::ranges::all_of(solved, [](const Value& each) { return each.value == 0; })) {
      group.sample = Untold{.why = Untold::Why::none};
      return group;
    }
    values = spent_by_solved(std::move(values), solved);
  }
  Measured measured;
  int lost = 0;
  for (const auto& [block, value] : values) {
    if (!std::isfinite(value)) {
      ++lost;
      continue;
    }
    measured.values.push_back(value);
    if (design.is_paired) measured.blocks.push_back(block);
  }
  const bool are_equal = measured.values.size() > 1 &&
                         std::ranges::count(measured.values, measured.values.front()) == std::ssize(measured.values);
  if (lost > 0)
    group.sample = Untold{.why = Untold::Why::lost, .lost = lost, .values = std::move(measured.values)};
  else if (!design.is_paired && are_equal && repeats_itself(study, solver))
    group.sample = Copies{measured.values.front(), static_cast<int>(measured.values.size())};
  else
    group.sample = std::move(measured);
  return group;
}

// A group that lost values stays so: the stronger reason.
void leave_apart(Group& group) {
  if (untold(group)) return;
  const std::span<const double> values = compare::values_of(group);
  group.sample = Untold{.why = Untold::Why::apart, .values = {values.begin(), values.end()}};
}

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

auto is_timed(Timing how) {
  return [how](const Solve& solve) { return solve.timing == how; };
}

// Who was slowed, and by what. No solver, but a doubt: of all.
std::vector<Doubt> doubts_of_load(const StudyResults& study) {
  Doubts doubts;
  const auto doubt_of = [](const char* what) { return Doubt{.kind = DoubtKind::times_not_comparable, .what = what}; };
  add(doubts, study, doubt_of("solved in parallel"), is_timed(Timing::parallel));
  add(doubts, study, doubt_of("a debug build"), is_timed(Timing::debug_build));
  // Machines differ if their processors do, or both name and start: one that starts again keeps its name, and
  // containers on it have their own.
  const auto differ = [&](const char* fact) { return facts_of(study, fact).size() > 1; };
  if (differ("cpu") || (differ("host") && differ("boot"))) doubts.push_back(doubt_of("several machines"));
  for (Doubt& doubt : doubts) doubt.who.clear();
  if (!doubts.empty()) return {doubts.front()};
  add_counts(doubts, study, doubt_of("the machine was busy"), [&](const std::string& solver) {
    const auto disturbed = std::ranges::count_if(study.of(solver), &Solve::was_disturbed);
    const auto clean = std::ranges::count_if(study.of(solver), is_timed(Timing::clean));
    return std::pair(disturbed > 1 && 10 * disturbed > clean ? disturbed : 0, clean);
  });
  return doubts;
}

// Those that were solved in other sessions than most.
std::vector<std::string> measured_apart(const StudyResults& study) {
  std::map<std::set<int>, std::vector<std::string>> solvers_of;
  for (const std::string& solver : study.labels) {
    std::set<int> sessions;
    for (const Solve& solve : study.of(solver)) sessions.insert(solve.session);
    if (!sessions.empty()) solvers_of[sessions].push_back(solver);
  }
  const auto size = [](const auto& entry) { return entry.second.size(); };
  if (!solvers_of.empty()) solvers_of.erase(std::ranges::max_element(solvers_of, {}, size));
  std::vector<std::string> apart;
  for (const auto& [sessions, solvers] : solvers_of) apart.insert(apart.end(), solvers.begin(), solvers.end());
  return apart;
}

// Those whose solves are another's, so that only the machine can make their times differ; the control is none.
std::vector<std::string> copies_of_others(const StudyResults& study) {
  std::vector<std::string> copies, solvers = study.labels;
  std::vector<Solves> earlier;
  const auto is_control = [&](const std::string& solver) { return solver == study.definition.plan.control; };
  std::stable_partition(solvers.begin(), solvers.end(), is_control);
  for (const std::string& solver : solvers) {
    const Solves all = study.of(solver);
    const auto is_same = [&](Solves other) { return !all.empty() && have_same_solves(other, all); };
    if (std::ranges::any_of(earlier, is_same)) copies.push_back(solver);
    earlier.push_back(all);
  }
  return copies;
}

std::vector<Doubt> doubts_of_times(const StudyResults& study) {
  std::vector<Doubt> doubts = doubts_of_load(study);
  if (!doubts.empty() && doubts.front().who.empty()) return doubts;
  constexpr std::size_t fewest_turns = 5;  // at being first: fewer leave a drift of the machine in the times
  const auto takes_turns = [&](const auto& solver) { return runs_of(study.of(solver)).size() >= fewest_turns; };
  if (study.labels.size() > 1 && std::ranges::none_of(study.labels, takes_turns))
    return {{.kind = DoubtKind::times_not_comparable, .what = "one solver after the other"}};
  const auto add_of = [&](std::vector<std::string> who, const char* what) {  // one reason is enough
    for (const Doubt& told : doubts)
      std::erase_if(who, [&](const std::string& solver) { return std::ranges::count(told.who, solver) > 0; });
    add(doubts, {.kind = DoubtKind::times_not_comparable, .who = std::move(who), .what = what});
  };
  add_of(measured_apart(study), "measured in another session");
  add_of(copies_of_others(study), "all solves are another's, bit for bit");
  std::vector<std::string> programs = study.labels;
  std::erase_if(programs, [&](const std::string& solver) {
    return std::ranges::none_of(study.of(solver), is_timed(Timing::process));
  });
  if (programs.size() < study.labels.size()) add_of(std::move(programs), "messages are in them");
  return doubts;
}

// What solvers reach in seconds depends on the load.
std::vector<Doubt> doubts_of_clock(const StudyResults& study) {
  const double limit = study.definition.stop.seconds;
  if (limit == 0) return {};
  const auto is_ended = [=](const Solve& solve) {  // programs stop before it
    return solve.seconds >= 0.9 * limit && !solve.had_enough_time;
  };
  std::vector<Doubt> doubts = doubts_of_load(study);
  if (!measured_apart(study).empty()) doubts.push_back({.what = "measured in different sessions"});
  for (Doubt& doubt : doubts) {
    doubt.kind = DoubtKind::seconds_decide;
    if (doubt.who.empty()) doubt.who = study.labels;
    std::erase_if(doubt.who,
                  [&](const std::string& solver) { return std::ranges::none_of(study.of(solver), is_ended); });
  }
  std::erase_if(doubts, [](const Doubt& doubt) { return doubt.who.empty(); });
  return doubts;
}

void add_of_evaluations(Doubts& doubts, const StudyResults& study) {
  for (const auto& [by, what] : {std::pair(CountedBy::nobody, "evaluations are not counted, so not compared"),
                                 {CountedBy::solver, "evaluations are by its own count, so not compared"}})
    add(doubts, study, {.kind = DoubtKind::counted_otherwise, .what = what},
        [by = by](const Solve& solve) { return !is_without_answer(solve.status) && solve.counted_by == by; });
}

// Solvers whose solves, nearly all, a limit of the study ends: the one of most and the one of fewest evaluations.
void add_of_budgets(Doubts& doubts, const StudyResults& study) {
  if (study.definition.stop.seconds > 0) return;
  std::string fewest, most;
  double few = std::numeric_limits<double>::infinity(), many = 0;
  for (const std::string& solver : study.labels) {
    double evaluations = 0, limited = 0, uncounted = 0;
    const Solves all = study.of(solver);
    for (const Solve& solve : all) {
      evaluations += static_cast<double>(solve.evaluations) / static_cast<double>(all.size());
      limited += solve.stop_reason == StopReason::iterations || solve.stop_reason == StopReason::evaluations;
      uncounted += solve.counted_by != CountedBy::suite;
    }
    if (uncounted > 0 || evaluations == 0 || limited < 0.9 * static_cast<double>(all.size())) continue;
    if (evaluations < few) few = evaluations, fewest = solver;
    if (evaluations > many) many = evaluations, most = solver;
  }
  if (many < 2 * few) return;
  doubts.push_back({.kind = DoubtKind::budgets_differ,
                    .who = {most, fewest},
                    .count = many,
                    .of = few,
                    .what = fmt::format("budgets differ: {:.0f} and {:.0f} evaluations a solve", many, few)});
}

// By the stored plan: a command may judge by another.
void add_of_plan(Doubts& doubts, const StudyResults& study) {
  const numerics::Json plan = numerics::parsed_json(study.entry.definition)["analysis"];
  std::set<std::int64_t> others;  // sessions
  std::set<std::string> fields;
  for (const Session& session : study.sessions) {
    const auto recorded = session.environment.find("analysis");
    if (recorded == session.environment.end()) continue;
    const numerics::Json then = numerics::parsed_json(recorded->second);
    for (const auto& [field, value] : then.items()) {
      if (!plan.contains(field) || plan[field] != value) others.insert(session.id), fields.insert(field);
    }
  }
  add(doubts, study, {.kind = DoubtKind::plan_changed, .what = fmt::format("{}", fmt::join(fields, ", "))},
      [&](const Solve& solve) { return others.contains(solve.session); });
}

void add_of_repeats(Doubts& doubts, const StudyResults& study) {
  if (design_of(study, false).is_paired) return;
  std::map<std::size_t, std::vector<std::string>> repeating;  // solvers, by their number of runs
  for (const std::string& solver : study.labels) {
    if (repeats_itself(study, solver)) repeating[complete_runs_of(study, solver).size()].push_back(solver);
  }
  for (const auto& [runs, who] : repeating)
    doubts.push_back({.kind = DoubtKind::repeats_itself, .who = who, .count = static_cast<double>(runs)});
}

}  // namespace

bool gave_answer(const Solve& solve) { return !is_without_answer(solve.status) && solve.status != Status::not_finite; }

bool have_same_solves(Solves solves, Solves others) {
  return std::ranges::equal(solves, others, [](const Solve& one, const Solve& two) {
    return one.run == two.run && one.point == two.point && are_same(one, two) && one.evaluations == two.evaluations;
  });
}

std::vector<Doubt> doubts_of(const StudyResults& study) {
  Doubts doubts;
  add_counts(doubts, study, {.kind = DoubtKind::runs_missing}, [&](const std::string& solver) {
    return std::pair(study.definition.runs - std::ssize(complete_runs_of(study, solver)), study.definition.runs);
  });
  add(doubts, study, {.kind = DoubtKind::without_answer}, [](const Solve& solve) { return !gave_answer(solve); });
  add(doubts, study, {.kind = DoubtKind::claimed_but_wrong},
      [](const Solve& solve) { return solve.status == Status::claimed_but_wrong; });
  add(doubts, study, {.kind = DoubtKind::outside_limits}, &Solve::is_outside_limits);
  add_of_budgets(doubts, study);
  if (const int count = study.definition.out_of_reach; count > 0)
    doubts.push_back({.kind = DoubtKind::out_of_reach,
                      .count = static_cast<double>(count),
                      .of = static_cast<double>(study.definition.points)});
  add_of_plan(doubts, study);
  add_of_repeats(doubts, study);
  add(doubts, study.other_version);
  return doubts;
}

Observations observe(const StudyResults& study, const Metric& metric) {
  const Design design = design_of(study, metric.is_of_run);
  Observations observed{.metric = std::string(metric.slug),
                        .quantity = std::string(metric.name),
                        .unit = std::string(metric.unit),
                        .better = metric.kind == Kind::share ? Better::larger : Better::smaller,
                        .scale = metric.scale,
                        .absolute_margin = metric.unit == "cm" ? study.definition.plan.margin_cm : 0,
                        .floor = metric.floor,
                        .rounding = metric.rounding,
                        .is_paired = design.is_paired,
                        .is_of_solved = is_of_solved(study, metric),
                        .are_logs = metric.kind == Kind::spent,
                        .trials = design.solves};
  std::vector<Group>& groups = observed.groups;
  for (const std::string& solver : study.labels) groups.push_back(group_of(study, metric, design, solver));
  observed.doubts = metric.unit == "s" ? doubts_of_times(study) : doubts_of_clock(study);
  if (metric.column.starts_with("evaluations")) add_of_evaluations(observed.doubts, study);
  for (const Doubt& doubt : observed.doubts) {
    for (Group& group : groups) {
      if (doubt.who.empty() || std::ranges::count(doubt.who, group.name) > 0) leave_apart(group);
    }
  }
  std::vector<Measured*> compared;
  for (Group& group : groups) {
    if (auto* const measured = std::get_if<Measured>(&group.sample)) compared.push_back(measured);
  }
  const auto has_same_blocks = [&](const Measured* group) { return group->blocks == compared.front()->blocks; };
  if (std::ranges::all_of(compared, has_same_blocks)) {
    for (Measured* const group : compared) group->blocks.clear();
  }
  return observed;
}

}  // namespace ikbench::compare
