// Reads a stored study as the study file that it was. Values that the store keeps in another form are first put where a
// study file has them.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <system_error>

#include "base/json.hpp"
#include "base/names.hpp"
#include "experiments/study/reader.hpp"
#include "experiments/study/reader_internal.hpp"
#include "experiments/study/writer.hpp"
#include "results/export.hpp"
#include "solvers/registry.hpp"

namespace ikbench::experiments {

using namespace base;
using namespace results;
using namespace solvers;

namespace {

// Returns the arm that was solved. A built-in arm, or the arm of a file in the current folder, is taken if it is still
// the stored arm. The store keeps an arm only to the rounding of its degrees, and has no URDF text for programs.
Robot arm_in(const StoredStudy& stored, const robots::UrdfChoice& urdf) {
  const std::string& name = stored.definition.robot;
  const auto is_same = [&](const Robot& arm) { return arm_json(arm) == parsed_json(stored.definition.arm); };
  std::error_code error;
  if (robots::is_arm_file(name) && std::filesystem::exists(name, error)) {
    Robot arm = robots::load_robot(name, urdf);
    if (is_same(arm)) return arm;
    throw std::invalid_argument(fmt::format(
        "{0} in this folder is another arm than {0} in the store; to use this one, add --robot {0}; otherwise run in "
        "another folder",
        name));
  }
  for (Robot& arm : robots::all_robots())
    if (arm.name == name && is_same(arm)) return arm;
  std::optional<Robot> arm = robots::stored_arm(stored.definition.arm);
  if (!arm) throw std::invalid_argument("its arm cannot be read, so it was changed since it was stored");
  arm->name = std::filesystem::path(name).stem().string();
  arm->summary = fmt::format("{} as the store has it, since this folder has no such file", name);
  arm->base_link = stored.definition.base_link;
  arm->tip_link = stored.definition.tip_link;
  arm->notes = stored.definition.arm_notes;
  return *arm;
}

// Returns the targets of the first run, as in a study file.
Json targets_in(const Store& store, const StoredStudy& stored) {
  Json poses = Json::array();
  const auto points = static_cast<std::size_t>(stored.definition.points);
  for (const Series& series : stored.series) {
    if (poses.size() == points) break;
    poses.clear();
    store.for_each_in_series(series.key, [&](const SolveRecord& solve) {
      if (solve.run == 1 && solve.point == std::ssize(poses) + 1)
        poses.push_back({{"position_m", solve.target_position_m}, {"rotation", solve.target_rotation}});
    });
  }
  if (poses.size() != points)
    throw std::invalid_argument("it lacks solves of the first run, so not all of its targets are known");
  return poses;
}

// A path whose targets were in a file: the fields of the path, and the targets that the store has.
class TargetsOfFile final : public TargetSet {
 public:
  TargetsOfFile(Path fields, Path targets) : fields_(std::move(fields)), targets_(std::move(targets)) {}

  std::string_view name() const override { return fields_->name(); }
  std::string_view summary() const override { return fields_->summary(); }
  void list_fields(Fields& io) override { fields_->list_fields(io); }
  int points() const override { return targets_->points(); }
  std::vector<Pose> poses(const Robot& arm, Random& random) const override { return targets_->poses(arm, random); }

