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

// Reads the members that fields have; the rest keep their values.
struct FieldsOf {
  const nlohmann::json& all;

  const nlohmann::json& of(std::string_view key) const { return at(all, fmt::format("/{}", key)); }
  void text(std::string_view key, std::string& field, std::string_view) const { read(of(key), field); }
  void texts(std::string_view key, std::vector<std::string>& field, std::string_view) const {
    if (of(key).is_array()) field.clear();
    read(of(key), field);
  }
  void number(std::string_view key, double& field, double unit, std::pair<double, double> range,
              std::string_view) const {
    if (!of(key).is_number()) return;
    const auto value = of(key).get<double>();
    if (!(value >= range.first && value <= range.second))
      throw std::invalid_argument(fmt::format("{} is {}; expected {} to {}", key, value, range.first, range.second));
    field = value * unit;
  }
  template <class Enum>
  void choice(std::string_view key, Enum& field, const std::vector<std::pair<std::string, Enum>>& choices,
              std::string_view) const {
    for (const auto& [name, value] : choices) {
      if (of(key) == name) field = value;
    }
  }
  template <class Enum>
  void chosen(std::string_view key, std::vector<Enum>& field, const std::vector<std::pair<std::string, Enum>>& choices,
              std::string_view) const {
    if (!of(key).is_array()) return;
    field.clear();
    for (const auto& [name, value] : choices) {
      if (std::ranges::find(of(key), nlohmann::json(name)) != of(key).end()) field.push_back(value);
    }
  }
};

}  // namespace

Plan plan_of(const nlohmann::json& analysis) {
  Plan plan;
  FieldsOf fields{analysis};
  list_fields(fields, plan);
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
  FieldsOf style{at(all, "/figures")};
  list_fields(style, of.style);
  for (const auto& [label, colour] : style.of("colours").items()) {
    if (colour.is_string()) of.style.colours[label] = colour.get<std::string>();
  }
  if (const auto mistake = mistake_in(of.style))
    throw std::invalid_argument(fmt::format("figures: {}; expected {}", mistake->first, mistake->second));
  of.plan = plan_of(at(all, "/analysis"));
  return of;
}

}  // namespace ikbench::results
