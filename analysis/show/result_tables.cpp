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

#include "analysis/judge/statistics/omnibus.hpp"
#include "analysis/show/headline.hpp"
#include "analysis/show/phrases.hpp"
#include "analysis/show/text.hpp"
#include "base/json.hpp"
#include "base/names.hpp"

namespace ikbench::show {

using namespace judge;

namespace {

constexpr std::size_t most_told = 15;        // pairs of a metric; of more only those with the reference
constexpr std::size_t most_listed = 10'000;  // pairs beside these: 400 solvers have 300 000

const std::string star = "*", plus = "+", exclamation = "!";

// "* worse and + better than DLS, ! not tested", of the marks that occur.
std::string meaning_of(const std::set<std::string>& marks, const std::string& reference,
                       const std::string& why_not_tested = "") {
  std::vector<std::string> pairs, all;
  if (marks.contains(star)) pairs.push_back(star + " worse");
  if (marks.contains(plus)) pairs.push_back(plus + " better");
  if (!pairs.empty()) all.push_back(listed(pairs) + " than " + reference);
  if (marks.contains(exclamation)) all.push_back(exclamation + " not tested" + why_not_tested);
  return listed(all, ", ");
}

// A value of a group, which may only be an upper bound.
Cell value_cell(const Group& group, double value) {
  if (std::isnan(value)) return {};
  return group.tolerance > 0 && value == group.tolerance ? Cell(ValueCell{.value = value, .is_bound = true})
                                                         : Cell(value);
}

// Wilson's, of a share of observations that are solved or not.
std::optional<Interval> interval_of(const JudgedMetric& judged, const Descriptives& its) {
  if (!is_success_rate(judged) || trials_per_value(judged.samples) > 1 || its.n == 0) return {};
  const Interval share = wilson_interval(its.mean / 100, its.n, judged.plan.significance);
  return Interval{100 * share.low, 100 * share.high};
}

// Whether a metric's numbers stand as ratios to the reference, since those of two are of other targets.
bool are_ratios(const JudgedMetric& judged, const std::string& reference) {
  const auto is_known = [&](const Comparison& comparison) {  // a reference that solved too few empties nobody's row
    return (comparison.first == reference || comparison.second == reference) &&
           !std::holds_alternative<NotTested>(comparison.result);
  };
  return is_conditional_on_success(judged.samples) && std::ranges::any_of(judged.comparisons, is_known);
}

bool are_means(const ReportModel& answer) { return answer.primary().plan.test == results::AnalysisPlan::Test::means; }

std::string average_shown(const ReportModel& answer) { return are_means(answer) ? "mean" : "median"; }

// What the cells of a metric have in common: with many solvers each would look through all pairs for it.
struct OfMetric {
  OfMetric(const JudgedMetric& its, const std::string& reference)
      : judged(its), are_ratios(show::are_ratios(its, reference)) {
    for (const Comparison& comparison : its.comparisons) {
      if (comparison.first == reference) pairs[comparison.second] = &comparison;
      if (comparison.second == reference) pairs[comparison.first] = &comparison;
    }
  }

