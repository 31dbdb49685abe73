#include "experiments/study/writer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "base/json.hpp"
#include "base/number.hpp"
#include "base/toml_table.hpp"
#include "experiments/environment.hpp"
#include "experiments/external/program.hpp"
#include "experiments/study/reader.hpp"
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

template <class Values>
std::vector<double> in_units(const Values& values, double unit) {
  std::vector<double> result;
  for (const double value : values) result.push_back(in_unit(value, unit));
  return result;
}

// Returns every bit of the values as text.
template <class Values>
std::string exact(const Values& values) {
  std::string text;
  for (const double value : values) text += fmt::format("{} ", value);
  return text;
}

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

// Visits the fields of a list, and keeps each as JSON in units of files, and as text for a key, to the bit.
class Written final : public Fields {
 public:
  struct Field {
    std::string key;
    OrderedJson json;
    std::string text, meaning;
    InKey in_key = InKey::by_name;
    const std::vector<Pose>* poses = nullptr;
  };
  std::vector<Field> fields;

 private:
  void on_text(Name name, std::string& field) override { add(name, field, field); }
  void on_texts(Name name, std::vector<std::string>& field) override {
    std::vector<std::string> words;
    for (const std::string& word : field) words.push_back(base::text_of(base::Json(word)));
    add(name, field, field.empty() ? "" : fmt::format("{} {}", field.size(), fmt::join(words, "\n")));
  }
  void on_choice(Name name, std::size_t& chosen, const std::vector<std::string>& choices) override {
    add(name, choices.at(chosen), choices.at(chosen), choices);
  }
  void on_whole(Name name, std::int64_t& field, std::pair<std::int64_t, std::int64_t>) override {
    add(name, field, fmt::format("{}", field));
  }
  void on_number(Name name, double& field, double unit, std::pair<double, double>) override {
    add(name, in_unit(field, unit), fmt::format("{}", field));
  }
  void on_numbers(Name name, std::vector<double>& field, double unit, int) override {
    add(name, in_units(field, unit), exact(field));
  }
  void on_poses(Name name, std::any field) override {
    add(name, {}, "");
    fields.back().poses = std::any_cast<std::vector<Pose>*>(field);
  }

  void add(Name name, OrderedJson json, std::string text, const std::vector<std::string>& choices = {}) {
    const std::string names = choices.empty() ? "" : fmt::format("{}: ", fmt::join(choices, " | "));
    fields.push_back(
        {std::string(name.key), std::move(json), std::move(text), names + std::string(name.meaning), name.in_key});
  }
};

using FieldsWritten = std::vector<Written::Field>;

// `fields` has to outlive the result.
template <class Struct>
FieldsWritten written(Struct& fields) {
  Written all;
  list_fields(all, fields);
  return std::move(all.fields);
}

// ---- JSON ---------------------------------------------------------------------------------------------------------

