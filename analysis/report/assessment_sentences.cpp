#include "analysis/report/assessment_sentences.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/inference/deciding.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/assessment_disagreements.hpp"
#include "analysis/report/assessment_doubts.hpp"
#include "analysis/report/assessment_verdicts.hpp"
#include "analysis/report/assessment_words.hpp"
#include "analysis/report/outcome_words.hpp"
#include "analysis/statistics/power.hpp"

namespace ikbench::report {

using namespace statistics;
using namespace inference;

namespace {

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
  for (std::size_t i = 0; i < evidence.groups.size(); ++i) names.push_back(name_words(evidence, i));
  std::string text = fmt::format("Data: {}, {} is better; {} {} ({}) with {} each", evidence.quantity,
                                 evidence.better == Better::smaller ? "smaller" : "larger", names.size(),
                                 names.size() == 1 ? "group" : "groups", listed(names), sizes(evidence));
  text += evidence.from_summaries ? "; only means, standard deviations and sizes are known." : ".";
  if (!evidence.replicate.empty()) text += fmt::format(" One observation is {}.", evidence.replicate);
  if (evidence.scale == ValueScale::log10)
    text += " Tests compare logarithms. So a mean is a geometric mean, and a difference is a ratio.";
  if (evidence.blocks > 0)
    text += fmt::format(" All groups share {} blocks. A block is {}.", evidence.blocks, evidence.block);
  return text;
}

// What so many observations can see, whatever was seen.
std::string sensitivity(const Evidence& evidence) {
  const int n =
      std::ranges::min_element(evidence.groups, {}, [](const GroupEvidence& g) { return g.described.n; })->described.n;
  if (n < 2 || evidence.constant || has_too_few(evidence)) return "";
  const PowerGoal goal{.power = evidence.plan.power,
                       .alpha = evidence.plan.significance / static_cast<double>(evidence.family())};
  const bool in_blocks = evidence.decides_within_blocks();
  return fmt::format(
      " With {} {} a t-test finds differences of at least {} standard deviations{} with {} power; other tests need more.",
      n, replicates_words(evidence),
      rounded_number(in_blocks ? least_mean_difference(n, goal) : least_difference(n, goal), 2),
      in_blocks ? " of the differences" : "", percent(evidence.plan.power));
}

std::string methods(const Evidence& evidence) {
  const std::string_view by = deciding_words(evidence);
  std::string text = fmt::format("Methods: {} decides, at {}", by, rounded_number(evidence.plan.significance, 3));
  if (!evidence.plan.control.empty()) {
    text +=
        fmt::format(", for each group against the control {}", row_label(evidence.plan.control, longest_name_in_text));
  } else if (evidence.pairs > 1) {
    text += fmt::format(", for all {} pairs", evidence.pairs);
  }
  if (!evidence.from_summaries && evidence.ranks_decide() && evidence.pairs > 1) {
    constexpr std::array<std::string_view, 4> whose{"Holm", "Hochberg", "Bonferroni", "Benjamini-Hochberg"};
    text += fmt::format("; p-values are corrected by {}", whose[static_cast<std::size_t>(evidence.plan.adjustment)]);
  }
  return text + "; differences below " + margin_words(evidence) + " do not matter." + sensitivity(evidence);
}

// "F(5, 44.3) = 142, p = 4e-26"
std::string result_words(const TestResult& test) {
  if (!test.undefined.empty()) return "not defined, " + test.undefined;
  std::string df = rounded_number(test.df, 3);
  if (std::isfinite(test.df_within)) df += ", " + rounded_number(test.df_within, 3);
  std::string text = std::isfinite(test.df)
                         ? fmt::format("{}({}) = {}", test.symbol, df, rounded_number(test.statistic, 4))
                         : fmt::format("{} = {}", test.symbol, rounded_number(test.statistic, 4));
  return fmt::format("{}, {}", text, p_words(test.p));
}

std::string assumptions(const Evidence& evidence) {
  std::string text = "Assumptions: ";
  std::vector<std::string> tests;
  for (const TestResult& each : evidence.tests) {
    if (each.role == Role::assumption) tests.push_back(fmt::format("{}: {}", each.test, result_words(each)));
  }
  if (tests.empty()) return "";
  const TestResult* test = variance_test(evidence);
  const bool tested = test != nullptr && test->undefined.empty();
  text += !tested                      ? "equal variances cannot be tested"
          : variances_differ(evidence) ? "equal variances are rejected"
                                       : "equal variances are not rejected";
  if (std::isfinite(evidence.variance_ratio)) {
    text += fmt::format("; the variance of {} is {} times that of {}", name_words(evidence, evidence.most_variable),
                        rounded_number(evidence.variance_ratio, 3), name_words(evidence, evidence.least_variable));
  }
  text += fmt::format(" ({}).", fmt::join(tests, "; "));
  if (evidence.from_summaries) return text + " Summaries do not show whether the values are normal.";
  std::vector<std::string> not_normal;
  std::size_t known = 0;
  for (std::size_t i = 0; i < evidence.groups.size(); ++i) {
    const double p = evidence.groups[i].normality;
    known += std::isfinite(p) ? 1 : 0;
    if (p < evidence.plan.significance)
      not_normal.push_back(fmt::format("{} ({})", name_words(evidence, i), p_words(p)));
  }
  if (known == 0)
    return text + " Normality cannot be tested: Shapiro-Wilk takes 3 to 5000 values that are not all equal.";
  if (!not_normal.empty()) {
    return text +
           fmt::format(" Normality is rejected for {} (Shapiro-Wilk, separately for each group).", listed(not_normal));
  }
  return text + fmt::format(" Normality is not rejected for any group{} (Shapiro-Wilk).",
                            known < evidence.groups.size() ? " that can be tested" : "");
}

// Single values over decades: their mean is that of the largest few, and a test of means is a test of those.
std::string decades(const Evidence& evidence) {
  constexpr double wide = 2;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < evidence.groups.size(); ++i) {
    const double span = evidence.groups[i].decades;
    if (span > wide) names.push_back(fmt::format("{} ({})", name_words(evidence, i), rounded_number(span, 2)));
  }
  if (names.empty() || evidence.ranks_decide() || evidence.scale == ValueScale::log10) return "";
  return fmt::format(
      "Caution: the single values of {} span more than two decades (in brackets: nine tenths of them), so the largest "
      "few decide the mean, and a test of means compares the worst cases. Geometric means, A12 and rank tests compare "
      "typical values.",
      listed(names));
}

