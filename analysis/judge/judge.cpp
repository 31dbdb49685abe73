#include "analysis/judge/judge.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

namespace ikbench::judge {

namespace {

// Returns for each group whether another group is better.
std::vector<bool> beaten_groups(const JudgedMetric& judged) {
  std::vector<bool> is_beaten(judged.samples.groups.size());
  for (const Comparison& comparison : judged.comparisons) {
    const Verdict verdict = verdict_of(comparison);
    if (verdict == Verdict::better) is_beaten[comparison.second_index] = true;
    if (verdict == Verdict::worse) is_beaten[comparison.first_index] = true;
  }
  return is_beaten;
}

// Adds a warning that names the groups whose mean a few values dominate, of the comparisons that are inconclusive for
// this reason. Where only the differences of two groups are dominated, both are named.
void add_dominance_warning(JudgedMetric& judged) {
  std::set<std::size_t> dominated;
  for (const Comparison& comparison : judged.comparisons) {
    if (!is_not_tested(comparison, NotTestedReason::dominated)) continue;
    const std::array both{comparison.first_index, comparison.second_index};
    const auto is_dominated_group = [&](std::size_t group) { return is_dominated(judged.samples.groups[group]); };
    const bool is_any = std::ranges::any_of(both, is_dominated_group);
    for (const std::size_t group : both)
      if (!is_any || is_dominated_group(group)) dominated.insert(group);
  }
  if (dominated.empty()) return;
  Warning warning{.kind = WarningKind::dominated_by_few,
                  .detail = (is_log_scale(judged.samples) ? "" : "mean ") + judged.samples.quantity};
  for (const std::size_t group : dominated) warning.solvers.push_back(judged.samples.groups[group].name);
  judged.samples.warnings.push_back(std::move(warning));
}

// Returns whether the better group of a comparison has the worse median. If another group beats the better one, only a
// difference above the margin counts. Otherwise any difference counts, because the headline shows that median.
bool is_median_worse(const JudgedMetric& judged, const Comparison& comparison, bool is_better_beaten) {
  const double better = judged.descriptives[comparison.first_index].median;
  const double worse = judged.descriptives[comparison.second_index].median;
  if (is_better_beaten || better == worse) return is_worse_beyond_margin(judged.samples, judged.plan, better, worse);
  return (better > worse) == (judged.samples.better == Better::smaller);
}

// Adds a warning for the first group that is better by ranks, but worse by the median or the mean. Groups that have
// their own targets are left out, because their averages say nothing of a pair.
void add_rank_warning(JudgedMetric& judged) {
  const MetricSamples& samples = judged.samples;
  if (is_conditional_on_success(samples) || samples.min_blocks > 0 || judged.plan.test == AnalysisPlan::Test::means)
    return;
  const std::vector<bool> is_beaten = beaten_groups(judged);
  for (const Comparison& comparison : judged.comparisons) {
    if (!std::holds_alternative<TestResult>(comparison.result) || !is_difference(verdict_of(comparison))) continue;
    const Comparison ordered = better_first(comparison, "");
    const bool is_by_median = is_median_worse(judged, ordered, is_beaten[ordered.first_index]);
    const double better_mean = judged.descriptives[ordered.first_index].mean;
    const double worse_mean = judged.descriptives[ordered.second_index].mean;
    if (!is_by_median && !is_worse_beyond_margin(samples, judged.plan, better_mean, worse_mean)) continue;
    judged.samples.warnings.push_back({.kind = WarningKind::ranks_disagree,
                                       .solvers = {ordered.first, ordered.second},
                                       .detail = (is_by_median ? "median " : "mean ") + samples.quantity});
    return;
  }
}

// Sets the indices of comparisons that were made of parts of these groups.
void set_group_indices(std::vector<Comparison>& comparisons, const std::vector<Group>& groups) {
  const auto index_of = [&](const std::string& name) {
    return static_cast<std::size_t>(std::ranges::find(groups, name, &Group::name) - groups.begin());
  };
  for (Comparison& comparison : comparisons) {
    comparison.first_index = index_of(comparison.first);
    comparison.second_index = index_of(comparison.second);
  }
}

// Returns the comparisons of a metric; none of a grid. Pairs of the study's own labels keep the p that they would have
// without imported results. Imported labels are compared only with the control, and these pairs are a second family.
std::vector<Comparison> comparisons_of(const JudgedMetric& metric, const ImportedResults& imported,
                                       std::size_t metrics) {
  if (!metric.samples.is_random) return {};
  if (imported.labels.empty()) return compare_pairs(metric.samples, metric.plan, metrics);
  MetricSamples own = metric.samples;
  std::erase_if(own.groups, [&](const Group& group) { return imported.has(group.name); });
  AnalysisPlan own_plan = metric.plan;
  if (imported.is_control_chosen) own_plan.control.clear();
  std::vector<Comparison> comparisons = compare_pairs(own, own_plan, metrics);
  std::erase_if(comparisons, [&](const Comparison& comparison) {
    return comparison.first != metric.plan.control && comparison.second != metric.plan.control;
  });
  MetricSamples others = metric.samples;
  std::erase_if(others.groups,
                [&](const Group& group) { return !imported.has(group.name) && group.name != metric.plan.control; });
  for (Comparison& comparison : compare_pairs(others, metric.plan, metrics))
    comparisons.push_back(std::move(comparison));
  set_group_indices(comparisons, metric.samples.groups);
  return comparisons;
}

// Returns whether a metric repeats "solved": if only time ends solves, and at the deadline, every solved target is
// solved in time.
bool repeats_solved(const Metric& metric, const results::StudyDefinition& study) {
  const bool is_solved_in_time = metric.quantity_kind == QuantityKind::time && metric.kind == MetricKind::success_rate;
  return is_solved_in_time && study.has_tolerance() && study.stop.only_time_limits() &&
         study.stop.seconds <= study.deadline();
}

// Returns the word by which the tie-breakers of a plan name a metric; empty if no word does.
std::string_view tie_breaker_of(const MetricSamples& samples) {
  if (is_proportion(samples)) return "";
  switch (samples.quantity_kind) {
    case QuantityKind::time:
      return "time";
    case QuantityKind::evaluations:
      return "evaluations";
    case QuantityKind::motion:
      return "motion";
    case QuantityKind::other:
    case QuantityKind::solved:
    case QuantityKind::answered:
    case QuantityKind::position:
    case QuantityKind::angle:
      break;
  }
  return "";
}

// Returns whether every unbeaten group beats all beaten ones, and is tested against every other unbeaten one.
bool is_clear_order(const std::vector<Comparison>& comparisons, const std::vector<bool>& is_beaten) {
  return std::ranges::all_of(comparisons, [&](const Comparison& comparison) {
    const bool is_first_beaten = is_beaten[comparison.first_index];
    const bool is_second_beaten = is_beaten[comparison.second_index];
    if (is_first_beaten && is_second_beaten) return true;
    if (is_first_beaten != is_second_beaten) return is_difference(verdict_of(comparison));
    return verdict_of(comparison) != Verdict::not_tested;
  });
}

// Returns the average evaluations of each group; infinity if the evaluations are not known, and 0 for all groups if no
// metric is evaluations.
std::vector<double> average_evaluations(const std::vector<Group>& groups, const std::vector<JudgedMetric>& metrics) {
  std::vector<double> averages(groups.size(), 0.0);
  const auto evaluations = std::ranges::find(metrics, QuantityKind::evaluations,
                                             [](const JudgedMetric& metric) { return metric.samples.quantity_kind; });
  if (evaluations == metrics.end()) return averages;
  std::map<std::string_view, double> known;
  for (std::size_t i = 0; i < evaluations->descriptives.size(); ++i)
    known.emplace(evaluations->samples.groups[i].name, average_of(*evaluations, i));
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const auto found = known.find(groups[i].name);
    const bool is_known = found != known.end() && !std::isnan(found->second);
    averages[i] = is_known ? found->second : std::numeric_limits<double>::infinity();
  }
  return averages;
}

// Returns whether the samples say anything: a proportion needs a value, and another quantity a value that is not 0.
bool has_meaning(const MetricSamples& samples) {
  return std::ranges::any_of(samples.groups, [&](const Group& group) {
    return std::ranges::any_of(values_of(group), [&](double value) { return value != 0 || is_proportion(samples); });
  });
}

// Returns the descriptives that readers see: the geometric mean of logarithms, and the share of all solves of a
// proportion by session.
Descriptives shown_descriptives(const MetricSamples& samples, const Group& group) {
  const Descriptives descriptives = describe(group);
  if (is_log_scale(samples)) return {.n = descriptives.n, .mean = std::exp(descriptives.mean)};
  if (group.pooled_n > 0) return {.n = group.pooled_n, .mean = group.pooled_share};
  return descriptives;
}

// Returns the column of the metric that decides a study.
std::string_view deciding_column(const results::StudyDefinition& study, bool is_any_solved) {
  if (!study.plan.metric.empty()) return study.plan.metric;
  return is_any_solved || (study.is_grid() && study.has_tolerance()) ? "solved" : "position_error_cm";
}

// Returns whether reports show a metric that does not decide.
bool is_reported(const Metric& metric, const results::StudyDefinition& study, bool is_any_solved, bool is_any_failed) {
  const WhenReported here = is_any_failed ? WhenReported::if_some_fail : WhenReported::if_all_solve;
  if (metric.when_reported != WhenReported::always && metric.when_reported != here) return false;
  // If a target was solved, "solved" says which errors are small enough.
  if (metric.kind == MetricKind::error && is_any_solved) return false;
  return !repeats_solved(metric, study);
}

}  // namespace

