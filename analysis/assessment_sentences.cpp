// The words of an assessment: what a good reviewer would ask, answered in order.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include "analysis/assessment.hpp"
#include "analysis/row_chart.hpp"
#include "analysis/text.hpp"

namespace ikbench {
namespace {

constexpr std::size_t most_named = 8;  // in one sentence
constexpr std::size_t longest_name = 60;
constexpr double unequal_variances = 4;  // largest by smallest, from which a pooled variance is named as a danger

// Three digits, and all digits before the point.
std::string number(double value) {
  const double size = std::abs(value);
  return size >= 1000 && size < 1e7 ? fmt::format("{:.0f}", value) : rounded_number(value, 3);
}

std::string p_words(double p) {
  if (p < 1e-300) return "p < 1e-300";
  return p > 0.9995 ? "p > 0.999" : fmt::format("p = {}", rounded_number(p, 3));
}

// "a, b and c"; of many the first, and how many more.
std::string listed(const std::vector<std::string>& items) {
  std::string text;
  const std::size_t shown = items.size() > most_named + 1 ? most_named : items.size();
  for (std::size_t i = 0; i < shown; ++i) {
    const bool last = i + 1 == items.size();
    text += fmt::format("{}{}", i == 0 ? "" : last ? " and " : ", ", items[i]);
  }
  return shown == items.size() ? text : fmt::format("{} and {} more", text, items.size() - shown);
}

// The same of clauses that have commas themselves.
std::string clauses(const std::vector<std::string>& items) {
  const std::size_t shown = items.size() > most_named + 1 ? most_named : items.size();
  const auto first = items.begin(), end = first + static_cast<std::ptrdiff_t>(shown);
  const std::string text = fmt::format("{}", fmt::join(first, end, "; "));
  return shown == items.size() ? text : fmt::format("{}; and {} more", text, items.size() - shown);
}

std::string name(const Evidence& evidence, std::size_t group) {
  return row_label(evidence.groups[group].name, longest_name);
}

std::string pair_words(const Evidence& evidence, const Contrast& contrast) {
  return fmt::format("{} and {}", name(evidence, contrast.first), name(evidence, contrast.second));
}

std::string flawed(const Evidence& evidence) {
  return fmt::format("Flawed: {}{}", evidence.flaw, evidence.flaw.ends_with('.') ? "" : ".");
}

// "20 observations", "18 to 20 observations"
std::string sizes(const Evidence& evidence) {
  const auto [least, most] =
      std::ranges::minmax(evidence.groups, {}, [](const GroupEvidence& group) { return group.described.n; });
  if (least.described.n == most.described.n) {
    return fmt::format("{} {}", most.described.n, most.described.n == 1 ? "observation" : "observations");
  }
  return fmt::format("{} to {} observations", least.described.n, most.described.n);
}

std::string design(const Evidence& evidence) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < evidence.groups.size(); ++i) names.push_back(name(evidence, i));
  std::string text = fmt::format("What was compared: {}, {} is better, of {} {} ({}) with {} each", evidence.quantity,
                                 evidence.better == Better::smaller ? "smaller" : "larger", names.size(),
                                 names.size() == 1 ? "group" : "groups", listed(names), sizes(evidence));
  text += evidence.from_summaries ? ", of which means, standard deviations and numbers alone are known." : ".";
  if (!evidence.replicate.empty()) text += fmt::format(" One observation is {}.", evidence.replicate);
  if (evidence.blocks > 0)
    text +=
        fmt::format(" All groups were given the same in {} blocks: a block is {}.", evidence.blocks, evidence.block);
  return text;
}

std::string methods(const Evidence& evidence) {
  std::string text = fmt::format("Methods: {} decides, at {}", words_of(evidence.plan.test),
                                 rounded_number(evidence.plan.significance, 3));
  if (!evidence.plan.control.empty()) {
    text += fmt::format(", each against the control {}", row_label(evidence.plan.control, longest_name));
  } else if (evidence.pairs > 1) {
    text += fmt::format(", over all {} pairs", evidence.pairs);
  }
  if (!evidence.from_summaries && evidence.pairs > 1) {
    constexpr std::array<std::string_view, 4> whose{"Holm", "Hochberg", "Bonferroni", "Benjamini and Hochberg"};
    text += fmt::format("; p-values of ranks are corrected by {}",
                        whose[static_cast<std::size_t>(evidence.plan.adjustment)]);
  }
  return text + "; a difference matters from " + percent(evidence.plan.margin) +
         " on. The other methods stand beside it and decide nothing.";
}

