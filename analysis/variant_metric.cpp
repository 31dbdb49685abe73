#include "analysis/variant_metric.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/statistics/mann_whitney.hpp"
#include "analysis/statistics/p_adjust.hpp"
#include "analysis/statistics/power.hpp"
#include "analysis/statistics/proportion.hpp"
#include "analysis/statistics/wilcoxon_signed_rank.hpp"
#include "analysis/text.hpp"

namespace ikbench {
namespace {

void check(const MarginQuestion& question) {
  if (!(question.margin >= 0 && question.margin < 1)) {
    throw std::invalid_argument(fmt::format("margin {}: expected 0 to 1, without 1", question.margin));
  }
  if (!(question.significance > 0 && question.significance <= 0.2)) {
    throw std::invalid_argument(fmt::format("significance {}: expected above 0, to 0.2", question.significance));
  }
}

bool is_finite(double value) { return std::isfinite(value); }

int not_finite(std::span<const double> values) {
  return static_cast<int>(values.size()) - static_cast<int>(std::ranges::count_if(values, is_finite));
}

void settle(MetricComparison& result, Outcome outcome, std::string why) {
  result.outcome = outcome;
  result.is_fact = true;
  result.remark = std::move(why);
  if (result.a.mean > 0 && result.outcome != Outcome::not_compared) result.ratio.ratio = result.b.mean / result.a.mean;
}

// What is not finite ranks as worse than every number.
std::vector<double> rankable(std::span<const double> values, Better better) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> result(values.begin(), values.end());
  std::ranges::replace_if(
      result, [](double value) { return !is_finite(value); }, better == Better::smaller ? infinity : -infinity);
  return result;
}

void rank(MetricComparison& result, const MetricSamples& samples, double level) {
  const Better better = samples.metric.better;
  const std::vector<double> a = rankable(samples.a, better), b = rankable(samples.b, better);
  const bool smaller = better == Better::smaller;
  result.b_better = vargha_delaney(smaller ? a : b, smaller ? b : a, level);
  if (result.is_fact) return;
  double favour = result.b_better.value - 0.5;
  if (samples.paired) {
    const WilcoxonSignedRank test = wilcoxon_signed_rank(a, b, level);
    result.p_ranks = test.p;
    favour = (test.V - test.n * (test.n + 1.0) / 4) * (smaller ? 1 : -1);
  } else {
    result.p_ranks = mann_whitney(a, b, level).p;
  }
  result.ranks_favour = favour > 0 ? 1 : favour < 0 ? -1 : 0;
}

// 1 where the mean of b is the better, -1 where it is the worse.
int means_favour(const MetricComparison& comparison, Better better) {
  const double ahead = (comparison.a.mean - comparison.b.mean) * (better == Better::smaller ? 1 : -1);
  return ahead > 0 ? 1 : ahead < 0 ? -1 : 0;
}

Better better_of(const MetricComparison& comparison) {
  return std::ranges::find(compared_metrics, comparison.metric, &ComparedMetric::name)->better;
}

// The runs a side with which the distance of the ratio from the nearer end of the margin shows.
double runs_to_decide(const MetricSamples& samples, double ratio, const MarginQuestion& question) {
  if (!is_finite(ratio)) return not_defined;
  const double end = 1 + std::copysign(question.margin, ratio - 1);
  std::vector<double> scaled(samples.a.begin(), samples.a.end());
  for (double& value : scaled) value *= end;
  GroupSummary first = summarise(scaled), second = summarise(samples.b);
  const double distance = second.mean - first.mean;
  if (samples.paired) {  // Welch's test of the differences and a group without spread is Student's test of pairs
    for (std::size_t i = 0; i < scaled.size(); ++i) scaled[i] -= samples.b[i];
    first = summarise(scaled);
    second.std = 0;
  }
  const bool is_beyond = std::abs(ratio - 1) > question.margin;  // Holm's correction is at most Bonferroni's
  const double alpha = question.significance / (is_beyond ? samples.tests : 1);
  return runs_to_see(first, second, distance, {.power = question.power, .alpha = 2 * alpha}).n;  // one-sided tests
}

// Runs that are not finite have no mean to compare: their number does.
void compare_not_finite(MetricComparison& result, const MetricSamples& samples) {
  const int a = not_finite(samples.a), b = not_finite(samples.b);
  const int of_a = static_cast<int>(samples.a.size()), of_b = static_cast<int>(samples.b.size());
  const std::string counts = fmt::format("not finite: {} of {} runs of A, {} of {} of B", a, of_a, b, of_b);
  if (a == 0 || b == 0) return settle(result, a == 0 ? Outcome::worse : Outcome::better, counts);
  const double p = fisher_exact({.successes = a, .trials = of_a}, {.successes = b, .trials = of_b}).p;
  const double more_in_b = static_cast<double>(b) / of_b - static_cast<double>(a) / of_a;
  result.p_worse = more_in_b > 0 ? p : 1;
  result.p_better = more_in_b < 0 ? p : 1;
  result.ratio.undefined = counts;
}

void compare_constants(MetricComparison& result, Better better, double margin) {
  const std::string constant = "constant in both";
  const double beyond = std::abs(result.b.mean - result.a.mean) - margin * std::abs(result.a.mean);
  const double rounding = 4 * std::numeric_limits<double>::epsilon() * std::abs(result.a.mean);
  const int favoured = means_favour(result, better);
  if (favoured == 0) return settle(result, Outcome::same, constant + ", and equal");
  if (beyond <= rounding) return settle(result, Outcome::same, constant + ", and within the margin");
  settle(result, favoured > 0 ? Outcome::better : Outcome::worse, constant);
}

void compare_means(MetricComparison& result, const MetricSamples& samples, const MarginQuestion& question) {
  const RatioQuestion about{.margin = question.margin, .level = 1 - 2 * question.significance};
  result.ratio =
      samples.paired ? paired_mean_ratio(samples.a, samples.b, about) : mean_ratio(samples.a, samples.b, about);
  const Better better = samples.metric.better;
  if (result.a.std == 0 && result.b.std == 0) return compare_constants(result, better, question.margin);
  if (result.ratio.undefined.empty()) {
    const bool smaller = better == Better::smaller;
    result.p_worse = smaller ? result.ratio.p_above : result.ratio.p_below;
    result.p_better = smaller ? result.ratio.p_below : result.ratio.p_above;
    result.p_not_worse = 1 - result.p_worse;
    result.runs_to_decide = runs_to_decide(samples, result.ratio.ratio, question);
  } else if (is_finite(result.ratio.p_difference)) {  // of a mean of 0 any difference is beyond the margin
    const double for_it = result.ratio.p_difference / 2, against_it = 1 - for_it;
    const int favoured = means_favour(result, better);
    result.p_worse = favoured < 0 ? for_it : against_it;
    result.p_better = favoured > 0 ? for_it : against_it;
  }
}

// What is known of a metric that no test has decided.
std::string what_is_known(const MetricComparison& comparison, const MarginQuestion& question) {
  if (!comparison.ratio.undefined.empty()) return comparison.ratio.undefined;
  const double alpha = question.significance;
  const std::string_view word = means_favour(comparison, better_of(comparison)) > 0 ? "better" : "worse";
  std::string known = "not told apart";
  if (comparison.p_worse < alpha || comparison.p_better < alpha) {
    known = fmt::format("{} by its own p, not by Holm's", word);
  } else if (comparison.ratio.p_difference < alpha) {
    known = fmt::format("{}, but not shown to be by more than {}", word, percent(question.margin));
  }
  if (!is_finite(comparison.runs_to_decide)) return known;
  return fmt::format("{}; about {:.0f} runs would decide", known, comparison.runs_to_decide);
}

// Where the ranks say other than the means; empty where they do not.
std::string ranks_remark(const MetricComparison& comparison, double alpha) {
  if (!is_finite(comparison.p_ranks) || !is_finite(comparison.ratio.p_difference)) return "";
  const bool by_means = comparison.ratio.p_difference < alpha, by_ranks = comparison.p_ranks < alpha;
  const std::string p = fmt::format("p {}", short_number(comparison.p_ranks));
  const std::string_view favoured = comparison.ranks_favour > 0 ? "better" : "worse";
  if (by_means && by_ranks && comparison.ranks_favour == -means_favour(comparison, better_of(comparison))) {
    return fmt::format("the ranks contradict the mean: by them B is {} ({})", favoured, p);
  }
  if (by_ranks && comparison.outcome == Outcome::undecided && !by_means) {
    return fmt::format("by ranks B is {} ({})", favoured, p);
  }
  if (!by_ranks && (comparison.outcome == Outcome::worse || comparison.outcome == Outcome::better)) {
    return fmt::format("not told apart by ranks ({})", p);
  }
  return "";
}

}  // namespace

