#include "analysis/report/assessment_verdicts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/inference/contrasts.hpp"
#include "analysis/inference/deciding.hpp"
#include "analysis/inference/judge.hpp"
#include "analysis/inference/method.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/assessment_doubts.hpp"
#include "analysis/report/assessment_words.hpp"

namespace ikbench::report {

using namespace statistics;
using namespace inference;

namespace {

// "A has the mean 1.25", "B has no mean: 3 of its 20 values are not finite"
std::string mean_words(const Evidence& evidence, std::size_t group) {
  const Description& of = evidence.groups[group].described;
  const std::string name = name_words(evidence, group);
  if (std::isfinite(of.mean)) return fmt::format("{} has the mean {}", name, rounded_number(of.mean, 3));
  if (of.not_finite == 0) return fmt::format("{} has no mean", name);
  return fmt::format("{} has no mean: {} of its {} values {} not finite", name, of.not_finite, of.n,
                     of.not_finite == 1 ? "is" : "are");
}

// "by 0.156 to 0.57, more than 5 %"; empty where neither is known. An interval that is not for the better one is left
// out.
std::string amount_words(const Evidence& evidence, const Contrast& contrast) {
  const auto [low, high] = interval_sizes(evidence, contrast);
  const bool is_for_it =
      !includes_none(evidence, contrast) && !mean_favours_other(evidence, contrast) && std::isfinite(low + high);
  const std::string extent = extent_words(evidence, contrast);
  if (!is_for_it) return extent.empty() ? "" : "by " + extent;
  const double unit = evidence.of_outcomes ? 0.01 : 1;  // percentage points
  std::string text = "by " + rounded_number(low / unit, 3);
  if (rounded_number(low, 3) != rounded_number(high, 3)) text += " to " + rounded_number(high / unit, 3);
  if (evidence.of_outcomes) text += " percentage points";
  if (evidence.scale == ValueScale::log10) text += " times";
  return extent.empty() ? text : fmt::format("{}, {}", text, extent);
}

// "..., 3 % to 12 % (margin 5 %; p = 0.002)": in the brackets that are there, or in its own.
std::string with_remark(std::string text, const std::string& remark) {
  if (!text.ends_with(')')) return fmt::format("{} ({})", text, remark);
  text.pop_back();
  return fmt::format("{}; {})", text, remark);
}

std::size_t other_than(std::size_t group, const Contrast& contrast) {
  return contrast.first == group ? contrast.second : contrast.first;
}

std::size_t better_of(const Contrast& contrast) {
  return contrast.relation == Relation::better ? contrast.first : contrast.second;
}

// ", ahead in 98 % of blocks", of the better one; empty where only summaries are known.
std::string ahead_words(const Evidence& evidence, const Contrast& contrast) {
  const double share = contrast.superiority.value;
  if (!std::isfinite(share)) return "";
  return fmt::format(", ahead in {} of {}", percent(better_of(contrast) == contrast.first ? share : 1 - share),
                     evidence.blocks > 0 ? std::string_view(evidence.block_noun) : "pairs of observations");
}

// By what the one is better, where it is not the mean.
std::string by_words(const Evidence& evidence) {
  if (!evidence.ranks_decide()) return "";
  return evidence.decides_within_blocks() ? " by ranks within blocks" : " by ranks";
}

// ": mean 0.0019 vs 0.365, by 0.156 to 0.57, more than 5 %", with "mean " as the kind; " (A has the mean 1.25; B has no
// mean: ...)".
std::string effect_of(const Evidence& evidence, const Contrast& contrast, std::size_t group, std::string_view kind) {
  const std::size_t other = other_than(group, contrast);
  const double mean = evidence.groups[group].described.mean, of_other = evidence.groups[other].described.mean;
  if (!std::isfinite(mean) || !std::isfinite(of_other))
    return fmt::format(" ({}; {}){}", mean_words(evidence, group), mean_words(evidence, other),
                       ahead_words(evidence, contrast));
  const std::string amount = amount_words(evidence, contrast);
  const std::string means =
      evidence.of_outcomes ? fmt::format("{} vs {}", percent(mean), percent(of_other)) : against(mean, of_other);
  const std::string ahead = ahead_words(evidence, contrast);
  if (evidence.ranks_decide()) {
    return fmt::format("{} ({}{}, which ranks do not compare)", ahead, kind.empty() ? "mean " : kind, means);
  }
  return fmt::format(": {}{}{}{}{}", kind, means, amount.empty() ? "" : ", ", amount, kind.empty() ? ahead : "");
}

// "IK-BA is better than DE: 0.0019 vs 0.365, by 0.156 to 0.57, more than 5 % (p = 0.000297), although ..."
std::string better_words(const Evidence& evidence, const Contrast& contrast) {
  const std::size_t winner = better_of(contrast);
  std::string text =
      fmt::format("{} is better{} than {}{}", name_words(evidence, winner), by_words(evidence),
                  name_words(evidence, other_than(winner, contrast)), effect_of(evidence, contrast, winner, ""));
  if (std::isfinite(contrast.p)) text = with_remark(std::move(text), p_words(contrast.p));
  const std::string doubt = doubt_words(evidence, contrast);
  return doubt.empty() ? text : fmt::format("{}, although {}", text, doubt);
}

bool has_judged(const Evidence& evidence) {
  return std::ranges::any_of(evidence.contrasts, [](const Contrast& c) { return c.relation != Relation::undefined; });
}

// "10 of the 15 pairs differ. IK-BA is better than BA: ..."; of pairs with the best, or of the others where none of
// those differs.
std::string who_differs_words(const Evidence& evidence, const std::vector<std::string>& with_best,
                              const std::vector<std::string>& of_others) {
  const std::size_t pairs = evidence.contrasts.size(), differ = with_best.size() + of_others.size();
  if (!has_judged(evidence)) return pairs == 1 ? "the pair cannot be judged" : "no pair can be judged";
  const std::string best = name_words(evidence, evidence.reference.value_or(best_group(evidence)));
  if (pairs == 1) return differ == 1 ? with_best.front() : "no difference is shown";
  const std::string of = evidence.reference ? fmt::format("pairs with {}", best) : "pairs";
  if (differ == 0) return fmt::format("no difference is shown in any of the {} {}", pairs, of);
  return fmt::format("{} of the {} {} {}. {}{}", differ, pairs, of, differ == 1 ? "differs" : "differ",
                     with_best.empty() ? fmt::format("None of them includes {}: ", best) : "",
                     clauses(with_best.empty() ? of_others : with_best));
}

// "difference between -0.1 and 0.2"
std::string interval_words_of(const Evidence& evidence, const Contrast& contrast) {
  const double unit = evidence.of_outcomes ? 0.01 : 1;
  return fmt::format("{} between {} and {}{}", evidence.scale == ValueScale::log10 ? "ratio" : "difference",
                     rounded_number(contrast.difference.low / unit, 3),
                     rounded_number(contrast.difference.high / unit, 3),
                     evidence.of_outcomes ? " percentage points" : "");
}

// What is known of two that are not told apart.
std::string open_words(const Evidence& evidence, const Contrast& contrast) {
  const std::string runs = runs_words(evidence, contrast.runs_to_decide);
  const std::string then = runs.empty() ? "" : "; " + runs;
  if (contrast.p == 1 && contrast.difference.value == no_difference(evidence) &&
      !std::isfinite(contrast.difference.low)) {
    return "all observations are equal, but there are too few to call the groups the same" + then;
  }
  if (!std::isfinite(contrast.difference.low)) return p_words(contrast.p) + then;
  return fmt::format("{}; {}{}{}", p_words(contrast.p), interval_words_of(evidence, contrast),
                     excludes_none(evidence, contrast)
                         ? fmt::format(", which excludes {} by another method ({}) than the test that decides",
                                       evidence.scale == ValueScale::log10 ? "1" : "zero", evidence.method->interval)
                         : "",
                     then);
}

// "A vs B (...); A vs C and B vs C (...)": a reason once for all that share it, and which test would do.
template <class NameOf>
std::string undefined_words(const Evidence& evidence, const std::vector<const Contrast*>& pairs, NameOf name_of_pair) {
  std::vector<std::pair<std::string, std::vector<std::string>>> by_reason;
  bool by_means = false, by_ranks = false;
  std::size_t single = 0;  // that no test judges
  for (const Contrast* pair : pairs) {
    auto found = std::ranges::find(by_reason, pair->undefined, [](const auto& each) { return each.first; });
    if (found == by_reason.end()) found = by_reason.insert(found, {pair->undefined, {}});
    found->second.push_back(name_of_pair(*pair));
    const Description &first = evidence.groups[pair->first].described,
                      &second = evidence.groups[pair->second].described;
    if (std::min(first.n, second.n) < 2) {
      ++single;
      continue;
    }
    (std::isfinite(first.std) && std::isfinite(second.std) ? by_means : by_ranks) = true;
  }
  std::vector<std::string> words;
  for (const auto& [reason, names] : by_reason) words.push_back(fmt::format("{} ({})", listed(names), reason));
  const bool has_other = !evidence.from_summaries && !evidence.ranks_decide();
  const std::string test = has_other && by_ranks                           ? "kruskal_wallis"
                           : by_means && evidence.plan.test == "bootstrap" ? "tamhane"
                                                                           : "";
  if (test.empty()) return clauses(words);
  return fmt::format(
      "{0}; in a new study another test would judge {1} (ikbench run: --set analysis.test={2}; ikbench stats: --test {2})",
      clauses(words),
      single > 0          ? "others of them"
      : pairs.size() == 1 ? "it"
                          : "them",
      test);
}

// What is said of the pairs of one group, by what is known of them.
struct PairsOf {
  std::vector<const Contrast*> ahead = {}, behind = {}, same = {}, open = {}, undefined = {};
  std::vector<const Contrast*> others_decided = {};
  std::size_t others = 0, others_undefined = 0;
};

PairsOf pairs_of(const Evidence& evidence, std::size_t group) {
  PairsOf result;
  for (const Contrast& contrast : evidence.contrasts) {
    const bool is_own = contrast.first == group || contrast.second == group;
    const bool is_undefined = contrast.relation == Relation::undefined;
    result.others += is_own ? 0 : 1;
    result.others_undefined += !is_own && is_undefined ? 1 : 0;
    if (is_decided(contrast)) {
      (!is_own                        ? result.others_decided
       : better_of(contrast) == group ? result.ahead
                                      : result.behind)
          .push_back(&contrast);
    }
    if (is_own && contrast.relation == Relation::same) result.same.push_back(&contrast);
    if (is_own && contrast.relation == Relation::undecided) result.open.push_back(&contrast);
    if (is_own && is_undefined) result.undefined.push_back(&contrast);
  }
  return result;
}

std::string others_of(const Evidence& evidence, std::size_t group, const std::vector<const Contrast*>& pairs) {
  std::vector<std::string> names;
  for (const Contrast* pair : pairs) {
    const std::string name = name_words(evidence, other_than(group, *pair));
    const std::string doubt = doubt_words(evidence, *pair);
    names.push_back(doubt.empty() ? name : fmt::format("{} (although {})", name, doubt));
  }
  return listed(names);
}

// "IK-BA is better than BA and DE; against DE, the best of these: 0.0019 vs 0.365, by 0.156 to 0.57, more than 5 % (p
// at most 0.0003)". What is known of one pair, and how sure all are.
std::string lead_words(const Evidence& evidence, std::size_t group, const std::vector<const Contrast*>& pairs,
                       std::string_view is_better) {
  double largest_p = not_defined;
  for (const Contrast* pair : pairs) largest_p = std::fmax(largest_p, pair->p);
  const Contrast& best = **std::ranges::min_element(
      pairs, {}, [&](const Contrast* pair) { return standing(evidence, evidence.groups[other_than(group, *pair)]); });
  std::string text =
      fmt::format("{} {} than {}", name_words(evidence, group), is_better, others_of(evidence, group, pairs));
  if (pairs.size() > 1) {
    text += fmt::format("; against {}, the best of these", name_words(evidence, other_than(group, best)));
  }
  const std::string_view kind = evidence.of_outcomes                  ? "share "
                                : evidence.scale == ValueScale::log10 ? "geometric mean "
                                                                      : "mean ";
  text += effect_of(evidence, best, group, kind);
  if (std::isnan(largest_p)) return text;
  const bool is_exact = pairs.size() == 1 || largest_p < 1e-300;
  return with_remark(std::move(text), is_exact ? p_words(largest_p) : "p at most " + at_most(largest_p));
}

std::string same_words(const Evidence& evidence, std::size_t group, const std::vector<const Contrast*>& pairs) {
  std::string text =
      fmt::format("{} and {} are the same within {}", name_words(evidence, group), others_of(evidence, group, pairs),
                  pairs.size() == 1 ? margin_words(evidence, *pairs.front()) : margin_words(evidence));
  const Estimate& difference = pairs.front()->difference;
  if (pairs.size() == 1 && difference.low != difference.high) {
    text = with_remark(std::move(text), interval_words_of(evidence, *pairs.front()));
  }
  const std::string limit = unseen_words(evidence, pairs);
  return limit.empty() ? text : with_remark(std::move(text), limit);
}

std::string open_pairs_words(const Evidence& evidence, std::size_t group, const std::vector<const Contrast*>& pairs) {
  if (pairs.size() == 1) {
    const Contrast& pair = *pairs.front();
    return fmt::format("{} against {} is undecided ({})", name_words(evidence, group),
                       name_words(evidence, other_than(group, pair)), open_words(evidence, pair));
  }
  const std::string text =
      fmt::format("{} against {} is undecided", name_words(evidence, group), others_of(evidence, group, pairs));
  const std::string runs = runs_words(evidence, runs_of_all(pairs));
  return runs.empty() ? text : fmt::format("{} ({})", text, runs);
}

std::string_view standing_words(const Evidence& evidence) {
  if (!evidence.ranks_decide()) return "mean";
  return evidence.decides_within_blocks() ? "average rank" : "mean rank";
}

// "5 of the 10 other pairs differ (the better first): DE vs BA; ..."
std::string other_pairs_words(const Evidence& evidence, const PairsOf& pairs) {
  if (pairs.others == 0) return "";
  const bool is_one = pairs.others == 1;
  if (pairs.others_undefined == pairs.others) {
    return is_one ? "The other pair cannot be judged." : "None of the other pairs can be judged.";
  }
  const std::string others = fmt::format("the {} other pair{}", pairs.others, is_one ? "" : "s");
  const std::string undefined =
      pairs.others_undefined == 0 ? "" : fmt::format(" {} of them cannot be judged.", pairs.others_undefined);
  if (pairs.others_decided.empty()) {
    return (is_one ? "The other pair is not shown to differ." : fmt::format("None of {} is shown to differ.", others)) +
           undefined;
  }
  std::vector<std::string> names;
  for (const Contrast* pair : pairs.others_decided) {
    const std::size_t better = better_of(*pair);
    names.push_back(
        fmt::format("{} vs {}", name_words(evidence, better), name_words(evidence, other_than(better, *pair))));
  }
  const bool all = names.size() == pairs.others;
  if (all && is_one) return fmt::format("The other pair differs too (the better first): {}.", clauses(names));
  return fmt::format("{}{} differ{} (the better first): {}.{}", all ? "Also " : fmt::format("{} of ", names.size()),
                     others, names.size() == 1 ? "s" : "", clauses(names), undefined);
}

// "studentized bootstrap, corrected for 3 pairs; Fisher's exact test for groups of one value each"
std::string decided_by(const Evidence& evidence) {
  const auto constants =
      std::ranges::count_if(evidence.contrasts, [&](const Contrast& each) { return are_constants(evidence, each); });
  const auto by_order = std::ranges::count(evidence.contrasts, true, &Contrast::is_by_order);
  const auto facts = std::ranges::count(evidence.contrasts, true, &Contrast::is_fact);
  const auto is_against_known = [&](const Contrast& each) {
    return each.is_by_order && evidence.groups[each.first].copies + evidence.groups[each.second].copies > 0;
  };
  const auto against_known = std::ranges::count_if(evidence.contrasts, is_against_known);
  std::vector<std::string> tests;
  if (constants + by_order + facts < std::ssize(evidence.contrasts)) {
    std::string& planned = tests.emplace_back(pair_test_words(evidence));
    if (evidence.pairs > 1) planned += fmt::format(", corrected for {} pairs", corrected_for(evidence));
  }
  if (against_known > 0) tests.emplace_back("the sign test against solvers whose runs are all equal");
  if (facts > 0) tests.emplace_back("no test between solvers whose runs are all equal, where the difference is a fact");
  if (by_order > against_known) {
    tests.push_back(fmt::format(
        "{} for groups that do not overlap, where one has a single value or both have too few different ones",
        evidence.blocks > 0 ? "the sign test" : "the exact test of ranks"));
  }
  if (constants > 0) tests.push_back(fmt::format("{} for groups of one value each", test_of_constants_words(evidence)));
  return fmt::format("{}", fmt::join(tests, "; "));
}

}  // namespace

std::vector<std::string> who_differs(const Evidence& evidence) {
  if (evidence.contrasts.empty()) return {};
  const std::size_t best = evidence.reference.value_or(best_group(evidence));
  std::vector<std::string> with_best, of_others, open, same;
  std::vector<const Contrast*> undefined, equivalent;
  for (const Contrast& contrast : evidence.contrasts) {
    const bool of_best = contrast.first == best || contrast.second == best;
    if (is_decided(contrast)) (of_best ? with_best : of_others).push_back(better_words(evidence, contrast));
    if (contrast.relation == Relation::undecided) {
      open.push_back(fmt::format("{} ({})", pair_words(evidence, contrast), open_words(evidence, contrast)));
    }
    if (contrast.relation == Relation::same) {
      same.push_back(pair_words(evidence, contrast));
      equivalent.push_back(&contrast);
    }
    if (contrast.relation == Relation::undefined) undefined.push_back(&contrast);
  }
  std::vector<std::string> sentences;
  sentences.push_back(fmt::format("Differences: {}.", who_differs_words(evidence, with_best, of_others)));
  if (!same.empty()) {
    const std::string limit = unseen_words(evidence, equivalent);
    sentences.push_back(fmt::format("The same within {}: {}{}.", margin_words(evidence), clauses(same),
                                    limit.empty() ? "" : fmt::format(" ({})", limit)));
  }
  if (!open.empty()) sentences.push_back(fmt::format("Undecided: {}.", clauses(open)));
  if (!undefined.empty()) {
    const auto name = [&](const Contrast& contrast) { return pair_words(evidence, contrast); };
    sentences.push_back(fmt::format("Not defined: {}.", undefined_words(evidence, undefined, name)));
  }
  return sentences;
}

std::string in_short(const Evidence& evidence) {
  if (evidence.contrasts.empty()) return "";
  const std::size_t best = evidence.reference.value_or(best_group(evidence));
  const PairsOf pairs = pairs_of(evidence, best);
  if (has_single_values(evidence)) return "nothing can be judged, because no group has more than one observation.";
  std::vector<std::string> parts;
  if (!pairs.ahead.empty()) parts.push_back(lead_words(evidence, best, pairs.ahead, "is better" + by_words(evidence)));
  if (!pairs.behind.empty()) parts.push_back(lead_words(evidence, best, pairs.behind, "is worse" + by_words(evidence)));
  if (!pairs.same.empty()) parts.push_back(same_words(evidence, best, pairs.same));
  if (!pairs.open.empty()) parts.push_back(open_pairs_words(evidence, best, pairs.open));
  if (!pairs.undefined.empty()) {
    const auto name = [&](const Contrast& contrast) { return name_words(evidence, other_than(best, contrast)); };
    parts.push_back(fmt::format("{} cannot be judged against {}", name_words(evidence, best),
                                undefined_words(evidence, pairs.undefined, name)));
  }
  const bool is_open = pairs.ahead.empty() && pairs.behind.empty() && !(pairs.same.empty() && pairs.open.empty());
  if (is_open && evidence.contrasts.size() > 1) {
    parts.insert(
        parts.begin(),
        fmt::format(
            "{} {} not shown to be better than another group", name_words(evidence, best),
            evidence.plan.control.empty() ? fmt::format("has the best {}, but is", standing_words(evidence)) : "is"));
  }
  std::string text = fmt::format("{}.", fmt::join(parts, "; "));
  if (const std::string others = other_pairs_words(evidence, pairs); !others.empty()) text += " " + others;
  if (evidence.constant) return text;
  if (has_judged(evidence)) text += fmt::format(" Decided by: {}.", decided_by(evidence));
  std::vector<const Contrast*> decided = pairs.ahead;
  decided.insert(decided.end(), pairs.behind.begin(), pairs.behind.end());
  const std::string limit = unseen_words(evidence, decided);
  return limit.empty() ? text : fmt::format("{} Better {}.", text, limit);
}

}  // namespace ikbench::report
