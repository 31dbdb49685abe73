// A study as data: the targets, the solvers, the number of runs, the seed. Every part of this folder takes one:
// reader.hpp makes a study of a file or a store, writer.hpp writes it, runner.hpp solves it. The fields of study files
// are explained in docs/reference/study-file.md.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/study/path.hpp"
#include "results/study.hpp"
#include "robots/robot.hpp"
#include "solvers/options.hpp"
#include "solvers/registry.hpp"
#include "solvers/solve.hpp"

namespace ikbench::experiments {

using results::LimitPolicy, results::Search, results::Start, results::BoundsPolicy, results::WristBranch,
    results::WristTurns, results::WrapPolicy;

struct Program;       // external/program.hpp
struct GivenAnswers;  // external/answers.hpp

// The treatment of a solver whose library this program was built without, or of a program that does not start.
enum class IfMissing {
  refuse,  // the study cannot be read
  skip     // the study is read without the solver, and lists it as skipped
};

// A solver entry of a study: a solver with its settings.
struct SolverEntry {
  std::string label;                            // unique in the study; name in tables and figures
  std::string solver;                           // registered name, or a program's own name
  solvers::Settings options;                    // only options that differ from the solver's defaults
  int population = 0;                           // 0: that of the study
  std::shared_ptr<const Program> program = {};  // null: the solver is built in
  IfMissing if_missing = IfMissing::refuse;
  // A solver that a user of these libraries defines, named `solver`; null: a registered solver. The file of the running
  // program counts as the source of such a solver, so after any change of the program everything is solved again.
  std::shared_ptr<const solvers::SolverInfo> custom = {};
  std::shared_ptr<const GivenAnswers> answers = {};  // made elsewhere; null: the solver runs here
  std::string colour = {};                           // in figures; empty: the default of the solver
  std::string sweep_base = {};                       // label of the swept entry that made this entry; empty: none
};

// The name of the solver of every entry whose answers were made elsewhere.
constexpr std::string_view elsewhere = "elsewhere";

// Returns the solver of an entry. The entry must not be of a program. Throws std::invalid_argument for an unknown name.
const solvers::SolverInfo& solver_info(const SolverEntry& entry);

// A solver that a study is read without, because its library or program is missing.
struct SkippedSolver {
  std::string label;
  std::string reason;  // "not built: ..."
};

// A solver whose answers are made elsewhere and are not there yet, or are to other targets.
struct AwaitedSolver {
  std::string label;
  std::string file;         // where the study looks for the answers
  std::string reason = {};  // which answer is to another target; empty: there is no file
};

// A study with all that is made of its settings: the arm, the path, the solvers.
struct Study : results::StudySpec {
  std::shared_ptr<const Robot> robot_of_file;  // the arm in the file `robot`; null: the arm is built in
  robots::UrdfChoice urdf;                     // for a URDF file
  Path path = target_sets().front();
  Eigen::VectorXd initial;  // [rad, m], all joints; the arm before the first point of a run
  solvers::Trace trace = solvers::Trace::none;
  std::vector<SolverEntry> solvers;
  std::shared_ptr<const Program> checker;  // the check of answers that reached their target; null: none
  std::vector<SkippedSolver> skipped;      // solvers that were left out
  std::vector<AwaitedSolver> awaited;      // solvers that the study is read without
  std::vector<std::string> notes;          // sentences on settings that were not taken as they stand
};

std::vector<std::string> labels_of(const Study& study);  // labels of all solvers
// Returns the labels that the study's file has, also of solvers whose answers are not there yet.
std::vector<std::string> labels_in_file(const Study& study);

// Returns the kind of goal that a search has.
solvers::GoalKind goal_kind(Search search);

// Returns the study's arm. Throws std::invalid_argument if no arm has that name.
Robot robot_of(const Study& study);

// Returns the unit of each joint in files: a degree [rad] for a revolute joint, a metre [m] for a prismatic one.
Configuration joint_units(const robots::Chain& arm);

// Returns the defaults of the entry's solver with these settings applied. Throws std::invalid_argument as
// OptionList::set does.
solvers::Settings entry_options(const SolverEntry& entry, const solvers::Settings& settings);
// Returns the options that an entry's solver is made with: its defaults, the study's bounds, then its own options.
solvers::Settings effective_options(const Study& study, const SolverEntry& entry);
// Returns the number of candidates per iteration: the entry's, or the study's if the entry has none.
int effective_population(const Study& study, const SolverEntry& entry);

// Returns the targets of a run (from 1), the same for all solvers. Only random targets differ between runs. Targets of
// a longer run begin with those of a shorter one. `arm` is robot_of(study); callers of many runs make it once.
std::vector<Pose> targets_of_run(const Study& study, const Robot& arm, int run);
std::vector<Pose> targets_of_run(const Study& study, int run);

// Returns the initial configuration [rad, m] of a study that gives none: zeros, or the nearest values inside the
// limits.
Configuration default_configuration(const Robot& arm);

// Returns the starts [rad, m] of a run's solves, the same for all solvers. Empty for Start::previous and
// Start::initial.
std::vector<Configuration> starts_of_run(const Study& study, const Robot& arm, int run);

// A target that no configuration can reach, because it is farther from the shoulder than the arm is long. Distance and
// reach are those of the wrist's centre if the study searches for that.
struct UnreachableTarget {
  int point;        // from 1
  double distance;  // [m]
  double reach;     // [m]
};
// Returns the unreachable targets of a run; none for a path that draws targets, or that leaves them out.
std::vector<UnreachableTarget> unreachable_targets(const Study& study);

// A share of a study's solves, so that several machines can solve a study side by side.
// The work units of a study are its runs, or, if no solve starts from the previous answer, the single targets of every
// run. All solvers solve a unit on one machine, so that they can be compared. Shard I of N has the units I, I + N,
// I + 2N, ...: more runs leave each unit where it is.
struct Shard {
  int index = 1;  // I, from 1
  int count = 1;  // N

  std::string text() const;  // "I/N"
};

// Reads "I/N", with 1 <= I <= N <= 100000. Throws std::invalid_argument for anything else.
Shard parse_shard(std::string_view text);

bool is_in_shard(Shard shard, const Study& study, int run, int point);
std::int64_t work_unit_count(const Study& study);
std::int64_t planned_solve_count(Shard shard, const Study& study);  // of all solvers

}  // namespace ikbench::experiments
