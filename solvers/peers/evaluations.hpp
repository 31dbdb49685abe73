// What the solvers by NLopt share. Evaluations of our objective by the library: keeps the best of them, and knows when
// the study's stop rule ends the solve.
#pragma once

#include <fmt/format.h>
#include <nlopt.h>

#include <chrono>
#include <cmath>
#include <memory>
#include <string>

#include "solvers/solve.hpp"

namespace ikbench::solvers {

using NloptHandle = std::unique_ptr<nlopt_opt_s, decltype([](nlopt_opt opt) { nlopt_destroy(opt); })>;

inline std::string nlopt_version_text() {
  int major = 0, minor = 0, fix = 0;
  nlopt_version(&major, &minor, &fix);
  return fmt::format("NLopt {}.{}.{}", major, minor, fix);
}

// The state of a solve by calls of a library.
struct LibrarySolve {
  using Clock = std::chrono::steady_clock;

  void start(const Problem& asked, Objective& objective) {
    started = Clock::now();
    problem = asked;
    has_ended = false;
    best = {asked.start};
    best.improve(asked.start, objective.error(asked.start));
  }

  Problem problem;
  Best best;  // of all evaluations
  bool has_ended = false;
  Clock::time_point started;
};

// The evaluations of one call of the library. The solve outlives it.
class Evaluations {
 public:
  Evaluations(LibrarySolve& solve, Objective& objective)
      : solve_(solve),
        problem_(solve.problem),
        objective_(objective),
        tolerance_(problem_.stop.tolerance, problem_.stop.angle_tolerance, objective) {}

  Objective& objective() { return objective_; }
  // A number that a library can rank, even if the error is not finite.
  double error(const robots::ConfigurationRef& q) {
    const double error = objective_.error(q);
    found(q, error);
    return std::isfinite(error) ? error : no_error;
  }
  // What was evaluated elsewhere.
  void found(const robots::ConfigurationRef& q, double error) {
    if (solve_.best.improve(q, error) && problem_.improvements != nullptr)
      problem_.improvements->add(objective_.evaluations(), error);
  }
  Residual found(const robots::ConfigurationRef& q, const Linearized& at) {
    found(q, at.error);
    return at.to_go;
  }
  bool is_over() {
    is_over_ = is_over_ || left() <= 0 || tolerance_.is_reached(solve_.best) ||
               (problem_.stop.seconds > 0 && seconds_left() <= 0);
    return is_over_;
  }
  // The number of evaluations left: of the study's budget, or of a population's over its iterations.
  std::int64_t left() const {
    const std::int64_t all = problem_.stop.evaluations > 0 ? problem_.stop.evaluations
                                                           : std::int64_t{problem_.iterations} * problem_.population;
    return all - objective_.evaluations();
  }

  static constexpr double no_error = 1e10;  // [m]; its square is finite too

 private:
  double seconds_left() const {
    return problem_.stop.seconds - std::chrono::duration<double>(LibrarySolve::Clock::now() - solve_.started).count();
  }

  LibrarySolve& solve_;
  const Problem& problem_;
  Objective& objective_;
  Tolerance tolerance_;
  bool is_over_ = false;
};

}  // namespace ikbench::solvers
