#include "analysis/judge/gate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

namespace ikbench::judge {
namespace {

using namespace results;

void refuse_other_task(const StudyResults& one, const StudyResults& other) {
  const Definition &a = one.definition, &b = other.definition;
  const std::pair<bool, const char*> differences[]{
      {a.robot != b.robot || a.arm != b.arm, "arms"},
      {a.path != b.path || a.points != b.points, "targets"},
      {a.seed != b.seed, "seeds"},
      {a.search != b.search, "searches"},
      {a.start != b.start, "starts"},
      {a.task != b.task || a.near != b.near || a.rotation_weight != b.rotation_weight,
       "paths, starts or weights of a rotation"},
      {a.limits != b.limits, "treatments of joint limits"},
      {a.check != b.check, "checks of answers"},
      {a.stop.tolerance != b.stop.tolerance || a.stop.angle_tolerance != b.stop.angle_tolerance, "tolerances"}};
  for (const auto& [differ, what] : differences)
    if (differ)
      throw std::invalid_argument(fmt::format("not compared: {} has other {} than before", other.labels.front(), what));
}

// Of each of their sessions the one of ours of the same turn, which is a shard, if each turn of both began before the
// next of either; a second is the least that times of sessions tell. None if they were not solved in turn.
std::optional<std::map<int, int>> turns_of(const std::vector<Session>& ours, const std::vector<Session>& theirs) {
  if (ours.size() < 2 || ours.size() != theirs.size()) return {};
  const auto shard_of = [](const Session& session) {
    const auto shard = session.environment.find("shard");
    return shard == session.environment.end() ? "" : shard->second;
  };
  std::map<int, int> turns;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const bool is_early =
        i > 0 && std::min(ours[i].began, theirs[i].began) < std::max(ours[i - 1].began, theirs[i - 1].began);
    if (is_early || shard_of(ours[i]).empty() || shard_of(ours[i]) != shard_of(theirs[i])) return {};
    turns[static_cast<int>(theirs[i].id)] = static_cast<int>(ours[i].id);
  }
  return turns;
}

// Of both stores, as solvers of one study. Takes their solves. Sessions of one turn are one; without turns all differ.
StudyResults study_of_both(StudyResults& baseline, StudyResults both, const std::map<int, int>& turns) {
  both.labels = {"now", "before"};
  both.faults = {};
  const auto before = both.sessions.empty() ? 0 : static_cast<int>(both.sessions.back().id);
  for (Session& session : std::exchange(baseline.sessions, {})) {
    if (!turns.empty()) continue;
    session.id += before;
    both.sessions.push_back(std::move(session));
  }
  both.solves.reserve(2 * both.solves.size());
  for (Solve solve : std::exchange(baseline.solves, {})) {
    solve.label = 1;
    solve.session = turns.empty() ? solve.session + before : turns.at(solve.session);
    both.solves.push_back(solve);
  }
  refuse_other_targets(both);
  both.definition.plan = baseline.definition.plan;  // a candidate sets no margin of its own
  return both;
}

// Of solves, whatever they are of. Where the machine decides who is too late, that is not counted.
Observations observed_answers(const StudyResults& study, bool machine_decides) {
  Observations observed{
      .metric = "answers", .quantity = "answered", .better = Better::larger, .scale = Scale::share, .is_paired = true};
  observed.measures = Measure::answered;
  for (const std::string& solver : study.labels) {
    Measured answers;
    for (const Solve& solve : study.of(solver))
      answers.values.push_back(gave_answer(solve) || (machine_decides && solve.status == results::Status::over_budget));
    observed.groups.push_back({.name = solver, .sample = std::move(answers)});
  }
  return observed;
}

// Solved in time is one, too.
bool is_time(const JudgedMetric& judged) { return judged.observations.measures == Measure::time; }

// What takes a part of the significance.
bool may_decide(const Gate& gate, const JudgedMetric& judged) {
  return is_time(judged) ? gate.do_times_decide : !gate.are_same;
}

bool is_of_answers(const JudgedMetric& judged) { return judged.observations.measures == Measure::answered; }

// How many answers are missing where before none was, or where now none is left. Chance may do that, too.
int newly_missing(const JudgedMetric& judged) {
  const Description &candidate = judged.described.front(), &baseline = judged.described.back();
  const bool is_new = is_of_answers(judged) && (baseline.mean == 1 || candidate.mean == 0);
  return is_new ? static_cast<int>(std::lround((baseline.mean - candidate.mean) * baseline.n)) : 0;
}

}  // namespace

