#include "experiments/study_writer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>

#include "experiments/foreign/program.hpp"
#include "experiments/orientation.hpp"
#include "experiments/study_fields.hpp"
#include "experiments/study_reader.hpp"
#include "numerics/json.hpp"
#include "numerics/number.hpp"
#include "numerics/toml_table.hpp"
#include "robots/arm_fields.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace robots;
using namespace solvers;
using namespace results;

namespace {

std::vector<double> in_units(const Eigen::VectorXd& values, double unit) {
  std::vector<double> result;
  for (const double value : values) result.push_back(in_unit(value, unit));
  return result;
}

bool is_exact(const Eigen::VectorXd& values, double unit) {
  return std::all_of(values.begin(), values.end(), [&](double value) { return in_unit(value, unit) * unit == value; });
}

// "-0" would be read as the integer 0.
std::string numeral(double value) { return value == 0 && std::signbit(value) ? "-0.0" : fmt::format("{}", value); }

std::string numerals(const std::vector<double>& values) {
  std::vector<std::string> texts;
  for (const double value : values) texts.push_back(numeral(value));
  return fmt::format("[{}]", fmt::join(texts, ", "));
}

std::string toml_string(std::string_view text) {
  std::ostringstream out;
  out << toml::value<std::string>(text);
  return out.str();
}

class TomlWriter final : public Fields {
 public:
  void line(std::string_view key, std::string_view value, std::string_view meaning) {
    out += meaning.empty() ? fmt::format("{} = {}\n", key, value) : fmt::format("{} = {}  # {}\n", key, value, meaning);
  }

  // Used by the look of figures alone.
  template <class Enum>
  void chosen(std::string_view key, const std::vector<Enum>& field, const Choices<Enum>& choices,
              std::string_view meaning) {
    std::vector<std::string> values, names;
    for (const Enum value : field) values.push_back(toml_string(name_of(value)));
    for (const auto& [name, value] : choices) names.push_back(name);
    line(key, fmt::format("[{}]", fmt::join(values, ", ")), fmt::format("{}: {}", fmt::join(names, " | "), meaning));
  }

  std::string out;

 private:
  void on_text(Name name, std::string& field) override { line(name.key, toml_string(field), name.meaning); }
  void on_texts(Name name, std::vector<std::string>& field) override {
    std::vector<std::string> texts;
    for (const std::string& text : field) texts.push_back(toml_string(text));
    if (!texts.empty()) line(name.key, fmt::format("[{}]", fmt::join(texts, ", ")), name.meaning);
  }
  void on_choice(Name name, std::size_t& chosen, const std::vector<std::string>& choices) override {
    line(name.key, toml_string(choices[chosen]), fmt::format("{}: {}", fmt::join(choices, " | "), name.meaning));
  }
  void on_whole(Name name, std::int64_t& field, std::pair<std::int64_t, std::int64_t>) override {
    line(name.key, fmt::format("{}", field), name.meaning);
  }
  void on_number(Name name, double& field, double unit, std::pair<double, double>) override {
    line(name.key, numeral(in_unit(field, unit)), name.meaning);
  }
  void on_numbers(Name name, Eigen::VectorXd& field, double unit, int) override {
    line(name.key, numerals(in_units(field, unit)), name.meaning);
  }
  void on_poses(Name name, std::vector<Pose>& field) override {
    out += fmt::format("{} = [\n", name.key);
    for (const Pose& pose : field) {
      const Eigen::VectorXd position = pose.translation();
      const bool in_cm = is_exact(position, centimetre);
      out += fmt::format("  {{ {} = {}, rotation = {} }},\n", in_cm ? "position_cm" : "position_m",
                         numerals(in_units(position, in_cm ? centimetre : 1)), numerals(by_rows(pose.linear())));
    }
    out += "]\n";
  }
};

class JsonWriter final : public Fields {
 public:
  // Used by the look of figures alone.
  template <class Enum>
  void chosen(std::string_view key, const std::vector<Enum>& field, const Choices<Enum>&, std::string_view) {
    for (const Enum value : field) out[std::string(key)].push_back(name_of(value));
  }

  nlohmann::ordered_json out;

 private:
  void on_text(Name name, std::string& field) override { add(name, field); }
  void on_texts(Name name, std::vector<std::string>& field) override { add(name, field); }
  void on_choice(Name name, std::size_t& chosen, const std::vector<std::string>& choices) override {
    add(name, choices[chosen]);
  }
  void on_whole(Name name, std::int64_t& field, std::pair<std::int64_t, std::int64_t>) override { add(name, field); }
  void on_number(Name name, double& field, double unit, std::pair<double, double>) override {
    add(name, in_unit(field, unit));
  }
  void on_numbers(Name name, Eigen::VectorXd& field, double unit, int) override { add(name, in_units(field, unit)); }
  void on_poses(Name, std::vector<Pose>&) override {}  // every solve has its target