// Leaves poses out, since every solve has its target.
OrderedJson json_of(const FieldsWritten& fields, OrderedJson json = {}) {
  for (const Written::Field& field : fields) {
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
OrderedJson start_of(ProgramSpec choice) {
  ProgramSpec by_default;
  const FieldsWritten fields = written(choice), defaults = written(by_default);
  OrderedJson json;
  for (std::size_t i = 0; i < fields.size(); ++i)
    if (fields[i].text != defaults[i].text) json[fields[i].key] = fields[i].json;
  return json;
}

// Returns an entry as in a study file. Its colour is among those of the figures.
OrderedJson entry_definition(const SolverEntry& entry) {
  OrderedJson json = {{"label", entry.label}};
  if (entry.program)
    json.update(start_of(entry.program->choice));
  else
    json["solver"] = entry.solver;
  if (entry.population > 0) json["population"] = entry.population;
  if (entry.if_missing == IfMissing::skip) json["if_missing"] = "leave_out";
  for (const auto& [name, setting] : entry.options)
    std::visit([&](const auto& value) { json["options"][name] = value; }, setting);
  return json;
}

OrderedJson definition(const Study& study) {
  Study fields = as_in_files(study);
  OrderedJson json = json_of(written(fields));
  json["analysis"] = json_of(written(fields.plan));
  for (const SolverEntry& entry : study.solvers) {
    if (!entry.colour.empty()) fields.figures.colours.emplace(entry.label, entry.colour);
  }
  if (fields.figures != FigureStyle()) json["figures"] = json_of(written(fields.figures));
  if (!fields.figures.colours.empty()) json["figures"]["colours"] = fields.figures.colours;
  json["stop"] = json_of(written(fields.stop));
  if (fields.loop.period > 0) json["loop"] = json_of(written(fields.loop));
  if (study.checker) {
    json["check"] = json_of(written(fields.check));
    json["check"]["process"] = study.check.process, json["check"]["files"] = study.checker->choice.files;
    json["check"].update(start_of(study.checker->choice));
  }
  for (const SolverEntry& entry : study.solvers) json["solvers"].push_back(entry_definition(entry));
  if (is_urdf_file(study.robot)) json["urdf"] = json_of(written(fields.urdf));
  json["path"] = json_of(written(fields.path), {{"kind", fields.path->name()}});
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
    json["links"].push_back(json_of(written(link)));
  }
  std::size_t joint = 0;
  for (const std::string& name : joint_names(arm.description)) json["links"][joint++]["name"] = name;
  if (arm.velocity.size() > 0)
    json["velocity_deg_s"] = in_units((arm.velocity.array() / joint_units(arm.chain).array()).eval(), 1);
  if (!arm.tip_link.empty()) json["base_link"] = arm.base_link, json["tip_link"] = arm.tip_link;
  if (!arm.notes.empty()) json["notes"] = arm.notes;
  for (auto [key, frame] : {std::pair{"base", arm.chain.base()}, std::pair{"tool", arm.chain.tool()}})
    json[key] = json_of(written(frame));
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

// Returns the settings in which a study differs from the original. These may differ freely: name, title, seed, trace,
// turns, the analysis, further solvers (of which options are compared below), and the arm if each has random targets of
// its own, as a row of a table.
std::vector<std::string> departures(const Study& study, const Study& original) {
  std::vector<std::string> keys;
  const auto ours = definition(study).flatten(), theirs = definition(original).flatten();
  for (const auto& [pointer, value] : theirs.items()) {
    const bool of_arm = pointer == "/robot" || pointer.starts_with("/initial_deg");  // limits of the arm may move it
    const bool is_free = pointer == "/name" || pointer == "/title" || pointer == "/seed" || pointer == "/trace" ||
                         pointer == "/turns" || (of_arm && original.path->name() == "random") ||
                         pointer.starts_with("/analysis/") || pointer.starts_with("/figures/") ||
                         pointer.starts_with("/solvers/");
    if (is_free || (ours.contains(pointer) && ours[pointer] == value)) continue;
    std::string name = pointer.substr(1);
    std::replace(name.begin(), name.end(), '/', '.');
    keys.push_back(name);
  }
  if (study.checker) keys.emplace_back("check");
  for (const SolverEntry& entry : original.solvers) {
    const auto same = std::ranges::find(study.solvers, entry.label, &SolverEntry::label);
    if (same == study.solvers.end()) continue;
    if (same->solver != entry.solver || same->population != entry.population ||
        effective_options(study, *same) != effective_options(original, entry)) {
      keys.push_back("options of " + entry.label);
    }
  }
  return keys;
}

// ---- TOML ---------------------------------------------------------------------------------------------------------

std::string line(std::string_view key, std::string_view value, std::string_view meaning) {
  return meaning.empty() ? fmt::format("{} = {}\n", key, value) : fmt::format("{} = {}  # {}\n", key, value, meaning);
}

std::string lines_of(const FieldsWritten& fields) {
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

// ---- keys ---------------------------------------------------------------------------------------------------------

// Returns the part of a key that names fields: "\nPREFIXname value" for each field that differs from its default.
template <class Struct>
std::string said_by_name(Struct fields, Struct defaults, std::string_view prefix = "") {
  const FieldsWritten ours = written(fields), theirs = written(defaults);
  std::string text;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    if (ours[i].in_key == InKey::by_name && ours[i].text != theirs.at(i).text)
      text += fmt::format("\n{}{} {}", prefix, ours[i].key, ours[i].text);
  }
  return text;
}

// Returns the part of a key for the targets. Fixed targets enter as poses, whatever their kind of path. Drawn ones
// enter as the fields of the path, the seed and the run.
std::string targets_text(const Study& study) {
  std::string text;
  if (!study.path->is_random()) {
    for (const Pose& target : targets_of_run(study, 1)) text += exact(target.matrix().reshaped());
    return text;
  }
  const std::vector<Path> kinds = target_sets();
  const auto defaults = std::ranges::find(kinds, study.path->name(), [](const Path& kind) { return kind->name(); });
  return fmt::format("{} {}", study.path->name(), study.path->points()) + said_by_name(study.path, *defaults);
}

}  // namespace

std::string to_toml(Path path) {
  std::vector<std::string_view> kinds;
  for (const Path& kind : target_sets()) kinds.push_back(kind->name());
  return "[path]\n" +
         line("kind", toml_string(path->name()), fmt::format("{}; see: ikbench list paths", fmt::join(kinds, " | "))) +
         lines_of(written(path));
}

std::string to_toml(FigureStyle style) { return lines_of(written(style)); }

std::string to_toml(const Study& study) {
  Study fields = as_in_files(study);
  if (study.initial == default_configuration(robot_of(study)))
    fields.initial.resize(0);  // does not depend on the arm then
  std::string text = lines_of(written(fields));
  text +=
      "\n[analysis]  # how the results are judged; it does not affect the solves\n" + lines_of(written(fields.plan)) +
      "\n[figures]  # their style; it affects neither the solves nor how they are judged\n" + to_toml(fields.figures);
  if (is_urdf_file(study.robot)) text += "\n[urdf]\n" + lines_of(written(fields.urdf));
  text += "\n[stop]\n" + lines_of(written(fields.stop)) + "\n[loop]\n" + lines_of(written(fields.loop)) + '\n' +
          to_toml(fields.path);
  if (study.checker) {
    ProgramSpec choice = study.checker->choice;
    text += "\n[check]\n" + lines_of(written(choice)) + lines_of(written(fields.check));
  }
  for (const SkippedSolver& left_out : study.skipped)
    text += fmt::format("\n# left out: {} is {}\n", left_out.label, left_out.reason);
  for (const SolverEntry& entry : study.solvers) {
    text += "\n[[solvers]]\n" + line("label", toml_string(entry.label), "");
    if (entry.program) {
      ProgramSpec choice = entry.program->choice;
      text += lines_of(written(choice));
    } else {
      text += line("solver", toml_string(entry.solver), "options and ranges: ikbench list solvers " + entry.solver);
    }
    if (entry.population > 0)
      text += line("population", fmt::format("{}", entry.population), "overrides the population of the study");
    if (!entry.colour.empty())
      text += line("colour", toml_string(entry.colour), "of the solver in every figure: \"#RRGGBB\"");
    if (entry.if_missing == IfMissing::skip)
      text +=
          line("if_missing", "'leave_out'", "where it was not built the study goes on without it; refuse: it does not");
    std::vector<std::string> options;
    for (const auto& [name, of_entry] : entry.options) {
      const std::string value = text_of(of_entry);
      options.push_back(name + " = " + (std::holds_alternative<double>(of_entry) ? value : toml_string(value)));
    }
    if (!options.empty()) text += line("options", fmt::format("{{ {} }}", fmt::join(options, ", ")), "");
  }
  return text;
}

std::string to_json(const Study& study) {
  OrderedJson json = definition(study);
  json["points"] = study.path->points();
  json["arm"] = arm_definition(robot_of(study));
  const std::optional<Study> original = original_of(study);
  json["departures"] = original ? departures(study, *original) : std::vector<std::string>();
  if (const auto beyond = unreachable_targets(study).size(); beyond > 0) json["unreachable_targets"]["points"] = beyond;
  return base::text_of(json);
}

Json arm_json(const Robot& arm) { return parsed_json(base::text_of(arm_definition(arm))); }

std::string to_json(results::AnalysisPlan plan) { return base::text_of(json_of(written(plan))); }

std::string configuration_key(const Study& study, const SolverEntry& entry) {
  // Writes the fields marked InKey::in_text. With another word or order here, all stored solves would be solved again.
  const Robot arm = robot_of(study);
  std::string text = "numerics 2\nrobot";
  text += arm.chain.definition() + exact(arm.limits.lower) + exact(arm.limits.upper) + "\ntargets ";
  text += targets_text(study);
  text += fmt::format("\ninitial {}\nsearch {} branch {} population {} seed {} trace {}", exact(study.initial),
                      static_cast<int>(study.search), static_cast<int>(study.wrist_branch),
                      effective_population(study, entry), study.seed, static_cast<int>(study.trace));
  text += fmt::format("\nstop {} {} {} {}", study.stop.iterations, study.stop.tolerance, study.stop.evaluations,
                      study.stop.seconds);
  // Other fields enter only if they differ from their defaults, so that a new field leaves stored solves as they are.
  text += said_by_name(study, Study{});
  text += said_by_name(study.stop, StopRule{}, "stop.");
  if (study.checker) {
    const std::vector<std::string> numbers = study.check.numbers();
    text += fmt::format("\ncheck {} files {} numbers {}", fmt::join(study.check.process, " "),
                        fmt::join(study.checker->choice.files, " "),
                        fmt::join(std::set<std::string>(numbers.begin(), numbers.end()), ", "));
  }
  // This binding does not compile with a new field of SolverEntry. Options and population enter as they are in effect,
  // whether a sweep chose them or not.
  [[maybe_unused]] const auto& [label, algorithm, options, population, program, if_missing, own, colour, family] =
      entry;
  text += fmt::format("\nsolver {} label {}", algorithm, label);
  if (program) text += said_by_name(program->choice, ProgramSpec{}, "program.");
  Settings in_effect = effective_options(study, entry);
  if (!program) {
    solver_info(entry).describe([&](const OptionList& list) {
      std::erase_if(in_effect, [&](const auto& setting) {
        const auto option = std::ranges::find(list.options(), setting.first, &Option::name);
        return option->is_later && option->get() == setting.second;
      });
    });
  }
  for (const auto& [name, value] : in_effect) text += fmt::format("\n{} = {}", name, text_of(value));
  return fmt::format("{:016x}", Key(0).with(text).value());
}

std::string source_digest_of(const SolverEntry& entry) {
  if (entry.program) return entry.program->digest;
  return entry.custom ? file_digest(executable_path()) : solver_source_digest(entry.solver);
}

std::string library_name(const SolverEntry& entry) { return entry.program ? "" : solver_info(entry).library; }

std::string source_key(const SolverEntry& entry) {
  Key source = Key(0).with(shared_source_digest()).with(source_digest_of(entry));
  if (const std::string library = library_name(entry); !library.empty()) source = source.with(library);
  return fmt::format("{}{:016x}", source_separator, source.value());
}

std::string series_key(const Study& study, const SolverEntry& entry) {
  const std::string& check = study.check.digest;
  return configuration_key(study, entry) + source_key(entry) +
         (check.empty() ? "" : fmt::format("{:016x}", Key(0).with(check).value()));
}

std::vector<Series> series_of(const Study& study) {
  std::vector<Series> all;
  for (const SolverEntry& entry : study.solvers) {
    Settings options = effective_options(study, entry);
    if (entry.program) {
      options["process"] = fmt::format("{}", fmt::join(entry.program->choice.process, " "));
      if (entry.program->choice.batch > 0) options["batch"] = static_cast<double>(entry.program->choice.batch);
    } else if (const SolverInfo& info = solver_info(entry); info.use) {
      info.use(options);
    }
    if (entry.population > 0 || (!entry.program && solver_info(entry).least_population > 0))
      options["population"] = static_cast<double>(effective_population(study, entry));
    Json values = Json::object();
    for (const auto& [name, value] : options) {
      const std::string text = text_of(value);
      const Json number = Json::parse(text, nullptr, false);
      values[name] = number.is_number() ? number : Json(text);
    }
    all.push_back({.key = series_key(study, entry),
                   .label = entry.label,
                   .algorithm = entry.solver,
                   .options = base::text_of(values)});
  }
  return all;
}

StoredStudy to_stored(const Study& study) {
  return {.name = study.name, .definition = parse_definition(to_json(study)), .series = series_of(study)};
}

}  // namespace ikbench::experiments
