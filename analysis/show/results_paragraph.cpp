#include "analysis/show/results_paragraph.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

#include "analysis/show/phrases.hpp"
#include "analysis/show/result_tables.hpp"
#include "analysis/show/text.hpp"
#include "base/names.hpp"
#include "base/number.hpp"

namespace ikbench::show {

using namespace judge;
using Names = std::vector<std::string>;
using Pairs = std::vector<Comparison>;

namespace {

constexpr std::size_t max_in_sentence = 4;  // comparisons
constexpr std::size_t max_averages = 6;

bool is_solved_share(const JudgedMetric& judged) { return judged.samples.quantity_kind == QuantityKind::solved; }

// Averages.

// A solver's average, as text and as number.
struct Average {
  std::string solver, text;
  double value;
};

// Returns the known averages of a metric, best first. Counts are those of single trials.
std::vector<Average> averages_of(const ReportModel& model, const JudgedMetric& judged, bool are_counts) {
  std::vector<Average> averages;
  for (const std::string& solver : model.solvers()) {
    const std::size_t group = index_of(judged.samples, solver);
    if (group == judged.samples.groups.size()) continue;
    const auto [value, is_bound] = displayed_average(judged, group);
    if (std::isnan(value)) continue;
    const int n = judged.descriptives[group].n;
    std::string text = number_within(value, percent_boundaries(judged));
    if (is_bound) text = "at most " + text;
    if (are_counts) text = fmt::format("{:.0f}", value * n / 100);
    averages.push_back({name_in_sentence(solver), text, value});
  }
  std::ranges::stable_sort(averages, [&](const Average& first, const Average& second) {
    return judged.samples.better == Better::larger ? first.value > second.value : first.value < second.value;
  });
  return averages;
}

// Returns "All 100 targets were solved by LM and DLS, 99 by SLSQP, and 35 by PSO"; of many solvers the best and the
// range.
std::string solved_sentence(const ReportModel& model, const JudgedMetric& judged) {
  std::set<int> sizes;
  for (const Descriptives& shares : judged.descriptives) sizes.insert(shares.n);
  const bool are_counts = trials_per_value(judged.samples) == 1 && sizes.size() == 1;
  const std::vector<Average> averages = averages_of(model, judged, are_counts);
  if (averages.empty()) return "";
  const std::string limit = model.time_limit.empty() ? "" : fmt::format("Within {}, ", model.time_limit);
  const std::string whole = are_counts ? base::counted(*sizes.begin(), model.noun) : "targets";
  const std::string unit = are_counts ? "" : " %";
  std::vector<std::pair<std::string, Names>> by_text;  // best first
  for (const Average& average : averages) {
    if (by_text.empty() || by_text.back().first != average.text) by_text.push_back({average.text, {}});
    by_text.back().second.push_back(average.solver);
  }
  const auto& [best, firsts] = by_text.front();
  const bool is_all = averages.front().value == 100;
  if (averages.front().value == 0)
    return as_sentence(fmt::format("{}no solver reached any of the {}.", limit, are_counts ? whole : "targets"));
  const std::string who = firsts.size() > max_averages ? number_word(firsts.size()) + " solvers" : enumerated(firsts);
  const std::string share = is_all ? "all " + whole : fmt::format("{}{} of {}", best, unit, whole);
  std::string text = as_sentence(fmt::format("{}{} were solved by {}", limit, share, who));
  const std::size_t others = averages.size() - firsts.size();
  if (others == 0) return text + '.';
  if (others > max_averages) {
    const std::string low = by_text.back().first, high = by_text[1].first + unit;
    return by_text.size() == 2
               ? fmt::format("{}, and {} by each of the {} others.", text, high, number_word(others))
               : fmt::format("{}, and {} to {} by the {} others.", text, low, high, number_word(others));
  }
  for (auto group = by_text.begin() + 1; group != by_text.end(); ++group) {
    const bool is_last = group + 1 == by_text.end();
    text += fmt::format(", {}{}{} by {}", is_last ? "and " : "", group->first, unit, enumerated(group->second));
  }
  return text + '.';
}

// Returns "The median position error was 1 mm with A and 2 mm with B"; of many solvers the best and the range.
std::string average_sentence(const ReportModel& model, const JudgedMetric& judged) {
  const std::vector<Average> averages = averages_of(model, judged, false);
  if (averages.empty()) return "";
  const MetricSamples& samples = judged.samples;
  const bool are_means = is_success_rate(judged) || judged.plan.test == results::AnalysisPlan::Test::means;
  const std::string average = are_means ? "mean " : "median ";
  const std::string subject = fmt::format("The {}{} was", is_log_scale(samples) ? "" : average, samples.quantity);
  const auto with = [&](const Average& of) {
    return fmt::format("{} with {}", with_unit(of.text, samples.unit), of.solver);
  };
  if (averages.size() <= max_averages) {
    Names texts;
    std::ranges::transform(averages, std::back_inserter(texts), with);
    return fmt::format("{} {}.", subject, enumerated(texts));
  }
  const std::string low = averages[1].text, high = averages.back().text;
  const std::string others = number_word(averages.size() - 1);
  const std::string of_others =
      low == high ? fmt::format("{} with each of the {} others", with_unit(high, samples.unit), others)
                  : fmt::format("{} to {} with the {} others", low, with_unit(high, samples.unit), others);
  return fmt::format("{} {} and {}.", subject, with(averages.front()), of_others);
}

// Returns whether no solver of a study solved a target.
bool is_nothing_solved(const ReportModel& model) {
  const auto is_zero = [](const Descriptives& shares) { return shares.mean == 0; };
  return std::ranges::any_of(model.metrics, [&](const JudgedMetric& judged) {
    return is_solved_share(judged) && std::ranges::all_of(judged.descriptives, is_zero);
  });
}

// Returns the sentences on the averages of the first metric. If no target was solved, that comes first.
std::vector<std::string> first_sentences(const ReportModel& model) {
  const JudgedMetric& primary = model.primary();
  if (is_solved_share(primary)) return {solved_sentence(model, primary)};
  if (!is_nothing_solved(model)) return {average_sentence(model, primary)};
  const std::string solver = model.time_limit.empty() ? "No" : fmt::format("Within {}, no", model.time_limit);
  return {solver + " solver reached any target.", average_sentence(model, primary)};
}

// Pairs.

// Returns a number that is not rounded onto any of `ends`.
std::string exact_text(double value, const Boundaries& ends) {
  for (int digits = 3; digits < 12; ++digits) {
    std::string text = number_text(value, digits);
    const double read = base::number_from(text).value_or(value);
    if (read == value || std::ranges::count(ends, read) == 0) return text;
  }
  return number_text(value);
}

// Returns "[0.5, 0.8]", with a round bracket at an end that the interval excludes.
std::string bracketed(const Interval& interval, const Boundaries& ends) {
  return fmt::format("{}{}, {}{}", interval.excludes_low ? '(' : '[', exact_text(interval.low, ends),
                     exact_text(interval.high, ends), interval.excludes_high ? ')' : ']');
}

std::string with_interval(double value, const std::optional<Interval>& interval, const std::string& unit,
                          const Boundaries& ends) {
  const std::string text = with_unit(exact_text(value, ends), unit);
  return interval ? fmt::format("{} {}", text, bracketed(*interval, ends)) : text;
}

bool estimates_ratio(const Comparison& comparison) { return comparison.scale == EffectScale::ratio; }

// Returns the numbers of a pair: "ratio 0.69 [0.51, 0.8], A12 = 0.75 [0.6, 0.9], p = 0.02".
std::string numbers_of(const Comparison& comparison, const JudgedMetric& judged) {
  Names texts;
  const auto* const tested = std::get_if<TestResult>(&comparison.result);
  if (all_values_equal(comparison)) return tested ? fmt::format("all {} values equal", tested->n) : "all values equal";
  if (comparison.estimate) {
    const std::set<double> ends = null_and_margin(comparison, judged);
    const auto& [value, interval] = *comparison.estimate;
    texts.push_back(
        fmt::format("{} {}", estimates_ratio(comparison) ? "ratio" : "difference",
                    with_interval(value, interval, estimates_ratio(comparison) ? "" : estimate_unit(comparison, judged),
                                  {ends.begin(), ends.end()})));
  }
  if (tested && tested->hedges_g) {
    texts.push_back(fmt::format("{} = {}", judged.samples.is_paired ? "g_av" : "g", number_text(*tested->hedges_g)));
  } else if (tested && shows_a12(*tested, judged)) {
    texts.push_back("A12 = " + with_interval(tested->dominance->a12(), tested->dominance->interval, "", {0.5}));
  }
  if (tested) {
    const std::string p = p_text(tested->adjusted_p, {judged.plan.significance});
    texts.push_back((p[0] == '<' || p[0] == '>' ? "p " : "p = ") + p);
    if (is_difference(tested->verdict) && tested->is_below_margin) texts.push_back("less than " + margin_text(judged));
  }
  if (std::holds_alternative<DeterministicResult>(comparison.result)) texts.emplace_back("both deterministic");
  if (is_not_tested(comparison, NotTestedReason::dominated)) texts.emplace_back("a few values dominate");
  return fmt::format("{}", fmt::join(texts, ", "));
}

// The words between the solvers of pairs with one outcome.
struct Relation {
  std::string before = {}, is, are, after = {};  // "is" for one first solver, "are" for several
};

// Returns "A was better than B (...) and C (...)", or "A (...) and B (...) were better than C".
std::string related(const Pairs& pairs, const Relation& relation, const auto& details) {
  const auto with_details = [&](const std::string& name, const Comparison& pair) {
    const std::string text = details(pair);
    return text.empty() ? name : fmt::format("{} ({})", name, text);
  };
  const auto have_second = [&](const Comparison& pair) { return pair.second == pairs.front().second; };
  if (pairs.size() > 1 && std::ranges::all_of(pairs, have_second)) {
    Names firsts;
    for (const Comparison& pair : pairs) firsts.push_back(with_details(pair.first, pair));
    return fmt::format("{}{} {} {}{}", relation.before, enumerated(firsts), relation.are, pairs.front().second,
                       relation.after);
  }
  std::vector<std::pair<std::string, Names>> by_first;
  for (const Comparison& pair : pairs) {
    if (by_first.empty() || by_first.back().first != pair.first) by_first.push_back({pair.first, {}});
    by_first.back().second.push_back(with_details(pair.second, pair));
  }
  Names texts;
  for (const auto& [first, seconds] : by_first)
    texts.push_back(
        fmt::format("{}{} {} {}", texts.empty() ? relation.before : "", first, relation.is, enumerated(seconds)));
  return fmt::format("{}{}", fmt::join(texts, ", and "), relation.after);
}

// Returns the smallest and the largest of what the pairs have: "ratios of 0.1 to 0.3 and p of at most 0.001".
std::string range_text(const Pairs& pairs, const JudgedMetric& judged) {
  std::vector<double> estimates;
  std::set<double> ends;
  double largest_p = 0;
  std::size_t below_margin = 0;
  for (const Comparison& pair : pairs) {
    if (pair.estimate) estimates.push_back(pair.estimate->value);
    ends.merge(null_and_margin(pair, judged));
    const auto* const tested = std::get_if<TestResult>(&pair.result);
    if (tested == nullptr) continue;
    largest_p = std::max(largest_p, tested->adjusted_p);
    if (is_difference(tested->verdict) && tested->is_below_margin) ++below_margin;
  }
  const std::string p = p_text(largest_p, {judged.plan.significance});
  const std::string p_clause = p[0] == '<' ? "p " + p : "p of at most " + p;
  if (estimates.empty()) return p_clause;
  const auto [smallest, largest] = std::ranges::minmax(estimates);
  const bool are_ratios = estimates_ratio(pairs.front());
  const Boundaries boundaries{ends.begin(), ends.end()};
  const std::string low = exact_text(smallest, boundaries), high = exact_text(largest, boundaries);
  const std::string unit = are_ratios ? "" : estimate_unit(pairs.front(), judged);
  std::string text = fmt::format("{} of {}{} and {}", are_ratios ? "ratios" : "differences",
                                 low == high ? "" : low + " to ", with_unit(high, unit), p_clause);
  if (below_margin == pairs.size())
    text += ", each less than " + margin_text(judged);
  else if (below_margin > 0)
    text += fmt::format(", {} of them less than {}", below_margin, margin_text(judged));
  return text;
}

// Returns "A was better than five others", "Five others were better than A", or, if the pairs have no solver in common,
// "Five further comparisons were decided".
std::string related_to_many(const Pairs& pairs, const Relation& relation, const std::string& outcome) {
  const Comparison& one = pairs.front();
  const std::string count = number_word(pairs.size());
  if (std::ranges::all_of(pairs, [&](const Comparison& pair) { return pair.first == one.first; }))
    return fmt::format("{}{} {} {} others{}", relation.before, one.first, relation.is, count, relation.after);
  if (std::ranges::all_of(pairs, [&](const Comparison& pair) { return pair.second == one.second; }))
    return as_sentence(
        fmt::format("{}{} others {} {}{}", relation.before, count, relation.are, one.second, relation.after));
  return as_sentence(fmt::format("{} further comparisons were {}", count, outcome));
}

// Writes the sentences about the pairs of one question.
class PairsWriter {
 public:
  PairsWriter(const ReportModel& model, const HeadlineQuestion& question)
      : model_(model), question_(question), judged_(model.metrics[question.metric]) {}