JudgedMetric judge(MetricSamples samples, const AnalysisPlan& plan) {
  std::vector<Comparison> comparisons = compare_pairs(samples, plan);
  return judge(std::move(samples), plan, std::move(comparisons));
}

JudgedMetric judge(MetricSamples samples, const AnalysisPlan& plan, std::vector<Comparison> comparisons) {
  JudgedMetric judged{.samples = std::move(samples), .plan = plan, .comparisons = std::move(comparisons)};
  for (const Group& group : judged.samples.groups)
    judged.descriptives.push_back(shown_descriptives(judged.samples, group));
  add_dominance_warning(judged);
  add_rank_warning(judged);
  return judged;
}

double average_of(const JudgedMetric& judged, std::size_t group) {
  if (missing_in(judged.samples.groups[group]) > 0) return unknown;
  const Descriptives& descriptives = judged.descriptives[group];
  const bool is_mean =
      is_proportion(judged.samples) || judged.plan.test == AnalysisPlan::Test::means || std::isnan(descriptives.median);
  return is_mean ? descriptives.mean : descriptives.median;
}

std::vector<std::size_t> display_order(const JudgedMetric& judged, const std::vector<JudgedMetric>& metrics) {
  const std::vector<bool> is_beaten = beaten_groups(judged);
  const bool are_clear = is_clear_order(judged.comparisons, is_beaten);
  const std::vector<double> costs = average_evaluations(judged.samples.groups, metrics);
  std::vector<std::size_t> order(judged.descriptives.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) {
    enum Rank { unbeaten, known, incomplete, without_average };
    const double average = average_of(judged, i);
    if (std::isnan(average)) return std::tuple(without_average, 0.0, 0.0);
    Rank rank = known;
    if (are_clear && !is_beaten[i]) rank = unbeaten;
    if (missing_in(judged.samples.groups[i]) > 0) rank = incomplete;
    return std::tuple(rank, judged.samples.better == Better::larger ? -average : average, costs[i]);
  });
  return order;
}

