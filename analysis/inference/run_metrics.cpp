#include "analysis/inference/run_metrics.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "analysis/inference/study.hpp"
#include "results/orientation.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

bool is_followed(Run run, const StudyResults& study) {
  if (study.facts.draws_targets || run.size() < 2) return false;
  if (std::ranges::any_of(run, is_without_answer, &Solve::status)) return false;
  for (std::size_t k = 1; k < run.size(); ++k) {
    const Solve &before = *run[k - 1], &solve = *run[k];
    if (solve.run != before.run || solve.point != before.point + 1 || !solve.is_following) return false;
    if (!std::isfinite(solve.largest_move_deg)) return false;
  }
  return true;
}

// Sums a value over the moves between points.
template <class ValueOf>
double sum_of_moves(Run run, const StudyResults& study, ValueOf value_of) {
  if (!is_followed(run, study)) return not_defined;
  double sum = 0;
  for (const Solve* solve : run.subspan(1)) sum += value_of(*solve);
  return sum;
}

// Shape of a run that follows a path; not defined if it has one solve only.
RunShape shape_of(Run run, const StudyResults& study) {
  if (!is_followed(run, study)) return {};
  const std::vector<RunShape>& all = study.solve_data->shapes;
  const auto place = [](const auto& of) { return std::pair(of.solver, of.run); };
  const auto found = std::ranges::lower_bound(all, place(*run.front()), {}, place);
  return found != all.end() && place(*found) == place(*run.front()) ? *found : RunShape{};
}

}  // namespace

double orientation_error_deg(const Solve& solve, const StudyResults& study) {
  return study.facts.orientation ? orientation_angle_deg(solve.orientation_error) : not_defined;
}

double variation_m(const Solve& solve) { return solve.extras == nullptr ? 0 : solve.extras->variation_m; }

double instructions(const Solve& solve) {
  return solve.extras == nullptr ? statistics::not_defined : solve.extras->instructions;
}

double excess_error_cm(Run run, const StudyResults& study) {
  std::vector<double> excess;
  for (const Solve* solve : run) {
    const double unavoidable = problem_of(study, *solve).unavoidable_error_cm;
    if (unavoidable > 0) excess.push_back(solve->position_error_cm - unavoidable);
  }
  return excess.empty() ? not_defined : mean(excess);
}

double path_length_deg(Run run, const StudyResults& study) {
  return sum_of_moves(run, study, [](const Solve& solve) { return solve.variation_deg; });
}

double path_length_m(Run run, const StudyResults& study) { return sum_of_moves(run, study, variation_m); }

double largest_jump_deg(Run run, const StudyResults& study) {
  if (!is_followed(run, study)) return not_defined;
  return (*std::ranges::max_element(run.subspan(1), {}, &Solve::largest_move_deg))->largest_move_deg;
}

double jumps(Run run, const StudyResults& study) {
  return sum_of_moves(run, study,
                      [&](const Solve& solve) { return solve.largest_move_deg > study.plan.jump_deg ? 1 : 0; });
}

double second_difference_deg(Run run, const StudyResults& study) { return shape_of(run, study).second_difference_deg; }

double return_deg(Run run, const StudyResults& study) { return shape_of(run, study).return_deg; }

}  // namespace ikbench::inference
