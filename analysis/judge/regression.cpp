#include "analysis/judge/regression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include "base/names.hpp"

namespace ikbench::judge {
namespace {

using namespace results;

constexpr const char *candidate_label = "candidate", *baseline_label = "baseline";

// Throws std::invalid_argument, which names the first difference, if the candidate solved another task.
void refuse_other_task(const StudyResults& baseline, const StudyResults& candidate) {
  const StudyDefinition &a = baseline.definition, &b = candidate.definition;
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
      throw std::invalid_argument(
          fmt::format("not compared: {} has other {} than before", candidate.labels.front(), what));
}

// Maps each session of the baseline to the candidate's session of the same round, which is a shard. The map is empty if
// the stores were not solved in turn: each round of both must begin before the next round of either, in whole seconds.
std::optional<std::map<int, int>> matching_sessions(const std::vector<Session>& ours,
                                                    const std::vector<Session>& theirs) {
  if (ours.size() < 2 || ours.size() != theirs.size()) return {};
  const auto shard_of = [](const Session& session) {
    const auto shard = session.environment.find("shard");
    return shard == session.environment.end() ? "" : shard->second;
  };
  std::map<int, int> rounds;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const bool is_early =
        i > 0 && std::min(ours[i].began, theirs[i].began) < std::max(ours[i - 1].began, theirs[i - 1].began);
    if (is_early || shard_of(ours[i]).empty() || shard_of(ours[i]) != shard_of(theirs[i])) return {};
    rounds[static_cast<int>(theirs[i].id)] = static_cast<int>(ours[i].id);
  }
  return rounds;
}

// Returns both versions as solvers of one study, and takes their solves. Sessions of one round become one session. If
// `rounds` is empty, no two sessions become one.
StudyResults study_of_both(StudyResults& baseline, StudyResults both, const std::map<int, int>& rounds) {
  both.labels = {candidate_label, baseline_label};
  both.rejections = {};
  const auto before = both.sessions.empty() ? 0 : static_cast<int>(both.sessions.back().id);
  for (Session& session : std::exchange(baseline.sessions, {})) {
    if (!rounds.empty()) continue;
    session.id += before;
    both.sessions.push_back(std::move(session));
  }
  both.solves.reserve(2 * both.solves.size());
  for (SolveSummary solve : std::exchange(baseline.solves, {})) {
    solve.label = 1;
    solve.session = rounds.empty() ? solve.session + before : rounds.at(solve.session);
    both.solves.push_back(solve);
  }
  require_same_targets(both);
  both.definition.plan = baseline.definition.plan;  // a candidate sets no margin of its own
  return both;
}

// Returns the shares of solves that gave any answer. If the load of the machine decides which solves are too late, late
// solves count as answered.
MetricSamples answered_samples(const StudyResults& study, bool machine_decides) {
  MetricSamples samples{
      .metric = "answers", .quantity = "answered", .better = Better::larger, .kind = Proportions{}, .is_paired = true};
  samples.quantity_kind = QuantityKind::answered;
  for (const std::string& solver : study.labels) {
    Sample answers;
    for (const SolveSummary& solve : study.of(solver))
      answers.values.push_back(has_answer(solve) || (machine_decides && solve.status == results::Status::over_budget));
    samples.groups.push_back({.name = solver, .sample = std::move(answers)});
  }
  return samples;
}

// Returns whether a metric is made of times; "solved in time" is made of times, too.
bool is_time(const JudgedMetric& judged) { return judged.samples.quantity_kind == QuantityKind::time; }

bool is_of_answers(const JudgedMetric& judged) { return judged.samples.quantity_kind == QuantityKind::answered; }

// Returns whether a metric decides: the plan names the metric, --metric does not leave the metric out, and a metric of
// times has a margin.
bool decides(const RegressionCheck& check, const JudgedMetric& metric) {
  const std::string name = name_in_plan(check.judged, metric);
  if (name.empty() || (is_time(metric) && !check.counts_times())) return false;
  return check.options.metrics.empty() || std::ranges::count(check.options.metrics, name) > 0;
}

// Throws std::invalid_argument if the options ask for metrics or margins that the plan does not have.
void refuse_what_the_plan_lacks(const RegressionOptions& options, const StudyDefinition& definition) {
  const std::vector<std::string> named = names_in_plan(definition);
  const std::vector<std::string>& asked = options.metrics.empty() ? named : options.metrics;
  for (const std::string& name : asked)
    if (std::ranges::count(named, name) == 0)
      throw std::invalid_argument(fmt::format(
          "--metric {}: the study's plan names {}; expected some of these, or name it in `metric` or `tie_breakers` of [analysis]",
          name, base::listed(named)));
  const std::vector<Metric> metrics = metrics_of(definition);
  const auto is_of_time = [&](const std::string& name) {
    const auto metric = std::ranges::find(metrics, name, &Metric::column);
    return name == "time" || (metric != metrics.end() && is_time_metric(*metric));
  };
  const bool has_time = std::ranges::any_of(asked, is_of_time);
  if (options.time_margin && !has_time && options.metrics.empty())
    throw std::invalid_argument(
        "--time-margin: the study's plan does not name time; add it to `tie_breakers` of [analysis]");
  if (options.time_margin && !has_time)
    throw std::invalid_argument("--time-margin lets times decide, but --metric leaves them out; add time to --metric");
  if (!options.time_margin && !options.metrics.empty() && has_time)
    throw std::invalid_argument("--metric time: times decide by a margin of their own; add --time-margin 10%");
}

// Returns how many answers are missing, if the baseline gave all answers or the candidate gives none; otherwise 0. No
// test is made, so chance may have caused the missing answers.
int count_new_failures(const JudgedMetric& judged) {
  const Descriptives &candidate = judged.descriptives.front(), &baseline = judged.descriptives.back();
  const bool is_new = is_of_answers(judged) && (baseline.mean == 1 || candidate.mean == 0);
  return is_new ? static_cast<int>(std::lround((baseline.mean - candidate.mean) * baseline.n)) : 0;
}

// Returns the study with only two labels, and without the records for figures.
StudyResults study_of_two(const StudyResults& study, const std::string& candidate, const std::string& baseline) {
  StudyResults two;
  static_cast<StoredStudy&>(two) = study;
  two.sessions = study.sessions;
  two.labels = {candidate, baseline};
  for (std::size_t i = 0; i < two.labels.size(); ++i) {
    const std::string& label = two.labels[i];
    for (SolveSummary solve : study.of(label)) {
      solve.label = static_cast<int>(i);
      two.solves.push_back(std::move(solve));
    }
    if (const auto found = study.rejections.find(label); found != study.rejections.end()) two.rejections.insert(*found);
    if (const auto found = study.batch_timings.find(label); found != study.batch_timings.end())
      two.batch_timings.insert(*found);
    if (std::ranges::count(study.stale_solves.solvers, label) > 0) two.stale_solves = study.stale_solves;
  }
  return two;
}

// Keeps the warnings that concern the two labels. A warning that also names other labels gets the counts of only these
// two.
void keep_warnings(std::vector<Warning>& warnings, const StudyResults& two) {
  const auto is_other = [&](const std::string& name) { return std::ranges::count(two.labels, name) == 0; };
  const std::vector<Warning> own = evaluation_warnings(two);
  std::erase_if(warnings, [&](const Warning& warning) {
    return !warning.solvers.empty() && std::ranges::all_of(warning.solvers, is_other);
  });
  for (Warning& warning : warnings) {
    std::erase_if(warning.solvers, is_other);
    const auto found = std::ranges::find(own, warning.kind, &Warning::kind);
    if (found == own.end()) continue;
    warning.count = found->count;
    warning.total = found->total;
  }
}

// Keeps the groups and the comparison of the two labels of a check, the candidate first.
void keep_two(const RegressionCheck& check, MetricSamples& samples, std::vector<Comparison>& comparisons) {
  const auto is_meant = [&](const std::string& name) { return name == check.candidate || name == check.baseline; };
  std::erase_if(samples.groups, [&](const Group& group) { return !is_meant(group.name); });
  if (samples.groups.front().name != check.candidate) std::swap(samples.groups.front(), samples.groups.back());
  std::erase_if(comparisons, [&](const Comparison& comparison) {
    return !is_meant(comparison.first) || !is_meant(comparison.second);
  });
  Comparison& comparison = comparisons.front();
  comparison = better_first(std::move(comparison), check.baseline);
  comparison.first_index = 0;
  comparison.second_index = 1;
}

// Returns the name of the family that the pairs of a metric belong to.
std::string family_of(const RegressionCheck& check, const JudgedMetric& metric) {
  const std::string name = name_in_plan(check.judged, metric);
  return name.empty() ? "not in the plan: " + metric.samples.metric : name;
}

// Returns the comparisons of each metric of each check. All pairs of the metrics that a name of the plan stands for are
// one family. If one label solved all targets and another did not, evaluations and evaluations per success are one
// family. Solvers that are identical in two stores belong only to the family of times, since no chance is in their
// answers.
std::vector<std::vector<std::vector<Comparison>>> all_comparisons(const std::vector<RegressionCheck>& checks) {
  const std::size_t metrics = names_in_plan(checks.front().judged.study.definition).size();
  std::vector<std::vector<std::vector<Comparison>>> all;
  std::map<std::string, std::vector<std::pair<std::size_t, std::size_t>>>
      families;  // places of checks and metrics, by name
  for (std::size_t i = 0; i < checks.size(); ++i) {
    const std::vector<JudgedMetric>& judged = checks[i].judged.metrics;
    all.emplace_back(judged.size());
    for (std::size_t m = 0; m < judged.size(); ++m) {
      if (checks[i].is_identical && !checks[i].label.empty() && !is_time(judged[m]))
        all[i][m] = compare_pairs(judged[m].samples, judged[m].plan, metrics);
      else
        families[family_of(checks[i], judged[m])].emplace_back(i, m);
    }
  }
  for (const auto& [metric, places] : families) {
    std::vector<FamilyMember> members;
    for (const auto& [i, m] : places)
      members.push_back({&checks[i].judged.metrics[m].samples, &checks[i].judged.metrics[m].plan});
    std::vector<std::vector<Comparison>> found = compare_pairs(members, metrics);
    for (std::size_t k = 0; k < places.size(); ++k) all[places[k].first][places[k].second] = std::move(found[k]);
  }
  return all;
}

bool is_below_margin(const Comparison& comparison) {
  const auto* const tested = std::get_if<TestResult>(&comparison.result);
  return tested != nullptr && tested->is_below_margin;
}

// Returns the outcome of a metric that decides; empty if nothing is to be reported.
std::optional<RegressionOutcome> deciding_outcome(const RegressionCheck& check, const JudgedMetric& judged) {
  const Comparison& comparison = judged.comparisons.front();
  const bool is_settled = check.is_identical && !is_time(judged);
  switch (verdict_of(comparison)) {
    case Verdict::worse:
      return is_below_margin(comparison) ? RegressionOutcome::worse_below_margin : RegressionOutcome::worse;
    case Verdict::better:
      if (is_below_margin(comparison)) return {};
      return RegressionOutcome::better;
    case Verdict::not_tested:
      if (is_settled) return {};
      return RegressionOutcome::not_tested;
    case Verdict::inconclusive: {
      // If a budget makes all evaluations equal, the comparison says nothing.
      const bool is_no_news = all_values_equal(comparison) && judged.samples.quantity_kind == QuantityKind::evaluations;
      if (is_settled || is_no_news) return {};
      return RegressionOutcome::inconclusive;
    }
    case Verdict::equivalent:
      break;
  }
  return {};
}

// Returns the outcome of a metric that does not decide; empty if nothing is to be reported.
std::optional<RegressionOutcome> other_outcome(const JudgedMetric& judged) {
  const Comparison& comparison = judged.comparisons.front();
  const Verdict verdict = verdict_of(comparison);
  if (is_time(judged) || !is_difference(verdict) || is_below_margin(comparison)) return {};
  return verdict == Verdict::worse ? RegressionOutcome::worse : RegressionOutcome::better;
}

// Adds the outcome of a metric to the check.
void add_outcome(RegressionCheck& check, const JudgedMetric& judged) {
  if (const int missing = count_new_failures(judged); missing > 0) {
    check.new_failures = missing;
    return;
  }
  const bool is_deciding = decides(check, judged);
  const auto outcome = is_deciding ? deciding_outcome(check, judged) : other_outcome(judged);
  if (outcome) check.outcomes.push_back({judged.samples.metric, judged.samples.quantity, *outcome, is_deciding});
  if (!is_deciding) return;
  const bool is_tested = verdict_of(judged.comparisons.front()) != Verdict::not_tested;
  const bool is_share_of_nothing =
      is_proportion(judged.samples) && judged.descriptives.front().mean == 0 && judged.descriptives.back().mean == 0;
  if (is_time(judged) && !is_tested) check.are_times_missing = true;
  if (is_tested && !is_share_of_nothing) check.is_compared = true;
}

}  // namespace