Gate gate(StudyResults study, std::optional<double> time_margin, const std::string& label) {
  const std::string candidate = study.labels.front(), baseline = study.labels.back();
  const Solves ours = study.of(candidate), theirs = study.of(baseline);
  const auto place = [](const Solve& solve) { return std::pair(solve.run, solve.point); };
  if (theirs.empty() || !std::ranges::equal(ours, theirs, {}, place, place))
    throw std::invalid_argument(fmt::format(
        "not compared: {} has {} solves, {} {}; complete both with ikbench run, with as many runs",
        label.empty() ? candidate : label, ours.size(), label.empty() ? baseline : "before", theirs.size()));
  Gate gate{.label = label,
            .do_times_decide = time_margin.has_value(),
            .are_same = have_same_solves(ours, theirs) && std::ranges::any_of(ours, gave_answer)};
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const bool is_solved = ours[i].status == Status::ok, was_solved = theirs[i].status == Status::ok;
    gate.same += have_same_solves(ours.subspan(i, 1), theirs.subspan(i, 1));
    if (is_solved == was_solved || !study.definition.has_tolerance()) continue;
    (is_solved ? gate.won : gate.lost)
        .push_back(study.definition.points == 1 ? fmt::format("run {}", ours[i].run)
                                                : fmt::format("target {} of run {}", ours[i].point, ours[i].run));
  }
  study.definition.plan.control = baseline;  // shown second
  JudgedStudy& judged = gate.judged = observe_all(std::move(study));
  const bool machine_decides = !doubts_of_clock(judged.study).empty();
  judged.metrics.push_back(
      {.observations = observed_answers(judged.study, machine_decides), .plan = judged.study.definition.plan});
  for (JudgedMetric& metric : judged.metrics)
    if (is_time(metric) && time_margin) metric.plan.margin = *time_margin;
  judged.study.solves = {}, judged.study.drawn = {};  // observed, and large
  return gate;
}

Gate gate(StudyResults baseline, StudyResults candidate, std::optional<double> time_margin) {
  refuse_other_task(baseline, candidate);
  const std::string label = candidate.labels.front();
  const bool are_of_this_clock = std::ranges::all_of(baseline.sessions, is_of_this_clock) &&
                                 std::ranges::all_of(candidate.sessions, is_of_this_clock);
  const auto turns = turns_of(candidate.sessions, baseline.sessions);
  const std::string now = calls_of(candidate), before = calls_of(baseline);
  const std::string other = !are_of_this_clock
                                ? "of the clock of a former version, which no time of this one is compared with"
                            : now != before ? fmt::format("{}, before {}", now, before)
                                            : "";
  if (time_margin && !(turns && other.empty()))
    throw std::invalid_argument(fmt::format(
        "not compared: times of {} are {}", label,
        !other.empty() ? other
                       : "of other sessions than before; expected two stores that were solved in turn (cli/gate.sh "
                         "with OLD), or leave out --time-margin"));
  StudyResults study = study_of_both(baseline, std::move(candidate), time_margin ? *turns : std::map<int, int>());
  Gate both = gate(std::move(study), time_margin, label);
  for (JudgedMetric& metric : both.judged.metrics) {  // of two sessions times are never comparable
    if (!is_time(metric) || time_margin) continue;
    metric.observations.doubts.clear();
    if (!other.empty()) metric.observations.doubts.push_back({.kind = DoubtKind::times_not_comparable, .what = other});
  }
  const auto budget_of = [](const numerics::StopRule& stop) {
    return fmt::format("{} iterations, {} evaluations, {:g} ms", stop.iterations, stop.evaluations, 1e3 * stop.seconds);
  };
  const std::string ours = budget_of(both.judged.study.definition.stop), theirs = budget_of(baseline.definition.stop);
  if (ours == theirs) return both;
  std::erase_if(both.judged.doubts, [](const Doubt& doubt) { return doubt.kind == DoubtKind::budgets_differ; });
  both.judged.doubts.push_back({.kind = DoubtKind::budgets_differ,
                                .who = both.judged.study.labels,
                                .what = fmt::format("budgets of a solve differ: {}; before {}", ours, theirs)});
  return both;
}

