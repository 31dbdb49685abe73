#include "results/study.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "base/json.hpp"
#include "base/names.hpp"
#include "base/toml_table.hpp"
#include "base/units.hpp"

namespace ikbench::results {

using namespace base;

void list_fields(base::Fields& io, StudySpec& study) {
  io.text("name", study.name, {"results go to out/<name>/; default: the name of the file", base::InKey::no});
  io.text("title", study.title, {"", base::InKey::no});
  io.text("published", study.published,
          {"compare the results with the tables of this paper; \"\": none", base::InKey::no});
  io.text("robot", study.robot,
          {"a name from ikbench list robots, or a file beside the study: \"my_arm.toml\", \"my_arm.urdf\"",
           base::InKey::in_text});
  io.choice(
      "search", study.search, names_of(study.search),
      {"wrist: search the joints before the spherical wrist and solve the wrist in closed form; all_joints: search all "
       "joints, for the position only; pose: search all joints, for position and orientation; axis: for the position and "
       "the direction of the tool's z axis; flange: search all but the last joint, which only turns the tool, for the "
       "position only",
       base::InKey::in_text});
  io.number(
      "rotation_weight_m", study.rotation_weight, 1, {0.001, 10},
      "with search = \"pose\" or \"axis\": the error that solvers reduce is the root mean square distance of three "
      "points of the tool, its own and those this far along its x and y axes, or along its z axis both ways");
  io.choice(
      "bounds", study.bounds, names_of(study.bounds),
      {"joint limits of candidates: as each solver's own option says, or the same for all solvers with that option",
       base::InKey::in_text});
  io.choice("wrist_branch", study.wrist_branch, {"nearest", "positive", "negative", "inside"},
            {"which of the two wrist branches completes an answer", base::InKey::in_text});
  io.choice(
      "wrist_turns", study.wrist_turns, {"principal", "nearest"},
      "the wrist's angles lie within half a turn of 0, or they are turned by whole turns to where they move least");
  io.choice(
      "limits", study.limits, names_of(study.limits),
      "recorded: answers outside the joint limits are kept and reported; enforced: an answer outside is refused, so "
      "the arm stays where it was; solvers with bounds = \"initial\" by default clamp candidates; the wrist takes a "
      "branch inside the limits");
  io.choice(
      "wrap", study.wrap, {"no", "into_limits", "nearest"},
      "into_limits: after a solve, joints outside their limits are turned back inside by whole turns where that is "
      "possible, for every solver; nearest, the default with search = \"pose\": all joints, to where they are nearest to "
      "the start; the pose stays");
  io.whole(
      "motion_joints", study.motion_joints, {0, 64},
      "joint motion [deg] counts only this number of joints, from the first (the largest displacement counts all); 0: all");
  io.choice("start", study.start, names_of(study.start),
            "a solve starts at the previous answer, at initial_deg, in the middle of the joint limits, at "
            "random within them, or near a solution of a random target");
  io.number("near_deg", study.near, base::degree, {0, 360},
            "with start = \"near\": largest distance of each revolute joint from that solution");
  io.whole("population", study.population, population_range,
           {"candidates per iteration; a solver can override it", base::InKey::in_text});
  io.whole("runs", study.runs, {1, 1'000'000}, {"independent repetitions", base::InKey::no});
  io.whole("rounds", study.rounds, {1, 1000},
           {"sessions in which all solvers solve a share of the runs or targets, in new processes and another order: "
            "times are compared over them, from 4 on; at most one for each run or target",
            base::InKey::no});
  io.choice("state", study.state, names_of(study.state),
            "which call on a target is timed, if solves do not start from the previous answer: the first, after other "
            "solvers' work; warm: the second");
  io.whole("seed", study.seed, {0, base::no_limit}, {"seed of all random numbers", base::InKey::in_text});
}

std::string SweepPlace::label() const {
  if (values.size() == 1) return values.front().second;
  std::string text;
  for (const auto& [key, value] : values) text += fmt::format("{}{}={}", text.empty() ? "" : " ", key, value);
  return text;
}

namespace {

// Reads the place of a study in a sweep.
void read_sweep(base::TomlReader reader, SweepPlace& place) {
  constexpr std::size_t max_keys = 10;
  reader.text("name", place.name);
  if (place.name.empty()) return;
  for (const toml::table* const value : reader.tables("values", max_keys, "the swept keys")) {
    base::TomlReader fields = reader.nested(*value, "sweep.values.");
    auto& [key, text] = place.values.emplace_back();
    fields.text("key", key);
    fields.text("value", text);
  }
}

// Refuses a stored table in which a key has its former name, because the key would count as one that is not given.
// Other renamed keys are refused by their readers.
void refuse_former_keys(const toml::table& table, std::string_view source) {
  for (const auto& [key, node] : table) {
    if (const std::string now = base::renaming(key.str(), {"rounds", "tie_breakers"}); !now.empty())
      throw FormerDefinition(fmt::format("{}: {}", source, now));
  }
}

// Reads the grid of the targets. Throws std::invalid_argument for a plane without its vectors.
void read_grid(base::TomlReader reader, StudyDefinition& study) {
  constexpr int dimensions = 3;
  list_fields(reader, study.grid);
  for (const std::vector<double>* vector : {&study.grid.across, &study.grid.up, &study.grid.shoulder}) {
    if (study.is_grid() && std::ssize(*vector) != dimensions)
      throw std::invalid_argument(fmt::format("study {}: the plane of the grid lacks a vector", study.name));
  }
}

}  // namespace

std::vector<Requirement> read_requirements(const base::TomlReader& require) {
  std::vector<Requirement> requirements;
  const auto read = [&](const toml::key& key, const toml::node& node, const std::string& prefix) {
    const auto value = node.value<std::string>();
    if (!value) require.fail(key.str(), node, "a share in quotes, such as \"95%\"");
    try {
      requirements.push_back(parse_requirement(fmt::format("{}{}={}", prefix, key.str(), *value)));
    } catch (const std::invalid_argument& error) {
      throw require.mistake(key.str(), error.what());
    }
  };
  for (const auto& [key, node] : require.table()) {
    if (const toml::table* const of_solver = node.as_table())
      for (const auto& [metric, share] : *of_solver) read(metric, share, std::string(key.str()) + '.');
    else
      read(key, node, "");
  }
  return requirements;
}

namespace {

// Returns "plane y = 0".
std::string plane_text(const TargetGrid& grid) {
  const std::vector<double>&x = grid.across, &y = grid.up;
  const std::array<double, 3> normal{x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    constexpr double nearly = 1 - 1e-9;
    const bool is_in_base = std::abs(grid.shoulder[axis]) < 1e-5 * grid.reach;  // up to the digits of an arm's file
    const double at = is_in_base ? 0 : grid.shoulder[axis];
    if (std::abs(normal[axis]) > nearly)
      return fmt::format("plane {} = {:.3g}{}", "xyz"[axis], at, at == 0 ? "" : " m");
  }
  return fmt::format("plane through the shoulder, normal to ({:.2g}, {:.2g}, {:.2g})", normal[0], normal[1], normal[2]);
}

}  // namespace

std::string StudyDefinition::grid_text() const {
  std::string tool;
  if (has_direction() && grid.tool == TargetGrid::Tool::down) tool = "tool down, ";
  if (has_direction() && grid.tool == TargetGrid::Tool::zero) tool = "tool as at zero joint angles, ";
  if (grid.tool == TargetGrid::Tool::directions)
    tool = grid.directions == 8 ? "eight directions of the tool, "
                                : fmt::format("{} directions of the tool, ", grid.directions);
  return fmt::format("{}{}, steps of {:.4g} cm", tool, plane_text(grid), grid.step / base::centimetre);
}

std::string lack_of_share(const StudySpec& study, std::string_view slug) {
  const bool is_in_time = slug == "in-time";
  if (is_in_time && study.stop.only_time_limits()) return "in-time is not reported with --limit; expected solved";
  if (is_in_time && study.plan.deadline == 0 && study.loop.period == 0)
    return "in-time needs a study with analysis.deadline_ms or loop.period_ms";
  if (!is_in_time && !study.has_tolerance()) return "solved needs a study with a tolerance (stop.tolerance_cm)";
  return "";
}

StudyDefinition parse_definition(std::string_view json) {
  return definition_of(base::parsed_json(json), std::string(json));
}

StudyDefinition definition_of(const base::Json& document, std::string json) {
  if (!document.is_object()) throw std::invalid_argument("the definition of a study is not a JSON object");
  const toml::table table = base::toml_of(document);
  const std::string source = fmt::format("study {}", table["name"].value_or("without a name"));
  refuse_former_keys(table, source);
  if (table["analysis"].is_table()) refuse_former_keys(*table["analysis"].as_table(), source);
  base::TomlReader reader(table, source, "");
  base::TomlReader path = reader.part("path"), stop = reader.part("stop"), reach = reader.part("unreachable_targets"),
                   figures = reader.part("figures"), colours = figures.part("colours"),
                   analysis = reader.part("analysis"), arm = reader.part("arm"), loop = reader.part("loop"),
                   check = reader.part("check");
  constexpr std::pair<std::int64_t, std::int64_t> counts{0, std::numeric_limits<int>::max()};
  StudyDefinition study;
  study.json = std::move(json);
  list_fields(reader, study);
  list_fields(stop, study.stop);
  list_fields(loop, study.loop);
  list_fields(check, study.check);
  check.texts("process", study.check.process);
  list_fields(analysis, study.plan);
  study.requirements = read_requirements(reader.part("require"));
  list_fields(figures, study.figures);
  read_sweep(reader.part("sweep"), study.sweep);
  for (const auto& [label, node] : colours.table())
    colours.text(label.str(), study.figures.colours[std::string(label.str())]);
  if (const auto mistake = style_error(study.figures))
    throw std::invalid_argument(fmt::format("figures: {}; expected {}", mistake->first, mistake->second));
  std::string targets;
  path.text("kind", study.path);
  path.text("targets", targets);
  study.draws_targets = targets == "drawn";
  reader.whole("points", study.points, counts);
  reader.texts("departures", study.departures);
  reach.whole("points", study.unreachable_targets, counts);
  read_grid(reader.part("grid"), study);
  arm.text("base_link", study.base_link);
  arm.text("tip_link", study.tip_link);
  arm.texts("notes", study.arm_notes);
  std::vector<double> velocities;
  arm.numbers("velocity_deg_s", velocities, 1, 0);
  for (std::size_t j = 0; j < velocities.size() && study.loop.period > 0; ++j) {
    const auto link = table["arm"]["links"][j];
    const double unit = link["joint"].value_or(std::string()) == "slides" ? 1 : base::degree;
    const double step = velocities[j] * unit * study.loop.period;
    study.max_steps.emplace_back(std::isnormal(step) ? step : INFINITY, link["limits_deg"].is_string());
  }
  study.arm = text_of(document.value("arm", base::Json()));
  study.task = text_of(document.value("initial_deg", base::Json()));
  if (study.draws_targets) study.task += text_of(document.value("path", base::Json()));
  return study;
}

}  // namespace ikbench::results