RegressionCheck check_regression(StudyResults study, const std::string& candidate, const std::string& baseline,
                                 RegressionOptions options, const std::string& label) {
  refuse_what_the_plan_lacks(options, study.definition);
  const Solves ours = study.of(candidate), theirs = study.of(baseline);
  const auto place = [](const SolveSummary& solve) { return std::pair(solve.run, solve.point); };
  if (theirs.empty() || !std::ranges::equal(ours, theirs, {}, place, place))
    throw LacksSolves(fmt::format(
        "not compared: {} has {} solves, {} {}; complete both with ikbench run and the same number of runs",
        label.empty() ? candidate : label, ours.size(), label.empty() ? baseline : "before", theirs.size()));
  RegressionCheck check{.label = label, .candidate = candidate, .baseline = baseline, .options = std::move(options)};
  check.is_identical = are_identical(ours, theirs) && std::ranges::any_of(ours, has_answer);
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const bool is_solved = ours[i].status == Status::ok, was_solved = theirs[i].status == Status::ok;
    check.identical_solves += are_identical(ours.subspan(i, 1), theirs.subspan(i, 1));
    if (is_solved == was_solved || !study.definition.has_tolerance()) continue;
    (is_solved ? check.newly_solved : check.newly_unsolved)
        .push_back(study.definition.points == 1 ? fmt::format("run {}", ours[i].run)
                                                : fmt::format("target {} of run {}", ours[i].point, ours[i].run));
  }
  std::string& control = study.definition.plan.control;
  if (control != candidate && control != baseline) control.clear();
  check.judged = make_all_samples(std::move(study));
  JudgedStudy& judged = check.judged;
  StudyResults two = study_of_two(judged.study, candidate, baseline);
  const bool machine_decides = !clock_warnings(two).empty();
  judged.metrics.push_back(
      {.samples = answered_samples(judged.study, machine_decides), .plan = judged.study.definition.plan});
  for (JudgedMetric& metric : judged.metrics) {
    if (is_time(metric) && check.counts_times()) metric.plan.margin = *check.options.time_margin;
    keep_warnings(metric.samples.warnings, two);
  }
  judged.warnings = study_warnings(two);
  two.solves = {};  // no longer needed, and large
  judged.study = std::move(two);
  return check;
}

