#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <string_view>
#include <utility>

#include "analysis/inference/judge.hpp"
#include "analysis/inference/method.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/assessment_words.hpp"
#include "analysis/report/words.hpp"
#include "analysis/statistics/rounding.hpp"

namespace ikbench::report {

using namespace statistics;
using namespace inference;
using namespace fmt::literals;

namespace {

using Pairs = std::vector<const Finding*>;
using Label = std::function<std::string(std::size_t group)>;

// "mean 1 vs 2, by 0.9 to 1.1 (margin 5 %; p = 0.03)"
struct Clause {
  std::string text;
  std::vector<std::string> remarks = {};
};

std::string words_of(const Clause& clause) {
  if (clause.remarks.empty()) return clause.text;
  return fmt::format("{}{}({})", clause.text, clause.text.empty() ? "" : " ", fmt::join(clause.remarks, "; "));
}

// The unit in which times are told, and its size: milliseconds where all are short.
struct ToldUnit {
  std::string_view unit = "";
  double size = 1;
};
ToldUnit told_unit(const Evidence& evidence) {
  constexpr double longest_in_ms = 0.1;
  const auto is_long = [](const GroupEvidence& group) { return group.described.mean >= longest_in_ms; };
  if (evidence.unit != "s") return {};
  return std::ranges::any_of(evidence.groups, is_long) ? ToldUnit{" s"} : ToldUnit{" ms", 0.001};
}

// "0.0019 vs 0.365", with enough digits to tell them apart.
std::string against(double mean, double other) {
  std::string one = rounded_number(mean, 3), two = rounded_number(other, 3);
  for (int digits = 4; one == two && digits <= 12; ++digits) {
    one = rounded_number(mean, digits);
    two = rounded_number(other, digits);
  }
  return fmt::format("{} vs {}", one, two);
}

// Two digits, rounded up.
std::string at_most(double p) {
  const double unit = std::pow(10, std::floor(std::log10(p)) - 1);
  return rounded_number(std::ceil(p / unit) * unit, 2);
}

std::size_t better_of(const Finding& pair) { return pair.relation == Relation::worse ? pair.second : pair.first; }
std::size_t other_than(std::size_t group, const Finding& pair) {
  return pair.first == group ? pair.second : pair.first;
}

bool have_same_bits(const Evidence& evidence, const Finding& pair) {
  const std::size_t bits = evidence.groups[pair.first].bits;
  return bits > 0 && bits == evidence.groups[pair.second].bits;
}

// Items by what is said of them: "A and B (reason); C (another)".
using ByReason = std::map<std::string, std::vector<std::string>>;

// Words for a scale: an average, a difference, that of averages, what the size of one is counted in, and that in the
// unit of the values.
struct ScaleWords {
  std::string_view average, difference, of_averages, none, unit;
  double in_unit = 1;
};
ScaleWords words_of_scale(const Evidence& evidence) {
  static constexpr std::array<ScaleWords, 3> all{
      {{"mean", "difference", "difference between means", "zero", ""},
       {"geometric mean", "ratio", "ratio", "1", " times"},
       {"share", "difference", "difference", "zero", " percentage points", 0.01}}};
  ScaleWords words = all[static_cast<std::size_t>(evidence.scale)];
  if (evidence.scale == ValueScale::plain) {
    const auto [unit, size] = told_unit(evidence);
    words.unit = unit;
    words.in_unit = size;
  }
  return words;
}

bool includes_none(const Evidence& evidence, const Finding& pair) {
  return pair.estimate.low < no_difference(evidence) && pair.estimate.high > no_difference(evidence);
}

// Returns whether a number that is positive where the first is ahead contradicts the deciding test.
bool is_against(const Finding& pair, double for_first) { return sign_of(for_first) == -pair.ahead; }

bool is_against(const Evidence& evidence, const Finding& pair, double Description::*average) {
  const double first = evidence.groups[pair.first].described.*average,
               second = evidence.groups[pair.second].described.*average;
  const double difference = without_rounding(second - first, std::max(std::abs(first), std::abs(second)));
  return is_against(pair, evidence.better == Better::smaller ? difference : -difference);
}

// Averages and shares that favour the other: "the median".
std::vector<std::string> measures_against(const Evidence& evidence, const Finding& pair) {
  std::vector<std::string> measures;
  if (!is_decided(pair)) return measures;
  if (is_against(evidence, pair, &Description::mean)) measures.emplace_back("the mean");
  if (is_against(evidence, pair, &Description::median)) measures.emplace_back("the median");
  if (is_against(pair, pair.superiority.value - 0.5)) {
    measures.push_back(evidence.blocks > 0 ? "the share of " + evidence.block_noun : "A12");
  }
  return measures;
}

// Numbers that contradict the test: "the interval of the difference includes zero and the median favours the other".
std::string doubt_words(const Evidence& evidence, const Finding& pair) {
  const bool is_open = pair.relation == Relation::undecided;
  if (!is_open && !is_decided(pair)) return "";
  const double none = no_difference(evidence);
  std::vector<std::string> doubts;
  if (is_open ? pair.estimate.low > none || pair.estimate.high < none : includes_none(evidence, pair)) {
    const ScaleWords scale = words_of_scale(evidence);
    doubts.push_back(fmt::format(words::interval_against, "of"_a = scale.of_averages,
                                 "includes"_a = is_open ? "excludes" : "includes", "none"_a = scale.none));
  }
  if (const std::vector<std::string> measures = measures_against(evidence, pair); !measures.empty()) {
    doubts.push_back(fmt::format(words::favour_other, "measures"_a = listed(measures),
                                 "favour"_a = measures.size() == 1 ? "favours" : "favour"));
  }
  return fmt::format("{}", fmt::join(doubts, " and "));
}

// "0.156 to 0.57", "12 to 30 percentage points"
std::string size_words(const Evidence& evidence, const Finding& pair) {
  const auto [low, high] = interval_sizes(evidence, pair);
  const ScaleWords scale = words_of_scale(evidence);
  const std::string least = rounded_number(low / scale.in_unit, 3), most = rounded_number(high / scale.in_unit, 3);
  return fmt::format("{}{}{}", least, least == most ? "" : " to " + most, scale.unit);
}

// The interval of `first` less the other of the pair, or of their ratio.
std::string interval_words(const Evidence& evidence, const Finding& pair, std::size_t first) {
  const ScaleWords scale = words_of_scale(evidence);
  const bool by_ranks = evidence.ranks_decide(), is_ratio = by_ranks || evidence.scale == ValueScale::log10;
  const Estimate& of = by_ranks ? pair.ratio : pair.estimate;
  const Estimate difference = first == pair.first ? of : reversed(of, is_ratio);
  return fmt::format(words::interval, "what"_a = by_ranks ? "typical ratio" : scale.difference,
                     "low"_a = rounded_number(difference.low / scale.in_unit, 3),
                     "high"_a = rounded_number(difference.high / scale.in_unit, 3),
                     "unit"_a = is_ratio ? "" : scale.unit);
}

std::string mean_words(const Evidence& evidence, std::size_t group) {
  const Description& of = evidence.groups[group].described;
  const std::string name = name_words(evidence, group);
  const auto [unit, size] = told_unit(evidence);
  if (std::isfinite(of.mean))
    return fmt::format(words::has_mean, "name"_a = name,
                       "mean"_a = rounded_number(of.mean / size, 3) + std::string(unit));
  return fmt::format(words::has_no_mean, "name"_a = name, "lost"_a = of.not_finite, "n"_a = of.n);
}

// "mean 0.0019 vs 0.365, by 0.156 to 0.57, more than 5 %"; by ranks "ahead in 98 % of blocks (mean ...)".
Clause effect_of(const Evidence& evidence, const Finding& pair, std::size_t group) {
  const std::size_t other = other_than(group, pair);
  const double mean = evidence.groups[group].described.mean, of_other = evidence.groups[other].described.mean;
  const double share = better_of(pair) == pair.first ? pair.superiority.value : 1 - pair.superiority.value;
  const std::string ahead =
      std::isnan(share) ? ""
                        : fmt::format(words::ahead, "share"_a = percent(share),
                                      "of"_a = evidence.blocks > 0 ? evidence.block_noun : "pairs of observations");
  if (!std::isfinite(mean + of_other)) return {ahead, {mean_words(evidence, group), mean_words(evidence, other)}};
  const auto [unit, size] = told_unit(evidence);
  const std::string means =
      fmt::format("{} {}", words_of_scale(evidence).average,
                  evidence.scale == ValueScale::share ? fmt::format("{} vs {}", percent(mean), percent(of_other))
                                                      : against(mean / size, of_other / size) + std::string(unit));
  if (evidence.ranks_decide()) return {ahead, {fmt::format(words::not_by_ranks, "means"_a = means)}};
  const auto [extent, remark] = extent_words(evidence, pair);
  const bool has_size = !includes_none(evidence, pair) && !is_against(evidence, pair, &Description::mean) &&
                        std::isfinite(pair.estimate.low + pair.estimate.high);
  std::vector<std::string> parts{means};
  if (has_size) parts.push_back("by " + size_words(evidence, pair));
  if (!extent.empty()) parts.push_back((has_size ? "" : "by ") + extent);
  Clause effect{fmt::format("{}", fmt::join(parts, ", "))};
  if (!remark.empty()) effect.remarks = {remark};
  return effect;
}

// The best group (or the control) against the others.
class Answer {
 public:
  Answer(const Evidence& evidence, Label label, bool is_short)
      : evidence_(evidence),
        best_(evidence.reference.value_or(best_group(evidence))),
        label_(std::move(label)),
        is_short_(is_short) {}