  std::vector<std::string> sentences() {
    Pairs better, equivalent, inconclusive, not_tested;
    for (Comparison& pair : named_pairs()) {
      pair.first = name_in_sentence(pair.first);
      pair.second = name_in_sentence(pair.second);
      switch (verdict_of(pair)) {
        case Verdict::better:
        case Verdict::worse:
          better.push_back(better_first(std::move(pair), ""));
          break;
        case Verdict::equivalent:
          equivalent.push_back(std::move(pair));
          break;
        case Verdict::inconclusive:
          inconclusive.push_back(std::move(pair));
          break;
        case Verdict::not_tested:
          not_tested.push_back(std::move(pair));
          break;
      }
    }
    const bool are_ranks =
        std::ranges::count(judged_.samples.warnings, WarningKind::ranks_disagree, &Warning::kind) > 0;
    const std::string than = are_ranks ? "ranked better than" : "better than";
    add(better, {.is = are_ranks ? than : "was " + than, .are = are_ranks ? than : "were " + than}, "decided");
    add(equivalent,
        {.is = "was equivalent to", .are = "were equivalent to", .after = " within " + margin_text(judged_)},
        "equivalent within " + margin_text(judged_));
    add(inconclusive,
        {.before = inconclusive.size() == 1 ? "the comparison of " : "the comparisons of ",
         .is = "with",
         .are = "with",
         .after = inconclusive.size() == 1 ? " was inconclusive" : " were inconclusive"},
        "inconclusive");
    add_not_tested(not_tested);
    return sentences_;
  }

