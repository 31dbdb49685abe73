#include "experiments/study_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "experiments/table_reader.hpp"
#include "experiments/task.hpp"
#include "numerics/units.hpp"
#include "robots/spherical_wrist.hpp"
#include "solvers/registry.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace robots;
using namespace solvers;

namespace {

// Checks the fields of the solvers against those of the study.
void check_solvers(const TomlReader& reader, const Study& study, const Robot& arm) {
  const toml::table& table = reader.table();
  const bool is_enforced = study.limits == Limits::enforced;
  constexpr std::string_view not_enforced =
      "bounds is \"initial\", but limits is \"enforced\"; expected bounds that keep candidates inside the limits";
  if (is_enforced && study.bounds == StudyBounds::initial)
    throw mistake(reader, table.get("bounds"), "bounds", not_enforced);
  std::size_t tables = 0;  // of [[solvers]] so far; a sweep makes several entries of one
  for (std::size_t i = 0; i < study.solvers.size(); ++i) {
    const SolverEntry& entry = study.solvers[i];
    const bool is_of_same_table = i > 0 && !entry.family.empty() && entry.family == study.solvers[i - 1].family;
    if (!is_of_same_table) ++tables;
    if (entry.program) continue;  // a program itself declines what it cannot solve
    const auto own = table["solvers"][tables - 1];
    const GoalKind goal = study.search == Search::pose ? GoalKind::pose : GoalKind::position;
    if (const std::string why = solver(entry.solver).why_not(arm.chain, goal); !why.empty()) {
      throw mistake(reader, own["solver"].node(), entry.label + ".solver", why);
    }
    const int population = effective_population(study, entry);
    if (const int least = solver(entry.solver).least_population; population < least) {
      const std::string message =
          fmt::format("population is {}, but {} needs at least {}", population, entry.solver, least);
      throw entry.population > 0 ? mistake(reader, own["population"].node(), entry.label + ".population", message)
                                 : mistake(reader, table.get("population"), "population", message);
    }
    const auto bounds = entry.options.find("bounds");
    if (is_enforced && bounds != entry.options.end() && bounds->second == "initial") {
      throw mistake(reader, own["options"]["bounds"].node(), entry.label + ".bounds", not_enforced);
    }
  }
}

// Checks the fields that only a search for poses has.
void check_search(const TomlReader& reader, const Study& study) {
  const toml::table& table = reader.table();
  const double position = study.stop.tolerance / centimetre, angle = study.stop.angle_tolerance / degree;
  if (study.search == Search::pose) {
    if ((position > 0) == (angle > 0)) return;
    const std::string_view given = position > 0 ? "tolerance_cm" : "tolerance_deg";
    throw mistake(
        reader, table["stop"][given].node(), "stop." + std::string(given),
        fmt::format("stop.tolerance_cm is {:g} and stop.tolerance_deg is {:g}; search = \"pose\" expects both, "
                    "or neither",
                    position, angle));
  }
  if (angle > 0) {
    throw mistake(
        reader, table["stop"]["tolerance_deg"].node(), "stop.tolerance_deg",
        "stop.tolerance_deg is about the orientation, which is not searched; expected search = \"pose\" or no "
        "stop.tolerance_deg");
  }
  if (study.rotation_weight != Study{}.rotation_weight) {
    throw mistake(reader, table.get("rotation_weight_m"), "rotation_weight_m",
                  "rotation_weight_m weighs the orientation, which is not searched; expected search = \"pose\" or no "
                  "rotation_weight_m");
  }
}

// Checks that path, arm and start fit each other.
void check_targets(const TomlReader& reader, const Study& study, const Robot& arm) {
  try {
    study.path->check(arm);
  } catch (const std::invalid_argument& error) {
    throw mistake(reader, reader.table().get("path"), "path", error.what());
  }
  Random random(Key(0));
  if (study.start == Start::near && study.path->solutions(arm, random).empty()) {
    throw mistake(reader, reader.table().get("start"), "start",
                  "start is \"near\", but the path's targets are not made of configurations; expected path.kind = "
                  "\"random\" with targets that the arm can reach, or another start");
  }
}

}  // namespace

void check_fields(const TomlReader& reader, const Study& study, const Robot& arm) {
  const auto at = [&](std::string_view key, std::string_view message) {
    return mistake(reader, reader.table().get(key), key, message);
  };
  check_targets(reader, study, arm);
  constexpr double most_solves = 1e8;
  if (static_cast<double>(study.solvers.size()) * study.runs * study.path->points() > most_solves) {
    throw at("runs", "solvers, runs and points make more than 100 000 000 solves; expected fewer");
  }
  if (study.trace == Trace::best_error && study.stop.iterations > 1'000'000) {
    throw at("trace", "a trace has at most 1 000 000 iterations; expected stop.iterations of at most that");
  }
  check_solvers(reader, study, arm);
  const Configuration units = joint_units(arm.chain);
  for (Eigen::Index j = 0; j < units.size() && study.limits == Limits::enforced; ++j) {
    const double outside = std::max(arm.limits.lower[j] - study.initial[j], study.initial[j] - arm.limits.upper[j]);
    if (outside > 0) {
      throw at("initial_deg",
               fmt::format("initial_deg is {:g} {} outside the limits of joint {}, but limits is \"enforced\"; see: "
                           "ikbench list robots {}",
                           outside / units[j], units[j] == 1 ? "m" : "deg", j + 1, arm.name));
    }
  }
  if (study.search == Search::wrist && !SphericalWrist::fits(arm.chain)) {
    throw at("search", fmt::format("search is \"wrist\", but {} has no spherical wrist; expected \"all_joints\" or "
                                   "\"pose\"",
                                   arm.name));
  }
  if (study.search == Search::flange && !only_turns_tool(arm.chain)) {
    throw at("search", fmt::format("search is \"flange\", but the last joint of {} moves the tool's point; expected "
                                   "\"all_joints\" or \"pose\"",
                                   arm.name));
  }
  check_search(reader, study);
}

}  // namespace ikbench::experiments
