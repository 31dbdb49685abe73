#include "analysis/show/report_model.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

#include "analysis/figures/rows.hpp"
#include "analysis/judge/all_answers.hpp"
#include "analysis/show/answers_table.hpp"
#include "analysis/show/hard_targets.hpp"
#include "analysis/show/map_sentence.hpp"
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
    if (auto* const excluded = std::get_if<ExcludedSample>(&group.sample); excluded && !is_log_scale(samples))
      scale_all(excluded->values);
  }
  for (Descriptives& values : judged.descriptives)
    scale(factor, values.mean, values.sd, values.median, values.lower_quartile, values.upper_quartile,
          values.quantile_95, values.smallest, values.largest);
  for (Comparison& comparison : judged.comparisons) {
    auto& estimate = comparison.estimate;
    if (!estimate || comparison.scale == EffectScale::ratio) continue;
    scale(factor, estimate->value);
    if (estimate->interval) scale(factor, estimate->interval->low, estimate->interval->high);
  }
  return judged;
}

// The counts of one solver in a control loop, over all solves.
struct LoopCounts {
  double solves = 0, failed = 0, late = 0;
  double steps = 0, too_fast = 0;  // between two targets of a run
  double largest_step_deg = 0;
  std::int64_t late_in_a_row = 0;  // the longest row
  bool is_timed = true;            // no solves at once, and a release build
};

LoopCounts count_loop(const StudyResults& study, const Solves& solves) {
  LoopCounts counts;
  std::int64_t in_a_row = 0;
  for (const SolveSummary& solve : solves) {
    ++counts.solves;
    counts.is_timed &= results::is_timed_alone(solve.timing);
    counts.failed += has_failed(study, solve);
    counts.late += solve.missed_deadline;
    if (!solve.missed_deadline || solve.point == 1) in_a_row = 0;
    in_a_row += solve.missed_deadline;
    counts.late_in_a_row = std::max(counts.late_in_a_row, in_a_row);
    if (solve.point == 1) continue;
    ++counts.steps;
    counts.too_fast += solve.exceeds_velocity;
    counts.largest_step_deg = std::max(counts.largest_step_deg, solve.largest_move_deg);
  }
  return counts;
}

// Returns "joint 7" for each joint without a known velocity limit.
std::vector<std::string> unlimited_joints(const StudyResults& study) {
  const auto& max_steps = study.definition.max_steps;
  std::vector<std::string> names;
  for (std::size_t j = 0; j < max_steps.size(); ++j)
    if (std::isinf(max_steps[j].first)) names.push_back(fmt::format("joint {}", j + 1));
  return names;
}

Cell percent_cell(double count, double whole) { return whole > 0 ? Cell(100 * count / whole) : Cell(); }

// Returns the table of a control loop; without rows if the study has none.
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
  const std::vector<std::string> unlimited = unlimited_joints(study);
  const bool has_limits = unlimited.size() < study.definition.max_steps.size();
  bool is_all_timed = true;
  for (const std::string& solver : solvers) {
    const Solves solves = study.of(solver);
    if (period == 0 || solves.empty()) continue;
    const LoopCounts counts = count_loop(study, solves);
    is_all_timed &= counts.is_timed;
    table.rows.push_back({solver, percent_cell(counts.failed, counts.solves),
                          counts.is_timed ? percent_cell(counts.late, counts.solves) : Cell(),
                          counts.is_timed ? Cell(counts.late_in_a_row) : Cell(), counts.largest_step_deg,
                          has_limits ? percent_cell(counts.too_fast, counts.steps) : Cell()});
  }
  table.notes = {
      "Steps: movement of one revolute joint between two targets. Late: solved after the period, or not at all."};
  if (!is_all_timed) table.notes.emplace_back("Lateness is not known for parallel solves and debug builds.");
  if (!unlimited.empty())
    table.notes.push_back(
        fmt::format("Never too fast, because the velocity limit is not known: {}.", listed(unlimited)));
  return table;
}

