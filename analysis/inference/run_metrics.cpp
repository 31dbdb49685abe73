#include "analysis/inference/run_metrics.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/inference/study.hpp"
#include "numerics/units.hpp"
#include "results/orientation.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

bool is_followed(Run run, const StudyResults& study) {
  if (!study.task.is_path || run.size() < 2) return false;
  if (std::ranges::any_of(run, is_without_answer, [](const SolveRecord* solve) { return solve->status; })) return false;
  for (std::size_t k = 1; k < run.size(); ++k) {
    const SolveRecord &before = *run[k - 1], &solve = *run[k];
    if (solve.point != before.point + 1 || solve.start_rad != before.answer_rad) return false;
    if (solve.answer_rad.empty() || solve.answer_rad.size() != solve.start_rad.size()) return false;
    if (!std::isfinite(solve.largest_move_deg)) return false;
  }
  return true;
}

// The sum over the moves between points.
template <class ValueOf>
double sum_of_moves(Run run, const StudyResults& study, ValueOf value_of) {
  if (!is_followed(run, study)) return not_defined;
  double sum = 0;
  for (const SolveRecord* solve : run.subspan(1)) sum += value_of(*solve);
  return sum;
}

// Norm over the joints that turn [deg]; `element` gives that of a joint [rad].
template <class Element>
double norm_deg(std::size_t joints, const StudyResults& study, Element element) {
  double sum = 0;
  for (std::size_t joint = 0; joint < joints; ++joint) {
    if (!study.task.slides.contains(joint)) sum += element(joint) * element(joint);
  }
  return std::sqrt(sum) / numerics::degree;
}

bool is_near(const std::vector<double>& a, const std::vector<double>& b) {
  return std::ranges::equal(a, b, [](double x, double y) { return std::abs(x - y) <= 1e-9; });
}

}  // namespace

double orientation_error_deg(const SolveRecord& solve, const StudyResults& study) {
  return study.task.orientation ? orientation_angle_deg(solve.orientation_error) : not_defined;
}

double excess_error_cm(Run run) {
  std::vector<double> excess;
  for (const SolveRecord* solve : run) {
    if (solve->unavoidable_error_cm > 0) excess.push_back(solve->position_error_cm - solve->unavoidable_error_cm);
  }
  return excess.empty() ? not_defined : mean(excess);
}

double path_length_deg(Run run, const StudyResults& study) {
  return sum_of_moves(run, study, [](const SolveRecord& solve) { return solve.variation_deg; });
}

double path_length_m(Run run, const StudyResults& study) {
  return sum_of_moves(run, study, [](const SolveRecord& solve) { return solve.variation_m; });
}

double largest_jump_deg(Run run, const StudyResults& study) {
  if (!is_followed(run, study)) return not_defined;
  return (*std::ranges::max_element(run.subspan(1), {}, &SolveRecord::largest_move_deg))->largest_move_deg;
}

double jumps(Run run, const StudyResults& study) {
  return sum_of_moves(run, study,
                      [&](const SolveRecord& solve) { return solve.largest_move_deg > study.plan.jump_deg ? 1 : 0; });
}

double second_difference_deg(Run run, const StudyResults& study) {
  if (!is_followed(run, study) || run.size() < 3) return not_defined;
  double sum = 0;
  for (std::size_t k = 1; k + 1 < run.size(); ++k) {
    const std::vector<double>&before = run[k - 1]->answer_rad, &here = run[k]->answer_rad,
          &after = run[k + 1]->answer_rad;
    sum +=
        norm_deg(here.size(), study, [&](std::size_t joint) { return after[joint] - 2 * here[joint] + before[joint]; });
  }
  return sum / static_cast<double>(run.size() - 2);
}

double return_deg(Run run, const StudyResults& study) {
  if (!is_followed(run, study)) return not_defined;
  const SolveRecord &first = *run.front(), &last = *run.back();
  const bool is_closed =
      is_near(first.target_position_m, last.target_position_m) && is_near(first.target_rotation, last.target_rotation);
  if (!is_closed) return not_defined;
  return norm_deg(first.answer_rad.size(), study,
                  [&](std::size_t joint) { return last.answer_rad[joint] - first.answer_rad[joint]; });
}

}  // namespace ikbench::inference
