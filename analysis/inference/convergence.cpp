#include "analysis/inference/convergence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/inference/study_facts.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/statistics/quantile.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

constexpr double largest_target_cm = 10;
constexpr double smallest_target_cm = 1e-8;
constexpr std::size_t target_count = 51;     // as COCO has
constexpr std::size_t most_positions = 200;  // more cannot be told apart in a figure

double or_censored(double value) { return std::isfinite(value) ? value : censored; }

bool is_verified(const Solve& solve) {
  return !stays(solve.status) && solve.status != Status::claimed_but_wrong && solve.status != Status::not_finite;
}

// The best error when so many evaluations were made.
double error_at(const StudyResults& study, const Solve& solve, std::span<const Step> course, double evaluations) {
  const double total = total_cost(study, solve, Metric::evaluations);
  if (!is_verified(solve)) return censored;
  if (course.empty()) return evaluations < total ? censored : final_error_cm(solve);
  constexpr double fuzz = 1 + 1e-9;  // i n / n is not always i
  const double made = evaluations < total ? evaluations * fuzz : censored;
  const auto next = std::ranges::upper_bound(course, made, {}, &Step::evaluations);
  return next == course.begin() ? censored : or_censored((next - 1)->error_cm);
}

double ratio_of(double cost, double smallest) {
  return cost == censored ? censored : cost == smallest ? 1 : cost / smallest;
}

// `count` numbers from `first` to `last`, both exact and positive; a single number if they are equal.
std::vector<double> log_spaced(double first, double last, std::size_t count) {
  std::vector<double> numbers{first};
  if (first == last) return numbers;
  const double steps = static_cast<double>(count - 1);
  for (std::size_t i = 1; i + 1 < count; ++i) {
    const double part = static_cast<double>(i) / steps;
    numbers.push_back(std::pow(10, (1 - part) * std::log10(first) + part * std::log10(last)));
  }
  numbers.push_back(last);
  return numbers;
}

// Stairs, ascending and not negative in `at`, at no more than most_positions.
std::vector<Share> thinned(const std::vector<Share>& stairs) {
  if (stairs.size() <= most_positions) return stairs;
  std::vector<Share> kept;
  const auto positive = std::ranges::upper_bound(stairs, 0.0, {}, &Share::at);
  if (positive != stairs.begin()) kept.push_back(*(positive - 1));
  for (const double at : log_spaced(positive->at, stairs.back().at, most_positions - kept.size())) {
    kept.push_back({.at = at, .share = (std::ranges::upper_bound(stairs, at, {}, &Share::at) - 1)->share});
  }
  return kept;
}

}  // namespace

double total_cost(const StudyResults& study, const Solve& solve, Metric cost) {
  const double total = cost == Metric::seconds ? seconds_of(study, solve) : static_cast<double>(solve.evaluations);
  return std::max(0.0, or_censored(total));
}

std::vector<Solves> solves_by_solver(const StudyResults& study) {
  std::vector<Solves> result;
  for (const std::string& solver : study.solvers) {
    const std::span<const Solve> own = solves_of(study, solver);
    Solves& solves = result.emplace_back();
    solves.reserve(own.size());
    for (const Solve& solve : own) solves.push_back(&solve);
  }
  return result;
}

bool is_chained(const StudyResults& study) { return study.points > 1 && !study.facts.starts_anew(); }

const std::vector<double>& trace_cm(const Solve& solve) {
  static const std::vector<double> none;
  return solve.rare == nullptr ? none : solve.rare->trace_cm;
}

bool has_improvements(const Solve& solve) { return solve.rare != nullptr && !solve.rare->improved_at.empty(); }

std::vector<Step> iterations_of(const StudyResults& study, const Solve& solve) {
  const std::vector<double>& trace = trace_cm(solve);
  const double total = total_cost(study, solve, Metric::evaluations), all = static_cast<double>(trace.size());
  std::vector<Step> steps;
  for (const double error : trace) steps.push_back({total * (static_cast<double>(steps.size() + 1) / all), error});
  return steps;
}