std::string effect_words(const TestResult& test) {
  return std::isfinite(test.effect) ? fmt::format(", {} = {}", test.effect_symbol, rounded_number(test.effect, 2)) : "";
}

// The planned test of all groups, and then the others.
std::vector<std::string> analyses(const Evidence& evidence) {
  std::string planned, others;
  for (const TestResult& test : evidence.tests) {
    if (test.role == Role::assumption) continue;
    std::string& text = &test == deciding_test(evidence) ? planned : others;
    text += fmt::format(" {}{}: {}{}{}.", test.test, test.without.empty() ? "" : fmt::format(" ({})", test.without),
                        result_words(test), effect_words(test),
                        !test.undefined.empty() ? ""
                        : test.p < evidence.plan.significance
                            ? (evidence.groups.size() == 2 ? "; the groups differ" : "; at least one group differs")
                            : "; no difference is shown");
    if (test.role == Role::paper && variances_differ(evidence))
      text += " It assumes equal variances, which are rejected.";
  }
  return {planned.empty() ? "" : "All groups together:" + planned,
          others.empty() ? "" : "Other tests of all groups, which do not decide:" + others};
}

std::string too_few(const Evidence& evidence) {
  if (!has_too_few(evidence)) return "";
  const auto most = std::ranges::max(evidence.groups, {}, [](const GroupEvidence& g) { return g.described.n; });
  return fmt::format("Caution: no pair can differ by this test. It takes at least {} {}, and here are {}.",
                     evidence.fewest, replicates_words(evidence), most.described.n);
}

