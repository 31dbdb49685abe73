#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "base/json.hpp"
#include "base/names.hpp"
#include "base/number.hpp"
#include "experiments/study/reader.hpp"
#include "experiments/study/reader_internal.hpp"
#include "experiments/study/study_fields.hpp"
#include "experiments/study/written_fields.hpp"
#include "robots/robot.hpp"

namespace ikbench::experiments {

using namespace base;
using namespace solvers;

namespace {

// Inserts the text as a TOML value, or as a string if the text is no value, because people type both `runs=5` and
// `path.tool=eq27`. The value keeps the option that gave it.
void insert(toml::table& table, std::string_view key, const std::string& text, std::string_view option) {
  refuse_deep_keys(text, option);
  for (const std::string& toml : {text, toml_string(text)}) {
    try {
      toml::table parsed = toml::parse(std::string_view("value = " + toml), option);
      if (parsed.size() != 1) continue;
      parsed.get("value")->visit([&](auto& value) { table.insert_or_assign(key, std::move(value)); });
      return;
    } catch (const toml::parse_error&) {
    }
  }
  table.insert_or_assign(key, text);
}

// Returns the table with this key, which is added if it is not there.
toml::table& subtable(toml::table& table, std::string_view key, std::string_view option) {
  if (!table.contains(key)) insert(table, key, "{}", option);
  toml::table* part = table.get(key)->as_table();
  if (part == nullptr)
    throw std::invalid_argument(fmt::format("{} {}: {} of the study is not a table", option, key, key));
  return *part;
}

constexpr std::string_view swept_owner = "sweep";
constexpr std::array<std::string_view, 8> study_tables{"analysis", "check",   "figures", "loop",
                                                       "path",     "require", "stop",    "urdf"};

// Returns the settings of a solver that can be swept: the population, and the options of a built-in solver.
std::set<std::string> settings_of(const std::string& solver) {
  std::set<std::string> settings{std::string(population_key)};
  for (const SolverInfo& info : all_solvers()) {
    if (info.name != solver) continue;
    for (const auto& [option, value] : info.options({})) settings.insert(option);
  }
  return settings;
}

// An override as it was typed: "key=value", perhaps behind the option that gave it, such as "--robot ".
struct TypedOverride {
  explicit TypedOverride(const std::string& argument) {
    const std::size_t blank = argument.starts_with("--") ? argument.find(' ') : std::string::npos;
    option = blank == std::string::npos ? std::string(override_source) : argument.substr(0, blank);
    text = blank == std::string::npos ? argument : argument.substr(blank + 1);
    const std::size_t equals = text.find('=');
    constexpr std::size_t max_key_bytes = 300;
    if (equals == std::string::npos || equals == 0 || equals > max_key_bytes) {
      throw std::invalid_argument(
          fmt::format("{} {}: expected key=value, such as runs=5 or ik_bat.bounds=clamp", option, text.substr(0, 100)));
    }
    key = text.substr(0, equals);
    value = text.substr(equals + 1);
  }

  std::string option, text, key, value;
};

// A sweep as it was typed: "key=values".
struct Sweep {
  explicit Sweep(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) {
      throw std::invalid_argument(fmt::format(
          "--sweep {}: expected setting=values, such as population=10,20,50, ik_bat.alpha=0.5,0.9 or near_deg=1,10,45",
          text.substr(0, 100)));
    }
    key = text.substr(0, equals);
    values.emplace_back();
    int depth = 0;  // of brackets, whose commas are inside a value
    for (const char c : text.substr(equals + 1)) {
      depth += (c == '[' || c == '{') - (c == ']' || c == '}');
      if (c == ',' && depth == 0)
        values.emplace_back();
      else
        values.back() += c;
    }
    for (std::string& value : values) {  // numbers as TOML has them; whole numbers may have more digits than a double
      const bool is_whole = value.find_first_not_of("0123456789") == std::string::npos;
      if (const std::optional<double> number = number_from(value); number && std::isfinite(*number) && !is_whole)
        value = text_of(*number);
    }
  }

