#include "analysis/figures/convergence_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "analysis/figures/figure_parts.hpp"
#include "analysis/inference/clusters.hpp"
#include "analysis/inference/comparable.hpp"
#include "analysis/inference/convergence.hpp"
#include "analysis/inference/estimand.hpp"
#include "analysis/inference/study_facts.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/inference/times.hpp"
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

// Explains the bands of share curves.
std::string bands(const StudyResults& study, const Clusters& clusters) {
  if (!clusters.undefined().empty()) return fmt::format(" There are no intervals: {}.", clusters.undefined());
  return fmt::format(" {} {} intervals at each position, from {} bootstrap samples of the {} with all their solves{}.",
                     study.solvers.size() <= most_bands ? "Bands:" : "The data file has", percent(clusters.level()),
                     clusters.replicates().size(), clusters.noun(),
                     study.solvers.size() <= most_bands ? "" : "; a band for each curve would hide others");
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

std::optional<Figure> convergence_figure(const StudyResults& study, const Clusters&, Metric) {
  const std::vector<Solves> traces = traced_by_solver(study);
  const std::vector<double> positions = evaluations_axis(study, traces);
  if (positions.empty()) return std::nullopt;
  const std::string error = study.facts.pose ? "error of the pose" : "position error";
  const bool has_bands = study.solvers.size() <= most_bands;
  std::vector<Curve> curves;
  std::vector<double> all;
  for (const Solves& solves : traces) {
    const std::vector<Estimate> errors = error_bands(study, solves, positions);
    double last = 0;
    for (const Solve* solve : solves) last = std::max(last, total_cost(study, *solve, Metric::evaluations));
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
  if (std::ranges::any_of(shares, [](const Share& share) { return std::isfinite(share.low); })) curve.band = 0;
  Estimate before{0, 0, 0};
  curve.add(std::min(axis.low, shares.front().at), before);
  for (const Share& share : shares) {
    curve.add(share.at, before);
    const bool is_step = share.share != before.value;
    before = {share.share, share.low, share.high};
    if (is_step) curve.add(share.at, before);
  }
  curve.add(axis.high, before);
  return curve;
}

// Adds a curve of shares for each solver; empty if there is nothing to show.
void draw_shares(Figure& figure, const StudyResults& study, const std::vector<std::vector<Share>>& shares,
                 const NameWithUnit& label, const std::string& share_of) {
  double smallest = censored, largest = 0;
  for (const auto& curve : shares) {
    for (const Share& share : curve) {
      if (share.at > 0) smallest = std::min(smallest, share.at);
      largest = std::max(largest, share.at);
    }
  }
  const Axis axis = ratio_axis(smallest, largest, label);
  std::vector<Curve> curves;
  for (const auto& curve : shares) curves.push_back(stairs(curve, axis));
  figure.settings =
      axis.settings + fmt::format("set ylabel '{}'\nset yrange [-0.02:1.02]\nset ytics 0.2\nshown(y) = y\n", share_of);
  figure.data = fmt::format("# {}; {}, and its interval: corners of the stairs\n", text_of(label), share_of);
  add_legend(figure, add_curves(figure, study, curves));
}

// The shares of each solver's values that are at most so large, with the intervals that the clusters give.
template <class ValuesOf>
std::vector<std::vector<Share>> shares_of(const std::vector<Solves>& by_solver, const Clusters& clusters,
                                          ValuesOf&& values_of) {
  std::vector<std::vector<Share>> curves;
  for (const Solves& solves : by_solver)
    curves.push_back(banded_shares(clustered(solves, clusters, values_of), clusters));
  return curves;
}

Figure runtime_figure(const StudyResults& study, const Clusters& clusters, Metric cost) {
  const std::vector<double> targets = target_errors_cm(study);
  const auto costs_of = [&](const Solve& solve) {
    return costs_to_targets(study, solve, targets, cost, course_of(study, solve));
  };
  const bool has_tolerance = std::isfinite(tolerance_cm(study));
  Figure figure{.name = fmt::format("statistics-ecdf-{}", name_of(cost))};
  figure.caption = fmt::format(
      "Share of pairs of a solve and a target error that were reached within this {} (after COCO). The targets are {} "
      "errors, evenly spaced on a logarithmic scale from {} cm to {} cm, {}.{} Beyond its longest "
      "solve, a curve stays level.{}{}",
      cost == Metric::seconds ? "time" : "number of evaluations", targets.size(), rounded_number(targets.front(), 3),
      rounded_number(targets.back(), 3),
      has_tolerance ? "the tolerance of the study"
                    : "the decade below the smallest error of any solve, at least 1e-8 cm",
      steps(study), bands(study, clusters), without_trace(study));
  if (cost == Metric::seconds) figure.caption += " " + speed_note(study);
  draw_shares(figure, study, shares_of(traced_by_solver(study), clusters, costs_of), with_unit(cost),
              "share of solves and targets");
  return figure;
}

Figure error_figure(const StudyResults& study, const Clusters& clusters) {
  const auto error_of = [](const Solve& solve) { return std::vector{std::max(0.0, final_error_cm(solve))}; };
  const auto shares = shares_of(solves_by_solver(study), clusters, error_of);
  Figure figure{.name = "statistics-ecdf-error",
                .caption =
                    "Share of solves with at most this position error. An answer that is not finite counts as a solve "
                    "without an error." +
                    bands(study, clusters)};
  const auto has_zero = [](const auto& curve) { return !curve.empty() && curve.front().at == 0; };
  if (std::ranges::any_of(shares, has_zero)) figure.caption += " Errors of zero are drawn at the left edge.";
  draw_shares(figure, study, shares, with_unit(Metric::position_error_cm), "share of solves");
  return figure;
}

// Explains a problem, for the caption.
std::string problem(const StudyResults& study) {
  std::string words = " A problem is one target in one run";
  if (study.facts.starts_anew() || study.points == 1) words += ", from the same start for all solvers.";
  if (study.facts.start == "previous" && study.points > 1) {
    words += "; after the first, each solver starts where its previous answer left the arm.";
  }
  if (study.facts.start.empty() && study.points > 1) words += ".";
  if (!study.facts.path.empty() && !study.facts.draws_targets && study.runs > 1)
    words += " The runs repeat the same targets.";
  return words;
}

// The profile of the tolerance's cost, or else of the error.
std::optional<Figure> profile_figure(const StudyResults& study, const Clusters& clusters, std::optional<Metric> cost) {
  const Profile profile = performance_profile(study, [&](const Solve& solve) {
    if (!cost) return std::max(final_error_cm(solve), info_of(Metric::position_error_cm).rounding);
    return is_ok(solve) ? total_cost(study, solve, *cost) : censored;
  });
  const auto compared = std::ranges::count_if(profile.ratios, [](const auto& ratios) { return !ratios.empty(); });
  if (compared < 2) return std::nullopt;

  const bool in_seconds = cost == Metric::seconds;
  const std::string_view name = !cost ? "error" : in_seconds ? "seconds" : "evaluations";
  const std::string_view words = !cost ? "position error" : in_seconds ? "time" : "number of evaluations";
  std::vector<std::vector<Share>> shares;
  const std::vector<std::size_t> clusters_of_problems = clusters.of(profile.solves);
  for (const auto& ratios : profile.ratios) {
    shares.push_back(banded_shares({.values = ratios, .clusters = clusters_of_problems}, clusters));
  }
  Figure figure{.name = fmt::format("statistics-profile-{}", name)};
  figure.caption = fmt::format(
      "Performance profiles (Dolan and Moré, 2002): share of {} problems in which a solver's {}{} is at most this many "
      "times the smallest of all solvers.{}",
      profile.problems, words, cost ? " on an answer " + within_words(study, Metric::position_error_cm) : "",
      problem(study));
  if (!cost) {
    figure.caption += fmt::format(" An error up to {} cm is rounding and counts as that.",
                                  info_of(Metric::position_error_cm).rounding);
  }
  figure.caption += bands(study, clusters);
  if (profile.unsolved > 0) figure.caption += fmt::format(" No solver solves {} of them.", profile.unsolved);
  if (profile.has_zero_costs) {
    figure.caption +=
        fmt::format(" If the smallest {} is zero, any other value is infinitely many times as large.", words);
  }
  if (profile.left_out > 0) {
    figure.caption += fmt::format(" {} problems that not every solver was given are left out.", profile.left_out);
  }
  draw_shares(figure, study, shares, {fmt::format("{} / smallest of all solvers", cost ? name : words), ""},
              "share of problems");
  return figure;
}

// Success against time or budget.
Figure solved_figure(const StudyResults& study, const Clusters& clusters, Metric cost) {
  const std::vector<Solves> by_solver = solves_by_solver(study);
  const std::vector<double> tolerance{tolerance_cm(study)};
  const auto is_within_earlier = [&](const Solve& solve) { return has_improvements(solve) && !study.facts.pose; };
  const auto cost_of = [&](const Solve& solve) {
    const double whole = is_ok(solve) ? total_cost(study, solve, cost) : censored;
    if (!is_ok(solve) || !is_within_earlier(solve)) return std::vector{whole};
    return std::vector{
        std::min(whole, costs_to_targets(study, solve, tolerance, cost, course_of(study, solve)).front())};
  };
  auto shares = shares_of(by_solver, clusters, cost_of);
  for (std::size_t i = 0; i < by_solver.size(); ++i) {
    if (!by_solver[i].empty() && shares[i].empty()) shares[i].push_back({.at = 0, .share = 0});
  }
  Figure figure{.name = fmt::format("statistics-solved-{}", name_of(cost))};
  figure.caption =
      fmt::format("Share of solves that are ok after this {}: {}. The other solves count as never solved.{}",
                  cost == Metric::seconds ? "time" : "number of evaluations",
                  within_words(study, Metric::position_error_cm), bands(study, clusters));
  if (std::ranges::any_of(study.solves, is_within_earlier))
    figure.caption += " A solve counts from the evaluation at which its best error came within the tolerance.";
  if (cost == Metric::seconds) figure.caption += " " + speed_note(study);
  draw_shares(figure, study, shares, with_unit(cost), "share of solves that are ok");
  return figure;
}

}  // namespace

std::vector<Figure> convergence_figures(const StudyResults& measured) {
  if (measured.solves.empty()) return {};
  const StudyResults study = drawn_part(at_median_speed(measured));
  const Clusters clusters(study);
  std::vector<Figure> figures;
  const auto add = [&](std::optional<Figure> figure) {
    if (figure) figures.push_back(std::move(*figure));
  };
  const auto add_of = [&](Metric cost, auto draw) {
    const StudyResults compared = compared_in(study, cost);
    if (compared.solves.empty()) return;
    std::optional<Figure> figure = draw(compared, Clusters(compared, &clusters), cost);
    const std::string note = words_of(left_out(study, cost));
    if (figure && !note.empty()) figure->caption += " " + note;
    add(std::move(figure));
  };
  const auto add_of_both = [&](auto draw) {
    add_of(Metric::evaluations, draw);
    if (times_are_comparable(study)) add_of(Metric::seconds, draw);
  };
  const auto has_course = [](const Solve& solve) { return has_improvements(solve) || !trace_cm(solve).empty(); };
  if (std::ranges::any_of(study.solves, has_course)) {
    add_of(Metric::evaluations, convergence_figure);
    if (!study.facts.pose) add_of_both(runtime_figure);  // traces of poses have another error than the tolerance
  }
  add(error_figure(study, clusters));
  if (!std::isfinite(tolerance_cm(study))) {
    add(profile_figure(study, clusters, std::nullopt));
    return figures;
  }
  add_of_both(solved_figure);
  add_of_both(profile_figure);
  return figures;
}

}  // namespace ikbench::figures
