// ikbench solve: one target from the command line.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/plan_options.hpp"
#include "cli/reporting.hpp"
#include "experiments/orientation.hpp"
#include "experiments/runner.hpp"
#include "experiments/study_reader.hpp"
#include "experiments/study_writer.hpp"
#include "numerics/names.hpp"
#include "numerics/number.hpp"
#include "numerics/units.hpp"
#include "results/export.hpp"
#include "results/orientation.hpp"
#include "robots/spherical_wrist.hpp"
#include "solvers/registry.hpp"

namespace ikbench::cli {

using namespace numerics;
using namespace robots;
using namespace solvers;
using namespace results;
using namespace experiments;
using namespace figures;
using namespace report;

namespace {

constexpr std::string_view command_line = "the command line";
constexpr int not_solved = 6;  // exit code

struct SolveArguments {
  std::string robot = "kuka_iiwa14", solver = "damped_least_squares", tool = "down", search;
  std::vector<double> position_cm, rpy_deg, start_deg;
  Overrides overrides;
  double tolerance_cm = 0.01;
  std::optional<double> tolerance_deg;
  std::int64_t seed = 1;
  OutputArguments output;
};

// Turns the study reader's message about the flags' study into one about the flags.
std::invalid_argument of_flags(std::string message) {
  const std::string place = fmt::format("{}:", command_line);  // with a line and column that nobody wrote
  if (message.starts_with(place)) message.erase(0, std::min(message.find(": ") + 2, message.size()));
  constexpr std::array<std::pair<std::string_view, std::string_view>, 4> flags{
      {{"search", "--search"},
       {"seed", "--seed"},
       {"stop.tolerance_cm", "--tolerance-cm"},
       {"stop.tolerance_deg", "--tolerance-deg"}}};
  for (const auto& [key, flag] : flags) {
    const std::string words = fmt::format("--set {0}: {0} ", key);
    if (message.starts_with(words)) message.replace(0, words.size() - 1, flag);
  }
  return std::invalid_argument(message);
}

// The study that the flags describe. It is read like a file, so that the same ranges hold.
Study study_of(const SolveArguments& arguments) {
  solver(arguments.solver);
  Study study{.name = "solve", .robot = arguments.robot};
  study.solvers = {{arguments.solver, arguments.solver, {}}};
  Overrides overrides{"search=all_joints", fmt::format("seed={}", arguments.seed), "runs=1",
                      fmt::format("stop.tolerance_cm={}", arguments.tolerance_cm)};
  Overrides of_arm{"search=all_joints"};
  for (const std::string& text : arguments.overrides) {
    const bool of_solver = text.find('.') == std::string::npos || text.find('.') > text.find('=');
    overrides.push_back(of_solver ? arguments.solver + "." + text : text);
    if (!of_solver) of_arm.push_back(text);
  }
  Study any_solver{.name = "solve", .robot = arguments.robot};  // the solver asked for may not fit the arm
  any_solver.solvers = {{"any", "random_search", {}}};
  const Robot arm = arm_of(parse_study(to_toml(any_solver), command_line, of_arm));
  const int joints = arm.joints();
  if (!arguments.start_deg.empty() && arguments.start_deg.size() != static_cast<std::size_t>(joints)) {
    throw std::invalid_argument(fmt::format("--start-deg has {} angles; expected {}, one for each joint of {}",
                                            arguments.start_deg.size(), joints, arguments.robot));
  }
  study.initial.resize(static_cast<Eigen::Index>(arguments.start_deg.size()));
  for (std::size_t j = 0; j < arguments.start_deg.size(); ++j) {
    study.initial[static_cast<Eigen::Index>(j)] =
        arguments.start_deg[j] * joint_units(arm.chain)[static_cast<Eigen::Index>(j)];
  }
  if (!arguments.start_deg.empty() && arm.limits.violation(study.initial) > 0) {
    warn("--start-deg is outside the joint limits");
  }
  if (is_arm_file(arguments.robot)) study.robot_of_file = std::make_shared<const Robot>(arm);
  const bool needs_pose = !solver(arguments.solver).why_not(arm.chain, solvers::GoalKind::position).empty();
  const std::string search = !arguments.search.empty()         ? arguments.search
                             : needs_pose                      ? "pose"
                             : SphericalWrist::fits(arm.chain) ? "wrist"
                             : !arguments.rpy_deg.empty()      ? "pose"
                                                               : "all_joints";
  overrides.front() = "search=" + search;
  if (arguments.tolerance_deg || (search == "pose" && arguments.tolerance_cm > 0)) {
    constexpr double by_default = 0.01;
    overrides.push_back(fmt::format("stop.tolerance_deg={}", arguments.tolerance_deg.value_or(by_default)));
  }
  return parse_study(to_toml(study), command_line, overrides);
}

void check_range(std::string_view option, const std::vector<double>& values) {
  const auto wrong = std::ranges::find_if(values, [](double value) { return !(std::abs(value) <= 1e6); });
  if (wrong == values.end()) return;
  throw std::invalid_argument(fmt::format("{} has {}; expected numbers within +-1e6", option, *wrong));
}

void check_size(std::string_view option, const std::vector<double>& values, std::string_view expected) {
  if (values.size() == 3) return;
  throw std::invalid_argument(fmt::format("{} has {} number{}; expected 3: {}", option, values.size(),
                                          values.size() == 1 ? "" : "s", expected));
}

Pose target_of(const SolveArguments& arguments) {
  check_size("--position-cm", arguments.position_cm, "x y z [cm]");
  if (!arguments.rpy_deg.empty()) check_size("--rpy-deg", arguments.rpy_deg, "roll, pitch and yaw [deg]");
  check_range("--position-cm", arguments.position_cm);
  check_range("--rpy-deg", arguments.rpy_deg);
  Pose target = Pose::Identity();
  target.translation() = Eigen::Map<const Eigen::Vector3d>(arguments.position_cm.data()) / 100;
  if (arguments.rpy_deg.empty()) {
    target.linear() = rotation(arguments.tool == "down" ? Tool::down : Tool::eq27);
  } else {
    target.linear() = rotation_from_rpy(Eigen::Map<const Eigen::Vector3d>(arguments.rpy_deg.data()) * degree);
  }
  return target;
}

Study asked_study(const SolveArguments& arguments) {
  try {
    return study_of(arguments);
  } catch (const std::invalid_argument& error) {
    throw of_flags(error.what());
  }
}

void show(const SolveRecord& record, const Study& study) {
  const Robot arm = arm_of(study);
  std::vector<std::vector<std::string>> rows{{"solver", record.solver},
                                             {"status", std::string(name_of(record.status))}};
  for (std::size_t j = 0; j < record.answer_rad.size(); ++j) {
    const bool slides = arm.chain.links()[j].joint == Joint::slides;
    rows.push_back({fmt::format("joint {} [{}]", j + 1, slides ? "cm" : "deg"),
                    fmt::format("{:.6f}", record.answer_rad[j] / (slides ? centimetre : degree))});
  }
  rows.push_back({"position error [cm]", fmt::format("{:.6g}", record.position_error_cm)});
  rows.push_back({"orientation error [deg]", fmt::format("{:.6g}{}", orientation_angle_deg(record.orientation_error),
                                                         study.search == Search::all_joints ? " (not sought)" : "")});
  rows.push_back({"variation [deg]", fmt::format("{:.4f}", record.variation_deg)});
  rows.push_back({"limit violation [deg]", fmt::format("{:.4f}", record.limit_violation_deg)});
  const std::vector<DhLink>& links = arm.chain.links();
  if (std::ranges::any_of(links, [](const DhLink& link) { return link.joint == Joint::slides; })) {
    rows.push_back({"variation [cm]", fmt::format("{:.4f}", record.variation_m / centimetre)});
    rows.push_back({"limit violation [cm]", fmt::format("{:.4f}", record.limit_violation_m / centimetre)});
  }
  rows.push_back({"evaluations", std::to_string(record.evaluations)});
  rows.push_back({"iterations", std::to_string(record.iterations)});
  rows.push_back({"time [ms]", fmt::format("{:.4f}", record.seconds * 1e3)});
  const Tones tones{.column = 1, .of_rows = {Tone::plain, record.status == Status::ok ? Tone::good : Tone::bad}};
  for (const std::string& line : aligned_rows(rows, text_width(), tones)) fmt::print("{}\n", line);
}

}  // namespace

void add_solve(CLI::App& app, Invocation& invocation) {
  auto arguments = std::make_shared<SolveArguments>();
  CLI::App* command = app.add_subcommand("solve", "Solve one target and print the answer with its errors");
  const CLI::Validator number(
      [](const std::string& text) {
        return numerics::number_from(text) ? std::string()
                                           : fmt::format("'{}' is not a number", numerics::front(text, 100));
      },
      "");
  command->add_option("--position-cm", arguments->position_cm, "target position x y z [cm]")
      ->required()
      ->check(number)
      ->delimiter(',');
  command->add_option("--rpy-deg", arguments->rpy_deg, "roll, pitch and yaw of the tool [deg]; default: see --tool")
      ->check(number)
      ->delimiter(',');
  command->add_option("--tool", arguments->tool, "orientation of the tool: down, or as in the paper's Eq. 27")
      ->check(CLI::IsMember({"down", "eq27"}))
      ->capture_default_str();
  command
      ->add_option("--robot", arguments->robot, "a name from ikbench list robots, or a file: my_arm.toml, my_arm.urdf")
      ->capture_default_str();
  command->add_option("--solver", arguments->solver, "see: ikbench list solvers")->capture_default_str();
  command
      ->add_option(
          "--search", arguments->search,
          "wrist, all_joints or pose; default: pose for a solver of poses alone, wrist if the arm has a spherical wrist, "
          "else pose with --rpy-deg and all_joints, for the position alone, without")
      ->check(CLI::IsMember({"wrist", "all_joints", "pose"}));
  command
      ->add_option(
          "--start-deg", arguments->start_deg,
          "start values of all joints [deg], or [m] where one slides; default: zeros, or the nearest inside the "
          "limits")
      ->check(number)
      ->delimiter(',');
  command
      ->add_option("--set", arguments->overrides,
                   "change an option of the solver or of the stop rule: alpha=0.9, stop.iterations=50")
      ->allow_extra_args(false);
  command
      ->add_option("--tolerance-cm", arguments->tolerance_cm,
                   "stop at this position error [cm]; a larger error has status tolerance_missed; 0: no tolerance")
      ->check(number)
      ->capture_default_str();
  command
      ->add_option("--tolerance-deg", arguments->tolerance_deg,
                   "with --search pose: the tool is also turned no further than this from the target [deg]; default: "
                   "0.01")
      ->check(number);
  command->add_option("--seed", arguments->seed, "seed of the random numbers")
      ->check(whole_number())
      ->capture_default_str();
  add_json_option(*command, arguments->output);
  command->footer(
      "Examples:\n"
      "  ikbench solve --position-cm 60 20 10\n"
      "  ikbench solve --position-cm 60,20,10 --solver ik_bat --set bounds=clamp --set stop.iterations=1000\n"
      "  ikbench solve --robot planar_2 --position-cm 50 50 0\n"
      "  ikbench solve --robot ur5e --position-cm 40 20 30 --rpy-deg 180 0 90\n\n"
      "Exit codes: 0 the status of the answer is ok, 6 it is another and the answer is printed all the same,\n"
      "1 a mistake in the request, 2 a failure of the program or the system.");
  command->callback([arguments, &invocation] {
    const Pose target = target_of(*arguments);
    check_range("--start-deg", arguments->start_deg);
    Study study = asked_study(*arguments);
    study.path = path_through({target});
    warn_of_unreachable(study);
    const SolveRecord record = solve_once(study, study.solvers.front(), target);
    if (arguments->output.is_json)
      fmt::print("{}\n", to_json(record));
    else
      show(record, study);
    if (record.status != Status::ok) invocation.exit_code = not_solved;
  });
}

}  // namespace ikbench::cli