// "F(5, 44.3) = 142, p = 4e-26"
std::string result_words(const TestResult& test) {
  if (!test.undefined.empty()) return "not defined, " + test.undefined;
  std::string df = number(test.df);
  if (std::isfinite(test.df_within)) df += ", " + number(test.df_within);
  std::string text = std::isfinite(test.df)
                         ? fmt::format("{}({}) = {}", test.symbol, df, rounded_number(test.statistic, 4))
                         : fmt::format("{} = {}", test.symbol, rounded_number(test.statistic, 4));
  return fmt::format("{}, {}", text, p_words(test.p));
}

bool variances_differ(const Evidence& evidence) {
  for (const TestResult& test : evidence.tests) {
    if (test.role == Role::assumption && test.p < evidence.plan.significance) return true;
  }
  return false;
}

// Unequal by more than a small sample's chance.
bool pooling_misleads(const Evidence& evidence) {
  const double ratio = evidence.variance_ratio;
  return std::isinf(ratio) || (ratio > unequal_variances && variances_differ(evidence));
}

std::string assumptions(const Evidence& evidence) {
  std::string text = "Assumptions: ";
  std::vector<std::string> tests;
  for (const TestResult& test : evidence.tests) {
    if (test.role == Role::assumption) tests.push_back(fmt::format("{}: {}", test.test, result_words(test)));
  }
  if (tests.empty()) return "";
  const bool tested = std::ranges::any_of(
      evidence.tests, [](const TestResult& test) { return test.role == Role::assumption && test.undefined.empty(); });
  text += !tested                      ? "equal variances could not be tested"
          : variances_differ(evidence) ? "equal variances do not hold"
                                       : "equal variances are not refuted";
  if (std::isfinite(evidence.variance_ratio)) {
    text += fmt::format("; that of {} is {} times that of {}", name(evidence, evidence.most_variable),
                        number(evidence.variance_ratio), name(evidence, evidence.least_variable));
  }
  text += fmt::format(" ({}).", fmt::join(tests, "; "));
  if (evidence.from_summaries) return text + " Whether the values are normal cannot be told from summaries.";
  std::vector<std::string> not_normal;
  std::size_t known = 0;
  for (std::size_t i = 0; i < evidence.groups.size(); ++i) {
    const double p = evidence.groups[i].normality;
    known += std::isfinite(p) ? 1 : 0;
    if (p < evidence.plan.significance) not_normal.push_back(fmt::format("{} ({})", name(evidence, i), p_words(p)));
  }
  if (known == 0) return text + " Normality could not be tested.";
  if (!not_normal.empty()) {
    return text + fmt::format(" Normality does not hold for {} (Shapiro-Wilk).", listed(not_normal));
  }
  return text + fmt::format(" Normality is not refuted for any group{} (Shapiro-Wilk).",
                            known < evidence.groups.size() ? " that could be tested" : "");
}

std::string effect_words(const TestResult& test) {
  return std::isfinite(test.effect) ? fmt::format(", {} = {}", test.effect_symbol, rounded_number(test.effect, 2)) : "";
}

std::string analyses(const Evidence& evidence, Role role, std::string_view heading) {
  std::string text;
  for (const TestResult& test : evidence.tests) {
    if (test.role != role) continue;
    text += fmt::format(" {}: {}{}{}.", test.test, result_words(test), effect_words(test),
                        !test.undefined.empty()               ? ""
                        : test.p < evidence.plan.significance ? "; the groups are not all the same"
                                                              : "; a difference is not shown");
  }
  if (text.empty()) return "";
  if (role == Role::paper && variances_differ(evidence))
    text += " It takes equal variances for granted, and they are not.";
  return fmt::format("{}:{}", heading, text);
}

