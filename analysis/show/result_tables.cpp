#include "analysis/show/result_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <span>
#include <string_view>
#include <utility>

#include "analysis/judge/statistics/closed_tests.hpp"
#include "analysis/judge/statistics/omnibus.hpp"
#include "analysis/show/hard_targets.hpp"
#include "analysis/show/headline.hpp"
#include "analysis/show/phrases.hpp"
#include "analysis/show/requirements.hpp"
#include "analysis/show/text.hpp"
#include "base/json.hpp"
#include "base/names.hpp"

namespace ikbench::show {

using namespace judge;

namespace {

constexpr std::size_t max_shown_pairs = 15;       // of a metric; otherwise only pairs with the reference
constexpr std::size_t max_listed_pairs = 10'000;  // not shown, but in files; 400 solvers have 300 000 pairs

const std::string star = "*", plus = "+", exclamation = "!";

// Returns the cell of a group's value, which may only be an upper bound.
Cell value_cell(const Group& group, double value) {
  if (std::isnan(value)) return {};
  return group.tolerance > 0 && value == group.tolerance ? Cell(ValueCell{.value = value, .is_bound = true})
                                                         : Cell(value);
}

// Returns the interval [%] of a share of successes, which is in percent; nullopt for other metrics, for a
// deterministic solver, whose share has no chance in it, and for a grid, which is no random sample.
std::optional<Interval> share_interval(const JudgedMetric& judged, std::size_t group) {
  const Descriptives& descriptives = judged.descriptives[group];
  if (!is_success_rate(judged) || descriptives.n == 0 || !judged.samples.is_random ||
      is_deterministic(judged.samples.groups[group]))
    return {};
  const Interval share = wilson_interval({.share = descriptives.mean / 100, .n = static_cast<double>(descriptives.n)},
                                         judged.plan.significance);
  return Interval{100 * share.low, 100 * share.high};
}

bool are_means(const ReportModel& model) { return model.primary().plan.test == results::AnalysisPlan::Test::means; }

std::string average_name(const ReportModel& model) { return are_means(model) ? "mean" : "median"; }

// The solvers that the marks of a table of results depend on.
struct MarkedSolvers {
  std::string reference;
  std::set<std::string> losers;       // worse than another solver in the deciding metric
  std::vector<std::string> untested;  // whose statement in the headline is "not tested"
};

MarkedSolvers marked_solvers(const ReportModel& model) {
  MarkedSolvers marked{.reference = reference_of(model), .losers = beaten_solvers(model.primary().comparisons)};
  for (const Statement& statement : model.questions.front().statements)
    if (statement.kind == Statement::StatementKind::not_tested) marked.untested = statement.solvers;
  return marked;
}

// A column of the table of results. With many solvers each cell would otherwise search all pairs for its own.
class ResultColumn {
 public:
  ResultColumn(const ReportModel& model, const JudgedMetric& judged, const MarkedSolvers& marked)
      : model_(model), judged_(judged), marked_(marked) {
    for (const Comparison& comparison : judged.comparisons) {
      if (comparison.first == marked.reference) add(comparison.second, comparison);
      if (comparison.second == marked.reference) add(comparison.first, comparison);
    }
  }

  // True if numbers stand as ratios to the reference, because each solver solved targets of its own.
  bool has_ratios() const { return is_conditional_on_success(judged_.samples) && is_any_pair_tested_; }

  // Returns a solver's number with its mark. In the deciding metric without a control a star means that some solver is
  // better. Otherwise a mark is the verdict of the pair with the reference.
  Cell cell(const std::string& solver) const {
    const std::size_t i = index_of(judged_.samples, solver);
    if (i == judged_.samples.groups.size()) return MissingCell{"not in it"};
    const Group& group = judged_.samples.groups[i];
    if (missing_in(group) > 0) return MissingCell{"values are missing"};
    const Comparison* const stored = pair_of(solver);
    const Comparison pair = stored ? better_first(*stored, marked_.reference) : Comparison();
    const bool is_untested = is_not_tested(solver, group, stored);
    const ValueCell cell{.value = unknown, .mark = mark(solver, stored ? &pair : nullptr, is_untested)};
    if (has_ratios() && solver != marked_.reference && !excluded(group)) return ratio_cell(cell, pair, is_untested);
    return average_cell(cell, i);
  }

