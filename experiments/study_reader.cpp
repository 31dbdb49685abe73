#include "experiments/study_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "base/embedded_file.hpp"
#include "base/inputs.hpp"
#include "base/json.hpp"
#include "base/names.hpp"
#include "base/number.hpp"
#include "base/toml_table.hpp"
#include "experiments/foreign/program.hpp"
#include "experiments/study_writer.hpp"
#include "experiments/task.hpp"
#include "results/published.hpp"
#include "robots/rotation.hpp"
#include "robots/spherical_wrist.hpp"

namespace ikbench::experiments {

using namespace base;
using namespace numerics;
using namespace robots;
using namespace solvers;
using namespace results;

namespace {

constexpr EmbeddedFile study_files[]{
#include "studies.inc"
};

std::string source_of(const EmbeddedFile& file) { return fmt::format("built-in study {}", file.stem()); }

// ---- overrides ----------------------------------------------------------------------------------------------------

// Inserts the text as a TOML value, or else as a string: people type both `runs=5` and `path.tool=eq27`.
void insert(toml::table& table, std::string_view key, const std::string& text) {
  refuse_deep_keys(text, override_source);
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
  toml::table* part = table.get(key)->as_table();
  if (part == nullptr) throw std::invalid_argument(fmt::format("--set {}: {} of the study is not a table", key, key));
  return *part;
}

constexpr std::string_view population_key = "population", swept_owner = "sweep";

// What can be swept of a solver: the population, and the options of one that is built in.
std::set<std::string> settings_of(const std::string& solver) {
  std::set<std::string> settings{std::string(population_key)};
  for (const SolverInfo& info : all_solvers()) {
    if (info.name != solver) continue;
    for (const auto& [option, value] : info.options({})) settings.insert(option);
  }
  return settings;
}

// Applies one override to a study's table. "IK-BA.alpha" is of the entries with that label or solver, and "sweep.alpha"
// of those whose solver has that setting.
void override_one(toml::table& study, const std::string& text) {
  const std::size_t equals = text.find('=');
  constexpr std::size_t longest_key = 300;
  if (equals == std::string::npos || equals == 0 || equals > longest_key) {
    throw std::invalid_argument(
        fmt::format("--set {}: expected key=value, such as runs=5 or ik_bat.bounds=clamp", text.substr(0, 100)));
  }
  const std::string key = text.substr(0, equals), value = text.substr(equals + 1);
  const std::size_t dot = key.rfind('.');
  if (dot == std::string::npos) {
    constexpr std::array<std::string_view, 5> stops{"seconds", "iterations", "evaluations", "tolerance_cm",
                                                    "tolerance_deg"};
    if (std::ranges::find(stops, key) != stops.end())
      throw std::invalid_argument(fmt::format("--set {0}: unknown key; did you mean stop.{0}?", key));
    return insert(study, key, value);
  }
  const std::string owner = key.substr(0, dot), field = key.substr(dot + 1);
  if (owner.empty() || field.empty()) {
    throw std::invalid_argument(fmt::format("--set {}: expected a name on both sides of the dot", text.substr(0, 100)));
  }
  std::set<std::string> owners{"analysis", "figures", "loop", "path", "stop", "tables", "urdf"}, settings;
  if (owners.contains(owner)) return insert(subtable(study, owner), field, value);
  const bool is_of_all = owner == swept_owner;
  bool is_known = false;
  if (toml::array* const entries = study["solvers"].as_array()) {
    for (toml::node& element : *entries) {
      toml::table* const entry = element.as_table();
      if (entry == nullptr) continue;
      const std::string label = (*entry)["label"].value_or(std::string());
      const std::string solver = (*entry)["solver"].value_or(std::string());
      const std::set<std::string> own = settings_of(solver);
      if (is_of_all ? own.contains(field) : owner == label || owner == solver) {
        insert(field == population_key || field == "colour" || field == "patience_s" ? *entry
                                                                                     : subtable(*entry, "options"),
               field, value);
        is_known = true;
      }
      settings.insert(own.begin(), own.end());
      owners.insert({label, solver});
    }
  }
  if (is_known) return;
  owners.erase("");
  throw std::invalid_argument(
      is_of_all
          ? fmt::format("--sweep {}: {}", field, unknown_name("setting", field, {settings.begin(), settings.end()}))
          : fmt::format("--set {}: {}", key, unknown_name("solver", owner, {owners.begin(), owners.end()})));
}

// ---- parts of a study ---------------------------------------------------------------------------------------------

// The folder of a file that a key names: the study's, or the current one if --set gave the key.
std::filesystem::path folder_of(const TomlReader& reader, std::string_view key) {
  const toml::node* const node = reader.table().get(key);
  const bool is_of_file = node != nullptr && node->source().begin.line > 0 && !node->source().path;
  return is_of_file ? reader.source().parent_path() : std::filesystem::path();
}

class PathReader final : public TomlReader {
 public:
  explicit PathReader(TomlReader reader) : TomlReader(std::move(reader)) {}

