#include "experiments/study_overrides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <vector>

#include "numerics/json.hpp"
#include "numerics/names.hpp"
#include "numerics/number.hpp"

namespace ikbench::experiments {

using namespace numerics;

namespace {

// Inserts the text as a TOML value, or else as a string: people type both `runs=5` and `path.tool=eq27`.
void insert(toml::table& table, std::string_view key, const std::string& text) {
  refuse_deep_keys(text, "--set");
  try {
    toml::table parsed = toml::parse(std::string_view("value = " + text), override_source);
    if (parsed.size() == 1) {
      parsed.get("value")->visit([&](auto& value) { table.insert_or_assign(key, std::move(value)); });
      return;
    }
  } catch (const toml::parse_error&) {
  }
  table.insert_or_assign(key, text);
}

toml::table& subtable(toml::table& table, std::string_view key) {
  if (!table.contains(key)) table.insert(key, toml::table{});
  toml::table* found = table.get(key)->as_table();
  if (found == nullptr) throw std::invalid_argument(fmt::format("--set {}: {} of the study is not a table", key, key));
  return *found;
}

}  // namespace

void override_one(toml::table& study, const std::string& text) {
  const std::size_t equals = text.find('=');
  constexpr std::size_t longest_key = 300;
  if (equals == std::string::npos || equals == 0 || equals > longest_key) {
    throw std::invalid_argument(
        fmt::format("--set {}: expected key=value, such as runs=5 or ik_bat.bounds=clamp", text.substr(0, 100)));
  }
  const std::string key = text.substr(0, equals), value = text.substr(equals + 1);
  if (constexpr std::string_view sweep = "sweep."; key.starts_with(sweep)) {
    insert(subtable(study, "sweep"), std::string_view(key).substr(sweep.size()), value);
    return;
  }
  const std::size_t dot = key.rfind('.');
  if (dot == std::string::npos) {
    insert(study, key, value);
    return;
  }
  const std::string owner = key.substr(0, dot), field = key.substr(dot + 1);
  if (owner.empty() || field.empty()) {
    throw std::invalid_argument(fmt::format("--set {}: expected a name on both sides of the dot", text.substr(0, 100)));
  }
  const std::vector<std::string> tables{"analysis", "figures", "path", "stop", "urdf"};
  if (std::find(tables.begin(), tables.end(), owner) != tables.end()) {
    insert(subtable(study, owner), field, value);
    return;
  }
  std::vector<std::string> owners = tables;
  bool found = false;
  if (toml::array* entries = study["solvers"].as_array()) {
    for (toml::node& element : *entries) {
      toml::table* entry = element.as_table();
      if (entry == nullptr) continue;
      const std::string label = (*entry)["label"].value_or(std::string());
      const std::string name = (*entry)["solver"].value_or(std::string());
      if (owner == label || owner == name) {
        insert(field == "population" || field == "colour" ? *entry : subtable(*entry, "options"), field, value);
        found = true;
      }
      for (const std::string& known : {label, name}) {
        if (!known.empty() && std::find(owners.begin(), owners.end(), known) == owners.end()) owners.push_back(known);
      }
    }
  }
  if (!found) throw std::invalid_argument(fmt::format("--set {}: {}", key, unknown_name("solver", owner, owners)));
}

std::string sweep_override(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) {
    throw std::invalid_argument(
        fmt::format("--sweep {}: expected setting=values, such as population=10,20,50 or ik_bat.alpha=0.5,0.9",
                    text.substr(0, 100)));
  }
  std::string values;
  for (std::size_t from = equals + 1; from <= text.size();) {
    const std::size_t end = std::min(text.find(',', from), text.size());
    const std::string value = text.substr(from, end - from);
    const std::optional<double> number = number_from(value);
    if (number && !std::isfinite(*number)) {
      throw std::invalid_argument(fmt::format("--sweep {}: {} is not allowed there; expected finite numbers or words",
                                              text.substr(0, 100), value.substr(0, 100)));
    }
    values += (values.empty() ? "" : ", ") + (number ? text_of(*number) : text_of(Json(value)));
    from = end + 1;
  }
  return fmt::format("sweep.{}=[{}]", text.substr(0, equals), values);
}

}  // namespace ikbench::experiments
