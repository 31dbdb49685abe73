// A study as plain data: what is asked, as study files say it and the store keeps it (JSON), and what judging needs of
// its arm and targets. `experiments` makes it from a study file; `analysis` reads it from the store and needs no
// solver.
#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/fields.hpp"
#include "base/units.hpp"
#include "numerics/stop_rule.hpp"
#include "results/figure_style.hpp"
#include "results/record.hpp"
#include "results/requirement.hpp"

namespace ikbench::base {
class TomlReader;
}

namespace ikbench::results {

// The metrics that `tie_breakers` of a plan may name, in any order. The headline goes on to the first of those that is
// judged.
inline const std::vector<std::string> default_tie_breakers{"time", "evaluations", "motion"};

// The rules by which a study is judged, fixed before its data. They decide no number of a solve.
struct AnalysisPlan {
  enum class Test { ranks, means } test = Test::ranks;
  enum class Values { runs, points } values = Values::runs;  // along a path: means over its points, or over the runs
  std::string metric = {};  // of the headline; empty: solved if any target is solved, otherwise the error
  std::vector<std::string> tie_breakers = {"time", "evaluations"};  // for solvers that the metric does not separate
  std::string control = {};                                         // compares only with this group; empty: all pairs
  double significance = 0.05;
  double margin = 0.05;  // smallest difference that matters: a ratio outside 1 / 1.05 to 1.05; for shares, points
  double deadline = 0;   // [s] per solve; what is solved within it is a metric; 0: the loop's period, if any

  bool operator==(const AnalysisPlan&) const = default;
};

constexpr std::pair<double, double> margin_percent_range{0, 99};

// Lists the fields once for study files, the store's JSON and the command line: name, member, range and meaning.
inline void list_fields(base::Fields& io, AnalysisPlan& plan) {
  constexpr double percent = 0.01;
  io.choice("test", plan.test, {"ranks", "means"}, "what is compared: ranks, or means, as in papers");
  io.choice(
      "values", plan.values, {"runs", "points"},
      "with start = \"previous\", what counts as one value: a run, by the mean of its points, or a point, by the mean of "
      "its runs");
  io.text(
      "metric", plan.metric,
      "metric that decides which solver is best (ikbench list metrics); \"\": solved if any target is solved, otherwise the "
      "error");
  io.texts(
      "tie_breakers", plan.tie_breakers,
      "tie-breakers, out of time, evaluations and motion: if solved does not separate the best solvers, the headline "
      "compares them by the first of these that is compared at all; []: none. The metric and the tie-breakers share "
      "the significance and decide the exit code of compare");
  io.text("control", plan.control, "label to compare the others with; \"\": compare every pair");
  io.number("significance", plan.significance, 1, {0.0001, 0.2},
            "significance level of all tests together, in the metrics that the plan names");
  io.number(
      "margin_percent", plan.margin, percent, margin_percent_range,
      "smallest relative difference that matters (for shares: in percentage points); within it two solvers are the same");
  io.number("deadline_ms", plan.deadline, 0.001, {0, 1e6},
            "reports what is solved within this time; 0: within loop.period_ms, if there is one");
}

// A control loop along a path, where each solve has a period. It decides no number of a solve.
struct ControlLoop {
  double period = 0;  // [s]; 0: no loop
};
inline void list_fields(base::Fields& io, ControlLoop& loop) {
  io.number(
      "period_ms", loop.period, 0.001, {0, 1e6},
      "for a path with start = \"previous\": reports solves that take longer, and steps for which a joint is too slow; "
      "0: no loop");
}

// A program of the user that says which answers are valid. It is asked only about answers that reached their target.
struct AnswerCheck {
  std::vector<std::string> larger = {}, smaller = {};  // names of its numbers, by the direction that is better
  std::vector<std::string> process = {};               // empty: there is no check
  std::string digest = {};                             // hash of its program, a part of the series' key; not stored

