#include "analysis/report/variants_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <string_view>
#include <utility>

#include "analysis/inference/margin.hpp"
#include "analysis/inference/not_finite.hpp"
#include "analysis/inference/outcomes.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/json.hpp"
#include "analysis/report/words.hpp"

namespace ikbench::report {

using namespace results;
using namespace statistics;
using namespace inference;
using namespace fmt::literals;

namespace {

constexpr std::size_t most_labels = 12;

using Comparisons = std::span<const VariantComparison>;

std::string metric_words(const MetricComparison& metric) {
  return metric.estimand == Estimand::mean ? std::string(name_of(metric.metric))
                                           : fmt::format("{} ({})", name_of(metric.metric), name_of(metric.estimand));
}

bool is_of_shares(const MetricComparison& metric) { return metric.observed.scale == ValueScale::share; }

// Number of observations of A (group 0) or B (group 1).
int number_of(const MetricComparison& metric, std::size_t group) {
  return metric.is_compared() ? metric.evidence.groups[group].described.n : 0;
}

// The mean of what is finite; in pairs, of the pairs that are.
double mean_of(const MetricComparison& metric, std::size_t group) {
  if (!metric.is_compared()) return not_defined;
  const double of_values = mean(of_finite(metric.observed).groups[group].values);
  return metric.observed.scale == ValueScale::log10 ? std::pow(10, of_values) : of_values;
}

// "run" or "target": what one observation is of.
std::string_view noun_of(const Observations& observed) {
  return observed.blocks.empty() || observed.block_noun == "runs" ? "run" : "target";
}

// The ratio B / A. For means it follows from the interval of their difference; typical values and ranks have a ratio
// already.
Estimate ratio_of(const MetricComparison& metric) {
  const Finding finding = metric.finding();
  if (metric.evidence.ranks_decide()) return reversed(finding.ratio, true);
  if (finding.is_ratio) return reversed(finding.estimate, true);
  const double mean_a = mean_of(metric, 0);
  if (!(mean_a > 0)) return {};
  const double most = is_of_shares(metric) ? 1 / mean_a : HUGE_VAL;
  const auto ratio = [&](double apart) {  // A - B
    return std::isfinite(apart) ? std::clamp(1 - apart / mean_a, 0.0, most) : not_defined;
  };
  return {
      .value = mean_of(metric, 1) / mean_a, .low = ratio(finding.estimate.high), .high = ratio(finding.estimate.low)};
}

// The margin of a metric: "5 % or 0.01 cm", of shares "5 percentage points".
std::string margin_words(Comparisons comparisons, const AnalysisPlan& plan, const MetricComparison& metric) {
  if (is_of_shares(metric)) return points(plan.margin);
  const auto is_in_cm = [](const MetricComparison& each) { return info_of(each.metric).unit == "cm"; };
  return inference::margin_words(plan.margin, any_metric(comparisons, is_in_cm) ? plan.margin_cm : 0);
}

// The margin of all metrics: "5 % (shares: 5 percentage points)".
std::string margin_words(Comparisons comparisons, const AnalysisPlan& plan) {
  std::string of_shares, of_others;
  for (const VariantComparison& comparison : comparisons) {
    for (const MetricComparison& metric : comparison.metrics)
      (is_of_shares(metric) ? of_shares : of_others) = margin_words(comparisons, plan, metric);
  }
  if (of_shares.empty() || of_others.empty()) return of_shares + of_others;
  return fmt::format(words::margins, "margin"_a = of_others, "of_shares"_a = of_shares);
}

bool has_same_bits(const MetricComparison& metric) {
  return metric.finding().is_fact && metric.observed.groups.front().bits > 0;
}

// The verdict on B: "better", "worse by less than 5 %".
std::string b_is(const MetricComparison& metric, const std::string& margin) {
  if (!metric.is_compared()) {
    std::set<std::string_view> reasons;
    for (const Doubt& doubt : metric.why_not) reasons.insert(brief_of(doubt.kind));
    if (!metric.refused.empty()) reasons.insert("no margin");
    reasons.erase("");
    return fmt::format("not compared{}{}", reasons.empty() ? "" : ": ", fmt::join(reasons, ", "));
  }
  const Finding found = metric.finding();
  const auto sized = [&](std::string_view word) {
    return found.is_within_margin()   ? fmt::format(words::by_less, "word"_a = word, "margin"_a = margin)
           : found.is_beyond_margin() ? fmt::format(words::by_more, "word"_a = word, "margin"_a = margin)
           : found.is_across_margin() ? fmt::format(words::perhaps_by_less, "word"_a = word, "margin"_a = margin)
                                      : fmt::format(words::by_unknown, "word"_a = word);
  };
  switch (found.relation) {
    case Relation::better:
      return sized("worse");
    case Relation::worse:
      return sized("better");
    case Relation::same:
      return has_same_bits(metric) ? std::string(words::the_same_bits) : "the same within " + margin;
    case Relation::undefined:
      return "cannot be judged";
    default:
      return "undecided";
  }
}

std::string not_finite_words(const Observations& observed) {
  std::vector<std::string> parts;
  for (const Group& group : observed.groups) {
    const std::size_t lost = count_not_finite(group);
    if (lost > 0)
      parts.push_back(fmt::format("{} of {} {}s of {}", lost, group.values.size(), noun_of(observed), group.name));
  }
  return parts.empty() ? "" : fmt::format(words::lost, "list"_a = fmt::join(parts, ", "));
}

std::string remark_on(const MetricComparison& metric, double significance) {
  if (!metric.refused.empty()) return metric.refused;
  if (!metric.is_compared()) return metric.is_counted ? "see below" : "nobody counted";
  const Finding found = metric.finding();
  if (found.is_fact) return std::string(has_same_bits(metric) ? words::equal_bits : words::repeats_itself);
  std::vector<std::string> parts{not_finite_words(metric.observed)};
  if (found.relation == Relation::undefined || !found.why.empty()) {
    parts.push_back(found.why);
  } else if (found.relation == Relation::undecided) {
    if (found.p >= metric.level() && found.p < significance)
      parts.push_back(fmt::format(words::by_itself, "better"_a = found.ahead < 0 ? "better" : "worse"));
  } else if (found.relation != Relation::better && !metric.evidence.ranks_decide()) {
    parts.push_back(inference::rare_failures_words(std::min(number_of(metric, 0), number_of(metric, 1)),
                                                   fmt::format("{}s", noun_of(metric.observed)), metric.level()));
  }
  std::erase(parts, "");
  return fmt::format("{}", fmt::join(parts, "; "));
}

std::vector<Cell> row_of(const VariantComparison& comparison, const MetricComparison& metric, const std::string& margin,
                         double significance) {
  const Estimate ratio = ratio_of(metric);
  const Finding found = metric.finding(), of_b = reversed(found);
  const auto unless_fact = [&](double value) { return found.is_fact ? not_defined : value; };
  const std::string remark = remark_on(metric, significance);
  return {comparison.label,
          metric_words(metric),
          b_is(metric, margin),
          std::int64_t{number_of(metric, 0)},
          std::int64_t{number_of(metric, 1)},
          mean_of(metric, 0),
          mean_of(metric, 1),
          or_nothing(ratio.value),
          or_nothing(ratio.low),
          or_nothing(ratio.high),
          or_nothing(PValue{unless_fact(found.p)}),
          or_nothing(PValue{metric.is_compared() ? unless_fact(metric.level()) : not_defined}),
          or_nothing(unless_fact(of_b.superiority.value)),
          or_nothing(unless_fact(of_b.superiority.low)),
          or_nothing(unless_fact(of_b.superiority.high)),
          remark.empty() ? Cell() : Cell(remark)};
}

std::string label_of(Comparisons comparisons, const VariantComparison& comparison) {
  return comparisons.size() == 1 ? "" : comparison.label + ": ";
}

// Says what an observation is, and whether observations are in pairs. Their number is the largest of the metrics.
std::string design_words(const VariantComparison& comparison) {
  const auto metric = std::ranges::max_element(
      comparison.metrics, {}, [](const MetricComparison& each) { return number_of(each, 0) + number_of(each, 1); });
  if (metric == comparison.metrics.end() || !metric->is_compared()) return "";
  const Observations& observed = metric->observed;
  return fmt::format(fmt::runtime(observed.blocks.empty() ? words::independent_runs : words::pairs),
                     "a"_a = number_of(*metric, 0), "b"_a = number_of(*metric, 1), "of"_a = noun_of(observed),
                     "what"_a = observed.replicate, "pair"_a = observed.block);
}

// "position_error_cm (from 0.2 to 0.42, 2.1 times A's, interval 1.8 to 2.5, p 0.0003)"
std::string regression(const MetricComparison& metric) {
  std::vector<std::string> facts{
      fmt::format("from {} to {}", short_number(mean_of(metric, 0)), short_number(mean_of(metric, 1)))};
  const Estimate ratio = ratio_of(metric);
  if (std::isfinite(ratio.value)) facts.push_back(fmt::format("{} times A's", short_number(ratio.value)));
  if (std::isfinite(ratio.low))
    facts.push_back(fmt::format("interval {} to {}", short_number(ratio.low), short_number(ratio.high)));
  const Finding found = metric.finding();
  facts.push_back(found.is_fact ? "no test" : fmt::format("p {}", short_number(found.p)));
  return fmt::format("{} ({})", metric_words(metric), fmt::join(facts, ", "));
}

std::string regressions(Comparisons comparisons) {
  std::vector<std::string> found;
  for (const VariantComparison& comparison : comparisons) {
    for (const MetricComparison& metric : comparison.metrics) {
      if (is_regression(metric)) found.push_back(label_of(comparisons, comparison) + regression(metric));
    }
  }
  const std::size_t named = std::min(found.size(), most_labels);
  return fmt::format("{}{}", fmt::join(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(named), "; "),
                     found.size() == named ? "" : fmt::format(" and {} more", found.size() - named));
}

// The metrics that nothing decides.
std::string undecided_metrics(const VariantComparison& comparison) {
  std::vector<std::string> found;
  for (const MetricComparison& metric : comparison.metrics) {
    if (!metric.is_compared() || metric.finding().relation != Relation::undecided) continue;
    found.push_back(metric_words(metric));
  }
  return fmt::format("{}", fmt::join(found, ", "));
}

// The metrics in which B is better by more than the margin.
std::string better_metrics(const VariantComparison& comparison) {
  std::vector<std::string> found;
  for (const MetricComparison& metric : comparison.metrics) {
    if (!metric.is_compared()) continue;
    const Finding finding = metric.finding();
    if (finding.relation == Relation::worse && finding.is_beyond_margin()) found.push_back(metric_words(metric));
  }
  return fmt::format("{}", fmt::join(found, ", "));
}

}  // namespace

Table variants_table(Comparisons comparisons, const AnalysisPlan& plan) {
  Table table{.name = "comparison",
              .caption = fmt::format("B compared with A, with a margin of {}", margin_words(comparisons, plan)),
              .columns = {"label", "metric", "B_is", "n_A", "n_B", "mean_A", "mean_B", "B_by_A", "low", "high", "p",
                          "level", "a12", "a12_low", "a12_high", "remark"},
              .notes = {std::string(words::comparison_columns)}};
  for (const VariantComparison& comparison : comparisons) {
    for (const MetricComparison& metric : comparison.metrics)
      table.rows.push_back(row_of(comparison, metric, margin_words(comparisons, plan, metric), plan.significance));
  }
  return table;
}

Table short_table(const Table& table) {
  constexpr std::array<std::string_view, 6> columns{"label", "metric", "B_is", "mean_A", "mean_B", "B_by_A"};
  Table result = with_columns(table, columns);
  result.columns.insert(result.columns.end(), {"interval", "p"});
  const auto column = [&](std::string_view name) {
    return std::ranges::find(table.columns, name) - table.columns.begin();
  };
  const auto low = column("low"), high = column("high"), p = column("p");
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    const auto cells = table.rows[r].begin();
    result.rows[r].push_back(
        is_empty(cells[low]) ? Cell() : Cell(Range{std::get<double>(cells[low]), std::get<double>(cells[high])}));
    result.rows[r].push_back(cells[p]);
  }
  return result;
}

