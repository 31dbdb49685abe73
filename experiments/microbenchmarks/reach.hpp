// The problem that all measure: bring the flange of the iiwa, by all seven joints, to the first point of the paper's
// helix.
#pragma once

#include <cmath>

#include "experiments/study.hpp"
#include "robots/robot.hpp"
#include "solvers/bounds.hpp"

namespace ikbench::microbenchmarks {

struct Reach {
  robots::Robot arm = robots::robot("kuka_iiwa14");
  Eigen::Vector3d target = experiments::targets(experiments::Study{}, 1).front().translation();
  solvers::Problem problem{
      .start = Eigen::VectorXd::Zero(7), .lower = arm.limits.lower, .upper = arm.limits.upper, .population = 50};

  robots::Candidates candidates() const {
    robots::Candidates drawn(7, problem.population);
    numerics::Random random{numerics::Key(1)};
    solvers::draw_within_limits(problem, random, drawn);
    return drawn;
  }

  // Eqs. 1, 18 and 26, letter by letter.
  double textbook_error(const Eigen::Ref<const Eigen::VectorXd>& q) const {
    Eigen::Matrix4d T = Eigen::Matrix4d::Identity();
    for (Eigen::Index j = 0; j < q.size(); ++j) {
      const robots::DhLink& link = arm.chain.links()[static_cast<std::size_t>(j)];
      const double c = std::cos(q[j] + link.offset), s = std::sin(q[j] + link.offset);
      const double ca = std::cos(link.alpha), sa = std::sin(link.alpha);
      Eigen::Matrix4d T_link;
      T_link << c, -s * ca, s * sa, link.a * c,  //
          s, c * ca, -c * sa, link.a * s,        //
          0, sa, ca, link.d,                     //
          0, 0, 0, 1;
      T = T * T_link;
    }
    return (T.block<3, 1>(0, 3) - target).norm();
  }
};

}  // namespace ikbench::microbenchmarks
