#include "analysis/report/variants_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "analysis/inference/margin.hpp"
#include "analysis/inference/text.hpp"

namespace ikbench::report {

using namespace results;
using namespace statistics;
using namespace inference;

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_labels = 12;

// An empty cell where a fact needs none.
Cell defined(double value) { return std::isfinite(value) ? Cell(value) : Cell(); }
Cell p_value(double value) { return std::isfinite(value) ? Cell(PValue{value}) : Cell(); }

std::vector<Cell> row_of(const VariantComparison& comparison, const MetricComparison& metric) {
  return {comparison.label,
          std::string(metric.metric),
          std::string(name_of(metric.outcome)),
          std::int64_t{metric.a.n},
          std::int64_t{metric.b.n},
          metric.a.mean,
          metric.b.mean,
          defined(metric.ratio.ratio),
          defined(metric.ratio.low),
          defined(metric.ratio.high),
          p_value(metric.p_worse),
          p_value(metric.p_better),
          p_value(metric.ratio.p_equivalent),
          p_value(metric.ratio.p_difference),
          defined(metric.b_better.value),
          defined(metric.b_better.low),
          defined(metric.b_better.high),
          p_value(metric.p_ranks),
          defined(metric.n_to_decide),
          metric.remark.empty() ? Cell() : Cell(metric.remark)};
}

// Of all metrics together.
std::string margin_words(std::span<const VariantComparison> comparisons, const MarginQuestion& question) {
  double margin_cm = 0;
  for (const VariantComparison& comparison : comparisons) {
    for (const MetricComparison& metric : comparison.metrics) {
      margin_cm = std::max(margin_cm, question_about(metric.metric, question).margin_cm);
    }
  }
  return inference::margin_words(question.margin, margin_cm);
}

std::string of_label(std::span<const VariantComparison> comparisons, const VariantComparison& comparison) {
  return comparisons.size() == 1 ? "" : comparison.label + ": ";
}

Json json_of(const Cell& cell) {
  if (const auto* const text = std::get_if<std::string>(&cell)) return *text;
  if (const auto* const count = std::get_if<std::int64_t>(&cell)) return *count;
  if (const auto* const value = std::get_if<double>(&cell)) return *value;  // dumped as null where not finite
  if (const auto* const p = std::get_if<PValue>(&cell)) return p->value;
  return nullptr;
}

// "position_error_cm (2.1 times A's, 90 % interval 1.8 to 2.5, p 0.0003)"
std::string regression(const MetricComparison& metric, const MarginQuestion& question) {
  std::vector<std::string> facts;
  const RatioComparison& ratio = metric.ratio;
  if (std::isfinite(ratio.ratio)) facts.push_back(fmt::format("{} times A's", short_number(ratio.ratio)));
  if (std::isfinite(ratio.low)) {
    facts.push_back(fmt::format("{} interval {} to {}", percent(1 - 2 * question.significance), short_number(ratio.low),
                                short_number(ratio.high)));
  }
  facts.push_back(metric.is_fact ? "no test" : fmt::format("p {}", short_number(metric.p_worse)));
  return fmt::format("{} ({})", metric.metric, fmt::join(facts, ", "));
}

std::string regressions(std::span<const VariantComparison> comparisons, const MarginQuestion& question) {
  std::vector<std::string> found;
  for (const VariantComparison& comparison : comparisons) {
    for (const MetricComparison& metric : comparison.metrics) {
      if (metric.outcome != Outcome::worse) continue;
      found.push_back(of_label(comparisons, comparison) + regression(metric, question));
    }
  }
  const std::size_t named = std::min(found.size(), most_labels);
  return fmt::format("{}{}", fmt::join(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(named), "; "),
                     found.size() == named ? "" : fmt::format(" and {} more", found.size() - named));
}

// " (at this spread it takes about 45 runs a side)"
std::string would_decide(std::span<const VariantComparison> comparisons) {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  std::string_view observation;
  for (const VariantComparison& comparison : comparisons) {
    for (const MetricComparison& metric : comparison.metrics) {
      if (metric.outcome != Outcome::undecided || !std::isfinite(metric.n_to_decide)) continue;
      least = std::min(least, metric.n_to_decide);
      most = std::max(most, metric.n_to_decide);
      observation = metric.observation;
    }
  }
  if (most == 0) return "";
  return fmt::format(" (at this spread it takes about {} {}s a side)", range_words(least, most), observation);
}

// "2 better by more than 5 %, 17 undecided (about 45 runs would decide the first, 22160 the last)"
std::string counted_outcomes(std::span<const VariantComparison> comparisons, const std::string& margin) {
  const std::array<std::pair<Outcome, std::string>, 9> words{
      {{Outcome::worse, "worse by more than " + margin},
       {Outcome::worse_by_less, "worse by less than " + margin},
       {Outcome::better, "better by more than " + margin},
       {Outcome::better_by_less, "better by less than " + margin},
       {Outcome::same, "the same within " + margin},
       {Outcome::not_worse, "not worse by more than " + margin},
       {Outcome::undecided, "undecided" + would_decide(comparisons)},
       {Outcome::not_compared, "not compared"},
       {Outcome::not_counted, "not compared: nobody counted"}}};
  std::vector<std::string> parts;
  for (const auto& [outcome, said] : words) {
    if (const int number = count(comparisons, outcome); number > 0) parts.push_back(fmt::format("{} {}", number, said));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

Table variants_table(std::span<const VariantComparison> comparisons, const MarginQuestion& question) {
  Table table{
      .name = "comparison",
      .caption = fmt::format("B compared with A, with a margin of {}", margin_words(comparisons, question)),
      .columns = {{"label", Align::left},
                  {"metric", Align::left},
                  {"B_is", Align::left},
                  {"n_A"},
                  {"n_B"},
                  {"mean_A"},
                  {"mean_B"},
                  {"B_by_A"},
                  {"low"},
                  {"high"},
                  {"p_worse"},
                  {"p_better"},
                  {"p_same"},
                  {"p_difference"},
                  {"a12"},
                  {"a12_low"},
                  {"a12_high"},
                  {"p_ranks"},
                  {"n_to_decide"},
                  {"remark", Align::left}},
      .notes = {fmt::format(
          "B_by_A is the ratio of means. low and high are its {:g} % interval, as for two one-sided tests at {:g}. "
          "p_worse and p_better test whether B is worse or better by more than the margin, p_difference whether the means "
          "differ, p_ranks whether the ranks do (sign test for paired observations, otherwise "
          "Mann-Whitney test), each with Holm's correction over all labels and metrics; p_same tests whether the ratio is "
          "within the margin. a12, with an interval of the same level: the "
          "probability that an observation of B is better than one of A, ignoring pairs.",
          100 * (1 - 2 * question.significance), question.significance)}};
  for (const VariantComparison& comparison : comparisons) {
    for (const MetricComparison& metric : comparison.metrics) table.rows.push_back(row_of(comparison, metric));
  }
  return table;
}

std::vector<std::string> variants_notes(std::span<const VariantComparison> comparisons) {
  std::vector<std::string> notes;
  const auto is_of_all = [&](const std::string& note) {
    return std::ranges::all_of(comparisons, [&](const VariantComparison& comparison) {
      return comparison.design == note || std::ranges::find(comparison.notes, note) != comparison.notes.end();
    });
  };
  const auto add = [&](const VariantComparison& comparison, const std::string& note) {
    const std::string text = is_of_all(note) ? note : of_label(comparisons, comparison) + note;
    if (std::ranges::find(notes, text) == notes.end()) notes.push_back(text);
  };
  for (const VariantComparison& comparison : comparisons) add(comparison, comparison.design);
  notes.emplace_back(
      "This comparison is decided by the ratio of means, against the margin. A report uses the test of its plan and "
      "corrects for its own pairs, so the two may disagree.");
  for (const VariantComparison& comparison : comparisons) {
    for (const std::string& note : comparison.notes) add(comparison, note);
  }
  return notes;
}

std::string variants_verdict(std::span<const VariantComparison> comparisons, const MarginQuestion& question) {
  const std::string margin = margin_words(comparisons, question);
  std::size_t all = 0;
  for (const VariantComparison& comparison : comparisons) all += comparison.metrics.size();
  const std::string rest =
      fmt::format("Of {} comparison{}: {}.", all, all == 1 ? "" : "s", counted_outcomes(comparisons, margin));
  if (count(comparisons, Outcome::worse) > 0) {
    return fmt::format("Regression beyond {}: {}. {}", margin, regressions(comparisons, question), rest);
  }
  const bool is_open = count(comparisons, Outcome::undecided) + count(comparisons, Outcome::not_compared) +
                           count(comparisons, Outcome::not_counted) >
                       0;
  return fmt::format("No regression beyond {}{}. {}", margin, is_open ? " was found" : "", rest);
}

std::string variants_json(std::span<const VariantComparison> comparisons, const MarginQuestion& question) {
  const Table table = variants_table(comparisons, question);
  Json json{{"verdict", variants_verdict(comparisons, question)},
            {"margin", question.margin},
            {"margin_cm", question.margin_cm},
            {"significance", question.significance},
            {"notes", variants_notes(comparisons)},
            {"rows", Json::array()}};
  for (const std::vector<Cell>& row : table.rows) {
    Json object = Json::object();
    for (std::size_t c = 0; c < row.size(); ++c) object[table.columns[c].name] = json_of(row[c]);
    json["rows"].push_back(std::move(object));
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace ikbench::report