std::vector<std::string> limits(const Evidence& evidence) {
  std::vector<std::string> parts;
  std::vector<const Contrast*> open;
  for (const Contrast& contrast : evidence.contrasts) {
    if (contrast.relation == Relation::undecided) open.push_back(&contrast);
  }
  if (!open.empty()) {
    const std::string runs = runs_words(evidence, runs_of_all(open));
    parts.push_back(fmt::format("undecided does not mean equal: {}",
                                runs.empty() ? "a difference remains possible"
                                             : fmt::format("{}, with {} power", runs, percent(evidence.plan.power))));
  }
  if (!evidence.flaw.empty()) parts.push_back("with flawed observations the p-values are no evidence");
  if (evidence.from_summaries)
    parts.push_back("summaries do not show distributions: no ranks, no medians, no normality");
  parts.push_back(
      "the results hold for these conditions only, not for other targets, arms, budgets or settings; each quantity is "
      "judged separately");
  return {fmt::format("What this does not show: {}.", fmt::join(parts, "; "))};
}

}  // namespace

std::vector<std::string> sentences_of(const Evidence& evidence) {
  if (evidence.groups.empty()) return {"There are no groups."};
  std::vector<std::string> sentences;
  if (evidence.groups.size() > 1 && evidence.contrasts.empty()) {
    sentences.emplace_back(
        "Not judged: the observations are described, but the groups are not ranked, tested or compared. The note below "
        "the table says why.");
    sentences.push_back(design(evidence));
    for (const std::string& note : evidence.notes) sentences.push_back("Note: " + note);
    return sentences;
  }
  if (!evidence.flaw.empty()) sentences.push_back(flaw_words(evidence));
  if (std::string words = in_short(evidence); !words.empty()) sentences.push_back("In short: " + words);
  if (std::string words = change_words(evidence); !words.empty()) sentences.push_back(std::move(words));
  sentences.push_back(design(evidence));
  for (const std::string& note : evidence.notes) sentences.push_back("Note: " + note);
  if (evidence.of_outcomes) sentences.push_back(shares_words(evidence));
  if (evidence.groups.size() < 2) {
    sentences.push_back("There is only one group, so there is nothing to compare.");
    return sentences;
  }
  if (evidence.constant) {
    for (std::string& sentence : who_differs(evidence)) sentences.push_back(std::move(sentence));
    sentences.push_back(
        fmt::format("All values within a group are equal. p comes from {}. If a quantity is fixed by design, such as a "
                    "budget of evaluations, its difference is a fact and needs no test.",
                    test_of_constants_words(evidence)));
    return sentences;
  }
  if (has_single_values(evidence)) return sentences;
  sentences.push_back(evidence.of_outcomes ? outcome_methods_words(evidence) : methods(evidence));
  sentences.push_back(too_few(evidence));
  sentences.push_back(assumptions(evidence));
  sentences.push_back(decades(evidence));
  for (std::string& sentence : analyses(evidence)) sentences.push_back(std::move(sentence));
  for (std::string& sentence : who_differs(evidence)) sentences.push_back(std::move(sentence));
  sentences.push_back(disagreements(evidence));
  for (std::string& sentence : limits(evidence)) sentences.push_back(std::move(sentence));
  std::erase(sentences, "");
  return sentences;
}

std::vector<std::string> headlines_of(const Evidence& evidence) {
  const std::string words = in_short(evidence);
  if (words.empty()) return {};
  return {evidence.flaw.empty() ? fmt::format("{}: {}", evidence.quantity, words)
                                : fmt::format("{} ({}): {}", evidence.quantity, flaw_words(evidence), words)};
}

}  // namespace ikbench::report
