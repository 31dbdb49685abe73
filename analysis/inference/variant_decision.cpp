#include "analysis/inference/variant_decision.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "analysis/inference/judge.hpp"
#include "analysis/inference/margin.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/inference/unseen.hpp"
#include "analysis/statistics/p_adjust.hpp"

namespace ikbench::inference {

using namespace statistics;

namespace {

std::string of_constants(const MetricComparison& comparison) {
  const int a = comparison.a.n, b = comparison.b.n;
  const std::string number = a == b ? fmt::format("{}", a) : fmt::format("{} and {}", a, b);
  return comparison.mean_favours == 0
             ? fmt::format("equal in all {} {}s", number, comparison.observation)
             : fmt::format("differs in these {} {}s, but they are too few to decide", number, comparison.observation);
}

// p after Holm's correction.
struct Corrected {
  double worse, better, difference, ranks;
};

// What is known of a metric that no test has decided.
std::string what_is_known(const MetricComparison& comparison, const Corrected& corrected,
                          const MarginQuestion& question) {
  const double alpha = question.significance;
  const std::string_view word = comparison.mean_favours > 0 ? "better" : "worse";
  std::string known = "no difference shown";
  if (comparison.p_worse < alpha || comparison.p_better < alpha) {
    known =
        fmt::format("{} before Holm's correction, but not after it", comparison.p_better < alpha ? "better" : "worse");
  } else if (comparison.a.std == 0 && comparison.b.std == 0 && !(comparison.ratio.p_difference < alpha)) {
    known = of_constants(comparison);
  } else if (!comparison.ratio.undefined.empty()) {
    known = comparison.ratio.undefined;
  } else if (corrected.difference < alpha) {
    const MarginQuestion asked = question_about(comparison.metric, question);
    const bool is_absolute = asked.margin_cm > asked.margin * std::abs(comparison.a.mean);
    known = fmt::format("{}, but perhaps by less than {}", word,
                        margin_words(is_absolute ? 0 : asked.margin, is_absolute ? asked.margin_cm : 0));
  }
  if (!std::isfinite(comparison.n_to_decide)) return known;
  return fmt::format("{}; about {:.0f} {}s a side show a difference of the margin, or that there is none", known,
                     comparison.n_to_decide, comparison.observation);
}

// Where the ranks say other than the means; empty where they do not.
std::string ranks_remark(const MetricComparison& comparison, const Corrected& corrected, double alpha) {
  if (!std::isfinite(corrected.ranks) || !std::isfinite(corrected.difference)) return "";
  const bool by_means = corrected.difference < alpha, by_ranks = corrected.ranks < alpha;
  const std::string p = fmt::format("p {}", short_number(corrected.ranks));
  const std::string_view favoured = comparison.ranks_favour > 0 ? "better" : "worse";
  if (by_means && by_ranks && comparison.ranks_favour == -comparison.mean_favours) {
    return fmt::format("ranks contradict the mean: by ranks B is {} ({})", favoured, p);
  }
  if (by_ranks && comparison.outcome == Outcome::undecided && !by_means) {
    return fmt::format("by ranks B is {} ({})", favoured, p);
  }
  if (!by_ranks && (comparison.outcome == Outcome::worse || comparison.outcome == Outcome::better)) {
    return fmt::format("undecided by ranks ({})", p);
  }
  return "";
}

std::string remark_on(const MetricComparison& comparison, const Corrected& corrected, const MarginQuestion& question) {
  std::vector<std::string> remarks;
  const auto add = [&](std::string remark) {
    if (!remark.empty()) remarks.push_back(std::move(remark));
  };
  add(comparison.remark);
  const bool is_open = comparison.outcome == Outcome::undecided || comparison.outcome == Outcome::not_worse;
  add(is_open ? what_is_known(comparison, corrected, question) : comparison.ratio.undefined);
  constexpr std::array good{Outcome::same, Outcome::better, Outcome::better_by_less};
  if (std::ranges::find(good, comparison.outcome) != good.end()) {
    add(unseen_words(std::min(comparison.a.n, comparison.b.n), fmt::format("{}s", comparison.observation),
                     question.significance));
  }
  add(ranks_remark(comparison, corrected, question.significance));
  return fmt::format("{}", fmt::join(remarks, "; "));
}

Outcome outcome_of(const MetricComparison& comparison, const Corrected& corrected, double alpha) {
  const bool is_small = comparison.ratio.p_equivalent < alpha;
  switch (answer_of({.p_better = corrected.better, .p_worse = corrected.worse, .within_margin = is_small}, alpha)) {
    case Answer::worse:
      return Outcome::worse;
    case Answer::better:
      return Outcome::better;
    case Answer::same:
      if (!(corrected.difference < alpha)) return Outcome::same;
      return comparison.mean_favours > 0 ? Outcome::better_by_less : Outcome::worse_by_less;
    default:
      return comparison.p_not_worse < alpha ? Outcome::not_worse : Outcome::undecided;
  }
}

}  // namespace

void decide(std::span<VariantComparison> comparisons, const MarginQuestion& question) {
  std::vector<MetricComparison*> all;
  for (VariantComparison& comparison : comparisons) {
    for (MetricComparison& metric : comparison.metrics) all.push_back(&metric);
  }
  const auto holm = [&](auto p_of) {
    std::vector<double> p;
    for (const MetricComparison* metric : all) p.push_back(p_of(*metric));
    return adjusted(p, Correction::holm);
  };
  const auto worse = holm([](const MetricComparison&metric) { return metric.p_worse; }),
             better = holm([](const MetricComparison&metric) { return metric.p_better; }),
             difference = holm([](const MetricComparison&metric) { return metric.ratio.p_difference; }),
             ranks = holm([](const MetricComparison&metric) { return metric.p_ranks; });
  for (std::size_t i = 0; i < all.size(); ++i) {
    MetricComparison& metric = *all[i];
    if (metric.is_fact) continue;
    const Corrected corrected{.worse = worse[i], .better = better[i], .difference = difference[i], .ranks = ranks[i]};
    metric.outcome = outcome_of(metric, corrected, question.significance);
    // No more than there are already, and they do not.
    const bool is_open = metric.outcome == Outcome::undecided || metric.outcome == Outcome::not_worse;
    if (is_open && metric.n_to_decide <= std::min(metric.a.n, metric.b.n)) metric.n_to_decide = not_defined;
    metric.remark = remark_on(metric, corrected, question);
    metric.p_worse = corrected.worse;
    metric.p_better = corrected.better;
    metric.ratio.p_difference = corrected.difference;
    metric.p_ranks = corrected.ranks;
  }
}

}  // namespace ikbench::inference
