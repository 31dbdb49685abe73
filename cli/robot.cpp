// ikbench robot: shows an arm of the library, of an arm file or of a URDF file, and its tool's pose.
#include "cli/robot.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "analysis/figures/arm.hpp"
#include "analysis/figures/figure.hpp"
#include "analysis/figures/figure_parts.hpp"
#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/plan_options.hpp"
#include "cli/reporting.hpp"
#include "experiments/study.hpp"
#include "experiments/study_writer.hpp"
#include "numerics/units.hpp"
#include "robots/spherical_wrist.hpp"
#include "robots/urdf.hpp"

namespace ikbench::cli {

using namespace numerics;
using namespace robots;
using namespace figures;
using namespace report;

namespace {

struct RobotArguments {
  std::string robot, out, limits = "hard";
  UrdfChoice urdf;
  double snap_deg = 0.001;
  std::vector<double> at;
  OutputArguments output;
};

std::string number(double value) { return fmt::format("{:g}", value == 0 ? 0.0 : value); }  // no -0

std::string frame_text(const Frame& frame) {
  const Eigen::Vector3d &at = frame.position, rpy_deg = frame.rpy / degree;
  return fmt::format("at ({}, {}, {}) m, roll pitch yaw ({}, {}, {}) deg", number(at.x()), number(at.y()),
                     number(at.z()), number(rpy_deg.x()), number(rpy_deg.y()), number(rpy_deg.z()));
}

std::string frame_line(std::string_view name, const Frame& frame) {
  return frame == Frame() ? "" : fmt::format("{} {}\n", name, frame_text(frame));
}

bool slides(const Robot& arm, Eigen::Index joint) {
  return arm.chain.links()[static_cast<std::size_t>(joint)].joint == Joint::slides;
}

std::string joint_table(const Robot& arm) {
  std::vector<std::string> names;
  for (const DescribedJoint& joint : arm.description) {
    if (joint.motion != DescribedJoint::Motion::none) names.push_back(joint.name);
  }
  std::vector<std::vector<std::string>> rows{
      {"JOINT", "", "from", "to", "", "a [m]", "alpha [deg]", "d [m]", "offset [deg]"}};
  if (!names.empty()) rows.front().emplace_back("name");
  const Configuration units = experiments::joint_units(arm.chain);
  for (Eigen::Index j = 0; j < arm.joints(); ++j) {
    const DhLink& link = arm.chain.links()[static_cast<std::size_t>(j)];
    const double lower = arm.limits.lower[j] / units[j];
    const bool is_endless = !std::isfinite(lower);
    rows.push_back({std::to_string(j + 1),
                    slides(arm, j)                 ? "slides"
                    : link.joint == Joint::coupled ? "coupled"
                                                   : "turns",
                    is_endless ? "without" : number(lower), is_endless ? "end" : number(arm.limits.upper[j] / units[j]),
                    is_endless       ? ""
                    : slides(arm, j) ? "m"
                                     : "deg",
                    number(link.a), number(link.alpha / degree), number(link.d), number(link.offset / degree)});
    if (!names.empty()) rows.back().push_back(names[static_cast<std::size_t>(j)]);
  }
  return aligned(rows);
}

std::string reach_text(const Robot& arm) {
  const Chain::Ball ball = arm.chain.reach();
  if (!std::isfinite(ball.radius)) return "reach: not known, because a joint slides";
  return fmt::format("reach: at most {} m from ({}, {}, {}) m", number(ball.radius), number(ball.centre.x()),
                     number(ball.centre.y()), number(ball.centre.z()));
}

Configuration joints_at(const Robot& arm, const std::vector<double>& at) {
  if (at.empty()) {  // zeros, or the nearest that the limits allow
    return arm.limits.lower.cwiseMax(Eigen::VectorXd::Zero(arm.joints())).cwiseMin(arm.limits.upper);
  }
  if (at.size() != static_cast<std::size_t>(arm.joints())) {
    throw std::invalid_argument(
        fmt::format("--at has {} values; expected {}, one for each joint of {}", at.size(), arm.joints(), arm.name));
  }
  Configuration q = experiments::joint_units(arm.chain);
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    const double value = at[static_cast<std::size_t>(j)];
    if (!(std::abs(value) <= 1e6)) {
      throw std::invalid_argument(fmt::format("--at has {}; expected values within +-1e6", value));
    }
    q[j] *= value;
  }
  return q;
}

std::string tool_text(const Robot& arm, const Configuration& q) {
  std::vector<std::string> values;
  const Configuration in_units = q.cwiseQuotient(experiments::joint_units(arm.chain));
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    values.push_back(number(in_units[j]) + (slides(arm, j) ? " m" : " deg"));
  }
  std::string text = fmt::format("with the joints at {}, the tool is {}", fmt::join(values, ", "),
                                 frame_text(frame_of(arm.chain.forward(q))));
  if (arm.limits.violation(q) > 0) text += "; a joint is outside its limits";
  return text;
}

