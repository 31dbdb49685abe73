#include "analysis/slim2023/circle_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>

#include "analysis/claims/rules_of_solves.hpp"
#include "analysis/figures/figure_parts.hpp"
#include "analysis/figures/study_figures.hpp"
#include "analysis/inference/convergence.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/slim2023/circle.hpp"
#include "analysis/slim2023/published_numbers.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "numerics/number.hpp"

namespace ikbench::slim2023 {

using namespace numerics;
using namespace statistics;
using namespace inference;
using namespace figures;

namespace {

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

Figure convergence_figure(const StudyResults& study) {
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
  std::vector<Figure> figures{path_figure(study, "figure-14", View::from_above), path_figure(study, "figure-15")};
  if (std::optional<Figure> joints = joints_figure(study, "figure-16")) figures.push_back(std::move(*joints));
  std::map<int, std::vector<double>> printed;
  for (const PrintedPosture& posture : printed_table_8(study.facts.published)) {
    printed[posture.point] = {posture.error_cm};
  }
  figures.push_back(curves_figure(study, Metric::position_error_cm, "figure-17", printed));
  const auto is_traced = [](const Solve& solve) { return !trace_cm(solve).empty(); };
  if (std::ranges::any_of(study.solves, is_traced)) figures.push_back(convergence_figure(study));
  return figures;
}

}  // namespace ikbench::slim2023