// "IK-BA is better than DE: 0.00190 against 0.365, difference -0.363 (95 % interval ...), p = ..., A12 = 0.98"
std::string better_words(const Evidence& evidence, const Contrast& contrast) {
  const bool first = contrast.relation == Relation::first_better;
  const std::size_t winner = first ? contrast.first : contrast.second, loser = first ? contrast.second : contrast.first;
  const auto mean_of = [&](std::size_t i) { return number(evidence.groups[i].described.mean); };
  std::string text = fmt::format("{} is better than {}: {} against {}", name(evidence, winner), name(evidence, loser),
                                 mean_of(winner), mean_of(loser));
  if (std::isfinite(contrast.difference.low)) {
    const double low = std::min(std::abs(contrast.difference.low), std::abs(contrast.difference.high));
    const double high = std::max(std::abs(contrast.difference.low), std::abs(contrast.difference.high));
    const bool includes_zero = contrast.difference.low < 0 && contrast.difference.high > 0;
    const bool first_by_mean = (contrast.difference.value < 0) == (evidence.better == Better::smaller);
    text += first_by_mean != first ? ", though not by the mean"
            : includes_zero        ? ", though the interval of the difference of means includes zero"
            : low == high          ? fmt::format(", by {}", number(low))
                                   : fmt::format(", by {} to {}", number(low), number(high));
  }
  if (contrast.within_margin) text += fmt::format(", which is less than {}", percent(evidence.plan.margin));
  if (std::isfinite(contrast.p)) text += ", " + p_words(contrast.p);
  if (std::isfinite(contrast.superiority.value)) {
    const double chance = first ? contrast.superiority.value : 1 - contrast.superiority.value;
    text +=
        fmt::format(", ahead in {} of {}", percent(chance), evidence.blocks > 0 ? "blocks" : "pairs of observations");
  }
  return text;
}

// The group that the planned test puts first: by average ranks where they decide, else by the mean.
std::size_t best_group(const Evidence& evidence) {
  std::size_t best = 0;
  const auto worth = [&](const GroupEvidence& group) {
    if (evidence.plan.test == DecidingTest::friedman) return group.average_rank;
    return evidence.better == Better::smaller ? group.described.mean : -group.described.mean;
  };
  for (std::size_t i = 1; i < evidence.groups.size(); ++i) {
    if (worth(evidence.groups[i]) < worth(evidence.groups[best]) || !std::isfinite(worth(evidence.groups[best])))
      best = i;
  }
  return best;
}

// "10 of the 15 pairs differ. IK-BA is better than BA: ..."; of pairs with the best, or of the others where none of
// those differs.
std::string who_differs_words(const Evidence& evidence, const std::vector<std::string>& with_best,
                              const std::vector<std::string>& of_others) {
  const std::size_t pairs = evidence.contrasts.size(), differ = with_best.size() + of_others.size();
  const std::string best = name(evidence, evidence.reference.value_or(best_group(evidence)));
  if (pairs == 1) return differ == 1 ? with_best.front() : "a difference is not shown";
  const std::string of = evidence.reference ? fmt::format("pairs with {}", best) : "pairs";
  if (differ == 0) return fmt::format("none of the {} {} is shown to differ", pairs, of);
  return fmt::format("{} of the {} {} {}. {}{}", differ, pairs, of, differ == 1 ? "differs" : "differ",
                     with_best.empty() ? fmt::format("No pair with {} is among them: ", best) : "",
                     clauses(with_best.empty() ? of_others : with_best));
}

std::vector<std::string> who_differs(const Evidence& evidence) {
  if (evidence.contrasts.empty()) return {};
  const std::size_t best = evidence.reference.value_or(best_group(evidence));
  std::vector<std::string> with_best, of_others, others_open, same, undefined;
  for (const Contrast& contrast : evidence.contrasts) {
    const bool decided = contrast.relation == Relation::first_better || contrast.relation == Relation::second_better;
    const bool of_best = contrast.first == best || contrast.second == best;
    if (decided) (of_best ? with_best : of_others).push_back(better_words(evidence, contrast));
    if (contrast.relation == Relation::not_told_apart) {
      others_open.push_back(
          fmt::format("{} ({}{})", pair_words(evidence, contrast), p_words(contrast.p),
                      std::isfinite(contrast.difference.low)
                          ? fmt::format("; the difference is between {} and {}", number(contrast.difference.low),
                                        number(contrast.difference.high))
                          : ""));
    }
    if (contrast.relation == Relation::equivalent) same.push_back(pair_words(evidence, contrast));
    if (contrast.relation == Relation::undefined) {
      undefined.push_back(fmt::format("{} ({})", pair_words(evidence, contrast), contrast.undefined));
    }
  }
  std::vector<std::string> sentences;
  sentences.push_back(fmt::format("Who differs: {}.", who_differs_words(evidence, with_best, of_others)));
  if (!same.empty())
    sentences.push_back(fmt::format("The same within {}: {}.", percent(evidence.plan.margin), listed(same)));
  if (!others_open.empty()) sentences.push_back(fmt::format("Not told apart: {}.", listed(others_open)));
  if (!undefined.empty()) sentences.push_back(fmt::format("Not defined: {}.", listed(undefined)));
  return sentences;
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
        .push_back(fmt::format("{} ({} against {})", pair_words(evidence, contrast), p_words(p), p_words(other)));
  }
  return result;
}