  void add(Name name, nlohmann::ordered_json value) { out[std::string(name.key)] = std::move(value); }
};

nlohmann::ordered_json json_of(results::Plan plan) {
  JsonWriter writer;
  list_fields(writer, plan);
  return writer.out;
}

nlohmann::ordered_json json_of(FigureStyle style) {
  JsonWriter writer;
  list_fields(writer, style);
  if (!style.colours.empty()) writer.out["colours"] = style.colours;
  return writer.out;
}

// The study with its initial configuration in the units of files.
Study as_in_files(Study study) {
  if (study.initial.size() == 0) return study;
  const Configuration units = joint_units(arm_of(study).chain);
  for (Eigen::Index j = 0; j < study.initial.size(); ++j) study.initial[j] = in_unit(study.initial[j], units[j]);
  return study;
}

nlohmann::ordered_json definition(const Study& study) {
  Study fields = as_in_files(study);
  JsonWriter writer, stop, path;
  list_fields(writer, fields);
  writer.out["analysis"] = json_of(study.analysis);
  FigureStyle style = study.figures;
  for (const SolverEntry& entry : study.solvers) {
    if (!entry.colour.empty()) style.colours.emplace(entry.label, entry.colour);
  }
  if (style != FigureStyle()) writer.out["figures"] = json_of(style);
  list_fields(stop, fields.stop);
  writer.out["stop"] = stop.out;
  if (is_urdf_file(study.robot)) {
    JsonWriter urdf;
    list_fields(urdf, fields.urdf);
    writer.out["urdf"] = urdf.out;
  }
  path.out["kind"] = fields.path->name();
  fields.path->list_fields(path);
  if (fields.path->is_drawn()) path.out["targets"] = "drawn";  // `analysis` needs to know only this of a kind of path
  writer.out["path"] = path.out;
  return writer.out;
}

// The arm as in its file, so that readers of the store can draw it.
nlohmann::ordered_json arm_definition(const Robot& arm) {
  nlohmann::ordered_json json;
  for (Eigen::Index j = 0; j < arm.joints(); ++j) {
    JsonWriter writer;
    LimitedLink one{arm.chain.links()[static_cast<std::size_t>(j)], {arm.limits.lower[j], arm.limits.upper[j]}};
    list_fields(writer, one);
    json["links"].push_back(std::move(writer.out));
  }
  std::size_t joint = 0;
  for (const DescribedJoint& described : arm.description) {
    if (described.motion != DescribedJoint::Motion::none) json["links"][joint++]["name"] = described.name;
  }
  if (!arm.notes.empty()) json["notes"] = arm.notes;
  for (const auto& [key, frame] : {std::pair{"base", arm.chain.base()}, std::pair{"tool", arm.chain.tool()}}) {
    JsonWriter writer;
    Frame fields = frame;
    list_fields(writer, fields);
    json[key] = std::move(writer.out);
  }
  return json;
}

// The built-in study that claims to be of the same paper and is most like it: by the kind of path, then by the arm.
std::optional<Study> original_of(const Study& study) {
  const std::vector<Study> known = studies();
  const auto is_of_same_paper = [&](const Study& candidate) {
    return !study.published.empty() && candidate.published == study.published;
  };
  const auto likeness = [&](const Study& candidate) {
    if (!is_of_same_paper(candidate)) return 0;
    return 1 + (candidate.path->name() == study.path->name() ? 2 : 0) + (candidate.robot == study.robot ? 1 : 0);
  };
  const auto original = std::ranges::max_element(known, {}, likeness);  // the first of equals
  if (original == known.end() || likeness(*original) == 0) return std::nullopt;
  return *original;
}

auto find_solver(const Study& study, const std::string& label) {
  return std::ranges::find(study.solvers, label, &SolverEntry::label);
}

// The settings in which a study differs from the original. These may differ freely: name, title, seed, trace, repeats,
// the analysis, and further solvers.
std::vector<std::string> departures(const Study& study, const Study& original) {
  std::vector<std::string> found;
  const auto ours = definition(study).flatten(), theirs = definition(original).flatten();
  for (const auto& [pointer, value] : theirs.items()) {
    const bool is_free = pointer == "/name" || pointer == "/title" || pointer == "/seed" || pointer == "/trace" ||
                         pointer == "/repeats" || pointer.starts_with("/analysis/") || pointer.starts_with("/figures/");
    if (is_free || (ours.contains(pointer) && ours[pointer] == value)) continue;
    std::string key = pointer.substr(1);
    std::replace(key.begin(), key.end(), '/', '.');
    found.push_back(key);
  }
  for (const SolverEntry& entry : original.solvers) {
    const auto same = find_solver(study, entry.label);
    if (same == study.solvers.end()) continue;
    if (same->solver != entry.solver || same->population != entry.population ||
        effective_options(study, *same) != effective_options(original, entry)) {
      found.push_back("options of " + entry.label);
    }
  }
  return found;
}

void add_departures(nlohmann::ordered_json& json, const Study& study) {
  json["departures"] = std::vector<std::string>();
  const std::optional<Study> original = original_of(study);
  if (!original) return;
  json["departures"] = departures(study, *original);
  for (const SolverEntry& entry : original->solvers) {
    if (find_solver(study, entry.label) == study.solvers.end()) json["missing_solvers"].push_back(entry.label);
  }
}

std::string toml_value(const std::string& setting) { return number_from(setting) ? setting : toml_string(setting); }

using EntryPlace = std::vector<SolverEntry>::const_iterator;

// The end of the entries that a sweep made of one.
EntryPlace end_of_family(EntryPlace first, EntryPlace end) {
  if (first->family.empty()) return first + 1;
  return std::find_if(first, end, [&](const SolverEntry& entry) { return entry.family != first->family; });
}

// Swept settings, each with its values in TOML, in their order.
using SweptValues = std::map<std::string, std::vector<std::string>>;

SweptValues swept_values(EntryPlace first, EntryPlace end) {
  SweptValues axes;
  for (; first != end; ++first) {
    for (const auto& [setting, text] : first->swept) {
      std::vector<std::string>& values = axes[setting];
      if (std::ranges::find(values, toml_value(text)) == values.end()) values.push_back(toml_value(text));
    }
  }
  return axes;
}

}  // namespace