std::string percent(double share) { return fmt::format("{:g} %", 100 * share); }

MetricComparison compare_metric(const MetricSamples& samples, const MarginQuestion& question) {
  check(question);
  MetricComparison result{.metric = samples.metric.name, .a = summarise(samples.a), .b = summarise(samples.b)};
  if (!samples.not_compared.empty()) {
    settle(result, Outcome::not_compared, samples.not_compared);
    return result;
  }
  if (samples.a.empty() || samples.b.empty()) {
    result.ratio.undefined = "there is no complete run to compare";
    return result;
  }
  const auto is_rounding = [&](double value) { return value >= 0 && value <= samples.metric.rounding; };
  if (samples.same_bits) {
    settle(result, Outcome::same, "to the bit");
  } else if (not_finite(samples.a) + not_finite(samples.b) > 0) {
    compare_not_finite(result, samples);
  } else if (samples.metric.rounding > 0 && std::ranges::all_of(samples.a, is_rounding) &&
             std::ranges::all_of(samples.b, is_rounding)) {
    settle(result, Outcome::same, fmt::format("both are rounding, below {}", short_number(samples.metric.rounding)));
  } else if (samples.a.size() < 2 || samples.b.size() < 2) {
    result.ratio.undefined = "a single run has no spread; more runs have one (--set runs=20)";
  } else {
    compare_means(result, samples, question);
  }
  rank(result, samples, 1 - 2 * question.significance);
  return result;
}

