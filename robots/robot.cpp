#include "robots/robot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "base/embedded_file.hpp"
#include "base/inputs.hpp"
#include "base/json.hpp"
#include "base/names.hpp"
#include "base/toml_table.hpp"
#include "robots/arm_fields.hpp"
#include "robots/urdf.hpp"

namespace ikbench::robots {

using namespace base;

namespace {

constexpr EmbeddedFile arm_files[]{
#include "arms.inc"
};

using Bounds = std::pair<double, double>;

LimitedLink read_link(TomlReader reader, Bounds lengths) {
  LimitedLink one{.lengths = lengths};
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const bool is_endless = reader.table()["limits_deg"].value<std::string_view>() == no_limits;
  if (is_endless) one.limits = {-infinity, infinity};
  list_fields(reader, one);
  if (reader.table().contains("theta_deg"))
    throw reader.mistake("theta_deg", "theta is the joint's own angle; expected offset_deg for what is added to it");
  reader.refuse_unknown_keys();
  const bool slides = one.link.joint == Joint::slides;
  const char* const key = slides ? "limits_m" : "limits_deg";
  const toml::node* const limits = reader.table().get(key);
  if (slides && limits == nullptr)
    throw reader.mistake(key, "a prismatic joint has no limits_m; expected them, such as limits_m = [0, 0.5]");
  const auto [largest, unit] = slides ? std::pair(lengths.second, 1.0) : std::pair(angles_deg.second, degree);
  if (is_endless) return one;
  if (!(one.limits[0] < one.limits[1]) || !(one.limits.cwiseAbs().maxCoeff() <= largest * unit))
    reader.fail(key, *limits, fmt::format("the lower limit and then the upper, within +-{}", largest));
  return one;
}

Frame read_frame(TomlReader& reader, const std::string& key, Bounds lengths) {
  Frame frame;
  TomlReader frame_reader = reader.part(key);
  list_fields(frame_reader, frame);
  frame_reader.refuse_unknown_keys();
  if (!(frame.position.cwiseAbs().maxCoeff() <= lengths.second))
    frame_reader.fail("position_m", *frame_reader.find("position_m"),
                      fmt::format("lengths within +-{}", lengths.second));
  return frame;
}

enum class Table { standard, modified };

// Turns Craig's modified table into a standard one: a row of Craig's begins with the length and twist that end the
// previous row of a standard table.
void make_standard(std::vector<DhLink>& links, Frame& base) {
  base.position += base.pose().linear() * Eigen::Vector3d(links.front().a, 0, 0);
  base.rpy.x() += links.front().alpha;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const bool is_last = i + 1 == links.size();
    links[i].a = is_last ? 0 : links[i + 1].a;
    links[i].alpha = is_last ? 0 : links[i + 1].alpha;
  }
}

Robot read_robot(TomlReader reader, std::string name, Bounds lengths) {
  std::vector<DhLink> links;
  std::vector<double> lower, upper;
  double widest = 0;  // [rad]
  for (const toml::table* link :
       reader.tables("links", max_joints,
                     fmt::format("a list of 1 to {} links such as {{ d_m = 0.36, alpha_deg = -90 }}", max_joints))) {
    const LimitedLink one = read_link(reader.nested(*link, "links."), lengths);
    links.push_back(one.link);
    lower.push_back(one.limits[0]);
    upper.push_back(one.limits[1]);
    widest = std::max(widest, one.limits.cwiseAbs().maxCoeff());
  }
  const bool all_turn = std::ranges::count(links, Joint::turns, &DhLink::joint) == std::ssize(links);
  if (all_turn && links.size() > 2 && widest <= 360 * degree * degree)  // a turn in radians, taken for degrees
    throw reader.mistake("links", fmt::format("no joint may turn further than {:g} deg; if these are radians, write "
                                              "degrees",
                                              widest / degree));
  Frame base = read_frame(reader, "base", lengths);
  const Frame tool = read_frame(reader, "tool", lengths);
  Table table = Table::standard;
  reader.choice("dh", table, {"standard", "modified"});
  if (table == Table::modified) {
    if (std::ranges::count(links, Joint::coupled, &DhLink::joint) > 0)
      throw reader.mistake("dh", "a modified table has no coupled joints; expected dh = \"standard\"");
    if (std::ranges::count(links, 0.0, &DhLink::beta) < std::ssize(links))
      throw reader.mistake("dh", "a modified table has no beta_deg; expected dh = \"standard\"");
    make_standard(links, base);
  }
  const auto joints = std::ssize(links);
  JointLimits limits{Configuration::Map(lower.data(), joints), Configuration::Map(upper.data(), joints)};
  Robot arm{std::move(name), "", "", Chain(std::move(links), base, tool), std::move(limits)};
  list_fields(reader, arm);
  if (const auto n = arm.velocity.size(); n > 0 && (n != arm.joints() || !(arm.velocity.minCoeff() >= 0)))
    reader.fail("velocity_deg_s", *reader.find("velocity_deg_s"),
                fmt::format("{}, one for each joint, 0 where it is not known", counted(arm.joints(), "values")));
  for (Eigen::Index j = 0; j < arm.velocity.size(); ++j) arm.velocity[j] *= arm.chain.slides(j) ? 1 : degree;
  reader.refuse_unknown_keys();
  return arm;
}

}  // namespace

