#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "base/json.hpp"
#include "base/names.hpp"
#include "base/number.hpp"
#include "experiments/external/answers.hpp"
#include "experiments/external/program.hpp"
#include "experiments/study/reader_internal.hpp"
#include "experiments/task.hpp"

namespace ikbench::experiments {

using namespace base;
using namespace solvers;
using namespace results;

namespace {

constexpr std::array<std::string_view, 2> if_missing_choices{"refuse", "skip"};

// Throws SkippedSolver if the entry may be left out; its library or program is missing for the reason `why`.
void skip_if_allowed(TomlReader& entry, const std::string& what, const std::string& why) {
  IfMissing if_missing = IfMissing::refuse;
  entry.choice("if_missing", if_missing, if_missing_choices);
  if (if_missing == IfMissing::refuse) return;
  SkippedSolver skipped{.label = what, .reason = why};
  entry.text("label", skipped.label);
  throw skipped;
}

// Reads the answers of an entry that were made elsewhere. Throws AwaitedSolver if there is no such file, or
// SkippedSolver if the entry may be left out.
void read_given(TomlReader& reader, SolverEntry& entry, const Robot& arm) {
  constexpr std::string_view key = "answers";
  std::string name;
  reader.text(key, name, "");
  if (name.empty()) throw reader.mistake(key, "an empty name; expected a file such as \"moveit.csv\"");
  entry.solver = elsewhere;
  const std::filesystem::path folder = base_folder(reader, key);
  entry.answers = with_key_context(reader, key, [&] { return read_answers(name, folder, arm); });
  if (entry.answers) return;
  const std::string file = (folder / name).string();
  skip_if_allowed(reader, std::string(elsewhere), fmt::format("there is no file {}", file));
  AwaitedSolver awaited{.label = std::string(elsewhere), .file = file};
  reader.text("label", awaited.label);
  throw awaited;
}

// Reads the kind of an entry: a built-in solver, a program, or answers. Throws SkippedSolver if the entry may be left
// out, and its program does not start or this program was built without its library; throws as read_given.
void read_kind(TomlReader& reader, SolverEntry& entry, const Robot& arm) {
  reader.text("solver", entry.solver);
  const bool is_program = reader.find("process") != nullptr, is_given = reader.find("answers") != nullptr;
  const bool is_built_in = reader.find("solver") != nullptr;
  if (is_program + is_given + is_built_in != 1) {
    throw std::invalid_argument(
        reader.where(reader.table().source(), "solver") +
        (is_program || is_given ? "a [[solvers]] has two of `solver`, `process` and `answers`; expected one of them"
                                : "a [[solvers]] has no `solver`, `process` or `answers`; see: ikbench list solvers"));
  }
  if (is_program) {
    entry.program = read_program(reader, true);
    entry.solver = entry.program->hello.name;
    return;
  }
  if (is_given) return read_given(reader, entry, arm);
  for (const MissingPeer& peer : missing_peers()) {
    if (peer.name == entry.solver) skip_if_allowed(reader, entry.solver, peer.how);
  }
  with_key_context(reader, "solver", [&] { return solver(entry.solver); });
}

// Returns the value of a setting: the population or an option. `settings` names the entry's label before its keys.
Setting value_in(const TomlReader& settings, const SolverEntry& entry, const std::string& setting,
                 const toml::node& node) {
  if (setting == population_key) {
    const toml::value<std::int64_t>* value = node.as_integer();
    if (value == nullptr || value->get() < population_range.first || value->get() > population_range.second) {
      settings.fail_number(
          setting, node, fmt::format("a whole number from {} to {}", population_range.first, population_range.second));
    }
    return static_cast<double>(value->get());
  }
  Setting value;
  if (const auto quoted = node.value<std::string>()) {
    if (!is_plain(*quoted)) settings.fail(setting, node, plain_text);
    const Settings defaults = entry_options(entry, {});
    const auto by_default = defaults.find(setting);
    const bool is_number = by_default != defaults.end() && std::holds_alternative<double>(by_default->second);
    if (const auto number = number_from(*quoted); number && is_number)
      settings.fail(setting, node,
                    std::isfinite(*number) ? fmt::format("a number, without quotes: {}", *number) : "a finite number");
    value = *quoted;
  } else if (const auto* const whole = node.as_integer()) {
    value = static_cast<double>(whole->get());
    const std::string digits = std::to_string(whole->get());
    // A number of more digits than a double has stays a text, which no option accepts.
    if (fmt::format("{:.0f}", std::get<double>(value)) != digits) value = digits;
  } else if (const auto* const number = node.as_floating_point()) {
    value = number->get();
  } else {
    settings.fail(setting, node, "a number or a quoted string, or a list of them");
  }
  try {
    entry_options(entry, {{setting, value}});
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(settings.where(node.source(), setting) + error.what());
  }
  return value;
}

// Sets the population or an option of an entry.
void set_setting(SolverEntry& entry, const std::string& setting, const Setting& value) {
  if (setting == population_key)
    entry.population = static_cast<int>(std::get<double>(value));
  else
    entry.options[setting] = value;
}

// The swept settings, each with its values.
using Axes = std::map<std::string, std::vector<Setting>>;

// Reads a setting of the entry: one value, or a list of them, which is swept.
void read_setting(const TomlReader& settings, SolverEntry& entry, Axes& axes, const std::string& setting,
                  const toml::node& node) {
  const toml::array* const list = node.as_array();
  if (list == nullptr) return set_setting(entry, setting, value_in(settings, entry, setting, node));
  if (list->empty() || list->size() > max_solvers)
    settings.fail(setting, node, fmt::format("a list of 1 to {} values", max_solvers));
  std::vector<Setting> values;
  for (const toml::node& element : *list) {
    values.push_back(value_in(settings, entry, setting, element));
    if (std::ranges::count(values, values.back()) > 1) settings.fail(setting, element, "each value once");
  }
  axes[setting] = std::move(values);
}

const std::string too_many_solvers = fmt::format("more than {0} solvers; expected at most {0}", max_solvers);

// Returns one entry per combination of the values; the last setting varies fastest. Returns the entry itself if nothing
// is swept.
std::vector<SolverEntry> combinations(const TomlReader& reader, const SolverEntry& entry, const Axes& axes) {
  const auto refuse_if = [&](bool is_wrong, std::string_view what) {
    if (is_wrong)
      throw std::invalid_argument(fmt::format("{}the sweep of {} makes {}",
                                              reader.where(reader.table().source(), "solvers"), entry.label, what));
  };
  std::vector<SolverEntry> entries{entry};
  if (!axes.empty()) entries.front().sweep_base = entry.label;
  for (const auto& [setting, values] : axes) {
    refuse_if(entries.size() * values.size() > max_solvers, too_many_solvers);
    std::vector<SolverEntry> longer;
    for (const SolverEntry& shorter : entries) {
      for (const Setting& value : values) {
        SolverEntry& combined = longer.emplace_back(shorter);
        set_setting(combined, setting, value);
        combined.label += fmt::format(" {}={}", setting, text_of(value));
      }
    }
    entries = std::move(longer);
  }
  refuse_if(!std::ranges::all_of(entries, is_plain, &SolverEntry::label),
            "a label of more than 200 bytes; expected a shorter label");
  return entries;
}

// Checks an entry of a program against the study. A program may decline more targets later.
void check_program(const TomlReader& at_entry, const SolverEntry& entry, const Study& study) {
  const Hello& hello = entry.program->hello;
  if (!hello.solves(goal_kind(study.search)))
    throw at_entry.mistake(
        "process", fmt::format("{} solves for {}; expected another search", hello.name, fmt::join(hello.goals, ", ")));
  if (entry.program->choice.batch == 0) return;
  if (!hello.takes_batches)
    throw at_entry.mistake("batch", entry.solver + " takes no batches: its hello does not have \"batch\": true");
  if (study.is_chained())
    throw at_entry.mistake("batch", "each solve starts at the previous answer; expected another start");
}

// Refuses answers that were made elsewhere in a study whose targets or joints no other solver can know.
void check_given(const TomlReader& at_entry, const Study& study) {
  if (study.is_chained())
    throw at_entry.mistake("answers",
                           "start is \"previous\", so that each target begins at the answer before; expected "
                           "another start, such as \"middle\"");
  if (study.search == Search::wrist || study.search == Search::flange)
    throw at_entry.mistake("answers",
                           "answers have all joints; expected search = \"pose\", \"axis\" or \"all_joints\"");
}

// Returns why an entry of a grid is left out: the arm decides the goal, and the solver may not solve for such a goal.
// Returns an empty text if the entry is not left out.
std::string why_left_out(const Study& study, const SolverEntry& entry, const Robot& arm) {
  const bool may_be_skipped = study.path->grid() != nullptr && entry.if_missing == IfMissing::skip;
  if (!may_be_skipped || entry.program || entry.answers) return "";
  return solver(entry.solver).why_not(arm.chain, goal_kind(study.search));
}

// Checks an entry against the study. `at_entry` names the label before its keys.
void check_entry(const TomlReader& reader, const TomlReader& at_entry, const SolverEntry& entry, const Study& study,
                 const Robot& arm) {
  if (entry.program) return check_program(at_entry, entry, study);
  if (entry.answers) return check_given(at_entry, study);
  const SolverInfo info = solver(entry.solver);
  if (const std::string why = info.why_not(arm.chain, goal_kind(study.search)); !why.empty())
    throw at_entry.mistake("solver", why);
  if (const int population = effective_population(study, entry); population < info.min_population) {
    throw(entry.population > 0 ? at_entry : reader)
        .mistake(population_key, fmt::format("population is {}, but {} needs at least {}", population, entry.solver,
                                             info.min_population));
  }
  const auto bounds = entry.options.find("bounds");
  if (study.limits == LimitPolicy::enforced && bounds != entry.options.end() && bounds->second == Setting("initial")) {
    const toml::table* const options = at_entry.table()["options"].as_table();
    throw(options == nullptr ? at_entry : at_entry.nested(*options, at_entry.prefix()))
        .mistake("bounds", bounds_need_recorded_limits);
  }
}

// Reads an entry. A setting that has a list of values makes one entry per combination, as "IK-BA population=20".
std::vector<SolverEntry> read_entry(TomlReader reader, const Robot& arm) {
  SolverEntry entry;
  read_kind(reader, entry, arm);
  entry.label = entry.solver;
  reader.text("label", entry.label);
  if (entry.label.empty() || entry.label.front() == ' ' || entry.label.back() == ' ')
    reader.fail("label", *reader.find("label"), "a label that is not empty, without spaces at its ends");
  reader.choice("if_missing", entry.if_missing, if_missing_choices);
  reader.text("colour", entry.colour);
  if (!entry.colour.empty() && !hex_colour(entry.colour))
    reader.fail("colour", *reader.find("colour"), std::string(expected_colour));
  Axes axes;
  const TomlReader settings = reader.nested(reader.table(), entry.label + ".");
  if (const toml::node* node = reader.find(population_key))
    read_setting(settings, entry, axes, std::string(population_key), *node);
  if (const toml::table* options = reader.subtable("options")) {
    for (const auto& [key, node] : *options) read_setting(settings, entry, axes, std::string(key.str()), node);
  }
  reader.refuse_unknown_keys();
  return combinations(reader, entry, axes);
}

}  // namespace

std::shared_ptr<const Program> read_program(TomlReader& reader, bool is_of_entry) {
  constexpr std::string_view key = "process";
  ProgramSpec choice;
  list_fields(reader, choice);
  if (choice.process.empty() || choice.process[0].empty())
    throw reader.mistake(key, reader.prefix() + "process is missing or empty; expected a program, and its arguments");
  try {
    return probe(choice, base_folder(reader, key));
  } catch (const std::invalid_argument& error) {
    if (is_of_entry) skip_if_allowed(reader, choice.process[0], error.what());
    throw reader.mistake(key, fmt::format("{}: {}{}", choice.process[0], error.what(),
                                          is_of_entry ? "; see: ikbench check-solver" : ""));
  }
}

void read_solvers(TomlReader& reader, Study& study, const Robot& arm) {
  constexpr std::string_view key = "solvers", expected = "1 to 400 tables [[solvers]] with solver = \"...\"";
  std::set<std::string> labels;
  const auto take_label = [&](const std::string& label, const toml::table& table) {
    if (labels.insert(label).second) return;
    throw std::invalid_argument(
        fmt::format("{}label \"{}\" is used twice; expected a different label for each of [[solvers]]",
                    reader.where(table.source(), key), label));
  };
  for (const toml::table* const table : reader.tables(key, max_solvers, expected)) {
    std::vector<SolverEntry> entries;
    try {
      entries = read_entry(reader.nested(*table, "solvers."), arm);
    } catch (const SkippedSolver& skipped) {
      study.skipped.push_back(skipped);
    } catch (const AwaitedSolver& awaited) {
      take_label(awaited.label, *table);
      check_given(reader.nested(*table, awaited.label + "."), study);
      study.awaited.push_back(awaited);
    }
    for (SolverEntry& entry : entries) {
      take_label(entry.label, *table);
      if (const std::string why = why_left_out(study, entry, arm); !why.empty()) {
        study.skipped.push_back({.label = entry.label, .reason = why});
        continue;
      }
      check_entry(reader, reader.nested(*table, entry.label + "."), entry, study, arm);
      if (study.solvers.size() == max_solvers) throw reader.mistake(key, "the entries make " + too_many_solvers);
      study.solvers.push_back(std::move(entry));
    }
  }
  if (study.solvers.empty() && study.awaited.empty()) reader.fail(key, *reader.find(key), expected);
}

}  // namespace ikbench::experiments
