#include "analysis/judge/data/sampling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "analysis/judge/statistics/descriptives.hpp"
#include "analysis/judge/statistics/two_sample_tests.hpp"
#include "base/names.hpp"
#include "base/units.hpp"

namespace ikbench::judge {

using namespace results;

namespace {

constexpr double rounding_deg = 1e-9 / base::degree;
constexpr double least_motion_deg = 1e-3;  // a smaller motion is rounding by a solver, and moves no arm

// Returns whether the iterations of a solve are known. An external or library solver that reports no counts has 0.
bool counts_iterations(const SolveSummary& solve) {
  return solve.iterations > 0 || solve.counted_by != results::CountedBy::none;
}

double of_answer(const SolveSummary& solve, double value) {
  return results::has_no_answer(solve.status) ? unknown : value;
}

// Returns 1 if a target was reached in time, otherwise 0; NaN if the study has no deadline.
double is_in_time(const SolveSummary& solve, const StudyResults& study) {
  const double deadline = study.definition.deadline();
  const bool is_solved = study.definition.has_tolerance() ? solve.status == Status::ok : has_answer(solve);
  const bool has_no_time = is_solved && solve.timing == Timing::elsewhere && std::isnan(solve.seconds);
  return deadline == 0 || has_no_time ? unknown : double(is_solved && solve.seconds <= deadline);
}

constexpr std::array rows{
#define METRIC(column, slug, name, unit, kind, quantity_kind, floor, resolution, when_reported, ...) \
  Metric{column,                                                                                     \
         slug,                                                                                       \
         name,                                                                                       \
         unit,                                                                                       \
         MetricKind::kind,                                                                           \
         QuantityKind::quantity_kind,                                                                \
         floor,                                                                                      \
         resolution,                                                                                 \
         WhenReported::when_reported,                                                                \
         [](const SolveSummary& solve, [[maybe_unused]] const StudyResults& study) -> double { return __VA_ARGS__; }},
#include "analysis/judge/data/metrics.inc"
#undef METRIC
};

// Returns whether each value of a metric stands for a run; otherwise each value stands for a target.
bool are_runs(const StudyResults& study, const Metric& metric) {
  return metric.kind == MetricKind::per_run || study.definition.compares_runs();
}

// Returns the error up to which errors count as equal; 0 if the study has no tolerance, or the metric is no error.
double tolerance_of(const StudyResults& study, const Metric& metric) {
  const numerics::StopRule& stop = study.definition.stop;
  if (metric.kind != MetricKind::error) return 0;
  return metric.quantity_kind == QuantityKind::angle ? stop.tolerance_deg() : stop.tolerance_cm();
}

// Returns whether a metric is the cost of reaching a target within the tolerance.
bool is_cost_of_answers(const StudyResults& study, const Metric& metric) {
  return metric.kind == MetricKind::cost && study.definition.has_tolerance();
}

// Returns whether only solved targets have a value of the metric. Along a path failed solves have a cost, too, because
// the next solve starts where the failed one ended.
bool is_of_solved(const StudyResults& study, const Metric& metric) {
  return is_cost_of_answers(study, metric) && !study.definition.is_chained();
}

// A value with the number of the block to which the value belongs.
struct Value {
  int block;
  double value;
};

int block_of(const SolveSummary& solve, const StudyDefinition& definition, bool is_run) {
  if (is_run) return solve.run;
  return definition.draws_targets ? (solve.run - 1) * definition.points + solve.point : solve.point;
}

// Returns the values of all solves of a solver, in the order of their blocks.
std::vector<Value> values_of(const StudyResults& study, const Metric& metric, std::string_view solver) {
  const StudyDefinition& definition = study.definition;
  const bool of_runs = are_runs(study, metric), of_solved = is_of_solved(study, metric);
  const double least = tolerance_of(study, metric);
  // If a solver never gave an answer, the arm stayed at the start, whose error says nothing of the solver.
  const bool is_unknown = metric.kind == MetricKind::error && std::ranges::none_of(study.of(solver), has_answer);
  std::vector<Value> values;
  for (const Solves run : of_runs ? complete_runs_of(study, solver) : runs_of(study.of(solver))) {
    if (metric.kind == MetricKind::per_run) {
      values.push_back({run.front().run, metric.value(run.back(), study)});
      continue;
    }
    for (const SolveSummary& solve : run) {
      if (of_solved && solve.status != Status::ok) continue;
      const double value = is_unknown ? unknown : metric.value(solve, study);
      values.push_back(
          {block_of(solve, definition, of_runs), metric.kind == MetricKind::error && value < least ? least : value});
    }
  }
  if (!std::ranges::is_sorted(values, {}, &Value::block)) std::ranges::stable_sort(values, {}, &Value::block);
  return values;
}

// Returns the average of a block; NaN if a value or the average is not finite.
double block_average(const std::vector<double>& values, bool is_median) {
  if (!std::ranges::all_of(values, [](double value) { return std::isfinite(value); })) return unknown;
  const double average = is_median ? describe_values(values).median : summarise(values).mean;
  return std::isfinite(average) ? average : unknown;
}

// Returns the average of each block. `solves` must be in the order of the blocks.
std::vector<Value> means_of(const std::vector<Value>& solves, bool are_medians = false) {
  std::vector<Value> means;
  std::vector<double> values;
  for (std::size_t i = 0; i < solves.size();) {
    const int block = solves[i].block;
    for (values.clear(); i < solves.size() && solves[i].block == block; ++i) values.push_back(solves[i].value);
    means.push_back({block, block_average(values, are_medians)});
  }
  return means;
}

// Returns the cost of all attempts per success, as one logarithm per value. The mean of the logarithms is the logarithm
// of the ratio of the two sums, and their spread gives the error of that mean (the infinitesimal jackknife; Efron, The
// Jackknife, 1982, chapter 6). Sets the effective sample size (Kish, Survey Sampling, 1965) and the number of solved
// targets. `costs` and `solved` must have the same blocks.
std::vector<Value> cost_per_success(std::vector<Value> costs, const std::vector<Value>& solved, Sample& sample) {
  double total_cost = 0, squares = 0, total_solved = 0;
  for (const Value& cost : costs) {
    total_cost += cost.value;
    squares += cost.value * cost.value;
  }
  for (const Value& share : solved) total_solved += share.value;
  sample.effective_n = total_cost * total_cost / squares;
  sample.solved_targets = total_solved;
  const auto n = static_cast<double>(costs.size());
  for (std::size_t i = 0; i < costs.size(); ++i)
    costs[i].value =
        std::log(total_cost / total_solved) + n * (costs[i].value / total_cost - solved[i].value / total_solved);
  return costs;
}

Group group_of(const StudyResults& study, const Metric& metric, bool is_paired, const std::string& solver) {
  Group group{.name = solver};
  const double least = tolerance_of(study, metric);
  const std::vector<Value> all = values_of(study, metric, solver);
  if (std::ranges::any_of(all, [=](const Value& each) { return each.value <= least; })) group.tolerance = least;
  std::vector<Value> values = means_of(all, uses_medians(metric));
  Sample measured;
  if (metric.kind == MetricKind::ert || is_cost_of_answers(study, metric)) {
    const std::vector<Value> solved = means_of(values_of(study, metric_named("solved"), solver));
    if (!solved.empty() && std::ranges::all_of(solved, [](const Value& each) { return each.value == 0; })) {
      group.sample = ExcludedSample{.reason = ExclusionReason::nothing_solved};
      return group;
    }
    if (metric.kind == MetricKind::ert) values = cost_per_success(std::move(values), solved, measured);
  }
  const auto missing =
      static_cast<int>(std::erase_if(values, [](const Value& each) { return !std::isfinite(each.value); }));
  for (const auto& [block, value] : values) {
    measured.values.push_back(value);
    if (is_paired) measured.blocks.push_back(block);
  }
  const bool are_equal = measured.values.size() > 1 &&
                         std::ranges::count(measured.values, measured.values.front()) == std::ssize(measured.values);
  if (missing > 0)
    group.sample = ExcludedSample{
        .reason = ExclusionReason::missing_values, .missing = missing, .values = std::move(measured.values)};
  else if (!is_paired && are_equal && is_deterministic(study, solver))
    group.sample = Sample{.values = {measured.values.front()}, .is_deterministic = true};
  else
    group.sample = std::move(measured);
  return group;
}

// The values of all solves of one session.
struct SessionValues {
  std::vector<double> values = {};
  double sum = 0, solved = 0;
};

// Returns the values of a solver by session, without sessions that have an unknown value, or costs of 0, which have no
// logarithm.
std::map<int, SessionValues> values_by_session(const StudyResults& study, const Metric& metric,
                                               const std::string& solver) {
  std::map<int, SessionValues> sessions;
  for (const SolveSummary& solve : study.of(solver)) {
    SessionValues& session = sessions[solve.session];
    const bool is_solved = solve.status == Status::ok;
    session.values.push_back(is_of_solved(study, metric) && !is_solved ? unknown : metric.value(solve, study));
    session.sum += session.values.back();
    if (is_solved) ++session.solved;
  }
  std::erase_if(sessions, [&](const auto& each) {
    const bool has_logarithm = metric.kind != MetricKind::ert || each.second.sum != 0;
    return !std::isfinite(each.second.sum) || !has_logarithm;
  });
  return sessions;
}

// Returns one value per session: the share solved in time, or the logarithm of the median time. For costs per success,
// returns the values of `cost_per_success`; empty if no target was solved in these sessions.
Sample sample_of_sessions(const std::map<int, SessionValues>& sessions, MetricKind kind) {
  Sample sample;
  std::vector<Value> costs, solved;
  for (const auto& [session, each] : sessions) {
    const double share = each.sum / static_cast<double>(each.values.size());
    const double median = std::max(describe_values(each.values).median, 1e-9);
    sample.values.push_back(kind == MetricKind::success_rate ? share : std::log(median));
    sample.blocks.push_back(session);
    costs.push_back({session, each.sum});
    solved.push_back({session, each.solved});
  }
  sample.effective_n = static_cast<double>(sessions.size());        // no session decides by itself
  sample.solved_targets = std::numeric_limits<double>::infinity();  // not limited, unless by cost_per_success
  if (kind != MetricKind::ert) return sample;
  sample.values.clear();
  if (std::ranges::none_of(solved, [](const Value& each) { return each.value > 0; })) return sample;
  for (const Value& each : cost_per_success(std::move(costs), solved, sample)) sample.values.push_back(each.value);
  return sample;
}

// Returns the group of a solver with one value per session of `compared`. Reports show the average of these values. A
// solver without a session of `compared` gets an excluded group, which describes the values of all sessions.
Group group_of_times(const StudyResults& study, const Metric& metric, const std::string& solver,
                     const std::set<int>& compared) {
  const bool is_share = metric.kind == MetricKind::success_rate, is_ert = metric.kind == MetricKind::ert;
  std::map<int, SessionValues> sessions = values_by_session(study, metric, solver);
  const auto is_not_compared = [&](const auto& each) { return !compared.contains(each.first); };
  const bool is_comparable = !std::ranges::all_of(sessions, is_not_compared);
  if (is_comparable) std::erase_if(sessions, is_not_compared);
  Group group{.name = solver};
  if (is_share) {
    for (const auto& [session, each] : sessions) {
      group.pooled_n += static_cast<int>(each.values.size());
      group.pooled_share += each.sum;
    }
  }
  group.pooled_share /= std::max(1, group.pooled_n);
  Sample sample = sample_of_sessions(sessions, metric.kind);
  const bool is_any_solved = std::ranges::count(study.of(solver), Status::ok, &SolveSummary::status) > 0;
  if (is_comparable && (!is_ert || !sample.values.empty()))
    group.sample = std::move(sample);
  else if (!is_any_solved && !is_share && (is_ert || study.definition.has_tolerance()))
    group.sample = ExcludedSample{.reason = ExclusionReason::nothing_solved};
  else
    group.sample = ExcludedSample{.reason = ExclusionReason::not_comparable, .values = std::move(sample.values)};
  return group;
}

// Returns the kind of a metric's values, as far as the metric decides the kind without a study.
SampleKind sample_kind(const Metric& metric) {
  switch (metric.kind) {
    case MetricKind::success_rate:
      return Proportions{};
    case MetricKind::ert:
      return LogCosts{.is_per_success = true};
    case MetricKind::error:
    case MetricKind::cost:
    case MetricKind::per_run:
      break;
  }
  if (metric.value_of == nullptr) return Differences{};  // a number of the study's check may be negative
  return Ratios{.floor = metric.floor};
}

// Returns the samples of a metric that is made of times.
MetricSamples make_samples_by_session(const StudyResults& study, const Metric& metric) {
  MetricSamples samples = empty_samples(metric);
  samples.is_paired = true;
  if (metric.kind == MetricKind::cost) samples.kind = LogCosts{};
  samples.min_blocks = min_sessions;
  const SessionSets sessions = session_sets(study);
  const bool is_share = metric.kind == MetricKind::success_rate;
  for (std::size_t i = 0; i < study.labels.size(); ++i) {
    const std::string& label = study.labels[i];
    if (study.imported.has(label) || study.batch_timings.contains(label)) {
      samples.groups.push_back({.name = label, .sample = ExcludedSample{.reason = ExclusionReason::not_comparable}});
      continue;
    }
    // The share solved in time counts busy sessions, too. Busy sessions are no random sample, so a share without them
    // would flatter.
    samples.groups.push_back(group_of_times(study, metric, label, is_share ? sessions.comparable : sessions.quiet[i]));
  }
  return samples;
}

// Returns the warnings about the values of a metric.
std::vector<Warning> metric_warnings(const StudyResults& study, const Metric& metric) {
  if (is_time_metric(metric)) return time_warnings(study);
  if (metric.quantity_kind == QuantityKind::evaluations) return evaluation_warnings(study);
  return clock_warnings(study);
}

// Returns whether a number of a study's check has a name that means a metric.
bool is_metric_name(const Metric& known, const std::string& name) {
  const std::string lower = base::lower_case(name);
  return lower == known.column || lower == known.slug || lower == known.name || lower == "answered" ||
         std::ranges::count(results::default_tie_breakers, lower) > 0;
}

}  // namespace

std::span<const Metric> metrics() { return rows; }

double Metric::value(const SolveSummary& solve, const StudyResults& study) const {
  if (value_of != nullptr) return value_of(solve, study);
  return solve.status == Status::ok && number < solve.check_values.size() ? solve.check_values[number] : unknown;
}

std::vector<Metric> metrics_of(const StudySpec& study) {
  std::vector<Metric> all(rows.begin(), rows.end());
  for (const auto& [names, better] :
       {std::pair(&study.check.larger, Better::larger), {&study.check.smaller, Better::smaller}}) {
    for (const std::string& name : *names) {
      for (const Metric& known : all)
        if (is_metric_name(known, name))
          throw std::invalid_argument(fmt::format(
              "[check] reports a number \"{}\", which is the name of a metric; expected another name", name));
      all.push_back({name, name, name, "", MetricKind::cost, QuantityKind::other, 0, 0, WhenReported::always, nullptr,
                     all.size() - rows.size(), better});
    }
  }
  return all;
}

const Metric& metric_named(std::string_view column, std::span<const Metric> all) {
  return base::find_named("metric", column, all, [](const Metric& metric) { return metric.column; });
}

MetricSamples empty_samples(const Metric& metric) {
  return {.metric = std::string(metric.slug),
          .quantity = std::string(metric.name),
          .unit = std::string(metric.unit),
          .quantity_kind = metric.quantity_kind,
          .better = metric.better,
          .kind = sample_kind(metric),
          .resolution = metric.resolution};
}

MetricSamples make_samples(const StudyResults& study, const Metric& metric) {
  MetricSamples samples =
      is_time_metric(metric) ? make_samples_by_session(study, metric) : make_samples_by_target(study, metric);
  samples.is_random = !study.definition.is_grid();
  samples.warnings = metric_warnings(study, metric);
  Warning unsolved{.kind = WarningKind::times_not_comparable,
                   .detail = "too few targets were solved in the compared sessions"};
  for (Group& group : samples.groups) {  // a group with a warning is described, but not compared
    const bool has_warning = std::ranges::any_of(samples.warnings, [&](const Warning& warning) {
      return warning.solvers.empty() || std::ranges::count(warning.solvers, group.name) > 0;
    });
    const ExcludedSample* const sample = excluded(group);
    if (sample != nullptr && sample->reason == ExclusionReason::not_comparable && !has_warning &&
        metric.kind != MetricKind::success_rate)
      unsolved.solvers.push_back(group.name);
    if (sample != nullptr || !has_warning) continue;  // missing values are the stronger reason to exclude
    const std::span<const double> values = judge::values_of(group);
    group.sample = ExcludedSample{.reason = ExclusionReason::not_comparable, .values = {values.begin(), values.end()}};
  }
  if (!unsolved.solvers.empty()) samples.warnings.push_back(std::move(unsolved));
  return samples;
}

MetricSamples make_samples_by_target(const StudyResults& study, const Metric& metric) {
  const StudyDefinition& definition = study.definition;
  const bool of_runs = are_runs(study, metric);
  MetricSamples samples = empty_samples(metric);
  samples.is_paired = definition.draws_targets || !of_runs;
  if (auto* const ratios = std::get_if<Ratios>(&samples.kind))
    ratios->is_conditional_on_success = is_of_solved(study, metric);
  if (auto* const differences = std::get_if<Differences>(&samples.kind))
    differences->is_conditional_on_success = is_of_solved(study, metric);
  if (auto* const proportions = std::get_if<Proportions>(&samples.kind)) {
    if (of_runs)
      proportions->trials_per_value = definition.points;
    else if (!definition.draws_targets)
      proportions->trials_per_value = definition.runs;
  }
  for (const std::string& solver : study.labels)
    samples.groups.push_back(group_of(study, metric, samples.is_paired, solver));
  return samples;
}

}  // namespace ikbench::judge
