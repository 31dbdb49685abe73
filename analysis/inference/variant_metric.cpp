#include "analysis/inference/variant_metric.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "analysis/inference/margin.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/statistics/mann_whitney.hpp"
#include "analysis/statistics/power.hpp"
#include "analysis/statistics/proportion.hpp"
#include "analysis/statistics/rounding.hpp"
#include "analysis/statistics/sign_test.hpp"
#include "results/analysis_plan_fields.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

void check(const MarginQuestion& question) {
  const auto refuse_beyond = [](std::string_view name, double value, std::pair<double, double> range) {
    if (value >= range.first && value <= range.second) return;
    throw std::invalid_argument(fmt::format("{} {}: expected {} to {}", name, value, range.first, range.second));
  };
  refuse_beyond("margin", question.margin, {margins_percent.first / 100, margins_percent.second / 100});
  refuse_beyond("margin in cm", question.margin_cm, margins_cm);
  refuse_beyond("significance", question.significance, significances);
  refuse_beyond("power", question.power, powers);
}

bool is_finite(double value) { return std::isfinite(value); }

int not_finite(std::span<const double> values) {
  return static_cast<int>(values.size()) - static_cast<int>(std::ranges::count_if(values, is_finite));
}

void settle(MetricComparison& result, Outcome outcome, std::string why) {
  result.outcome = outcome;
  result.is_fact = true;
  result.remark = std::move(why);
  const bool is_compared = outcome != Outcome::not_compared && outcome != Outcome::not_counted;
  if (result.a.mean > 0 && is_compared) result.ratio.ratio = result.b.mean / result.a.mean;
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
  const Better better = info_of(samples.metric).better;
  const std::vector<double> a = rankable(samples.a, better), b = rankable(samples.b, better);
  const bool smaller = better == Better::smaller;
  result.b_better = vargha_delaney(smaller ? a : b, smaller ? b : a, level);
  if (result.is_fact) return;
  double favour = result.b_better.value - 0.5;
  if (samples.paired) {
    const SignTest test = sign_test(a, b);
    result.p_ranks = test.p;
    favour = test.direction * (smaller ? 1 : -1);
  } else {
    result.p_ranks = mann_whitney(a, b).p;
  }
  if (result.a.std == 0 && result.b.std == 0) result.p_ranks = result.ratio.p_difference;  // ties have no exact p there
  result.ranks_favour = favour > 0 ? 1 : favour < 0 ? -1 : 0;
}

// The observations a side with which a difference of the margin shows, or that there is none, at the spread of these
// samples. It does not hang on the difference that these happen to have.
double to_decide(const MetricSamples& samples, const MarginQuestion& question) {
  const double room = std::max(question.margin_cm, question.margin * std::abs(mean(samples.a)));
  if (!(room > 0)) return not_defined;
  // Two one-sided tests have to show that there is no difference, each with half of what may fail. Holm's correction is
  // at most Bonferroni's.
  const PowerGoal goal{.power = (1 + question.power) / 2, .alpha = 2 * question.significance / samples.tests};
  if (!samples.paired) return runs_to_see(summarise(samples.a), summarise(samples.b), room, goal).n;
  std::vector<double> differences(samples.a.begin(), samples.a.end());
  for (std::size_t i = 0; i < differences.size(); ++i) differences[i] -= samples.b[i];
  return pairs_to_see(summarise(differences).std, room, goal).n;
}

// The chance, were there no difference, that samples lie apart as these do: of independent ones Mann and Whitney's
// exact p, which is Fisher's of the table of sides; of pairs, that of n signs all being the same.
double p_of_lying_apart(const MetricSamples& samples) {
  const int of_a = static_cast<int>(samples.a.size()), of_b = static_cast<int>(samples.b.size());
  if (samples.paired) return std::ldexp(2.0, -of_a);
  return fisher_exact({.successes = of_a, .trials = of_a}, {.successes = 0, .trials = of_b}).p;
}

bool is_within_margin(const MetricComparison& result, double margin) {
  const double size = std::abs(result.a.mean);
  return without_rounding(std::abs(result.b.mean - result.a.mean) - margin * size, size) <= 0;
}

// That no run of either fails shows less than that measured values are equal: where the chance to fail is the margin,
// n runs without a failure have the probability (1 - margin)^n, and A's, where it is A that fails, 1 / (1 + margin)^n.
void limit_by_failures(MetricComparison& result, const MarginQuestion& question) {
  if (result.a.mean != 1 || result.b.mean != 1) return;
  const double margin = question.margin;
  result.p_not_worse = std::pow(1 - margin, result.b.n);
  result.ratio.p_equivalent = std::max(result.p_not_worse, std::pow(1 + margin, -result.a.n));
  if (margin > 0) result.n_to_decide = std::ceil(-std::log(question.significance) / std::log1p(margin));
}