void decide(std::vector<Gate>& gates) {
  std::size_t tests = 0;
  for (const Gate& gate : gates) {
    for (const JudgedMetric& judged : gate.judged.metrics) {
      const Finding alone = compare(judged.observations, judged.plan).front();
      tests += may_decide(gate, judged) && std::holds_alternative<Tested>(alone.what) && !are_equal(alone);
    }
  }
  for (Gate& gate : gates) {
    gate.is_compared = gate.are_same;
    gate.are_times_missing = gate.do_times_decide && std::ranges::none_of(gate.judged.metrics, is_time);
    for (JudgedMetric& judged : gate.judged.metrics) {
      judged = judge(std::move(judged.observations), judged.plan, std::max<std::size_t>(tests, 1));
      const Observations& observed = judged.observations;
      Finding& finding = judged.findings.front();
      if (gate.are_same && !is_time(judged) && std::holds_alternative<Tested>(finding.what))
        finding.what = Fact(), finding.amount = Amount{amount_of_equal(finding.scale)};
      if (is_time(judged) && !gate.do_times_decide) continue;
      if (const int missing = newly_missing(judged); missing > 0) {
        gate.newly_missing = missing;
        continue;
      }
      const Verdict verdict = verdict_of(finding);
      const auto* const tested = std::get_if<Tested>(&finding.what);
      // A budget makes equal evaluations; what is new of answers was told.
      const bool is_no_news =
          are_equal(finding) && (is_of_answers(judged) || observed.measures == Measure::evaluations);
      const bool is_small = tested && tested->is_small;
      std::vector<std::string>* const said = verdict == Verdict::worse ? &(is_small ? gate.worse_by_little : gate.worse)
                                             : verdict == Verdict::better     ? is_small ? nullptr : &gate.better
                                             : !may_decide(gate, judged)      ? nullptr
                                             : verdict == Verdict::not_tested ? &gate.not_tested
                                             : verdict == Verdict::undecided && !is_no_news ? &gate.not_decided
                                                                                            : nullptr;
      if (said != nullptr) said->push_back(observed.quantity);
      gate.are_times_missing |= is_time(judged) && verdict == Verdict::not_tested;
      const bool is_of_nothing =  // 0 % solved by both
          observed.scale == Scale::share && judged.described.front().mean == 0 && judged.described.back().mean == 0;
      gate.is_compared |= !is_of_answers(judged) && !is_of_nothing && verdict != Verdict::not_tested;
    }
    gate.is_compared |= !gate.worse.empty() || !gate.better.empty() || gate.newly_missing > 0;
  }
}

int exit_code(const std::vector<Gate>& gates, bool is_strict) {
  const auto is_worse = [](const Gate& gate) { return !gate.worse.empty() || gate.newly_missing > 0; };
  if (std::ranges::any_of(gates, is_worse)) return 3;
  if (std::ranges::any_of(gates, [](const Gate& gate) { return !gate.is_compared || gate.are_times_missing; }))
    return 1;
  const auto is_open = [](const Gate& gate) { return !gate.not_decided.empty() || !gate.not_tested.empty(); };
  return is_strict && std::ranges::any_of(gates, is_open) ? 4 : 0;
}

}  // namespace ikbench::judge