  const JudgedMetric& judged;
  bool are_ratios;
  std::map<std::string_view, const Comparison*> pairs = {};  // with the reference, by the other
};

// A solver's number, and its mark: of the deciding metric, without a control, that another is better; else of its pair
// with the reference. Where the numbers of two are of other targets, the finding of the pair stands in its place.
Cell result_cell(const ReportModel& answer, const OfMetric& metric, const std::string& solver,
                 const std::set<std::string>& losers, const std::vector<std::string>& apart) {
  const JudgedMetric& judged = metric.judged;
  const std::vector<Group>& groups = judged.samples.groups;
  const std::size_t i = index_of(judged.samples, solver);
  if (i == groups.size()) return MissingCell{"not in it"};
  const Group& group = groups[i];
  if (missing_in(group) > 0) return MissingCell{"values are missing"};
  const std::string reference = reference_of(answer);
  const auto found = metric.pairs.find(solver);
  const Comparison* const pair = found == metric.pairs.end() ? nullptr : found->second;
  const Comparison comparison = pair ? better_first(*pair, reference) : Comparison();
  const Verdict verdict = pair ? verdict_of(comparison) : Verdict::inconclusive;
  const auto* const tested = std::get_if<TestResult>(&comparison.result);
  const bool is_deciding = &judged == &answer.primary(), is_of_all = is_deciding && judged.plan.control.empty();
  const auto is_told = [&](const std::string& name) {
    return excluded(groups[index_of(judged.samples, name)]) == nullptr;
  };
  const bool is_untested =
      !is_told(solver) || (is_of_all && !judged.comparisons.empty()
                               ? std::ranges::count(apart, solver) > 0
                               : pair && verdict == Verdict::not_tested && is_told(reference));  // else it has the mark
  // Within the margin only what a headline tells is marked, so not of other metrics, nor in a gate what is no loss.
  const bool matters = !tested || !tested->is_below_margin || (answer.verdict.empty() && is_deciding);
  const bool is_worse = is_of_all ? losers.contains(solver) : matters && verdict == Verdict::worse;
  const bool is_better = matters && verdict == Verdict::better;
  ValueCell cell{.value = unknown, .mark = is_worse ? star : is_better ? plus : is_untested ? exclamation : ""};
  if (metric.are_ratios && solver != reference && is_told(solver)) {
    if (is_untested)
      return MissingCell{std::string(reason_words(std::get<NotTested>(comparison.result).reason).of_solver)};
    if (const auto& amount = comparison.estimate)
      cell.value = amount->value, cell.relative_to_reference = comparison.scale;
    return tested || cell.relative_to_reference ? Cell(cell) : MissingCell{"too few to compare"};
  }
  const Descriptives& its = judged.descriptives[i];
  const bool has_means = are_means(answer);
  const bool is_only_one = is_success_rate(judged) || is_log_scale(judged.samples) || std::isnan(its.median);
  const BoundedValue shown =
      is_only_one ? displayed_average(judged, i) : show::displayed(judged, i, has_means ? its.mean : its.median);
  if (std::isnan(shown.value))
    return MissingCell{excluded(group) ? std::string(reason_words(not_tested_reason(excluded(group)->reason)).of_solver)
                                       : "without a value"};
  cell.value = shown.value, cell.is_bound = shown.is_bound;
  cell.interval = interval_of(judged, its);
  if (!is_deciding || is_success_rate(judged) || is_conditional_on_success(judged.samples) || cell.is_bound ||
      its.n < 2)
    return cell;
  if (has_means && !std::isnan(its.sd)) cell.sd = its.sd;
  if (!has_means && !is_only_one) cell.interval = Interval{its.lower_quartile, its.upper_quartile};
  return cell;
}

// Whom the stars are about: without a control, those of the deciding metric need not be about the reference.
std::string of_whom(const ReportModel& answer, const std::string& reference) {
  std::set<std::string> others = beaten_solvers(answer.primary().comparisons);
  for (const Comparison& comparison : answer.primary().comparisons) {
    if (comparison.first == reference_of(answer) && verdict_of(comparison) == Verdict::better)
      others.erase(comparison.second);
  }
  return answer.primary().plan.control.empty() && !others.empty() ? "another solver" : reference;
}

// " (6 runs are too few, 7 are needed)" if that is why pairs are not tested, and all that are have this reason.
std::string why_too_few(const ReportModel& answer) {
  std::set<std::string> reasons;
  for (const JudgedMetric& judged : answer.metrics) {
    for (const Comparison& comparison : judged.comparisons) {
      const auto* const open = std::get_if<NotTested>(&comparison.result);
      if (open == nullptr) continue;
      const bool is_told = open->reason == NotTestedReason::sample_too_small && open->n > 0;
      reasons.insert(is_told ? reason_text(*open, observation_noun(answer, judged)) : "");
    }
  }
  return reasons.size() == 1 && !reasons.begin()->empty() ? fmt::format(" ({})", *reasons.begin()) : "";
}

// What stands in a table of results, which its notes explain.
struct Occurring {
  bool averages = false, spreads = false, shares = false;
  std::set<std::string> marks = {}, scales = {};
  NamesByPhrase reasons = {};                          // metrics by why they have a "-"
  std::vector<std::string> ratios = {}, counted = {};  // metrics: to the reference; of each one's own targets