  std::vector<std::string> numbers() const {
    std::vector<std::string> all = larger;
    all.insert(all.end(), smaller.begin(), smaller.end());
    return all;
  }
  bool operator==(const AnswerCheck&) const = default;
};
inline void list_fields(base::Fields& io, AnswerCheck& check) {
  io.texts("larger", check.larger, "numbers that it gives for every answer, of which larger ones are better");
  io.texts("smaller", check.smaller, "the same, of which smaller ones are better");
}

// The joints that a solver searches, and for what.
// wrist: the joints before a spherical wrist, for the position; the wrist's angles follow in closed form (Eqs. 15-17).
// all_joints: all joints, for the position only.
// flange: all but the last joint, which turns the tool about its own point and stays where it is; for the position.
// pose: all joints, for position and orientation.
// axis: all joints, for the position and the direction of the tool's z axis.
enum class Search { wrist, all_joints, pose, axis, flange };

// The rule that picks one of the wrist's two branches for an answer. With enforced limits, a branch outside always
// gives way to one inside.
// nearest: the branch with the smaller move.
// positive, negative: the branch with this sign of the middle joint.
// inside: the nearer of the branches inside the joint limits, or the nearer of both if none is inside.
enum class WristBranch { nearest, positive, negative, inside };

// The whole turns of the wrist's angles.
// principal: angles of the arc tangent, in [-180, 180] deg.
// nearest: angles turned by whole turns to where they move least.
enum class WristTurns { principal, nearest };

// The joint limits of candidates: as each solver's own option says, or the same for all solvers with that option.
enum class BoundsPolicy { per_solver, initial, clamp };

// The joint limits of answers.
// recorded: an answer outside is kept and reported.
// enforced: limits hold for every solver and for the wrist; an answer outside is refused, and the arm stays where it
// was.
enum class LimitPolicy { recorded, enforced };

// The whole turns by which revolute joints of an answer are turned afterwards. No pose changes.
// into_limits: back inside the limits, where possible.
// nearest: to the whole turn inside the limits that is nearest to the start, as controllers do.
enum class WrapPolicy { no, into_limits, nearest };

// The start of each solve of a run: the previous answer, the initial configuration, the middle of the limits, a
// configuration drawn from seed, run and point, or one near the configuration that the target was made of.
enum class Start { previous, initial, middle, random, near };

// The state in which a timed call begins.
// first: the first call on its target, after other solvers' work, as in a program that does other things.
// warm: the second call on its target, with warm caches, as in a loop over many targets. A program makes both in its
// process, because its caches are cold behind each message.
enum class CacheState { first, warm };

// The names as in files, in the order of the enumerators.
constexpr std::array<std::string_view, 5> names_of(Search) { return {"wrist", "all_joints", "pose", "axis", "flange"}; }
constexpr std::array<std::string_view, 3> names_of(BoundsPolicy) { return {"per_solver", "initial", "clamp"}; }
constexpr std::array<std::string_view, 2> names_of(LimitPolicy) { return {"recorded", "enforced"}; }
constexpr std::array<std::string_view, 5> names_of(Start) {
  return {"previous", "initial", "middle", "random", "near"};
}
constexpr std::array<std::string_view, 2> names_of(CacheState) { return {"first", "warm"}; }

// The place of a study in a sweep over keys of a study (`ikbench run --sweep near_deg=1,10`): the name of the sweep,
// and the key and value of each swept key. A study that is in no sweep has no name here. The place decides no number of
// a solve.
struct SweepPlace {
  std::string name = {};
  std::vector<std::pair<std::string, std::string>> values = {};  // in the order of the command

  // Returns the values for a column's head: "10", or "near_deg=10 robot=ur5e" if several keys are swept.
  std::string label() const;
};

// The settings of a study, as its file has them. docs/reference/study-file.md explains each.
struct StudySpec {
  std::string name = "study";
  std::string title;
  std::string published;              // paper whose printed tables are shown with the results, or empty
  std::string robot = "kuka_iiwa14";  // a built-in arm, or a file
  Search search = Search::wrist;
  // Weight of a radian in a pose error [m]. The error compares three points that are about as far apart as the parts of
  // a tool and of what it holds. With 0.1 m or 1 m, swarms find fewer poses of a UR5e.
  double rotation_weight = 0.25;
  BoundsPolicy bounds = BoundsPolicy::per_solver;
  WristBranch wrist_branch = WristBranch::nearest;
  WristTurns wrist_turns = WristTurns::principal;
  LimitPolicy limits = LimitPolicy::recorded;
  WrapPolicy wrap = WrapPolicy::no;
  int motion_joints = 0;
  Start start = Start::previous;
  double near = 5 * base::degree;  // [rad] for Start::near: largest distance of a joint from the solution
  int population = 50;
  int runs = 20;
  int rounds = 6;  // sessions; decides only times (experiments/runner.hpp)
  CacheState state = CacheState::first;
  std::uint64_t seed = 1;
  numerics::StopRule stop;
  ControlLoop loop;
  AnswerCheck check;
  AnalysisPlan plan;                           // decides no number of a solve
  std::vector<Requirement> requirements = {};  // [require]; decide no number of a solve
  FigureStyle figures;                         // colours of solver entries are in these entries of a study file
  SweepPlace sweep = {};                       // given by the command, not by a study file

