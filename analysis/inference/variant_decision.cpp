#include "analysis/inference/variant_decision.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <vector>

#include "analysis/inference/judge.hpp"
#include "analysis/inference/text.hpp"
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

// What is known of a metric that no test has decided.
std::string what_is_known(const MetricComparison& comparison, const MarginQuestion& question) {
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
  } else if (comparison.ratio.p_difference < alpha) {
    known = fmt::format("{}, but perhaps by less than {}", word, percent(question.margin));
  }
  if (!std::isfinite(comparison.n_to_decide)) return known;
  return fmt::format("{}; about {:.0f} {}s would decide", known, comparison.n_to_decide, comparison.observation);
}

// Where the ranks say other than the means; empty where they do not.
std::string ranks_remark(const MetricComparison& comparison, double alpha) {
  if (!std::isfinite(comparison.p_ranks) || !std::isfinite(comparison.ratio.p_difference)) return "";
  const bool by_means = comparison.ratio.p_difference < alpha, by_ranks = comparison.p_ranks < alpha;
  const std::string p = fmt::format("p {}", short_number(comparison.p_ranks));
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

std::string remark_on(const MetricComparison& comparison, const MarginQuestion& question) {
  std::vector<std::string> remarks;
  const auto add = [&](std::string remark) {
    if (!remark.empty()) remarks.push_back(std::move(remark));
  };
  add(comparison.remark);
  const bool is_open = comparison.outcome == Outcome::undecided || comparison.outcome == Outcome::not_worse;
  add(is_open ? what_is_known(comparison, question) : comparison.ratio.undefined);
  add(ranks_remark(comparison, question.significance));
  return fmt::format("{}", fmt::join(remarks, "; "));
}

}  // namespace

void decide(std::span<MetricComparison> comparisons, const MarginQuestion& question) {
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
    const Answer answer = answer_of(
        {.p_better = better[i], .p_worse = worse[i], .within_margin = comparison.ratio.p_equivalent < alpha}, alpha);
    comparison.outcome = answer == Answer::worse          ? Outcome::worse
                         : answer == Answer::better       ? Outcome::better
                         : answer == Answer::same         ? Outcome::same
                         : comparison.p_not_worse < alpha ? Outcome::not_worse
                                                          : Outcome::undecided;
    comparison.remark = remark_on(comparison, question);
    comparison.p_worse = worse[i];
    comparison.p_better = better[i];
  }
}

}  // namespace ikbench::inference