std::vector<Step> course_of(const StudyResults& study, const Solve& solve) {
  if (!has_improvements(solve)) return iterations_of(study, solve);
  std::vector<Step> steps;
  for (std::size_t i = 0; i < solve.rare->improved_at.size(); ++i) {
    steps.push_back({solve.rare->improved_at[i], solve.rare->improved_to_cm[i]});
  }
  return steps;
}

bool has_trace(const Solve& solve) { return !trace_cm(solve).empty() || solve.iterations == 0; }

std::vector<Solves> traced_by_solver(const StudyResults& study) {
  std::vector<Solves> result = solves_by_solver(study);
  for (Solves& solves : result) {
    std::erase_if(solves, [&](const Solve* solve) {
      const bool is_known = study.facts.pose ? !trace_cm(*solve).empty() : has_trace(*solve);
      return !is_known && !has_improvements(*solve);
    });
  }
  return result;
}

double final_error_cm(const Solve& solve) { return or_censored(solve.position_error_cm); }

double tolerance_deg(const StudyResults& study) {
  const double angle = study.facts.stop.tolerance_deg;
  return angle > 0 ? angle : std::numeric_limits<double>::infinity();
}

std::vector<double> costs_to_targets(const StudyResults& study, const Solve& solve, std::span<const double> targets_cm,
                                     Metric cost, std::span<const Step> course) {
  std::vector<double> costs(targets_cm.size(), censored);
  if (!is_verified(solve)) return costs;
  const double whole = total_cost(study, solve, cost), evaluations = total_cost(study, solve, Metric::evaluations);
  std::size_t next = 0;
  const auto passes = [&](double error_cm, double at) {
    for (; next < targets_cm.size() && error_cm <= targets_cm[next]; ++next) costs[next] = at;
  };
  if (course.empty()) passes(final_error_cm(solve), whole);
  for (const Step& step : course) {
    const bool is_counted = cost == Metric::evaluations;
    passes(step.error_cm, is_counted        ? step.evaluations
                          : evaluations > 0 ? whole * step.evaluations / evaluations
                                            : whole);
  }
  return costs;
}

std::vector<Estimate> error_bands(const StudyResults& study, const Solves& traces,
                                  std::span<const double> evaluations) {
  std::vector<std::vector<Step>> courses;
  for (const Solve* solve : traces) courses.push_back(course_of(study, *solve));
  std::vector<Estimate> bands;
  std::vector<double> errors;
  for (const double position : evaluations) {
    errors.clear();
    for (std::size_t i = 0; i < traces.size(); ++i) errors.push_back(error_at(study, *traces[i], courses[i], position));
    const std::vector<double> ranked = ranked_values(errors);
    const auto at = [&](double p) { return or_censored(quantile(ranked, p, QuantileType::type_5)); };
    bands.push_back({.value = at(0.5), .low = at(0.25), .high = at(0.75)});
  }
  return bands;
}

std::vector<double> evaluations_axis(const StudyResults& study, const std::vector<Solves>& traces) {
  double first = censored, last = 0;
  for (const Solves& solves : traces) {
    for (const Solve* solve : solves) {
      const double total = total_cost(study, *solve, Metric::evaluations);
      if (!(total > 0)) continue;
      const std::vector<Step> course = course_of(study, *solve);
      first = std::min(first, course.empty() ? total : course.front().evaluations);
      last = std::max(last, total);
    }
  }
  return last > 0 ? log_spaced(first, last, most_positions) : std::vector<double>();
}

std::vector<double> target_errors_cm(const StudyResults& study) {
  double smallest = tolerance_cm(study);
  if (!std::isfinite(smallest)) {
    double best = largest_target_cm / 10;
    for (const Solve& solve : study.solves) best = std::min(best, final_error_cm(solve));
    smallest = std::max(smallest_target_cm, std::pow(10, std::floor(std::log10(std::max(best, smallest_target_cm)))));
  }
  return log_spaced(std::max(largest_target_cm, 10 * smallest), smallest, target_count);
}