void decide(std::span<MetricComparison> comparisons, const MarginQuestion& question) {
  check(question);
  std::vector<double> worse, better;
  for (const MetricComparison& comparison : comparisons) {
    worse.push_back(comparison.p_worse);
    better.push_back(comparison.p_better);
  }
  worse = adjusted(worse, Correction::holm);
  better = adjusted(better, Correction::holm);
  const double alpha = question.significance;
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    MetricComparison& comparison = comparisons[i];
    if (comparison.is_fact) continue;
    if (worse[i] < alpha) {
      comparison.outcome = Outcome::worse;
    } else if (better[i] < alpha) {
      comparison.outcome = Outcome::better;
    } else if (comparison.ratio.p_equivalent < alpha) {
      comparison.outcome = Outcome::same;
    } else if (comparison.p_not_worse < alpha) {
      comparison.outcome = Outcome::not_worse;
    }
    if (comparison.outcome == Outcome::undecided || comparison.outcome == Outcome::not_worse) {
      comparison.remark = what_is_known(comparison, question);
    } else if (!comparison.ratio.undefined.empty()) {
      comparison.remark = comparison.ratio.undefined;
    }
    if (const std::string ranks = ranks_remark(comparison, alpha); !ranks.empty()) {
      comparison.remark += (comparison.remark.empty() ? "" : "; ") + ranks;
    }
    comparison.p_worse = worse[i];
    comparison.p_better = better[i];
  }
}

}  // namespace ikbench
