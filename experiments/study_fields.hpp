// The fields of a study, listed once: name, member, range, meaning, and whether it decides a number of a solve. Readers
// and writers of studies (study_reader.cpp, study_writer.cpp) follow this list, and so does the key of a series. A new
// option of a study is a member in study.hpp and an entry here. The fields of a path are in paths/, those of the
// analysis plan in results/plan.hpp.
#pragma once

#include <cstdint>
#include <utility>

#include "experiments/study.hpp"
#include "numerics/fields.hpp"
#include "numerics/units.hpp"
#include "results/plan.hpp"

namespace ikbench::experiments {

inline void list_fields(Fields& io, solvers::StopRule& stop) {
  io.whole("iterations", stop.iterations, {0, 1'000'000'000}, "maximum number of iterations, 200 unless given",
           InKey::in_text);
  io.number("tolerance_cm", stop.tolerance, numerics::centimetre, {0, 1e6},
            "a solve stops at this position error; 0: no tolerance", InKey::in_text);
  io.number(
      "tolerance_deg", stop.angle_tolerance, numerics::degree, {0, 180},
      "with search = \"pose\" or \"axis\": a solve stops where the tool, or its z axis, is also turned no further than "
      "this from its target; 0: no tolerance");
  io.whole("evaluations", stop.evaluations, {0, numerics::no_limit}, "maximum number of evaluations; 0: no maximum",
           InKey::in_text);
  io.number("seconds", stop.seconds, 1, {0, 1e6},
            "maximum wall time of a solve; results then depend on the machine; 0: no maximum", InKey::in_text);
}

inline void list_fields(Fields& io, Path& path) { path->list_fields(io); }

// The key has the chain and the limits that result from these.
inline void list_fields(Fields& io, robots::UrdfChoice& urdf) {
  using Which = robots::UrdfChoice::Limits;
  io.text("base", urdf.base, "link from which the arm is read; \"\": the root, behind joints that float",
          InKey::in_text);
  io.text("tip", urdf.tip, "link to which it is read, the tool; \"\": the end with the most moving joints before it",
          InKey::in_text);
  io.choice("limits", urdf.limits, Choices<Which>{{"hard", Which::hard}, {"soft", Which::soft}},
            "hard: the joints' <limit>; soft: the tighter of it and <safety_controller>", InKey::in_text);
  io.number(
      "snap_deg", urdf.snap, numerics::degree, {0, 1},
      "angles this near a multiple of 15 deg, and axes this near parallel, are meant to be it: up to 0.001 only if "
      "the printed digits may mean it",
      InKey::in_text);
}

constexpr std::pair<std::int64_t, std::int64_t> populations{1, 100'000};

inline void list_fields(Fields& io, Study& study) {
  io.text("name", study.name, "results go to out/<name>/; default: the name of the file", InKey::no);
  io.text("title", study.title, "", InKey::no);
  io.text("published", study.published, "compare the results with the printed tables of this paper; \"\": none",
          InKey::no);
  io.text("robot", study.robot,
          "a name from ikbench list robots, or a file beside the study: \"my_arm.toml\", \"my_arm.urdf\"",
          InKey::in_text);
  io.choice(
      "search", study.search,
      Choices<Search>{{"wrist", Search::wrist},
                      {"all_joints", Search::all_joints},
                      {"pose", Search::pose},
                      {"axis", Search::axis},
                      {"flange", Search::flange}},
      "wrist: search the joints before the spherical wrist and solve the wrist in closed form; all_joints: search all "
      "joints for the position alone; pose: search all joints for position and orientation; axis: for the position and "
      "the direction of the tool's z axis; flange: search all but the last, which only turns the tool, for the "
      "position alone",
      InKey::in_text);
  io.number(
      "rotation_weight_m", study.rotation_weight, 1, {0.001, 10},
      "with search = \"pose\" or \"axis\": the error that solvers reduce is the root mean square distance of three "
      "points of the tool, its own and those this far along its x and y axes, or along its z axis both ways");
  io.choice(
      "bounds", study.bounds,
      Choices<StudyBounds>{
          {"per_solver", StudyBounds::per_solver}, {"initial", StudyBounds::initial}, {"clamp", StudyBounds::clamp}},
      "joint limits of candidates: as each solver's own option says, or the same for all solvers with that option",
      InKey::in_text);
  io.choice("wrist_branch", study.wrist_branch,
            Choices<WristBranch>{{"nearest", WristBranch::nearest},
                                 {"positive", WristBranch::positive},
                                 {"negative", WristBranch::negative},
                                 {"inside", WristBranch::inside}},
            "which of the two wrist branches completes an answer", InKey::in_text);
  io.choice(
      "wrist_turns", study.wrist_turns,
      Choices<WristTurns>{{"principal", WristTurns::principal}, {"nearest", WristTurns::nearest}},
      "the wrist's angles lie within half a turn of 0, or they are turned by whole turns to where they move least");
  io.choice(
      "limits", study.limits, Choices<Limits>{{"recorded", Limits::recorded}, {"enforced", Limits::enforced}},
      "recorded: answers outside the joint limits are kept and reported; enforced: candidates are clamped, the wrist "
      "takes a branch inside the limits, and an answer outside is refused, so the arm stays where it was");
  io.choice(
      "wrap", study.wrap, Choices<Wrap>{{"no", Wrap::no}, {"into_limits", Wrap::into_limits}},
      "into_limits: after a solve, joints outside their limits are turned back inside by whole turns where that is "
      "possible, for every solver; the pose stays");
  io.choice("start", study.start,
            Choices<Start>{{"previous", Start::previous},
                           {"initial", Start::initial},
                           {"middle", Start::middle},
                           {"random", Start::random},
                           {"near", Start::near}},
            "a solve starts where the previous one left the arm, at initial_deg, in the middle of the joint limits, at "
            "random within them, or near a solution of a random target");
  io.number("near_deg", study.near, numerics::degree, {0, 360},
            "with start = \"near\": largest distance of each joint that turns from that solution");
  io.numbers("initial_deg", study.initial, 1, 0,
             "configuration before the first point of a run: degrees, and metres for a joint that slides",
             InKey::in_text);
  io.whole("population", study.population, populations, "candidates per iteration; a solver can override it",
           InKey::in_text);
  io.whole("runs", study.runs, {1, 1'000'000}, "independent repetitions", InKey::no);
  io.whole(
      "repeats", study.repeats, {1, 1000},
      "how often each solve is timed; its time is the median. 1 with --jobs above 1, stop.seconds or a debug build",
      InKey::no);
  io.whole("seed", study.seed, {0, numerics::no_limit}, "seed of all random numbers", InKey::in_text);
  io.choice("trace", study.trace,
            Choices<solvers::Trace>{{"none", solvers::Trace::none}, {"best_error", solvers::Trace::best_error}},
            "whether to store the best error after every iteration", InKey::in_text);
}

}  // namespace ikbench::experiments