std::string verdict_of(Comparisons comparisons, const MetricComparison& metric, const AnalysisPlan& plan) {
  return b_is(metric, margin_words(comparisons, plan, metric));
}

std::vector<std::string> variants_notes(Comparisons comparisons) {
  std::vector<std::string> notes;
  const auto is_of_all = [&](const std::string& note) {
    return std::ranges::all_of(comparisons, [&](const VariantComparison& comparison) {
      return design_words(comparison) == note || std::ranges::find(comparison.notes, note) != comparison.notes.end();
    });
  };
  const auto add = [&](const VariantComparison& comparison, const std::string& note) {
    if (note.empty()) return;
    const std::string text = is_of_all(note) ? note : label_of(comparisons, comparison) + note;
    if (std::ranges::find(notes, text) == notes.end()) notes.push_back(text);
  };
  for (const VariantComparison& comparison : comparisons) add(comparison, design_words(comparison));
  for (const VariantComparison& comparison : comparisons) {
    for (const std::string& note : comparison.notes) add(comparison, note);
  }
  return notes;
}

std::string variants_verdict(Comparisons comparisons, const AnalysisPlan& plan) {
  std::vector<std::pair<std::string, int>> counts;  // "2 better by more than 5 %", in the order of first occurrence
  int count = 0;
  for (const VariantComparison& comparison : comparisons) {
    for (const MetricComparison& metric : comparison.metrics) {
      const std::string said = verdict_of(comparisons, metric, plan);
      auto found = std::ranges::find(counts, said, &std::pair<std::string, int>::first);
      if (found == counts.end()) found = counts.insert(found, {said, 0});
      ++found->second;
      ++count;
    }
  }
  std::vector<std::string> parts;
  for (const auto& [said, number] : counts) parts.push_back(fmt::format("{} {}", number, said));
  const std::string margin = margin_words(comparisons, plan);
  const std::string rest = fmt::format(words::comparisons, "count"_a = count, "s"_a = count == 1 ? "" : "s",
                                       "counts"_a = fmt::join(parts, ", "));
  const bool is_of_two = comparisons.size() == 1 && comparisons.front().is_of_two;  // then nothing regresses
  const auto said = [&](words::Template of_variants, words::Template of_two) {
    return fmt::runtime(is_of_two ? of_two : of_variants);
  };
  const std::string label = comparisons.empty() ? "" : comparisons.front().label;
  if (any_metric(comparisons, is_regression))
    return fmt::format(said(words::regression, words::worse), "label"_a = label, "margin"_a = margin,
                       "list"_a = regressions(comparisons), "rest"_a = rest);
  const std::string undecided = is_of_two ? undecided_metrics(comparisons.front()) : "";
  if (!undecided.empty())
    return fmt::format(words::not_decided, "label"_a = label, "list"_a = undecided, "rest"_a = rest);
  const auto is_unknown = [](const MetricComparison& metric) { return is_open(metric) || !metric.is_counted; };
  const std::string better = is_of_two ? better_metrics(comparisons.front()) : "";
  return fmt::format(better.empty() ? said(words::no_regression, words::not_worse) : fmt::runtime(words::better_in),
                     "label"_a = label, "margin"_a = margin, "list"_a = better,
                     "found"_a = any_metric(comparisons, is_unknown) ? " was found" : "", "rest"_a = rest);
}

std::string variants_json(Comparisons comparisons, const AnalysisPlan& plan, const Outcome& outcome) {
  Json json{{"outcome", outcome.name},
            {"exit_code", outcome.exit_code},
            {"verdict", variants_verdict(comparisons, plan)},
            {"margin", plan.margin},
            {"margin_cm", plan.margin_cm},
            {"significance", plan.significance},
            {"notes", variants_notes(comparisons)},
            {"rows", rows_json(variants_table(comparisons, plan))}};
  return numerics::text_of(json, 2) + "\n";
}

}  // namespace ikbench::report
