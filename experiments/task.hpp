// The search for one target: what a solver gets, and how its answer becomes the values of all joints. The runner of
// solves makes one Task per solver entry; the multiverse completes answers with another wrist.
#pragma once

#include <array>
#include <optional>

#include "experiments/study/study.hpp"
#include "robots/spherical_wrist.hpp"
#include "solvers/solve.hpp"

namespace ikbench::experiments {

// Returns true if the last joint turns the tool about the tool's own point, which this joint therefore does not move.
bool rotates_tool_only(const robots::Chain& whole);

// Turns the revolute joints of an answer [rad, m] by whole turns, as the policy says. The limits and the chain are
// those of the answer's joints.
void wrap(Configuration& answer, const Configuration& start, const robots::JointLimits& limits,
          const robots::Chain& chain, results::WrapPolicy policy);

// The search for one target, over all joints or over those before the wrist. Study and arm must outlive the task.
class Task {
 public:
  Task(const Study& study, const Robot& arm);

  // Returns the joints that are searched, with the point that they place.
  const robots::Chain& arm() const { return searched_; }
  solvers::Goal goal(const Pose& target) const;
  solvers::Problem problem(const Configuration& start, int population) const;

  // Returns all joints [rad, m] of an answer: those that the search found, and the wrist's by the closed form. They are
  // wrapped as the study says. A joint behind the flange stays as at `start`.
  Configuration with_wrist(const Configuration& found, const Pose& target, const Configuration& start) const;

 private:
  // Returns the index of the branch that the study's rule takes if limits do not count.
  std::size_t preferred_branch(const std::array<Eigen::Vector3d, 2>& branches, const Eigen::Vector3d& near) const;
  std::size_t select_branch(const std::array<Eigen::Vector3d, 2>& branches, const Eigen::Vector3d& near) const;

  const Study& study_;
  const Robot& arm_;
  std::optional<robots::SphericalWrist> wrist_;
  robots::Chain searched_;
};

}  // namespace ikbench::experiments
