#include "analysis/slim2023/paper_figures.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "analysis/figures/axis.hpp"
#include "analysis/figures/box_figure.hpp"
#include "analysis/figures/figure_parts.hpp"
#include "analysis/figures/overview_figure.hpp"
#include "analysis/figures/study_figures.hpp"
#include "analysis/inference/convergence.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/slim2023/paper_tables.hpp"
#include "analysis/statistics/descriptive.hpp"

namespace ikbench::slim2023 {

using namespace claims;
using namespace results;
using namespace statistics;
using namespace inference;
using namespace figures;

namespace {

// figure-6, 7, 8. The printed times are of another machine: their ratios can be compared.
Figure curves_beside_printed(const StudyResults& study, const PaperMetric& paper) {
  Figure figure = curves_figure(study, paper.metric, fmt::format("figure-{}", paper.curves_figure), {}, Curves::means);
  const std::optional<PrintedRow> reference = printed_row(study, own_solver, Metric::seconds);
  if (paper.metric != Metric::seconds || !reference) return figure;
  std::vector<std::string> ratios;
  for (const PrintedRow& row : printed_table_3(study, Metric::seconds)) {
    if (row.algorithm == own_solver) continue;
    ratios.push_back(
        fmt::format("{} {}", row.algorithm, rounded_number(row.printed.mean / reference->printed.mean, 3)));
  }
  figure.caption += fmt::format(" Printed mean times, in multiples of {}'s: {}.", own_solver, fmt::join(ratios, ", "));
  return figure;
}

// figure-10, 11, 12, with the printed numbers beside the boxes, but for times. A printed minimum of 0 is below half a
// unit of its digits.
Figure boxes_beside_printed(const StudyResults& study, const PaperMetric& paper) {
  std::vector<Mark> marks;
  std::string below;
  for (const PrintedRow& row : printed_table_3(study, paper.metric)) {
    const bool is_drawn = study.plan.unit == Unit::run && paper.metric != Metric::seconds;
    if (!is_drawn || std::ranges::count(study.solvers, row.algorithm) == 0) continue;
    const bool is_open = !(row.printed.min > 0);
    const double least = is_open ? half_unit(row.digits.back()) : row.printed.min;
    marks.push_back({row.algorithm, least, row.printed.median, row.printed.max, is_open});
    if (!is_open) continue;
    below +=
        fmt::format(" Arrow: the printed minimum of {} is 0, so below {}.", row.algorithm, rounded_number(least, 3));
  }
  Figure figure = box_figure(study, paper.metric, fmt::format("figure-{}", paper.box_figure), marks);
  if (!marks.empty()) figure.caption += fmt::format(" Grey: printed minimum, median and maximum.{}", below);
  return figure;
}

Figure overview_beside_printed(const StudyResults& study) {
  std::vector<OverviewMark> marks;
  for (const PrintedRow& row : printed_table_3(study, Metric::position_error_cm)) {
    const auto mean_of = [&](Metric metric) { return printed_row(study, row.algorithm, metric).value().printed.mean; };
    marks.push_back({row.algorithm, row.printed.mean, mean_of(Metric::variation_deg), mean_of(Metric::seconds)});
  }
  return overview_figure(study, marks);
}

// Best error after every iteration, mean over the solves; a solve that ended earlier keeps its last.
std::vector<double> mean_trace(const Solves& traced) {
  std::vector<double> means;
  for (std::size_t i = 0;; ++i) {
    std::vector<double> at_iteration;
    bool is_over = true;
    for (const Solve* solve : traced) {
      const std::vector<double>& trace = trace_cm(*solve);
      if (trace.empty()) continue;
      at_iteration.push_back(trace[std::min(i, trace.size() - 1)]);
      is_over = is_over && i >= trace.size();
    }
    if (is_over) return means;
    means.push_back(mean(at_iteration));
  }
}

// Returns nothing without a trace.
std::optional<Figure> iterations_figure(const StudyResults& all_solvers) {
  const StudyResults study = drawn_part(all_solvers);
  Figure figure{.name = "figure-18",
                .caption =
                    "Best position error [cm] after every iteration, mean over all solves; solves that stop early "
                    "keep their last error."};
  std::vector<double> all;
  std::vector<std::string> clauses, labels;
  std::size_t iterations = 2;
  const std::vector<Solves> traced = traced_by_solver(study);
  for (std::size_t i = 0; i < traced.size(); ++i) {
    const std::vector<double> curve = mean_trace(traced[i]);
    if (curve.empty()) continue;
    figure.data += fmt::format("{}# {}\n# iteration, mean of the best position error [cm]\n",
                               figure.data.empty() ? "" : "\n\n", one_line(study.solvers[i]));
    for (std::size_t k = 0; k < curve.size(); ++k) figure.data += fmt::format("{} {}\n", k + 1, data_number(curve[k]));
    all.insert(all.end(), curve.begin(), curve.end());
    iterations = std::max(iterations, curve.size());
    labels.push_back(shortened(study.solvers[i], longest_label));
    clauses.push_back(fmt::format("'{}.dat' index {} using 1:(shown($2)) with lines ls {} lw 1.3 title {}", figure.name,
                                  clauses.size(), style_of(study, study.solvers[i]), gnuplot_string(labels.back())));
  }
  if (clauses.empty()) return std::nullopt;
  const Axis axis = value_axis(all, {"average position error", "cm"}, Scale::logarithmic);
  figure.caption = with_notes(figure.caption, study, Metric::position_error_cm, axis);
  figure.settings = axis.settings + fmt::format("set xlabel 'iteration'\nset xrange [0:{}]\n", iterations);
  add_legend(figure, labels);
  figure.plot = plot_command(clauses);
  return figure;
}

void add(std::optional<Figure> figure, std::vector<Figure>& figures) {
  if (figure) figures.push_back(std::move(*figure));
}

}  // namespace

std::vector<Figure> circle_figures(const StudyResults& study) {
  if (study.solves.empty() || study.facts.path != "circle") return {};
  std::vector<Figure> figures{path_figure(study, "figure-14", View::from_above),
                              path_figure(study, "figure-15", View::with_three_arms)};
  // The Dobot's joint 4 turns the tool about the vertical; the paper draws it with the angle of joint 1.
  const bool is_dobot = study.solve_data->robot == "dobot_magician";
  add(joints_figure(study, "figure-16", is_dobot ? std::optional<std::size_t>(1) : std::nullopt), figures);
  std::map<int, std::vector<double>> printed;
  const CsvTable table = printed_table(study.facts.published, "table-8");
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    printed[static_cast<int>(table.number(row, "point"))] = {table.number(row, "error_cm")};
  }
  figures.push_back(curves_figure(study, Metric::position_error_cm, "figure-17", printed));
  add(iterations_figure(study), figures);
  return figures;
}

std::vector<Figure> paper_figures(const StudyResults& study) {
  if (study.solves.empty()) return {};
  std::vector<Figure> figures{overview_beside_printed(study), path_figure(study, "figure-5")};
  for (const PaperMetric& metric : paper_metrics) figures.push_back(curves_beside_printed(study, metric));
  add(joints_figure(study, "figure-9"), figures);
  for (const PaperMetric& metric : paper_metrics) figures.push_back(boxes_beside_printed(study, metric));
  std::ranges::move(circle_figures(study), std::back_inserter(figures));
  return figures;
}

}  // namespace ikbench::slim2023
