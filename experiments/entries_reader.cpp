#include "experiments/entries_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include "experiments/foreign/program.hpp"
#include "experiments/study_fields.hpp"
#include "experiments/table_reader.hpp"
#include "numerics/names.hpp"
#include "numerics/number.hpp"
#include "solvers/registry.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace solvers;

namespace {

const Choices<IfMissing> if_missing_choices{{"refuse", IfMissing::refuse}, {"leave_out", IfMissing::leave_out}};

// Starts the program to read its name and options.
std::shared_ptr<const Program> read_program(TomlReader& reader) {
  constexpr std::string_view key = "process";
  ProgramChoice choice;
  TableReader fields(reader);
  list_fields(fields, choice);
  const auto wrong = [&](const std::exception& error) {
    return mistake(reader, reader.table().get(key), key,
                   fmt::format("{}: {}; see: ikbench check-solver", choice.process[0], error.what()));
  };
  try {
    return meet(choice, folder_of(reader, key));
  } catch (const std::runtime_error& error) {
    throw wrong(error);
  } catch (const std::invalid_argument& error) {
    throw wrong(error);
  }
}

// Reads what an entry is: a built-in solver or a program.
void read_kind(TomlReader& reader, SolverEntry& entry) {
  reader.text("solver", entry.solver, "");
  const toml::node *name = reader.find("solver"), *process = reader.find("process");
  if ((name != nullptr) == (process != nullptr)) {
    throw std::invalid_argument(
        reader.where(reader.table().source(), "solver") +
        (process == nullptr ? "an entry of [[solvers]] has no `solver` and no `process`; see: ikbench list solvers"
                            : "an entry of [[solvers]] has a `process` and a `solver`; expected one of them"));
  }
  if (process != nullptr) {
    entry.program = read_program(reader);
    entry.solver = entry.program->hello.name;
    return;
  }
  try {
    static_cast<void>(solver(entry.solver));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(reader.where(name->source(), "solver") + error.what());
  }
}

// Returns whether the default of an option is a number.
bool is_of_numbers(const SolverEntry& entry, const std::string& option) {
  const Settings defaults = options_with(entry, {});
  const auto by_default = defaults.find(option);
  return by_default != defaults.end() && number_from(by_default->second);
}

constexpr std::string_view population_key = "population";

// A value of a setting, the population or an option, as text. `settings` has the entry's label before its keys.
std::string value_in(const TomlReader& settings, const SolverEntry& entry, const std::string& setting,
                     const toml::node& node) {
  if (setting == population_key) {
    const toml::value<std::int64_t>* value = node.as_integer();
    if (value == nullptr || value->get() < populations.first || value->get() > populations.second) {
      settings.fail_number(setting, node,
                           fmt::format("a whole number from {} to {}", populations.first, populations.second));
    }
    return fmt::format("{}", value->get());
  }
  std::string text;
  if (const auto quoted = node.value<std::string>()) {
    if (!TomlReader::is_plain(*quoted)) settings.fail(setting, node, TomlReader::plain);
    if (const auto number = number_from(*quoted); number && is_of_numbers(entry, setting))
      settings.fail(setting, node,
                    std::isfinite(*number) ? fmt::format("a number, without quotes: {}", *number) : "a finite number");
    text = *quoted;
  } else if (node.is_integer()) {
    text = fmt::format("{}", *node.value<std::int64_t>());
  } else if (node.is_floating_point()) {
    text = fmt::format("{}", *node.value<double>());
  } else {
    settings.fail(setting, node, "a number or a quoted string, or a list of them");
  }
  try {
    options_with(entry, {{setting, text}});
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(settings.where(node.source(), setting) + error.what());
  }
  return text;
}

void give(SolverEntry& entry, const std::string& setting, const std::string& value) {
  if (setting == population_key)
    entry.population = std::stoi(value);
  else
    entry.options[setting] = value;
}

// Swept settings, each with its values.
using Axes = std::map<std::string, std::vector<std::string>>;

std::vector<std::string> values_in(const TomlReader& settings, const SolverEntry& entry, const std::string& setting,
                                   const toml::node& node) {
  const toml::array* list = node.as_array();
  if (list == nullptr || list->empty() || list->size() > most_swept)
    settings.fail(setting, node, fmt::format("a list of 1 to {} values", most_swept));
  std::vector<std::string> values;
  for (const toml::node& element : *list) {
    values.push_back(value_in(settings, entry, setting, element));
    if (std::ranges::count(values, values.back()) > 1) settings.fail(setting, element, "each value once");
  }
  return values;
}

// A setting of the entry: one value, or a list of them.
void read_setting(const TomlReader& settings, SolverEntry& entry, Axes& axes, const std::string& setting,
                  const toml::node& node) {
  if (node.is_array())
    axes[setting] = values_in(settings, entry, setting, node);
  else
    give(entry, setting, value_in(settings, entry, setting, node));
}

// A key of [sweep].
struct SweptKey {
  std::string owner;  // a label or a solver's name; empty: every solver that has the setting
  std::string setting;
  const toml::node* values;
  bool is_used = false;
};

std::vector<SweptKey> swept_keys(TomlReader& study) {
  std::vector<SweptKey> keys;
  const toml::table* sweep = study.subtable("sweep");
  if (sweep == nullptr) return keys;
  for (const auto& [key, node] : *sweep) {
    const std::string name(key.str());
    if (const toml::table* of_owner = node.as_table()) {  // IK-BA.alpha, without quotes
      for (const auto& [setting, values] : *of_owner) keys.push_back({name, std::string(setting.str()), &values});
      continue;
    }
    const std::size_t dot = name.rfind('.');
    const bool has_owner = dot != std::string::npos;
    keys.push_back({has_owner ? name.substr(0, dot) : "", has_owner ? name.substr(dot + 1) : name, &node});
  }
  return keys;
}

// The way in which a key names the entry. A later one replaces the values of an earlier one.
enum class Names { not_it, every_solver, its_solver, its_label };

Names names_of(const SweptKey& key, const SolverEntry& entry) {
  if (key.owner == entry.label) return Names::its_label;
  if (key.owner == entry.solver) return Names::its_solver;
  const bool has_setting = key.setting == population_key || options_with(entry, {}).contains(key.setting);
  return key.owner.empty() && has_setting ? Names::every_solver : Names::not_it;
}

void refuse_unused(const TomlReader& study, const std::vector<SweptKey>& keys, const std::vector<SolverEntry>& entries,
                   const std::vector<LeftOut>& left_out) {
  for (const SweptKey& key : keys) {
    if (key.is_used || std::ranges::find(left_out, key.owner, &LeftOut::label) != left_out.end()) continue;
    std::set<std::string> owners, settings{std::string(population_key)};
    for (const SolverEntry& entry : entries) {
      owners.insert({entry.family.empty() ? entry.label : entry.family, entry.solver});
      for (const auto& [option, value] : options_with(entry, {})) settings.insert(option);
    }
    const bool has_owner = !key.owner.empty();
    const std::set<std::string>& known = has_owner ? owners : settings;
    throw mistake(study.nested(study.table(), "sweep."), key.values, has_owner ? key.owner : key.setting,
                  unknown_name(has_owner ? "solver" : "setting to sweep", has_owner ? key.owner : key.setting,
                               {known.begin(), known.end()}));
  }
}

// One entry per combination of the values; the last setting varies fastest. The entry itself if nothing is swept.
std::vector<SolverEntry> combinations(const TomlReader& reader, const SolverEntry& entry, const Axes& axes) {
  if (axes.empty()) return {entry};
  std::vector<std::size_t> counts;
  double product = 1;
  for (const auto& [setting, values] : axes) {
    counts.push_back(values.size());
    product *= static_cast<double>(values.size());
  }
  if (product > most_swept) {
    throw std::invalid_argument(fmt::format("{}the sweep of {} makes {} = {:.0f} entries; expected at most {}",
                                            reader.where(reader.table().source(), "solvers"), entry.label,
                                            fmt::join(counts, " x "), product, most_swept));
  }
  SolverEntry base = entry;
  base.family = entry.label;
  std::vector<SolverEntry> entries{base};
  for (const auto& [setting, values] : axes) {
    std::vector<SolverEntry> longer;
    for (const SolverEntry& shorter : entries) {
      for (const std::string& value : values) {
        SolverEntry& one = longer.emplace_back(shorter);
        give(one, setting, value);
        one.swept[setting] = value;
        one.label += fmt::format(" {}={}", setting, value);
      }
    }
    entries = std::move(longer);
  }
  if (!std::ranges::all_of(entries, TomlReader::is_plain, &SolverEntry::label)) {
    throw std::invalid_argument(
        fmt::format("{}the sweep of {} makes a label of more than 200 bytes; expected a shorter label",
                    reader.where(reader.table().source(), "solvers"), entry.label));
  }
  return entries;
}

std::vector<SolverEntry> read_solver(TomlReader reader, std::vector<SweptKey>& sweep) {
  SolverEntry entry;
  read_kind(reader, entry);
  entry.label = entry.solver;
  reader.text("label", entry.label, "");
  if (entry.label.empty() || entry.label.front() == ' ' || entry.label.back() == ' ')
    reader.fail("label", *reader.find("label"), "a label that is not empty, without spaces at its ends");
  reader.choice("if_missing", entry.if_missing, if_missing_choices, "");
  reader.text("colour", entry.colour, "");
  if (!entry.colour.empty() && !results::hex_colour(entry.colour))
    reader.fail("colour", *reader.find("colour"), results::expected_colour());
  Axes axes;
  const TomlReader settings = reader.nested(reader.table(), entry.label + ".");
  if (const toml::node* node = reader.find(population_key))
    read_setting(settings, entry, axes, std::string(population_key), *node);
  if (const toml::table* options = reader.subtable("options")) {
    for (const auto& [key, node] : *options) read_setting(settings, entry, axes, std::string(key.str()), node);
  }
  for (const Names names : {Names::every_solver, Names::its_solver, Names::its_label}) {
    for (SweptKey& key : sweep) {
      if (names_of(key, entry) != names) continue;
      axes[key.setting] = values_in(settings, entry, key.setting, *key.values);
      key.is_used = true;
    }
  }
  reader.refuse_unknown_keys();
  return combinations(reader, entry, axes);
}

}  // namespace

