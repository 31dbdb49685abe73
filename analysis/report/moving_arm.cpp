#include "analysis/report/moving_arm.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <numbers>

#include "analysis/inference/text.hpp"
#include "analysis/report/json.hpp"
#include "results/files.hpp"

namespace ikbench::report {

using namespace results;
using namespace inference;

namespace {

constexpr std::size_t most_points = 200;
constexpr std::size_t most_solvers = 24;

// To 1e-5, a 30th of the width of a pixel at a metre of arm; null where it is no number.
Json rounded(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) {
    list.push_back(std::isfinite(value) ? Json(std::round(value * 1e5) / 1e5) : Json(nullptr));
  }
  return list;
}

// The joints of an answer that are outside their limits, and by how much. That any is has been recorded; up to 1e-9 rad
// is rounding, as it is to the verifier (experiments/verifier.cpp). Decided here, since the page has rounded angles.
Json joints_outside(const SolveRecord& solve, const Json& arm) {
  constexpr double degree = std::numbers::pi / 180, rounding_deg = 1e-9 / degree;
  Json list = Json::array();
  if (!(solve.limit_violation_deg > 0)) return list;
  for (std::size_t joint = 0; joint < solve.answer_rad.size(); ++joint) {
    const double angle_deg = solve.answer_rad[joint] / degree;
    const double outside_deg =
        std::max(arm["lower_deg"][joint].get<double>() - angle_deg, angle_deg - arm["upper_deg"][joint].get<double>());
    if (outside_deg > rounding_deg) list.push_back({{"joint", joint}, {"deg", outside_deg}});
  }
  return list;
}

// The first run of a solver, point by point; a start only where it is not the answer before.
Json first_run(const StudyResults& study, const std::string& solver, const Json& arm) {
  std::map<std::pair<int, int>, const SolveRecord*> solves;
  for (const SolveRecord& solve : study.solves) {
    if (solve.solver == solver) solves[{solve.run, solve.point}] = &solve;
  }
  if (solves.empty()) return nullptr;
  const int run = solves.begin()->first.first;
  Json steps = Json::array();
  const SolveRecord* before = nullptr;
  for (const auto& [place, solve] : solves) {
    if (place.first != run || steps.size() == most_points) break;
    Json step{{"point", solve->point},
              {"target", rounded(solve->target_position_m)},
              {"answer", rounded(solve->answer_rad)},
              {"error_cm", json_number(solve->position_error_cm)},
              {"variation_deg", json_number(solve->variation_deg)},
              {"outside", joints_outside(*solve, arm)}};
    if (!before || before->answer_rad != solve->start_rad) step["start"] = rounded(solve->start_rad);
    steps.push_back(std::move(step));
    before = solve;
  }
  return {{"name", one_line(solver)}, {"run", run}, {"steps", std::move(steps)}};
}

constexpr std::size_t most_joints = 64;

bool is_list_of_lengths(const Json& list, std::size_t size) {
  return list.is_array() && list.size() == size && std::ranges::all_of(list, [](const Json& each) {
           return each.is_number() && std::abs(each.get<double>()) <= 1000;  // [m], or limits [deg]
         });
}

// How many joints the arm has that the page can draw; 0 where it is none that it knows, as a foreign store may say.
std::size_t joints_of(const Json& arm) {
  const auto lengths = [&](std::initializer_list<const char*> names, const Json& of) {
    return std::ranges::all_of(names, [&](const char* name) {
      return of.contains(name) && of[name].is_number() && std::abs(of[name].get<double>()) <= 1000;
    });
  };
  std::size_t joints = 0;
  const Json kind = arm.value("kind", Json());
  if (kind == "dobot_magician" && lengths({"upper_arm_m", "forearm_m", "wrist_to_tool_m", "height_m"}, arm)) {
    joints = 3;
  } else if (kind == "denavit_hartenberg" && arm.contains("links") && arm["links"].is_array() &&
             arm["links"].size() <= most_joints && is_list_of_lengths(arm.value("tip_m", Json()), 3)) {
    const bool all = std::ranges::all_of(arm["links"], [&](const Json& link) {
      return link.is_object() && lengths({"a_m", "alpha_rad", "d_m", "offset_rad"}, link);
    });
    joints = all ? arm["links"].size() : 0;
  }
  const bool has_limits = is_list_of_lengths(arm.value("lower_deg", Json()), joints) &&
                          is_list_of_lengths(arm.value("upper_deg", Json()), joints);
  return has_limits ? joints : 0;
}

bool can_be_drawn(const SolveRecord& solve, std::size_t joints) {
  const auto is_near = [](double coordinate) { return std::abs(coordinate) <= 1000; };  // [m]
  return solve.answer_rad.size() == joints && solve.start_rad.size() == joints && solve.target_position_m.size() == 3 &&
         std::ranges::all_of(solve.target_position_m, is_near);
}

}  // namespace

std::optional<std::string> moving_arm(const StudyEntry& entry, const StudyResults& study) {
  const Json definition = Json::parse(entry.definition, nullptr, false);
  if (!definition.is_object() || !definition.contains("arm") || !definition["arm"].is_object()) return std::nullopt;
  const std::size_t joints = joints_of(definition["arm"]);
  const auto drawn = [&](const SolveRecord& solve) { return can_be_drawn(solve, joints); };
  if (joints == 0 || !std::ranges::all_of(study.solves, drawn)) return std::nullopt;
  Json solvers = Json::array();
  for (const std::string& solver : study.solvers) {
    if (solvers.size() == most_solvers) break;
    Json run = first_run(study, solver, definition["arm"]);
    if (!run.is_null()) solvers.push_back(std::move(run));
  }
  if (solvers.empty()) return std::nullopt;
  std::string text = Json{{"arm", definition["arm"]}, {"solvers", std::move(solvers)}}.dump(
      -1, ' ', false, Json::error_handler_t::replace);
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at))
    text.replace(at, 1, "\\u003c");
  return text;
}

std::optional<std::string> drawing_library() {
  for (const std::filesystem::path folder : {"/usr/share/javascript/three", "/usr/share/nodejs/three"}) {
    std::string library;
    for (const char* name : {"build/three.min.js", "examples/js/controls/OrbitControls.js"}) {
      const auto text = read_file(folder / name);
      const bool is_safe =
          text && text->find("</script") == std::string::npos && text->find("<!--") == std::string::npos;
      if (!is_safe) break;
      library += *text + '\n';
      if (std::string_view(name).starts_with("examples")) return library;
    }
  }
  return std::nullopt;
}

}  // namespace ikbench::report
