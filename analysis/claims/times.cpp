#include "analysis/claims/times.hpp"

#include <fmt/format.h>

#include "analysis/inference/times.hpp"

namespace ikbench::claims {

using namespace statistics;
using namespace inference;

std::vector<TimeAssessment> assess_times(const StudyResults& measured, double limit_ms) {
  constexpr double ms_in_s = 1000;
  const StudyResults study = at_median_speed(measured);
  constexpr double verifier_rounding_cm = 1e-7;
  const double most = tolerance_cm(study) + verifier_rounding_cm;
  std::vector<TimeAssessment> rows;
  for (const std::string& solver : study.solvers) {
    TimeAssessment row{.solver = solver};
    std::vector<double> times, iterations, evaluations;
    for (const Solve& solve : solves_of(study, solver)) {
      const double time_ms = ms_in_s * seconds_of(study, solve);
      times.push_back(time_ms);
      iterations.push_back(static_cast<double>(solve.iterations));
      evaluations.push_back(static_cast<double>(solve.evaluations));
      if (solve.position_error_cm <= most) {
        if (time_ms < limit_ms) ++row.in_time;
      } else {
        ++row.never_reached;  // also an answer that is not finite
      }
    }
    row.solves = static_cast<int>(times.size());
    row.time_ms = describe(times);
    row.iterations_median = describe(iterations).median;
    row.evaluations_median = describe(evaluations).median;
    rows.push_back(row);
  }
  return rows;
}

std::string printed_words(const PrintedTime& printed, double limit_ms) {
  return fmt::format("{}: mean {} ms, maximum {} ms; on average {}, in the worst case {}", printed.solver,
                     printed.ms.mean, printed.ms.max, printed.ms.mean < limit_ms ? "yes" : "no",
                     printed.ms.max < limit_ms ? "yes" : "no");
}

}  // namespace ikbench::claims