void add_dispute(std::vector<std::string>& parts, const Dispute& found, std::string_view here, std::string_view there) {
  if (!found.only_here.empty())
    parts.push_back(fmt::format("{} separates {}; {} does not", here, listed(found.only_here), there));
  if (!found.only_there.empty())
    parts.push_back(fmt::format("{} does not separate {}; {} does", here, listed(found.only_there), there));
}

// The deciding test of all groups together; null where it was not made.
const TestResult* deciding_test(const Evidence& evidence) {
  switch (evidence.plan.test) {
    case DecidingTest::anova:
      return evidence.test("One-way ANOVA");
    case DecidingTest::kruskal_wallis:
      return evidence.test("Kruskal and Wallis' test");
    case DecidingTest::friedman:
      return evidence.test("Iman and Davenport's form of it");
    default:
      return evidence.test("Welch's ANOVA");
  }
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
  return all_differ
             ? fmt::format("All groups together differ ({}), and no pair by itself: which ones is not shown",
                           p_words(together->p))
             : fmt::format("Some pairs differ, and all groups together are not shown to ({})", p_words(together->p));
}

std::string disagreements(const Evidence& evidence) {
  const bool comparable = std::ranges::any_of(evidence.contrasts, [](const Contrast& c) {
    return (std::isfinite(c.p_unpooled) && (std::isfinite(c.p_pooled) || std::isfinite(c.p_ranks))) ||
           (std::isfinite(c.p_paired) && std::isfinite(c.p_ranks));
  });
  if (!comparable) return "";
  std::vector<std::string> parts;
  Dispute pooled;
  if (evidence.blocks > 0) {
    add_dispute(parts, dispute(evidence, &Contrast::p_paired, &Contrast::p_ranks),
                "The paired t, of means within blocks,", "Friedman's test, of ranks,");
  } else {
    pooled = dispute(evidence, &Contrast::p_pooled, &Contrast::p_unpooled);
    add_dispute(parts, pooled, "Tukey, with one variance for all,", "Games-Howell, with each group's own,");
    add_dispute(parts, dispute(evidence, &Contrast::p_unpooled, &Contrast::p_ranks), "Games-Howell, of means,",
                "Dunn's test, of ranks,");
  }
  if (std::string words = together_or_apart(evidence); !words.empty()) parts.push_back(std::move(words));
  if (parts.empty()) return "Where methods disagree: nowhere do they come to another verdict.";
  std::string text = fmt::format("Where methods disagree: {}.", fmt::join(parts, ". "));
  const bool pooling = !pooled.only_here.empty() || !pooled.only_there.empty();
  if (pooling && pooling_misleads(evidence)) {
    const std::string least = name(evidence, evidence.least_variable);
    text += fmt::format(
        " Tukey's one variance is dominated by {}, {}: where variances are so unequal, Games-Howell is the one to "
        "believe.",
        name(evidence, evidence.most_variable),
        std::isfinite(evidence.variance_ratio)
            ? fmt::format("whose own is {} times that of {}", number(evidence.variance_ratio), least)
            : fmt::format("while {} has none", least));
  }
  return text;
}

std::vector<std::string> limits(const Evidence& evidence) {
  std::vector<std::string> parts;
  double most = 0;
  std::size_t open = 0;
  for (const Contrast& contrast : evidence.contrasts) {
    if (contrast.relation != Relation::not_told_apart) continue;
    ++open;
    if (std::isfinite(contrast.runs_to_see_margin)) most = std::max(most, contrast.runs_to_see_margin);
  }
  if (open > 0) {
    parts.push_back(fmt::format(
        "not told apart is not the same: {}",
        most > 0 ? fmt::format("to find a difference of {} with {} certainty in {}, a group "
                               "needs {}{:.0f} observations",
                               percent(evidence.plan.margin), percent(evidence.plan.power),
                               open == 1 ? "that pair" : "each of those pairs", open == 1 ? "" : "up to ", most)
                 : "the data allow for a difference"));
  }
  if (!evidence.flaw.empty()) parts.push_back("the p-values are no evidence where the observations are flawed");
  if (evidence.from_summaries)
    parts.push_back("summaries say nothing of the distributions: no ranks, no medians, no normality");
  parts.push_back(
      "it speaks of these conditions alone, not of other targets, arms, budgets or settings; and each quantity is "
      "judged by itself");
  return {fmt::format("What this does not show: {}.", fmt::join(parts, "; "))};
}

}  // namespace