 private:
  Path fields_, targets_;
};

// Returns a path of the kind that a stored study has, with its defaults. Null if this program does not know the kind.
Path path_of_kind(const StoredStudy& stored) {
  const std::vector<Path> kinds = target_sets();
  const auto found = std::ranges::find(kinds, stored.definition.path, [](const Path& kind) { return kind->name(); });
  return found == kinds.end() ? nullptr : *found;
}

// Returns the path of a stored study, without the poses of a study file or of another file. Null if this program does
// not know its kind.
Path path_in(const StoredStudy& stored, const toml::table& definition) {
  const Path path = path_of_kind(stored);
  if (path == nullptr) return nullptr;
  TomlReader reader(definition, fmt::format("study {}", stored.name), "");
  TomlReader fields = reader.part("path");
  path->list_fields(fields);
  return path;
}

// Gives the entries of a study their colours, by label.
void give_colours(toml::table& study, const std::map<std::string, std::string>& colours) {
  toml::array* const entries = study["solvers"].as_array();
  for (std::size_t i = 0; entries != nullptr && i < entries->size(); ++i) {
    toml::table* const entry = entries->get(i)->as_table();
    if (entry == nullptr) continue;  // the reader of studies refuses it
    const auto colour = colours.find((*entry)["label"].value_or(std::string()));
    if (colour != colours.end()) entry->insert_or_assign("colour", colour->second);
  }
}

}  // namespace

bool read_stored_targets(const StoredStudy& stored, Study& study) {
  const toml::table definition = toml_of(parsed_json(stored.definition.json));
  TomlReader reader(definition, "the definition of " + stored.name, "");
  if (const Path path = path_of_kind(stored)) study.path = path;
  TomlReader fields = reader.part("path");
  study.path->list_fields(fields);
  study.path->lay_out(robot_of(study), {study.search, study.stop.tolerance, study.stop.angle_tolerance});
  if (study.path->points() != stored.definition.points) return false;
  const Configuration units = joint_units(robot_of(study).chain);
  Configuration initial;
  reader.numbers("initial_deg", initial, 1, static_cast<int>(units.size()));
  if (initial.size() > 0) study.initial = initial.cwiseProduct(units);
  return true;
}

std::vector<std::vector<std::string>> programs_of(const StoredStudy& stored) {
  std::set<std::vector<std::string>> programs;
  if (!stored.definition.check.process.empty()) programs.insert(stored.definition.check.process);
  const toml::table definition = toml_of(parsed_json(stored.definition.json));
  if (!definition.contains("solvers")) return {programs.begin(), programs.end()};
  TomlReader reader(definition, fmt::format("study {}", stored.name), "");
  for (const toml::table* const entry : reader.tables("solvers", max_solvers, "a list of solvers")) {
    std::vector<std::string> process;
    reader.nested(*entry, "solvers.").texts("process", process, "");
    if (!process.empty()) programs.insert(process);
  }
  return {programs.begin(), programs.end()};
}

std::vector<std::string> own_solvers_of(const StoredStudy& stored) {
  const std::vector<SolverInfo> registered = all_solvers();
  const toml::table definition = toml_of(parsed_json(stored.definition.json));
  std::vector<std::string> labels;
  if (!definition.contains("solvers")) return labels;
  TomlReader reader(definition, fmt::format("study {}", stored.name), "");
  for (const toml::table* const entry : reader.tables("solvers", max_solvers, "a list of solvers")) {
    const std::string solver = (*entry)["solver"].value_or(std::string());
    if (entry->contains("process") || std::ranges::count(registered, solver, &SolverInfo::name) == 0)
      labels.push_back((*entry)["label"].value_or(solver));
  }
  return labels;
}

Study load_study(const Store& store, const StoredStudy& stored, const Overrides& overrides) {
  Json study = parsed_json(stored.definition.json);
  if (!study.contains("solvers"))
    throw std::invalid_argument(fmt::format(
        "study {}: the store, of an older ikbench, does not say how its solvers were set; run its study file again",
        stored.name));
  for (const char* made_of_study : {"arm", "departures", "grid", "points", "sweep", "unreachable_targets"})
    study.erase(made_of_study);
  if (study.contains("figures")) study["figures"].erase("colours");
  if (study.contains("path")) study["path"].erase("targets");
  toml::table table = toml_of(study);
  give_colours(table, stored.definition.figures.colours);
  const Path path = path_in(stored, table);
  const bool are_listed =
      path != nullptr && path->grid() == nullptr && (path->points() == 0 || path->points() != stored.definition.points);
  if (are_listed) {
    const Json listed = {{"kind", "poses"}, {"poses", targets_in(store, stored)}};
    table.insert_or_assign("path", toml_of(listed));
  }
  const toml::table urdf = table["urdf"].is_table() ? *table["urdf"].as_table() : toml::table();
  for (const std::string& text : overrides) apply_override(table, text);
  const bool has_own_robot = bool(table.get("robot")) && table.get("robot")->source().path;
  if (!has_own_robot && table["urdf"].is_table() && *table["urdf"].as_table() != urdf)
    throw std::invalid_argument("another base, tip or limits need the file of the arm; add --robot FILE");
  const std::string source = fmt::format("study {}", stored.name);
  Study read = read_study(table, source, [&](const robots::UrdfChoice& choice) {
    try {
      return arm_in(stored, choice);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(fmt::format("{}: {}", source, error.what()));
    }
  });
  const bool is_of_store = !table["path"]["kind"].node()->source().path;
  if (are_listed && is_of_store) read.path = std::make_shared<TargetsOfFile>(path, read.path);
  return read;
}

}  // namespace ikbench::experiments