JudgedStudy make_all_samples(StudyResults study) {
  const results::StudyDefinition& definition = study.definition;
  const auto solved = std::ranges::count(study.solves, results::Status::ok, &SolveSummary::status);
  const bool is_any_solved = definition.has_tolerance() && solved > 0;
  const std::vector<Metric> all = metrics_of(definition);
  const Metric& deciding = metric_named(deciding_column(definition, is_any_solved), all);
  const bool is_any_failed = is_any_solved && !definition.is_chained() && solved < std::ssize(study.solves);
  JudgedStudy judged;
  for (const Metric& metric : all) {
    const bool is_deciding = &metric == &deciding;
    if (!is_deciding && !is_reported(metric, definition, is_any_solved, is_any_failed)) continue;
    MetricSamples samples = make_samples(study, metric);
    if (!is_deciding && !has_meaning(samples)) continue;
    if (is_deciding) judged.primary = judged.metrics.size();
    judged.metrics.push_back({.samples = std::move(samples), .plan = definition.plan});
    if (metric.value_of == nullptr) judged.metrics.back().plan.margin = 0;  // values may be below 0
  }
  judged.warnings = study_warnings(study);
  judged.study = std::move(study);
  return judged;
}

JudgedStudy judge(StudyResults study) {
  JudgedStudy judged = make_all_samples(std::move(study));
  const std::size_t metrics = names_in_plan(judged.study.definition).size();
  for (JudgedMetric& metric : judged.metrics) {
    std::vector<Comparison> comparisons = comparisons_of(metric, judged.study.imported, metrics);
    metric = judge(std::move(metric.samples), metric.plan, std::move(comparisons));
  }
  judged.targets = solved_targets(judged.study);
  return judged;
}