  void add(const ValueCell& cell, bool is_share, bool is_average) {
    averages |= !is_share && is_average;
    (is_share ? shares : spreads) |= cell.interval || cell.sd;
    marks.insert(cell.mark);
    if (cell.relative_to_reference)
      scales.insert(*cell.relative_to_reference == EffectScale::ratio ? "multiples of" : "differences from");
  }
};

// What its numbers and marks are.
std::vector<std::string> key_of(const ReportModel& answer, const Occurring& occurring) {
  const JudgedMetric& decisive = answer.primary();
  const bool is_of_file = !answer.direction.empty(), has_means = are_means(answer);
  const double level = decisive.plan.significance;
  const std::string reference = reference_of(answer);
  std::string numbers = !occurring.averages ? "" : has_means ? "Means" : "Medians";
  if (occurring.spreads) numbers += has_means ? " ± standard deviations" : " (quartiles)";
  if (const auto [least, most] = std::ranges::minmax(decisive.descriptives, {}, &Descriptives::n);
      most.n > 0 && is_of_file)
    numbers = fmt::format("{} of {}{}; {}", occurring.averages ? numbers : "Shares",
                          least.n == most.n ? "" : fmt::format("{} to ", least.n), base::counted(most.n, "values"),
                          answer.direction);
  const auto has_facts = [](const JudgedMetric& judged) {
    return std::ranges::any_of(judged.comparisons, [](const Comparison& comparison) {
      return std::holds_alternative<DeterministicResult>(comparison.result) && is_difference(verdict_of(comparison));
    });
  };
  const std::string tested = fmt::format(" (p < {}{}{})", number_text(level),
                                         decisive.plan.control.empty() && answer.order.size() > 2 ? ", all pairs" : "",
                                         std::ranges::any_of(answer.metrics, has_facts) ? ", or for certain" : "");
  return {
      numbers, meaning_of(occurring.marks, of_whom(answer, reference) + tested, why_too_few(answer)),
      occurring.shares
          ? fmt::format("Intervals{}: {:.3g} %", occurring.spreads && !has_means ? " of shares" : "", 100 * (1 - level))
          : "",
      occurring.scales.empty()
          ? ""
          : fmt::format("{}: {} {}'s {}", is_of_file ? listed(occurring.ratios) : as_sentence(listed(occurring.ratios)),
                        fmt::join(occurring.scales, " or "), reference, average_shown(answer))};
}

// What a page tells besides.
std::vector<std::string> explained(const ReportModel& answer, const Occurring& occurring) {
  const auto is_any = [&](auto is_so) {
    return std::ranges::any_of(answer.metrics,
                               [&](const JudgedMetric& judged) { return std::invoke(is_so, judged.samples); });
  };
  const bool are_common =
      is_any([](const MetricSamples& its) { return is_conditional_on_success(its) && its.is_paired; });
  return {is_any(is_cost_per_success)
              ? fmt::format("Per solved: all that was spent, divided by the {} solved", answer.noun)
              : "",
          occurring.scales.empty() ? ""
          : are_common             ? fmt::format("Multiples are on {} that both solved", answer.noun)
                                   : "Multiples are of solved " + answer.noun,
          occurring.counted.empty()
              ? ""
              : fmt::format("{}: {}s of the {} that each solved", as_sentence(listed(occurring.counted)),
                            average_shown(answer), answer.noun),
          occurring.reasons.entries.empty()
              ? ""
              : fmt::format("-: {}", fmt::join(occurring.reasons.formatted("{} ({})"), "; "))};
}

// The table of pairs, which row_of fills.
Table without_pairs(const ReportModel& answer) {
  Table table{
      .name = "pairs",
      .caption = "The first against the second",
      .columns = named_columns({"metric", "first", "second", "estimate", "interval", "unit", "p", "verdict", "A12",
                                "ahead", "behind", "g", "g_av", "test", "n", "n that could decide", "size", "reason"})};
  std::set<double> ends;
  for (const JudgedMetric& judged : answer.metrics)
    for (const Comparison& comparison : judged.comparisons) ends.merge(null_and_margin(comparison, judged));
  table.columns[4].role = ColumnRole::interval, table.columns[4].boundaries = {ends.begin(), ends.end()};
  table.columns[6].role = ColumnRole::p, table.columns[6].boundaries = {answer.primary().plan.significance};
  for (Column& column : std::span(table.columns).subspan(8)) column.role = ColumnRole::machine_only;
  return table;
}

std::vector<Cell> row_of(const Comparison& comparison, const JudgedMetric& judged) {
  const std::optional<EffectEstimate>& amount = comparison.estimate;
  const auto* const tested = std::get_if<TestResult>(&comparison.result);
  const auto* const open = std::get_if<NotTested>(&comparison.result);
  const auto* const effect = tested && tested->dominance ? &*tested->dominance : nullptr;
  const Verdict verdict = verdict_of(comparison);
  const VerdictStyle& words = verdict_words(verdict);
  const std::string how_often = amount ? "" : dominance_text(comparison);
  const int enough = tested ? tested->required_n : open ? open->required_n : 0;
  const auto number = [](const auto& of, auto value) { return of ? Cell(value(*of)) : Cell(); };
  const auto text = [](std::string_view its) { return text_cell(std::string(its)); };
  const bool are_means = tested && tested->hedges_g;  // by which of them a size is told
  std::vector<Cell> row{judged.samples.quantity,
                        comparison.first,
                        comparison.second,
                        number(amount, [](const EffectEstimate& its) { return its.value; }),
                        amount && amount->interval ? Cell(*amount->interval) : Cell(),
                        text_cell(estimate_unit(comparison, judged)),
                        number(tested, [](const TestResult& its) { return its.adjusted_p; }),
                        VerdictCell{comparison_text(comparison, judged) + (how_often.empty() ? "" : ", " + how_often),
                                    words.tone, std::string(words.key)}};
  row.push_back(effect && !are_means ? Cell(effect->a12()) : Cell());
  row.push_back(number(effect, [](const Dominance& its) { return its.better; }));
  row.push_back(number(effect, [](const Dominance& its) { return its.worse; }));
  for (const bool of_pairs : {false, true})
    row.push_back(are_means && judged.samples.is_paired == of_pairs ? Cell(*tested->hedges_g) : Cell());
  row.push_back(text(tested ? tested->test : ""));
  row.push_back(tested ? Cell(std::int64_t{tested->n})
                       : number(open, [](const NotTested& its) { return std::int64_t{its.n}; }));
  row.push_back(enough > 0 ? Cell(std::int64_t{enough}) : Cell());
  row.push_back(text(!tested || !is_difference(verdict) ? "" : tested->is_below_margin ? "small" : "matters"));
  row.push_back(text(tested ? "" : open ? reason_words(open->reason).key : "certain"));
  return row;
}

std::string how_p_is_adjusted(const ReportModel& answer) {
  const std::string metrics =
      answer.named_metrics == 1 ? "" : fmt::format(" and by the {} metrics that the plan names", answer.named_metrics);
  return fmt::format("p is multiplied by the number of pairs tested of its metric{}, and intervals hold for all.",
                     metrics);
}

}  // namespace

Table results_table(const ReportModel& answer, bool is_brief) {
  Table table{.name = "results", .caption = "Results", .columns = {{"solver"}}};
  for (const std::string& solver : answer.solvers()) table.rows.push_back({solver});
  const std::string reference = reference_of(answer);
  const std::set<std::string> losers = beaten_solvers(answer.primary().comparisons);
  std::vector<std::string> apart;  // nobody knows whether they are better
  for (const Statement& statement : answer.questions.front().statements)
    if (statement.kind == Statement::StatementKind::not_tested) apart = statement.solvers;
  Occurring occurring;
  for (const JudgedMetric& judged : answer.metrics) {
    const MetricSamples& samples = judged.samples;
    const bool is_average = &judged == &answer.primary() && !is_success_rate(judged) &&
                            !is_conditional_on_success(samples) && !is_log_scale(samples);
    table.columns.push_back({.name = (is_average ? average_shown(answer) + " " : "") + samples.quantity,
                             .unit = samples.unit,
                             .boundaries = percent_boundaries(judged)});
    const OfMetric metric(judged, reference);
    const bool are_ratios_here = metric.are_ratios,
               are_counted = is_conditional_on_success(samples) && !are_ratios_here && !judged.comparisons.empty();
    if (are_ratios_here) occurring.ratios.push_back(samples.quantity);
    if (are_counted) occurring.counted.push_back(samples.quantity);
    for (auto& row : table.rows) {
      row.push_back(result_cell(answer, metric, std::get<std::string>(row[0]), losers, apart));
      if (const auto* const absent = std::get_if<MissingCell>(&row.back()))
        occurring.reasons.add(absent->reason, samples.quantity);
      if (const auto* const marked = std::get_if<ValueCell>(&row.back()))
        occurring.add(*marked, is_success_rate(judged), !is_log_scale(samples) && !are_ratios_here && !are_counted);
    }
  }
  const auto add = [&](std::vector<std::string> sentences) {
    std::erase(sentences, "");
    if (!sentences.empty()) table.notes.push_back(fmt::format("{}.", fmt::join(sentences, ". ")));
  };
  add(key_of(answer, occurring));
  if (is_brief) return table;
  add(explained(answer, occurring));
  table.notes.insert(table.notes.end(), answer.notes.begin(), answer.notes.end());
  return table;
}

Table studies_table(const std::vector<ReportModel>& studies, const std::vector<std::string>& names) {
  Table table{.name = "studies", .caption = "What decides each study", .columns = {{"solver"}}, .is_of_study = false};
  NamesByPhrase quantities, references;  // studies by them
  std::set<std::string> all_marks;
  for (std::size_t s = 0; s < studies.size(); ++s) {
    Table of_study = results_table(studies[s]);
    std::set<std::string> marks;
    table.columns.push_back({.name = names[s], .unit = of_study.columns[1].unit});
    quantities.add(of_study.columns[1].name, names[s]);
    for (std::vector<Cell>& of_solver : of_study.rows) {
      const auto name_of = [](const std::vector<Cell>& cells) { return std::get<std::string>(cells[0]); };
      auto row = std::ranges::find(table.rows, name_of(of_solver), name_of);
      if (row == table.rows.end()) row = table.rows.insert(row, {of_solver[0]});
      row->resize(s + 1, MissingCell{"not in the study"});
      if (auto* const marked = std::get_if<ValueCell>(&of_solver[1])) {
        marks.insert(marked->mark);
        marked->interval.reset(), marked->sd.reset();
      }
      row->push_back(of_solver[1]);
    }
    if (marks.contains(star) || marks.contains(plus))
      references.add((studies[s].primary().plan.control.empty() ? "" : "the control ") +
                         of_whom(studies[s], reference_of(studies[s])),
                     names[s]);
    all_marks.merge(marks);
  }
  for (auto& row : table.rows) row.resize(table.columns.size(), MissingCell{"not in the study"});
  std::vector<std::string> sentences{"Shown: " + listed(quantities.formatted("{} ({})")),
                                     meaning_of(all_marks, listed(references.formatted("{} ({})"), " or ")),
                                     "Each study is judged alone"};
  std::erase(sentences, "");
  table.notes = {fmt::format("{}.", fmt::join(sentences, ". "))};
  return table;
}

Table transposed(const Table& studies) {
  Table turned{.name = studies.name, .caption = studies.caption, .columns = {{"study"}}, .notes = studies.notes};
  for (std::size_t c = 1; c < studies.columns.size(); ++c) turned.rows.push_back({studies.columns[c].name});
  for (const auto& row : studies.rows) {
    turned.columns.push_back({.name = std::get<std::string>(row[0]), .unit = studies.columns[1].unit});
    for (std::size_t c = 1; c < row.size(); ++c) turned.rows[c - 1].push_back(row[c]);
  }
  return turned;
}

// A pair, complete: readers see what stands up to the verdict.
Table pairs_table(const ReportModel& answer) {
  Table table = without_pairs(answer);
  const std::string reference = reference_of(answer);
  std::vector<std::vector<Cell>> others;
  std::size_t left_out = 0;
  bool has_p = false;
  for (const JudgedMetric& judged : answer.metrics) {
    const bool is_asked = answer.is_in_headline(judged), are_many = judged.comparisons.size() > most_told;
    for (const Comparison& comparison : judged.comparisons) {
      const bool is_told = is_asked && (!are_many || comparison.first == reference || comparison.second == reference);
      if (!is_told && others.size() == most_listed) {
        ++left_out;
        continue;
      }
      (is_told ? table.rows : others).push_back(row_of(comparison, judged));
      has_p |= std::holds_alternative<TestResult>(comparison.result);
    }
  }
  table.visible_rows = table.rows.size();
  std::ranges::move(others, std::back_inserter(table.rows));
  const std::string decides = ranking_note(answer);
  std::vector<std::string> notes{decides.empty() ? "" : decides + "; other metrics are exploratory.",
                                 answer.verdict.empty() && has_p ? how_p_is_adjusted(answer) : "",
                                 left_out == 0 ? "" : fmt::format("{} more pairs are not listed.", left_out)};
  std::erase(notes, "");
  if (!notes.empty()) table.notes = {fmt::format("{}", fmt::join(notes, " "))};
  return table;
}

Table tested_pairs_table(const ReportModel& answer) {
  Table table = without_pairs(answer);
  const std::size_t metrics = answer.primary().descriptives.size() > 2 ? 1 : answer.metrics.size();
  std::set<int> sizes;
  for (const JudgedMetric& judged : std::span(answer.metrics).first(metrics)) {
    for (const Comparison& comparison : judged.comparisons) {
      if (verdict_of(comparison) == Verdict::not_tested) continue;
      table.rows.push_back(row_of(comparison, judged));
      if (const auto* const tested = std::get_if<TestResult>(&comparison.result)) sizes.insert(tested->n);
    }
  }
  if (answer.direction.empty() || sizes.size() < 2) return table;
  // Pairs of a file that have different blocks in common tell how many.
  std::ranges::find(table.columns, "n", &Column::name)->role = ColumnRole::value;
  return table;
}

Table descriptives_table(const ReportModel& answer) {
  Table table{
      .name = "descriptives",
      .caption = "By metric and solver",
      .columns = named_columns({"metric", "solver", "n", "mean", "sd", "median", "lower quartile", "upper quartile",
                                "95 % quantile", "smallest", "largest", "interval", "unit", "missing"})};
  bool is_any_lost = false, is_any_share = false;
  for (const JudgedMetric& judged : answer.metrics) {
    const MetricSamples& samples = judged.samples;
    for (const std::string& solver : answer.solvers()) {
      const std::size_t i = index_of(samples, solver);
      if (i == samples.groups.size()) continue;
      const Descriptives& its = judged.descriptives[i];
      const Group& group = samples.groups[i];
      auto& row = table.rows.emplace_back();
      row = {samples.quantity, group.name, std::int64_t{its.n}, value_cell(group, its.mean)};
      const std::optional<Interval> interval = interval_of(judged, its);
      for (const double value :
           {its.sd, its.median, its.lower_quartile, its.upper_quartile, its.quantile_95, its.smallest, its.largest})
        row.push_back(interval ? Cell() : value_cell(group, value));
      row.push_back(interval ? Cell(*interval) : Cell());
      is_any_share |= interval.has_value();
      row.emplace_back(samples.unit);
      row.push_back(missing_in(group) > 0 ? Cell(std::int64_t{missing_in(group)}) : Cell());
      is_any_lost |= missing_in(group) > 0;
    }
  }
  table.notes = {fmt::format("n: {}{}. Quartiles as MATLAB's.{}", answer.noun,
                             answer.direction.empty()
                                 ? "; of costs those that a solver solved, of costs per solved all, of times "
                                   "sessions, with their geometric mean"
                                 : "",
                             is_any_share ? " Interval: Wilson's." : "")};
  if (is_any_lost) table.notes.emplace_back("missing: without a value; such a solver is not tested.");
  return table;
}

Table omnibus_table(const ReportModel& answer) {
  Table table{.name = "anova",
              .caption = "Do the solvers differ at all?",
              .columns = named_columns({"metric", "test", "source", "SS", "df", "MS", "statistic", "p", "eta squared",
                                        "partial eta squared", "epsilon"})};
  table.columns[7].role = ColumnRole::p;
  NamesByPhrase left_out;
  for (const JudgedMetric& judged : answer.metrics) {
    const auto [tests, without] = omnibus_tests(judged.samples);
    const std::string& quantity = judged.samples.quantity;
    const auto known = [](double value) { return std::isnan(value) ? Cell() : Cell(value); };
    const auto degrees = [](double df) { return df == std::round(df) ? Cell(std::llround(df)) : Cell(df); };
    const bool is_of_blocks = judged.samples.is_paired;
    for (const OmnibusTest& test : tests) {
      const Cell eta = known(test.eta_squared());
      table.rows.push_back({quantity, std::string(test.name), "between", known(test.ss_between), degrees(test.df),
                            known(test.ss_between / test.df), test.statistic, test.p, is_of_blocks ? Cell() : eta,
                            is_of_blocks ? eta : Cell(), known(test.epsilon)});
      table.rows.push_back({quantity, std::string(test.name), is_of_blocks ? "error (solver x block)" : "within",
                            known(test.ss_within), degrees(test.df_within), known(test.ss_within / test.df_within),
                            Cell(), Cell(), Cell(), Cell(), Cell()});
    }
    if (!without.empty() && !tests.empty()) left_out.add(names_of(without), quantity);
  }
  table.notes = {"The pairs decide, whatever these say."};
  std::ranges::move(left_out.formatted("Without {}: no chance in the values, or not compared ({})."),
                    std::back_inserter(table.notes));
  return table;
}

base::OrderedJson to_json(const ReportModel& answer) {
  base::OrderedJson warnings = base::OrderedJson::array(), direction;
  const Table pairs = pairs_table(answer);
  std::vector<std::string> notes = answer.notes;
  notes.insert(notes.end(), pairs.notes.begin(), pairs.notes.end());
  for (const JudgedMetric& judged : answer.metrics)
    direction[judged.samples.quantity] = judged.samples.better == Better::larger ? "larger" : "smaller";
  for (const Warning& warning : answer.all_warnings()) warnings.push_back(warning_text(warning));
  return {{"headline", headline(answer)},
          {"metric", answer.primary().samples.quantity},
          {"groups", to_json(descriptives_table(answer))},
          {"tests", to_json(omnibus_table(answer))},
          {"findings", to_json(pairs)},
          {"direction", std::move(direction)},
          {"doubts", std::move(warnings)},
          {"notes", notes}};
}

}  // namespace ikbench::show
