#include "analysis/show/moving_arm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/algorithm/string/replace.hpp>
#include <set>

#include "analysis/figures/rows.hpp"
#include "base/embedded_file.hpp"
#include "base/json.hpp"
#include "base/names.hpp"
#include "robots/robot.hpp"

namespace ikbench::show {

using namespace results;
using judge::StudyResults;
using Json = base::OrderedJson;

namespace {

constexpr std::size_t most_points = 200;
constexpr std::size_t most_solvers = 24;

// Returns the values rounded to 1e-5, which is a 30th of a pixel's width for an arm of 1 m. JSON has null for a value
// that is not finite.
Json rounded(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(std::round(value * 1e5) / 1e5);
  return list;
}

// Returns the places in a first run that the page shows: all of a short run, and evenly spaced ones of a long run.
std::set<std::size_t> shown_places(const StudyResults& study, const std::vector<std::string>& order) {
  std::size_t n = 0;
  for (const std::string& solver : order) n = std::max(n, study.first_run_of(solver).size());
  const std::size_t shown = std::min(n, most_points);
  std::set<std::size_t> places;
  for (std::size_t k = 0; k < shown; ++k) places.insert(shown < 2 ? k : k * (n - 1) / (shown - 1));
  return places;
}

// Returns these places of a solver's first run. A step has a start only if it differs from the previous answer.
Json first_run(const StudyResults& study, const std::string& solver, const std::set<std::size_t>& places) {
  const std::span<const SolveRecord> solves = study.first_run_of(solver);
  const auto [unit, factor] = figures::drawn_unit(study, "cm");
  Json steps = Json::array();
  const SolveRecord* before = nullptr;
  for (const std::size_t place : places) {
    if (place >= solves.size()) break;
    const SolveRecord& solve = solves[place];
    const judge::SolveSummary& judged = study.of(solver)[place];
    Json step{{"point", solve.point},
              {"target", rounded(solve.target_position_m)},
              {"answer", rounded(solve.answer_rad)},
              {"error", factor * solve.position_error_cm},
              {"variation_deg", solve.variation_deg},
              {"variation_m", solve.variation_m},
              {"late", judged.missed_deadline},
              {"too_fast", judged.exceeds_velocity}};
    if (!before || before->answer_rad != solve.start_rad) step["start"] = rounded(solve.start_rad);
    steps.push_back(std::move(step));
    before = &solve;
  }
  return {{"name", base::one_line(solver)}, {"unit", unit}, {"steps", std::move(steps)}};
}

Json drawn(const robots::Frame& frame) {
  const auto numbers = [](const Eigen::Vector3d& v) { return Json{v.x(), v.y(), v.z()}; };
  return {{"position_m", numbers(frame.position)}, {"rpy_rad", numbers(frame.rpy)}};
}

Json drawn(const robots::Chain& chain) {
  constexpr std::array joints{"turns", "slides", "coupled"};
  Json links = Json::array();
  for (const robots::DhLink& link : chain.links()) {
    links.push_back({{"joint", joints[static_cast<std::size_t>(link.joint)]},
                     {"offset_rad", link.offset},
                     {"d_m", link.d},
                     {"a_m", link.a},
                     {"alpha_rad", link.alpha},
                     {"beta_rad", link.beta}});
  }
  return {{"links", std::move(links)}, {"base", drawn(chain.base())}, {"tool", drawn(chain.tool())}};
}

bool can_be_drawn(const StudyResults& study, std::size_t joints) {
  const auto is_near = [](double coordinate) { return std::abs(coordinate) <= 1000; };  // [m]
  return std::ranges::all_of(study.plotted, [&](const SolveRecord& solve) {
    return solve.target_position_m.size() == 3 && std::ranges::all_of(solve.target_position_m, is_near) &&
           solve.start_rad.size() == joints && solve.answer_rad.size() == joints;
  });
}

}  // namespace

std::optional<std::string> animation_json(const StudyResults& study, const std::vector<std::string>& order) {
  const std::optional<robots::Robot> arm = robots::stored_arm(study.definition.arm);
  if (!arm || !can_be_drawn(study, arm->chain.links().size())) return std::nullopt;
  Json solvers = Json::array();
  std::vector<std::string> shown = order;
  std::erase_if(shown, [&](const std::string& solver) { return study.first_run_of(solver).empty(); });
  shown.resize(std::min(shown.size(), most_solvers));
  const std::set<std::size_t> places = shown_places(study, shown);
  for (const std::string& solver : shown) solvers.push_back(first_run(study, solver, places));
  if (solvers.empty()) return std::nullopt;
  const bool is_path = !study.definition.draws_targets && !study.definition.is_grid();
  const bool are_all = *places.rbegin() + 1 == places.size();
  const std::string which =
      are_all ? ""
              : fmt::format(" Only {} of {} targets are shown, evenly spaced.", places.size(), *places.rbegin() + 1);
  std::string text = base::text_of(
      Json{{"arm", drawn(arm->chain)}, {"is_path", is_path}, {"which", which}, {"solvers", std::move(solvers)}});
  boost::replace_all(text, "<", "\\u003c");  // no text ends the element
  return text;
}

std::string threejs_source() {
  const std::initializer_list<base::EmbeddedFile> files{
#include "three.inc"
  };
  std::string library;
  for (const base::EmbeddedFile& file : files) library.append(file.text) += '\n';
  return library;
}

}  // namespace ikbench::show