std::vector<std::string> names_in_plan(const results::StudyDefinition& study) {
  const AnalysisPlan& plan = study.plan;
  std::string first = plan.metric;
  if (first.empty()) first = study.has_tolerance() ? "solved" : "error";
  std::vector<std::string> names{first};
  std::string_view deciding_word;
  if (!plan.metric.empty()) deciding_word = tie_breaker_of(empty_samples(metric_named(plan.metric, metrics_of(study))));
  for (const std::string& word : results::default_tie_breakers)
    if (word != deciding_word && std::ranges::count(plan.tie_breakers, word) > 0) names.push_back(word);
  return names;
}

std::string name_in_plan(const JudgedStudy& study, const JudgedMetric& metric) {
  const std::vector<std::string> names = names_in_plan(study.study.definition);
  const JudgedMetric& deciding = study.metrics[study.primary];
  if (&metric == &deciding) return names.front();
  const std::string_view word = tie_breaker_of(metric.samples);
  const auto has_word = [&](const JudgedMetric& each) { return tie_breaker_of(each.samples) == word; };
  // A word names only one metric, because otherwise more metrics would decide than share the significance.
  const bool is_first = &metric == &*std::ranges::find_if(study.metrics, has_word);
  const bool is_named = !word.empty() && is_first && !has_word(deciding) && std::ranges::count(names, word) > 0;
  return is_named ? std::string(word) : "";
}

const JudgedMetric* find_metric(const JudgedStudy& judged, std::string_view column) {
  const std::vector<Metric> all = metrics_of(judged.study.definition);
  const std::string_view slug = metric_named(column, all).slug;
  const auto found =
      std::ranges::find_if(judged.metrics, [&](const JudgedMetric& each) { return each.samples.metric == slug; });
  return found == judged.metrics.end() ? nullptr : &*found;
}

const Comparison* find_comparison(const JudgedMetric& judged, std::string_view one, std::string_view other) {
  const std::size_t i = index_of(judged.samples, one);
  const std::size_t j = index_of(judged.samples, other);
  const auto found = std::ranges::find_if(judged.comparisons, [=](const Comparison& comparison) {
    return (comparison.first_index == i && comparison.second_index == j) ||
           (comparison.first_index == j && comparison.second_index == i);
  });
  return found == judged.comparisons.end() ? nullptr : &*found;
}

ComparisonTable::ComparisonTable(const JudgedMetric& judged)
    : groups_(judged.samples.groups.size()), cells_(groups_ * groups_, nullptr) {
  for (const Comparison& comparison : judged.comparisons) {
    cells_.at(comparison.first_index * groups_ + comparison.second_index) = &comparison;
    cells_.at(comparison.second_index * groups_ + comparison.first_index) = &comparison;
  }
}

const Comparison* ComparisonTable::find(std::size_t first, std::size_t second) const {
  return first < groups_ && second < groups_ ? cells_[first * groups_ + second] : nullptr;
}

Verdict ComparisonTable::verdict(std::size_t first, std::size_t second) const {
  const Comparison* const comparison = find(first, second);
  if (comparison == nullptr) return Verdict::not_tested;
  const Verdict verdict = verdict_of(*comparison);
  return comparison->first_index == first ? verdict : reversed(verdict);
}

}  // namespace ikbench::judge
