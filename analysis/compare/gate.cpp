#include "analysis/compare/gate.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <stdexcept>
#include <utility>

#include "numerics/names.hpp"

namespace ikbench::compare {
namespace {

using namespace results;

void refuse_other_task(const StudyResults& one, const StudyResults& other) {
  const Definition &a = one.definition, &b = other.definition;
  const std::string before = one.solvers == other.solvers ? "before" : one.solvers.front();
  const std::pair<bool, const char*> differences[]{
      {a.robot != b.robot || a.arm != b.arm, "arms"},
      {a.path != b.path || a.points != b.points, "targets"},
      {a.seed != b.seed, "seeds"},
      {a.search != b.search, "searches"},
      {a.start != b.start, "starts"},
      {a.task != b.task || a.near != b.near || a.rotation_weight != b.rotation_weight,
       "paths, starts or weights of a rotation"},
      {a.limits != b.limits, "treatments of joint limits"},
      {a.stop.tolerance != b.stop.tolerance || a.stop.angle_tolerance != b.stop.angle_tolerance, "tolerances"}};
  for (const auto& [differ, what] : differences) {
    if (differ)
      throw std::invalid_argument(
          fmt::format("not compared: {} has other {} than {}", other.solvers.front(), what, before));
  }
  const auto place = [](const Solve& solve) { return std::pair(solve.run, solve.point); };
  if (one.solves.empty() || !std::ranges::equal(one.solves, other.solves, {}, place, place))
    throw std::invalid_argument(
        fmt::format("not compared: {} has {} solves, {} {}; complete both with ikbench run, with as many runs",
                    other.solvers.front(), other.solves.size(), before, one.solves.size()));
}

// Of both sides, as solvers of one study. Takes their solves.
StudyResults study_of_both(StudyResults& baseline, StudyResults both) {
  if (baseline.solvers == both.solvers)
    both.solvers = {baseline.solvers.front() + " now", baseline.solvers.front() + " before"};
  else
    both.solvers.push_back(baseline.solvers.front());
  both.entry.series = {{.label = both.solvers.front()}, {.label = both.solvers.back()}};
  both.drawn = {};
  std::map<std::int64_t, int> numbers;  // of two stores sessions have the same, of one store they are the same
  for (const Session& session : baseline.sessions) {
    const auto known = std::ranges::find_if(both.sessions, [&](const Session& each) {
      return each.began == session.began && each.environment == session.environment;
    });
    const auto next = both.sessions.empty() ? 1 : both.sessions.back().id + 1;
    numbers[session.id] = static_cast<int>(known == both.sessions.end() ? next : known->id);
    if (known != both.sessions.end()) continue;
    both.sessions.push_back(session);
    both.sessions.back().id = next;
  }
  both.solves.reserve(2 * both.solves.size());
  for (Solve solve : std::exchange(baseline.solves, {})) {
    solve.solver = 1;
    solve.session = numbers[solve.session];
    both.solves.push_back(solve);
  }
  refuse_other_targets(both);
  both.definition.plan = baseline.definition.plan;     // a candidate sets no margin of its own
  both.definition.plan.control = both.solvers.back();  // shown second
  return both;
}

// Limits of a solve that the two had, one doubt each.
std::vector<Doubt> doubts_of_limits(const StudyResults& baseline, const StudyResults& both) {
  const numerics::StopRule &a = both.definition.stop, &b = baseline.definition.stop;
  std::vector<Doubt> doubts;
  const auto add = [&](const char* unit, auto ours, auto theirs) {
    if (ours == theirs) return;
    doubts.push_back({.kind = DoubtKind::budgets_differ,
                      .who = both.solvers,
                      .what = fmt::format("budgets differ: {} and {} {} a solve", ours, theirs, unit)});
  };
  add("iterations", a.iterations, b.iterations);
  add("evaluations", a.evaluations, b.evaluations);
  add("s", a.seconds, b.seconds);
  return doubts;
}

// Of solves, whatever they are of. Where the machine decides who is too late, that is not counted.
Judged judged_answers(const StudyResults& study, bool machine_decides) {
  Observations observed{.metric = "answers", .quantity = "answered", .better = Better::larger, .scale = Scale::share};
  for (const std::string& solver : study.solvers) {
    Group& group = observed.groups.emplace_back(Group{.name = solver});
    for (const Solve& solve : study.of(solver))
      group.values.push_back(gave_answer(solve) || (machine_decides && solve.status == results::Status::over_budget));
  }
  return judge(std::move(observed), study.definition.plan);
}

bool is_time(const Judged& judged) { return judged.observations.metric == metric_named("seconds").slug; }

// Equal values cannot be worse by chance, and times decide nothing.
bool takes_significance(const Judged& judged) {
  const Finding& finding = judged.findings.front();
  return finding.why == Why::tested && !finding.are_all_equal && !is_time(judged);
}

// Without chance any loss that matters is a loss: of solvers that repeat themselves, and of answers where none was
// missing or none is left.
bool is_lost_for_sure(const Judged& judged) {
  const Observations& observed = judged.observations;
  const Description &candidate = judged.described.front(), &baseline = judged.described.back();
  if (observed.metric == "answers")
    return candidate.mean < baseline.mean && (baseline.mean == 1 || candidate.mean == 0);
  if (judged.findings.front().why != Why::fact) return false;
  const double loss = (candidate.mean - baseline.mean) * (observed.better == Better::smaller ? 1 : -1);
  const double share = observed.scale == Scale::share ? 1 : std::min(std::abs(candidate.mean), std::abs(baseline.mean));
  return loss > std::max(observed.absolute_margin, judged.plan.margin * share) + observed.rounding;
}

// A metric of which all values vanished, though there are answers.
void refuse_vanished(const JudgedStudy& judged, const std::string& label) {
  if (judged.metrics.back().described.front().mean == 0) return;
  for (const Judged& metric : judged.metrics) {
    const std::vector<Group>& groups = metric.observations.groups;
    if (groups.front().lost > 0 && groups.front().values.empty() && !groups.back().values.empty())
      throw std::invalid_argument(
          fmt::format("not compared: {} lacks all {}, which it had before; if that is meant, make a new baseline",
                      label, metric.observations.quantity));
  }
}

}  // namespace

Gate gate(StudyResults baseline, StudyResults candidate) {
  refuse_other_task(baseline, candidate);
  Gate gate;
  if (baseline.solvers == candidate.solvers) gate.label = baseline.solvers.front();
  StudyResults study = study_of_both(baseline, std::move(candidate));
  gate.are_same = have_same_solves(study.of(study.solvers.front()), study.of(study.solvers.back()));
  JudgedStudy& judged = gate.judged = judge(std::move(study));
  const std::vector<Doubt>& doubts = judged.metrics[judged.deciding].observations.doubts;
  const bool machine_decides = std::ranges::count(doubts, DoubtKind::seconds_decide, &Doubt::kind) > 0;
  judged.metrics.push_back(judged_answers(judged.study, machine_decides));
  if (!gate.label.empty()) refuse_vanished(judged, gate.label);
  std::ranges::move(doubts_of_limits(baseline, judged.study), std::back_inserter(judged.doubts));
  judged.study.solves = {};  // judged, and large
  return gate;
}

void decide(std::vector<Gate>& gates) {
  std::ptrdiff_t shares = 0;
  for (const Gate& gate : gates)
    shares += gate.are_same ? 0 : std::ranges::count_if(gate.judged.metrics, takes_significance);
  for (Gate& gate : gates) {
    JudgedStudy& study = gate.judged;
    Plan plan = study.study.definition.plan;
    const double whole = plan.significance, tests = static_cast<double>(std::max(shares, std::ptrdiff_t{1}));
    plan.significance /= tests;
    for (Judged& judged : study.metrics) {
      if (tests > 1) judged = judge(std::move(judged.observations), plan);
      const Observations& observed = judged.observations;
      Finding& finding = judged.findings.front();
      if (is_lost_for_sure(judged)) {
        finding.verdict = Verdict::worse;
        finding.why = Why::fact;
        finding.is_within_margin = false;
        finding.p.reset();
        finding.interval.reset();
      }
      if (finding.p) *finding.p = std::min(1.0, *finding.p * tests);  // as of the pairs of a report
      judged.plan.significance = whole;
      const bool is_equal =
          gate.are_same || (finding.are_all_equal &&
                            (observed.is_paired || observed.scale != Scale::share || observed.metric == "answers"));
      const bool is_open = !is_equal && finding.why != Why::fact;
      const bool is_other = is_difference(finding.verdict) && !finding.is_within_margin;
      if (is_time(judged)) continue;
      if (is_other) (finding.verdict == Verdict::worse ? gate.worse : gate.better).push_back(observed.quantity);
      if (finding.verdict == Verdict::undecided && is_open) gate.not_decided.push_back(observed.quantity);
      if (finding.verdict == Verdict::not_tested && is_open) gate.not_tested.push_back(observed.quantity);
    }
    const Judged& deciding = study.metrics[study.deciding];
    const auto size = [&](std::size_t i) {
      return std::max(deciding.described[i].n, deciding.observations.groups[i].copies);
    };
    gate.size = deciding.observations.is_paired ? deciding.findings.front().n : std::min(size(0), size(1));
    for (Judged& judged : study.metrics) {
      for (Group& group : judged.observations.groups) group.values = {};
    }
  }
}

int exit_code(const std::vector<Gate>& gates, bool is_strict) {
  if (std::ranges::any_of(gates, [](const Gate& gate) { return !gate.worse.empty(); })) return 3;
  const auto is_open = [](const Gate& gate) { return !gate.not_decided.empty() || !gate.not_tested.empty(); };
  return is_strict && std::ranges::any_of(gates, is_open) ? 4 : 0;
}

}  // namespace ikbench::compare