 private:
  const ReportModel& model_;
  const JudgedMetric& judged_;
  const MarkedSolvers& marked_;
  std::map<std::string_view, const Comparison*> pairs_ = {};  // with the reference, by the other solver
  bool is_any_pair_tested_ = false;

  void add(const std::string& other, const Comparison& comparison) {
    pairs_[other] = &comparison;
    is_any_pair_tested_ |= !std::holds_alternative<NotTested>(comparison.result);
  }
  const Comparison* pair_of(const std::string& solver) const {
    const auto found = pairs_.find(solver);
    return found == pairs_.end() ? nullptr : found->second;
  }
  bool is_deciding() const { return &judged_ == &model_.primary(); }
  // True if marks are about all pairs, not only those with the reference.
  bool is_about_all() const { return is_deciding() && judged_.plan.control.empty(); }

  bool is_not_tested(const std::string& solver, const Group& group, const Comparison* pair) const {
    if (excluded(group)) return true;
    if (is_about_all() && !judged_.comparisons.empty()) return std::ranges::count(marked_.untested, solver) > 0;
    if (pair == nullptr || verdict_of(*pair) != Verdict::not_tested) return false;
    const Group& reference = judged_.samples.groups[index_of(judged_.samples, marked_.reference)];
    return excluded(reference) == nullptr;  // otherwise the reference has the mark
  }

  std::string mark(const std::string& solver, const Comparison* pair, bool is_untested) const {
    if (!judged_.samples.is_random) return "";
    const Verdict verdict = pair ? verdict_of(*pair) : Verdict::inconclusive;
    const auto* const tested = pair ? std::get_if<TestResult>(&pair->result) : nullptr;
    // A difference below the margin has a mark only if the headline reports the difference. Other metrics have no such
    // mark, and neither has a regression check, where a difference below the margin is no regression.
    const bool matters = !tested || !tested->is_below_margin || (model_.verdict.empty() && is_deciding());
    const bool is_worse = is_about_all() ? marked_.losers.contains(solver) : matters && verdict == Verdict::worse;
    if (is_worse) return star;
    if (matters && verdict == Verdict::better) return plus;
    return is_untested ? exclamation : "";
  }

  static Cell ratio_cell(ValueCell cell, const Comparison& pair, bool is_untested) {
    if (is_untested) return MissingCell{std::string(reason_words(std::get<NotTested>(pair.result).reason).of_solver)};
    if (pair.estimate) {
      cell.value = pair.estimate->value;
      cell.relative_to_reference = pair.scale;
    }
    if (pair.estimate || std::holds_alternative<TestResult>(pair.result)) return cell;
    return MissingCell{"too few to compare"};
  }

