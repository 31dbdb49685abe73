#include "analysis/report/assessment_doubts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "analysis/report/assessment_words.hpp"
#include "analysis/report/words.hpp"
#include "analysis/statistics/rounding.hpp"

namespace ikbench::report {

using namespace statistics;
using namespace inference;
using namespace fmt::literals;

namespace {

// The measures that favour the other group of a pair than the deciding test.
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

}  // namespace

bool includes_none(const Evidence& evidence, const Contrast& contrast) {
  return contrast.difference.low < no_difference(evidence) && contrast.difference.high > no_difference(evidence);
}

bool excludes_none(const Evidence& evidence, const Contrast& contrast) {
  return contrast.difference.low > no_difference(evidence) || contrast.difference.high < no_difference(evidence);
}

bool mean_favours_other(const Evidence& evidence, const Contrast& contrast) { return dissent(evidence, contrast).mean; }

std::string doubt_words(const Evidence& evidence, const Contrast& contrast) {
  const std::string_view interval = evidence.scale == ValueScale::log10 ? "the interval of the ratio"
                                    : evidence.of_outcomes              ? "the interval of the difference"
                                                           : "the interval of the difference between means";
  const std::string_view none = none_words(evidence);
  if (contrast.relation == Relation::undecided) {
    return excludes_none(evidence, contrast)
               ? fmt::format(words::interval_excludes, "interval"_a = interval, "none"_a = none)
               : "";
  }
  if (!is_decided(contrast)) return "";
  std::vector<std::string> doubts, measures;
  if (includes_none(evidence, contrast))
    doubts.push_back(fmt::format(words::interval_includes, "interval"_a = interval, "none"_a = none));
  const Dissent found = dissent(evidence, contrast);
  if (found.mean) measures.emplace_back("the mean");
  if (found.median) measures.emplace_back("the median");
  if (found.share) measures.push_back(evidence.blocks > 0 ? "the share of " + evidence.block_noun : "A12");
  if (!measures.empty()) {
    doubts.push_back(fmt::format(words::favour_other, "measures"_a = listed(measures),
                                 "favour"_a = measures.size() == 1 ? "favours" : "favour"));
  }
  return fmt::format("{}", fmt::join(doubts, " and "));
}

Sentence change_words(const Evidence& evidence) {
  std::vector<const Contrast*> open;
  bool is_small = false, is_doubted = false;
  for (const Contrast& contrast : evidence.contrasts) {
    if (contrast.relation == Relation::undecided) open.push_back(&contrast);
    if (!is_decided(contrast)) continue;
    is_small = is_small || contrast.is_within_margin() || contrast.is_across_margin();
    is_doubted = is_doubted || !doubt_words(evidence, contrast).empty();
  }
  if (evidence.contrasts.empty() || has_single_values(evidence)) return {};
  std::vector<std::string> parts;
  if (!evidence.flaws.empty()) parts.emplace_back(words::sound_observations);
  if (const std::string runs = runs_words(evidence, runs_of_all(open)); !runs.empty()) {
    parts.push_back(fmt::format(words::larger_study, "runs"_a = runs));
  }
  const auto is_undefined = [](const Contrast& contrast) { return contrast.relation == Relation::undefined; };
  const auto is_short = [](const GroupEvidence& group) { return group.described.n < 3; };
  if (std::ranges::any_of(evidence.contrasts, is_undefined) && std::ranges::any_of(evidence.groups, is_short)) {
    parts.emplace_back(words::more_than_two);
  }
  if (is_doubted) parts.emplace_back(words::another_measure);
  if (is_small) parts.push_back(fmt::format(words::larger_margin, "margin"_a = margin_words(evidence)));
  parts.emplace_back(words::other_conditions);
  return {"What would change it", fmt::format("{}.", fmt::join(parts, "; "))};
}

}  // namespace ikbench::report