void compare_ratio(MetricComparison& result, const MetricSamples& samples, const MarginQuestion& question) {
  const RatioQuestion asked{
      .margin = question.margin, .level = 1 - 2 * question.significance, .absolute_margin = question.margin_cm};
  RatioComparison& ratio = result.ratio;
  ratio = samples.paired ? paired_mean_ratio(samples.a, samples.b, asked) : mean_ratio(samples.a, samples.b, asked);
  const auto is_negative = [](double value) { return value < 0; };
  if (std::ranges::none_of(samples.a, is_negative) && std::ranges::none_of(samples.b, is_negative)) {
    ratio.low = std::max(ratio.low, 0.0);  // Fieller's interval knows nothing of signs; NaN stays
  }
  const double least = p_of_lying_apart(samples);  // Student's p of no spread is 0, which no number of runs can show
  const auto shown = [&](double p) { return p == 0 ? least : p; };
  ratio.p_difference = shown(ratio.p_difference);
  if (is_finite(ratio.p_above)) {
    const bool smaller = info_of(samples.metric).better == Better::smaller;
    ratio.p_equivalent = shown(ratio.p_equivalent);
    result.p_worse = shown(smaller ? ratio.p_above : ratio.p_below);
    result.p_better = shown(smaller ? ratio.p_below : ratio.p_above);
    result.p_not_worse = shown(1 - result.p_worse);
    result.n_to_decide = to_decide(samples, question);
  } else if (is_finite(ratio.p_difference)) {  // of a mean of 0 any difference is beyond a relative margin
    const bool is_exact = !ratio.exact.empty();
    const double for_it = is_exact ? ratio.p_difference : ratio.p_difference / 2,
                 against_it = is_exact ? 1 : 1 - for_it;
    result.p_worse = result.mean_favours < 0 ? for_it : against_it;
    result.p_better = result.mean_favours > 0 ? for_it : against_it;
  }
}

// Of finite observations.
void compare_means(MetricComparison& result, const MetricSamples& samples, const MarginQuestion& question) {
  if (samples.a.size() < 2 || samples.b.size() < 2) {
    result.ratio.undefined = fmt::format("a single {}", samples.observation);
    return;
  }
  const double ahead =
      (mean(samples.a) - mean(samples.b)) * (info_of(samples.metric).better == Better::smaller ? 1 : -1);
  result.mean_favours = ahead > 0 ? 1 : ahead < 0 ? -1 : 0;
  const bool is_constant = result.a.std == 0 && result.b.std == 0;
  if (is_constant && info_of(samples.metric).kind == Kind::count && is_within_margin(result, question.margin)) {
    return settle(result, Outcome::same, "constant in both and within the margin");
  }
  compare_ratio(result, samples, question);
  if (is_constant && info_of(samples.metric).kind == Kind::share) limit_by_failures(result, question);
}

bool are_rounding(const MetricSamples& samples) {
  const double rounding = info_of(samples.metric).rounding;
  const auto is_rounding = [&](double value) { return value >= 0 && value <= rounding; };
  return rounding > 0 && std::ranges::all_of(samples.a, is_rounding) && std::ranges::all_of(samples.b, is_rounding);
}

bool has_negative(const MetricSamples& samples) {
  const auto is_negative = [least = -info_of(samples.metric).rounding](double value) {
    return is_finite(value) && value < least;
  };
  return std::ranges::any_of(samples.a, is_negative) || std::ranges::any_of(samples.b, is_negative);
}

struct FiniteValues {
  std::vector<double> a, b;
};

FiniteValues finite_values(const MetricSamples& samples) {
  FiniteValues finite;
  if (samples.paired) {
    for (std::size_t i = 0; i < samples.a.size(); ++i) {
      if (!is_finite(samples.a[i]) || !is_finite(samples.b[i])) continue;
      finite.a.push_back(samples.a[i]);
      finite.b.push_back(samples.b[i]);
    }
  } else {
    std::ranges::copy_if(samples.a, std::back_inserter(finite.a), is_finite);
    std::ranges::copy_if(samples.b, std::back_inserter(finite.b), is_finite);
  }
  return finite;
}