  std::vector<std::string> sentences() {
    say_decided(pairs(Relation::better), "better");
    say_decided(pairs(Relation::worse), "worse");
    if (const Pairs same = pairs(Relation::same); !same.empty()) say_same(same);
    if (const Pairs open = pairs(Relation::undecided); !open.empty()) say_open(open);
    if (const Pairs undefined = pairs(Relation::undefined); !undefined.empty()) say_undefined(undefined);
    return std::move(sentences_);
  }

 private:
  // The pairs of the best with that relation to the other, the best other first.
  Pairs pairs(Relation relation) const {
    Pairs result;
    for (const Finding& pair : evidence_.contrasts) {
      const bool is_own = pair.first == best_ || pair.second == best_;
      if (is_own && (pair.first == best_ ? pair.relation : reversed(pair.relation)) == relation) {
        result.push_back(&pair);
      }
    }
    std::ranges::stable_sort(result, {}, [&](const Finding* pair) {
      return group_score(evidence_, evidence_.groups[other_than(best_, *pair)]);
    });
    return result;
  }
  // Labels tell the value of the best, and of the best other of each sentence; of few others, each value.
  std::string first() const { return sentences_.empty() ? label_(best_) : name_words(evidence_, best_); }
  std::vector<std::string> names_of_others(const Pairs& pairs) const {
    constexpr std::size_t most_labelled = 3;
    std::vector<std::string> names;
    for (const Finding* pair : pairs) {
      const std::size_t other = other_than(best_, *pair);
      names.push_back(names.empty() || pairs.size() <= most_labelled ? label_(other) : name_words(evidence_, other));
    }
    return names;
  }
  std::string others(const Pairs& pairs) const { return listed(names_of_others(pairs)); }
  void say(const Clause& clause, const std::string& doubts = "") {
    const std::string separator = clause.remarks.empty() ? "" : ": ";
    sentences_.push_back(
        (is_short_ ? clause.text + separator + fmt::format("{}", fmt::join(clause.remarks, "; ")) : words_of(clause)) +
        doubts);
  }
  // The others by what is said of their pairs; leaves out pairs of which nothing is said.
  ByReason by_reason(const Pairs& pairs, const std::function<std::string(const Finding&)>& reason_of) const {
    ByReason reasons;
    for (const Finding* pair : pairs) {
      if (const std::string reason = reason_of(*pair); !reason.empty()) {
        reasons[reason].push_back(name_words(evidence_, other_than(best_, *pair)));
      }
    }
    return reasons;
  }
  ByReason reasons_of(const Pairs& pairs) const {
    return by_reason(pairs, [](const Finding& pair) { return pair.why; });
  }
  // ", although the median favours the other"; names the pairs unless it holds for all.
  std::string doubts(const Pairs& pairs) const {
    std::vector<std::string> parts;
    for (const auto& [doubt, names] :
         by_reason(pairs, [&](const Finding& pair) { return doubt_words(evidence_, pair); })) {
      parts.push_back(names.size() == pairs.size() ? doubt : fmt::format("{} ({})", doubt, listed(names)));
    }
    return parts.empty() ? "" : ", although " + listed(parts);
  }
  // The interval that goes with the deciding test.
  const Estimate& interval_of(const Finding& pair) const {
    return evidence_.ranks_decide() ? pair.ratio : pair.estimate;
  }

