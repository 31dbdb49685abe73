#include "experiments/study/writer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "base/json.hpp"
#include "base/toml_table.hpp"
#include "experiments/external/answers.hpp"
#include "experiments/external/program.hpp"
#include "experiments/study/reader.hpp"
#include "experiments/study/series_key.hpp"
#include "experiments/study/study_fields.hpp"
#include "experiments/study/written_fields.hpp"
#include "results/record.hpp"
#include "robots/arm_fields.hpp"
#include "robots/urdf.hpp"
#include "solvers/registry.hpp"

namespace ikbench::experiments {

using namespace base;
using namespace robots;
using namespace solvers;
using namespace results;

namespace {

std::string toml_text(const OrderedJson& value) {
  if (value.is_string()) return toml_string(value.get<std::string>());
  if (value.is_array()) {
    std::vector<std::string> texts;
    for (const OrderedJson& element : value) texts.push_back(toml_text(element));
    return fmt::format("[{}]", fmt::join(texts, ", "));
  }
  if (!value.is_number_float()) return base::text_of(value);
  const auto number = value.get<double>();  // "-0" would be read as the integer 0
  return number == 0 && std::signbit(number) ? "-0.0" : fmt::format("{}", number);
}

// ---- JSON ---------------------------------------------------------------------------------------------------------

// Returns the fields as members of an object. Poses are left out, because every solve has its target.
OrderedJson json_of(const WrittenFields& fields, OrderedJson json = {}) {
  for (const WrittenField& field : fields) {
    if (field.poses == nullptr) json[field.key] = field.json;
  }
  return json;
}

// Returns the study with its initial configuration in the units of files.
Study as_in_files(Study study) {
  const Configuration units = joint_units(robot_of(study).chain);
  for (Eigen::Index j = 0; j < study.initial.size(); ++j) study.initial[j] = in_unit(study.initial[j], units[j]);
  return study;
}

// Returns how a program is started, without the settings that have their defaults.
OrderedJson program_json(ProgramSpec choice) {
  ProgramSpec by_default;
  const WrittenFields fields = written_fields(choice);
  const WrittenFields defaults = written_fields(by_default);
  OrderedJson json;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (fields[i].text != defaults[i].text) json[fields[i].key] = fields[i].json;
  }
  return json;
}

// Returns an entry as in a study file, but without its colour. The colours are among the keys of the figures.
OrderedJson entry_definition(const SolverEntry& entry) {
  OrderedJson json = {{"label", entry.label}};
  if (entry.program)
    json.update(program_json(entry.program->choice));
  else if (entry.answers)
    json["answers"] = entry.answers->file;
  else
    json["solver"] = entry.solver;
  if (entry.population > 0) json["population"] = entry.population;
  if (entry.if_missing == IfMissing::skip) json["if_missing"] = "skip";
  for (const auto& [name, setting] : entry.options) {
    auto& option = json["options"][name];
    std::visit([&](const auto& value) { option = value; }, setting);
  }
  return json;
}

// Returns the requirements as [require] has them: "mine.solved": "95%".
OrderedJson requirements_json(const std::vector<results::Requirement>& requirements) {
  OrderedJson json;
  for (const results::Requirement& requirement : requirements) {
    const std::string text = requirement.text();
    const std::size_t equals = text.rfind('=');
    json[text.substr(0, equals)] = text.substr(equals + 1);
  }
  return json;
}

// Returns the study as in a study file.
OrderedJson definition(const Study& study) {
  Study fields = as_in_files(study);
  OrderedJson json = json_of(written_fields(fields));
  json["analysis"] = json_of(written_fields(fields.plan));
  for (const SolverEntry& entry : study.solvers) {
    if (!entry.colour.empty()) fields.figures.colours.emplace(entry.label, entry.colour);
  }
  if (fields.figures != FigureStyle()) json["figures"] = json_of(written_fields(fields.figures));
  if (!fields.figures.colours.empty()) json["figures"]["colours"] = fields.figures.colours;
  json["stop"] = json_of(written_fields(fields.stop));
  if (!study.requirements.empty()) json["require"] = requirements_json(study.requirements);
  if (!study.sweep.name.empty()) {
    json["sweep"]["name"] = study.sweep.name;
    for (const auto& [key, value] : study.sweep.values)
      json["sweep"]["values"].push_back({{"key", key}, {"value", value}});
  }
  if (fields.loop.period > 0) json["loop"] = json_of(written_fields(fields.loop));
  if (study.checker) {
    json["check"] = json_of(written_fields(fields.check));
    json["check"]["process"] = study.check.process;
    json["check"]["files"] = study.checker->choice.files;
    json["check"].update(program_json(study.checker->choice));
  }
  for (const SolverEntry& entry : study.solvers) json["solvers"].push_back(entry_definition(entry));
  if (is_urdf_file(study.robot)) json["urdf"] = json_of(written_fields(fields.urdf));
  json["path"] = json_of(written_fields(fields.path), {{"kind", fields.path->name()}});
  if (fields.path->is_random())
    json["path"]["targets"] = "drawn";  // `analysis` needs to know only this of a kind of path
  return json;
}

// Returns the arm as in its file, so that readers of the store can draw it.
OrderedJson arm_definition(const Robot& arm) {
  OrderedJson json;
  for (Eigen::Index j = 0; j < arm.joints(); ++j) {
    LimitedLink link{arm.chain.links()[static_cast<std::size_t>(j)], {arm.limits.lower[j], arm.limits.upper[j]}};
    link.has_beta = link.link.beta != 0;
    json["links"].push_back(json_of(written_fields(link)));
  }
  std::size_t joint = 0;
  for (const std::string& name : joint_names(arm.description)) json["links"][joint++]["name"] = name;
  if (arm.velocity.size() > 0)
    json["velocity_deg_s"] = in_units((arm.velocity.array() / joint_units(arm.chain).array()).eval(), 1);
  if (!arm.tip_link.empty()) {
    json["base_link"] = arm.base_link;
    json["tip_link"] = arm.tip_link;
  }
  if (!arm.notes.empty()) json["notes"] = arm.notes;
  for (auto [key, frame] : {std::pair{"base", arm.chain.base()}, std::pair{"tool", arm.chain.tool()}})
    json[key] = json_of(written_fields(frame));
  return json;
}

// Returns the built-in study of the same paper that is most like this one: by the kind of path, then by the arm.
std::optional<Study> original_of(const Study& study) {
  const std::vector<Study> known = built_in_studies();
  const auto likeness = [&](const Study& candidate) {
    if (study.published.empty() || candidate.published != study.published) return 0;
    return 1 + (candidate.path->name() == study.path->name() ? 2 : 0) + (candidate.robot == study.robot ? 1 : 0);
  };
  const auto original = std::ranges::max_element(known, {}, likeness);  // the first of equals
  if (original == known.end() || likeness(*original) == 0) return std::nullopt;
  return *original;
}

// Returns true if a setting, named as in a flat definition, may differ from the original study. The options of solvers
// are compared apart. The arm may differ if the targets are random, because each row of a table may have its own arm.
// The limits of the arm may then move the initial configuration.
bool may_differ(const std::string& pointer, const Study& original) {
  constexpr std::array<std::string_view, 5> free_settings{"/name", "/title", "/seed", "/trace", "/rounds"};
  constexpr std::array<std::string_view, 4> free_tables{"/analysis/", "/figures/", "/require/", "/solvers/"};
  const bool is_of_arm = pointer == "/robot" || pointer.starts_with("/initial_deg");
  if (is_of_arm && original.path->name() == "random") return true;
  return std::ranges::find(free_settings, pointer) != free_settings.end() ||
         std::ranges::any_of(free_tables, [&](std::string_view table) { return pointer.starts_with(table); });
}

// Returns the settings in which a study differs from the original.
std::vector<std::string> departures(const Study& study, const Study& original) {
  std::vector<std::string> keys;
  const auto of_study = definition(study).flatten();
  const auto of_original = definition(original).flatten();
  for (const auto& [pointer, value] : of_original.items()) {
    if (may_differ(pointer, original) || (of_study.contains(pointer) && of_study[pointer] == value)) continue;
    std::string name = pointer.substr(1);
    std::replace(name.begin(), name.end(), '/', '.');
    keys.push_back(name);
  }
  if (study.checker) keys.emplace_back("check");
  for (const SolverEntry& entry : original.solvers) {
    const auto with_label = std::ranges::find(study.solvers, entry.label, &SolverEntry::label);
    if (with_label == study.solvers.end()) continue;
    if (with_label->solver != entry.solver || with_label->population != entry.population ||
        effective_options(study, *with_label) != effective_options(original, entry)) {
      keys.push_back("options of " + entry.label);
    }
  }
  return keys;
}

// ---- TOML ---------------------------------------------------------------------------------------------------------

// Returns a line "key = value", with its meaning as a comment if that is not empty.
std::string line(std::string_view key, std::string_view value, std::string_view meaning) {
  return meaning.empty() ? fmt::format("{} = {}\n", key, value) : fmt::format("{} = {}  # {}\n", key, value, meaning);
}

// Returns the fields as lines, and poses as a list of tables.
std::string lines_of(const WrittenFields& fields) {
  std::string text;
  for (const auto& [key, json, exact_text, meaning, in_key, poses] : fields) {
    if (poses == nullptr) {
      text += line(key, toml_text(json), meaning);
      continue;
    }
    text += fmt::format("{} = [\n", key);
    for (const Pose& pose : *poses) {
      text += fmt::format("  {{ position_m = {}, rotation = {} }},\n", toml_text(in_units(pose.translation(), 1)),
                          toml_text(row_major(pose.linear())));
    }
    text += "]\n";
  }
  return text;
}

// Returns the lines of an entry, below [[solvers]].
std::string lines_of_entry(const SolverEntry& entry) {
  std::string text = line("label", toml_string(entry.label), "");
  if (entry.program) {
    ProgramSpec choice = entry.program->choice;
    text += lines_of(written_fields(choice));
  } else if (entry.answers) {
    text += line("answers", toml_string(entry.answers->file), "made elsewhere: run, point and a column per joint");
  } else {
    text += line("solver", toml_string(entry.solver), "options and ranges: ikbench list solvers " + entry.solver);
  }
  if (entry.population > 0)
    text += line("population", fmt::format("{}", entry.population), "overrides the population of the study");
  if (!entry.colour.empty())
    text += line("colour", toml_string(entry.colour), "colour of the solver in every figure: \"#RRGGBB\"");
  if (entry.if_missing == IfMissing::skip)
    text += line("if_missing", "'skip'", "what to do if the solver was not built: continue without it, or refuse");
  std::vector<std::string> options;
  for (const auto& [name, setting] : entry.options) {
    const std::string value = text_of(setting);
    options.push_back(name + " = " + (std::holds_alternative<double>(setting) ? value : toml_string(value)));
  }
  if (!options.empty()) text += line("options", fmt::format("{{ {} }}", fmt::join(options, ", ")), "");
  return text;
}

// Returns [require] as a study file has it; empty if nothing is required.
std::string requirement_lines(const std::vector<results::Requirement>& requirements) {
  if (requirements.empty()) return "";
  std::string text = "\n[require]  # shares that the solvers must show; they do not affect the solves\n";
  const OrderedJson shares = requirements_json(requirements);
  for (const auto& [name, share] : shares.items())
    text += line(toml_string(name), toml_string(share.get<std::string>()), "");
  return text;
}

}  // namespace

