#include "experiments/redrawn_tasks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "experiments/recheck.hpp"
#include "experiments/source_digest.hpp"
#include "experiments/study_fields.hpp"
#include "experiments/study_writer.hpp"
#include "experiments/table_reader.hpp"
#include "numerics/json.hpp"
#include "numerics/random.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace robots;
using namespace results;

namespace {

// A target near a singularity takes up to a tenth of a millisecond.
constexpr std::size_t most_poses = 5000;
constexpr double most_apart = 1e-9;

// Says whether this version of the source made a series. Series of outside programs and of libraries count as not made
// by it.
bool is_by_this_source(const Series& series) {
  try {
    const Key source = Key(0).with(shared_source_digest()).with(solver_source_digest(series.algorithm));
    return series.key.ends_with(fmt::format("{}{:016x}", before_source, source.value()));
  } catch (const std::logic_error&) {
    return false;
  }
}

// Parses those fields of `json` that exist.
toml::table table_of(const nlohmann::json& json, std::initializer_list<std::string_view> keys) {
  std::string text;
  for (const std::string_view key : keys)
    if (json.contains(key)) text += fmt::format("{} = {}\n", key, toml_of(json.at(key)));
  return parse_toml(text, "definition");
}

// Throws std::invalid_argument if a field is missing or unknown: another version of the program wrote the definition.
Path path_in(const nlohmann::json& json) {
  std::vector<Path> kinds = paths();
  const auto kind = std::ranges::find(kinds, json.at("kind").get<std::string>(),
                                      [](const Path& path) { return std::string(path->name()); });
  if (kind == kinds.end()) throw std::invalid_argument("an unknown kind of path");
  nlohmann::json fields = json;
  fields.erase("targets");
  const toml::table needed = parse_toml(to_toml(*kind), "path");
  for (const auto& [key, value] : *needed["path"].as_table()) {
    if (!fields.contains(key.str())) throw std::invalid_argument("a path without one of its fields");
  }
  fields.erase("kind");
  const toml::table table = parse_toml("path = " + toml_of(fields), "definition");
  TomlReader reader(*table["path"].as_table(), "definition", "path.");
  TableReader reading(reader);
  (*kind)->list_fields(reading);
  reader.refuse_unknown_keys();
  return *kind;
}

// NaN is never the same as anything.
template <class Stored, class Given>
bool is_same(const Stored& stored, const Given& given) {
  return stored.size() == given.size() && ((stored - given).array().abs() <= most_apart).all();
}

Configuration joints_in(const std::vector<double>& joints) {
  return Eigen::Map<const Eigen::VectorXd>(joints.data(), static_cast<Eigen::Index>(joints.size()));
}

}  // namespace

RedrawnTasks::RedrawnTasks(const StudyEntry& entry, const Robot& arm) : arm_(arm) {
  const auto definition = numerics::parsed_json(entry.definition);
  if (!definition.is_object() || definition.contains("urdf")) return;  // a URDF arm's table is rounded differently
  if (std::ranges::none_of(entry.series, is_by_this_source)) return;
  try {
    const toml::table table = table_of(definition, {"seed", "start", "near_deg", "initial_deg"});
    TomlReader reader(table, "definition", "");
    TableReader fields(reader);
    list_fields(fields, study_);
    if (study_.initial.size() != arm_.joints()) return;
    study_.initial = study_.initial.cwiseProduct(joint_units(arm_.chain)).eval();
    study_.path = path_in(definition.at("path"));
    study_.path->check(arm_);
    is_drawn_ = true;
  } catch (const std::invalid_argument&) {
  } catch (const nlohmann::json::exception&) {
  }
}

// The targets and starts of a run; null if they are not drawn.
const RedrawnTasks::Run* RedrawnTasks::drawn(int run) {
  const bool differ = study_.path->is_drawn() || study_.start == Start::random;
  const auto points = static_cast<std::size_t>(study_.path->points());
  const auto [found, is_new] = runs_.try_emplace(differ ? run : 1);
  if (is_new && (!study_.path->is_drawn() || runs_.size() * points <= most_poses))
    found->second = {targets(study_, arm_, run), starts(study_, arm_, run)};
  return found->second.targets.empty() ? nullptr : &found->second;
}

bool RedrawnTasks::has_its_target(const SolveRecord& solve) {
  const Run* const run = drawn(solve.run);
  const auto point = static_cast<std::size_t>(solve.point);
  if (run == nullptr || point > run->targets.size()) return true;
  return is_same(target_of(solve).matrix(), run->targets[point - 1].matrix());
}

// An answer that is not finite moves the arm nowhere.
bool RedrawnTasks::has_its_start(const SolveRecord& solve) {
  const Configuration stored = joints_in(solve.start_rad);
  const bool follows = next_ == Place{solve.series, solve.run, solve.point};
  const Configuration now = solve.status == Status::not_finite ? stored : joints_in(solve.answer_rad);
  const Configuration was = std::exchange(where_it_is_, now);
  next_ = {solve.series, solve.run, solve.point + 1};
  if (study_.start == Start::initial || (study_.start == Start::previous && solve.point == 1))
    return is_same(stored, study_.initial);
  if (study_.start == Start::previous) return !follows || is_same(stored, was);
  const Run* const run = drawn(solve.run);
  const auto point = static_cast<std::size_t>(solve.point);
  return run == nullptr || point > run->starts.size() || is_same(stored, run->starts[point - 1]);
}

const char* RedrawnTasks::differing_column(const SolveRecord& solve) {
  const auto joints = static_cast<std::size_t>(arm_.joints());
  const bool has_sizes = solve.target_position_m.size() == 3 && solve.target_rotation.size() == 9 &&
                         solve.start_rad.size() == joints && solve.answer_rad.size() == joints;
  if (!is_drawn_ || !has_sizes || solve.point < 1) return nullptr;
  if (!has_its_start(solve)) return "start_rad";
  return has_its_target(solve) ? nullptr : "target_position_m";
}

}  // namespace ikbench::experiments
