#include "experiments/study/reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "base/embedded_file.hpp"
#include "base/inputs.hpp"
#include "base/names.hpp"
#include "base/toml_table.hpp"
#include "experiments/external/answers.hpp"
#include "experiments/external/program.hpp"
#include "experiments/study/reader_internal.hpp"
#include "experiments/study/study_fields.hpp"
#include "experiments/task.hpp"
#include "results/export.hpp"
#include "results/published.hpp"
#include "robots/rotation.hpp"
#include "robots/spherical_wrist.hpp"
#include "robots/urdf.hpp"

namespace ikbench::experiments {

using namespace base;
using namespace robots;
using namespace results;

namespace {

constexpr EmbeddedFile study_files[]{
#include "studies.inc"
};

std::string source_of(const EmbeddedFile& file) { return fmt::format("built-in study {}", file.stem()); }

// A reader of [path], whose poses are tables.
class PathReader final : public TomlReader {
 public:
  explicit PathReader(TomlReader reader) : TomlReader(std::move(reader)) {}

 private:
  // Reads a list of poses, which is required, because a study needs targets.
  void on_poses(Name name, const std::any& field) override {
    constexpr std::string_view expected =
        "a list of 1 to 100000 poses such as { position_cm = [60, 0, 35], rpy_deg = [180, 0, 180] }";
    auto& poses = *std::any_cast<std::vector<Pose>*>(field);
    poses.clear();
    for (const toml::table* const table : tables(name.key, point_count_range.second, expected)) {
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
  const std::vector<Path> kinds = target_sets();
  std::vector<std::string_view> names;
  for (const Path& kind : kinds) names.push_back(kind->name());
  std::size_t chosen = 0;
  if (!reader.table().contains("kind"))
    throw reader.mistake("kind", fmt::format("path.kind is missing; expected the kind of the targets, one of \"{}\"",
                                             fmt::join(names, "\", \"")));
  reader.choice("kind", chosen, names);
  Path path = kinds[chosen];
  list_fields(reader, path);
  // If --set gives another kind, keys of the file's kind stay behind, and only keys of --set can be unknown.
  const toml::source_region& kind = reader.find("kind")->source();
  const bool is_other_kind = kind.begin.line == 0 || kind.path;
  reader.refuse_unknown_keys(is_other_kind ? override_source : "");
  with_key_context(reader, "file", [&] { path->load(base_folder(reader, "file")); });
  return path;
}

// Reads all keys of a table.
template <class Part>
void read_part(TomlReader reader, Part& part) {
  list_fields(reader, part);
  reader.refuse_unknown_keys();
}

// Reads the study's arm: the arm of a store, a built-in arm, or a file. A file is in the study's folder, or in the
// current folder if --set gave its name.
Robot read_arm(const TomlReader& reader, Study& study, const ArmOfStore& arm_of_store) {
  if (arm_of_store && !reader.table().get("robot")->source().path) {
    study.robot_of_file = std::make_shared<const Robot>(arm_of_store(study.urdf));
    return *study.robot_of_file;
  }
  if (!is_arm_file(study.robot)) return with_key_context(reader, "robot", [&] { return robot(study.robot); });
  const std::filesystem::path file = base_folder(reader, "robot") / study.robot;
  std::error_code error;
  if (!std::filesystem::exists(file, error)) {
    throw reader.mistake(
        "robot", fmt::format("there is no file {}; expected one, or an arm of: ikbench list robots", file.string()));
  }
  study.robot_of_file = std::make_shared<const Robot>(load_robot(file, study.urdf));
  return *study.robot_of_file;
}

// Returns the largest number of iterations that a solver can make with these evaluations. A fixed number would stop a
// solver too early that evaluates one candidate per iteration.
int max_iterations(std::int64_t evaluations) {
  constexpr std::int64_t limit = 1'000'000'000;
  return static_cast<int>(std::min(evaluations, limit));
}

// Refuses limits and tolerances that do not fit the search.
void check_stop(const TomlReader& stop, const Study& study) {
  const double position = study.stop.tolerance / centimetre, angle = study.stop.angle_tolerance / degree;
  if (study.stop.iterations == 0)
    throw stop.mistake("iterations",
                       "stop.iterations is 0, so nothing would be solved; expected at least 1, or "
                       "1000000000 if only another limit shall count");
  if (study.has_direction() && (position > 0) != (angle > 0)) {
    throw stop.mistake(position > 0 ? "tolerance_cm" : "tolerance_deg",
                       fmt::format("stop.tolerance_cm is {:g} and stop.tolerance_deg is {:g}; search = \"pose\" or "
                                   "\"axis\" expects both, or neither",
                                   position, angle));
  }
  if (study.stop.adds_squares && (position == 0 || angle == 0))
    throw stop.mistake("tolerances", "tolerances is \"squares\", which needs both errors; expected both tolerances");
  if (!study.has_direction() && angle > 0) {
    throw stop.mistake("tolerance_deg",
                       "stop.tolerance_deg is for the orientation, which is not searched; expected search = \"pose\" "
                       "or \"axis\", or no stop.tolerance_deg");
  }
}

// Reads [check], and starts its program.
void read_check(TomlReader reader, Study& study) {
  list_fields(reader, study.check);
  study.checker = read_program(reader, false);
  if (study.checker->choice.batch > 0)
    throw reader.mistake("batch", "[check] gets one answer per message; expected no batch");
  const std::vector<std::string> numbers = study.check.numbers();
  for (const std::string& name : numbers) {
    const bool is_reserved = name.starts_with(check_extra) || name.starts_with(invalid_extra);
    if (trimmed(name).empty() || !is_plain(name) || name.size() > max_name_bytes || is_reserved)
      throw reader.mistake("larger", fmt::format("[check] names a number \"{}\"; expected a plain text", name));
  }
  if (numbers.size() > max_extras)
    throw reader.mistake("larger", fmt::format("[check] names {} numbers; at most {}", numbers.size(), max_extras));
  study.check.process = study.checker->choice.process;
  study.check.digest = study.checker->digest;
  reader.refuse_unknown_keys();
}

// Refuses an initial configuration outside the joint limits.
void check_initial(const TomlReader& reader, const Study& study, const Robot& arm) {
  const Configuration units = joint_units(arm.chain);
  for (Eigen::Index j = 0; j < units.size(); ++j) {
    const double outside = std::max(arm.limits.lower[j] - study.initial[j], study.initial[j] - arm.limits.upper[j]);
    if (outside > 0)
      throw reader.mistake("initial_deg",
                           fmt::format("initial_deg is {:g} {} outside the limits of joint {}; see: ikbench robot {}",
                                       outside / units[j], units[j] == 1 ? "m" : "deg", j + 1, arm.name));
  }
}

// Checks the study as it was read, except its entries.
void check_study(const TomlReader& reader, const Study& study, const Robot& arm) {
  const auto refuse_if = [&](bool is_wrong, std::string_view key, std::string_view message) {
    if (is_wrong) throw reader.mistake(key, message);
  };
  with_key_context(reader, "path", [&] { study.path->check(arm); });
  refuse_if(study.path->grid() != nullptr && study.is_chained(), "start",
            "start is \"previous\", but a grid is no way that an arm follows; expected another start");
  refuse_if(study.path->grid() != nullptr && study.runs > 1, "runs",
            fmt::format("runs is {}, but a grid is solved once; expected runs = 1", study.runs));
  refuse_if(study.path->grid() != nullptr && !study.has_tolerance(), "path",
            "path.kind is \"grid\", which shows what is solved; expected stop.tolerance_cm");
  refuse_if(study.path->uses_numpy_random() && study.seed > std::numeric_limits<std::uint32_t>::max(), "seed",
            "path.generator is \"numpy\", whose seeds are at most 4294967295");
  Random random(Key(0));
  refuse_if(study.start == Start::near && study.path->source_configurations(arm, random).empty(), "start",
            "start is \"near\", but the path's targets are not made of configurations; expected path.kind = \"random\" "
            "with targets that the arm can reach, or another start");
  refuse_if(
      study.loop.period > 0 && (!study.is_chained() || study.path->is_random()), "loop",
      "loop.period_ms is only for a path that the arm follows; expected start = \"previous\" and targets that are not "
      "drawn, or no [loop]");
  refuse_if(
      study.state == results::CacheState::warm && study.is_chained(), "state",
      "state is \"warm\", but start = \"previous\", so that a solver makes a run in a row; expected another start");
  refuse_if(study.checker && !study.has_tolerance(), "check",
            "[check] checks answers that reach their target; expected stop.tolerance_cm");
  constexpr double max_solves = 1e8;
  refuse_if(static_cast<double>(study.solvers.size()) * study.runs * study.path->points() > max_solves, "runs",
            "solvers, runs and points make more than 100 000 000 solves; expected fewer");
  refuse_if(study.trace == solvers::Trace::best_error && study.stop.iterations > 1'000'000, "trace",
            "a trace has at most 1 000 000 iterations; expected stop.iterations of at most that");
  refuse_if(study.limits == LimitPolicy::enforced && study.bounds == BoundsPolicy::initial, "bounds",
            bounds_need_recorded_limits);
  check_initial(reader, study, arm);
  refuse_if(study.motion_joints > arm.joints(), "motion_joints",
            fmt::format("motion_joints is {}, but {} has {}; expected at most that, or 0 for all", study.motion_joints,
                        arm.name, counted(arm.joints(), "joints")));
  if (study.search == Search::wrist && !SphericalWrist::fits(arm.chain)) {
    const std::string misfit = SphericalWrist::misfit(arm.chain);
    throw reader.mistake("search", fmt::format("search is \"wrist\", but {} has no spherical wrist{}; expected "
                                               "\"all_joints\", \"axis\" or \"pose\"",
                                               arm.name, misfit.empty() ? "" : ": " + misfit));
  }
  refuse_if(study.search == Search::flange && !rotates_tool_only(arm.chain), "search",
            fmt::format("search is \"flange\", but the last joint of {} moves the tool's point; expected "
                        "\"all_joints\", \"axis\" or \"pose\"",
                        arm.name));
  refuse_if(!study.has_direction() && study.rotation_weight != Study{}.rotation_weight, "rotation_weight_m",
            "rotation_weight_m weighs the orientation, which is not searched; expected search = \"pose\" or \"axis\", "
            "or no rotation_weight_m");
}

// Drops a control that a sweep splits, or that is not solved.
void drop_lost_control(Study& study) {
  std::string& control = study.plan.control;
  const std::vector<std::string> labels = labels_of(study);
  if (control.empty() || std::ranges::find(labels, control) != labels.end()) return;
  study.notes.push_back(fmt::format("the control, {}, is swept or left out, so every pair is compared", control));
  control.clear();
}

// Drops solvers that figures name and that the study is read without.
void drop_lost_figures(Study& study) {
  std::erase_if(study.figures.solvers, [&](const std::string& label) {
    return std::ranges::count(study.awaited, label, &AwaitedSolver::label) > 0;
  });
}

// Checks answers that were made elsewhere against the study's targets. A solver whose answers are to other targets is
// awaited.
void check_answers(Study& study, const Robot& arm) {
  for (const SolverEntry& entry : study.solvers) {
    if (!entry.answers) continue;
    const std::string reason = difference_in_targets(*entry.answers, study, arm);
    if (!reason.empty()) study.awaited.push_back({entry.label, entry.answers->path, reason});
  }
  std::erase_if(study.solvers, [&](const SolverEntry& entry) {
    return std::ranges::count(study.awaited, entry.label, &AwaitedSolver::label) > 0;
  });
  drop_lost_control(study);
  drop_lost_figures(study);
}

// A name that a key gives, and what it must be the name of.
struct GivenName {
  std::string_view key;
  std::string_view kind;  // "metric"
  const std::string& name;
};

// Throws a mistake if the name is none of the known ones.
void refuse_unknown(const TomlReader& reader, const GivenName& given, const std::vector<std::string>& known) {
  if (std::ranges::find(known, given.name) == known.end())
    throw reader.mistake(given.key, unknown_name(given.kind, given.name, known));
}

// Reads the keys of a study that are in no table.
void read_general_keys(TomlReader& reader, Study& study) {
  const toml::table& table = reader.table();
  list_fields(reader, study);
  // By default, wrap as controllers do: otherwise whole turns decide whose joint motion is smallest. Stored definitions
  // have their own value.
  if (study.search == Search::pose && !table.contains("wrap")) study.wrap = WrapPolicy::nearest;
  if (study.name.empty()) reader.fail("name", *table.get("name"), "a non-empty name");
  const auto papers = published::papers();
  if (!study.published.empty())
    refuse_unknown(reader, {.key = "published", .kind = "paper", .name = study.published},
                   {papers.begin(), papers.end()});
  if (!table.contains("robot"))
    throw reader.mistake("robot", "robot is missing; expected the name of an arm (ikbench list robots) or its file");
}

// Reads [urdf], which only a study with a URDF file may have.
void read_urdf(TomlReader& reader, Study& study) {
  if (reader.find("urdf") != nullptr && !is_urdf_file(study.robot))
    throw reader.mistake("urdf", fmt::format("[urdf] is only for URDF files, but robot is \"{}\"; expected one such as "
                                             "\"my_arm.urdf\"",
                                             study.robot));
  TomlReader urdf = reader.part("urdf");
  if (urdf.find("snap_deg") != nullptr)
    throw urdf.mistake("snap_deg",
                       "angles of a URDF file are no longer snapped: the arm is taken as the file has "
                       "it; expected no snap_deg");
  read_part(urdf, study.urdf);
}

// Gives a grid the settings that its file leaves to the arm, or to what a grid is for.
void set_defaults_of_grid(const toml::table& table, Study& study, const Robot& arm) {
  constexpr int joints_of_pose = 6, joints_of_axis = 5;
  if (!table.contains("runs")) study.runs = 1;
  if (!table.contains("start")) study.start = Start::middle;
  if (table.contains("search")) return;
  study.search = Search::all_joints;
  if (arm.joints() == joints_of_axis) study.search = Search::axis;
  if (arm.joints() < joints_of_pose) return;
  study.search = Search::pose;
  if (!table.contains("wrap")) study.wrap = WrapPolicy::nearest;
}

// Lays a grid out for the arm, once the search and its tolerances are known.
void lay_out_path(const TomlReader& reader, Study& study, const Robot& arm) {
  with_key_context(reader, "path", [&] {
    study.path->lay_out(arm, {study.search, study.stop.tolerance, study.stop.angle_tolerance});
  });
}

// Reads [stop]. If only evaluations are limited, iterations do not end a solve. A grid that chooses the search by the
// arm has a tolerance of the orientation only if the orientation is searched.
void read_stop(const TomlReader& stop, Study& study, bool chooses_search) {
  read_part(stop, study.stop);
  if (chooses_search && !study.has_direction()) study.stop.angle_tolerance = 0;
  if (study.stop.evaluations > 0 && !stop.table().contains("iterations"))
    study.stop.iterations = max_iterations(study.stop.evaluations);
  check_stop(stop, study);
}

// Converts the initial configuration from the units of files, or takes the default if the study gives none.
void convert_initial(const TomlReader& reader, Study& study, const Robot& arm) {
  if (study.initial.size() == 0) {
    study.initial = default_configuration(arm);
  } else if (study.initial.size() == arm.joints()) {
    study.initial = study.initial.cwiseProduct(joint_units(arm.chain)).eval();
  } else {
    throw reader.mistake("initial_deg", fmt::format("initial_deg has {}; expected {}, one for each joint of {}",
                                                    counted(study.initial.size(), "values"), arm.joints(), arm.name));
  }
}

// Reads [require], whose labels must be of the study. A label that a sweep splits stands for all that the sweep made.
void read_requirements(const TomlReader& require, Study& study) {
  study.requirements = results::for_swept_labels(results::read_requirements(require), labels_in_file(study));
  if (study.path->grid() != nullptr && !study.requirements.empty())
    throw std::invalid_argument(
        fmt::format("[require]: {}; a study of random targets can have it", results::grid_is_no_sample));
  for (const results::Requirement& requirement : study.requirements) {
    const std::string lack = results::lack_of_share(study, requirement.metric);
    if (!lack.empty()) throw require.mistake(requirement.metric, lack);
    if (!requirement.solver.empty())
      refuse_unknown(require, {.key = requirement.solver, .kind = "label", .name = requirement.solver},
                     labels_in_file(study));
  }
}

// Reads [analysis]. The control may be a label that a sweep splits, which is dropped.
void read_plan(const TomlReader& analysis, Study& study) {
  read_part(analysis, study.plan);
  for (const std::string& metric : study.plan.tie_breakers)
    refuse_unknown(analysis, {.key = "tie_breakers", .kind = "metric", .name = metric}, results::default_tie_breakers);
  const std::string& control = study.plan.control;
  const bool is_swept = std::ranges::find(study.solvers, control, &SolverEntry::sweep_base) != study.solvers.end();
  if (!control.empty() && !is_swept)
    refuse_unknown(analysis, {.key = "control", .kind = "label", .name = control}, labels_in_file(study));
  drop_lost_control(study);
}

}  // namespace

Study read_study(const toml::table& table, std::string_view source, const ArmOfStore& arm_of_store) {
  Study study;
  study.name = std::filesystem::path(source).stem().string();  // two files are two studies
  TomlReader reader(table, source, "");
  read_general_keys(reader, study);
  study.path = read_path(PathReader(reader.part("path")));
  read_urdf(reader, study);
  const Robot arm = read_arm(reader, study, arm_of_store);
  if (study.path->grid() != nullptr) set_defaults_of_grid(table, study, arm);
  const TomlReader stop = reader.part("stop"), analysis = reader.part("analysis"), figures = reader.part("figures");
  read_stop(stop, study, study.path->grid() != nullptr && !table.contains("search"));
  lay_out_path(reader, study, arm);
  read_part(reader.part("loop"), study.loop);
  if (reader.find("check") != nullptr) read_check(reader.part("check"), study);
  convert_initial(reader, study, arm);
  read_solvers(reader, study, arm);
  read_plan(analysis, study);
  read_requirements(reader.part("require"), study);
  read_style(figures, study.figures);
  for (const std::string& label : study.figures.solvers)
    refuse_unknown(figures, {.key = "solvers", .kind = "label", .name = label}, labels_in_file(study));
  reader.refuse_unknown_keys();
  check_study(reader, study, arm);
  check_answers(study, arm);
  return study;
}

namespace {

// Adds to a study without targets the keys that it lacks, from the study `any-arm` (ikbench run --robot).
void add_protocol(toml::table& study) {
  constexpr std::string_view protocol = "any-arm", source = "without [path] as any-arm";
  toml::table any_arm = toml::parse(find_embedded(study_files, protocol)->text, source);
  for (const char* key : {"name", "title", "robot", "solvers"}) any_arm.erase(key);
  if (const std::optional search = study["search"].value<std::string>();
      search && *search != "pose" && *search != "axis")
    any_arm["stop"].as_table()->erase("tolerance_deg");
  if (study["stop"]["evaluations"]) any_arm["stop"].as_table()->erase("iterations");  // read_study knows how many
  const auto add = [](toml::table& table, const toml::key& key, toml::node& node) {  // does nothing if the key is there
    node.visit([&](auto& value) { table.insert(key, std::move(value)); });
  };
  for (auto&& [key, node] : any_arm) {
    toml::table* const of_study = study[key].as_table();
    toml::table* const of_protocol = node.as_table();
    if (of_study == nullptr || of_protocol == nullptr) {
      add(study, key, node);
      continue;
    }
    for (auto&& [field, value] : *of_protocol) add(*of_study, field, value);
  }
}

// Returns why a name is neither a study file nor a built-in study.
std::string no_study(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    return fmt::format("{} is a folder; expected a TOML file, or a name of: ikbench list studies", file.string());
  if (std::filesystem::exists(file, error)) return fmt::format("{} is not a regular file", file.string());
  if (const std::string beside = file.string() + ".toml"; std::filesystem::is_regular_file(beside, error))
    return fmt::format("there is no file {0}; did you mean {0}.toml?", file.string());
  if (file.extension() == ".toml" || file.has_parent_path())
    return fmt::format("there is no file {}; expected a TOML file, or a name of: ikbench list studies", file.string());
  std::vector<std::string> names;
  for (const EmbeddedFile& embedded : study_files) names.emplace_back(embedded.stem());
  std::ranges::sort(names);
  return "there is no such file, and " + unknown_name("built-in study", file.string(), names);
}

}  // namespace

namespace {

// Returns the labels that a name means if no label is written so. These are labels in other cases of letters. If there
// are none, they are the labels of the solver with this name, or with this abbreviation in tables. Throws
// std::invalid_argument if no label is meant.
std::vector<std::string> labels_like(const Study& study, const std::string& name) {
  std::vector<std::string> labels, by_solver;
  const std::string wanted = lower_case(name), solver = solver_named(name);
  for (const SolverEntry& entry : study.solvers) {
    for (const std::string& label : {entry.label, entry.sweep_base})
      if (!label.empty() && lower_case(label) == wanted) labels.push_back(label);
    if (!entry.program && entry.solver == solver) by_solver.push_back(entry.label);
  }
  if (labels.empty()) labels = by_solver;
  if (labels.empty()) throw std::invalid_argument(unknown_name("label", name, labels_of(study)));
  return labels;
}

}  // namespace

std::filesystem::path base_folder(const TomlReader& reader, std::string_view key) {
  const toml::node* const node = reader.table().get(key);
  const bool is_of_file = node != nullptr && node->source().begin.line > 0 && !node->source().path;
  return is_of_file ? reader.source().parent_path() : std::filesystem::path();
}

std::string solver_named(const std::string& name) {
  const std::string wanted = lower_case(name);
  for (const solvers::SolverInfo& info : solvers::all_solvers()) {
    if (info.name == wanted) return info.name;
  }
  for (const Study& study : built_in_studies()) {
    for (const SolverEntry& entry : study.solvers) {
      if (lower_case(entry.label) == wanted) return entry.solver;
    }
  }
  return name;
}

void select_solvers(Study& study, const std::vector<std::string>& lists) {
  std::set<std::string> labels;
  for (std::string rest : lists) {
    do {
      std::string longest;  // longest label with which the list begins, because a label may have commas
      const auto take = [&](const std::string& label) {
        if (label.size() > longest.size() && (rest + ',').starts_with(label + ',')) longest = label;
      };
      for (const SolverEntry& entry : study.solvers) {
        take(entry.label);
        take(entry.sweep_base);
      }
      for (const AwaitedSolver& awaited : study.awaited) take(awaited.label);
      const std::vector<std::string> meant =
          longest.empty() ? labels_like(study, rest.substr(0, rest.find(','))) : std::vector{longest};
      rest.erase(0, longest.empty() ? std::min(rest.find(','), rest.size() - 1) + 1 : longest.size() + 1);
      labels.insert(meant.begin(), meant.end());
    } while (!rest.empty());
  }
  std::erase_if(study.solvers, [&](const SolverEntry& entry) {
    return !labels.contains(entry.label) && !labels.contains(entry.sweep_base);
  });
  std::erase_if(study.awaited, [&](const AwaitedSolver& awaited) { return !labels.contains(awaited.label); });
  std::erase_if(study.figures.solvers, [kept = labels_of(study)](const std::string& label) {
    return std::ranges::find(kept, label) == kept.end();
  });
  drop_lost_control(study);
}

Study parse_study(std::string_view toml_text, std::string_view source, const Overrides& overrides) {
  toml::table table = parse_toml(toml_text, source);
  const bool has_path = table.contains("path");
  for (const std::string& text : overrides) apply_override(table, text);
  const bool is_of_protocol = !has_path && !table["path"]["kind"];
  if (is_of_protocol) add_protocol(table);
  Study study = read_study(table, source);
  if (is_of_protocol)
    study.notes.emplace_back("targets: reachable poses from random starts, because there is no [path]");
  return study;
}

std::vector<Study> built_in_studies() {
  std::vector<Study> studies;
  for (const EmbeddedFile& file : study_files) studies.push_back(parse_study(file.text, source_of(file)));
  std::ranges::sort(studies, {}, &Study::name);
  return studies;
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