Figure picture(const Robot& arm, const Configuration& q) {
  Figure figure{.name = "robot",
                .caption = fmt::format("{}: {}.", arm.name, tool_text(arm, q)),
                .height_cm = 8.0,
                .data = "# the arm from the base to the tool: x, y, z [cm]\n"};
  std::array<std::vector<double>, 3> coordinates;
  for (const Point& point : arm_points(arm, q)) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      coordinates[axis].push_back(point[axis] / centimetre);
      figure.data += data_number(coordinates[axis].back()) + (axis < 2 ? ' ' : '\n');
    }
  }
  figure.settings = space_axes(coordinates);
  figure.plot = "splot 'robot.dat' using 1:2:3 with linespoints lw 1.6 pt 7 ps 0.4 lc rgb word(colours, 2) notitle";
  return figure;
}

void draw_arm(const Robot& arm, const Configuration& q, const std::filesystem::path& folder,
              const OutputArguments& output) {
  draw({picture(arm, q)}, folder, {.jobs = 1});
  if (output.is_json) return;
  fmt::print("picture: {}\n", printable((folder / "robot.svg").string()));
}

}  // namespace

std::string robot_text(const Robot& arm) {
  std::string text = fmt::format(
      "{}: {}\nfrom {}\n\n{}{}{}\n{}\nwrist: {}\n", arm.name, arm.summary, arm.source,
      frame_line("base", arm.chain.base()), frame_line("tool", arm.chain.tool()), joint_table(arm), reach_text(arm),
      SphericalWrist::fits(arm.chain) ? "spherical; search = \"wrist\", \"all_joints\" or \"pose\""
                                      : "not spherical; search = \"all_joints\" or \"pose\"");
  for (const std::string& note : arm.notes) text += fmt::format("note: {}\n", note);
  return wrapped(text);
}

report::Json robot_json(const Robot& arm) {
  report::Json json{{"name", arm.name}, {"summary", arm.summary}, {"source", arm.source}, {"joints", arm.joints()}};
  const report::Json definition = parsed_ordered_json(experiments::to_json(arm));
  for (const auto& [key, value] : definition.items()) json[key] = value;
  json["reach_m"] = json_number(arm.chain.reach().radius);
  json["has_spherical_wrist"] = SphericalWrist::fits(arm.chain);
  return json;
}

void add_robot(CLI::App& app, Invocation&) {
  auto arguments = std::make_shared<RobotArguments>();
  CLI::App* command = app.add_subcommand("robot", "Show an arm: its joints, limits, reach, wrist and tool");
  command->add_option("ROBOT", arguments->robot, "a name from ikbench list robots, or a file: arm.toml, arm.urdf")
      ->required();
  command
      ->add_option("--at", arguments->at,
                   "values of all joints [deg], or [m] where one slides; default: zeros, or the nearest inside the "
                   "limits")
      ->delimiter(',');
  command->add_option("--base", arguments->urdf.base,
                      "link of a URDF file from which the arm is read; default: the root");
  command->add_option("--tip", arguments->urdf.tip,
                      "link of a URDF file to which the arm is read; default: the one with the most joints before it");
  command->add_option("--limits", arguments->limits, "limits of a URDF file: hard, or soft where they are tighter")
      ->check(CLI::IsMember({"hard", "soft"}))
      ->capture_default_str();
  command
      ->add_option("--snap-deg", arguments->snap_deg,
                   "angles of a URDF file this near a multiple of 15 deg, and axes this near parallel, are meant to be "
                   "it; 0: none")
      ->check(number_in({0, 1}))
      ->capture_default_str();
  command->add_option("--out", arguments->out, "also draw the arm into this folder: robot.svg, .pdf, .png");
  add_json_option(*command, arguments->output);
  command->footer(
      "Examples:\n"
      "  ikbench robot ur5e\n"
      "  ikbench robot franka_panda --at 0,-45,0,-135,0,90,45 --out out/panda\n"
      "  ikbench robot my_arm.urdf --base base_link --tip tool0 --limits soft");
  command->callback([arguments, command] {
    for (const char* option : {"--base", "--tip", "--limits", "--snap-deg"}) {
      if (command->count(option) == 0 || is_urdf_file(arguments->robot)) continue;
      throw std::invalid_argument(
          fmt::format("{} is about a URDF file, but the arm is {}; leave it out", option, arguments->robot));
    }
    UrdfChoice choice = arguments->urdf;
    choice.limits = arguments->limits == "soft" ? UrdfChoice::Limits::soft : UrdfChoice::Limits::hard;
    choice.snap = arguments->snap_deg * degree;
    const Robot arm = is_arm_file(arguments->robot) ? load_robot(arguments->robot, choice) : robot(arguments->robot);
    const Configuration q = joints_at(arm, arguments->at);
    if (arguments->output.is_json) {
      const Configuration in_units = q.cwiseQuotient(experiments::joint_units(arm.chain));
      const Frame tool = frame_of(arm.chain.forward(q));
      const Eigen::Vector3d rpy_deg = tool.rpy / degree;
      report::Json json = robot_json(arm);
      json["at"] = std::vector<double>(in_units.begin(), in_units.end());
      json["tool_at"] = {{"position_m", std::vector<double>(tool.position.begin(), tool.position.end())},
                         {"rpy_deg", std::vector<double>(rpy_deg.begin(), rpy_deg.end())}};
      show_json(json);
    } else
      fmt::print("{}{}\n", robot_text(arm), wrapped(tool_text(arm, q)));
    if (!arguments->out.empty()) draw_arm(arm, q, arguments->out, arguments->output);
  });
}

}  // namespace ikbench::cli
