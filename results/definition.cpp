#include "results/definition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "numerics/json.hpp"

namespace ikbench::results {
namespace {

// The value at a path of keys, such as "/stop/seconds"; null if there is none.
const nlohmann::json& at(const nlohmann::json& all, const std::string& path) {
  static const nlohmann::json none;
  const nlohmann::json::json_pointer pointer(path);
  return all.is_object() && all.contains(pointer) ? all.at(pointer) : none;
}

void read(const nlohmann::json& value, std::string& into) {
  if (value.is_string()) into = value.get<std::string>();
}
void read(const nlohmann::json& value, double& into) {
  if (value.is_number()) into = value.get<double>();
}
void read(const nlohmann::json& value, std::int64_t& into) {
  if (value.is_number_integer()) into = value.get<std::int64_t>();
}
void read(const nlohmann::json& value, int& into) {
  std::int64_t whole = into;
  read(value, whole);
  into = static_cast<int>(std::clamp<std::int64_t>(whole, 0, std::numeric_limits<int>::max()));
}
void read(const nlohmann::json& value, std::vector<std::string>& into) {
  for (const nlohmann::json& each : value) {
    if (each.is_string()) into.push_back(each.get<std::string>());
  }
}

}  // namespace

Plan plan_of(const nlohmann::json& analysis, std::string_view published) {
  Plan plan;
  const auto read_at = [&](const char* path, auto& into) { read(at(analysis, path), into); };
  const auto expect = [](const char* field, double value, double least, double most) {
    if (value >= least && value <= most) return;
    throw std::invalid_argument(fmt::format("plan: {} {}; expected {} to {}", field, value, least, most));
  };
  std::string test;
  double margin_percent = 100 * plan.margin;
  read_at("/test", test);
  read_at("/metric", plan.metric);
  read_at("/control", plan.control);
  read_at("/significance", plan.significance);
  read_at("/margin_percent", margin_percent);
  read_at("/margin_cm", plan.margin_cm);
  expect("significance", plan.significance, 0.0001, 0.2);
  expect("margin_percent", margin_percent, 0, 99);
  expect("margin_cm", plan.margin_cm, 0, 1000);
  plan.margin = margin_percent / 100;
  // Other names are of tests that are gone.
  if (test == "means" || (test != "ranks" && published == "slim2023")) plan.test = Plan::Test::means;
  return plan;
}

Definition definition_of(std::string_view json) {
  const nlohmann::json all = numerics::parsed_json(json);
  if (!all.is_object()) throw std::invalid_argument("the definition of a study is no JSON object");
  Definition of;
  const auto read_at = [&](const char* path, auto& into) { read(at(all, path), into); };
  read_at("/title", of.title);
  read_at("/published", of.published);
  read_at("/robot", of.robot);
  read_at("/search", of.search);
  read_at("/start", of.start);
  read_at("/path/kind", of.path);
  read_at("/limits", of.limits);
  read_at("/runs", of.runs);
  read_at("/path/points", of.points);
  read_at("/points", of.points);
  read_at("/seed", of.seed);
  read_at("/deadline_ms", of.deadline_ms);
  read_at("/stop/tolerance_cm", of.stop.tolerance_cm);
  read_at("/stop/tolerance_deg", of.stop.tolerance_deg);
  read_at("/stop/seconds", of.stop.seconds);
  read_at("/stop/iterations", of.stop.iterations);
  read_at("/stop/evaluations", of.stop.evaluations);
  read_at("/departures", of.departures);
  read_at("/missing_solvers", of.missing_solvers);
  read_at("/out_of_reach/points", of.out_of_reach);
  of.draws_targets = at(all, "/path/targets") == "drawn";
  of.arm = at(all, "/arm");
  of.plan = plan_of(at(all, "/analysis"), of.published);
  return of;
}

}  // namespace ikbench::results
