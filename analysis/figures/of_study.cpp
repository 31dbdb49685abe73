#include "analysis/figures/of_study.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

#include "analysis/figures/arm.hpp"
#include "analysis/figures/solver_styles.hpp"
#include "numerics/names.hpp"
#include "numerics/units.hpp"
#include "robots/robot.hpp"

namespace ikbench::figures {

using namespace compare;
using namespace numerics;
using results::SolveRecord;

namespace {

constexpr std::string_view error = "position_error_cm", motion = "variation_deg", time = "seconds";
constexpr std::size_t most_iterations = 200;  // drawn

// Targets that have an order.
bool is_path(const StudyResults& study) { return !study.definition.draws_targets && study.points > 1; }

CurveRow row_at(double x, const std::vector<double>& values, Average average) {
  const compare::Description all = describe({.name = "", .values = values});
  if (average == Average::mean) return {.x = x, .y = all.mean, .dotted = values.size() > 1 ? all.median : nowhere};
  if (values.size() == 1) return {.x = x, .y = all.median};
  return {.x = x, .y = all.median, .low = all.lower_quartile, .high = all.upper_quartile};
}

About about_of(const StudyResults& study, const Metric& metric, std::string name, std::string caption) {
  const auto [unit, factor] = drawn_unit(study, metric.unit);
  return {std::move(name), std::move(caption), std::string(metric.name), unit, factor * metric.rounding};
}

std::string observation_of(const StudyResults& study, const Metric& metric) {
  const std::string_view average = metric.kind == Kind::time ? "median" : "mean";
  if (study.definition.is_chained()) return fmt::format("the {} of a run", average);
  return study.runs > 1 && !study.definition.draws_targets ? fmt::format("a target, the {} of its runs", average)
                                                           : "a target";
}

std::string caption_of_boxes(std::string_view quantity, std::string_view observation) {
  return fmt::format("Distribution of {}: a dot is {}; box: quartiles and median; whiskers: smallest and largest.",
                     quantity, observation);
}

std::vector<BoxRow> rows_of(const std::vector<std::string>& solvers, const Judged& metric, double factor,
                            const Look& look) {
  std::vector<BoxRow> rows;
  for (const std::string& solver : solvers) {
    const auto group = std::ranges::find(metric.observations.groups, solver, &Group::name);
    const compare::Description all = describe(*group);
    BoxRow& row = rows.emplace_back(
        BoxRow{.label = name_of(look, solver), .style = style_of(look, solver), .values = group->values});
    row.box = {all.smallest, all.lower_quartile, all.median, all.upper_quartile, all.largest};
    for (double& value : row.values) value *= factor;
    for (double& value : row.box) value *= factor;
    if (std::isinf(all.largest)) {  // no whisker ends there, and no box
      std::vector<double> finite = row.values;
      std::erase_if(finite, [](double value) { return std::isinf(value); });
      row.remark = fmt::format("no answer in {}", row.values.size() - finite.size());
      row.box.back() = finite.empty() ? nowhere : std::ranges::max(finite);
      if (std::isinf(all.upper_quartile)) row.box.fill(nowhere);
    }
    if (group->lost > 0) row.remark += fmt::format("{}{} lost", row.remark.empty() ? "" : ", ", group->lost);
  }
  return rows;
}

Figure boxes_of(const JudgedStudy& judged, const Judged& judged_metric, std::string_view column, std::string name,
                const Look& look) {
  const Metric& metric = metric_named(column);
  About about = about_of(judged.study, metric, std::move(name),
                         caption_of_boxes(metric.name, observation_of(judged.study, metric)));
  const auto [unit, factor] = drawn_unit(judged.study, metric.unit);
  double tolerance = 0;
  for (const Group& group : judged_metric.observations.groups) tolerance = std::max(tolerance, factor * group.at_most);
  if (tolerance > 0) about.caption += fmt::format(" Values up to {0:.3g} {1} count as {0:.3g} {1}.", tolerance, unit);
  about.floor = std::max(about.floor, tolerance);
  return boxes(about, box_rows(judged, judged_metric, look));
}

// With a tolerance the share solved, which tells more than errors that all are below it.
std::optional<Figure> overview_of(const JudgedStudy& judged, const Look& look) {
  const bool is_share = judged.study.definition.has_tolerance();
  const Judged* const errors = judged_of(judged, is_share ? "solved" : error);
  const Judged* const motions = judged_of(judged, motion);
  if (errors == nullptr || motions == nullptr) return std::nullopt;
  const bool are_means = motions->plan.test == results::Plan::Test::means;
  const std::string average = are_means ? "mean" : "median";
  const auto value = [](const Judged& of, const std::string& solver, bool is_mean) {
    const compare::Description all = describe(*std::ranges::find(of.observations.groups, solver, &Group::name));
    return is_mean ? all.mean : all.median;
  };
  std::vector<Dot> dots;
  std::string without;
  const double factor = is_share ? 100 : drawn_unit(judged.study, errors->observations.unit).factor;
  for (const std::string& solver : shown_solvers(judged.study, look)) {
    dots.push_back({.label = name_of(look, solver),
                    .style = style_of(look, solver),
                    .x = value(*motions, solver, are_means),
                    .y = factor * value(*errors, solver, are_means || is_share)});
    if (std::isnan(dots.back().x)) without += (without.empty() ? "" : ", ") + solver;
  }
  About about = about_of(judged.study, metric_named(error), "overview",
                         fmt::format("Error against joint motion, {}s: best is the lower left.", average));
  about.quantity = fmt::format("{} {}", average, about.quantity);
  if (is_share) about = {"overview", "Share solved against joint motion: best is the upper left.", "solved", "%"};
  if (!without.empty()) about.caption += fmt::format(" Without a known joint motion: {}.", without);
  return overview(about, average + " joint motion [deg]", dots);
}

std::optional<Figure> solved_of(const StudyResults& study, const Look& look) {
  std::vector<Successes> all;
  bool are_counted = study.definition.has_tolerance();
  for (const std::string& solver : shown_solvers(study, look)) {
    Successes& one = all.emplace_back(Successes{.label = name_of(look, solver), .style = style_of(look, solver)});
    for (const Solve& solve : study.of(solver)) {
      are_counted = are_counted && solve.counted_by != results::CountedBy::nobody;
      ++one.attempts;
      if (solve.status == results::Status::ok)
        one.costs.push_back(std::max(1.0, static_cast<double>(solve.evaluations)));
    }
  }
  if (!are_counted) return std::nullopt;
  return shares({.name = "solved-by-evaluations",
                 .caption = "Share of targets solved within a number of evaluations.",
                 .quantity = "evaluations"},
                all);
}

std::optional<Figure> differences_of(const std::vector<std::string>& shown, const Judged& metric, const DrawnUnit& unit,
                                     const Look& look) {
  const Observations& of = metric.observations;
  Look brief = look;  // two names a row
  brief.names = short_names(shown, 20);
  const auto name = [&](const std::string& solver) { return name_of(brief, solver); };
  std::vector<IntervalRow> rows;
  bool are_ratios = false;
  for (const Finding& each : metric.findings) {
    const Finding finding = better_first(each, metric.plan.control);
    if (std::ranges::count(shown, finding.first) == 0 || std::ranges::count(shown, finding.second) == 0) continue;
    are_ratios = finding.scale == Scale::ratio;
    const double factor = are_ratios ? 1 : finding.scale == Scale::share ? 100 : unit.factor;
    IntervalRow& row = rows.emplace_back();
    row.label = fmt::format("{} {} {}", name(finding.first), are_ratios ? "/" : "-", name(finding.second));
    if (finding.estimate) row.estimate = factor * *finding.estimate;
    if (finding.interval) row.low = factor * finding.interval->low, row.high = factor * finding.interval->high;
    const bool is_better = finding.verdict == Verdict::better, is_worse = finding.verdict == Verdict::worse;
    const std::string& better = is_better ? finding.first : finding.second;
    row.verdict = is_better || is_worse                    ? name(better) + " better"
                  : finding.verdict == Verdict::same       ? "the same"
                  : finding.verdict == Verdict::not_tested ? "not tested"
                                                           : "not decided";
    if (is_better || is_worse) row.style = style_of(look, better);
  }
  if (rows.empty()) return std::nullopt;
  const std::string quantity = (of.scale == Scale::share ? "share " : "") + of.quantity;
  return differences(
      {.name = "differences",
       .caption = fmt::format("{} of {} by pairs, with intervals that hold together; at the right who is "
                              "better.",
                              are_ratios ? "Ratio" : "Difference", quantity),
       .quantity = fmt::format("{} of {}", are_ratios ? "ratio" : "difference", quantity),
       .unit = are_ratios                 ? ""
               : of.scale == Scale::share ? "points"
                                          : unit.name},
      rows, are_ratios);
}

}  // namespace

Look look_of(const std::vector<results::Series>& solvers, results::FigureStyle style) {
  std::vector<NamedSolver> named;
  for (const results::Series& solver : solvers) named.push_back({solver.label, solver.algorithm});
  std::ranges::stable_sort(named, {}, [&](const NamedSolver& solver) {  // those that are not shown come last
    return std::ranges::find(style.solvers, solver.label) - style.solvers.begin();
  });
  Look look{.style = std::move(style), .lines = {}};
  look.lines = line_styles(named, look.style);
  std::vector<std::string> labels;
  for (const NamedSolver& solver : named) labels.push_back(solver.label);
  look.names = short_names(labels, 36);
  return look;
}

std::vector<std::string> shown_solvers(const StudyResults& study, const Look& look) {
  std::vector<std::string> shown = look.style.solvers.empty() ? study.solvers : look.style.solvers;
  std::erase_if(shown, [&](const std::string& solver) { return study.of(solver).empty(); });
  return shown;
}

int style_of(const Look& look, const std::string& solver) {
  const auto found = look.lines.find(solver);
  return found == look.lines.end() ? 1 : found->second;
}

std::string name_of(const Look& look, const std::string& solver) {
  const auto found = look.names.find(solver);
  return found == look.names.end() ? solver : found->second;
}

const Judged* judged_of(const JudgedStudy& judged, std::string_view column) {
  const auto found = std::ranges::find_if(
      judged.metrics, [&](const Judged& each) { return each.observations.metric == metric_named(column).slug; });
  return found == judged.metrics.end() ? nullptr : &*found;
}

DrawnUnit drawn_unit(const StudyResults& study, std::string_view unit) {
  if (unit == "s") return {"ms", 1000};
  if (unit == "cm" && study.definition.published.empty()) return {"mm", 10};
  return {std::string(unit), 1};
}

std::vector<BoxRow> box_rows(const JudgedStudy& judged, const Judged& metric, const Look& look) {
  return rows_of(shown_solvers(judged.study, look), metric, drawn_unit(judged.study, metric.observations.unit).factor,
                 look);
}

std::vector<Line> by_point(const StudyResults& study, std::string_view column, const Look& look, Average average) {
  const Metric& metric = metric_named(column);
  const double factor = drawn_unit(study, metric.unit).factor;
  std::vector<Line> all;
  for (const std::string& solver : shown_solvers(study, look)) {
    std::map<int, std::vector<double>> values;
    for (const Solve& solve : study.of(solver)) {
      const double value = factor * metric.value(solve, study);
      if (std::isfinite(value)) values[solve.point].push_back(value);
    }
    Line& line = all.emplace_back(Line{.label = name_of(look, solver), .style = style_of(look, solver)});
    for (const auto& [point, of_point] : values) line.rows.push_back(row_at(point, of_point, average));
  }
  return all;
}

std::vector<Line> by_iteration(const StudyResults& study, const Look& look, Average average) {
  const double factor = drawn_unit(study, "cm").factor;
  std::vector<Line> all;
  for (const std::string& solver : shown_solvers(study, look)) {
    std::vector<std::span<const double>> traces;
    for (const SolveRecord& solve : study.drawn) {
      if (solve.solver == solver && !solve.trace_cm.empty()) traces.emplace_back(solve.trace_cm);
    }
    if (traces.empty()) continue;
    const std::size_t longest = std::ranges::max(traces, {}, &std::span<const double>::size).size();
    Line& line = all.emplace_back(Line{.label = name_of(look, solver), .style = style_of(look, solver)});
    const std::size_t step = 1 + (longest - 1) / most_iterations;
    for (std::size_t i = 0; i < longest; i += step) {
      std::vector<double> values;
      for (const std::span<const double> trace : traces) {
        const double value = factor * trace[std::min(i, trace.size() - 1)];
        if (std::isfinite(value)) values.push_back(value);
      }
      if (!values.empty()) line.rows.push_back(row_at(static_cast<double>(i + 1), values, average));
    }
  }
  return all;
}

PathRows path_rows(const StudyResults& study, const std::string& solver, std::size_t arms, const Look& look) {
  const std::span<const SolveRecord> solves = study.first_run_of(solver);
  const auto corner_of = [](std::span<const double> metres) {
    if (metres.size() != 3) return Corner{nowhere, nowhere, nowhere};
    return Corner{metres[0] / centimetre, metres[1] / centimetre, metres[2] / centimetre};
  };
  PathRows rows{.targets = {},
                .reached_label = "reached by " + name_of(look, solver),
                .style = style_of(look, solver),
                .is_joined = is_path(study),
                .is_closed = study.definition.path == "circle" && std::ssize(solves) == study.points};
  const std::optional<robots::Robot> arm = robots::stored_arm(study.definition.arm);
  const std::size_t every = arms == 0 ? 1 : std::max<std::size_t>(1, (solves.size() + arms - 1) / arms);
  for (std::size_t i = 0; i < solves.size(); ++i) {
    const SolveRecord& solve = solves[i];
    rows.targets.push_back(corner_of(solve.target_position_m));
    rows.reached.push_back(corner_of(solve.reached_position_m));
    const Eigen::Map<const Eigen::VectorXd> q(solve.answer_rad.data(),
                                              static_cast<Eigen::Index>(solve.answer_rad.size()));
    if (arms == 0 || i % every != 0 || !arm || q.size() != arm->joints() || !q.allFinite()) continue;
    std::vector<Corner>& corners =
        rows.arms.emplace_back(fmt::format("arm at point {}", solve.point), std::vector<Corner>()).second;
    for (const Point& point : arm_points(*arm, q)) corners.push_back(corner_of(point));
  }
  return rows;
}

JointRows joint_rows(const StudyResults& study, const Look& look) {
  JointRows all;
  const std::optional<robots::Robot> arm = robots::stored_arm(study.definition.arm);
  if (!arm) return all;
  std::vector<std::size_t> turning;
  for (std::size_t joint = 0; joint < arm->chain.links().size(); ++joint) {
    if (arm->chain.links()[joint].joint == robots::Joint::slides) continue;
    turning.push_back(joint);
    const auto j = static_cast<Eigen::Index>(joint);
    all.columns.push_back(
        {fmt::format("joint {}", joint + 1), arm->limits.lower[j] / degree, arm->limits.upper[j] / degree});
  }
  for (const std::string& solver : shown_solvers(study, look)) {
    JointRow row{.label = name_of(look, solver), .style = style_of(look, solver)};
    for (const SolveRecord& solve : study.first_run_of(solver)) {
      std::vector<double>& angles = row.angles_deg.emplace_back();
      for (const std::size_t joint : turning)
        angles.push_back(joint < solve.answer_rad.size() ? solve.answer_rad[joint] / degree : nowhere);
    }
    all.rows.push_back(std::move(row));
  }
  return all;
}

std::vector<Figure> of_file(const std::vector<Judged>& metrics, const Look& look) {
  std::vector<Figure> all;
  std::vector<std::string> shown = look.style.solvers;
  for (const Judged& metric : metrics) {
    const Observations& of = metric.observations;
    if (shown.empty()) std::ranges::transform(of.groups, std::back_inserter(shown), &Group::name);
    const bool has_values = std::ranges::any_of(of.groups, [](const Group& group) { return !group.values.empty(); });
    if (!has_values || (of.scale == Scale::share && of.trials == 1)) continue;
    const std::string number = all.empty() ? "" : fmt::format("-{}", all.size() + 1);
    all.push_back(boxes({.name = "boxes" + number,
                         .caption = caption_of_boxes(of.quantity, "a value"),
                         .quantity = of.quantity,
                         .unit = of.unit},
                        rows_of(shown, metric, 1, look)));
  }
  const Judged& first = metrics.front();
  if (auto figure = differences_of(shown, first, {first.observations.unit}, look)) all.push_back(std::move(*figure));
  return all;
}

std::vector<Figure> of_study(const JudgedStudy& judged, const Look& look) {
  const StudyResults& study = judged.study;
  const std::vector<std::string> shown = shown_solvers(study, look);
  if (shown.empty()) return {};
  std::vector<Figure> all;
  const auto add = [&](std::optional<Figure> figure) {
    if (figure) all.push_back(std::move(*figure));
  };
  add(overview_of(judged, look));
  if (const Judged* const errors = judged_of(judged, error))
    add(boxes_of(judged, *errors, error, "error-boxes", look));
  else if (study.definition.has_tolerance())  // where errors are not judged
    add(boxes_of(judged, {.observations = observe(study, metric_named(error))}, error, "error-boxes", look));
  const auto has_doubt = [](const std::vector<Doubt>& doubts) {
    return std::ranges::count(doubts, DoubtKind::times_not_comparable, &Doubt::kind) > 0;
  };
  const Judged *const times = judged_of(judged, time), *const motions = judged_of(judged, motion);
  if (times != nullptr && !has_doubt(times->observations.doubts) && !has_doubt(judged.doubts)) {
    add(boxes_of(judged, *times, time, "time-boxes", look));
  } else if (motions != nullptr) {
    add(boxes_of(judged, *motions, motion, "motion-boxes", look));
  }
  const std::vector<Line> traced = by_iteration(study, look, Average::median);
  const auto error_curves = [&](std::string_view by, const std::string& axis, const std::vector<Line>& curves_of) {
    const bool has_bands = study.runs > 1 || by == "iteration";
    return curves(about_of(study, metric_named(error), fmt::format("error-by-{}", by),
                           fmt::format("Error by {}: median{}.", by, has_bands ? " and quartiles" : "")),
                  axis, curves_of);
  };
  if (!traced.empty()) {
    add(error_curves("iteration", "iteration", traced));
  } else if (is_path(study)) {
    add(error_curves("point", "point", by_point(study, error, look, Average::median)));
  }
  add(solved_of(study, look));
  const Judged& deciding = judged.metrics[judged.deciding];
  add(differences_of(shown, deciding, drawn_unit(study, deciding.observations.unit), look));
  const std::vector<std::string>& best = deciding.headline.best;
  const auto found = std::ranges::find_first_of(shown, best);
  const std::string drawn = found != shown.end() ? *found : shown.front();
  const std::string part = study.points > most_drawn ? fmt::format(" The first {} points.", most_drawn) : "";
  if (study.points > 1)
    add(path({.name = "path", .caption = fmt::format("Targets, and what {} reached in its first run.{}", drawn, part)},
             path_rows(study, drawn, 1, look)));
  if (is_path(study)) {
    const auto [rows, columns] = joint_rows(study, look);
    if (!columns.empty())
      add(joints({.name = "joints",
                  .caption = "Joint angles along the path, first run of each solver. Dashed: limits." + part},
                 rows, columns));
  }
  return all;
}

}  // namespace ikbench::figures
