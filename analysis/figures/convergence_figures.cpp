#include "analysis/figures/convergence_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "analysis/figures/figure_parts.hpp"
#include "analysis/inference/comparable.hpp"
#include "analysis/inference/convergence.hpp"
#include "analysis/inference/estimand.hpp"
#include "analysis/inference/study_facts.hpp"
#include "analysis/inference/text.hpp"
#include "numerics/number.hpp"

namespace ikbench::figures {

using namespace numerics;
using namespace results;
using namespace statistics;
using namespace inference;

namespace {

std::string dependence(const StudyResults& study) {
  return is_chained(study)
             ? " The solves of a run depend on each other, so the curves only describe them and have no intervals."
             : " The curves describe the solves; they have no intervals.";
}

std::string without_trace(const StudyResults& study) {
  const auto missing = std::ranges::count_if(
      study.solves, [](const Solve& solve) { return !has_trace(solve) && !has_improvements(solve); });
  return missing == 0 ? "" : fmt::format(" {} solves without a trace are left out.", missing);
}

// Explains where the steps of a curve are.
std::string steps(const StudyResults& study) {
  const auto is_exact = [](const Solve& solve) { return has_improvements(solve) || trace_cm(solve).empty(); };
  if (std::ranges::all_of(study.solves, is_exact)) return " The best error falls at the evaluation that improved it.";
  if (std::ranges::none_of(study.solves, has_improvements)) return " Iteration i of n counts as i/n of a solve's cost.";
  return " The best error falls at the evaluation that improved it; where that is not stored, iteration i of n counts as "
         "i/n of a solve's cost.";
}

std::optional<Figure> convergence_figure(const StudyResults& study) {
  const std::vector<Solves> traces = traced_by_solver(study);
  const std::vector<double> positions = evaluations_axis(traces);
  if (positions.empty()) return std::nullopt;
  const std::string error = study.facts.pose ? "error of the pose" : "position error";
  const bool has_bands = study.solvers.size() <= most_bands;
  std::vector<Curve> curves;
  std::vector<double> all;
  for (const Solves& solves : traces) {
    const std::vector<Estimate> errors = error_bands(solves, positions);
    double last = 0;
    for (const Solve* solve : solves) last = std::max(last, evaluations_of(*solve));
    Curve& curve = curves.emplace_back();
    for (std::size_t k = 0; k < positions.size() && (k == 0 || positions[k - 1] < last); ++k) {
      if (errors[k].value == censored) continue;
      curve.add(positions[k], errors[k]);
      if (errors[k].high == censored) curve.band = curve.count;
      all.push_back(errors[k].value);
      if (has_bands) all.insert(all.end(), {errors[k].low, errors[k].high});
    }
    if (curve.band > curve.count) curve.band = 0;
  }
  const Axis axis = value_axis(all, {error, "cm"}, Scale::logarithmic);
  Figure figure{.name = "statistics-convergence"};
  figure.caption = fmt::format(
      "Best {} [cm] against evaluations, over all solves: median{}.{}{} A solve that has stopped keeps its last error, and a curve ends with the longest solve. An "
      "answer that is not finite, refused or worse than claimed ranks last; if half of the solves have no error, there "
      "is no line.{}{}",
      error, has_bands ? ", and the quartiles as a band" : " (the quartiles are in the data file)",
      study.facts.pose ? " It is what the solvers reduce: the root mean square distance of three points of the tool."
                       : "",
      steps(study), dependence(study), without_trace(study));
  figure.caption = with_notes(figure.caption, study, Metric::position_error_cm, axis);
  figure.settings = ratio_axis(positions.front(), positions.back(), {"evaluations", ""}).settings + axis.settings;
  figure.data = fmt::format("# evaluations; 50, 25 and 75 % quantiles over the solves of the best {} [cm]\n", error);
  add_legend(figure, add_curves(figure, study, curves));
  return figure;
}

// A curve as the corners of its stairs.
Curve stairs(const std::vector<Share>& shares, const Axis& axis) {
  Curve curve;
  if (shares.empty()) return curve;
  Estimate before{.value = 0};
  curve.add(std::min(axis.low, shares.front().at), before);
  for (const Share& share : shares) {
    curve.add(share.at, before);
    const bool is_step = share.share != before.value;
    before.value = share.share;
    if (is_step) curve.add(share.at, before);
  }
  curve.add(axis.high, before);
  return curve;
}

// Adds a curve of shares for each solver; empty if there is nothing to show.
void draw_shares(Figure& figure, const StudyResults& study, const std::vector<std::vector<Share>>& shares) {
  double smallest = censored, largest = 0;
  for (const auto& curve : shares) {
    for (const Share& share : curve) {
      if (share.at > 0) smallest = std::min(smallest, share.at);
      largest = std::max(largest, share.at);
    }
  }
  constexpr std::string_view share_of = "share of solves that are ok";
  const Axis axis = ratio_axis(smallest, largest, {"evaluations", ""});
  std::vector<Curve> curves;
  for (const auto& curve : shares) curves.push_back(stairs(curve, axis));
  figure.settings =
      axis.settings + fmt::format("set ylabel '{}'\nset yrange [-0.02:1.02]\nset ytics 0.2\nshown(y) = y\n", share_of);
  figure.data = fmt::format("# evaluations; {}: corners of the stairs\n", share_of);
  add_legend(figure, add_curves(figure, study, curves));
}

// Success against budget.
Figure solved_figure(const StudyResults& study) {
  const auto is_within_earlier = [&](const Solve& solve) { return has_improvements(solve) && !study.facts.pose; };
  const auto cost_of = [&](const Solve& solve) {
    if (!is_ok(solve)) return censored;
    const double whole = evaluations_of(solve);
    if (!is_within_earlier(solve)) return whole;
    const std::vector<Step> course = course_of(solve);
    const auto within = [&](const Step& step) { return step.error_cm <= tolerance_cm(study); };
    const auto first = std::ranges::find_if(course, within);
    return first == course.end() ? whole : std::min(whole, first->evaluations);
  };
  std::vector<std::vector<Share>> shares;
  for (const Solves& solves : solves_by_solver(study)) {
    std::vector<double> costs;
    for (const Solve* solve : solves) costs.push_back(cost_of(*solve));
    std::vector<Share>& curve = shares.emplace_back(shares_within(std::move(costs)));
    if (!solves.empty() && curve.empty()) curve.push_back({.at = 0, .share = 0});
  }
  Figure figure{.name = "statistics-solved-evaluations"};
  figure.caption = fmt::format(
      "Share of solves that are ok after this number of evaluations: {}. The other solves count as never "
      "solved.",
      within_words(study, Metric::position_error_cm));
  if (std::ranges::any_of(study.solves, is_within_earlier))
    figure.caption += " A solve counts from the evaluation at which its best error came within the tolerance.";
  draw_shares(figure, study, shares);
  return figure;
}

}  // namespace

std::vector<Figure> convergence_figures(const StudyResults& measured) {
  const StudyResults study = compared_in(drawn_part(measured), Metric::evaluations);
  if (study.solves.empty()) return {};
  std::vector<Figure> figures;
  const auto has_course = [](const Solve& solve) { return has_improvements(solve) || !trace_cm(solve).empty(); };
  if (std::ranges::any_of(study.solves, has_course)) {
    if (std::optional<Figure> figure = convergence_figure(study)) figures.push_back(std::move(*figure));
  }
  if (std::isfinite(tolerance_cm(study))) figures.push_back(solved_figure(study));
  const std::string note = words_of(left_out(drawn_part(measured), Metric::evaluations));
  if (!note.empty()) {
    for (Figure& figure : figures) figure.caption += " " + note;
  }
  return figures;
}

}  // namespace ikbench::figures