 private:
  const ReportModel& model_;
  const HeadlineQuestion& question_;
  const JudgedMetric& judged_;
  std::vector<std::string> sentences_ = {};

  // Returns all pairs of the question if they are few. Otherwise those of its best solver, and those that a statement
  // of the headline is about.
  Pairs named_pairs() const {
    const Names& solvers = question_.solvers;
    const auto is_asked = [&](const std::string& name) { return std::ranges::count(solvers, name) > 0; };
    Pairs pairs;
    std::ranges::copy_if(judged_.comparisons, std::back_inserter(pairs),
                         [&](const Comparison& pair) { return is_asked(pair.first) && is_asked(pair.second); });
    if (pairs.size() <= max_pairs || !judged_.plan.control.empty()) return pairs;
    std::set<std::pair<std::string, std::string>> named;
    for (const Statement& statement : question_.statements) {
      const bool has_winner = statement.kind == Statement::StatementKind::best || statement.against.empty();
      const std::string& anchor = has_winner ? statement.solvers.front() : statement.against.front();
      for (const std::string& name : statement.solvers) named.emplace(std::minmax(anchor, name));
      for (const std::string& name : statement.against) named.emplace(std::minmax(anchor, name));
    }
    std::erase_if(pairs, [&](const Comparison& pair) { return !named.contains(std::minmax(pair.first, pair.second)); });
    return pairs;
  }