  std::string key;
  std::vector<std::string> values = {};
};

constexpr std::string_view study_owner = "study";

// Returns whether a study has this key outside its tables.
bool is_general_key(const std::string& key) {
  Study study;
  const WrittenFields fields = written_fields(study);
  return std::ranges::find(fields, key, &WrittenField::key) != fields.end();
}

// Refuses the sweep of a key that is not of a study, or that changes no result.
void refuse_fixed_key(const Sweep& sweep) {
  constexpr std::array<std::string_view, 8> fixed{"analysis", "figures", "name",  "published",
                                                  "require",  "rounds",  "state", "title"};
  const std::string owner = sweep.key.substr(0, sweep.key.find('.'));
  if (std::ranges::find(fixed, owner) != fixed.end())
    throw std::invalid_argument(
        fmt::format("--sweep {}: {} changes no answer; give it once, by --set", sweep.key, owner));
  const bool is_of_table = std::ranges::find(study_tables, owner) != study_tables.end();
  if (owner != sweep.key && !is_of_table)
    throw std::invalid_argument(
        fmt::format("--sweep study.{0}: {1} is not a table of a study; for an option of a solver: "
                    "--sweep {0}=...",
                    sweep.key, owner));
  if (owner == sweep.key && !is_general_key(owner))
    throw std::invalid_argument(
        fmt::format("--sweep {}: a study has no such key; see: ikbench list studies any-arm", owner));
}

// Returns the names of a sweep's values. An arm's file has its stem as its name, unless two files have the same.
std::vector<std::string> names_of(const Sweep& sweep) {
  std::vector<std::string> names = sweep.values;
  const auto has_twice = [](const std::vector<std::string>& texts) {
    return std::set<std::string>(texts.begin(), texts.end()).size() < texts.size();
  };
  if (has_twice(names))
    throw std::invalid_argument(fmt::format("--sweep {}: a value is given twice; give each value once", sweep.key));
  for (const std::string& name : names)
    if (!is_plain(name) || trimmed(name).empty())
      throw std::invalid_argument(
          fmt::format("--sweep {}: {} is not a value; expected {}", sweep.key, in_quotes(name), plain_text));
  if (sweep.key != "robot") return names;
  std::vector<std::string> stems;
  for (const std::string& name : names)
    stems.push_back(robots::is_arm_file(name) ? std::filesystem::path(name).stem().string() : name);
  return has_twice(stems) ? names : stems;
}

// Refuses a key of [stop] without its table, which is a likely mistake.
void refuse_stop_key(const TypedOverride& typed) {
  constexpr std::array<std::string_view, 5> stops{"seconds", "iterations", "evaluations", "tolerance_cm",
                                                  "tolerance_deg"};
  if (std::ranges::find(stops, typed.key) != stops.end())
    throw std::invalid_argument(fmt::format("{0} {1}: unknown key; did you mean stop.{1}?", typed.option, typed.key));
}

// Sets `field` of all entries with this label or solver, or with `owner` "sweep" of all whose solver has that setting.
// Throws std::invalid_argument if there is no such entry.
void set_in_entries(toml::table& study, const TypedOverride& typed, const std::string& owner,
                    const std::string& field) {
  const bool is_of_all = owner == swept_owner;
  bool is_known = false;
  std::set<std::string> settings;
  std::set<std::string> owners(study_tables.begin(), study_tables.end());
  if (toml::array* const entries = study["solvers"].as_array()) {
    for (toml::node& element : *entries) {
      toml::table* const entry = element.as_table();
      if (entry == nullptr) continue;
      const std::string label = (*entry)["label"].value_or(std::string());
      const std::string solver = (*entry)["solver"].value_or(std::string());
      const std::set<std::string> own = settings_of(solver);
      if (is_of_all ? own.contains(field) : owner == label || owner == solver) {
        const bool is_of_entry = field == population_key || field == "colour" || field == "memory_mb" ||
                                 field == "timeout_s" || field == "batch" ||
                                 field == "patience_s";  // whose reader names the new key
        insert(is_of_entry ? *entry : subtable(*entry, "options", typed.option), field, typed.value, typed.option);
        is_known = true;
      }
      settings.insert(own.begin(), own.end());
      owners.insert({label, solver});
    }
  }
  if (is_known) return;
  owners.erase("");
  const std::string unknown = is_of_all ? unknown_name("setting", field, {settings.begin(), settings.end()})
                                        : unknown_name("solver", owner, {owners.begin(), owners.end()});
  throw std::invalid_argument(fmt::format("{} {}: {}", typed.option, is_of_all ? field : typed.key, unknown));
}

}  // namespace

