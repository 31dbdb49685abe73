#include "analysis/slim2023/paper_figures.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "analysis/figures/box_figure.hpp"
#include "analysis/figures/overview_figure.hpp"
#include "analysis/figures/study_figures.hpp"
#include "analysis/inference/comparable.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/slim2023/circle_figures.hpp"
#include "analysis/slim2023/paper_tables.hpp"
#include "analysis/slim2023/published_numbers.hpp"

namespace ikbench::slim2023 {

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
    marks.push_back({row.algorithm, scale * least, scale * row.printed.median, scale * row.printed.max});
    if (row.printed.min > 0) continue;
    below += fmt::format(" The printed minimum of {} is 0, so below {}.", row.algorithm, rounded_number(least, 3));
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

}  // namespace

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
