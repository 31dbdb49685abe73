// source = pytracik==0.0.3
// flags = -I src $(ls src/*.cpp src/urdf/*.cpp | grep -v /pytracik.cpp) -lorocos-kdl -lnlopt -pthread
// TRAC-IK as with_trac_ik.py asks it: solve type Speed, in its two threads, until the time is up.
#include "kdl_chain.hpp"
#include "trac_ik.hpp"

struct Library {  // of one budget and tolerance, the study's
  KDL::Chain chain;
  std::unique_ptr<TRAC_IK::TRAC_IK> solver;
};

Values solve(Library& library, ikbench::Problem& problem) {
  if (!library.solver)
    library.solver = std::make_unique<TRAC_IK::TRAC_IK>(
        library.chain, array(problem.lower), array(problem.upper), problem.seconds > 0 ? problem.seconds : 0.1,
        std::min(problem.near, problem.near_angle) / std::sqrt(3.0), TRAC_IK::Speed);
  KDL::JntArray q(library.chain.getNrOfJoints());
  const int found = library.solver->CartToJnt(array(problem.start), frame_of(target_of(problem)), q);
  return found >= 0 ? values(q) : Values();
}

int main() {
  ikbench::run(
      "trac_ik", {},
      [](const ikbench::Robot& robot) {
        return Library{chain_of(robot), nullptr};
      },
      solve, R"(["pose"])");
}