  // Returns true if each solve begins where the last one left the arm.
  bool is_chained() const { return start == Start::previous; }
  bool has_direction() const { return search == Search::pose || search == Search::axis; }
  bool has_tolerance() const { return stop.tolerance > 0 || stop.angle_tolerance > 0; }
};

constexpr std::pair<std::int64_t, std::int64_t> population_range{1, 100'000};
constexpr std::size_t max_solvers = 400;  // per study, because its report has all pairs

// Lists the fields once: name, member, range, meaning, and whether each decides a number of a solve. Readers and
// writers of study files and of the store follow this list, and so does the key of a series. A new option of a study is
// a member above and an entry there. `stop`, `plan` and `figures` have lists of their own.
void list_fields(base::Fields& io, StudySpec& study);

// The plane of a study whose targets are a grid, and what was left out of it.
struct TargetGrid {
  // The tool's attitude at every place of the grid.
  // down: along minus the base's z axis.
  // directions: one after the other in `directions` directions within the plane.
  // zero: as at zero joint angles, since all axes of the arm are parallel.
  enum class Tool { down, directions, zero } tool = Tool::down;
  int directions = 1;                        // targets of a place, one after the other
  double step = 0;                           // [m]; 0: the targets are no grid
  std::vector<double> across = {}, up = {};  // unit vectors of the plane, in the base's frame
  std::vector<double> shoulder = {};         // [m] centre of the ball that the tool never leaves
  double reach = 0;                          // [m] its radius
  int left_out = 0;                          // targets in that ball that certainly no configuration reaches

  bool operator==(const TargetGrid&) const = default;
};

// Lists the fields for the store's JSON.
inline void list_fields(base::Fields& io, TargetGrid& grid) {
  constexpr std::int64_t max_directions = 360;
  io.choice("tool", grid.tool, {"down", "directions", "zero"});
  io.whole("directions", grid.directions, {1, max_directions});
  io.number("step_m", grid.step, 1, {0, 1e6});
  io.numbers("across", grid.across, 1, 0);
  io.numbers("up", grid.up, 1, 0);
  io.numbers("shoulder_m", grid.shoulder, 1, 0);
  io.number("reach_m", grid.reach, 1, {0, 1e6});
  io.whole("left_out", grid.left_out, {0, 100'000'000});
}

// A study as the store keeps it, with what judging needs of its arm and targets.
struct StudyDefinition : StudySpec {
  int points = 0;
  std::string path;                     // kind of the target set
  bool draws_targets = false;           // draws new targets for every run
  std::string base_link, tip_link;      // if the arm is from a URDF file
  std::vector<std::string> arm_notes;   // sentences on what was not taken from the file as it stands
  std::vector<std::string> departures;  // settings that differ from the published study
  // How far each joint can move in a period of the loop [rad, m], and whether it is continuous; empty without a loop.
  std::vector<std::pair<double, bool>> max_steps;
  int unreachable_targets = 0;  // targets that no configuration reaches
  TargetGrid grid;              // if the targets are a grid
  std::string arm;              // JSON, as robots/robot.hpp reads it
  std::string task;             // JSON: the initial configuration, and how targets are drawn
  std::string json;             // the whole definition, as the store has it

  // [s] within which a solve counts as in time; 0: there is none.
  double deadline() const { return plan.deadline > 0 ? plan.deadline : loop.period; }
  bool is_grid() const { return grid.step > 0; }
  // Returns "tool down, plane y = 0, steps of 5 cm"; only for a grid.
  std::string grid_text() const;
  // Returns true if values are means of runs, otherwise of targets.
  bool compares_runs() const {
    return is_chained() ? plan.values == AnalysisPlan::Values::runs : points == 1 && !draws_targets;
  }
};

// Thrown for a definition that an earlier version wrote, and that this version cannot read.
struct FormerDefinition : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

// Reads [require]: "solved" = "95%", or a table per solver. Throws std::invalid_argument with the place of a mistake.
std::vector<Requirement> read_requirements(const base::TomlReader& require);
// Returns why a study has no share of this slug, as a sentence without a full stop; empty if it has.
std::string lack_of_share(const StudySpec& study, std::string_view slug);
// Reads a definition. Members that the text lacks keep their defaults. Throws std::invalid_argument if the text is no
// JSON object, or if a value is impossible; the message has the study's name and the member.
StudyDefinition parse_definition(std::string_view json);
// Returns the definition in a JSON `document` whose text is `json`, and throws as above.
StudyDefinition definition_of(const nlohmann::json& document, std::string json);

}  // namespace ikbench::results