std::filesystem::path folder_of(const TomlReader& reader, std::string_view key) {
  const toml::node* const node = reader.table().get(key);
  const std::string where = reader.where(node == nullptr ? reader.table().source() : node->source(), key);
  return where.starts_with(override_source) ? std::filesystem::path() : reader.source().parent_path();
}

std::vector<LeftOut> leave_out(toml::table& study) {
  std::vector<LeftOut> left_out;
  toml::array* const entries = study["solvers"].as_array();
  if (entries == nullptr) return left_out;
  const std::vector<MissingPeer> missing = missing_peers();
  for (auto element = entries->begin(); element != entries->end();) {
    const toml::table* const entry = element->as_table();
    const auto text = [&](const char* key) { return entry == nullptr ? "" : (*entry)[key].value_or(std::string()); };
    const auto peer = std::ranges::find(missing, text("solver"), &MissingPeer::name);
    if (peer == missing.end() || text("if_missing") != "leave_out") {
      ++element;
      continue;
    }
    const std::string label = text("label");
    left_out.push_back({label.empty() || !TomlReader::is_plain(label) ? peer->name : label, peer->how});
    element = entries->erase(element);
  }
  return left_out;
}

std::vector<SolverEntry> read_solvers(TomlReader& study, const std::vector<LeftOut>& left_out) {
  const toml::node* node = study.find("solvers");
  const toml::array* array = node == nullptr ? nullptr : node->as_array();
  const std::string expected = "at least one [[solvers]] entry with solver = \"...\"";
  if (node == nullptr)
    throw std::invalid_argument(study.where(study.table().source(), "solvers") +
                                "the study names no solver; expected " + expected);
  if (array == nullptr || array->empty() || array->size() > 1000 || !array->is_homogeneous<toml::table>()) {
    study.fail("solvers", *node, expected);
  }
  std::vector<SweptKey> sweep = swept_keys(study);
  std::vector<SolverEntry> entries;
  std::set<std::string> labels;
  for (const toml::node& element : *array) {
    for (SolverEntry& entry : read_solver(study.nested(*element.as_table(), "solvers."), sweep)) {
      if (!labels.insert(entry.label).second) {
        throw std::invalid_argument(
            fmt::format("{}label \"{}\" is used twice; expected a different label for each entry of [[solvers]]",
                        study.where(element.source(), "solvers"), entry.label));
      }
      entries.push_back(std::move(entry));
    }
  }
  refuse_unused(study, sweep, entries, left_out);
  const bool is_swept = std::ranges::any_of(entries, [](const SolverEntry& entry) { return !entry.swept.empty(); });
  if (is_swept && entries.size() > most_swept) {
    throw std::invalid_argument(fmt::format("{}the sweeps make {} entries of [[solvers]]; expected at most {}",
                                            study.where(node->source(), "solvers"), entries.size(), most_swept));
  }
  return entries;
}

}  // namespace ikbench::experiments
