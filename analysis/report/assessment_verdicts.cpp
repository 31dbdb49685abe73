#include "analysis/report/assessment_verdicts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/inference/text.hpp"
#include "analysis/report/assessment_words.hpp"
#include "analysis/statistics/rounding.hpp"

namespace ikbench::report {

using namespace statistics;
using namespace inference;

namespace {

// "0.0019 against 0.365", with as many digits as tell them apart.
std::string against(double mean, double other) {
  if (!std::isfinite(mean) || !std::isfinite(other)) {
    const auto words = [](double value) { return std::isfinite(value) ? number_words(value) : std::string("no mean"); };
    return fmt::format("{} vs {}", words(mean), words(other));
  }
  std::string one = number_words(mean), two = number_words(other);
  for (int digits = 4; one == two && digits <= 12; ++digits) {
    one = rounded_number(mean, digits);
    two = rounded_number(other, digits);
  }
  return fmt::format("{} vs {}", one, two);
}

// What says that the other of a pair is better than the one for which the deciding test is.
struct Dissent {
  bool mean = false, median = false, share = false;
};

Dissent dissent(const Evidence& evidence, const Contrast& contrast) {
  const Description& first = evidence.groups[contrast.first].described;
  const Description& second = evidence.groups[contrast.second].described;
  const auto is_against = [&](double for_first) { return sign_of(for_first) == -contrast.ahead; };
  const auto is_smaller_against = [&](double of_first, double of_second) {
    const double difference = without_rounding(of_second - of_first, std::max(std::abs(of_first), std::abs(of_second)));
    return is_against(evidence.better == Better::smaller ? difference : -difference);
  };
  return {.mean = is_smaller_against(first.mean, second.mean),
          .median = is_smaller_against(first.median, second.median),
          .share = is_against(contrast.superiority.value - 0.5)};
}

// "the median and A12 point the other way"; empty where nothing does.
std::string dissent_words(const Evidence& evidence, const Dissent& dissent) {
  std::vector<std::string> measures;
  if (dissent.mean) measures.emplace_back("the mean");
  if (dissent.median) measures.emplace_back("the median");
  if (dissent.share) measures.emplace_back(evidence.blocks > 0 ? "the share of blocks" : "A12");
  if (measures.empty()) return "";
  return fmt::format("{} {} the other", listed(measures), measures.size() == 1 ? "favours" : "favour");
}

// ", by 0.1 to 0.5, though the median points the other way". An interval around a mean that does is left out.
std::string extent_words(const Evidence& evidence, const Contrast& contrast) {
  const Dissent found = dissent(evidence, contrast);
  std::string text;
  std::vector<std::string> doubts;
  if (std::isfinite(contrast.difference.low) && !found.mean) {
    const double low = std::min(std::abs(contrast.difference.low), std::abs(contrast.difference.high));
    const double high = std::max(std::abs(contrast.difference.low), std::abs(contrast.difference.high));
    if (contrast.difference.low < 0 && contrast.difference.high > 0) {
      doubts.emplace_back("the interval of the difference between means includes zero");
    } else {
      text = number_words(low) == number_words(high)
                 ? fmt::format(", by {}", number_words(low))
                 : fmt::format(", by {} to {}", number_words(low), number_words(high));
    }
  }
  if (std::string words = dissent_words(evidence, found); !words.empty()) doubts.push_back(std::move(words));
  return doubts.empty() ? text : fmt::format("{}, although {}", text, fmt::join(doubts, " and "));
}

// "IK-BA is better than DE: 0.00190 against 0.365, difference -0.363 (95 % interval ...), p = ..., A12 = 0.98"
std::string better_words(const Evidence& evidence, const Contrast& contrast) {
  const bool first = contrast.relation == Relation::first_better;
  const std::size_t winner = first ? contrast.first : contrast.second, loser = first ? contrast.second : contrast.first;
  std::string text =
      fmt::format("{} is better than {}: {}", name_words(evidence, winner), name_words(evidence, loser),
                  against(evidence.groups[winner].described.mean, evidence.groups[loser].described.mean));
  text += extent_words(evidence, contrast);
  if (contrast.within_margin) text += fmt::format(", which is within the margin of {}", percent(evidence.plan.margin));
  if (std::isfinite(contrast.p)) text += ", " + p_words(contrast.p);
  if (std::isfinite(contrast.superiority.value)) {
    const double chance = first ? contrast.superiority.value : 1 - contrast.superiority.value;
    text +=
        fmt::format(", ahead in {} of {}", percent(chance), evidence.blocks > 0 ? "blocks" : "pairs of observations");
  }
  return text;
}

// "10 of the 15 pairs differ. IK-BA is better than BA: ..."; of pairs with the best, or of the others where none of
// those differs.
std::string who_differs_words(const Evidence& evidence, const std::vector<std::string>& with_best,
                              const std::vector<std::string>& of_others) {
  const std::size_t pairs = evidence.contrasts.size(), differ = with_best.size() + of_others.size();
  const std::string best = name_words(evidence, evidence.reference.value_or(best_group(evidence)));
  if (pairs == 1) return differ == 1 ? with_best.front() : "no difference is shown";
  const std::string of = evidence.reference ? fmt::format("pairs with {}", best) : "pairs";
  if (differ == 0) return fmt::format("no difference is shown in any of the {} {}", pairs, of);
  return fmt::format("{} of the {} {} {}. {}{}", differ, pairs, of, differ == 1 ? "differs" : "differ",
                     with_best.empty() ? fmt::format("None of them includes {}: ", best) : "",
                     clauses(with_best.empty() ? of_others : with_best));
}

// Pairs that one method separates and the other does not, with both p-values.
struct Dispute {
  std::vector<std::string> only_here, only_there;
};

Dispute dispute(const Evidence& evidence, double Contrast::*here, double Contrast::*there) {
  Dispute result;
  const double alpha = evidence.plan.significance;
  for (const Contrast& contrast : evidence.contrasts) {
    const double p = contrast.*here, other = contrast.*there;
    if (!std::isfinite(p) || !std::isfinite(other) || (p < alpha) == (other < alpha)) continue;
    (p < alpha ? result.only_here : result.only_there)
        .push_back(fmt::format("{} ({} vs {})", pair_words(evidence, contrast), p_words(p), p_words(other)));
  }
  return result;
}

void add_dispute(std::vector<std::string>& parts, const Dispute& found, std::string_view here, std::string_view there) {
  if (!found.only_here.empty())
    parts.push_back(fmt::format("{} separates {}; {} does not", here, listed(found.only_here), there));
  if (!found.only_there.empty())
    parts.push_back(fmt::format("{} does not separate {}; {} does", here, listed(found.only_there), there));
}

// All groups together against pair by pair, where all pairs are there.
std::string together_or_apart(const Evidence& evidence) {
  const TestResult* together = deciding_test(evidence);
  if (together == nullptr || !std::isfinite(together->p) || evidence.reference || evidence.pairs == 1) return "";
  const bool all_differ = together->p < evidence.plan.significance;
  const bool some_pair = std::ranges::any_of(evidence.contrasts, [](const Contrast& contrast) {
    return contrast.relation == Relation::first_better || contrast.relation == Relation::second_better;
  });
  if (all_differ == some_pair) return "";
  return all_differ ? fmt::format("The test of all groups finds a difference ({}), but no pair differs on its own",
                                  p_words(together->p))
                    : fmt::format("Some pairs differ, but the test of all groups shows no difference ({})",
                                  p_words(together->p));
}

// What is known of two that are not told apart.
std::string open_words(const Contrast& contrast) {
  if (contrast.p == 1 && contrast.difference.value == 0 && !std::isfinite(contrast.difference.low)) {
    return "all observations are equal, but there are too few to call the groups the same";
  }
  if (!std::isfinite(contrast.difference.low)) return p_words(contrast.p);
  return fmt::format("{}; difference between {} and {}", p_words(contrast.p), number_words(contrast.difference.low),
                     number_words(contrast.difference.high));
}

std::string rank_test_words(const Evidence& evidence) {
  if (evidence.groups.size() == 2) return evidence.ranks_within_blocks() ? "Wilcoxon" : "Mann-Whitney";
  return evidence.ranks_within_blocks() ? "Friedman" : "Dunn";
}

}  // namespace

std::vector<std::string> who_differs(const Evidence& evidence) {
  if (evidence.contrasts.empty()) return {};
  const std::size_t best = evidence.reference.value_or(best_group(evidence));
  std::vector<std::string> with_best, of_others, others_open, same, undefined;
  for (const Contrast& contrast : evidence.contrasts) {
    const bool decided = contrast.relation == Relation::first_better || contrast.relation == Relation::second_better;
    const bool of_best = contrast.first == best || contrast.second == best;
    if (decided) (of_best ? with_best : of_others).push_back(better_words(evidence, contrast));
    if (contrast.relation == Relation::not_told_apart) {
      others_open.push_back(fmt::format("{} ({})", pair_words(evidence, contrast), open_words(contrast)));
    }
    if (contrast.relation == Relation::equivalent) same.push_back(pair_words(evidence, contrast));
    if (contrast.relation == Relation::undefined) {
      undefined.push_back(fmt::format("{} ({})", pair_words(evidence, contrast), contrast.undefined));
    }
  }
  std::vector<std::string> sentences;
  sentences.push_back(fmt::format("Differences: {}.", who_differs_words(evidence, with_best, of_others)));
  if (!same.empty())
    sentences.push_back(fmt::format("The same within {}: {}.", percent(evidence.plan.margin), listed(same)));
  if (!others_open.empty()) sentences.push_back(fmt::format("Undecided: {}.", listed(others_open)));
  if (!undefined.empty()) sentences.push_back(fmt::format("Not defined: {}.", listed(undefined)));
  return sentences;
}

std::string disagreements(const Evidence& evidence) {
  const bool comparable = std::ranges::any_of(evidence.contrasts, [](const Contrast& c) {
    return (std::isfinite(c.p_unpooled) && (std::isfinite(c.p_pooled) || std::isfinite(c.p_ranks))) ||
           (std::isfinite(c.p_paired) && std::isfinite(c.p_ranks));
  });
  if (!comparable) return "";
  std::vector<std::string> parts;
  const std::string ranks = fmt::format("{} (ranks)", rank_test_words(evidence));
  Dispute pooled;
  if (evidence.ranks_within_blocks()) {
    add_dispute(parts, dispute(evidence, &Contrast::p_paired, &Contrast::p_ranks), "The paired t-test within blocks",
                ranks);
    add_dispute(parts, dispute(evidence, &Contrast::p_ranks, &Contrast::p_nemenyi),
                fmt::format("{} with the planned correction", rank_test_words(evidence)), "Nemenyi");
  }
  if (!evidence.ranks_within_blocks() || !evidence.ranks_decide()) {
    pooled = dispute(evidence, &Contrast::p_pooled, &Contrast::p_unpooled);
    add_dispute(parts, pooled, "Tukey (pooled variance)", "Games-Howell (separate variances)");
    add_dispute(parts, dispute(evidence, &Contrast::p_unpooled, &Contrast::p_ranks), "Games-Howell (means)", ranks);
  }
  if (std::string words = together_or_apart(evidence); !words.empty()) parts.push_back(std::move(words));
  if (parts.empty()) return "Where methods disagree: nowhere; all methods give the same verdicts.";
  std::string text = fmt::format("Where methods disagree: {}.", fmt::join(parts, ". "));
  const bool pooling = !pooled.only_here.empty() || !pooled.only_there.empty();
  if (pooling && pooling_misleads(evidence)) {
    const std::string least = name_words(evidence, evidence.least_variable);
    text += fmt::format(
        " {} dominates Tukey's pooled variance: {}. With variances this unequal, trust Games-Howell rather than Tukey.",
        name_words(evidence, evidence.most_variable),
        std::isfinite(evidence.variance_ratio)
            ? fmt::format("its variance is {} times that of {}", number_words(evidence.variance_ratio), least)
            : fmt::format("{} has no variance", least));
  }
  return text;
}

// Of the best (or the control): from whom it differs, and from whom not; and what a pooled variance would hide.
std::string in_short(const Evidence& evidence) {
  if (evidence.contrasts.empty()) return "";
  const std::size_t best = evidence.reference.value_or(best_group(evidence));
  std::vector<std::string> ahead, behind, open, same;
  std::size_t differ = 0;
  double largest_p = 0;
  for (const Contrast& contrast : evidence.contrasts) {
    const bool decided = contrast.relation == Relation::first_better || contrast.relation == Relation::second_better;
    differ += decided ? 1 : 0;
    if (contrast.first != best && contrast.second != best) continue;
    const bool is_first = contrast.first == best;
    const std::string other = name_words(evidence, is_first ? contrast.second : contrast.first);
    if (decided) {
      const bool wins = is_first == (contrast.relation == Relation::first_better);
      const std::string doubt = dissent_words(evidence, dissent(evidence, contrast));
      (wins ? ahead : behind).push_back(doubt.empty() ? other : fmt::format("{} (although {})", other, doubt));
      if (std::isfinite(contrast.p)) largest_p = std::max(largest_p, contrast.p);
    }
    if (contrast.relation == Relation::not_told_apart) open.push_back(other);
    if (contrast.relation == Relation::equivalent) same.push_back(other);
  }
  std::vector<std::string> parts;
  if (!ahead.empty()) parts.push_back(fmt::format("{} is better than {}", name_words(evidence, best), listed(ahead)));
  if (!behind.empty()) parts.push_back(fmt::format("{} is worse than {}", name_words(evidence, best), listed(behind)));
  if (!parts.empty() && largest_p > 0) {
    parts.back() += ahead.size() + behind.size() == 1 ? fmt::format(" ({})", p_words(largest_p))
                                                      : fmt::format(" (p at most {})", rounded_number(largest_p, 2));
  }
  if (!same.empty()) {
    parts.push_back(fmt::format("{} and {} are the same within {}", name_words(evidence, best), listed(same),
                                percent(evidence.plan.margin)));
  }
  if (!open.empty())
    parts.push_back(fmt::format("{} against {} is undecided", name_words(evidence, best), listed(open)));
  const Dispute pooled =
      evidence.blocks > 0 ? Dispute{} : dispute(evidence, &Contrast::p_pooled, &Contrast::p_unpooled);
  if (pooling_misleads(evidence) && !pooled.only_there.empty()) {
    parts.push_back(
        fmt::format("a pooled-variance test would miss the difference between {}", listed(pooled.only_there)));
  }
  if (parts.empty()) parts.push_back(fmt::format("no pair with {} can be judged", name_words(evidence, best)));
  if (evidence.contrasts.size() > 1)
    parts.push_back(fmt::format("{} of {} pairs differ", differ, evidence.contrasts.size()));
  return fmt::format("{}{}.", fmt::join(parts, "; "),
                     evidence.constant ? "" : fmt::format(", by {}", deciding_words(evidence)));
}

}  // namespace ikbench::report
