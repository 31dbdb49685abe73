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
constexpr double least_motion_deg = 1e-3;  // less is how a solver rounds, and moves no arm

// A program or library that tells none has 0.
bool counts_iterations(const SolveSummary& solve) {
  return solve.iterations > 0 || solve.counted_by != results::CountedBy::none;
}

double of_answer(const SolveSummary& solve, double value) {
  return results::has_no_answer(solve.status) ? unknown : value;
}

// Unknown without a deadline.
double is_in_time(const SolveSummary& solve, const StudyResults& study) {
  const double deadline = study.definition.deadline();
  const bool is_solved = study.definition.has_tolerance() ? solve.status == Status::ok : has_answer(solve);
  return deadline == 0 ? unknown : double(is_solved && solve.seconds <= deadline);
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

// An observation is a run, else a target.
bool are_runs(const StudyResults& study, const Metric& metric) {
  return metric.kind == MetricKind::per_run || study.definition.compares_runs();
}

// Below it errors are equal; 0 where the study has none.
double tolerance_of(const StudyResults& study, const Metric& metric) {
  const numerics::StopRule& stop = study.definition.stop;
  if (metric.kind != MetricKind::error) return 0;
  return metric.quantity_kind == QuantityKind::angle ? stop.tolerance_deg() : stop.tolerance_cm();
}

bool is_of_answers(const StudyResults& study, const Metric& metric) {
  return metric.kind == MetricKind::cost && study.definition.has_tolerance();
}

// What failed has no cost of an answer; along a path it has, for the next solve starts from there.
bool is_of_solved(const StudyResults& study, const Metric& metric) {
  return is_of_answers(study, metric) && !study.definition.is_chained();
}

struct Value {
  int block;
  double value;
};

// Of the solves, by block; an observation is made of those of one.
std::vector<Value> values_of(const StudyResults& study, const Metric& metric, std::string_view solver) {
  const StudyDefinition& definition = study.definition;
  const bool of_runs = are_runs(study, metric), of_solved = is_of_solved(study, metric);
  const double least = tolerance_of(study, metric);
  // Where the arm stayed is no error of a solver that never moved it.
  const bool is_unknown = metric.kind == MetricKind::error && std::ranges::none_of(study.of(solver), has_answer);
  std::vector<Value> values;
  for (const Solves run : of_runs ? complete_runs_of(study, solver) : runs_of(study.of(solver))) {
    if (metric.kind == MetricKind::per_run) {
      values.push_back({run.front().run, metric.value(run.back(), study)});
      continue;
    }
    for (const SolveSummary& solve : run) {
      if (of_solved && solve.status != Status::ok) continue;
      const int block = of_runs                    ? solve.run
                        : definition.draws_targets ? (solve.run - 1) * definition.points + solve.point
                                                   : solve.point;
      const double value = is_unknown ? unknown : metric.value(solve, study);
      values.push_back({block, metric.kind == MetricKind::error && value < least ? least : value});
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
    const double value = !is_known ? unknown : are_medians ? describe_values(values).median : summarise(values).mean;
    means.push_back({block, std::isfinite(value) ? value : unknown});
  }
  return means;
}

// What attempts spent by what they solved: of each observation a logarithm, so that their mean is that of the ratio of
// the two sums, and their spread its error (the infinitesimal jackknife; Efron, The Jackknife, 1982, chapter 6). Tells
// what they are worth (Kish, Survey Sampling, 1965), and the number solved.
std::vector<Value> spent_by_solved(std::vector<Value> spent, const std::vector<Value>& solved, Sample& measured) {
  double all_spent = 0, squares = 0, all_solved = 0;
  for (const Value& each : spent) all_spent += each.value, squares += each.value * each.value;
  for (const Value& each : solved) all_solved += each.value;
  measured.effective_n = all_spent * all_spent / squares, measured.solved_targets = all_solved;
  const auto n = static_cast<double>(spent.size());
  for (std::size_t i = 0; i < spent.size(); ++i)
    spent[i].value = std::log(all_spent / all_solved) + n * (spent[i].value / all_spent - solved[i].value / all_solved);
  return spent;
}

Group group_of(const StudyResults& study, const Metric& metric, bool is_paired, const std::string& solver) {
  Group group{.name = solver};
  const double least = tolerance_of(study, metric);
  const std::vector<Value> all = values_of(study, metric, solver);
  if (std::ranges::any_of(all, [=](const Value& each) { return each.value <= least; })) group.tolerance = least;
  std::vector<Value> values = means_of(all, uses_medians(metric));
  Sample measured;
  if (metric.kind == MetricKind::ert || is_of_answers(study, metric)) {
    const std::vector<Value> solved = means_of(values_of(study, metric_named("solved"), solver));
    if (!solved.empty() && std::ranges::all_of(solved, [](const Value& each) { return each.value == 0; })) {
      group.sample = ExcludedSample{.reason = ExclusionReason::nothing_solved};
      return group;
    }
    if (metric.kind == MetricKind::ert) values = spent_by_solved(std::move(values), solved, measured);
  }
  const auto lost =
      static_cast<int>(std::erase_if(values, [](const Value& each) { return !std::isfinite(each.value); }));
  for (const auto& [block, value] : values) {
    measured.values.push_back(value);
    if (is_paired) measured.blocks.push_back(block);
  }
  const bool are_equal = measured.values.size() > 1 &&
                         std::ranges::count(measured.values, measured.values.front()) == std::ssize(measured.values);
  if (lost > 0)
    group.sample = ExcludedSample{
        .reason = ExclusionReason::missing_values, .missing = lost, .values = std::move(measured.values)};
  else if (!is_paired && are_equal && repeats_itself(study, solver))
    group.sample = Sample{.values = {measured.values.front()}, .is_deterministic = true};
  else
    group.sample = std::move(measured);
  return group;
}

// One value per session: the share solved in time, the logarithm of the median time of its targets, where all are
// solved, or its part in the logarithm of all that was spent by all that was solved. The value shown is the one
// compared.
Group group_of_times(const StudyResults& study, const Metric& metric, const std::string& solver,
                     const std::set<int>& compared) {
  struct Session {
    std::vector<double> values = {};
    double sum = 0, solved = 0;
  };
  const bool is_share = metric.kind == MetricKind::success_rate, is_ert = metric.kind == MetricKind::ert;
  Group group{.name = solver};
  std::map<int, Session> all;
  bool is_any_solved = false;
  for (const SolveSummary& solve : study.of(solver)) {
    Session& its = all[solve.session];
    const bool is_solved = solve.status == Status::ok;
    its.values.push_back(is_of_solved(study, metric) && !is_solved ? unknown : metric.value(solve, study));
    its.sum += its.values.back(), its.solved += is_solved, is_any_solved |= is_solved;
  }
  std::erase_if(all, [&](const auto& each) {
    return !std::isfinite(each.second.sum) || (is_ert && each.second.sum == 0);  // which has no logarithm
  });
  const auto is_apart = [&](const auto& each) { return !compared.contains(each.first); };
  const bool are_apart = std::ranges::all_of(all, is_apart);
  if (!are_apart) std::erase_if(all, is_apart);
  Sample measured;
  std::vector<Value> spent, solved;
  for (const auto& [session, its] : all) {
    const auto n = static_cast<double>(its.values.size());
    measured.values.push_back(is_share ? its.sum / n : std::log(std::max(describe_values(its.values).median, 1e-9)));
    measured.blocks.push_back(session);
    spent.push_back({session, its.sum}), solved.push_back({session, its.solved});
    if (is_share) group.pooled_n += static_cast<int>(n), group.pooled_share += its.sum;
  }
  group.pooled_share /= std::max(1, group.pooled_n);
  const bool is_solved_here = std::ranges::any_of(solved, [](const Value& each) { return each.value > 0; });
  measured.effective_n = static_cast<double>(all.size());             // each is of a session, so none decides
  measured.solved_targets = std::numeric_limits<double>::infinity();  // or what spent_by_solved says
  if (is_ert) measured.values.clear();
  if (is_ert && is_solved_here)
    for (const Value& each : spent_by_solved(std::move(spent), solved, measured)) measured.values.push_back(each.value);
  if (!are_apart && (!is_ert || is_solved_here))
    group.sample = std::move(measured);
  else if (!is_any_solved && !is_share && (is_ert || study.definition.has_tolerance()))
    group.sample = ExcludedSample{.reason = ExclusionReason::nothing_solved};
  else
    group.sample = ExcludedSample{.reason = ExclusionReason::not_comparable, .values = std::move(measured.values)};
  return group;
}

// Returns the kind of a metric's values before anything is known of the study.
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

MetricSamples observe_times(const StudyResults& study, const Metric& metric) {
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
    // A share of deadlines counts busy sessions, too: they are no random sample, and leaving them out would flatter.
    samples.groups.push_back(group_of_times(study, metric, label, is_share ? sessions.comparable : sessions.quiet[i]));
  }
  return samples;
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
        if (const std::string its = base::lower_case(name); its == known.column || its == known.slug ||
                                                            its == known.name || its == "answered" ||
                                                            std::ranges::count(results::default_tie_breakers, its) > 0)
          throw std::invalid_argument(fmt::format("[check] has the number {}, which is a metric already", name));
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
  MetricSamples samples = is_time_metric(metric) ? observe_times(study, metric) : make_samples_by_target(study, metric);
  samples.warnings = is_time_metric(metric)                              ? time_warnings(study)
                     : metric.quantity_kind == QuantityKind::evaluations ? evaluation_warnings(study)
                                                                         : clock_warnings(study);
  Warning unsolved{.kind = WarningKind::times_not_comparable,
                   .detail = "too little is solved in the sessions that are compared"};
  for (Group& group : samples.groups) {  // who is in doubt is described, and not compared
    const bool is_doubted = std::ranges::any_of(samples.warnings, [&](const Warning& warning) {
      return warning.solvers.empty() || std::ranges::count(warning.solvers, group.name) > 0;
    });
    const ExcludedSample* const its = excluded(group);
    if (its && its->reason == ExclusionReason::not_comparable && !is_doubted && metric.kind != MetricKind::success_rate)
      unsolved.solvers.push_back(group.name);
    if (its || !is_doubted) continue;  // a group that lost values stays so: the stronger reason
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
