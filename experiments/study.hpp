// A study is data: the problems, the solvers, the number of repetitions, the seed.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "experiments/path.hpp"
#include "numerics/units.hpp"
#include "results/figure_style.hpp"
#include "results/plan.hpp"
#include "robots/robot.hpp"
#include "robots/urdf.hpp"
#include "solvers/options.hpp"
#include "solvers/registry.hpp"
#include "solvers/solve.hpp"

namespace ikbench::experiments {

// wrist: the solver searches the joints before a spherical wrist, whose angles follow in closed form (Eqs. 15-17).
// all_joints: it searches all joints for the position alone.
// flange: so does it, but for the last joint, which turns the tool about its own point and stays where it is.
// pose: it searches all joints for position and orientation.
// axis: it searches all joints for the position and the direction of the tool's z axis.
enum class Search { wrist, all_joints, pose, axis, flange };

// The rule that picks one of the wrist's two branches for an answer. nearest: the smaller move. positive, negative: the
// sign of the middle joint.
// inside: the nearer of those inside the joint limits, or the nearer of both if none is. With enforced limits, a branch
// outside always gives way to one inside.
enum class WristBranch { nearest, positive, negative, inside };

// principal: the wrist's angles are those of the arc tangent, in [-180, 180] deg. nearest: they are turned by whole
// turns to where they move least.
enum class WristTurns { principal, nearest };

// Joint limits of candidates: as each solver's own option says, or the same for all solvers with that option.
enum class StudyBounds { per_solver, initial, clamp };

// recorded: an answer outside the joint limits is kept and reported. enforced: limits hold for every solver and for the
// wrist; an answer outside is refused, and the arm stays where it was.
enum class Limits { recorded, enforced };

// into_limits: turns revolute joints of an answer back inside their limits by whole turns, where possible. No pose
// changes.
enum class Wrap { no, into_limits };

// The start of each solve of a run: the previous answer, the initial configuration, the middle of the limits, a
// configuration drawn from seed, run and point, or one near the configuration that the target was made of.
enum class Start { previous, initial, middle, random, near };

struct Program;  // foreign/program.hpp

// The treatment of a solver whose library this program was built without: refuse the study, or leave the solver out and
// say so.
enum class IfMissing { refuse, leave_out };

struct SolverEntry {
  std::string label;                            // unique in the study; the name in tables and figures
  std::string solver;                           // registered name, or a program's own name
  solvers::Settings options;                    // only those that differ from the solver's defaults
  int population = 0;                           // 0: as the study
  std::shared_ptr<const Program> program = {};  // null: the solver is built in
  IfMissing if_missing = IfMissing::refuse;
  // A solver that a user of these libraries defines, named `solver`; null: a registered one. The running program's file
  // counts as its source, so any change of the program solves anew.
  std::shared_ptr<const solvers::SolverInfo> own = {};
  std::string colour = {};  // in figures; empty: by its solver
  // One of the entries that a sweep made of an entry: that one's label, and the swept settings with their values here.
  std::string family = {};
  solvers::Settings swept = {};
};

// The solver of an entry that is no program.
const solvers::SolverInfo& info_of(const SolverEntry& entry);

struct LeftOut {
  std::string label;
  std::string why;  // "not built: ..."
};

struct Study {
  std::string name = "study";
  std::string title;
  std::string published;              // the paper whose printed tables stand beside the results, or empty
  std::string robot = "kuka_iiwa14";  // a built-in arm, or a file
  std::shared_ptr<const robots::Robot> robot_of_file;  // the arm in that file; null: the arm is built in
  robots::UrdfChoice urdf;                             // for a URDF file
  Path path;
  Search search = Search::wrist;
  // The weight of a radian in a pose error [m]. The error compares three points that are about as far apart as the
  // parts of a tool and of what it holds. With 0.1 m or 1 m, swarms find fewer poses of a UR5e.
  double rotation_weight = 0.25;
  StudyBounds bounds = StudyBounds::per_solver;
  WristBranch wrist_branch = WristBranch::nearest;
  WristTurns wrist_turns = WristTurns::principal;
  Limits limits = Limits::recorded;
  Wrap wrap = Wrap::no;
  Start start = Start::previous;
  double near = 5 * numerics::degree;  // [rad] for Start::near: largest distance of a joint from the solution
  Eigen::VectorXd initial;             // [rad], all joints; the arm before the first point of a run
  int population = 50;
  solvers::StopRule stop;
  int runs = 20;
  int repeats = 5;  // timed solves per problem; decides only times (runner.hpp)
  std::uint64_t seed = 1;
  solvers::Trace trace = solvers::Trace::none;
  std::vector<SolverEntry> solvers;
  std::vector<LeftOut> left_out;
  std::vector<std::string> notes;  // what of it was not taken as it stands
  results::Plan analysis;          // how the solves will be judged; decides no number of them
  results::FigureStyle figures;    // the look of its figures, without the colours of its entries
};

std::vector<std::string> labels_of(const Study& study);  // of its solvers

solvers::GoalKind goal_kind(Search search);

// The study's arm; std::invalid_argument if there is none of that name.
robots::Robot arm_of(const Study& study);

// The unit of each joint outside the program: degrees, or metres if the joint slides.
robots::Configuration joint_units(const robots::Chain& arm);

// The defaults of the entry's solver with these settings applied. Throws std::invalid_argument as OptionList::set does.
solvers::Settings options_with(const SolverEntry& entry, const solvers::Settings& settings);
// The options that an entry's solver is made with: its defaults, the study's bounds, then its own options.
solvers::Settings effective_options(const Study& study, const SolverEntry& entry);
int effective_population(const Study& study, const SolverEntry& entry);

// The targets of a run, the same for all solvers. Only random targets differ between runs; those of a longer run begin
// with those of a shorter one. `arm` is arm_of(study), which reads and checks a file.
std::vector<robots::Pose> targets(const Study& study, const robots::Robot& arm, int run);
std::vector<robots::Pose> targets(const Study& study, int run);

// The starts of a run's solves, the same for all solvers; none for Start::previous and Start::initial.
std::vector<robots::Configuration> starts(const Study& study, const robots::Robot& arm, int run);

// A target that certainly no configuration reaches, by its distance from the shoulder (to the wrist's centre, if that
// is searched).
struct Unreachable {
  int point;        // from 1
  double distance;  // [m]
  double reach;     // [m]
};
std::vector<Unreachable> unreachable(const Study& study);

}  // namespace ikbench::experiments
