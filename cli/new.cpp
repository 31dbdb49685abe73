// ikbench new: writes a study to start from.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "experiments/study_reader.hpp"
#include "experiments/study_writer.hpp"
#include "numerics/json.hpp"
#include "numerics/names.hpp"
#include "numerics/toml_table.hpp"
#include "results/files.hpp"

namespace ikbench::cli {

using namespace numerics;
using namespace robots;
using namespace results;
using namespace experiments;

namespace {

struct NewArguments {
  std::string file, like, robot = "kuka_iiwa14";
  UrdfChoice urdf;
  std::vector<std::string> solvers{"damped_least_squares", "newton", "ik_bat"};
  bool without_paper = false, forced = false;
};

std::string quoted(const std::string& text) { return text_of(nlohmann::json(text)); }  // as TOML quotes it too

// The arm as a study in that folder names it.
std::string robot_beside(const std::filesystem::path& folder, const std::string& robot) {
  return is_arm_file(robot) ? std::filesystem::proximate(robot, folder.empty() ? "." : folder).string() : robot;
}

// A short study of poses with one budget for all solvers.
std::string short_study(const NewArguments& arguments) {
  const std::filesystem::path file = arguments.file;
  std::string text = fmt::format(
      R"(# A study to start from. Every key with its meaning: ikbench list studies {}
name = {}
robot = {}  # a name from ikbench list robots, or a file beside this one: "my_arm.urdf", "my_arm.toml"
search = "pose"         # position and orientation; "all_joints": the position alone
start = "middle"        # every solve starts in the middle of the joint limits
bounds = "clamp"        # every solver stays inside the joint limits
runs = 100              # a target each
[stop]
iterations = 100000     # so many that they stop no solver
evaluations = 10000     # the same budget for all solvers; schedules end with it
tolerance_cm = 0.1      # a solve ends this near to its target
tolerance_deg = 0.5
[path]
kind = "random"         # poses that the arm reaches, the same for all solvers; other kinds: ikbench list paths
points = 1
[analysis]              # fix it before you see the data
margin_percent = 5      # the smallest difference that matters
)",
      file.filename().string(), quoted(file.stem().string()),
      quoted(robot_beside(file.parent_path(), arguments.robot)));
  if (!arguments.urdf.base.empty() || !arguments.urdf.tip.empty()) text += "[urdf]\n";
  if (!arguments.urdf.base.empty()) text += fmt::format("base = {}\n", quoted(arguments.urdf.base));
  if (!arguments.urdf.tip.empty()) text += fmt::format("tip = {}\n", quoted(arguments.urdf.tip));
  for (const std::string& solver : arguments.solvers) {
    text += fmt::format("[[solvers]]\nsolver = {}  # its options: ikbench list solvers {}\n", quoted(solver), solver);
  }
  return text;
}

Study built_in(const std::string& name) {
  std::vector<std::string> names;
  for (Study& study : studies()) {
    if (study.name == name) return std::move(study);
    names.push_back(study.name);
  }
  throw std::invalid_argument(unknown_name("built-in study", name, names));
}

std::string study_like(const NewArguments& arguments) {
  Study study = built_in(arguments.like);
  study.name = std::filesystem::path(arguments.file).stem().string();
  if (arguments.without_paper) study.published = study.title = "";
  return fmt::format("# Like the built-in study {}. Keys that you leave out have their defaults.\n{}", arguments.like,
                     to_toml(study));
}

void check_names(const NewArguments& arguments) {
  for (const std::string& name : arguments.solvers) static_cast<void>(solvers::solver(name));
  static_cast<void>(is_arm_file(arguments.robot) ? load_robot(arguments.robot, arguments.urdf)
                                                 : robot(arguments.robot));
}

void write_new(const NewArguments& arguments) {
  const std::filesystem::path file = arguments.file;
  if (file.extension() != ".toml") {
    throw std::invalid_argument(fmt::format("a study is a file such as my.toml, but this one is {}", arguments.file));
  }
  if (!TomlReader::is_plain(file.filename().string()))
    throw std::invalid_argument(fmt::format("the name of the file is not {}", TomlReader::plain));
  std::error_code error;
  if (!arguments.forced && std::filesystem::exists(std::filesystem::symlink_status(file, error))) {
    throw std::invalid_argument(
        fmt::format("{} is there already; choose another name, or replace it with --force", arguments.file));
  }
  check_names(arguments);
  const std::string text = arguments.like.empty() ? short_study(arguments) : study_like(arguments);
  const Study study = parse_study(text, arguments.file);  // what is wrong is said before there is a file
  write_through(file, text);
  std::vector<std::string> labels;
  for (const SolverEntry& entry : study.solvers) labels.push_back(entry.label);
  fmt::print("{}: {} on {}, {} runs of {}\n", printable(arguments.file),
             printable(fmt::format("{}", fmt::join(labels, ", "))), printable(study.robot), study.runs,
             study.path->points() == 1 ? "one target" : fmt::format("{} targets", study.path->points()));
  if (!study.published.empty()) {
    fmt::print(
        "Its report stands beside the printed tables of {0}; published = \"\", or --without-paper, makes it a "
        "study of its own.\n",
        study.published);
  }
  fmt::print("Edit it, then: {}\n", printable(shell_command("ikbench", {"run", arguments.file})));
}

}  // namespace

void add_new(CLI::App& app, Invocation&) {
  auto arguments = std::make_shared<NewArguments>();
  CLI::App* command = app.add_subcommand("new", "Write a study to start from");
  command->add_option("FILE", arguments->file, "the TOML file to write; the study gets its name")->required();
  CLI::Option* const like = command->add_option(
      "--like", arguments->like, "a built-in study (ikbench list studies), with every key and its meaning");
  command
      ->add_flag("--without-paper", arguments->without_paper,
                 "leave out the paper whose printed tables the study is held against")
      ->needs(like);
  command
      ->add_option("--robot", arguments->robot, "a name from ikbench list robots, or a file: my_arm.toml, my_arm.urdf")
      ->excludes(like)
      ->capture_default_str();
  command
      ->add_option("--base", arguments->urdf.base, "link of a URDF file from which the arm is read; default: the root")
      ->excludes(like);
  command
      ->add_option("--tip", arguments->urdf.tip,
                   "link of a URDF file to which the arm is read; default: the one with the most joints before it")
      ->excludes(like);
  command->add_option("--solver", arguments->solvers, "a name from ikbench list solvers; give it once for each solver")
      ->allow_extra_args(false)
      ->excludes(like)
      ->capture_default_str();
  command->add_flag("--force", arguments->forced, "replace a file of that name");
  command->footer(
      "Examples:\n"
      "  ikbench new my.toml                      a short study: random poses, one budget for all solvers\n"
      "  ikbench new my.toml --robot my_arm.urdf --solver newton --solver levenberg_marquardt\n"
      "  ikbench new my.toml --like slim2023 --without-paper    its solvers and its helix, in a study of your own\n"
      "  ikbench run my.toml");
  command->callback([arguments] { write_new(*arguments); });
}

}  // namespace ikbench::cli