  // "IK-BA is better than K-ABC and BA (p at most 0.0003)", "Against K-ABC, the best of these: mean ...".
  void say_decided(const Pairs& pairs, std::string_view better) {
    if (pairs.empty()) return;
    double largest_p = not_defined;
    for (const Finding* pair : pairs) largest_p = std::fmax(largest_p, pair->p);
    const Finding& nearest = *pairs.front();
    const bool is_one = pairs.size() == 1;
    const Clause effect = effect_of(evidence_, nearest, best_);
    Clause text{fmt::format(words::decided, "first"_a = first(), "better"_a = better,
                            "by"_a = !evidence_.ranks_decide() ? "" : " by ranks", "others"_a = others(pairs))};
    if (is_one && !is_short_) {
      if (!effect.text.empty()) text.text += ": " + effect.text;
      text.remarks = effect.remarks;
    }
    if (!std::isnan(largest_p)) {
      text.remarks.push_back(is_one || largest_p < 1e-300 ? p_words(largest_p) : "p at most " + at_most(largest_p));
    } else if (is_short_ && nearest.is_fact) {
      text.remarks.emplace_back(words::is_fact);
    }
    say(text, doubts(pairs));
    if (is_one || is_short_) return;
    say({fmt::format(words::nearest, "other"_a = name_words(evidence_, other_than(best_, nearest)),
                     "effect"_a = words_of(effect))});
  }
  void say_same(const Pairs& pairs) {
    const bool is_one = pairs.size() == 1;
    const Finding& front = *pairs.front();
    std::vector<std::string> all = names_of_others(pairs);
    all.insert(all.begin(), first());
    const std::string margin = is_one ? margin_words(evidence_, front) : margin_words(evidence_);
    Clause text{fmt::format(words::same, "all"_a = listed(all), "margin"_a = margin)};
    if (!is_one && !evidence_.plan.control.empty()) {  // the others are not compared with one another
      text = Clause{fmt::format(words::same_as_control, "others"_a = listed(names_of_others(pairs)),
                                "control"_a = first(), "margin"_a = margin)};
    }
    if (is_one && front.is_fact) {
      text.remarks.emplace_back(have_same_bits(evidence_, front) ? words::same_bits : words::is_fact);
    } else if (is_one && !is_short_ && interval_of(front).low < interval_of(front).high) {
      text.remarks = {interval_words(evidence_, front, best_)};
    }
    say(text);
  }
  void say_open(const Pairs& pairs) {
    Clause text{fmt::format(words::undecided, "first"_a = first(), "others"_a = others(pairs))};
    const Finding& front = *pairs.front();
    const bool has_interval = std::isfinite(interval_of(front).low);
    if (pairs.size() == 1) {
      const bool is_equal = front.p == 1 && front.estimate.value == no_difference(evidence_) && !has_interval;
      if (std::isfinite(front.p))
        text.remarks.emplace_back(is_equal ? std::string(words::all_equal) : p_words(front.p));
      if (has_interval && !is_short_) text.remarks.push_back(interval_words(evidence_, front, best_));
    }
    const ByReason reasons = is_short_ ? ByReason() : reasons_of(pairs);
    for (const auto& [reason, names] : reasons) {
      text.remarks.push_back(names.size() == pairs.size() ? reason
                                                          : fmt::format("against {} {}", listed(names), reason));
    }
    say(text, doubts(pairs));
  }
  void say_undefined(const Pairs& pairs) {
    std::vector<std::string> parts;
    for (const auto& [reason, names] : reasons_of(pairs))
      parts.push_back(fmt::format("{} ({})", listed(names), reason));
    say({fmt::format(words::not_judged, "first"_a = first(), "others"_a = is_short_ ? others(pairs) : clauses(parts))});
  }

