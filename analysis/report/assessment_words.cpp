#include "analysis/report/assessment_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "analysis/inference/margin.hpp"
#include "analysis/inference/method.hpp"
#include "analysis/inference/outcomes.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/words.hpp"

namespace ikbench::report {

using namespace inference;
using namespace fmt::literals;

namespace {

constexpr std::size_t most_named = 8;  // most items listed in one sentence

}  // namespace

std::string p_words(double p) {
  if (p < 1e-300) return "p < 1e-300";
  return p > 0.9995 ? "p > 0.999" : fmt::format("p = {}", rounded_number(p, 3));
}

std::string against(double mean, double other) {
  std::string one = rounded_number(mean, 3), two = rounded_number(other, 3);
  for (int digits = 4; one == two && digits <= 12; ++digits) {
    one = rounded_number(mean, digits);
    two = rounded_number(other, digits);
  }
  return fmt::format("{} vs {}", one, two);
}

std::string at_most(double p) {
  const double unit = std::pow(10, std::floor(std::log10(p)) - 1);
  return rounded_number(std::ceil(p / unit) * unit, 2);
}

std::string listed(const std::vector<std::string>& items) {
  std::string text;
  const std::size_t shown = items.size() > most_named + 1 ? most_named : items.size();
  for (std::size_t i = 0; i < shown; ++i) {
    const bool last = i + 1 == items.size();
    text += fmt::format("{}{}", i == 0 ? "" : last ? " and " : ", ", items[i]);
  }
  return shown == items.size() ? text : fmt::format("{} and {} more", text, items.size() - shown);
}

std::string clauses(const std::vector<std::string>& items) {
  const std::size_t shown = items.size() > most_named + 1 ? most_named : items.size();
  const auto first = items.begin(), end = first + static_cast<std::ptrdiff_t>(shown);
  const std::string text = fmt::format("{}", fmt::join(first, end, "; "));
  return shown == items.size() ? text : fmt::format("{}; and {} more", text, items.size() - shown);
}

std::string name_words(const Evidence& evidence, std::size_t group) {
  std::string name = row_label(evidence.groups[group].name, longest_name_in_text);
  const auto breaks = [&](const char* separator) { return name.find(separator) != std::string::npos; };
  return breaks(", ") || breaks("; ") || breaks(" and ") || breaks(" vs ") ? fmt::format("'{}'", name) : name;
}

std::string pair_words(const Evidence& evidence, const Finding& contrast) {
  return fmt::format("{} vs {}", name_words(evidence, contrast.first), name_words(evidence, contrast.second));
}

namespace {

std::string margins_of(const Evidence& evidence, double relative, double absolute) {
  return inference::margin_words(relative, absolute, evidence.unit == "cm" ? " cm" : "");
}

// True if the margin of the pair is the absolute one, not the one in percent.
bool is_margin_absolute(const Evidence& evidence, const Finding& contrast) {
  return has_absolute_margin(evidence) && margin_of(evidence, contrast) == evidence.margin;
}

}  // namespace

std::string margin_words(const Evidence& evidence) {
  if (evidence.scale == ValueScale::share) return points(evidence.plan.margin);
  return margins_of(evidence, evidence.plan.margin, has_absolute_margin(evidence) ? evidence.margin : 0);
}

std::string margin_words(const Evidence& evidence, const Finding& contrast) {
  if (!has_absolute_margin(evidence)) return margin_words(evidence);
  const bool is_absolute = is_margin_absolute(evidence, contrast);
  return margins_of(evidence, is_absolute ? 0 : evidence.plan.margin, is_absolute ? evidence.margin : 0);
}

std::pair<double, double> interval_sizes(const Evidence& evidence, const Finding& contrast) {
  const auto size = [&](double of) {
    return evidence.scale == ValueScale::log10 ? std::max(of, 1 / of) : std::abs(of);
  };
  return std::minmax({size(contrast.estimate.low), size(contrast.estimate.high)});
}

Clause extent_clause(const Evidence& evidence, const Finding& contrast) {
  constexpr double most_in_percent = 10;  // times the smaller mean
  if (evidence.plan.margin == 0 && !has_absolute_margin(evidence)) return {};
  if (evidence.ranks_decide()) return {};  // the interval is for means
  const std::string margin = margin_words(evidence, contrast);
  if (contrast.is_within_margin()) return {"less than " + margin};
  if (contrast.is_beyond_margin()) return {"more than " + margin};
  if (!contrast.is_across_margin()) return {};
  const bool is_ratio = evidence.scale == ValueScale::log10;
  const double first = std::abs(evidence.groups[contrast.first].described.mean),
               second = std::abs(evidence.groups[contrast.second].described.mean);
  const double unit = is_ratio ? 1 : std::isfinite(first + second) ? std::min(first, second) : not_defined;
  const auto [low, high] = interval_sizes(evidence, contrast);
  const double least = low - no_difference(evidence), most = high - no_difference(evidence);
  if (evidence.scale == ValueScale::share)
    return {fmt::format("{} to {}", rounded_number(100 * least, 3), points(most)), {"margin " + margin}};
  if (is_margin_absolute(evidence, contrast) || !(most <= most_in_percent * unit))
    return {"perhaps less than " + margin};
  return {fmt::format("{} to {}", percent(least / unit), percent(most / unit)), {"margin " + margin}};
}

std::string verdict_words(const Evidence& evidence, const Finding& contrast) {
  const std::string extent = words_of(extent_clause(evidence, contrast)), by = extent.empty() ? "" : " by " + extent;
  switch (contrast.relation) {
    case Relation::better:
      return fmt::format("{} is better{}", evidence.groups[contrast.first].name, by);
    case Relation::worse:
      return fmt::format("{} is better{}", evidence.groups[contrast.second].name, by);
    case Relation::same:
      return fmt::format("the same within {}", margin_words(evidence, contrast));
    case Relation::undefined:
      return "not defined: " + contrast.why;
    default:
      return contrast.why.empty() ? "undecided" : "undecided: " + contrast.why;
  }
}

std::string_view role_words(Role role) {
  constexpr std::array<std::string_view, 3> roles{"assumption", "classical", "robust"};
  return roles[static_cast<std::size_t>(role)];
}

std::int64_t ones_of(const GroupEvidence& group) { return std::llround(group.mean.value * group.described.n); }

std::string_view replicates_words(const Evidence& evidence) {
  return evidence.decides_within_blocks() ? std::string_view(evidence.block_noun) : "observations per group";
}

std::string runs_words(const Evidence& evidence, const Estimate& runs) {
  if (std::isnan(runs.value) && std::isnan(runs.low)) return "";  // a margin of 0 is never found
  const double most = std::fmax(runs.value, runs.high);
  const bool more =
      std::ranges::any_of(evidence.groups, [&](const GroupEvidence& group) { return most > group.described.n; });
  if (!more) return "";
  const std::string_view of = replicates_words(evidence);
  if (!std::isfinite(runs.low)) return fmt::format(words::runs_at_least, "runs"_a = runs.value, "of"_a = of);
  return fmt::format(words::runs_for_margin, "range"_a = range_words(runs.low, runs.high), "of"_a = of,
                     "margin"_a = margin_words(evidence));
}

Estimate runs_of_all(const std::vector<const Finding*>& pairs) {
  Estimate all;
  for (const Finding* pair : pairs) {
    const Estimate& own = pair->runs_to_decide;
    all = {std::fmax(all.value, own.value), std::fmin(all.low, own.low), std::fmax(all.high, own.high)};
  }
  return all;
}

std::string_view adjustment_words(const Evidence& evidence) {
  constexpr std::array<std::string_view, 4> whose{"Holm", "Hochberg", "Bonferroni", "Benjamini-Hochberg"};
  return whose[static_cast<std::size_t>(evidence.plan.adjustment)];
}

std::string_view none_words(const Evidence& evidence) { return evidence.scale == ValueScale::log10 ? "1" : "zero"; }

std::string rare_failures_words(const Evidence& evidence) {
  int fewest = std::numeric_limits<int>::max();
  for (const Finding& pair : evidence.contrasts) {
    const bool by_means = pair.relation == Relation::same || (is_decided(pair) && !evidence.ranks_decide());
    if (!by_means || evidence.of_outcomes || pair.is_fact) continue;
    // If a known value is the better one, failures of the other would only confirm it.
    const std::size_t winner = pair.relation == Relation::worse ? pair.second : pair.first;
    if (is_decided(pair) && evidence.groups[winner].copies > 0) continue;
    for (const std::size_t group : {pair.first, pair.second}) {
      const GroupEvidence& of = evidence.groups[group];
      if (of.copies == 0) fewest = std::min(fewest, of.described.n);  // a known value has no failures to hide
    }
  }
  if (fewest == std::numeric_limits<int>::max()) return "";
  return inference::rare_failures_words(fewest, replicates_words(evidence), evidence.plan.significance);
}

bool has_too_few(const Evidence& evidence) {
  const bool has_one_step = evidence.plan.adjustment == results::Adjustment::holm ||
                            evidence.plan.adjustment == results::Adjustment::bonferroni;
  return has_one_step && evidence.fewest > 0 && std::ranges::none_of(evidence.groups, [&](const GroupEvidence& group) {
           return group.described.n >= evidence.fewest;
         });
}

std::size_t corrected_for(const Evidence& evidence) {
  return evidence.method->corrects_all_pairs ? evidence.pairs : evidence.family();
}

bool has_single_values(const Evidence& evidence) {
  return std::ranges::all_of(evidence.groups, [](const GroupEvidence& group) { return group.described.n < 2; }) &&
         std::ranges::none_of(evidence.contrasts, &Finding::is_fact);
}

const TestResult* variance_test(const Evidence& evidence) {
  const TestResult* by_values = evidence.test(brown_forsythe_name);
  return by_values != nullptr ? by_values : evidence.test(bartlett_name);
}

bool variances_differ(const Evidence& evidence) {
  const TestResult* test = variance_test(evidence);
  return test != nullptr && test->p < evidence.plan.significance;
}

}  // namespace ikbench::report