// Returns the times of imported solvers and of the study's own; without rows if none are imported.
Table imported_table(const StudyResults& study, const std::vector<std::string>& solvers) {
  Table table{.name = "beside",
              .caption = "Times relative to LM on the same machine (not tested)",
              .columns = {{"solver"}, {"median"}, {"95 %"}, {"measured"}}};
  const auto lm = std::ranges::find(study.series, study.imported.local_reference, &results::Series::label);
  if (study.imported.labels.empty() || lm == study.series.end()) return table;
  const double local_seconds = describe_values(solve_times(study, lm->label)).median;
  const auto as_ratio = [](double ratio) {
    return ValueCell{.value = ratio, .relative_to_reference = judge::EffectScale::ratio};
  };
  for (const std::string& solver : solvers) {
    const Descriptives times = describe_values(solve_times(study, solver));
    const bool is_imported = study.imported.has(solver);
    const double unit = is_imported ? study.imported.reference_seconds : local_seconds;
    table.rows.push_back({solver, as_ratio(times.median / unit), as_ratio(times.quantile_95 / unit),
                          is_imported ? study.imported.origin : "in this run"});
  }
  return table;
}

// Returns the times per pose in batches, which no single call has; without rows if there are none.
Table batches_table(const StudyResults& study) {
  Table table{.name = "batches",
              .caption = "Time per pose in a batch, solved or not (not tested)",
              .columns = {{"solver"}, {"in batches of"}, {"median", "ms"}, {"95 %", "ms"}}};
  for (const auto& [solver, sizes_and_times] : study.batch_timings) {
    const auto& [sizes, seconds] = sizes_and_times;
    if (seconds.empty()) continue;
    const Descriptives times = describe_values(seconds);
    table.rows.push_back(
        {solver, fmt::format("{}", fmt::join(sizes, ", ")), 1000 * times.median, 1000 * times.quantile_95});
  }
  return table;
}

// True if two metrics' warnings say the same, perhaps with other details.
bool are_one(const Warning& known, const Warning& warning) {
  if (known.kind != warning.kind) return false;
  if (warning.kind == WarningKind::time_limit_decides && known.detail == warning.detail) return true;
  return known.solvers == warning.solvers && known.count == warning.count && known.total == warning.total;
}

// Orders the comparisons of a metric by their solvers' places in its order, and puts the better solver of each first.
void order_comparisons(JudgedMetric& judged, const std::vector<std::size_t>& order) {
  std::map<std::string_view, std::size_t> places;
  for (const std::size_t group : order) places.emplace(judged.samples.groups[group].name, places.size());
  // A map, because a sort of many pairs would look up the names again and again.
  std::multimap<std::pair<std::size_t, std::size_t>, Comparison> by_place;
  for (Comparison& comparison : judged.comparisons) {
    const std::size_t first = places.at(comparison.first), second = places.at(comparison.second);
    by_place.emplace(std::minmax(first, second),
                     better_first(std::move(comparison), judged.plan.control, second < first));
  }
  auto next = judged.comparisons.begin();
  for (auto& [place, comparison] : by_place) *next++ = std::move(comparison);
}

// Returns the notes below the table of results that are about the study.
std::vector<std::string> study_notes(const JudgedStudy& judged) {
  const results::StudyDefinition& definition = judged.study.definition;
  const bool are_runs = definition.compares_runs();
  std::vector<std::string> notes;
  if (are_runs ? definition.points > 1 : definition.runs > 1 && !definition.draws_targets)
    notes.push_back(
        fmt::format("Each {} is the mean of its {}.", are_runs ? "run" : "target", are_runs ? "targets" : "runs"));
  if (definition.is_grid()) notes = map_notes(judged.study);
  const auto is_time = [](const JudgedMetric& metric) { return metric.samples.quantity_kind == QuantityKind::time; };
  if (std::ranges::any_of(judged.metrics, is_time) &&
      std::ranges::any_of(judged.study.solves, &SolveSummary::is_self_timed))
    notes.emplace_back("Times of programs are self-reported.");
  for (const std::string& note : {failure_reasons_text(judged.study), rejections_text(judged.study)})
    if (!note.empty()) notes.push_back(note);
  return notes;
}

