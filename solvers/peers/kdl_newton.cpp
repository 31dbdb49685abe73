// KDL's ChainIkSolverPos_NR_JL: Newton's method with the pseudo-inverse, clipped at the joint limits, on KDL's own
// kinematics. One step is one call of the library.
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainiksolverpos_nr_jl.hpp>
#include <kdl/chainiksolvervel_pinv.hpp>
#include <memory>
#include <optional>

#include "solvers/peers/kdl.hpp"

namespace ikbench::solvers {

using namespace numerics;
using namespace robots;

namespace {

// KDL's solvers of one call; they refer to each other.
struct KdlNewtonCall {
  KdlNewtonCall(const Chain& arm, const Problem& problem, double accuracy, int iterations)
      : chain(kdl_chain(arm)),
        forward(chain),
        velocity(chain),
        newton(chain, kdl_joints(problem.lower), kdl_joints(problem.upper), forward, velocity,
               static_cast<unsigned>(iterations), accuracy) {}

  KDL::Chain chain;
  KDL::ChainFkSolverPos_recursive forward;
  KDL::ChainIkSolverVel_pinv velocity;
  KDL::ChainIkSolverPos_NR_JL newton;
};

class KdlNewton final : public Solver {
 public:
  struct Options {
    double accuracy = 0;
    int iterations = 0;

    void list(OptionList& list) {
      list.number(
          "accuracy", accuracy, {0, 1},
          "KDL's eps [m, rad]: it ends where every coordinate of the twist that is left is below; 0: where both "
          "tolerances of the study certainly hold, or without one 1e-6, as in KDL");
      list.count("iterations", iterations, {0, 1'000'000},
                 "KDL's maximum number of iterations, in KDL 100; 0: the study's, at most 1 000 000");
    }
  };

  explicit KdlNewton(Options options) : options_(options) {}

  static std::string why_not(const Chain& arm, GoalKind goal) {
    if (goal != GoalKind::pose) return "kdl_newton solves for a pose; expected search = \"pose\"";
    return why_kdl_cannot(arm);
  }

  void start(const Problem& problem, Objective& objective, Random&) override {
    // A vector is short enough if each of its three coordinates is at most this.
    const double within = std::min(problem.stop.tolerance, problem.stop.angle_tolerance) / std::sqrt(3.0);
    const double accuracy = options_.accuracy > 0 ? options_.accuracy : within > 0 ? within : 1e-6;
    calls_.start(problem, objective, options_.iterations);
    const int iterations = calls_.iterations_of_call();
    if (!call_ || *arm_ != objective.arm() || accuracy != accuracy_ || iterations != iterations_) {
      arm_ = objective.arm();
      accuracy_ = accuracy;
      iterations_ = iterations;
      call_ = std::make_unique<KdlNewtonCall>(*arm_, problem, accuracy, iterations);
    } else {
      call_->newton.setJointLimits(kdl_joints(problem.lower), kdl_joints(problem.upper));
    }
  }

  void step(Objective& objective, Random&) override {
    if (!calls_.has_ended()) calls_.call(call_->newton, objective);
  }

  const Best& best() const override { return calls_.best; }
  bool finished() const override { return calls_.has_ended(); }

 private:
  Options options_;
  std::optional<Chain> arm_;  // the arm of the call
  double accuracy_ = 0;
  int iterations_ = 0;
  std::unique_ptr<KdlNewtonCall> call_;
  KdlCalls calls_;
};

}  // namespace

SolverInfo kdl_newton() {
  return kdl_info<KdlNewton>("kdl_newton", "KDL's Newton-Raphson, clipped at the limits",
                             "Orocos KDL, ChainIkSolverPos_NR_JL");
}

}  // namespace ikbench::solvers