  Cell average_cell(ValueCell cell, std::size_t i) const {
    const Group& group = judged_.samples.groups[i];
    const Descriptives& descriptives = judged_.descriptives[i];
    const bool has_one_average =
        is_success_rate(judged_) || is_log_scale(judged_.samples) || std::isnan(descriptives.median);
    const double average = are_means(model_) ? descriptives.mean : descriptives.median;
    const BoundedValue shown = has_one_average ? displayed_average(judged_, i) : show::displayed(judged_, i, average);
    if (std::isnan(shown.value)) {
      const ExcludedSample* const sample = excluded(group);
      return MissingCell{sample ? std::string(reason_words(not_tested_reason(sample->reason)).of_solver)
                                : "without a value"};
    }
    cell.value = shown.value;
    cell.is_bound = shown.is_bound;
    cell.interval = share_interval(judged_, i);
    const bool has_spread = is_deciding() && judged_.samples.is_random && !is_success_rate(judged_) &&
                            !is_conditional_on_success(judged_.samples) && !cell.is_bound && descriptives.n >= 2;
    if (!has_spread) return cell;
    if (are_means(model_) && !std::isnan(descriptives.sd)) cell.sd = descriptives.sd;
    if (!are_means(model_) && !has_one_average)
      cell.interval = Interval{descriptives.lower_quartile, descriptives.upper_quartile};
    return cell;
  }
};

// Returns what stars compare with. Without a control those of the deciding metric need not be about the reference.
std::string compared_with(const ReportModel& model, const std::string& reference) {
  std::set<std::string> others = beaten_solvers(model.primary().comparisons);
  for (const Comparison& comparison : model.primary().comparisons) {
    if (comparison.first == reference_of(model) && verdict_of(comparison) == Verdict::better)
      others.erase(comparison.second);
  }
  return model.primary().plan.control.empty() && !others.empty() ? "some other solver" : reference;
}

// Returns " (6 runs, at least 7 needed)" if that is the reason of all pairs that are not tested; otherwise
// empty.
std::string too_few_text(const ReportModel& model) {
  std::set<std::string> reasons;
  for (const JudgedMetric& judged : model.metrics) {
    for (const Comparison& comparison : judged.comparisons) {
      const auto* const not_tested = std::get_if<NotTested>(&comparison.result);
      if (not_tested == nullptr) continue;
      const bool is_too_small = not_tested->reason == NotTestedReason::sample_too_small && not_tested->n > 0;
      reasons.insert(is_too_small ? reason_text(*not_tested, observation_noun(model, judged)) : "");
    }
  }
  return reasons.size() == 1 && !reasons.begin()->empty() ? fmt::format(" ({})", *reasons.begin()) : "";
}

// The kinds of cells that a table of results has, for the notes that explain them.
struct CellKinds {
  bool averages = false, spreads = false, shares = false;
  std::set<std::string> marks = {}, scales = {};
  NamesByPhrase reasons = {};                 // metrics by the reason of a "-"
  std::vector<std::string> ratios = {};       // metrics whose numbers are relative to the reference
  std::vector<std::string> own_targets = {};  // metrics in which each solver has its own targets

