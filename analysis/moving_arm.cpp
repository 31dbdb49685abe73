#include "analysis/moving_arm.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "analysis/text.hpp"

namespace ikbench {
namespace {

using Json = nlohmann::ordered_json;

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

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

// The first run of a solver, point by point; a start only where it is not the answer before.
Json first_run(const StudyResults& study, const std::string& solver) {
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
              {"error_cm", number(solve->position_error_cm)},
              {"variation_deg", number(solve->variation_deg)},
              {"outside_deg", number(solve->limit_violation_deg)}};
    if (!before || before->answer_rad != solve->start_rad) step["start"] = rounded(solve->start_rad);
    steps.push_back(std::move(step));
    before = solve;
  }
  return {{"name", one_line(solver)}, {"run", run}, {"steps", std::move(steps)}};
}

std::optional<std::string> text_of_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  if (!stream || !(text << stream.rdbuf())) return std::nullopt;
  return text.str();
}

}  // namespace

std::optional<std::string> moving_arm(const StudyEntry& entry, const StudyResults& study) {
  const Json definition = Json::parse(entry.definition, nullptr, false);
  if (!definition.is_object() || !definition.contains("arm") || !definition["arm"].is_object()) return std::nullopt;
  Json solvers = Json::array();
  for (const std::string& solver : study.solvers) {
    if (solvers.size() == most_solvers) break;
    Json run = first_run(study, solver);
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
      const auto text = text_of_file(folder / name);
      const bool is_safe =
          text && text->find("</script") == std::string::npos && text->find("<!--") == std::string::npos;
      if (!is_safe) break;
      library += *text + '\n';
      if (std::string_view(name).starts_with("examples")) return library;
    }
  }
  return std::nullopt;
}

}  // namespace ikbench