std::string to_toml(Path path) {
  std::vector<std::string_view> kinds;
  for (const Path& kind : paths()) kinds.push_back(kind->name());
  TomlWriter writer;
  writer.out = "[path]\n";
  writer.line("kind", toml_string(path->name()), fmt::format("{}; see: ikbench list paths", fmt::join(kinds, " | ")));
  path->list_fields(writer);
  return writer.out;
}

std::string to_toml(const Study& study) {
  Study fields = as_in_files(study);
  TomlWriter writer;
  list_fields(writer, fields);
  writer.out += "\n[analysis]  # how the results are judged; it does not affect the solves\n";
  list_fields(writer, fields.analysis);
  writer.out += "\n[figures]  # their look; it affects neither the solves nor how they are judged\n";
  list_fields(writer, fields.figures);
  if (fields.figures.solvers.empty())
    writer.out += fmt::format("# solvers = [{}]  # {}\n",
                              study.solvers.empty() ? "" : toml_string(study.solvers.front().label), meaning_of_shown);
  if (is_urdf_file(study.robot)) {
    writer.out += "\n[urdf]\n";
    list_fields(writer, fields.urdf);
  }
  writer.out += "\n[stop]\n";
  list_fields(writer, fields.stop);
  writer.out += '\n' + to_toml(fields.path);
  for (const LeftOut& left_out : study.left_out) {
    writer.out += fmt::format("\n# left out: {} is {}\n", left_out.label, left_out.why);
  }
  for (auto of = study.solvers.begin(); of != study.solvers.end(); of = end_of_family(of, study.solvers.end())) {
    const SolverEntry& entry = *of;
    const SweptValues axes = swept_values(of, end_of_family(of, study.solvers.end()));
    const auto value = [&](const std::string& setting, const std::string& of_entry) {
      const auto axis = axes.find(setting);
      if (axis == axes.end()) return toml_value(of_entry);
      return fmt::format("[{}]", fmt::join(axis->second, ", "));
    };
    writer.out += "\n[[solvers]]\n";
    writer.line("label", toml_string(entry.family.empty() ? entry.label : entry.family), "");
    if (entry.program) {
      ProgramChoice choice = entry.program->choice;
      list_fields(writer, choice);
    } else {
      writer.line("solver", toml_string(entry.solver), "options and ranges: ikbench list solvers " + entry.solver);
    }
    if (entry.population > 0) {
      writer.line("population", value("population", fmt::format("{}", entry.population)),
                  "overrides the population of the study");
    }
    if (!entry.colour.empty()) {
      writer.line("colour", toml_string(entry.colour), meaning_of_colour);
    } else if (&entry == &study.solvers.front()) {
      writer.out += fmt::format("# colour = \"blue\"  # {}\n", meaning_of_colour);
    }
    if (entry.if_missing == IfMissing::leave_out)
      writer.line("if_missing", "'leave_out'",
                  "where it was not built the study goes on without it; refuse: it does not");
    std::vector<std::string> options;
    for (const auto& [name, text] : entry.options) options.push_back(name + " = " + value(name, text));
    if (!options.empty()) writer.line("options", fmt::format("{{ {} }}", fmt::join(options, ", ")), "");
  }
  return writer.out;
}

std::string to_json(const Study& study) {
  nlohmann::ordered_json json = definition(study);
  json["points"] = study.path->points();
  json["arm"] = arm_definition(arm_of(study));
  add_departures(json, study);
  if (const std::vector<Unreachable> found = unreachable(study); !found.empty()) {
    const Unreachable& farthest = *std::ranges::max_element(found, {}, &Unreachable::distance);
    json["out_of_reach"] = {{"points", found.size()},
                            {"farthest_point", farthest.point},
                            {"farthest_cm", farthest.distance / centimetre},
                            {"reach_cm", farthest.reach / centimetre}};
  }
  return numerics::text_of(json);
}

std::string to_json(const Robot& arm) { return numerics::text_of(arm_definition(arm)); }

std::string to_json(const results::Plan& plan) { return numerics::text_of(json_of(plan)); }

}  // namespace ikbench::experiments
