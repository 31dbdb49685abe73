// ikbench robot: shows an arm of the library, of an arm file or of a URDF file, and the pose of its tool frame.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>

#include "base/names.hpp"
#include "base/number.hpp"
#include "base/units.hpp"
#include "cli/console.hpp"
#include "cli/file_kind.hpp"
#include "cli/options.hpp"
#include "experiments/study/study.hpp"
#include "robots/spherical_wrist.hpp"
#include "robots/urdf.hpp"

namespace ikbench::cli {

using namespace robots;

namespace {

struct RobotArguments {
  std::string robot;
  UrdfChoice urdf;
  std::string at;
  bool shows_links = false, shows_urdf = false;
};

// Returns the value in the unit with 12 digits. Further digits are errors of conversions.
std::string number(double value, double unit = 1) {
  return std::abs(value) < 1e-14 ? "0" : fmt::format("{:.12g}", value / unit);
}

std::string frame_text(const Frame& frame) {
  const Eigen::Vector3d &at = frame.position, &rpy = frame.rpy;
  return fmt::format("at ({}, {}, {}) m, roll pitch yaw ({}, {}, {}) deg", number(at.x()), number(at.y()),
                     number(at.z()), number(rpy.x(), degree), number(rpy.y(), degree), number(rpy.z(), degree));
}

std::string frame_line(std::string_view name, const Frame& frame) {
  return frame == Frame() ? "" : fmt::format("{} {}\n", name, frame_text(frame));
}

// Returns the kind of a joint, by the words of URDF.
const char* kind_text(Joint joint, bool is_endless) {
  switch (joint) {
    case Joint::turns:
      return is_endless ? "continuous" : "revolute";
    case Joint::slides:
      return "prismatic";
    case Joint::coupled:
      return "coupled";
  }
  return "";
}

std::string joint_table(const Robot& arm) {
  const std::vector<std::string> names = joint_names(arm.description);
  Rows rows{{"JOINT", "type", "from", "to", "", "a [m]", "alpha [deg]", "d [m]", "offset [deg]"}};
  const bool has_beta = std::ranges::any_of(arm.chain.links(), [](const DhLink& link) { return link.beta != 0; });
  if (has_beta) rows.front().insert(rows.front().begin() + 7, "beta [deg]");
  const bool has_velocities = arm.velocity.size() > 0;
  if (has_velocities) rows.front().emplace_back("velocity");
  if (!names.empty()) rows.front().emplace_back("name");
  const Configuration units = experiments::joint_units(arm.chain);
  for (Eigen::Index j = 0; j < arm.joints(); ++j) {
    const DhLink& link = arm.chain.links()[static_cast<std::size_t>(j)];
    const bool is_endless = !std::isfinite(arm.limits.lower[j]);
    const std::string unit = arm.chain.slides(j) ? "m" : "deg";
    rows.push_back({std::to_string(j + 1), kind_text(link.joint, is_endless),
                    is_endless ? "no" : number(arm.limits.lower[j], units[j]),
                    is_endless ? "limits" : number(arm.limits.upper[j], units[j]), is_endless ? "" : unit,
                    number(link.a), number(link.alpha, degree), number(link.d), number(link.offset, degree)});
    if (has_beta) rows.back().insert(rows.back().begin() + 7, number(link.beta, degree));
    if (has_velocities)
      rows.back().push_back(arm.velocity[j] == 0 ? "not known"
                                                 : fmt::format("{} {}/s", number(arm.velocity[j], units[j]), unit));
    if (!names.empty()) rows.back().push_back(names[static_cast<std::size_t>(j)]);
  }
  constexpr std::size_t any_width = 1000;  // digits do not break into lines
  return align_columns(rows, any_width);
}

std::string reach_text(const Robot& arm) {
  const Chain::Ball ball = arm.chain.reach();
  if (!std::isfinite(ball.radius)) return "reach: not known, because a joint is prismatic";
  return fmt::format("reach: at most {:.6g} m from ({}, {}, {}) m", ball.radius, number(ball.centre.x()),
                     number(ball.centre.y()), number(ball.centre.z()));
}

// Returns the configuration that --at names, in rad or m; the default one if `text` is empty. Throws
// std::invalid_argument if the text is not one number per joint, or if an angle looks like radians.
Configuration joints_at(const Robot& arm, const std::string& text) {
  if (text.empty()) return experiments::default_configuration(arm);
  std::vector<double> at;
  for (std::size_t from = 0; from <= text.size(); from = std::min(text.find(',', from), text.size()) + 1) {
    const std::string_view value = std::string_view(text).substr(from, text.find(',', from) - from);
    const std::optional<double> number = number_from(trimmed(value));
    if (!number || !(std::abs(*number) <= 1e6))
      throw std::invalid_argument(fmt::format(
          "--at: joint {} is {}; expected a number from -1000000 to 1000000 for each of the {} joints of {}",
          at.size() + 1, in_quotes(value), arm.joints(), arm.name));
    at.push_back(*number);
  }
  if (std::ssize(at) != arm.joints())
    throw std::invalid_argument(fmt::format("--at has {}; expected {}, one for each joint of {}",
                                            counted(std::ssize(at), "values"), arm.joints(), arm.name));
  const Configuration units = experiments::joint_units(arm.chain);
  const Eigen::Map<const Eigen::VectorXd> q(at.data(), arm.joints());
  for (Eigen::Index j = 0; j < q.size(); ++j)
    if (const std::string_view warning = doubt_of_angle(q[j], units[j]); !warning.empty() && !arm.chain.slides(j))
      throw std::invalid_argument(fmt::format("--at: {} {}", q[j], warning));
  return q.cwiseProduct(units);
}

std::string tool_text(const Robot& arm, const Configuration& q) {
  std::vector<std::string> values;
  for (Eigen::Index j = 0; j < q.size(); ++j)
    values.push_back(arm.chain.slides(j) ? number(q[j]) + " m" : number(q[j], degree) + " deg");
  std::string text = fmt::format("with the joints at {}, the tool is {}", fmt::join(values, ", "),
                                 frame_text(frame_of(arm.chain.forward(q))));
  if (arm.limits.violation(q) > 0) text += "; a joint is outside its limits";
  return text;
}

std::string wrist_text(const Robot& arm) {
  if (SphericalWrist::fits(arm.chain)) return "spherical; search = \"wrist\", \"all_joints\", \"axis\" or \"pose\"";
  const std::string misfit = SphericalWrist::misfit(arm.chain);
  return fmt::format("not spherical{}; search = \"all_joints\", \"axis\" or \"pose\"",
                     misfit.empty() ? "" : ", " + misfit);
}

std::string robot_text(const Robot& arm) {
  const std::string head = fmt::format("{}: {}\nsource: {}\n\n{}{}", arm.name, arm.summary, arm.source,
                                       frame_line("base", arm.chain.base()), frame_line("tool", arm.chain.tool()));
  std::string rest = fmt::format("\n{}\nwrist: {}\n", reach_text(arm), wrist_text(arm));
  if (!arm.other_tip.empty()) rest += fmt::format("note: the arm may also end elsewhere: --tip {}\n", arm.other_tip);
  for (const std::string& note : arm.notes) rest += fmt::format("note: {}\n", note);
  return wrapped(head) + joint_table(arm) + wrapped(rest);
}

}  // namespace

void add_robot(const Command& command, Invocation&) {
  auto arguments = std::make_shared<RobotArguments>();
  command.add("ROBOT", &arguments->robot, "name of an arm (ikbench list robots), or a file: arm.toml, arm.urdf")
      .required();
  command.add(
      "--at", &arguments->at,
      "values of all joints [deg], or [m] for prismatic joints; default: zeros, or the nearest values inside the limits");
  add_link_options(command, arguments->urdf.base, arguments->urdf.tip);
  command.add("--links", &arguments->shows_links, "print only the tree of links of a URDF file");
  command.add("--urdf", &arguments->shows_urdf, "print only the arm, as a URDF file");
  command.footer(
      "  ikbench robot ur5e\n"
      "  ikbench robot franka_panda --at 0,-45,0,-135,0,90,45\n"
      "  ikbench robot my_arm.urdf --base base_link --tip tool0");
  command.callback([arguments, command] {
    for (const char* option : {"--base", "--tip", "--links"}) {
      if (!command.was_given(option) || is_urdf_file(arguments->robot)) continue;
      throw std::invalid_argument(
          fmt::format("{} is only for URDF files, but the arm is {}; leave the option out", option, arguments->robot));
    }
    if (arguments->shows_links)
      return fmt::print("{}", printable(link_tree(text_of_arm_file(arguments->robot), arguments->robot)));
    refuse_as_arm(arguments->robot);
    const Robot arm =
        is_arm_file(arguments->robot) ? load_robot(arguments->robot, arguments->urdf) : robot(arguments->robot);
    if (arguments->shows_urdf) return fmt::print("{}", urdf_of(arm, arm.chain));
    const Configuration q = joints_at(arm, arguments->at);
    fmt::print("{}{}\n", robot_text(arm), wrapped(tool_text(arm, q)));
    for (const std::string& warning : doubts_of(arm)) warn(warning);
  });
}

}  // namespace ikbench::cli