std::string study_sentences(const StudyResults& study) {
  const std::string text = study_text(study);
  const std::string name = text.starts_with(study.name + ",") ? "" : study.name + ": ";
  return fmt::format("{}{}. A solve stops {}.", name, text, budget_text(study));
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

void ReportModel::remove_metrics(QuantityKind kind) {
  std::erase_if(metrics, [&](const JudgedMetric& judged) { return judged.samples.quantity_kind == kind; });
  questions = make_headline_questions(metrics, solvers(), tie_breakers);
}

std::vector<Warning> ReportModel::all_warnings() const {
  std::vector<Warning> merged = warnings;
  for (const JudgedMetric& judged : metrics) {
    for (const Warning& warning : judged.samples.warnings) {
      const auto known = std::ranges::find_if(merged, [&](const Warning& other) { return are_one(other, warning); });
      if (known == merged.end())
        merged.push_back(warning);
      else if (known->detail != warning.detail)
        known->detail += ", " + warning.detail;
      else if (known->solvers.size() < warning.solvers.size())  // the clock's warning about shares names fewer solvers
        *known = warning;
    }
  }
  std::ranges::stable_sort(merged, {}, &Warning::kind);
  return merged;
}

ReportModel make_report_model(std::vector<JudgedMetric> metrics, std::size_t primary,
                              std::vector<std::string> tie_breakers) {
  const auto headline_metric = metrics.begin() + static_cast<std::ptrdiff_t>(primary);
  std::rotate(metrics.begin(), headline_metric, headline_metric + 1);
  ReportModel model{.metrics = std::move(metrics), .tie_breakers = std::move(tie_breakers)};
  model.order = display_order(model.primary(), model.metrics);
  for (JudgedMetric& judged : model.metrics) {
    if (is_success_rate(judged)) judged = in_unit(std::move(judged), 100, "%");
    order_comparisons(judged, display_order(judged, model.metrics));
  }
  model.questions = make_headline_questions(model.metrics, model.solvers(), model.tie_breakers);
  return model;
}

ReportModel make_report_model(const JudgedStudy& judged) {
  // Tie-breakers are for solvers that solve alike: another first metric has no second question.
  const results::StudyDefinition& definition = judged.study.definition;
  const bool is_of_solved = judged.metrics[judged.primary].samples.quantity_kind == QuantityKind::solved;
  ReportModel model = make_report_model(judged.metrics, judged.primary,
                                        is_of_solved ? definition.plan.tie_breakers : std::vector<std::string>());
  model.warnings = judged.warnings;
  model.requirements = judged.requirements;
  model.without_answer = never_answering(judged.study);
  model.study_text = study_sentences(judged.study);
  model.extra_tables = {{"Control loop", loop_table(judged.study, model.solvers())},
                        {"Imported results", imported_table(judged.study, model.solvers())},
                        {"In batches", batches_table(judged.study)},
                        {"All answers", definition.is_grid() ? Table() : answers_table(judged.study)}};
  model.targets = targets_table(judged.targets);
  if (definition.is_grid())
    model.verdict = map_sentence(judged, model.solvers());
  else
    model.hard_targets = hard_targets(judged.targets, model.solvers());
  model.noun = definition.compares_runs() ? "runs" : "targets";
  if (definition.stop.only_time_limits()) model.time_limit = number_text(1000 * definition.stop.seconds) + " ms";
  model.named_metrics = names_in_plan(definition).size();
  for (JudgedMetric& metric : model.metrics) {
    const auto [unit, factor] = figures::drawn_unit(judged.study, metric.samples.unit);
    if (factor != 1) metric = in_unit(std::move(metric), factor, unit);
  }
  model.notes = study_notes(judged);
  model.rejections_text = rejections_text(judged.study);
  model.answers_text = why_not_counted(judged.study);
  return model;
}

std::vector<std::string> closed_metrics(const ReportModel& model) {
  std::vector<std::string> names;
  for (const JudgedMetric& judged : model.metrics)
    if (are_by_closed_tests(judged.comparisons)) names.push_back(judged.samples.quantity);
  return names;
}

std::string observation_noun(const ReportModel& model, const JudgedMetric& judged) {
  return judged.samples.quantity_kind == QuantityKind::time ? "sessions" : model.noun;
}

bool has_failed(const StudyResults& study, const SolveSummary& solve) {
  return study.definition.has_tolerance() ? solve.status != results::Status::ok : !has_answer(solve);
}

std::string reference_of(const ReportModel& model) {
  const JudgedMetric& decisive = model.primary();
  if (!decisive.plan.control.empty()) return decisive.plan.control;
  return decisive.samples.groups[model.order[0]].name;
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
