#include "analysis/judge/judge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

namespace ikbench::judge {

namespace {

// Where few values of a mean leave a finding open, of all whose means are such.
void add_doubt(JudgedMetric& judged) {
  Warning warning{.kind = WarningKind::dominated_by_few,
                  .detail = (is_log_scale(judged.samples) ? "" : "mean ") + judged.samples.quantity};
  const auto is_left = [](const Comparison& comparison) {
    return is_not_tested(comparison, NotTestedReason::dominated);
  };
  if (std::ranges::none_of(judged.comparisons, is_left)) return;
  for (const Group& group : judged.samples.groups)
    if (!excluded(group) && is_dominated(group)) warning.solvers.push_back(group.name);
  judged.samples.warnings.push_back(std::move(warning));
}

// Of the first that is better by ranks, though its median, or else its mean, is worse by more than the margin (a best
// one's median: at all). Where each has its own targets, these say nothing of two.
void add_doubt_of_ranks(JudgedMetric& judged) {
  const MetricSamples& samples = judged.samples;
  if (is_conditional_on_success(samples) || samples.min_blocks > 0 || judged.plan.test == AnalysisPlan::Test::means)
    return;
  const std::set<std::string> losers = beaten_solvers(judged.comparisons);
  for (const Comparison& comparison : judged.comparisons) {
    if (!std::holds_alternative<TestResult>(comparison.result) || !is_difference(verdict_of(comparison))) continue;
    const Comparison its = better_first(comparison, "");
    const Descriptives &one = judged.descriptives[its.first_index], &two = judged.descriptives[its.second_index];
    const bool is_best = !losers.contains(its.first);  // and its median stands beside it
    const bool is_median_worse = is_best && one.median != two.median
                                     ? (one.median > two.median) == (samples.better == Better::smaller)
                                     : is_worse_beyond_margin(samples, judged.plan, one.median, two.median);
    if (!is_median_worse && !is_worse_beyond_margin(samples, judged.plan, one.mean, two.mean)) continue;
    judged.samples.warnings.push_back({.kind = WarningKind::ranks_disagree,
                                       .solvers = {its.first, its.second},
                                       .detail = (is_median_worse ? "median " : "mean ") + samples.quantity});
    return;
  }
}

// The findings of a study beside which labels of another machine stand. Pairs of its own labels have the p that they
// have without those. Each of those is compared with the control alone, and these pairs are a second family.
std::vector<Comparison> findings_of(const JudgedMetric& metric, const ImportedResults& beside, std::size_t metrics) {
  if (beside.labels.empty()) return compare(metric.samples, metric.plan, metrics);
  MetricSamples own = metric.samples;
  std::erase_if(own.groups, [&](const Group& group) { return beside.has(group.name); });
  AnalysisPlan own_plan = metric.plan;
  if (beside.is_control_chosen) own_plan.control.clear();
  std::vector<Comparison> comparisons = compare(own, own_plan, metrics);
  std::erase_if(comparisons, [&](const Comparison& comparison) {
    return comparison.first != metric.plan.control && comparison.second != metric.plan.control;
  });
  MetricSamples others = metric.samples;
  std::erase_if(others.groups,
                [&](const Group& group) { return !beside.has(group.name) && group.name != metric.plan.control; });
  for (Comparison& comparison : compare(others, metric.plan, metrics)) comparisons.push_back(std::move(comparison));
  return comparisons;
}

// Where time alone ends solves at the deadline, what is solved is solved in time: two columns would be one.
bool is_solved_by_another_name(const Metric& metric, const results::StudyDefinition& study) {
  const bool is_solved_in_time = metric.quantity_kind == QuantityKind::time && metric.kind == MetricKind::success_rate;
  return is_solved_in_time && study.has_tolerance() && study.stop.only_time_limits() &&
         study.stop.seconds <= study.deadline();
}

// The word by which `then` of a plan names a metric; empty if none does.
std::string_view then_word_of(const MetricSamples& samples) {
  if (is_proportion(samples)) return "";
  switch (samples.quantity_kind) {
    case QuantityKind::time:
      return "time";
    case QuantityKind::evaluations:
      return "evaluations";
    case QuantityKind::motion:
      return "motion";
    default:
      return "";
  }
}

std::vector<bool> beaten_groups(const JudgedMetric& judged) {
  std::vector<bool> is_beaten(judged.samples.groups.size());
  for (const Comparison& comparison : judged.comparisons) {
    const Verdict verdict = verdict_of(comparison);
    if (verdict == Verdict::better) is_beaten[comparison.second_index] = true;
    if (verdict == Verdict::worse) is_beaten[comparison.first_index] = true;
  }
  return is_beaten;
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

// Returns the average evaluations of each group; infinity if they are not known, 0 for all if no metric is evaluations.
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

// Some observation has a value, and if this is no share one is not 0.
bool has_meaning(const MetricSamples& samples) {
  return std::ranges::any_of(samples.groups, [&](const Group& group) {
    return std::ranges::any_of(values_of(group), [&](double value) { return value != 0 || is_proportion(samples); });
  });
}

}  // namespace

JudgedMetric judge(MetricSamples observations, const AnalysisPlan& plan) {
  std::vector<Comparison> comparisons = compare(observations, plan);
  return judge(std::move(observations), plan, std::move(comparisons));
}

JudgedMetric judge(MetricSamples observations, const AnalysisPlan& plan, std::vector<Comparison> comparisons) {
  JudgedMetric judged{.samples = std::move(observations), .plan = plan, .comparisons = std::move(comparisons)};
  const MetricSamples& samples = judged.samples;
  set_group_indices(judged.comparisons, samples);
  for (const Group& group : samples.groups) {
    const Descriptives its = describe(group);
    judged.descriptives.push_back(is_log_scale(samples) ? Descriptives{.n = its.n, .mean = std::exp(its.mean)}
                                  : group.pooled_n > 0  ? Descriptives{.n = group.pooled_n, .mean = group.pooled_share}
                                                        : its);
  }
  add_doubt(judged);
  add_doubt_of_ranks(judged);
  return judged;
}

double average_of(const JudgedMetric& judged, std::size_t group) {
  const Descriptives& its = judged.descriptives[group];
  const bool is_mean =
      is_proportion(judged.samples) || judged.plan.test == AnalysisPlan::Test::means || std::isnan(its.median);
  if (missing_in(judged.samples.groups[group]) > 0) return unknown;
  return is_mean ? its.mean : its.median;
}

std::vector<std::size_t> display_order(const JudgedMetric& judged, const std::vector<JudgedMetric>& all) {
  const std::vector<bool> is_beaten = beaten_groups(judged);
  const bool are_clear = is_clear_order(judged.comparisons, is_beaten);
  const std::vector<double> costs = average_evaluations(judged.samples.groups, all);
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
  const bool are_any_solved = definition.has_tolerance() && solved > 0;
  const std::vector<Metric> all = metrics_of(definition);
  const Metric& deciding = metric_named(!definition.plan.metric.empty() ? definition.plan.metric
                                        : are_any_solved                ? "solved"
                                                                        : "position_error_cm",
                                        all);
  const bool do_some_fail = are_any_solved && !definition.is_chained() && solved < std::ssize(study.solves);
  JudgedStudy judged;
  for (const Metric& metric : all) {
    const bool is_deciding = &metric == &deciding;
    const bool is_told_by_solved = metric.kind == MetricKind::error && are_any_solved;
    const bool is_told =
        metric.when_reported == WhenReported::always ||
        metric.when_reported == (do_some_fail ? WhenReported::if_some_fail : WhenReported::if_all_solve);
    if (!is_deciding && (!is_told || is_told_by_solved)) continue;
    if (!is_deciding && is_solved_by_another_name(metric, definition)) continue;
    MetricSamples samples = make_samples(study, metric);
    if (!is_deciding && !has_meaning(samples)) continue;
    if (is_deciding) judged.primary = judged.metrics.size();
    judged.metrics.push_back({.samples = std::move(samples), .plan = definition.plan});
    if (metric.value_of == nullptr) judged.metrics.back().plan.margin = 0;  // a share of what may be below 0
  }
  judged.warnings = study_warnings(study);
  judged.study = std::move(study);
  return judged;
}

JudgedStudy judge(StudyResults study) {
  JudgedStudy judged = make_all_samples(std::move(study));
  const std::size_t metrics = names_in_plan(judged.study.definition).size();
  for (JudgedMetric& metric : judged.metrics) {
    std::vector<Comparison> comparisons = findings_of(metric, judged.study.imported, metrics);
    metric = judge(std::move(metric.samples), metric.plan, std::move(comparisons));
  }
  return judged;
}

std::vector<std::string> names_in_plan(const results::StudyDefinition& study) {
  const AnalysisPlan& plan = study.plan;
  std::string first = plan.metric;
  if (first.empty()) first = study.has_tolerance() ? "solved" : "error";
  std::vector<std::string> names{first};
  std::string_view its_word;
  if (!plan.metric.empty()) its_word = then_word_of(empty_samples(metric_named(plan.metric, metrics_of(study))));
  for (const std::string& word : results::default_tie_breakers)
    if (word != its_word && std::ranges::count(plan.tie_breakers, word) > 0) names.push_back(word);
  return names;
}

std::string name_in_plan(const JudgedStudy& study, const JudgedMetric& metric) {
  const std::vector<std::string> names = names_in_plan(study.study.definition);
  const JudgedMetric& deciding = study.metrics[study.primary];
  if (&metric == &deciding) return names.front();
  const std::string_view word = then_word_of(metric.samples);
  const auto has_word = [&](const JudgedMetric& each) { return then_word_of(each.samples) == word; };
  // A word names one metric: else more of them would decide than share the significance.
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