  const Evidence& evidence_;
  std::size_t best_;
  Label label_;
  bool is_short_;
  std::vector<std::string> sentences_ = {};
};

// "Other pairs that differ (2 of 10; the better first): K-ABC vs BA; ..."
std::vector<std::string> other_pairs_words(const Evidence& evidence) {
  const std::size_t best = evidence.reference.value_or(best_group(evidence));
  std::vector<std::string> differ;
  std::size_t others = 0, undefined = 0, same = 0;
  for (const Finding& pair : evidence.contrasts) {
    if (pair.first == best || pair.second == best) continue;
    ++others;
    undefined += pair.relation == Relation::undefined ? 1 : 0;
    same += pair.relation == Relation::same ? 1 : 0;
    const std::size_t better = better_of(pair);
    if (is_decided(pair)) {
      differ.push_back(
          fmt::format("{} vs {}", name_words(evidence, better), name_words(evidence, other_than(better, pair))));
    }
  }
  std::vector<std::string> sentences;
  if (!differ.empty()) {
    sentences.push_back(
        fmt::format(words::others_differ, "count"_a = differ.size(), "pairs"_a = others, "list"_a = clauses(differ)));
  } else if (undefined < others) {
    const std::string are_same = same == 0 ? ""
                                           : fmt::format(words::others_are_same, "count"_a = same, "pairs"_a = others,
                                                         "margin"_a = margin_words(evidence));
    sentences.push_back(fmt::format(words::others_do_not_differ, "same"_a = are_same));
  }
  if (undefined > 0) {
    sentences.push_back(fmt::format(words::others_not_judged, "count"_a = undefined, "pairs"_a = others));
  }
  return sentences;
}

// "studentized bootstrap, corrected for 3 pairs"
std::string planned_test(const Evidence& evidence) {
  if (evidence.pairs == 1) return std::string(pair_test_words(evidence));
  return fmt::format(words::corrected, "test"_a = pair_test_words(evidence), "pairs"_a = corrected_for(evidence));
}

// The test that decided a pair.
std::string test_of(const Evidence& evidence, const Finding& pair) {
  if (pair.is_fact) return std::string(have_same_bits(evidence, pair) ? words::by_bits : words::by_fact);
  if (pair.is_by_order && has_known(evidence, pair)) return std::string(words::by_sign_of_known);
  if (pair.is_by_order) {
    return fmt::format(words::by_order, "test"_a = evidence.blocks > 0 ? "the sign test" : "the exact test of ranks");
  }
  if (are_constants(evidence, pair))
    return fmt::format(words::by_constants, "test"_a = test_of_constants_words(evidence));
  return planned_test(evidence);
}

}  // namespace

std::string decided_by(const Evidence& evidence) {
  std::vector<std::string> tests;
  for (const Finding& pair : evidence.contrasts) {
    const std::string test = test_of(evidence, pair);
    if (std::ranges::find(tests, test) != tests.end()) continue;
    tests.insert(test == planned_test(evidence) ? tests.begin() : tests.end(), test);
  }
  return fmt::format("{}", fmt::join(tests, "; "));
}

bool has_judged(const Evidence& evidence) {
  return std::ranges::any_of(evidence.contrasts, [](const Finding& c) { return c.relation != Relation::undefined; });
}

std::vector<std::string> answer(const Evidence& evidence) {
  if (evidence.contrasts.empty()) return {};
  if (has_single_values(evidence)) return {std::string(words::single_values)};
  const auto label = [&](std::size_t group) { return name_words(evidence, group); };
  std::vector<std::string> sentences = Answer(evidence, label, false).sentences();
  std::ranges::move(other_pairs_words(evidence), std::back_inserter(sentences));
  if (!evidence.constant && has_judged(evidence)) {
    sentences.push_back(fmt::format(words::decided_by, "tests"_a = decided_by(evidence)));
  }
  return sentences;
}

std::vector<std::string> short_answer(const Evidence& evidence, const Label& label) {
  return Answer(evidence, label, true).sentences();
}

Sentence change_words(const Evidence& evidence, bool tells_extent) {
  bool is_within = false, is_across = false, is_doubted = false;
  for (const Finding& pair : evidence.contrasts) {
    if (!is_decided(pair)) continue;
    is_within = is_within || pair.is_within_margin();
    is_across = is_across || pair.is_across_margin();
    is_doubted = is_doubted || !measures_against(evidence, pair).empty();
  }
  if (evidence.contrasts.empty() || has_single_values(evidence)) return {};
  std::vector<std::string> parts;
  if (!evidence.flaws.empty()) parts.emplace_back(words::sound_observations);
  const auto is_short = [](const GroupEvidence& group) { return group.described.n < 3 && group.copies == 0; };
  if (std::ranges::count(evidence.contrasts, Relation::undefined, &Finding::relation) > 0 &&
      std::ranges::any_of(evidence.groups, is_short)) {
    parts.emplace_back(words::more_than_two);
  }
  if (is_doubted) parts.emplace_back(words::another_measure);
  const std::string margin = margin_words(evidence);
  if (is_within && tells_extent) parts.push_back(fmt::format(words::smaller_margin, "margin"_a = margin));
  if (is_across && tells_extent) parts.push_back(fmt::format(words::larger_margin, "margin"_a = margin));
  parts.emplace_back(words::other_conditions);
  return {"What would change it", fmt::format("{}.", fmt::join(parts, "; "))};
}

}  // namespace ikbench::report
