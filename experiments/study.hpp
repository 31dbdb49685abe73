// A study is data: what is solved, by whom, how often, from which seed.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/path.hpp"
#include "numerics/units.hpp"
#include "results/analysis_plan.hpp"
#include "robots/robot.hpp"
#include "robots/urdf.hpp"
#include "solvers/options.hpp"
#include "solvers/registry.hpp"
#include "solvers/solve.hpp"

namespace ikbench::experiments {

// wrist: the solver searches the joints before a spherical wrist, whose angles follow in closed form (Eqs. 15-17).
// all_joints: it searches all joints for the position alone.
// pose: it searches all joints for position and orientation.
enum class Search { wrist, all_joints, pose };

// Which of the wrist's two branches completes an answer: the one with the smaller move, or that whose middle joint is
// positive or negative.
// inside: the nearer of those inside the joint limits, and the nearer of all where none is. Where limits are enforced a
// branch outside gives way to one inside in any case.
enum class WristBranch { nearest, positive, negative, inside };

// Whether the joint limits hold for candidates: as each solver's own option says, or the same for all that have it.
enum class StudyBounds { per_solver, initial, clamp };

// recorded: an answer outside the joint limits is kept and told. enforced: limits hold for every solver and for the
// wrist, and an answer outside is refused: the arm stays where it was.
enum class Limits { recorded, enforced };

// into_limits: of an answer, each joint that turns and is outside its limits is turned back inside by whole turns,
// which changes no pose, where that is possible.
enum class Wrap { no, into_limits };

// Where the solves of a run begin: where the answer before left the arm, or each at the initial configuration, in the
// middle of the limits, at a configuration drawn from seed, run and point, or near the one that the target was made of.
enum class Start { previous, initial, middle, random, near };

struct Program;  // foreign/program.hpp

// What becomes of a study where a solver of it is of a library that this program was built without: it is refused, or
// goes on without that solver and says so.
enum class IfMissing { refuse, leave_out };

struct SolverEntry {
  std::string label;                            // unique within the study; its name in tables and figures
  std::string solver;                           // registered name; of a program, its own
  solvers::Settings options;                    // those that differ from the solver's defaults
  int population = 0;                           // 0: the study's
  std::shared_ptr<const Program> program = {};  // null: the solver is built in
  IfMissing if_missing = IfMissing::refuse;
  // A solver of who uses these libraries, under the name of `solver`; null: it is registered. Its source is the file of
  // the running program: whatever of that changes, it solves anew.
  std::shared_ptr<const solvers::SolverInfo> own = {};
};

// Of an entry's solver that is no program.
solvers::SolverInfo info_of(const SolverEntry& entry);

struct LeftOut {
  std::string label;
  std::string why;  // "not built: ..."
};

struct Study {
  std::string name = "study";
  std::string title;
  std::string published;              // the paper whose printed tables are set beside the results, or empty
  std::string robot = "kuka_iiwa14";  // a built-in arm, or a file
  std::shared_ptr<const robots::Robot> robot_of_file;  // what that file holds; null: the arm is built in
  robots::UrdfChoice urdf;                             // of that file, if it is a URDF file
  Path path;
  Search search = Search::wrist;
  // What a radian weighs in the error of a pose [m]: the three points that are compared are about as far apart as the
  // parts of a tool and of what it holds. With 0.1 m or 1 m, swarms find fewer poses of a UR5e.
  double rotation_weight = 0.25;
  StudyBounds bounds = StudyBounds::per_solver;
  WristBranch wrist_branch = WristBranch::nearest;
  Limits limits = Limits::recorded;
  Wrap wrap = Wrap::no;
  Start start = Start::previous;
  double near = 5 * numerics::degree;  // [rad] of Start::near: the farthest that a joint is from the solution
  Eigen::VectorXd initial;             // [rad], all joints; where the arm is before the first point of a run
  int population = 50;
  solvers::StopRule stop;
  int runs = 20;
  double deadline = 0;  // [s] of a solve, by which its time is judged; 0: none. It ends no solve
  int repeats = 5;      // of a solve, to time it; decides no number but times (runner.hpp)
  std::uint64_t seed = 1;
  solvers::Trace trace = solvers::Trace::none;
  std::vector<SolverEntry> solvers;
  std::vector<LeftOut> left_out;
  results::AnalysisPlan analysis;  // how the solves will be judged; decides no number of them
};

// The arm that it is about; std::invalid_argument where there is none of that name.
robots::Robot arm_of(const Study& study);

// What the values of an arm's joints are given in outside the program: degrees, and metres where a joint slides.
robots::Configuration joint_units(const robots::Chain& arm);

// The defaults of the entry's solver with these settings; std::invalid_argument as OptionList::set says.
solvers::Settings options_with(const SolverEntry& entry, const solvers::Settings& settings);
// What each entry's solver is really made with: the study's bounds applied, its own options over them, defaults
// filled in.
solvers::Settings effective_options(const Study& study, const SolverEntry& entry);
int effective_population(const Study& study, const SolverEntry& entry);

// Where the tool has to go in a run, the same for all solvers. Only random targets differ from run to run; those of
// one with more points begin with those of one with fewer. `arm` is arm_of(study), which reads and checks a file.
std::vector<robots::Pose> targets(const Study& study, const robots::Robot& arm, int run);
std::vector<robots::Pose> targets(const Study& study, int run);

// Where each solve of a run starts, the same for all solvers; none for Start::previous and Start::initial.
std::vector<robots::Configuration> starts(const Study& study, const robots::Robot& arm, int run);

// Why no two solvers of the study were given the same problem, so that there are no blocks to compare them in; empty
// where there are: targets drawn anew in every run are the same for all solvers, and so is each target of a path whose
// solves all begin at the initial configuration.
std::string why_no_blocks(const Study& study);

// A target that no configuration reaches, for certain: by the distance from the shoulder (to the wrist's centre, where
// that is what is searched).
struct Unreachable {
  int point;        // from 1
  double distance;  // [m]
  double reach;     // [m]
};
std::vector<Unreachable> unreachable(const Study& study);

}  // namespace ikbench::experiments