void apply_override(toml::table& study, const std::string& argument) {
  const TypedOverride typed(argument);
  const std::size_t dot = typed.key.rfind('.');
  if (dot == std::string::npos) {
    refuse_stop_key(typed);
    return insert(study, typed.key, typed.value, typed.option);
  }
  const std::string owner = typed.key.substr(0, dot);
  const std::string field = typed.key.substr(dot + 1);
  if (owner.empty() || field.empty()) {
    throw std::invalid_argument(
        fmt::format("{} {}: expected a name on both sides of the dot", typed.option, typed.text.substr(0, 100)));
  }
  if (std::ranges::find(study_tables, owner) != study_tables.end())
    return insert(subtable(study, owner, typed.option), field, typed.value, typed.option);
  set_in_entries(study, typed, owner, field);
}

std::string sweep_override(const std::string& text) {
  const Sweep sweep(text);
  std::string values;
  for (const std::string& value : sweep.values) {
    const std::optional<double> number = number_from(value);
    values += number && std::isfinite(*number) ? text_of(*number) : text_of(base::Json(value));
    values += ", ";
  }
  const bool is_of_all = sweep.key.find('.') == std::string::npos;
  return fmt::format("--sweep {}=[{}]", is_of_all ? fmt::format("{}.{}", swept_owner, sweep.key) : sweep.key, values);
}

bool is_sweep_of_study(const std::string& text) {
  const std::string key = text.substr(0, text.find('='));
  if (const std::size_t dot = key.find('.'); dot != std::string::npos) {
    const std::string owner = key.substr(0, dot);
    return owner == study_owner || std::ranges::find(study_tables, owner) != study_tables.end();
  }
  const auto has_setting = [&](const SolverInfo& info) { return settings_of(info.name).contains(key); };
  return std::ranges::none_of(all_solvers(), has_setting) && is_general_key(key);
}

std::vector<SweptStudy> swept_studies(const std::vector<std::string>& texts) {
  std::vector<SweptStudy> studies{{}};
  std::set<std::string> keys;
  for (const std::string& text : texts) {
    Sweep sweep(text);
    if (sweep.key.starts_with(fmt::format("{}.", study_owner))) sweep.key.erase(0, study_owner.size() + 1);
    refuse_fixed_key(sweep);
    if (!keys.insert(sweep.key).second)
      throw std::invalid_argument(
          fmt::format("--sweep {}: this key is swept twice; give all of its values in one --sweep", sweep.key));
    const std::vector<std::string> names = names_of(sweep);
    if (studies.size() * names.size() > max_swept_studies)
      throw std::invalid_argument(fmt::format("--sweep {}: more than {} studies; expected fewer values",
                                              text.substr(0, 100), max_swept_studies));
    std::vector<SweptStudy> longer;
    for (const SweptStudy& shorter : studies) {
      for (std::size_t i = 0; i < names.size(); ++i) {
        SweptStudy& study = longer.emplace_back(shorter);
        study.place.values.emplace_back(sweep.key, names[i]);
        study.overrides.push_back(fmt::format("--sweep {}={}", sweep.key, sweep.values[i]));
      }
    }
    studies = std::move(longer);
  }
  return studies;
}

}  // namespace ikbench::experiments