  // Adds a sentence, of which the first of the question names the metric. The name of a solver keeps its first letter.
  void add_sentence(const std::string& text, bool begins_with_name) {
    if (sentences_.empty()) return sentences_.push_back(fmt::format("In {}, {}.", judged_.samples.quantity, text));
    sentences_.push_back((begins_with_name ? text : as_sentence(text)) + '.');
  }

  // Adds a sentence for every four pairs, at most two; of more than eight pairs the second sentence has the range.
  void add(const Pairs& pairs, const Relation& relation, const std::string& outcome) {
    const auto numbers = [&](const Comparison& pair) { return numbers_of(pair, judged_); };
    const auto few = static_cast<std::ptrdiff_t>(std::min(pairs.size(), max_in_sentence));
    if (pairs.empty()) return;
    const bool begins_with_name = relation.before.empty();
    add_sentence(related({pairs.begin(), pairs.begin() + few}, relation, numbers), begins_with_name);
    const Pairs others(pairs.begin() + few, pairs.end());
    if (others.empty()) return;
    if (others.size() <= max_in_sentence) return add_sentence(related(others, relation, numbers), begins_with_name);
    add_sentence(fmt::format("{}, with {}", related_to_many(others, relation, outcome), range_text(others, judged_)),
                 begins_with_name);
  }

