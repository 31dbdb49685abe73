#include "analysis/report/assessment_verdicts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "analysis/inference/contrasts.hpp"
#include "analysis/inference/judge.hpp"
#include "analysis/inference/method.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/assessment_doubts.hpp"
#include "analysis/report/assessment_words.hpp"
#include "analysis/report/words.hpp"

namespace ikbench::report {

using namespace statistics;
using namespace inference;
using namespace fmt::literals;

namespace {

using Pairs = std::vector<const Contrast*>;

std::string mean_words(const Evidence& evidence, std::size_t group) {
  const Description& of = evidence.groups[group].described;
  const std::string name = name_words(evidence, group);
  if (std::isfinite(of.mean))
    return fmt::format(words::has_mean, "name"_a = name, "mean"_a = rounded_number(of.mean, 3));
  if (of.not_finite == 0) return fmt::format(words::has_no_mean, "name"_a = name);
  return fmt::format(words::mean_not_finite, "name"_a = name, "lost"_a = of.not_finite, "n"_a = of.n);
}

// "by 0.156 to 0.57, more than 5 %"; empty if neither is known. Leaves out an interval that does not favour the better
// one.
Clause amount_of(const Evidence& evidence, const Contrast& contrast) {
  const auto [low, high] = interval_sizes(evidence, contrast);
  const bool is_for_it =
      !includes_none(evidence, contrast) && !mean_favours_other(evidence, contrast) && std::isfinite(low + high);
  Clause amount = extent_clause(evidence, contrast);
  if (!is_for_it) {
    if (!amount.text.empty()) amount.text = "by " + amount.text;
    return amount;
  }
  const double unit = evidence.of_outcomes ? 0.01 : 1;  // percentage points
  std::string text = "by " + rounded_number(low / unit, 3);
  if (rounded_number(low, 3) != rounded_number(high, 3)) text += " to " + rounded_number(high / unit, 3);
  if (evidence.of_outcomes) text += " percentage points";
  if (evidence.scale == ValueScale::log10) text += " times";
  amount.text = amount.text.empty() ? text : fmt::format("{}, {}", text, amount.text);
  return amount;
}

std::size_t other_than(std::size_t group, const Contrast& contrast) {
  return contrast.first == group ? contrast.second : contrast.first;
}

std::size_t better_of(const Contrast& contrast) {
  return contrast.relation == Relation::better ? contrast.first : contrast.second;
}

// Share of comparisons in which the better one is ahead; empty if only summaries are known.
std::string ahead_words(const Evidence& evidence, const Contrast& contrast) {
  const double share = contrast.superiority.value;
  if (!std::isfinite(share)) return "";
  const double own = better_of(contrast) == contrast.first ? share : 1 - share;
  return fmt::format(words::ahead, "share"_a = percent(own),
                     "of"_a = evidence.blocks > 0 ? std::string_view(evidence.block_noun) : "pairs of observations");
}

// Says by what one group is better, if not by the mean.
std::string_view by_words(const Evidence& evidence) {
  if (!evidence.ranks_decide()) return "";
  return evidence.decides_within_blocks() ? " by ranks within blocks" : " by ranks";
}

// "mean 0.0019 vs 0.365, by 0.156 to 0.57, more than 5 %"; by ranks "ahead in 98 % of blocks (mean ...)".
Clause effect_of(const Evidence& evidence, const Contrast& contrast, std::size_t group) {
  const std::size_t other = other_than(group, contrast);
  const double mean = evidence.groups[group].described.mean, of_other = evidence.groups[other].described.mean;
  if (!std::isfinite(mean) || !std::isfinite(of_other)) {
    return {ahead_words(evidence, contrast), {mean_words(evidence, group), mean_words(evidence, other)}};
  }
  const std::string_view kind = evidence.of_outcomes                  ? "share"
                                : evidence.scale == ValueScale::log10 ? "geometric mean"
                                                                      : "mean";
  const std::string means =
      evidence.of_outcomes ? fmt::format("{} vs {}", percent(mean), percent(of_other)) : against(mean, of_other);
  if (evidence.ranks_decide()) {
    return {ahead_words(evidence, contrast), {fmt::format(words::not_by_ranks, "kind"_a = kind, "means"_a = means)}};
  }
  Clause amount = amount_of(evidence, contrast);
  amount.text = fmt::format("{} {}{}{}", kind, means, amount.text.empty() ? "" : ", ", amount.text);
  return amount;
}

std::string others_of(const Evidence& evidence, std::size_t group, const Pairs& pairs) {
  std::vector<std::string> names;
  for (const Contrast* pair : pairs) names.push_back(name_words(evidence, other_than(group, *pair)));
  return listed(names);
}

// ", although the median favours the other"; names the pairs unless it holds for all.
std::string doubts_of(const Evidence& evidence, std::size_t group, const Pairs& pairs) {
  std::vector<std::pair<std::string, Pairs>> doubts;
  for (const Contrast* pair : pairs) {
    const std::string doubt = doubt_words(evidence, *pair);
    if (doubt.empty()) continue;
    const auto found = std::ranges::find(doubts, doubt, &std::pair<std::string, Pairs>::first);
    (found == doubts.end() ? doubts.emplace_back(doubt, Pairs{}) : *found).second.push_back(pair);
  }
  std::vector<std::string> parts;
  for (const auto& [doubt, of] : doubts) {
    const bool is_of_all = of.size() == pairs.size();
    parts.push_back(is_of_all ? doubt : fmt::format("{} ({})", doubt, others_of(evidence, group, of)));
  }
  return parts.empty() ? "" : ", although " + listed(parts);
}

// "IK-BA is better than BA and DE (p at most 0.0003)", "Against DE, the best of these: mean 0.0019 vs 0.365, ...".
// Details one pair, and how sure all are.
std::vector<std::string> decided_words(const Evidence& evidence, std::size_t group, const Pairs& pairs,
                                       bool is_better) {
  double largest_p = not_defined;
  for (const Contrast* pair : pairs) largest_p = std::fmax(largest_p, pair->p);
  const Contrast& best = **std::ranges::min_element(
      pairs, {}, [&](const Contrast* pair) { return standing(evidence, evidence.groups[other_than(group, *pair)]); });
  Clause answer{fmt::format(words::decided, "first"_a = name_words(evidence, group),
                            "better"_a = is_better ? "better" : "worse", "by"_a = by_words(evidence),
                            "others"_a = others_of(evidence, group, pairs))};
  const Clause effect = effect_of(evidence, best, group);
  if (pairs.size() == 1) {
    if (!effect.text.empty()) answer.text += ": " + effect.text;
    answer.remarks = effect.remarks;
  }
  if (!std::isnan(largest_p)) {
    const bool is_exact = pairs.size() == 1 || largest_p < 1e-300;
    answer.remarks.push_back(is_exact ? p_words(largest_p) : "p at most " + at_most(largest_p));
  }
  std::vector<std::string> sentences{words_of(answer) + doubts_of(evidence, group, pairs)};
  if (pairs.size() > 1) {
    sentences.push_back(fmt::format(words::nearest, "other"_a = name_words(evidence, other_than(group, best)),
                                    "effect"_a = words_of(effect)));
  }
  return sentences;
}

bool has_judged(const Evidence& evidence) {
  return std::ranges::any_of(evidence.contrasts, [](const Contrast& c) { return c.relation != Relation::undefined; });
}

// "10 of the 15 pairs differ. IK-BA is better than BA: ..."; lists pairs with the best, or other pairs if none of those
// differs.
std::string who_differs_words(const Evidence& evidence, const std::vector<std::string>& with_best,
                              const std::vector<std::string>& of_others) {
  const std::size_t pairs = evidence.contrasts.size(), differ = with_best.size() + of_others.size();
  if (!has_judged(evidence)) return pairs == 1 ? "the pair cannot be judged" : "no pair can be judged";
  const std::string best = name_words(evidence, evidence.reference.value_or(best_group(evidence)));
  if (pairs == 1) return differ == 1 ? with_best.front() : "no difference is shown";
  const std::string of = evidence.reference ? fmt::format("pairs with {}", best) : "pairs";
  if (differ == 0) return fmt::format("no difference is shown in any of the {} {}", pairs, of);
  const std::string text = fmt::format(words::pairs_differ, "verb"_a = differ == 1 ? "differs" : "differ",
                                       "differ"_a = differ, "pairs"_a = pairs, "of"_a = of);
  return fmt::format("{}. {}", text,
                     with_best.empty()
                         ? fmt::format(words::pairs_not_of_best, "best"_a = best, "pairs"_a = clauses(of_others))
                         : clauses(with_best));
}

// "difference between -0.1 and 0.2"
std::string interval_words_of(const Evidence& evidence, const Contrast& contrast) {
  const double unit = evidence.of_outcomes ? 0.01 : 1;
  return fmt::format(words::interval, "what"_a = evidence.scale == ValueScale::log10 ? "ratio" : "difference",
                     "low"_a = rounded_number(contrast.difference.low / unit, 3),
                     "high"_a = rounded_number(contrast.difference.high / unit, 3),
                     "unit"_a = evidence.of_outcomes ? " percentage points" : "");
}

// Remarks on an undecided pair.
std::vector<std::string> open_remarks(const Evidence& evidence, const Contrast& contrast) {
  std::vector<std::string> remarks;
  const bool has_interval = std::isfinite(contrast.difference.low);
  const bool is_equal = contrast.p == 1 && contrast.difference.value == no_difference(evidence) && !has_interval;
  remarks.emplace_back(is_equal ? words::all_equal : p_words(contrast.p));
  if (has_interval) {
    std::string interval = interval_words_of(evidence, contrast);
    if (excludes_none(evidence, contrast)) {
      interval += ", " + fmt::format(words::excludes_none, "none"_a = none_words(evidence),
                                     "method"_a = evidence.method->interval);
    }
    remarks.push_back(std::move(interval));
  }
  if (std::string runs = runs_words(evidence, contrast.runs_to_decide); !runs.empty())
    remarks.push_back(std::move(runs));
  return remarks;
}

// "A vs B (...); A vs C and B vs C (...)": pairs with the same reason are listed together.
template <class NameOf>
std::string reasons_of(const Pairs& pairs, NameOf name_of_pair) {
  std::vector<std::pair<std::string, std::vector<std::string>>> by_reason;
  for (const Contrast* pair : pairs) {
    auto found = std::ranges::find(by_reason, pair->undefined, [](const auto& each) { return each.first; });
    if (found == by_reason.end()) found = by_reason.insert(found, {pair->undefined, {}});
    found->second.push_back(name_of_pair(*pair));
  }
  std::vector<std::string> texts;
  for (const auto& [reason, names] : by_reason) texts.push_back(fmt::format("{} ({})", listed(names), reason));
  return clauses(texts);
}

// Names a test that would judge unjudged pairs; empty if none would.
std::string another_test_words(const Evidence& evidence, const Pairs& pairs) {
  bool by_means = false, by_ranks = false, has_single = false;
  for (const Contrast* pair : pairs) {
    const Description &first = evidence.groups[pair->first].described,
                      &second = evidence.groups[pair->second].described;
    const bool is_single = std::min(first.n, second.n) < 2;  // no test judges it
    has_single = has_single || is_single;
    if (!is_single) (std::isfinite(first.std) && std::isfinite(second.std) ? by_means : by_ranks) = true;
  }
  const bool has_other = !evidence.from_summaries && !evidence.ranks_decide();
  const std::string_view test = has_other && by_ranks                           ? "kruskal_wallis"
                                : by_means && evidence.plan.test == "bootstrap" ? "tamhane"
                                                                                : "";
  if (test.empty()) return "";
  return fmt::format(words::another_test,
                     "what"_a = has_single          ? "others of them"
                                : pairs.size() == 1 ? "it"
                                                    : "them",
                     "test"_a = test);
}

// The pairs of one group, by verdict.
struct PairsOf {
  Pairs ahead = {}, behind = {}, same = {}, open = {}, undefined = {};
  Pairs others_decided = {};
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

std::string same_words(const Evidence& evidence, std::size_t group, const Pairs& pairs) {
  const bool is_one = pairs.size() == 1;
  Clause text{fmt::format(words::same, "first"_a = name_words(evidence, group),
                          "others"_a = others_of(evidence, group, pairs),
                          "margin"_a = is_one ? margin_words(evidence, *pairs.front()) : margin_words(evidence))};
  const Estimate& difference = pairs.front()->difference;
  if (is_one && difference.low != difference.high) text.remarks = {interval_words_of(evidence, *pairs.front())};
  return words_of(text);
}

std::string open_words(const Evidence& evidence, std::size_t group, const Pairs& pairs) {
  Clause text{fmt::format(words::undecided, "first"_a = name_words(evidence, group),
                          "others"_a = others_of(evidence, group, pairs))};
  if (pairs.size() == 1) {
    text.remarks = open_remarks(evidence, *pairs.front());
    return words_of(text);
  }
  text.text += doubts_of(evidence, group, pairs);
  if (std::string runs = runs_words(evidence, runs_of_all(pairs)); !runs.empty()) text.remarks = {std::move(runs)};
  return words_of(text);
}

std::string_view standing_words(const Evidence& evidence) {
  if (!evidence.ranks_decide()) return "mean";
  return evidence.decides_within_blocks() ? "average rank" : "mean rank";
}

// "Of the 10 other pairs 5 differ (the better first): DE vs BA; ..."
std::vector<std::string> other_pairs_words(const Evidence& evidence, const PairsOf& pairs) {
  if (pairs.others == 0) return {};
  const bool is_one = pairs.others == 1;
  if (pairs.others_undefined == pairs.others) {
    return {is_one ? "The other pair cannot be judged" : "None of the other pairs can be judged"};
  }
  std::vector<std::string> names;
  for (const Contrast* pair : pairs.others_decided) {
    const std::size_t better = better_of(*pair);
    names.push_back(
        fmt::format("{} vs {}", name_words(evidence, better), name_words(evidence, other_than(better, *pair))));
  }
  std::vector<std::string> sentences;
  if (is_one) {
    sentences.push_back(names.empty() ? "The other pair is not shown to differ"
                                      : "The other pair differs too (the better first): " + names.front());
  } else if (names.empty()) {
    sentences.push_back(fmt::format(words::others_do_not_differ, "pairs"_a = pairs.others));
  } else {
    sentences.push_back(fmt::format(
        words::others_differ, "pairs"_a = pairs.others, "verb"_a = names.size() == 1 ? "differs" : "differ",
        "differ"_a = names.size() == pairs.others ? "all" : fmt::to_string(names.size()), "list"_a = clauses(names)));
  }
  if (pairs.others_undefined > 0) {
    sentences.push_back(fmt::format(words::others_not_judged, "count"_a = pairs.others_undefined));
  }
  return sentences;
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

std::vector<Sentence> who_differs(const Evidence& evidence) {
  if (evidence.contrasts.empty()) return {};
  const std::size_t best = evidence.reference.value_or(best_group(evidence));
  std::vector<std::string> with_best, of_others, open, same;
  Pairs undefined;
  for (const Contrast& contrast : evidence.contrasts) {
    const bool of_best = contrast.first == best || contrast.second == best;
    if (is_decided(contrast)) {
      (of_best ? with_best : of_others)
          .push_back(decided_words(evidence, better_of(contrast), {&contrast}, true).front());
    }
    const std::string pair = pair_words(evidence, contrast);
    if (contrast.relation == Relation::undecided)
      open.push_back(words_of(Clause{pair, open_remarks(evidence, contrast)}));
    if (contrast.relation == Relation::same) same.push_back(pair);
    if (contrast.relation == Relation::undefined) undefined.push_back(&contrast);
  }
  std::vector<Sentence> sentences{{"Differences", who_differs_words(evidence, with_best, of_others) + '.'}};
  if (!same.empty()) sentences.push_back({"The same within " + margin_words(evidence), clauses(same) + '.'});
  if (!open.empty()) sentences.push_back({"Undecided", clauses(open) + '.'});
  if (undefined.empty()) return sentences;
  std::string reasons = reasons_of(undefined, [&](const Contrast& contrast) { return pair_words(evidence, contrast); });
  if (const std::string other = another_test_words(evidence, undefined); !other.empty()) reasons += ". " + other;
  sentences.push_back({"Not defined", reasons + '.'});
  return sentences;
}

InShort in_short(const Evidence& evidence) {
  if (evidence.contrasts.empty()) return {};
  const std::size_t best = evidence.reference.value_or(best_group(evidence));
  const PairsOf pairs = pairs_of(evidence, best);
  if (has_single_values(evidence)) return {{std::string(words::single_values)}};
  InShort result;
  const auto add = [&](std::vector<std::string> sentences) {
    std::ranges::move(sentences, std::back_inserter(result.sentences));
  };
  const bool is_open = pairs.ahead.empty() && pairs.behind.empty() && !(pairs.same.empty() && pairs.open.empty());
  const std::string first = name_words(evidence, best);
  if (is_open && evidence.contrasts.size() > 1) {
    add({evidence.plan.control.empty()
             ? fmt::format(words::none_better, "first"_a = first, "average"_a = standing_words(evidence))
             : fmt::format(words::control_not_better, "first"_a = first)});
  }
  if (!pairs.ahead.empty()) add(decided_words(evidence, best, pairs.ahead, true));
  if (!pairs.behind.empty()) add(decided_words(evidence, best, pairs.behind, false));
  if (!pairs.same.empty()) add({same_words(evidence, best, pairs.same)});
  if (!pairs.open.empty()) add({open_words(evidence, best, pairs.open)});
  if (!pairs.undefined.empty()) {
    const auto name = [&](const Contrast& contrast) { return name_words(evidence, other_than(best, contrast)); };
    add({fmt::format(words::not_judged, "first"_a = first, "others"_a = reasons_of(pairs.undefined, name))});
    if (std::string other = another_test_words(evidence, pairs.undefined); !other.empty()) add({std::move(other)});
  }
  add(other_pairs_words(evidence, pairs));
  if (!evidence.constant && has_judged(evidence))
    add({fmt::format(words::decided_by, "tests"_a = decided_by(evidence))});
  return result;
}

std::string words_of(const InShort& in_short) {
  return in_short.sentences.empty() ? "" : fmt::format("{}.", fmt::join(in_short.sentences, ". "));
}

}  // namespace ikbench::report
