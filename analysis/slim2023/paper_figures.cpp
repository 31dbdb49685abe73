#include "analysis/slim2023/paper_figures.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "analysis/claims/rules_of_solves.hpp"
#include "analysis/figures/axis.hpp"
#include "analysis/figures/box_figure.hpp"
#include "analysis/figures/figure_parts.hpp"
#include "analysis/figures/overview_figure.hpp"
#include "analysis/figures/study_figures.hpp"
#include "analysis/inference/comparable.hpp"
#include "analysis/inference/convergence.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/slim2023/circle.hpp"
#include "analysis/slim2023/paper_tables.hpp"
#include "analysis/slim2023/published_numbers.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "numerics/number.hpp"

namespace ikbench::slim2023 {

using namespace numerics;
using namespace results;
using namespace statistics;
using namespace inference;
using namespace figures;

namespace {

// The factor that makes IK-BA's printed median time ours; not defined if our times are not comparable.
double time_scale(const StudyResults& study) {
  const std::optional<PrintedRow> printed = printed_row(study, time_reference, Metric::seconds);
  if (!printed || !times_are_comparable(study)) return not_defined;
  for (const Sample& sample : samples(study, Metric::seconds)) {
    if (sample.solver == time_reference) return median(sample.values) / printed->printed.median;
  }
  return not_defined;
}

// The printed times are of another machine: their ratios can be compared.
std::string printed_ratios(const StudyResults& study) {
  const std::optional<PrintedRow> reference = printed_row(study, time_reference, Metric::seconds);
  std::vector<std::string> ratios;
  for (const PrintedRow& row : printed_table_3(study, Metric::seconds)) {
    if (!reference || row.algorithm == time_reference) continue;
    ratios.push_back(
        fmt::format("{} {}", row.algorithm, rounded_number(row.printed.mean / reference->printed.mean, 3)));
  }
  return ratios.empty() ? "" : fmt::format(" Printed mean times by {}'s: {}.", time_reference, fmt::join(ratios, ", "));
}

// figure-10, 11, 12, with the printed numbers beside the boxes. A printed minimum of 0 is below half a unit of its
// digits.
Figure printed_box_figure(const StudyResults& study, Metric metric) {
  const bool is_time = metric == Metric::seconds;
  const double scale = is_time ? time_scale(study) : 1;
  std::vector<Mark> marks;
  std::string below;
  for (const PrintedRow& row : printed_table_3(study, metric)) {
    const bool is_drawn = study.plan.unit == Unit::run && std::isfinite(scale);
    if (!is_drawn || std::ranges::count(study.solvers, row.algorithm) == 0) continue;
    const double resolution = claims::half_unit(row.digits.back());
    const double least = row.printed.min > 0 ? row.printed.min : resolution;
    const bool is_open = !(row.printed.min > 0);
    marks.push_back({row.algorithm, scale * least, scale * row.printed.median, scale * row.printed.max, is_open});
    if (!is_open) continue;
    below +=
        fmt::format(" Arrow: the printed minimum of {} is 0, so below {}.", row.algorithm, rounded_number(least, 3));
  }
  Figure figure = box_figure(study, metric, fmt::format("figure-{}", paper_numbers(metric).box_figure), marks);
  if (!marks.empty()) {
    figure.caption += fmt::format(
        " Grey: printed minimum, median and maximum{}.{}",
        is_time ? fmt::format(" times, scaled so that the median of {} is ours", time_reference) : "", below);
  }
  return figure;
}

std::vector<OverviewMark> printed_means(const StudyResults& study) {
  std::vector<OverviewMark> marks;
  for (const PrintedRow& row : printed_table_3(study, Metric::position_error_cm)) {
    const auto variation = printed_row(study, row.algorithm, Metric::variation_deg);
    const auto seconds = printed_row(study, row.algorithm, Metric::seconds);
    if (!variation || !seconds) continue;
    marks.push_back({.solver = row.algorithm,
                     .error_cm = row.printed.mean,
                     .variation_deg = variation->printed.mean,
                     .seconds = seconds->printed.mean});
  }
  return marks;
}

// Best error after every iteration, mean over the solves; a solve that ended earlier keeps its last.
std::vector<double> mean_trace(const StudyResults& study, const std::string& solver) {
  std::vector<const std::vector<double>*> traces;
  std::size_t iterations = 0;
  for (const Solve& solve : solves_of(study, solver)) {
    if (trace_cm(solve).empty()) continue;
    traces.push_back(&trace_cm(solve));
    iterations = std::max(iterations, trace_cm(solve).size());
  }
  std::vector<double> result(iterations), at_iteration(traces.size());
  for (std::size_t i = 0; i < iterations; ++i) {
    for (std::size_t t = 0; t < traces.size(); ++t) {
      at_iteration[t] = (*traces[t])[std::min(i, traces[t]->size() - 1)];
    }
    result[i] = mean(at_iteration);
  }
  return result;
}

Figure iterations_figure(const StudyResults& study) {
  const double rounding_cm = claims::farthest_target_cm(study) * std::numeric_limits<double>::epsilon();
  Figure figure{
      .name = "figure-18",
      .caption = fmt::format(
          "Best position error [cm] after every iteration, mean over all solves; solves that stop early keep their "
          "last error. Dashed: {} cm, the rounding level (2^-52 of the farthest target's distance from the base).",
          rounded_number(rounding_cm, 2))};
  std::vector<double> all;
  if (rounding_cm > 0) all.push_back(rounding_cm);
  std::vector<std::string> clauses, labels;
  std::size_t iterations = 1;
  for (std::size_t i = 0; i < study.solvers.size(); ++i) {
    const std::vector<double> curve = mean_trace(study, study.solvers[i]);
    if (curve.empty()) continue;
    figure.data += fmt::format("{}# {}\n# iteration, mean of the best position error [cm]\n",
                               figure.data.empty() ? "" : "\n\n", one_line(study.solvers[i]));
    for (std::size_t k = 0; k < curve.size(); ++k) figure.data += fmt::format("{} {}\n", k + 1, data_number(curve[k]));
    all.insert(all.end(), curve.begin(), curve.end());
    iterations = std::max(iterations, curve.size());
    labels.push_back(shortened(study.solvers[i], longest_label));
    clauses.push_back(fmt::format("'{}.dat' index {} using 1:(shown($2)) with lines ls {} lw 1.3 title {}", figure.name,
                                  clauses.size(), i + 1, gnuplot_string(labels.back())));
  }
  const Axis axis = value_axis(all, {"average position error", "cm"}, Scale::logarithmic);
  figure.caption = with_notes(figure.caption, study, Metric::position_error_cm, axis);
  figure.settings =
      axis.settings + fmt::format("set xlabel 'iteration'\nset xrange [0:{}]\n", std::max<std::size_t>(iterations, 2));
  if (rounding_cm > 0) {
    labels.emplace_back("rounding level");
    clauses.push_back(
        fmt::format("{} with lines lw 0.9 dt 2 lc rgb '#777777' title 'rounding level'", text_of(rounding_cm)));
  }
  add_legend(figure, labels);
  figure.plot = plot_command(clauses);
  return figure;
}

}  // namespace

std::vector<Figure> circle_figures(const StudyResults& study) {
  if (study.solves.empty() || !is_circle(study)) return {};
  std::vector<Figure> figures{path_figure(study, "figure-14", View::from_above),
                              path_figure(study, "figure-15", View::with_three_arms)};
  std::optional<Figure> joints = printed_joints_figure(study, "figure-16");
  if (!joints) joints = joints_figure(study, "figure-16");
  if (joints) figures.push_back(std::move(*joints));
  std::map<int, std::vector<double>> printed;
  for (const PrintedPosture& posture : printed_table_8(study.facts.published)) {
    printed[posture.point] = {posture.error_cm};
  }
  figures.push_back(curves_figure(study, Metric::position_error_cm, "figure-17", printed));
  const auto is_traced = [](const Solve& solve) { return !trace_cm(solve).empty(); };
  if (std::ranges::any_of(study.solves, is_traced)) figures.push_back(iterations_figure(study));
  return figures;
}

std::vector<Figure> paper_figures(const StudyResults& study) {
  if (study.solves.empty()) return {};
  std::vector<Figure> figures{overview_figure(study, printed_means(study)), path_figure(study, "figure-5")};
  for (const Metric metric : paper_metrics) {
    figures.push_back(curves_figure(study, metric, fmt::format("figure-{}", paper_numbers(metric).curves_figure)));
    if (metric == Metric::seconds) figures.back().caption += printed_ratios(study);
  }
  if (std::optional<Figure> joints = joints_figure(study, "figure-9")) figures.push_back(std::move(*joints));
  for (const Metric metric : paper_metrics) {
    figures.push_back(printed_box_figure(study, metric));
  }
  for (Figure& figure : circle_figures(study)) figures.push_back(std::move(figure));
  return figures;
}

}  // namespace ikbench::slim2023
