// Common parts of the solvers by NLopt: evaluations of our objective by the library. Keeps the best of them, and knows
// when the study's stop rule ends the solve.
#pragma once

#include <fmt/format.h>
#include <nlopt.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <string>

#include "solvers/bounds.hpp"
#include "solvers/solve.hpp"

namespace ikbench::solvers {

using NloptHandle = std::unique_ptr<nlopt_opt_s, decltype([](nlopt_opt opt) { nlopt_destroy(opt); })>;

inline std::string nlopt_version_text() {
  int major = 0, minor = 0, fix = 0;
  nlopt_version(&major, &minor, &fix);
  return fmt::format("NLopt {}.{}.{}", major, minor, fix);
}

// A solver that calls NLopt. The best answer is that of all evaluations.
class NloptSearch : public Searcher {
 public:
  void start(const Problem& problem, Objective& objective, Random&) override {
    started_ = Clock::now();
    take(problem);
    best_.improve(problem.start, objective.error(problem.start));
    jacobian_.resize(objective.rows(), problem.joints());
    has_ended_ = false;
    calls_ = 0;
  }
  bool finished() const override { return has_ended_; }
  int restarts() const override { return std::max(0, calls_ - 1); }

 protected:
  using Clock = std::chrono::steady_clock;
  friend class Evaluations;

  // Returns the start of the next call: the arm's configuration for the first call, then a random one.
  Configuration next_start(Random& random) {
    Configuration q = problem_.start.cwiseMax(problem_.lower).cwiseMin(problem_.upper);
    if (calls_++ > 0) draw_one_within_limits(problem_, random, q);
    return q;
  }

  Eigen::MatrixXd jacobian_;
  bool has_ended_ = false;
  int calls_ = 0;
  Clock::time_point started_;
};

// The evaluations of one call of the library. The solve outlives it.
class Evaluations {
 public:
  Evaluations(NloptSearch& solve, Objective& objective)
      : solve_(solve), problem_(solve.problem_), objective_(objective), tolerance_(problem_.stop, objective) {}

  Objective& objective() { return objective_; }
  // Returns the error [m], or a number that a library can rank if the error is not finite.
  double error(const robots::ConfigurationRef& q) {
    const double error = objective_.error(q);
    found(q, error);
    return std::isfinite(error) ? error : no_error;
  }
  // Records a candidate that was evaluated elsewhere.
  void found(const robots::ConfigurationRef& q, double error) {
    if (solve_.best_.improve(q, error) && problem_.improvements != nullptr)
      problem_.improvements->add(objective_.evaluations(), error);
  }
  Residual found(const robots::ConfigurationRef& q, const Linearized& at) {
    found(q, at.error);
    return at.to_go;
  }
  bool is_over() {
    is_over_ = is_over_ || left() <= 0 || tolerance_.is_reached(solve_.best_) ||
               (problem_.stop.seconds > 0 && seconds_left() <= 0);
    return is_over_;
  }
  // Returns the number of evaluations left: of the study's budget, or of a population's over its iterations.
  std::int64_t left() const {
    const std::int64_t all = problem_.stop.evaluations > 0 ? problem_.stop.evaluations
                                                           : std::int64_t{problem_.iterations} * problem_.population;
    return all - objective_.evaluations();
  }

  static constexpr double no_error = 1e10;  // [m]; its square is finite too

 private:
  double seconds_left() const {
    return problem_.stop.seconds - std::chrono::duration<double>(NloptSearch::Clock::now() - solve_.started_).count();
  }

  NloptSearch& solve_;
  const Problem& problem_;
  Objective& objective_;
  Tolerance tolerance_;
  bool is_over_ = false;
};

}  // namespace ikbench::solvers