double JointLimits::violation(const ConfigurationRef& q) const {
  return std::max({0.0, (lower - q).maxCoeff(), (q - upper).maxCoeff()});
}

JointLimits JointLimits::around(const ConfigurationRef& middle, double each_way) const {
  JointLimits range = *this;
  for (Eigen::Index j = 0; j < lower.size(); ++j) {
    if (!is_endless(lower[j], upper[j])) continue;
    range.lower[j] = middle[j] - each_way;
    range.upper[j] = middle[j] + each_way;
  }
  return range;
}

std::vector<Robot> all_robots() {
  std::vector<Robot> all;
  for (const EmbeddedFile& file : arm_files) all.push_back(parse_robot(file.text, file.name));
  return all;
}

std::string size_of(const Robot& arm) {
  Pose tool = Pose::Identity();  // behind the last joint
  for (const DescribedJoint& joint : arm.description)
    tool = joint.motion == DescribedJoint::Motion::none ? tool * joint.origin.pose() : Pose::Identity();
  const double reach = arm.chain.reach().radius, offset = tool.translation().norm();
  return fmt::format("{}{}{}{}", counted(arm.joints(), "joints"),
                     std::isfinite(reach) ? fmt::format(", reach {:.3g} m", reach) : "",
                     offset > 0 ? fmt::format(", tool {:.3g} m from the last joint", offset) : "",
                     arm.other_tip.empty() ? "" : fmt::format("; for another end: --tip {}", arm.other_tip));
}

std::vector<std::string> doubts_of(const Robot& arm) {
  std::vector<std::string> doubts;
  const double reach = arm.chain.reach().radius;
  if (std::isfinite(reach) && (reach > 10 || reach < 0.05))
    doubts.push_back(fmt::format("the arm reaches {:.3g} m; are all its lengths in metres?", reach));
  if (arm.velocity.size() > 0 && arm.velocity.maxCoeff() > 100)
    doubts.push_back(
        fmt::format("a joint's velocity is {:g} rad/s (or m/s); is it in degrees?", arm.velocity.maxCoeff()));
  return doubts;
}

Robot robot(std::string_view name) {
  if (const EmbeddedFile* const file = find_embedded(arm_files, name)) return parse_robot(file->text, file->name);
  std::vector<std::string> names;
  for (const EmbeddedFile& file : arm_files) names.emplace_back(file.stem());
  throw std::invalid_argument(unknown_name("robot", name, names) + "; or give a file that ends in .urdf or .toml");
}

bool is_arm_file(std::string_view name) { return name.ends_with(".toml") || is_urdf_file(name); }

Robot parse_robot(std::string_view text, const std::filesystem::path& file) {
  const toml::table table = parse_toml(text, file.string());
  std::string name = file.stem().string();
  if (name.empty() || !is_plain(name))
    throw std::invalid_argument(
        fmt::format("{}: the arm has the name of its file; expected {}", file.string(), plain_text));
  return read_robot(TomlReader(table, file.string(), ""), std::move(name), lengths_m);
}

Robot load_robot(const std::filesystem::path& file, const UrdfChoice& choice) {
  const std::string text = text_of_arm_file(file);
  return is_urdf_file(file.string()) ? parse_urdf(text, file, choice) : parse_robot(text, file);
}

std::string text_of_arm_file(const std::filesystem::path& file) {
  constexpr std::uintmax_t largest = 16'000'000;
  return text_of_file(file, largest);
}

std::optional<Robot> stored_arm(std::string_view json) {
  try {
    Json arm = parsed_json(json);
    for (const char* key : {"notes", "base_link", "tip_link"}) arm.erase(key);
    if (arm.at("links").size() > max_joints) return std::nullopt;
    for (Json& link : arm.at("links")) link.erase("name");
    const toml::table table = toml_of(arm);
    return read_robot(TomlReader(table, "stored arm", ""), "stored", stored_lengths_m);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

}  // namespace ikbench::robots