RegressionCheck check_regression(StudyResults baseline, StudyResults candidate, RegressionOptions options) {
  refuse_other_task(baseline, candidate);
  const std::string label = candidate.labels.front();
  const auto rounds = matching_sessions(candidate.sessions, baseline.sessions);
  const std::string now = timed_calls_text(candidate), before = timed_calls_text(baseline);
  // Why no time can be compared; empty: nothing is in the way.
  const std::string obstacle = now == before ? "" : fmt::format("{} now, {} before", now, before);
  if (options.time_margin && !(rounds && obstacle.empty()))
    throw std::invalid_argument(fmt::format(
        "not compared: times of {} are {}", label,
        !obstacle.empty() ? obstacle
                          : "of other sessions than before; expected two stores that were solved in alternating rounds "
                            "(cli/gate.sh with OLD), or leave out --time-margin"));
  StudyResults study =
      study_of_both(baseline, std::move(candidate), options.time_margin ? *rounds : std::map<int, int>());
  RegressionCheck both = check_regression(std::move(study), candidate_label, baseline_label, std::move(options), label);
  for (JudgedMetric& metric : both.judged.metrics) {  // times of different sessions are never comparable
    if (!is_time(metric) || both.counts_times()) continue;
    metric.samples.warnings.clear();  // no time decides here, so only the obstacle is shown
    if (!obstacle.empty())
      metric.samples.warnings.push_back({.kind = WarningKind::times_not_comparable, .detail = obstacle});
  }
  const auto budget_of = [](const numerics::StopRule& stop) {
    std::vector<std::string> limits;
    if (stop.iterations > 0) limits.push_back(base::counted(stop.iterations, "iterations"));
    if (stop.evaluations > 0) limits.push_back(base::counted(stop.evaluations, "evaluations"));
    if (stop.seconds > 0) limits.push_back(fmt::format("{:g} ms", 1e3 * stop.seconds));
    return base::listed(limits, " or ");
  };
  const std::string ours = budget_of(both.judged.study.definition.stop), theirs = budget_of(baseline.definition.stop);
  if (ours == theirs) return both;
  std::erase_if(both.judged.warnings,
                [](const Warning& warning) { return warning.kind == WarningKind::budgets_differ; });
  both.judged.warnings.push_back(
      {.kind = WarningKind::budgets_differ,
       .solvers = both.judged.study.labels,
       .detail = fmt::format("budgets per solve differ: the candidate has {}, the baseline {}", ours, theirs)});
  return both;
}

