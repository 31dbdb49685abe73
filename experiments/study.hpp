// A study is data: the problems, the solvers, the number of repetitions, the seed.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/path.hpp"
#include "results/study.hpp"
#include "robots/robot.hpp"
#include "solvers/options.hpp"
#include "solvers/registry.hpp"
#include "solvers/solve.hpp"

namespace ikbench::experiments {

using results::Limits, results::Search, results::Start, results::StudyBounds, results::WristBranch, results::WristTurns,
    results::Wrap;

struct Program;  // foreign/program.hpp

// The treatment of a solver whose library this program was built without, or of a program that does not start: refuse
// the study, or leave the solver out and say so.
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
  std::string family = {};  // the label of the entry with lists that this is one of; empty: none
};

// The solver of an entry that is no program.
const solvers::SolverInfo& info_of(const SolverEntry& entry);

struct LeftOut {
  std::string label;
  std::string why;  // "not built: ..."
};

// What is asked, with what is made of it: the arm, the path, the solvers.
struct Study : results::StudyData {
  std::shared_ptr<const Robot> robot_of_file;  // the arm in the file `robot`; null: the arm is built in
  robots::UrdfChoice urdf;                     // for a URDF file
  Path path = paths().front();
  Eigen::VectorXd initial;  // [rad], all joints; the arm before the first point of a run
  solvers::Trace trace = solvers::Trace::none;
  std::vector<SolverEntry> solvers;
  std::shared_ptr<const Program> checker;  // of answers that reached; null: there is no check
  std::vector<LeftOut> left_out;
  std::vector<std::string> notes;  // what of it was not taken as it stands
};

std::vector<std::string> labels_of(const Study& study);  // of its solvers

solvers::GoalKind goal_kind(Search search);

// The study's arm; std::invalid_argument if there is none of that name.
Robot arm_of(const Study& study);

// The unit of each joint outside the program: degrees, or metres if the joint slides.
Configuration joint_units(const robots::Chain& arm);

// The defaults of the entry's solver with these settings applied. Throws std::invalid_argument as OptionList::set does.
solvers::Settings options_with(const SolverEntry& entry, const solvers::Settings& settings);
// The options that an entry's solver is made with: its defaults, the study's bounds, then its own options.
solvers::Settings effective_options(const Study& study, const SolverEntry& entry);
int effective_population(const Study& study, const SolverEntry& entry);

// The targets of a run, the same for all solvers. Only random targets differ between runs; those of a longer run begin
// with those of a shorter one. `arm` is arm_of(study), which reads and checks a file.
std::vector<Pose> targets(const Study& study, const Robot& arm, int run);
std::vector<Pose> targets(const Study& study, int run);

// Zeros, or the nearest that the limits allow: the initial configuration where the study says none.
Configuration nearest_to_zero(const Robot& arm);

// The starts of a run's solves, the same for all solvers; none for Start::previous and Start::initial.
std::vector<Configuration> starts(const Study& study, const Robot& arm, int run);

// A target that certainly no configuration reaches, by its distance from the shoulder (to the wrist's centre, if that
// is searched).
struct Unreachable {
  int point;        // from 1
  double distance;  // [m]
  double reach;     // [m]
};
std::vector<Unreachable> unreachable(const Study& study);

// A share of a study's solves, so that several machines can solve it side by side.
//
// The parts of a study are its runs, or, if no solve starts from the previous answer, the single targets of every run.
// All solvers solve a part on one machine, so that they can be compared. Shard I of N has the parts I, I + N, I + 2N,
// ...: more runs leave each part where it is.
struct Shard {
  int index = 1;  // I, from 1
  int count = 1;  // N

  std::string text() const;  // "I/N"
};

// Reads "I/N"; throws std::invalid_argument for anything else.
Shard shard_from(std::string_view text);

bool contains(Shard shard, const Study& study, int run, int point);
std::int64_t parts_of(const Study& study);
std::int64_t solves_of(Shard shard, const Study& study);  // by all solvers

}  // namespace ikbench::experiments
