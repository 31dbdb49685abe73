// What a library evaluates by our objective: the best of it, and when the study's stop rule says that it is enough.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "solvers/tolerance.hpp"

namespace ikbench::solvers {

class Evaluations {
 public:
  using Clock = std::chrono::steady_clock;
  // `best` is kept up to date; `started`: the solve. They outlive it.
  Evaluations(const Problem& problem, Objective& objective, Best& best, Clock::time_point started)
      : problem_(problem),
        objective_(objective),
        best_(best),
        tolerance_(problem.stop.tolerance, problem.stop.angle_tolerance, objective),
        started_(started) {}

  Objective& objective() { return objective_; }
  // A number that a library can rank, also where there is no error.
  double error(const robots::ConfigurationRef& q) {
    const double error = objective_.error(q);
    if (best_.improve(q, error) && problem_.improvements != nullptr)
      problem_.improvements->add(objective_.evaluations(), error);
    return std::isfinite(error) ? error : no_error;
  }
  bool is_over() {
    is_over_ =
        is_over_ || left() <= 0 || tolerance_.is_reached(best_) || (problem_.stop.seconds > 0 && seconds_left() <= 0);
    return is_over_;
  }
  // How many may follow: as the study says, or as many as a population would have had in its iterations.
  std::int64_t left() const {
    const std::int64_t all = problem_.stop.evaluations > 0 ? problem_.stop.evaluations
                                                           : std::int64_t{problem_.iterations} * problem_.population;
    return all - objective_.evaluations();
  }

  static constexpr double no_error = 1e10;  // [m]; its square is a number too

 private:
  double seconds_left() const {
    return problem_.stop.seconds - std::chrono::duration<double>(Clock::now() - started_).count();
  }

  const Problem& problem_;
  Objective& objective_;
  Best& best_;
  Tolerance tolerance_;
  Clock::time_point started_;
  bool is_over_ = false;
};

// The library ends for this where it is told so by an exception.
struct IsOver {};

}  // namespace ikbench::solvers
