#include "analysis/inference/convergence.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/inference/study_facts.hpp"
#include "analysis/statistics/quantile.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

constexpr std::size_t most_positions = 200;  // more cannot be told apart in a figure

double or_censored(double value) { return std::isfinite(value) ? value : censored; }

bool is_verified(const Solve& solve) {
  return !stays(solve.status) && solve.status != Status::claimed_but_wrong && solve.status != Status::not_finite;
}

// The best error when so many evaluations were made.
double error_at(const Solve& solve, std::span<const Step> course, double evaluations) {
  const double total = evaluations_of(solve);
  if (!is_verified(solve)) return censored;
  if (course.empty()) return evaluations < total ? censored : or_censored(solve.position_error_cm);
  constexpr double fuzz = 1 + 1e-9;  // i n / n is not always i
  const double made = evaluations < total ? evaluations * fuzz : censored;
  const auto next = std::ranges::upper_bound(course, made, {}, &Step::evaluations);
  return next == course.begin() ? censored : or_censored((next - 1)->error_cm);
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

double evaluations_of(const Solve& solve) { return std::max(0.0, static_cast<double>(solve.evaluations)); }

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

std::vector<Step> course_of(const Solve& solve) {
  std::vector<Step> steps;
  if (!has_improvements(solve)) {
    const std::vector<double>& trace = trace_cm(solve);
    const double total = evaluations_of(solve), all = static_cast<double>(trace.size());
    for (const double error : trace) steps.push_back({total * (static_cast<double>(steps.size() + 1) / all), error});
    return steps;
  }
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

double tolerance_deg(const StudyResults& study) {
  const double angle = study.facts.stop.tolerance_deg;
  return angle > 0 ? angle : std::numeric_limits<double>::infinity();
}

std::vector<Estimate> error_bands(const Solves& traces, std::span<const double> evaluations) {
  std::vector<std::vector<Step>> courses;
  for (const Solve* solve : traces) courses.push_back(course_of(*solve));
  std::vector<Estimate> bands;
  std::vector<double> errors;
  for (const double position : evaluations) {
    errors.clear();
    for (std::size_t i = 0; i < traces.size(); ++i) errors.push_back(error_at(*traces[i], courses[i], position));
    const std::vector<double> ranked = ranked_values(errors);
    const auto at = [&](double p) { return or_censored(quantile(ranked, p, QuantileType::type_5)); };
    bands.push_back({.value = at(0.5), .low = at(0.25), .high = at(0.75)});
  }
  return bands;
}

std::vector<double> evaluations_axis(const std::vector<Solves>& traces) {
  double first = censored, last = 0;
  for (const Solves& solves : traces) {
    for (const Solve* solve : solves) {
      const double total = evaluations_of(*solve);
      if (!(total > 0)) continue;
      const std::vector<Step> course = course_of(*solve);
      first = std::min(first, course.empty() ? total : course.front().evaluations);
      last = std::max(last, total);
    }
  }
  return last > 0 ? log_spaced(first, last, most_positions) : std::vector<double>();
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

}  // namespace ikbench::inference