 private:
  // This key is required: a study needs targets.
  void on_poses(Name name, std::any field) override {
    constexpr std::string_view expected =
        "a list of 1 to 100000 poses such as { position_cm = [60, 0, 35], rpy_deg = [180, 0, 180] }";
    auto& poses = *std::any_cast<std::vector<Pose>*>(field);
    poses.clear();
    for (const toml::table* const table : tables(name.key, point_counts.second, expected)) {
      if (table->contains("position_cm") == table->contains("position_m"))
        fail(name.key, *table, "a pose with either a position_cm or a position_m");
      poses.push_back(pose_in(nested(*table, fmt::format("{}{}.", prefix(), name.key))));
    }
  }

  static Pose pose_in(TomlReader reader) {
    Eigen::Vector3d position = Eigen::Vector3d::Zero(), rpy = Eigen::Vector3d::Zero();
    reader.numbers("position_cm", position, centimetre, 3);
    reader.numbers("position_m", position, 1, 3);
    reader.numbers("rpy_deg", rpy, degree, 3);
    Eigen::VectorXd rotation(9);
    rotation << rotation_from_rpy(rpy).transpose().reshaped();
    reader.numbers("rotation", rotation, 1, 9);
    reader.refuse_unknown_keys();
    Pose pose = Pose::Identity();
    pose.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(rotation.data());
    if (!pose.linear().isUnitary(1e-9) || pose.linear().determinant() < 0)
      reader.fail("rotation", reader.table(), "a rotation matrix, row by row");
    pose.translation() = position;
    return pose;
  }
};

Path read_path(PathReader reader) {
  const std::vector<Path> kinds = paths();
  std::vector<std::string_view> names;
  for (const Path& kind : kinds) names.push_back(kind->name());
  std::size_t chosen = 0;
  if (!reader.table().contains("kind"))
    throw reader.mistake("kind", fmt::format("path.kind is missing, what the targets are; expected one of \"{}\"",
                                             fmt::join(names, "\", \"")));
  reader.choice("kind", chosen, names);
  Path path = kinds[chosen];
  list_fields(reader, path);
  // Of another kind by --set, keys of the file's kind stay behind.
  const toml::source_region& kind = reader.find("kind")->source();
  const bool is_other_kind = kind.begin.line == 0 || kind.path;
  reader.refuse_unknown_keys(is_other_kind ? override_source : "");
  try {
    path->load(folder_of(reader, "file"));
  } catch (const std::invalid_argument& error) {
    throw reader.mistake("file", error.what());
  }
  return path;
}

// Reads all keys of a table.
template <class Part>
void read_part(TomlReader reader, Part& part) {
  list_fields(reader, part);
  reader.refuse_unknown_keys();
}

// Reads the study's arm: a built-in one, or a file in the study's folder (for --set in the current one).
Robot read_arm(const TomlReader& reader, Study& study) {
  if (!is_arm_file(study.robot)) {
    try {
      return robot(study.robot);
    } catch (const std::invalid_argument& error) {
      throw reader.mistake("robot", error.what());
    }
  }
  const std::filesystem::path file = folder_of(reader, "robot") / study.robot;
  std::error_code error;
  if (!std::filesystem::exists(file, error)) {
    throw reader.mistake(
        "robot", fmt::format("there is no file {}; expected one, or an arm of: ikbench list robots", file.string()));
  }
  study.robot_of_file = std::make_shared<const Robot>(load_robot(file, study.urdf));
  return *study.robot_of_file;
}

// ---- entries ------------------------------------------------------------------------------------------------------

constexpr std::array<std::string_view, 2> if_missing_choices{"refuse", "leave_out"};

// Throws LeftOut if the entry of what is missing may be left out.
void leave_out(TomlReader& entry, const std::string& what, const std::string& why) {
  IfMissing if_missing = IfMissing::refuse;
  entry.choice("if_missing", if_missing, if_missing_choices);
  if (if_missing == IfMissing::refuse) return;
  LeftOut left_out{what, why};
  entry.text("label", left_out.label);
  throw left_out;
}

// Starts the program to read its name and options. Throws LeftOut if it does not start and may be left out.
std::shared_ptr<const Program> read_program(TomlReader& reader) {
  constexpr std::string_view key = "process";
  ProgramChoice choice;
  list_fields(reader, choice);
  if (choice.process.empty() || choice.process[0].empty())
    reader.fail(key, *reader.find(key), "a program, and its arguments");
  try {
    return meet(choice, folder_of(reader, key));
  } catch (const std::invalid_argument& error) {
    leave_out(reader, choice.process[0], error.what());
    throw reader.mistake(key, fmt::format("{}: {}; see: ikbench check-solver", choice.process[0], error.what()));
  }
}

// Reads what an entry is: a built-in solver or a program. Throws LeftOut as read_program does, also for a library that
// this program was built without.
void read_kind(TomlReader& reader, SolverEntry& entry) {
  reader.text("solver", entry.solver);
  const bool is_program = reader.find("process") != nullptr;
  if (is_program == (reader.find("solver") != nullptr)) {
    throw std::invalid_argument(reader.where(reader.table().source(), "solver") +
                                (is_program
                                     ? "a [[solvers]] has a `process` and a `solver`; expected one of them"
                                     : "a [[solvers]] has no `solver` and no `process`; see: ikbench list solvers"));
  }
  if (is_program) {
    entry.program = read_program(reader);
    entry.solver = entry.program->hello.name;
    return;
  }
  for (const MissingPeer& peer : missing_peers()) {
    if (peer.name == entry.solver) leave_out(reader, entry.solver, peer.how);
  }
  try {
    static_cast<void>(solver(entry.solver));
  } catch (const std::invalid_argument& error) {
    throw reader.mistake("solver", error.what());
  }
}

// Returns whether the default of an option is a number.
bool is_of_numbers(const SolverEntry& entry, const std::string& option) {
  const Settings defaults = options_with(entry, {});
  const auto by_default = defaults.find(option);
  return by_default != defaults.end() && number_from(by_default->second);
}

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
    if (!is_plain(*quoted)) settings.fail(setting, node, plain_text);
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

// Reads a list of values into `axes`.
void read_values(const TomlReader& settings, const SolverEntry& entry, Axes& axes, const std::string& setting,
                 const toml::node& node) {
  const toml::array* list = node.as_array();
  if (list == nullptr || list->empty() || list->size() > most_solvers)
    settings.fail(setting, node, fmt::format("a list of 1 to {} values", most_solvers));
  std::vector<std::string> values;
  for (const toml::node& element : *list) {
    values.push_back(value_in(settings, entry, setting, element));
    if (std::ranges::count(values, values.back()) > 1) settings.fail(setting, element, "each value once");
  }
  axes[setting] = std::move(values);
}

// A setting of the entry: one value, or a list of them.
void read_setting(const TomlReader& settings, SolverEntry& entry, Axes& axes, const std::string& setting,
                  const toml::node& node) {
  if (node.is_array())
    read_values(settings, entry, axes, setting, node);
  else
    give(entry, setting, value_in(settings, entry, setting, node));
}

const std::string too_many_solvers = fmt::format("more than {0} solvers; expected at most {0}", most_solvers);

// One entry per combination of the values; the last setting varies fastest. The entry itself if nothing is swept.
std::vector<SolverEntry> combinations(const TomlReader& reader, const SolverEntry& entry, const Axes& axes) {
  const auto refuse_if = [&](bool is_wrong, std::string_view what) {
    if (is_wrong)
      throw std::invalid_argument(fmt::format("{}the sweep of {} makes {}",
                                              reader.where(reader.table().source(), "solvers"), entry.label, what));
  };
  std::vector<SolverEntry> entries{entry};
  if (!axes.empty()) entries.front().family = entry.label;
  for (const auto& [setting, values] : axes) {
    refuse_if(entries.size() * values.size() > most_solvers, too_many_solvers);
    std::vector<SolverEntry> longer;
    for (const SolverEntry& shorter : entries) {
      for (const std::string& value : values) {
        SolverEntry& one = longer.emplace_back(shorter);
        give(one, setting, value);
        one.label += fmt::format(" {}={}", setting, value);
      }
    }
    entries = std::move(longer);
  }
  refuse_if(!std::ranges::all_of(entries, is_plain, &SolverEntry::label),
            "a label of more than 200 bytes; expected a shorter label");
  return entries;
}

constexpr std::string_view not_enforced =
    "bounds is \"initial\", but limits is \"enforced\"; expected bounds that keep candidates inside the limits";

// Checks an entry against the study. The keys of `at_entry` have its label before them.
void check_entry(const TomlReader& reader, const TomlReader& at_entry, const SolverEntry& entry, const Study& study,
                 const Robot& arm) {
  if (entry.program) {  // which may decline further
    if (const Hello& hello = entry.program->hello; !hello.solves(goal_kind(study.search)))
      throw at_entry.mistake("process", fmt::format("{} solves for {}; expected another search", hello.name,
                                                    fmt::join(hello.goals, ", ")));
    return;
  }
  const SolverInfo info = solver(entry.solver);
  if (const std::string why = info.why_not(arm.chain, goal_kind(study.search)); !why.empty())
    throw at_entry.mistake("solver", why);
  if (const int population = effective_population(study, entry); population < info.least_population) {
    throw(entry.population > 0 ? at_entry : reader)
        .mistake(population_key, fmt::format("population is {}, but {} needs at least {}", population, entry.solver,
                                             info.least_population));
  }
  const auto bounds = entry.options.find("bounds");
  if (study.limits == Limits::enforced && bounds != entry.options.end() && bounds->second == "initial") {
    const toml::table* const options = at_entry.table()["options"].as_table();
    throw(options == nullptr ? at_entry : at_entry.nested(*options, at_entry.prefix())).mistake("bounds", not_enforced);
  }
}

// Reads an entry. A setting that has a list of values makes one entry per combination: "IK-BA population=20".
std::vector<SolverEntry> read_entry(TomlReader reader) {
  SolverEntry entry;
  read_kind(reader, entry);
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

void read_solvers(TomlReader& reader, Study& study, const Robot& arm) {
  constexpr std::string_view key = "solvers", expected = "1 to 400 tables [[solvers]] with solver = \"...\"";
  std::set<std::string> labels;
  for (const toml::table* const table : reader.tables(key, most_solvers, expected)) {
    std::vector<SolverEntry> entries;
    try {
      entries = read_entry(reader.nested(*table, "solvers."));
    } catch (const LeftOut& left_out) {
      study.left_out.push_back(left_out);
    }
    for (SolverEntry& entry : entries) {
      if (!labels.insert(entry.label).second) {
        throw std::invalid_argument(
            fmt::format("{}label \"{}\" is used twice; expected a different label for each of [[solvers]]",
                        reader.where(table->source(), key), entry.label));
      }
      check_entry(reader, reader.nested(*table, entry.label + "."), entry, study, arm);
      if (study.solvers.size() == most_solvers) throw reader.mistake(key, "the entries make " + too_many_solvers);
      study.solvers.push_back(std::move(entry));
    }
  }
  if (study.solvers.empty()) reader.fail(key, *reader.find(key), expected);
}

// ---- what fields ask of each other --------------------------------------------------------------------------------

void check_stop(const TomlReader& stop, const Study& study) {
  const double position = study.stop.tolerance / centimetre, angle = study.stop.angle_tolerance / degree;
  if (study.stop.iterations == 0)
    throw stop.mistake("iterations",
                       "stop.iterations is 0, so nothing would be solved; expected at least 1, or "
                       "1000000000 where only another limit shall count");
  if (study.has_direction() && (position > 0) != (angle > 0)) {
    throw stop.mistake(position > 0 ? "tolerance_cm" : "tolerance_deg",
                       fmt::format("stop.tolerance_cm is {:g} and stop.tolerance_deg is {:g}; search = \"pose\" or "
                                   "\"axis\" expects both, or neither",
                                   position, angle));
  }
  if (!study.has_direction() && angle > 0) {
    throw stop.mistake("tolerance_deg",
                       "stop.tolerance_deg is about the orientation, which is not searched; expected search = \"pose\" "
                       "or \"axis\", or no stop.tolerance_deg");
  }
}

// Checks the study as it was read, but for its entries.
void check_study(const TomlReader& reader, const Study& study, const Robot& arm) {
  const auto refuse_if = [&](bool is_wrong, std::string_view key, std::string_view message) {
    if (is_wrong) throw reader.mistake(key, message);
  };
  try {
    study.path->check(arm);
  } catch (const std::invalid_argument& error) {
    throw reader.mistake("path", error.what());
  }
  Random random(Key(0));
  refuse_if(study.start == Start::near && study.path->solutions(arm, random).empty(), "start",
            "start is \"near\", but the path's targets are not made of configurations; expected path.kind = \"random\" "
            "with targets that the arm can reach, or another start");
  refuse_if(
      study.loop.period > 0 && (!study.is_chained() || study.path->is_drawn()), "loop",
      "loop.period_ms is about a path that the arm follows; expected start = \"previous\" and targets that are not "
      "drawn, or no [loop]");
  constexpr double most_solves = 1e8;
  refuse_if(static_cast<double>(study.solvers.size()) * study.runs * study.path->points() > most_solves, "runs",
            "solvers, runs and points make more than 100 000 000 solves; expected fewer");
  refuse_if(study.trace == Trace::best_error && study.stop.iterations > 1'000'000, "trace",
            "a trace has at most 1 000 000 iterations; expected stop.iterations of at most that");
  refuse_if(study.limits == Limits::enforced && study.bounds == StudyBounds::initial, "bounds", not_enforced);
  const Configuration units = joint_units(arm.chain);
  for (Eigen::Index j = 0; j < units.size(); ++j) {
    const double outside = std::max(arm.limits.lower[j] - study.initial[j], study.initial[j] - arm.limits.upper[j]);
    refuse_if(outside > 0, "initial_deg",
              fmt::format("initial_deg is {:g} {} outside the limits of joint {}; see: ikbench robot {}",
                          outside / units[j], units[j] == 1 ? "m" : "deg", j + 1, arm.name));
  }
  refuse_if(study.motion_joints > arm.joints(), "motion_joints",
            fmt::format("motion_joints is {}, but {} has {} joints; expected at most that, or 0 for all",
                        study.motion_joints, arm.name, arm.joints()));
  refuse_if(
      study.search == Search::wrist && !SphericalWrist::fits(arm.chain), "search",
      fmt::format("search is \"wrist\", but {} has no spherical wrist; expected \"all_joints\", \"axis\" or \"pose\"",
                  arm.name));
  refuse_if(study.search == Search::flange && !only_turns_tool(arm.chain), "search",
            fmt::format("search is \"flange\", but the last joint of {} moves the tool's point; expected "
                        "\"all_joints\", \"axis\" or \"pose\"",
                        arm.name));
  refuse_if(!study.has_direction() && study.rotation_weight != Study{}.rotation_weight, "rotation_weight_m",
            "rotation_weight_m weighs the orientation, which is not searched; expected search = \"pose\" or \"axis\", "
            "or no rotation_weight_m");
}

// ---- a study ------------------------------------------------------------------------------------------------------

// Drops a control that a sweep splits, or that is not solved.
void drop_lost_control(Study& study) {
  std::string& control = study.plan.control;
  const std::vector<std::string> labels = labels_of(study);
  if (control.empty() || std::ranges::find(labels, control) != labels.end()) return;
  study.notes.push_back(fmt::format("the control, {}, is swept or left out: every pair is compared", control));
  control.clear();
}

Study read_study(const toml::table& table, std::string_view source) {
  Study study;
  study.name = std::filesystem::path(source).stem().string();  // so that two files are two studies
  TomlReader reader(table, source, "");
  const auto refuse_unknown = [&](const TomlReader& at, std::string_view key, std::string_view kind,
                                  const std::string& name, const std::vector<std::string>& names) {
    if (std::ranges::find(names, name) == names.end()) throw at.mistake(key, unknown_name(kind, name, names));
  };
  list_fields(reader, study);
  if (study.name.empty()) reader.fail("name", *table.get("name"), "a non-empty name");
  const auto papers = published::papers();
  if (!study.published.empty())
    refuse_unknown(reader, "published", "paper", study.published, {papers.begin(), papers.end()});
  for (const auto& [key, expected] : {std::pair{"robot", "the name of an arm (ikbench list robots) or its file"},
                                      {"path", "a table with the kind of targets (ikbench list paths)"}}) {
    if (!table.contains(key)) throw reader.mistake(key, fmt::format("{} is missing; expected {}", key, expected));
  }
  study.path = read_path(PathReader(reader.part("path")));
  if (reader.find("urdf") != nullptr && !is_urdf_file(study.robot))
    throw reader.mistake("urdf", fmt::format("[urdf] is about a URDF file, but robot is \"{}\"; expected one such as "
                                             "\"my_arm.urdf\"",
                                             study.robot));
  read_part(reader.part("urdf"), study.urdf);
  const TomlReader stop = reader.part("stop"), analysis = reader.part("analysis"), figures = reader.part("figures");
  read_part(stop, study.stop);
  check_stop(stop, study);
  read_part(reader.part("loop"), study.loop);
  const Robot arm = read_arm(reader, study);
  const Configuration units = joint_units(arm.chain);
  if (study.initial.size() == 0) {
    study.initial = nearest_to_zero(arm);
  } else if (study.initial.size() == arm.joints()) {
    study.initial = study.initial.cwiseProduct(units).eval();
  } else {
    throw reader.mistake("initial_deg", fmt::format("initial_deg has {} values; expected {}, one for each joint of {}",
                                                    study.initial.size(), arm.joints(), arm.name));
  }
  read_solvers(reader, study, arm);
  const std::vector<std::string> labels = labels_of(study);
  read_part(analysis, study.plan);
  const std::string& control = study.plan.control;
  if (!control.empty() && std::ranges::find(study.solvers, control, &SolverEntry::family) == study.solvers.end())
    refuse_unknown(analysis, "control", "label", control, labels);
  drop_lost_control(study);
  read_style(figures, study.figures);
  read_part(reader.part("tables"), study.tables);
  for (const std::string& label : study.figures.solvers) refuse_unknown(figures, "solvers", "label", label, labels);
  reader.refuse_unknown_keys();
  check_study(reader, study, arm);
  return study;
}

std::string no_study(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    return fmt::format("{} is a folder; expected a TOML file, or a name of: ikbench list studies", file.string());
  if (std::filesystem::exists(file, error)) return fmt::format("{} is not a regular file", file.string());
  if (const std::string beside = file.string() + ".toml"; std::filesystem::is_regular_file(beside, error))
    return fmt::format("no such file: {0}; did you mean {0}.toml?", file.string());
  if (file.extension() == ".toml" || file.has_parent_path())
    return fmt::format("no such file: {}; expected a TOML file, or a name of: ikbench list studies", file.string());
  std::vector<std::string> names;
  for (const EmbeddedFile& embedded : study_files) names.emplace_back(embedded.stem());
  std::ranges::sort(names);
  return "no such file, and " + unknown_name("built-in study", file.string(), names);
}

}  // namespace

void keep_only(Study& study, const std::vector<std::string>& labels) {
  const auto is_of = [](const SolverEntry& entry, const std::string& label) {
    return entry.label == label || entry.family == label;
  };
  for (const std::string& label : labels) {
    if (std::ranges::none_of(study.solvers, [&](const SolverEntry& entry) { return is_of(entry, label); }))
      throw std::invalid_argument(unknown_name("label", label, labels_of(study)));
  }
  std::erase_if(study.solvers, [&](const SolverEntry& entry) {
    return std::ranges::none_of(labels, [&](const std::string& label) { return is_of(entry, label); });
  });
  std::erase_if(study.figures.solvers, [kept = labels_of(study)](const std::string& label) {
    return std::ranges::find(kept, label) == kept.end();
  });
  drop_lost_control(study);
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
    values += number && std::isfinite(*number) ? text_of(*number) : text_of(base::Json(value));
    values += ", ";
    from = end + 1;
  }
  const std::string setting = text.substr(0, equals);
  return fmt::format(
      "{}=[{}]", setting.find('.') == std::string::npos ? fmt::format("{}.{}", swept_owner, setting) : setting, values);
}

Study parse_study(std::string_view toml_text, std::string_view source, const Overrides& overrides) {
  toml::table table = parse_toml(toml_text, source);
  for (const std::string& text : overrides) override_one(table, text);
  return read_study(table, source);
}

std::vector<Study> studies() {
  std::vector<Study> all;
  for (const EmbeddedFile& file : study_files) all.push_back(parse_study(file.text, source_of(file)));
  std::ranges::sort(all, {}, &Study::name);
  return all;
}

Study load_study(const std::string& name_or_file, const Overrides& overrides) {
  if (const EmbeddedFile* const file = find_embedded(study_files, name_or_file))
    return parse_study(file->text, source_of(*file), overrides);
  std::error_code error;
  const std::filesystem::path file = name_or_file;
  if (!std::filesystem::is_regular_file(file, error)) throw std::invalid_argument(no_study(file));
  return parse_study(text_of_file(file), name_or_file, overrides);
}

}  // namespace ikbench::experiments