std::vector<std::string> sentences_of(const Evidence& evidence) {
  if (evidence.groups.empty()) return {"There is no group."};
  std::vector<std::string> sentences;
  if (!evidence.flaw.empty()) sentences.push_back(flawed(evidence));
  sentences.push_back(design(evidence));
  for (const std::string& note : evidence.notes) sentences.push_back("Note: " + note);
  if (evidence.groups.size() < 2) {
    sentences.push_back("One group alone: it is described, and there is nothing to compare it with.");
    return sentences;
  }
  if (evidence.constant) {
    for (std::string& sentence : who_differs(evidence)) sentences.push_back(std::move(sentence));
    sentences.push_back("Every group has one value alone: this is a fact of these data, and no test is needed.");
    return sentences;
  }
  sentences.push_back(methods(evidence));
  sentences.push_back(assumptions(evidence));
  sentences.push_back(analyses(evidence, Role::paper, "The paper's analysis"));
  sentences.push_back(analyses(evidence, Role::sound, "The sound analysis"));
  for (std::string& sentence : who_differs(evidence)) sentences.push_back(std::move(sentence));
  sentences.push_back(disagreements(evidence));
  for (std::string& sentence : limits(evidence)) sentences.push_back(std::move(sentence));
  std::erase(sentences, "");
  return sentences;
}

// Of the best (or the control): from whom it differs, and from whom not; and where a pooled variance would say another
// thing.
std::vector<std::string> headlines_of(const Evidence& evidence) {
  if (evidence.contrasts.empty()) return {};
  const std::size_t best = evidence.reference.value_or(best_group(evidence));
  std::vector<std::string> ahead, behind, open, same;
  std::size_t differ = 0;
  double largest_p = 0;
  for (const Contrast& contrast : evidence.contrasts) {
    const bool decided = contrast.relation == Relation::first_better || contrast.relation == Relation::second_better;
    differ += decided ? 1 : 0;
    if (contrast.first != best && contrast.second != best) continue;
    const bool is_first = contrast.first == best;
    const std::string other = name(evidence, is_first ? contrast.second : contrast.first);
    if (decided) {
      const bool wins = is_first == (contrast.relation == Relation::first_better);
      (wins ? ahead : behind).push_back(other);
      if (std::isfinite(contrast.p)) largest_p = std::max(largest_p, contrast.p);
    }
    if (contrast.relation == Relation::not_told_apart) open.push_back(other);
    if (contrast.relation == Relation::equivalent) same.push_back(other);
  }
  std::vector<std::string> parts;
  if (!ahead.empty()) parts.push_back(fmt::format("{} is better than {}", name(evidence, best), listed(ahead)));
  if (!behind.empty()) parts.push_back(fmt::format("{} is worse than {}", name(evidence, best), listed(behind)));
  if (!parts.empty() && largest_p > 0) {
    parts.back() += ahead.size() + behind.size() == 1 ? fmt::format(" ({})", p_words(largest_p))
                                                      : fmt::format(" (p at most {})", rounded_number(largest_p, 2));
  }
  if (!same.empty()) {
    parts.push_back(fmt::format("{} and {} are the same within {}", name(evidence, best), listed(same),
                                percent(evidence.plan.margin)));
  }
  if (!open.empty()) parts.push_back(fmt::format("{} is not told apart from {}", name(evidence, best), listed(open)));
  const Dispute pooled =
      evidence.blocks > 0 ? Dispute{} : dispute(evidence, &Contrast::p_pooled, &Contrast::p_unpooled);
  if (pooling_misleads(evidence) && !pooled.only_there.empty()) {
    parts.push_back(fmt::format("one variance for all (ANOVA, Tukey) would hide {}", listed(pooled.only_there)));
  }
  if (parts.empty()) parts.push_back(fmt::format("no pair with {} could be judged", name(evidence, best)));
  if (evidence.contrasts.size() > 1)
    parts.push_back(fmt::format("{} of {} pairs differ", differ, evidence.contrasts.size()));
  return {fmt::format(
      "{}: {}{}.{}", evidence.quantity, fmt::join(parts, "; "),
      evidence.constant ? ", where no test is needed" : fmt::format(", by {}", words_of(evidence.plan.test)),
      evidence.flaw.empty() ? "" : fmt::format(" {}", flawed(evidence)))};
}

}  // namespace ikbench
