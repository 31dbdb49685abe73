#include "analysis/report/variants_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "analysis/inference/margin.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/words.hpp"
#include "numerics/json.hpp"

namespace ikbench::report {

using namespace results;
using namespace statistics;
using namespace inference;
using namespace fmt::literals;

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_labels = 12;

// Returns an empty cell if nothing is defined.
Cell defined(double value) { return std::isfinite(value) ? Cell(value) : Cell(); }
Cell p_value(double value) { return std::isfinite(value) ? Cell(PValue{value}) : Cell(); }

std::string metric_words(const MetricComparison& metric) {
  return metric.estimand == Estimand::mean ? std::string(name_of(metric.metric))
                                           : fmt::format("{} ({})", name_of(metric.metric), name_of(metric.estimand));
}

bool is_of_shares(const MetricComparison& metric) { return metric.scale == ValueScale::share; }

// The ratio B / A. For means it follows from the interval of their difference; typical values and ranks have a ratio
// already.
Estimate ratio_of(const MetricComparison& metric) {
  const auto inverse = [](const Estimate& of) {
    return Estimate{.value = 1 / of.value, .low = 1 / of.high, .high = 1 / of.low};
  };
  if (metric.is_by_ranks) return inverse(metric.contrast.ratio);
  if (metric.estimand == Estimand::typical) return inverse(metric.contrast.difference);
  if (!(metric.mean_a > 0)) return {};
  const Estimate& difference = metric.contrast.difference;  // A - B
  const double most = is_of_shares(metric) ? 1 / metric.mean_a : HUGE_VAL;
  const auto ratio = [&](double apart) {
    return std::isfinite(apart) ? std::clamp(1 - apart / metric.mean_a, 0.0, most) : not_defined;
  };
  return {.value = metric.mean_b / metric.mean_a, .low = ratio(difference.high), .high = ratio(difference.low)};
}

// The margin of a metric: "5 % or 0.01 cm", of shares "5 percentage points".
std::string margin_words(const VariantsReport& of, const MetricComparison& metric) {
  if (is_of_shares(metric)) return points(of.plan.margin);
  const auto is_in_cm = [](const MetricComparison& each) { return info_of(each.metric).unit == "cm"; };
  return inference::margin_words(of.plan.margin, any_metric(of.comparisons, is_in_cm) ? of.plan.margin_cm : 0);
}

// The margin of all metrics: "5 % (shares: 5 percentage points)".
std::string margin_words(const VariantsReport& of) {
  std::string of_shares, of_others;
  for (const VariantComparison& comparison : of.comparisons) {
    for (const MetricComparison& metric : comparison.metrics)
      (is_of_shares(metric) ? of_shares : of_others) = margin_words(of, metric);
  }
  if (of_shares.empty() || of_others.empty()) return of_shares + of_others;
  return fmt::format(words::margins, "margin"_a = of_others, "of_shares"_a = of_shares);
}

// The verdict on B: "better", "worse by less than 5 %".
std::string b_is(const MetricComparison& metric, const std::string& margin) {
  if (!metric.is_compared) return metric.is_counted ? "not compared" : "not compared: nobody counted";
  const Finding& found = metric.contrast;
  const auto sized = [&](std::string_view word) {
    return found.is_within_margin()   ? fmt::format(words::by_less, "word"_a = word, "margin"_a = margin)
           : found.is_beyond_margin() ? fmt::format(words::by_more, "word"_a = word, "margin"_a = margin)
           : found.is_across_margin() ? fmt::format(words::perhaps_by_less, "word"_a = word, "margin"_a = margin)
                                      : fmt::format(words::by_unknown, "word"_a = word);
  };
  switch (metric.contrast.relation) {
    case Relation::better:
      return sized("worse");
    case Relation::worse:
      return sized("better");
    case Relation::same:
      return "the same within " + margin;
    case Relation::undefined:
      return "cannot be judged";
    default:
      return "undecided";
  }
}

std::vector<Cell> row_of(const VariantComparison& comparison, const MetricComparison& metric,
                         const std::string& margin) {
  const Estimate ratio = ratio_of(metric);
  const auto of_b = [&](double share_of_a) { return defined(metric.contrast.is_fact ? not_defined : 1 - share_of_a); };
  const Estimate& ahead = metric.contrast.superiority;
  return {comparison.label,
          metric_words(metric),
          b_is(metric, margin),
          std::int64_t{metric.n_a},
          std::int64_t{metric.n_b},
          metric.mean_a,
          metric.mean_b,
          defined(ratio.value),
          defined(ratio.low),
          defined(ratio.high),
          p_value(metric.contrast.is_fact ? not_defined : metric.contrast.p),
          p_value(metric.contrast.is_fact ? not_defined : metric.level),
          of_b(ahead.value),
          of_b(ahead.high),
          of_b(ahead.low),
          metric.remark.empty() ? Cell() : Cell(metric.remark)};
}

std::string of_label(const VariantsReport& of, const VariantComparison& comparison) {
  return of.comparisons.size() == 1 ? "" : comparison.label + ": ";
}

Json json_of(const Cell& cell) {
  if (const auto* const text = std::get_if<std::string>(&cell)) return *text;
  if (const auto* const count = std::get_if<std::int64_t>(&cell)) return *count;
  if (const auto* const value = std::get_if<double>(&cell)) return *value;  // dumped as null if not finite
  if (const auto* const p = std::get_if<PValue>(&cell)) return p->value;
  return nullptr;
}

// "position_error_cm (2.1 times A's, interval 1.8 to 2.5, p 0.0003)"
std::string regression(const MetricComparison& metric) {
  std::vector<std::string> facts;
  const Estimate ratio = ratio_of(metric);
  if (std::isfinite(ratio.value)) facts.push_back(fmt::format("{} times A's", short_number(ratio.value)));
  if (std::isfinite(ratio.low))
    facts.push_back(fmt::format("interval {} to {}", short_number(ratio.low), short_number(ratio.high)));
  facts.push_back(metric.contrast.is_fact ? "no test" : fmt::format("p {}", short_number(metric.contrast.p)));
  return fmt::format("{} ({})", metric_words(metric), fmt::join(facts, ", "));
}

std::string regressions(const VariantsReport& of) {
  std::vector<std::string> found;
  for (const VariantComparison& comparison : of.comparisons) {
    for (const MetricComparison& metric : comparison.metrics) {
      if (is_regression(metric)) found.push_back(of_label(of, comparison) + regression(metric));
    }
  }
  const std::size_t named = std::min(found.size(), most_labels);
  return fmt::format("{}{}", fmt::join(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(named), "; "),
                     found.size() == named ? "" : fmt::format(" and {} more", found.size() - named));
}

// "2 better by more than 5 %, 17 undecided", in the order in which they first occur.
std::string counted(const VariantsReport& of) {
  std::vector<std::pair<std::string, int>> counts;
  for (const VariantComparison& comparison : of.comparisons) {
    for (const MetricComparison& metric : comparison.metrics) {
      const std::string said = b_is(metric, margin_words(of, metric));
      const auto found = std::ranges::find(counts, said, &std::pair<std::string, int>::first);
      if (found == counts.end()) {
        counts.emplace_back(said, 1);
      } else {
        ++found->second;
      }
    }
  }
  std::vector<std::string> parts;
  for (const auto& [said, number] : counts) parts.push_back(fmt::format("{} {}", number, said));
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

Table variants_table(const VariantsReport& of) {
  const std::string margin = margin_words(of);
  Table table{.name = "comparison",
              .caption = fmt::format("B compared with A, with a margin of {}", margin),
              .columns = {"label", "metric", "B_is", "n_A", "n_B", "mean_A", "mean_B", "B_by_A", "low", "high", "p",
                          "level", "a12", "a12_low", "a12_high", "remark"},
              .notes = {std::string(words::comparison_columns)}};
  for (const VariantComparison& comparison : of.comparisons) {
    for (const MetricComparison& metric : comparison.metrics)
      table.rows.push_back(row_of(comparison, metric, margin_words(of, metric)));
  }
  return table;
}

std::vector<std::string> variants_notes(const VariantsReport& of) {
  std::vector<std::string> notes;
  const auto is_of_all = [&](const std::string& note) {
    return std::ranges::all_of(of.comparisons, [&](const VariantComparison& comparison) {
      return comparison.design == note || std::ranges::find(comparison.notes, note) != comparison.notes.end();
    });
  };
  const auto add = [&](const VariantComparison& comparison, const std::string& note) {
    if (note.empty()) return;
    const std::string text = is_of_all(note) ? note : of_label(of, comparison) + note;
    if (std::ranges::find(notes, text) == notes.end()) notes.push_back(text);
  };
  for (const VariantComparison& comparison : of.comparisons) add(comparison, comparison.design);
  for (const VariantComparison& comparison : of.comparisons) {
    for (const std::string& note : comparison.notes) add(comparison, note);
  }
  return notes;
}

std::string variants_verdict(const VariantsReport& of) {
  const std::string margin = margin_words(of);
  std::size_t all = 0;
  for (const VariantComparison& comparison : of.comparisons) all += comparison.metrics.size();
  const std::string rest =
      fmt::format(words::comparisons, "count"_a = all, "s"_a = all == 1 ? "" : "s", "counts"_a = counted(of));
  if (any_metric(of.comparisons, is_regression))
    return fmt::format(words::regression, "margin"_a = margin, "list"_a = regressions(of), "rest"_a = rest);
  const auto is_unknown = [](const MetricComparison& metric) { return is_open(metric) || !metric.is_counted; };
  return fmt::format(words::no_regression, "margin"_a = margin,
                     "found"_a = any_metric(of.comparisons, is_unknown) ? " was found" : "", "rest"_a = rest);
}

std::string variants_json(const VariantsReport& of) {
  const Table table = variants_table(of);
  Json json{{"verdict", variants_verdict(of)},      {"margin", of.plan.margin},    {"margin_cm", of.plan.margin_cm},
            {"significance", of.plan.significance}, {"notes", variants_notes(of)}, {"rows", Json::array()}};
  for (const std::vector<Cell>& row : table.rows) {
    Json object = Json::object();
    for (std::size_t c = 0; c < row.size(); ++c) object[table.columns[c]] = json_of(row[c]);
    json["rows"].push_back(std::move(object));
  }
  return numerics::text_of(json, 2) + "\n";
}

}  // namespace ikbench::report
