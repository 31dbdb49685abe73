// The fields of a study, said once: name, field, range, meaning, and whether it decides no number of a solve. What
// reads and writes studies (table_reader.hpp, study_writer.cpp) and the key of a series (series_key.cpp) follow this
// list, so that an option of a study is a member in study.hpp and an entry here. The fields of its analysis plan are in
// results/analysis_plan_fields.hpp.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "experiments/fields.hpp"
#include "experiments/study.hpp"
#include "results/analysis_plan_fields.hpp"
#include "numerics/units.hpp"

namespace ikbench::experiments {

inline void list_fields(Fields& io, solvers::StopRule& stop) {
  io.whole("iterations", stop.iterations, {0, 1'000'000'000}, "iterations at most", InKey::in_text);
  io.number("tolerance_cm", stop.tolerance, numerics::centimetre, {0, 1e6}, "position error at which a solve ends; 0: none",
            InKey::in_text);
  io.whole("evaluations", stop.evaluations, {0, no_limit}, "evaluations after which a solve ends; 0: no such rule",
           InKey::in_text);
  io.number("seconds", stop.seconds, 1, {0, 1e6},
            "wall time after which a solve ends, and numbers depend on the machine; 0: no such rule", InKey::in_text);
}

// In the order of the variant.
inline const Choices<Path> path_kinds{
    {"helix", Helix{}}, {"circle", Circle{}}, {"random", RandomTargets{}}, {"poses", std::vector<robots::Pose>{}}};

inline const std::string& kind_of(const Path& path) { return path_kinds[path.index()].first; }

constexpr std::pair<std::int64_t, std::int64_t> point_counts{1, 100'000}, populations{1, 100'000};

inline void list_tool(Fields& io, Tool& tool) {
  io.choice("tool", tool, Choices<Tool>{{"down", Tool::down}, {"eq27", Tool::eq27}},
            "how the tool is held: straight down, or as Eq. 27 prints it (horizontal)");
}

inline void list_fields(Fields& io, Helix& helix) {
  io.number("length_cm", helix.length, numerics::centimetre, {-1e6, 1e6}, "rise along z");
  io.number("turns", helix.turns, 1, {-1e3, 1e3}, "");
  io.numbers("centre_cm", helix.centre, numerics::centimetre, 3, "centre of the bottom");
  io.number("radius_cm", helix.radius, numerics::centimetre, {0, 1e6}, "");
  io.number("start_deg", helix.start, numerics::degree, {-1e5, 1e5}, "angle t of the first point");
  io.whole("points", helix.points, point_counts, "");
  io.choice("phase", helix.phase, Choices<Phase>{{"sin_cos", Phase::sin_cos}, {"cos_sin", Phase::cos_sin}},
            "(x, y) from the centre: radius (sin t, cos t), or radius (cos t, sin t)");
  io.choice("spacing", helix.spacing,
            Choices<Spacing>{{"k_over_n", Spacing::k_over_n}, {"k_over_n_minus_1", Spacing::k_over_n_minus_1}},
            "point k = 0 ... n - 1 lies at this fraction of the path");
  list_tool(io, helix.tool);
}

inline void list_fields(Fields& io, Circle& circle) {
  io.numbers("centre_cm", circle.centre, numerics::centimetre, 3, "");
  io.number("radius_cm", circle.radius, numerics::centimetre, {0, 1e6}, "");
  io.whole("points", circle.points, point_counts,
           "point k = 0 ... n - 1 is the centre + radius (cos t, sin t, 0) with t = 360 k/n deg");
  list_tool(io, circle.tool);
}

inline void list_fields(Fields& io, RandomTargets& drawn) {
  io.whole("points", drawn.points, point_counts,
           "each the tool's pose at joint angles uniform within the limits, drawn from seed and run");
}

inline void list_fields(Fields& io, std::vector<robots::Pose>& poses) { io.poses("poses", poses, ""); }

inline void list_fields(Fields& io, Study& study) {
  io.text("name", study.name, "folder of its results: out/<name>/", InKey::no);
  io.text("title", study.title, "", InKey::no);
  io.text("published", study.published, "paper whose printed tables are set beside the results; \"\": none", InKey::no);
  io.text("robot", study.robot, "see: ikbench list robots", InKey::in_text);
  io.choice("search", study.search, Choices<Search>{{"wrist", Search::wrist}, {"all_joints", Search::all_joints}},
            "wrist: the joints before a spherical wrist, which follows in closed form; all_joints: position only",
            InKey::in_text);
  io.choice(
      "bounds", study.bounds,
      Choices<StudyBounds>{
          {"per_solver", StudyBounds::per_solver}, {"initial", StudyBounds::initial}, {"clamp", StudyBounds::clamp}},
      "joint limits of candidates: each solver's own option, or one reading for all that have it", InKey::in_text);
  io.choice("wrist_branch", study.wrist_branch,
            Choices<WristBranch>{{"nearest", WristBranch::nearest},
                                 {"positive", WristBranch::positive},
                                 {"negative", WristBranch::negative},
                                 {"inside", WristBranch::inside}},
            "which of the wrist's two branches completes an answer", InKey::in_text);
  io.choice("limits", study.limits, Choices<Limits>{{"recorded", Limits::recorded}, {"enforced", Limits::enforced}},
            "answers outside the joint limits are kept and told; or candidates are clamped, the wrist takes a branch "
            "inside, and an answer outside is refused: the arm stays where it was");
  io.choice("start", study.start, Choices<Start>{{"previous", Start::previous}, {"initial", Start::initial}},
            "a solve starts where the one before it left the arm, or each at initial_deg");
  io.numbers("initial_deg", study.initial, numerics::degree, 0, "configuration before the first point of a run", InKey::in_text);
  io.whole("population", study.population, populations,
           "candidates an iteration; an entry of [[solvers]] may have its own", InKey::in_text);
  io.whole("runs", study.runs, {1, 1'000'000}, "independent repetitions", InKey::no);
  io.whole("seed", study.seed, {0, no_limit}, "", InKey::in_text);
  io.choice("trace", study.trace, Choices<solvers::Trace>{{"none", solvers::Trace::none}, {"best_error", solvers::Trace::best_error}},
            "best error after every iteration, kept in the store", InKey::in_text);
}

}  // namespace ikbench::experiments