  // Adds a sentence on the pairs without a test, with their reason if they have one in common.
  void add_not_tested(const Pairs& pairs) {
    if (pairs.empty()) return;
    std::set<std::string> reasons;
    for (const Comparison& pair : pairs) reasons.insert(reason_of(pair));
    const std::string reason = reasons.size() == 1 ? fmt::format(" ({})", *reasons.begin()) : "";
    const auto none = [](const Comparison&) { return std::string(); };
    if (std::ranges::all_of(judged_.comparisons,
                            [](const Comparison& pair) { return verdict_of(pair) == Verdict::not_tested; }))
      return add_sentence("no pair was tested" + reason, false);
    if (pairs.size() > max_in_sentence)
      return add_sentence(fmt::format("{} pairs were not tested{}", number_word(pairs.size()), reason), false);
    add_sentence(related(pairs, {.is = "was not tested against", .are = "were not tested against"}, none) + reason,
                 true);
  }

  // Returns why a pair is not tested, without the advice that a screen has behind a semicolon.
  std::string reason_of(const Comparison& pair) const {
    const auto& not_tested = std::get<NotTested>(pair.result);
    const std::string reason = reason_in_metric(not_tested, judged_, observation_noun(model_, judged_));
    return reason.substr(0, reason.find(';'));
  }
};

}  // namespace

std::vector<std::string> results_sentences(const ReportModel& model) {
  std::vector<std::string> sentences = first_sentences(model);
  for (const HeadlineQuestion& question : model.questions)
    std::ranges::move(PairsWriter(model, question).sentences(), std::back_inserter(sentences));
  std::erase(sentences, "");
  if (sentences.size() > max_result_sentences) sentences.resize(max_result_sentences);
  return sentences;
}

std::string pairs_predicate(const ReportModel& model) {
  std::size_t all = 0, untested = 0;
  for (const JudgedMetric& judged : model.metrics) {
    if (!model.is_in_headline(judged)) continue;
    all += judged.comparisons.size();
    untested += static_cast<std::size_t>(std::ranges::count(judged.comparisons, Verdict::not_tested, verdict_of));
  }
  const std::size_t shown = pairs_table(model).visible_rows;
  if (shown == 0 || untested == all) return "";
  if (shown < all) return fmt::format("has the {} comparisons with {}", shown, reference_of(model));
  if (all == 1) return "has this comparison";
  return all == 2 ? "has both comparisons" : fmt::format("has all {} comparisons", all);
}

}  // namespace ikbench::show