std::string to_toml(Path path) {
  std::vector<std::string_view> kinds;
  for (const Path& kind : target_sets()) kinds.push_back(kind->name());
  return "[path]\n" +
         line("kind", toml_string(path->name()), fmt::format("{}; see: ikbench list paths", fmt::join(kinds, " | "))) +
         lines_of(written_fields(path));
}

std::string to_toml(FigureStyle style) { return lines_of(written_fields(style)); }

std::string to_toml(const Study& study) {
  Study fields = as_in_files(study);
  if (study.initial == default_configuration(robot_of(study)))
    fields.initial.resize(0);  // does not depend on the arm then
  std::string text = lines_of(written_fields(fields));
  text += "\n[analysis]  # how the results are judged; it does not affect the solves\n" +
          lines_of(written_fields(fields.plan)) + requirement_lines(study.requirements) +
          "\n[figures]  # their style; it affects neither the solves nor how they are judged\n" +
          to_toml(fields.figures);
  if (is_urdf_file(study.robot)) text += "\n[urdf]\n" + lines_of(written_fields(fields.urdf));
  text += "\n[stop]\n" + lines_of(written_fields(fields.stop)) + "\n[loop]\n" + lines_of(written_fields(fields.loop)) +
          '\n' + to_toml(fields.path);
  if (study.checker) {
    ProgramSpec choice = study.checker->choice;
    text += "\n[check]\n" + lines_of(written_fields(choice)) + lines_of(written_fields(fields.check));
  }
  for (const SkippedSolver& skipped : study.skipped)
    text += fmt::format("\n# left out: {} is {}\n", skipped.label, skipped.reason);
  for (const AwaitedSolver& awaited : study.awaited)
    text += fmt::format("\n# left out: {} has no answers to these targets yet, {}\n", awaited.label, awaited.file);
  for (const SolverEntry& entry : study.solvers) text += "\n[[solvers]]\n" + lines_of_entry(entry);
  return text;
}

namespace {

// Returns the definition of a study with what the study's settings decide: its points, arm, departures and reach.
OrderedJson stored_document(const Study& study) {
  OrderedJson json = definition(study);
  json["points"] = study.path->points();
  json["arm"] = arm_definition(robot_of(study));
  const std::optional<Study> original = original_of(study);
  json["departures"] = original ? departures(study, *original) : std::vector<std::string>();
  if (study.path->grid() != nullptr) {
    TargetGrid grid = *study.path->grid();
    json["grid"] = json_of(written_fields(grid));
  }
  const std::size_t unreachable = unreachable_targets(study).size();
  if (unreachable > 0) json["unreachable_targets"]["points"] = unreachable;
  return json;
}

}  // namespace

std::string to_json(const Study& study) { return base::text_of(stored_document(study)); }

Json arm_json(const Robot& arm) { return Json(arm_definition(arm)); }

std::string to_json(results::AnalysisPlan plan) { return base::text_of(json_of(written_fields(plan))); }

StoredStudy to_stored(const Study& study) {
  const OrderedJson document = stored_document(study);
  return {.name = study.name,
          .definition = definition_of(Json(document), base::text_of(document)),
          .series = series_of(study)};
}

}  // namespace ikbench::experiments