  void add(const ValueCell& cell, bool is_share, bool is_average) {
    averages |= !is_share && is_average;
    (is_share ? shares : spreads) |= cell.interval || cell.sd;
    marks.insert(cell.mark);
    if (cell.relative_to_reference)
      scales.insert(*cell.relative_to_reference == EffectScale::ratio ? "relative to" : "differences from");
  }
};

std::string numbers_note(const ReportModel& model, const CellKinds& kinds) {
  const bool has_means = are_means(model);
  std::string text;
  if (kinds.averages) text = has_means ? "Means" : "Medians";
  if (kinds.spreads) text += has_means ? " ± standard deviations" : " (quartiles)";
  const auto [fewest, most] = std::ranges::minmax(model.primary().descriptives, {}, &Descriptives::n);
  if (most.n == 0 || model.direction.empty()) return text;
  return fmt::format("{} of {}{}; {}", kinds.averages ? text : "Shares",
                     fewest.n == most.n ? "" : fmt::format("{} to ", fewest.n), base::counted(most.n, "values"),
                     model.direction);
}

// Returns ", corrected", or that closed tests are used if the blocks of a metric are few; the headline names them.
std::string correction_text(const ReportModel& model) {
  const std::vector<std::string> closed = closed_metrics(model);
  if (closed.size() == model.metrics.size()) return ", closed tests";
  if (!closed.empty()) return fmt::format(", corrected; {}: closed tests", listed(closed));
  const bool is_corrected = model.order.size() > 2 || model.named_metrics > 1 || !model.verdict.empty();
  return is_corrected ? ", corrected" : "";
}

std::string marks_note(const ReportModel& model, const CellKinds& kinds) {
  const auto has_exact_differences = [](const JudgedMetric& judged) {
    return std::ranges::any_of(judged.comparisons, [](const Comparison& comparison) {
      return std::holds_alternative<DeterministicResult>(comparison.result) && is_difference(verdict_of(comparison));
    });
  };
  const AnalysisPlan& plan = model.primary().plan;
  const std::string tests =
      fmt::format(" (p < {}{}{})", number_text(plan.significance), correction_text(model),
                  std::ranges::any_of(model.metrics, has_exact_differences) ? ", or deterministic" : "");
  return marks_text(kinds.marks, compared_with(model, reference_of(model)) + tests, too_few_text(model));
}

std::string intervals_note(const ReportModel& model, const CellKinds& kinds) {
  if (!kinds.shares) return "";
  return fmt::format("Brackets{}: {:.3g} % intervals", kinds.spreads && !are_means(model) ? " of shares" : "",
                     100 * (1 - model.primary().plan.significance));
}

std::string ratios_note(const ReportModel& model, const CellKinds& kinds) {
  if (kinds.scales.empty()) return "";
  const std::string metrics = listed(kinds.ratios);
  return fmt::format("{}: {} {}'s {}", model.direction.empty() ? as_sentence(metrics) : metrics,
                     fmt::join(kinds.scales, " or "), reference_of(model), average_name(model));
}

// Returns the notes that a screen and a page have.
std::vector<std::string> brief_notes(const ReportModel& model, const CellKinds& kinds) {
  return {numbers_note(model, kinds), marks_note(model, kinds), intervals_note(model, kinds),
          ratios_note(model, kinds)};
}

// Returns the notes that only a page has.
std::vector<std::string> page_notes(const ReportModel& model, const CellKinds& kinds) {
  const auto has_any = [&](auto is_so) {
    return std::ranges::any_of(model.metrics,
                               [&](const JudgedMetric& judged) { return std::invoke(is_so, judged.samples); });
  };
  const auto has_common_targets = [](const MetricSamples& samples) {
    return is_conditional_on_success(samples) && samples.is_paired;
  };
  std::vector<std::string> notes;
  if (has_any(is_cost_per_success))
    notes.push_back(fmt::format("Per success: cost of all attempts divided by the {} solved (ERT)", model.noun));
  if (!kinds.scales.empty())
    notes.push_back(has_any(has_common_targets) ? fmt::format("Ratios use only {} that both solved", model.noun)
                                                : "Ratios use only solved " + model.noun);
  if (!kinds.own_targets.empty())
    notes.push_back(fmt::format("{}: {} over the {} that each solver solved", as_sentence(listed(kinds.own_targets)),
                                average_name(model), model.noun));
  if (!kinds.reasons.entries.empty())
    notes.push_back(fmt::format("-: {}", fmt::join(kinds.reasons.formatted("{} ({})"), "; ")));
  return notes;
}

// Returns the table of pairs without rows; pair_row makes them.
Table empty_pairs_table(const ReportModel& model) {
  Table table{
      .name = "pairs",
      .caption = "First solver against second",
      .columns = named_columns({"metric",  "first", "second",  "estimate",   "interval",      "unit",        "p",
                                "verdict", "A12",   "A12 low", "A12 high",   "share better",  "share worse", "g",
                                "g_av",    "test",  "n",       "required n", "within margin", "reason"})};
  std::set<double> ends;
  for (const JudgedMetric& judged : model.metrics)
    for (const Comparison& comparison : judged.comparisons) ends.merge(null_and_margin(comparison, judged));
  Column& interval = table.columns[4];
  interval.role = ColumnRole::interval;
  interval.boundaries = {ends.begin(), ends.end()};
  Column& p = table.columns[6];
  p.role = ColumnRole::p;
  p.boundaries = {model.primary().plan.significance};
  for (Column& column : std::span(table.columns).subspan(8)) column.role = ColumnRole::machine_only;
  return table;
}

VerdictCell verdict_cell(const Comparison& comparison, const JudgedMetric& judged) {
  const VerdictStyle& style = verdict_words(verdict_of(comparison));
  std::string text = comparison_text(comparison, judged);
  const std::string shares = comparison.estimate ? "" : dominance_text(comparison);
  if (!shares.empty()) text += ", " + shares;
  return {.text = std::move(text), .tone = style.tone, .key = std::string(style.key)};
}

Cell required_n_cell(const Comparison& comparison) {
  int required_n = 0;
  if (const auto* const tested = std::get_if<TestResult>(&comparison.result)) required_n = tested->required_n;
  if (const auto* const not_tested = std::get_if<NotTested>(&comparison.result)) required_n = not_tested->required_n;
  return required_n > 0 ? Cell(std::int64_t{required_n}) : Cell();
}

Cell n_cell(const Comparison& comparison) {
  if (const auto* const tested = std::get_if<TestResult>(&comparison.result)) return std::int64_t{tested->n};
  if (const auto* const not_tested = std::get_if<NotTested>(&comparison.result)) return std::int64_t{not_tested->n};
  return {};
}

// Returns "yes" for a pair that is the same, or whose tested difference is below the margin; empty for other pairs.
Cell within_margin_cell(const TestResult* tested) {
  const bool is_within =
      tested && (tested->verdict == Verdict::equivalent || (is_difference(tested->verdict) && tested->is_below_margin));
  return text_cell(is_within ? "yes" : "");
}

// Returns why a pair has no p; empty if it has.
Cell reason_cell(const Comparison& comparison) {
  if (std::holds_alternative<TestResult>(comparison.result)) return {};
  const auto* const not_tested = std::get_if<NotTested>(&comparison.result);
  return text_cell(std::string(not_tested ? reason_words(not_tested->reason).key : "deterministic"));
}

// Returns the complete row of a pair. Readers see the cells up to the verdict.
std::vector<Cell> pair_row(const Comparison& comparison, const JudgedMetric& judged) {
  const std::optional<EffectEstimate>& estimate = comparison.estimate;
  const auto* const tested = std::get_if<TestResult>(&comparison.result);
  const auto* const dominance = tested && tested->dominance ? &*tested->dominance : nullptr;
  const bool has_hedges_g = tested && tested->hedges_g;  // the effect size of means; A12 is that of ranks
  const bool has_interval = dominance && !has_hedges_g && dominance->interval;
  const auto hedges_g_cell = [&](bool is_of_pairs) {
    return has_hedges_g && judged.samples.is_paired == is_of_pairs ? Cell(*tested->hedges_g) : Cell();
  };
  return {judged.samples.quantity,
          comparison.first,
          comparison.second,
          estimate ? Cell(estimate->value) : Cell(),
          estimate && estimate->interval ? Cell(*estimate->interval) : Cell(),
          text_cell(estimate_unit(comparison, judged)),
          tested ? Cell(tested->adjusted_p) : Cell(),
          verdict_cell(comparison, judged),
          dominance && !has_hedges_g ? Cell(dominance->a12()) : Cell(),
          has_interval ? Cell(dominance->interval->low) : Cell(),
          has_interval ? Cell(dominance->interval->high) : Cell(),
          dominance ? Cell(dominance->better) : Cell(),
          dominance ? Cell(dominance->worse) : Cell(),
          hedges_g_cell(false),
          hedges_g_cell(true),
          text_cell(std::string(tested ? tested->test : "")),
          n_cell(comparison),
          required_n_cell(comparison),
          within_margin_cell(tested),
          reason_cell(comparison)};
}

// Returns the heading of a column, which is shorter than the name in sentences.
std::string heading_of(const MetricSamples& samples) {
  constexpr std::string_view targets = "targets ";
  const bool is_of_targets = is_proportion(samples) && samples.quantity.starts_with(targets);
  return is_of_targets ? samples.quantity.substr(targets.size()) : samples.quantity;
}

Column result_head(const ReportModel& model, const JudgedMetric& judged) {
  const MetricSamples& samples = judged.samples;
  const bool is_average = &judged == &model.primary() && !is_success_rate(judged) &&
                          !is_conditional_on_success(samples) && !is_log_scale(samples);
  return {.name = (is_average ? average_name(model) + " " : "") + heading_of(samples),
          .unit = samples.unit,
          .boundaries = percent_boundaries(judged)};
}

std::string how_p_is_adjusted(const ReportModel& model) {
  const std::string metrics =
      model.named_metrics == 1 ? "" : fmt::format(" and by the {} metrics that the plan names", model.named_metrics);
  const std::vector<std::string> closed = closed_metrics(model);
  std::string text;
  if (closed.size() < model.metrics.size())
    text = fmt::format(
        "p is multiplied by the number of pairs tested in its metric{}; intervals hold for all pairs at once.",
        metrics);
  if (closed.empty()) return text;
  const std::string shared =
      model.named_metrics == 1 ? "" : fmt::format(", times the {} metrics that the plan names", model.named_metrics);
  return fmt::format("{}{}In {}, p is the largest of a pair's {}{}; an interval would not hold for all pairs.", text,
                     text.empty() ? "" : " ", listed(closed), closed_tests_name, shared);
}

}  // namespace

Table results_table(const ReportModel& model, bool is_brief) {
  Table table{.name = "results", .caption = "Results", .columns = {{"solver"}}};
  for (const std::string& solver : model.solvers()) table.rows.push_back({solver});
  const MarkedSolvers marked = marked_solvers(model);
  CellKinds kinds;
  for (const JudgedMetric& judged : model.metrics) {
    const MetricSamples& samples = judged.samples;
    const ResultColumn column(model, judged, marked);
    table.columns.push_back(result_head(model, judged));
    const bool has_ratios = column.has_ratios();
    const bool has_own_targets =
        is_conditional_on_success(samples) && !has_ratios && (!judged.comparisons.empty() || !samples.is_random);
    if (has_ratios) kinds.ratios.push_back(samples.quantity);
    if (has_own_targets) kinds.own_targets.push_back(samples.quantity);
    for (auto& row : table.rows) {
      row.push_back(column.cell(std::get<std::string>(row[0])));
      if (const auto* const missing = std::get_if<MissingCell>(&row.back()))
        kinds.reasons.add(missing->reason, samples.quantity);
      if (const auto* const value = std::get_if<ValueCell>(&row.back()))
        kinds.add(*value, is_success_rate(judged), !is_log_scale(samples) && !has_ratios && !has_own_targets);
    }
  }
  const auto add_note = [&](std::vector<std::string> sentences) {
    std::erase(sentences, "");
    if (!sentences.empty()) table.notes.push_back(fmt::format("{}.", fmt::join(sentences, ". ")));
  };
  add_note(brief_notes(model, kinds));
  if (is_brief) return table;
  add_note(page_notes(model, kinds));
  table.notes.insert(table.notes.end(), model.notes.begin(), model.notes.end());
  return table;
}

std::string marks_text(const std::set<std::string>& marks, const std::string& reference,
                       const std::string& why_not_tested) {
  std::vector<std::string> verdicts, texts;
  if (marks.contains(star)) verdicts.push_back(star + " worse");
  if (marks.contains(plus)) verdicts.push_back(plus + " better");
  if (!verdicts.empty()) texts.push_back(listed(verdicts) + " than " + reference);
  if (marks.contains(exclamation)) texts.push_back(exclamation + " not tested" + why_not_tested);
  return listed(texts, ", ");
}

std::string reference_of_marks(const ReportModel& model) {
  const std::string control = model.primary().plan.control.empty() ? "" : "the control ";
  return control + compared_with(model, reference_of(model));
}

Table pairs_table(const ReportModel& model) {
  Table table = empty_pairs_table(model);
  const std::string reference = reference_of(model);
  std::vector<std::vector<Cell>> hidden_rows;
  std::size_t left_out = 0;
  bool has_p = false;
  for (const JudgedMetric& judged : model.metrics) {
    const bool is_asked = model.is_in_headline(judged);
    const bool are_many = judged.comparisons.size() > max_shown_pairs;
    for (const Comparison& comparison : judged.comparisons) {
      const bool is_shown = is_asked && (!are_many || comparison.first == reference || comparison.second == reference);
      if (!is_shown && hidden_rows.size() == max_listed_pairs) {
        ++left_out;
        continue;
      }
      (is_shown ? table.rows : hidden_rows).push_back(pair_row(comparison, judged));
      has_p |= std::holds_alternative<TestResult>(comparison.result);
    }
  }
  table.visible_rows = table.rows.size();
  std::ranges::move(hidden_rows, std::back_inserter(table.rows));
  const std::string decides = ranking_note(model);
  std::vector<std::string> notes{decides.empty() ? "" : decides + "; other metrics are exploratory.",
                                 model.verdict.empty() && has_p ? how_p_is_adjusted(model) : "",
                                 left_out == 0 ? "" : fmt::format("{} more pairs are not listed.", left_out)};
  std::erase(notes, "");
  if (!notes.empty()) table.notes = {fmt::format("{}", fmt::join(notes, " "))};
  return table;
}

Table tested_pairs_table(const ReportModel& model) {
  Table table = empty_pairs_table(model);
  const std::size_t metrics = model.primary().descriptives.size() > 2 ? 1 : model.metrics.size();
  std::set<int> sizes;
  for (const JudgedMetric& judged : std::span(model.metrics).first(metrics)) {
    for (const Comparison& comparison : judged.comparisons) {
      if (verdict_of(comparison) == Verdict::not_tested) continue;
      table.rows.push_back(pair_row(comparison, judged));
      if (const auto* const tested = std::get_if<TestResult>(&comparison.result)) sizes.insert(tested->n);
    }
  }
  if (model.direction.empty() || sizes.size() < 2) return table;
  // Readers see n if the pairs of a file have different numbers of blocks in common.
  std::ranges::find(table.columns, "n", &Column::name)->role = ColumnRole::value;
  return table;
}

Table descriptives_table(const ReportModel& model) {
  Table table{
      .name = "descriptives",
      .caption = "By metric and solver",
      .columns = named_columns({"metric", "solver", "n", "mean", "sd", "median", "lower quartile", "upper quartile",
                                "95 % quantile", "smallest", "largest", "interval", "unit", "missing"})};
  std::ranges::find(table.columns, "interval", &Column::name)->role = ColumnRole::interval;
  bool is_any_missing = false, is_any_share = false;
  for (const JudgedMetric& judged : model.metrics) {
    const MetricSamples& samples = judged.samples;
    for (const std::string& solver : model.solvers()) {
      const std::size_t i = index_of(samples, solver);
      if (i == samples.groups.size()) continue;
      const Descriptives& descriptives = judged.descriptives[i];
      const Group& group = samples.groups[i];
      auto& row = table.rows.emplace_back();
      row = {samples.quantity, group.name, std::int64_t{descriptives.n}, value_cell(group, descriptives.mean)};
      const bool is_of_trials = is_success_rate(judged) && trials_per_value(samples) == 1;
      const std::optional<Interval> interval = is_of_trials ? share_interval(judged, i) : std::nullopt;
      for (const double value :
           {descriptives.sd, descriptives.median, descriptives.lower_quartile, descriptives.upper_quartile,
            descriptives.quantile_95, descriptives.smallest, descriptives.largest})
        row.push_back(interval ? Cell() : value_cell(group, value));
      row.push_back(interval ? Cell(*interval) : Cell());
      is_any_share |= interval.has_value();
      row.emplace_back(samples.unit);
      row.push_back(missing_in(group) > 0 ? Cell(std::int64_t{missing_in(group)}) : Cell());
      is_any_missing |= missing_in(group) > 0;
    }
  }
  table.notes = {fmt::format("n: number of {}{}. Quartiles as in MATLAB.{}", model.noun,
                             model.direction.empty()
                                 ? " (costs: solved targets; costs per success: all; times: sessions, with the "
                                   "geometric mean)"
                                 : "",
                             is_any_share ? " Interval: Wilson score." : "")};
  if (is_any_missing)
    table.notes.emplace_back("missing: number of missing values; a solver that lacks values is not tested.");
  return table;
}

Table omnibus_table(const ReportModel& model) {
  Table table{.name = "anova",
              .caption = "Omnibus tests: do any solvers differ?",
              .columns = named_columns({"metric", "test", "source", "SS", "df", "MS", "statistic", "p", "eta squared",
                                        "partial eta squared", "epsilon"})};
  table.columns[7].role = ColumnRole::p;
  NamesByPhrase left_out;
  for (const JudgedMetric& judged : model.metrics) {
    if (!judged.samples.is_random) continue;
    auto [tests, without] = omnibus_tests(judged.samples);
    if (judged.plan.test == results::AnalysisPlan::Test::ranks) {
      const std::vector<OmnibusTest> of_ranks = friedman(judged.samples);
      tests.insert(tests.begin(), of_ranks.begin(), of_ranks.end());
    }
    const std::string& quantity = judged.samples.quantity;
    const auto known = [](double value) { return std::isnan(value) ? Cell() : Cell(value); };
    const auto degrees = [](double df) { return df == std::round(df) ? Cell(std::llround(df)) : Cell(df); };
    const bool is_of_blocks = judged.samples.is_paired;
    for (const OmnibusTest& test : tests) {
      const Cell eta = known(test.eta_squared());
      table.rows.push_back({quantity, std::string(test.name), "between", known(test.ss_between), degrees(test.df),
                            known(test.ss_between / test.df), test.statistic, test.p, is_of_blocks ? Cell() : eta,
                            is_of_blocks ? eta : Cell(), known(test.epsilon)});
      if (std::isnan(test.df_within)) continue;  // Friedman's test
      table.rows.push_back({quantity, std::string(test.name), is_of_blocks ? "error (solver x block)" : "within",
                            known(test.ss_within), degrees(test.df_within), known(test.ss_within / test.df_within),
                            Cell(), Cell(), Cell(), Cell(), Cell()});
    }
    if (!without.empty() && !tests.empty()) left_out.add(names_of(without), quantity);
  }
  table.notes = {"Verdicts rest on the pairwise comparisons, not on these tests."};
  if (const std::vector<std::string> closed = closed_metrics(model); !closed.empty())
    table.notes.push_back(fmt::format("Friedman's is one of the closed tests of {}.", listed(closed)));
  std::ranges::move(left_out.formatted("{} left out: deterministic or not comparable ({})."),
                    std::back_inserter(table.notes));
  return table;
}

base::OrderedJson to_json(const ReportModel& model) {
  base::OrderedJson warnings = base::OrderedJson::array(), direction;
  const Table pairs = pairs_table(model);
  std::vector<std::string> notes = model.notes;
  notes.insert(notes.end(), pairs.notes.begin(), pairs.notes.end());
  for (const JudgedMetric& judged : model.metrics)
    direction[judged.samples.quantity] = judged.samples.better == Better::larger ? "larger" : "smaller";
  for (const Warning& warning : model.all_warnings()) warnings.push_back(warning_text(warning));
  base::OrderedJson json{{"headline", headline(model)},
                         {"metric", model.primary().samples.quantity},
                         {"groups", to_json(descriptives_table(model))},
                         {"tests", to_json(omnibus_table(model))},
                         {"comparisons", to_json(pairs)},
                         {"direction", std::move(direction)},
                         {"warnings", std::move(warnings)},
                         {"requirements", requirements_json(model)},
                         {"notes", notes}};
  if (model.hard_targets) json["hard_targets"] = hard_targets_json(*model.hard_targets);
  for (const auto& [heading, table] : model.extra_tables)
    if (table.name == "answers" && !table.rows.empty()) json["answers"] = to_json(table);
  if (!model.without_answer.empty()) json["without_answer"] = model.without_answer;
  return json;
}

}  // namespace ikbench::show
