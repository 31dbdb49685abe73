// KDL's ChainIkSolverPos_LMA: Levenberg and Marquardt's method on KDL's own kinematics. It knows no joint limits. One
// step is one call of the library.
#include <kdl/chainiksolverpos_lma.hpp>
#include <memory>
#include <optional>

#include "solvers/peers/kdl.hpp"

namespace ikbench::solvers {

using namespace numerics;
using namespace robots;

namespace {

class KdlLma final : public Solver {
 public:
  struct Options {
    double rotation_weight = 0.01;
    double accuracy = 0;
    int iterations = 0;

    void list(OptionList& list) {
      list.number("rotation_weight", rotation_weight, {1e-6, 10}, "what a radian weighs in KDL's error [m]");
      list.number("accuracy", accuracy, {0, 1},
                  "KDL's eps [m]: it ends where its error is below; 0: where both tolerances of the study certainly "
                  "hold, or without one 1e-5, as in KDL");
      list.count("iterations", iterations, {0, 1'000'000},
                 "KDL's maximum number of iterations, in KDL 500; 0: the study's, at most 1 000 000");
    }
  };

  explicit KdlLma(Options options) : options_(options) {}

  static std::string why_not(const Chain& arm, GoalKind goal) {
    if (goal == GoalKind::axis)
      return "kdl_lma cannot leave a turn free; expected search = \"pose\", or another solver";
    return why_kdl_cannot(arm);
  }

  void start(const Problem& problem, Objective& objective, Random&) override {
    if (!arm_ || *arm_ != objective.arm()) {
      lma_.reset();
      arm_ = objective.arm();
      chain_ = kdl_chain(*arm_);
    }
    calls_.start(problem, objective, options_.iterations);
    const Call call{.weight = objective.goal().has_direction() ? options_.rotation_weight : 0,
                    .accuracy = accuracy(problem.stop, objective.goal().has_direction()),
                    .iterations = calls_.iterations_of_call()};
    if (!lma_ || call != call_) {
      call_ = call;
      Eigen::Matrix<double, 6, 1> weights;
      weights << 1, 1, 1, call.weight, call.weight, call.weight;
      lma_ = std::make_unique<KDL::ChainIkSolverPos_LMA>(chain_, weights, call.accuracy, call.iterations);
    }
  }

  void step(Objective& objective, Random&) override {
    if (!calls_.has_ended()) calls_.call(*lma_, objective);
  }

  const Best& best() const override { return calls_.best; }
  bool finished() const override { return calls_.has_ended(); }

 private:
  struct Call {
    double weight, accuracy;
    int iterations;
    bool operator==(const Call&) const = default;
  };

  double accuracy(const StopRule& stop, bool is_pose) const {
    if (options_.accuracy > 0) return options_.accuracy;
    if (!(stop.tolerance > 0)) return 1e-5;
    return is_pose ? std::min(stop.tolerance, options_.rotation_weight * stop.angle_tolerance) : stop.tolerance;
  }

  Options options_;
  std::optional<Chain> arm_;
  KDL::Chain chain_;  // of that arm; the library's solver refers to it
  Call call_{};
  std::unique_ptr<KDL::ChainIkSolverPos_LMA> lma_;
  KdlCalls calls_;
};

}  // namespace

SolverInfo kdl_lma() {
  return kdl_info<KdlLma>("kdl_lma", "KDL's Levenberg-Marquardt, without joint limits",
                          "Orocos KDL, ChainIkSolverPos_LMA");
}

}  // namespace ikbench::solvers