std::vector<Share> shares_within(std::vector<double> values) {
  std::ranges::sort(values);
  const double all = static_cast<double>(values.size());
  values.erase(std::ranges::lower_bound(values, censored), values.end());
  std::vector<Share> shares;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i + 1 < values.size() && values[i + 1] == values[i]) continue;
    shares.push_back({.at = values[i], .share = static_cast<double>(i + 1) / all});
  }
  return thinned(shares);
}

Profile performance_profile(const StudyResults& study, const CostOf& cost_of) {
  std::vector<std::span<const Solve>> rest;  // of each solver, those of places to come
  std::size_t solvers = 0;
  for (const std::string& solver : study.solvers) {
    rest.push_back(solves_of(study, solver));
    if (!rest.back().empty()) ++solvers;
  }
  Profile profile{.ratios = std::vector<std::vector<double>>(study.solvers.size())};
  std::vector<std::pair<std::size_t, const Solve*>> of_solver;
  for (const Solve* const place : places_of(study)) {
    of_solver.clear();
    for (std::size_t i = 0; i < rest.size(); ++i) {
      if (rest[i].empty() || rest[i].front().run != place->run || rest[i].front().point != place->point) continue;
      of_solver.emplace_back(i, &rest[i].front());
      rest[i] = rest[i].subspan(1);
    }
    if (of_solver.empty()) continue;
    const Solve& first = *of_solver.front().second;
    const bool is_shared = std::ranges::all_of(of_solver, [&](const auto& entry) {
      return same_target(problem_of(study, *entry.second), problem_of(study, first));
    });
    if (of_solver.size() < solvers || !is_shared) {
      ++profile.left_out;
      continue;
    }
    ++profile.problems;
    profile.solves.push_back(&first);
    double smallest = censored;
    for (const auto& [i, solve] : of_solver) smallest = std::min(smallest, std::max(0.0, or_censored(cost_of(*solve))));
    if (smallest == censored) ++profile.unsolved;
    if (smallest == 0) profile.has_zero_costs = true;
    for (const auto& [i, solve] : of_solver) {
      profile.ratios[i].push_back(ratio_of(std::max(0.0, or_censored(cost_of(*solve))), smallest));
    }
  }
  return profile;
}

std::string closest_point_by_point(const StudyResults& study) {
  if (std::isfinite(tolerance_cm(study))) return "";
  const Profile profile = performance_profile(study, final_error_cm);
  std::vector<std::pair<double, std::string>> wins;  // alone: a tie counts for nobody
  std::vector<int> closest(static_cast<std::size_t>(profile.problems));
  for (const std::vector<double>& ratios : profile.ratios) {
    for (std::size_t problem = 0; problem < ratios.size(); ++problem) closest[problem] += ratios[problem] <= 1 ? 1 : 0;
  }
  for (std::size_t i = 0; i < study.solvers.size(); ++i) {
    const std::vector<double>& ratios = profile.ratios[i];
    if (ratios.empty()) continue;
    auto& [won, solver] = wins.emplace_back(0, one_line(study.solvers[i]));
    for (std::size_t problem = 0; problem < ratios.size(); ++problem) {
      won += ratios[problem] <= 1 && closest[problem] == 1 ? 1 : 0;
    }
  }
  if (wins.size() < 2 || profile.problems == 0) return "";
  std::ranges::stable_sort(wins, std::greater{}, &std::pair<double, std::string>::first);
  std::vector<std::string> list;
  for (const auto& [won, solver] : wins)
    list.push_back(fmt::format("{} in {}", solver, percent(won / profile.problems)));
  const auto tied = std::ranges::count_if(closest, [](int solvers) { return solvers > 1; });
  return fmt::format(
      "Point by point, over {} solves each, the closest to the target is {}{}. (The worst points of a run decide its "
      "mean.)",
      profile.problems, fmt::join(list, ", "),
      tied > 0 ? fmt::format("; {} are ties", percent(static_cast<double>(tied) / profile.problems)) : "");
}

}  // namespace ikbench::inference