// Not finite is worse than any number, but one such run in eight is chance, and says nothing of the other seven: their
// number and the means of the finite ones are both looked at.
void compare_not_finite(MetricComparison& result, const MetricSamples& samples, const MarginQuestion& question) {
  const FiniteValues finite = finite_values(samples);
  MetricSamples others = samples;
  others.a = finite.a;
  others.b = finite.b;
  if (finite.a.size() < 2 || finite.b.size() < 2) {
    result.ratio.undefined = "too few finite values";
  } else if (are_rounding(others)) {
    result.ratio.undefined = "the finite values are rounding errors";
  } else {
    compare_means(result, others, question);
  }
  const Successes a{.successes = not_finite(samples.a), .trials = static_cast<int>(samples.a.size())};
  const Successes b{.successes = not_finite(samples.b), .trials = static_cast<int>(samples.b.size())};
  const double more_in_b = static_cast<double>(b.successes) / b.trials - static_cast<double>(a.successes) / a.trials;
  const auto either = [](double p_of_counts, double p_of_means) {  // Bonferroni's correction for looking at both
    const double smaller = std::isnan(p_of_means) ? p_of_counts : std::min(p_of_counts, p_of_means);
    return std::min(2 * smaller, 1.0);
  };
  const double counts_worse = fisher_exact(b, a).p_greater, counts_better = fisher_exact(a, b).p_greater;
  const bool counts_against = more_in_b > 0, means_against = result.p_worse < 0.5;  // the mean is beyond the margin
  const double p_better = either(counts_better, result.p_better);
  result.a.mean = mean(finite.a);
  result.b.mean = mean(finite.b);
  result.remark = fmt::format("not finite: {} of {} {}s of A, {} of {} of B", a.successes, a.trials,
                              samples.observation, b.successes, b.trials);
  if (p_better < question.significance && (counts_against || means_against)) {
    result.ratio.undefined = counts_against ? "the finite values of B are better, but fewer"
                                            : "B has more finite values, but they are worse";
  }
  result.p_better = counts_against || means_against ? 1 : p_better;
  result.p_worse = either(counts_worse, result.p_worse);
  result.p_not_worse = result.ratio.p_equivalent = result.n_to_decide = not_defined;
}

// Of one answer each, however often it was repeated: which is better is no matter of chance.
void compare_copies(MetricComparison& result, const MetricSamples& samples, const MarginQuestion& question) {
  const double ahead = (result.a.mean - result.b.mean) * (info_of(samples.metric).better == Better::smaller ? 1 : -1);
  const double room = std::max(question.margin * std::abs(result.a.mean), question.margin_cm);
  const bool is_small = without_rounding(std::abs(ahead) - room, std::abs(result.a.mean)) <= 0;
  settle(result,
         is_small    ? Outcome::same
         : ahead > 0 ? Outcome::better
                     : Outcome::worse,
         "all runs of each are equal: a fact of these targets, without a test");
}

}  // namespace

MarginQuestion question_about(std::string_view metric, const MarginQuestion& question) {
  MarginQuestion result = question;
  if (!is_in_cm(metric)) result.margin_cm = 0;
  return result;
}

MetricComparison compare_metric(const MetricSamples& samples, const MarginQuestion& of_all) {
  check(of_all);
  const MarginQuestion question = question_about(name_of(samples.metric), of_all);
  MetricComparison result{.metric = name_of(samples.metric),
                          .observation = samples.observation,
                          .a = summarise(samples.a),
                          .b = summarise(samples.b)};
  if (!samples.not_compared.empty()) {
    settle(result, Outcome::not_compared, samples.not_compared);
    return result;
  }
  if (!samples.is_counted) {
    settle(result, Outcome::not_counted, "nobody counted");
    return result;
  }
  if (samples.a.empty() || samples.b.empty()) {
    result.ratio.undefined = "no complete run to compare";
    return result;
  }
  if (samples.same_bits) {
    settle(result, Outcome::same, "equal bit for bit");
  } else if (samples.are_copies && result.a.std == 0 && result.b.std == 0) {
    compare_copies(result, samples, question);
  } else if (question.margin > 0 && has_negative(samples)) {
    settle(result, Outcome::not_compared, "negative values, of which a share says nothing; --margin 0 compares them");
  } else if (not_finite(samples.a) + not_finite(samples.b) > 0) {
    compare_not_finite(result, samples, question);
  } else if (are_rounding(samples)) {
    settle(result, Outcome::same,
           fmt::format("both are rounding errors, below {}", short_number(info_of(samples.metric).rounding)));
  } else {
    compare_means(result, samples, question);
  }
  rank(result, samples, 1 - 2 * question.significance);
  return result;
}

}  // namespace ikbench::inference
