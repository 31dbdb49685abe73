#include "analysis/show/report_model.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

#include "analysis/figures/rows.hpp"
#include "analysis/show/phrases.hpp"
#include "analysis/show/text.hpp"

namespace ikbench::show {

using namespace judge;

namespace {

void scale(double factor, auto&... values) { ((values *= factor), ...); }

JudgedMetric in_unit(JudgedMetric judged, double factor, std::string unit) {
  MetricSamples& samples = judged.samples;
  samples.unit = std::move(unit);
  scale(factor, samples.resolution, samples.absolute_margin);
  if (auto* const ratios = std::get_if<Ratios>(&samples.kind)) scale(factor, ratios->floor);
  const auto scale_all = [=](std::vector<double>& values) {
    for (double& value : values) scale(factor, value);
  };
  for (Group& group : samples.groups) {
    scale(factor, group.tolerance);
    if (auto* const measured = std::get_if<Sample>(&group.sample); measured && !is_log_scale(samples))
      scale_all(measured->values);
    if (auto* const printed = std::get_if<SummaryStatistics>(&group.sample)) scale(factor, printed->mean, printed->sd);
    if (auto* const its = std::get_if<ExcludedSample>(&group.sample); its && !is_log_scale(samples))
      scale_all(its->values);
  }
  for (Descriptives& its : judged.descriptives)
    scale(factor, its.mean, its.sd, its.median, its.lower_quartile, its.upper_quartile, its.quantile_95, its.smallest,
          its.largest);
  for (Comparison& comparison : judged.comparisons) {
    auto& amount = comparison.estimate;
    if (!amount || comparison.scale == EffectScale::ratio) continue;
    scale(factor, amount->value);
    if (amount->interval) scale(factor, amount->interval->low, amount->interval->high);
  }
  return judged;
}

// Of a control loop; without rows if the study has none.
Table loop_table(const StudyResults& study, const std::vector<std::string>& solvers) {
  const double period = study.definition.loop.period;
  const std::vector<double> ends{0, 100};
  Table table{.name = "loop",
              .caption = fmt::format("A control loop of {} ms", number_text(1000 * period)),
              .columns = {{"solver"},
                          {.name = "failed", .unit = "%", .boundaries = ends},
                          {.name = "late", .unit = "%", .boundaries = ends},
                          {"late in a row"},
                          {"largest step", "deg"},
                          {.name = "too fast", .unit = "%", .boundaries = ends}}};
  const auto& all_steps = study.definition.max_steps;
  std::vector<std::string> unlimited;
  for (std::size_t j = 0; j < all_steps.size(); ++j)
    if (std::isinf(all_steps[j].first)) unlimited.push_back(fmt::format("joint {}", j + 1));
  bool is_all_timed = true;
  for (const std::string& solver : solvers) {
    const Solves all = study.of(solver);
    if (period == 0 || all.empty()) continue;
    double failed = 0, late = 0, steps = 0, too_fast = 0, largest = 0;
    std::int64_t in_a_row = 0, most = 0;
    bool is_timed = true;
    for (const SolveSummary& solve : all) {
      is_timed &= solve.timing == results::Timing::clean || solve.timing == results::Timing::process;
      failed += has_failed(study, solve);
      late += solve.missed_deadline;
      in_a_row = solve.missed_deadline ? 1 + (solve.point > 1 ? in_a_row : 0) : 0;
      most = std::max(most, in_a_row);
      if (solve.point == 1) continue;
      ++steps;
      too_fast += solve.exceeds_velocity;
      largest = std::max(largest, solve.largest_move_deg);
    }
    is_all_timed &= is_timed;
    const auto percent = [](double count, double of) { return of > 0 ? Cell(100 * count / of) : Cell(); };
    const auto n = static_cast<double>(all.size());
    table.rows.push_back({solver, percent(failed, n), is_timed ? percent(late, n) : Cell(),
                          is_timed ? Cell(most) : Cell(), largest,
                          unlimited.size() == all_steps.size() ? Cell() : percent(too_fast, steps)});
  }
  table.notes = {
      "Steps are of one joint that turns, between two targets; late: longer than the period, or without an answer."};
  if (!is_all_timed) table.notes.emplace_back("Of solves at once and of a debug build it is not known who is late.");
  if (!unlimited.empty())
    table.notes.push_back(fmt::format("Without a known velocity limit, so never too fast: {}.", listed(unlimited)));
  return table;
}

// Of solvers of another machine and of those of this one; without rows if there are none.
Table beside_table(const StudyResults& study, const std::vector<std::string>& solvers) {
  Table table{.name = "beside",
              .caption = "Times as multiples of LM's on the same machine, not tested",
              .columns = {{"solver"}, {"median", "times"}, {"95 %", "times"}, {"measured"}}};
  const auto lm = std::ranges::find(study.series, study.imported.local_reference, &results::Series::label);
  if (study.imported.labels.empty() || lm == study.series.end()) return table;
  const double here = describe_values(solve_times(study, lm->label)).median;
  for (const std::string& solver : solvers) {
    const Descriptives its = describe_values(solve_times(study, solver));
    const bool is_there = study.imported.has(solver);
    const double unit = is_there ? study.imported.reference_seconds : here;
    table.rows.push_back(
        {solver, its.median / unit, its.quantile_95 / unit, is_there ? study.imported.origin : "in this run"});
  }
  return table;
}

// Times in batches, which are no single call's; without rows if there are none.
Table batches_table(const StudyResults& study) {
  Table table{.name = "batches",
              .caption = "The time of a pose in a batch, solved or not, not tested",
              .columns = {{"solver"}, {"in batches of"}, {"median", "ms"}, {"95 %", "ms"}}};
  for (const auto& [solver, its] : study.batch_timings) {
    if (its.second.empty()) continue;
    const Descriptives all = describe_values(its.second);
    table.rows.push_back(
        {solver, fmt::format("{}", fmt::join(its.first, ", ")), 1000 * all.median, 1000 * all.quantile_95});
  }
  return table;
}

}  // namespace

std::vector<std::string> ReportModel::solvers() const {
  std::vector<std::string> names;
  for (const std::size_t i : order) names.push_back(primary().samples.groups[i].name);
  return names;
}

bool ReportModel::is_in_headline(const JudgedMetric& judged) const {
  return std::ranges::any_of(questions,
                             [&](const HeadlineQuestion& question) { return &metrics[question.metric] == &judged; });
}

std::vector<Warning> ReportModel::all_warnings() const {
  std::vector<Warning> all = warnings;
  for (const JudgedMetric& judged : metrics) {
    for (const Warning& warning : judged.samples.warnings) {
      const auto known = std::ranges::find_if(all, [&](const Warning& other) {
        const bool is_one =
                       other.solvers == warning.solvers && other.count == warning.count && other.total == warning.total,
                   is_of_clock = warning.kind == WarningKind::time_limit_decides && other.detail == warning.detail;
        return other.kind == warning.kind && (is_one || is_of_clock);
      });
      if (known == all.end())
        all.push_back(warning);
      else if (known->detail != warning.detail)
        known->detail += ", " + warning.detail;
      else if (known->solvers.size() < warning.solvers.size())  // of shares the clock names fewer
        *known = warning;
    }
  }
  std::ranges::stable_sort(all, {}, &Warning::kind);
  return all;
}

ReportModel make_report_model(std::vector<JudgedMetric> metrics, std::size_t primary,
                              const std::vector<std::string>& tie_breakers) {
  const auto headline_metric = metrics.begin() + static_cast<std::ptrdiff_t>(primary);
  std::rotate(metrics.begin(), headline_metric, headline_metric + 1);
  ReportModel answer{.metrics = std::move(metrics)};
  answer.order = display_order(answer.primary(), answer.metrics);
  for (JudgedMetric& judged : answer.metrics) {
    if (is_success_rate(judged)) judged = in_unit(std::move(judged), 100, "%");
    std::map<std::string_view, std::size_t> places;
    for (const std::size_t i : display_order(judged, answer.metrics))
      places.emplace(judged.samples.groups[i].name, places.size());
    std::multimap<std::pair<std::size_t, std::size_t>, Comparison> by_place;  // many pairs: a sort would look names up
    for (Comparison& its : judged.comparisons) {
      const std::size_t first = places.at(its.first), second = places.at(its.second);
      by_place.emplace(std::minmax(first, second), better_first(std::move(its), judged.plan.control, second < first));
    }
    auto next = judged.comparisons.begin();
    for (auto& [place, its] : by_place) *next++ = std::move(its);
  }
  answer.questions = make_headline_questions(answer.metrics, answer.solvers(), tie_breakers);
  return answer;
}

ReportModel make_report_model(const JudgedStudy& judged) {
  // Tie-breakers are for solvers that solve alike: another first metric leaves no second question.
  const bool is_of_solved = judged.metrics[judged.primary].samples.quantity_kind == QuantityKind::solved;
  ReportModel all =
      make_report_model(judged.metrics, judged.primary,
                        is_of_solved ? judged.study.definition.plan.tie_breakers : std::vector<std::string>());
  all.warnings = judged.warnings;
  const std::string solved = study_text(judged.study), &name = judged.study.name;
  all.study_text = fmt::format("{}{}. A solve ends at {}.", solved.starts_with(name + ",") ? "" : name + ": ", solved,
                               budget_text(judged.study));
  all.extra_tables = {{"Control loop", loop_table(judged.study, all.solvers())},
                      {"Beside another machine", beside_table(judged.study, all.solvers())},
                      {"In batches", batches_table(judged.study)}};
  const results::StudyDefinition& definition = judged.study.definition;
  const bool are_runs = definition.compares_runs();
  all.noun = are_runs ? "runs" : "targets";
  if (definition.stop.only_time_limits())
    all.within = fmt::format(" within {} ms", number_text(1000 * definition.stop.seconds));
  all.named_metrics = names_in_plan(definition).size();
  if (are_runs ? definition.points > 1 : definition.runs > 1 && !definition.draws_targets)
    all.notes.push_back(
        fmt::format("Each {} is the mean of its {}.", are_runs ? "run" : "target", are_runs ? "targets" : "runs"));
  for (JudgedMetric& metric : all.metrics) {
    const auto [unit, factor] = figures::drawn_unit(judged.study, metric.samples.unit);
    if (factor != 1) metric = in_unit(std::move(metric), factor, unit);
  }
  const auto is_of_time = [](const JudgedMetric& metric) { return metric.samples.quantity_kind == QuantityKind::time; };
  if (std::ranges::any_of(judged.metrics, is_of_time) &&
      std::ranges::any_of(judged.study.solves, &SolveSummary::is_self_timed))
    all.notes.emplace_back("Times of programs are told by them.");
  all.rejections_text = rejections_text(judged.study);
  for (const std::string& note : {failure_reasons_text(judged.study), all.rejections_text})
    if (!note.empty()) all.notes.push_back(note);
  return all;
}

std::string observation_noun(const ReportModel& answer, const JudgedMetric& judged) {
  return judged.samples.quantity_kind == QuantityKind::time ? "sessions" : answer.noun;
}

bool has_failed(const StudyResults& study, const SolveSummary& solve) {
  return study.definition.has_tolerance() ? solve.status != results::Status::ok : !has_answer(solve);
}

std::string reference_of(const ReportModel& answer) {
  const JudgedMetric& decisive = answer.primary();
  if (!decisive.plan.control.empty()) return decisive.plan.control;
  return decisive.samples.groups[answer.order[0]].name;
}

BoundedValue displayed_average(const JudgedMetric& judged, std::size_t group) {
  return displayed(judged, group, average_of(judged, group));
}

BoundedValue displayed(const JudgedMetric& judged, std::size_t group, double value) {
  const MetricSamples& samples = judged.samples;
  const double at_most = samples.groups[group].tolerance;
  const auto is_ratio = [](const Comparison& comparison) {
    return comparison.scale == EffectScale::ratio && comparison.estimate.has_value();
  };
  if (std::isfinite(value) && value < floor_of(samples) && std::ranges::any_of(judged.comparisons, is_ratio))
    return {floor_of(samples), true};
  return {value, at_most > 0 && value == at_most};
}

std::vector<double> percent_boundaries(const JudgedMetric& judged) {
  return is_success_rate(judged) ? std::vector<double>{0, 100} : std::vector<double>();
}

bool is_success_rate(const JudgedMetric& judged) { return is_proportion(judged.samples); }

}  // namespace ikbench::show