void judge_all(std::vector<RegressionCheck>& checks) {
  std::vector<std::vector<std::vector<Comparison>>> all = all_comparisons(checks);
  for (std::size_t i = 0; i < checks.size(); ++i) {
    RegressionCheck& check = checks[i];
    check.is_compared = check.is_identical;
    check.are_times_missing = check.counts_times() && std::ranges::none_of(check.judged.metrics, is_time);
    for (std::size_t m = 0; m < check.judged.metrics.size(); ++m) {
      JudgedMetric& metric = check.judged.metrics[m];
      std::vector<Comparison>& comparisons = all[i][m];
      keep_two(check, metric.samples, comparisons);
      metric.plan.control = check.baseline;  // the control is shown second
      metric = judge(std::move(metric.samples), metric.plan, std::move(comparisons));
      Comparison& comparison = metric.comparisons.front();
      // Two labels of one store keep the comparison of the store's report.
      if (check.is_identical && !check.label.empty() && !is_time(metric) &&
          std::holds_alternative<TestResult>(comparison.result)) {
        comparison.result = DeterministicResult();
        comparison.estimate = EffectEstimate{null_value(comparison.scale)};
      }
    }
    for (const JudgedMetric& metric : check.judged.metrics) add_outcome(check, metric);
    if (check.new_failures > 0) check.is_compared = true;
  }
}

bool RegressionCheck::has(RegressionOutcome outcome) const { return !quantities(outcome).empty(); }

std::vector<std::string> RegressionCheck::quantities(RegressionOutcome outcome, bool is_deciding) const {
  std::vector<std::string> names;
  for (const MetricOutcome& each : outcomes)
    if (each.outcome == outcome && each.is_deciding == is_deciding) names.push_back(each.quantity);
  return names;
}

int exit_code(const std::vector<RegressionCheck>& checks, bool is_strict) {
  using enum RegressionOutcome;
  const auto is_worse = [](const RegressionCheck& check) { return check.has(worse) || check.new_failures > 0; };
  const auto is_missing = [](const RegressionCheck& check) { return !check.is_compared || check.are_times_missing; };
  const auto is_open = [](const RegressionCheck& check) { return check.has(inconclusive) || check.has(not_tested); };
  if (std::ranges::any_of(checks, is_worse)) return 3;
  if (std::ranges::any_of(checks, is_missing)) return 1;
  return is_strict && std::ranges::any_of(checks, is_open) ? 4 : 0;
}

}  // namespace ikbench::judge
