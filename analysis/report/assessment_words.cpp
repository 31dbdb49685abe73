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

namespace {

std::string joined(const std::vector<std::string>& items, std::string_view comma, std::string_view last) {
  std::string text;
  const std::size_t shown = items.size() > most_named + 1 ? most_named : items.size();
  for (std::size_t i = 0; i < shown; ++i) {
    text += fmt::format("{}{}", i == 0 ? "" : i + 1 == items.size() ? last : comma, items[i]);
  }
  return shown == items.size() ? text : fmt::format("{} and {} more", text, items.size() - shown);
}

}  // namespace

std::string listed(const std::vector<std::string>& items) { return joined(items, ", ", " and "); }
std::string clauses(const std::vector<std::string>& items) { return joined(items, "; ", "; "); }

std::string quantity_words(const std::string& quantity, std::string_view unit) {
  return unit == "s" ? split_unit(quantity).name : quantity;
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

std::pair<std::string, std::string> extent_words(const Evidence& evidence, const Finding& contrast) {
  constexpr double most_in_percent = 10;  // times the smaller mean
  if (evidence.plan.margin == 0 && !has_absolute_margin(evidence)) return {};
  if (evidence.ranks_decide()) return {};  // the interval is for means
  const std::string margin = margin_words(evidence, contrast);
  if (contrast.is_within_margin()) return {"less than " + margin, ""};
  if (contrast.is_beyond_margin()) return {"more than " + margin, ""};
  if (!contrast.is_across_margin()) return {};
  const bool is_ratio = evidence.scale == ValueScale::log10;
  const double first = std::abs(evidence.groups[contrast.first].described.mean),
               second = std::abs(evidence.groups[contrast.second].described.mean);
  const double unit = is_ratio ? 1 : std::isfinite(first + second) ? std::min(first, second) : not_defined;
  const auto [low, high] = interval_sizes(evidence, contrast);
  const double least = low - no_difference(evidence), most = high - no_difference(evidence);
  if (evidence.scale == ValueScale::share)
    return {fmt::format("{} to {}", rounded_number(100 * least, 3), points(most)), "margin " + margin};
  if (is_margin_absolute(evidence, contrast) || !(most <= most_in_percent * unit))
    return {"perhaps less than " + margin, ""};
  return {fmt::format("{} to {}", percent(least / unit), percent(most / unit)), "margin " + margin};
}

std::string verdict_words(const Evidence& evidence, const Finding& contrast) {
  const auto [extent, remark] = extent_words(evidence, contrast);
  const std::string by =
      fmt::format("{}{}{}", extent.empty() ? "" : " by ", extent, remark.empty() ? "" : fmt::format(" ({})", remark));
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
  constexpr std::array<std::string_view, 2> roles{"classical", "robust"};
  return roles[static_cast<std::size_t>(role)];
}

std::int64_t ones_of(const GroupEvidence& group) { return std::llround(group.mean.value * group.described.n); }

std::string_view replicates_words(const Evidence& evidence) {
  return evidence.decides_within_blocks() ? std::string_view(evidence.block_noun) : "observations per group";
}

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

Sentence too_few(const Evidence& evidence) {
  const auto size = [](const GroupEvidence& group) { return group.described.n; };
  if (evidence.fewest == 0 || evidence.groups.empty()) return {};
  const int most = std::ranges::max(evidence.groups, {}, size).described.n;
  if (most >= evidence.fewest) return {};
  return {"Caution", fmt::format(words::too_few, "fewest"_a = evidence.fewest, "of"_a = replicates_words(evidence),
                                 "most"_a = most)};
}

std::size_t corrected_for(const Evidence& evidence) {
  return evidence.method->corrects_all_pairs ? evidence.pairs : evidence.family();
}

bool has_single_values(const Evidence& evidence) {
  return std::ranges::all_of(evidence.groups, [](const GroupEvidence& group) { return group.described.n < 2; }) &&
         std::ranges::none_of(evidence.contrasts, &Finding::is_fact);
}

}  // namespace ikbench::report
