// KDL's ChainIkSolverPos_NR_JL: Newton's method with the pseudo-inverse, clipped at the joint limits, on KDL's own
// kinematics. One step is one call of the library, which knows no clock: where the study has a limit of time, a call
// makes a few iterations and the next goes on from its answer.
#include <kdl/config.h>

#include <algorithm>
#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainiksolverpos_nr_jl.hpp>
#include <kdl/chainiksolvervel_pinv.hpp>
#include <kdl/jntarray.hpp>
#include <memory>
#include <optional>

#include "numerics/functions.hpp"
#include "solvers/registry.hpp"

namespace ikbench::solvers {

using namespace robots;

namespace {

KDL::Frame kdl_frame(const Pose& T) {
  KDL::Frame frame;
  for (int i = 0; i < 3; ++i) {
    frame.p(i) = T.translation()[i];
    for (int j = 0; j < 3; ++j) frame.M(i, j) = T.linear()(i, j);
  }
  return frame;
}

KDL::JntArray kdl_joints(const Configuration& q) {
  KDL::JntArray array(static_cast<unsigned>(q.size()));
  array.data = q;
  return array;
}

// Returns the turn by beta about y, which KDL's rows of Denavit and Hartenberg lack.
KDL::Frame leaning(double beta) {
  const auto [sine, cosine] = numerics::sin_cos(beta);
  return KDL::Frame(KDL::Rotation(cosine, 0, sine, 0, 1, 0, -sine, 0, cosine));
}

// Returns the chain in KDL's form. The first segment is the frame of the base, which no joint moves.
KDL::Chain kdl_chain(const Chain& arm) {
  KDL::Chain chain;
  chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::None), kdl_frame(arm.base().pose())));
  for (const DhLink& link : arm.links()) {
    const KDL::Joint joint(link.joint == Joint::slides ? KDL::Joint::TransZ : KDL::Joint::RotZ);
    const KDL::Frame row = KDL::Frame::DH(link.a, link.alpha, link.d, link.offset);
    chain.addSegment(KDL::Segment(joint, row * leaning(link.beta)));
  }
  chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::None), kdl_frame(arm.tool().pose())));
  return chain;
}

// KDL's solvers of one call, which refer to each other.
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

class KdlNewton final : public Searcher {
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
                 "KDL's maximum number of iterations, in KDL 100; 0: the study's, at max_iterations 1 000 000");
    }
  };

  explicit KdlNewton(Options options) : options_(options) {}

  static std::string why_not(const Chain& arm, GoalKind goal) {
    if (goal != GoalKind::pose) return "kdl_newton solves for a pose; expected search = \"pose\"";
    const bool is_coupled = std::ranges::count(arm.links(), Joint::coupled, &DhLink::joint) > 0;
    return is_coupled ? "KDL has no coupled joints; expected an arm whose joints turn or slide" : "";
  }

  void start(const Problem& problem, Objective& objective, Random&) override {
    const double accuracy = accuracy_for(problem.stop);
    // An iteration is about one evaluation.
    std::int64_t max_iterations =
        options_.iterations > 0 ? options_.iterations : std::min(problem.stop.iterations, 1'000'000);
    if (problem.stop.evaluations > 0) max_iterations = std::min(max_iterations, problem.stop.evaluations);
    left_ = static_cast<int>(max_iterations);
    const int calls = problem.stop.seconds > 0 ? (left_ + max_call - 1) / max_call : 1;
    const int iterations = left_ / std::max(1, calls);
    if (!call_ || *arm_ != objective.arm() || accuracy != accuracy_ || iterations != iterations_) {
      arm_ = objective.arm();
      accuracy_ = accuracy;
      iterations_ = iterations;
      call_ = std::make_unique<KdlNewtonCall>(*arm_, problem, accuracy, iterations);
    } else {
      call_->newton.setJointLimits(kdl_joints(problem.lower), kdl_joints(problem.upper));
    }
    q_ = problem.start;
    take(problem);
    best_.improve(q_, objective.error(q_));
  }

  void step(Objective& objective, Random&) override {
    if (finished()) return;
    KDL::JntArray answer(static_cast<unsigned>(q_.size()));
    const int how = call_->newton.CartToJnt(kdl_joints(q_), kdl_frame(objective.goal().target), answer);
    q_ = answer.data;
    best_.improve(q_, objective.error(q_));
    left_ = how == KDL::SolverI::E_MAX_ITERATIONS_EXCEEDED && left_ >= 2 * iterations_ ? left_ - iterations_ : 0;
  }

  bool finished() const override { return left_ <= 0; }

 private:
  static constexpr int max_call = 50;  // iterations between looks at the clock

  // Returns KDL's eps for the tolerances of a study.
  double accuracy_for(const StopRule& stop) const {
    if (options_.accuracy > 0) return options_.accuracy;
    // A vector is short enough if each of its three coordinates is at most this.
    const double within = std::min(stop.tolerance, stop.angle_tolerance) / std::sqrt(3.0);
    return within > 0 ? within : 1e-6;
  }

  Options options_;
  std::optional<Chain> arm_;       // arm of the present call
  double accuracy_ = 0;            // accuracy of the present call
  int iterations_ = 0, left_ = 0;  // iterations per call; iterations left for all calls
  std::unique_ptr<KdlNewtonCall> call_;
  Configuration q_;
};

}  // namespace

SolverInfo kdl_newton() {
  SolverInfo info = solver_info<KdlNewton>("kdl_newton", "KDL's Newton-Raphson, clipped at the limits",
                                           "Orocos KDL, ChainIkSolverPos_NR_JL");
  info.library = "KDL " KDL_VERSION_STRING;
  info.is_counted = false;  // it has its own kinematics
  return info;
}

}  // namespace ikbench::solvers
