#include "robots/robot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "numerics/embedded_file.hpp"
#include "numerics/json.hpp"
#include "numerics/names.hpp"
#include "numerics/toml_table.hpp"
#include "robots/arm_fields.hpp"
#include "robots/urdf.hpp"

namespace ikbench::robots {

using namespace numerics;

namespace {

constexpr EmbeddedFile arm_files[]{
#include "arms.inc"
};

Robot built_in(const EmbeddedFile& file) { return parse_robot(file.text, file.name); }

LimitedLink read_link(TomlReader reader) {
  LimitedLink one;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const bool is_endless = reader.table()["limits_deg"].value<std::string_view>() == no_limits;
  if (is_endless) one.limits = {-infinity, infinity};
  list_fields(reader, one);
  reader.refuse_unknown_keys();
  const bool slides = one.link.joint == Joint::slides;
  const char* const key = slides ? "limits_m" : "limits_deg";
  const toml::node* const limits = reader.table().get(key);
  if (slides && limits == nullptr)
    throw reader.mistake(key, "a joint that slides has no limits_m; expected them, such as limits_m = [0, 0.5]");
  const double largest = slides ? lengths_m.second : angles_deg.second * degree;
  if (is_endless) return one;
  if (!(one.limits[0] < one.limits[1]) || !(one.limits.cwiseAbs().maxCoeff() <= largest)) {
    reader.fail(
        key, *limits,
        fmt::format("the lower limit and then the upper, within +-{}", slides ? lengths_m.second : angles_deg.second));
  }
  return one;
}

std::vector<LimitedLink> read_links(TomlReader& reader) {
  std::vector<LimitedLink> links;
  for (const toml::table* link :
       reader.tables("links", most_joints,
                     fmt::format("a list of 1 to {} links such as {{ d_m = 0.36, alpha_deg = -90 }}", most_joints)))
    links.push_back(read_link(reader.nested(*link, "links.")));
  return links;
}

Frame read_frame(TomlReader& reader, const std::string& key) {
  Frame frame;
  const toml::table* const table = reader.subtable(key);
  if (table == nullptr) return frame;
  TomlReader frame_reader = reader.nested(*table, key + ".");
  list_fields(frame_reader, frame);
  frame_reader.refuse_unknown_keys();
  if (!(frame.position.cwiseAbs().maxCoeff() <= lengths_m.second)) {
    frame_reader.fail("position_m", *table->get("position_m"), fmt::format("lengths within +-{}", lengths_m.second));
  }
  return frame;
}

void refuse_name(const std::filesystem::path& file) {
  if (file.stem().empty() || !TomlReader::is_plain(file.stem().string())) {
    throw std::invalid_argument(
        fmt::format("{}: the arm has the name of its file; expected {}", file.string(), TomlReader::plain));
  }
}

Robot read_robot(TomlReader reader, std::string name) {
  const std::vector<LimitedLink> links = read_links(reader);
  std::vector<DhLink> chain;
  JointLimits limits;
  limits.lower.resize(static_cast<Eigen::Index>(links.size()));
  limits.upper.resize(limits.lower.size());
  for (const LimitedLink& one : links) {
    const auto joint = static_cast<Eigen::Index>(chain.size());
    limits.lower[joint] = one.limits[0];
    limits.upper[joint] = one.limits[1];
    chain.push_back(one.link);
  }
  const Frame base = read_frame(reader, "base"), tool = read_frame(reader, "tool");
  Robot arm{std::move(name), "", "", Chain(std::move(chain), base, tool), std::move(limits)};
  list_fields(reader, arm);
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
  for (const EmbeddedFile& file : arm_files) all.push_back(built_in(file));
  return all;
}

Robot robot(std::string_view name) {
  if (const EmbeddedFile* const file = find_embedded(arm_files, name)) return built_in(*file);
  std::vector<std::string> names;
  for (const EmbeddedFile& file : arm_files) names.emplace_back(file.stem());
  std::error_code error;
  if (name.find_first_of("./") != std::string_view::npos || std::filesystem::exists(name, error)) {
    throw std::invalid_argument(fmt::format(
        "\"{}\" is no arm{}; expected a file that ends in .urdf or .toml (a mesh has no joints), or a name of: ikbench "
        "list robots",
        front(name, 100), did_you_mean(name, names)));
  }
  throw std::invalid_argument(unknown_name("robot", name, names));
}

bool is_arm_file(std::string_view name) { return name.ends_with(".toml") || is_urdf_file(name); }

Robot parse_robot(std::string_view text, const std::filesystem::path& file) {
  const toml::table table = parse_toml(text, file.string());
  Robot arm = read_robot(TomlReader(table, file.string(), ""), file.stem().string());
  refuse_name(file);
  return arm;
}

Robot load_robot(const std::filesystem::path& file) { return load_robot(file, UrdfChoice{}); }

Robot load_robot(const std::filesystem::path& file, const UrdfChoice& choice) {
  const std::string text = text_of_arm_file(file);
  return is_urdf_file(file.string()) ? parse_urdf(text, file, choice) : parse_robot(text, file);
}

std::string text_of_arm_file(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) {
    throw std::invalid_argument(fmt::format("{} is a folder; expected the .urdf or .toml file in it", file.string()));
  }
  if (!std::filesystem::is_regular_file(file, error)) {
    throw std::invalid_argument(fmt::format("there is no file {}", file.string()));
  }
  constexpr std::uintmax_t largest_urdf = 16'000'000;
  return is_urdf_file(file.string()) ? text_of_file(file, largest_urdf) : text_of_file(file);
}

std::optional<Robot> stored_arm(Json arm) {
  try {
    for (const char* told : {"notes", "base_link", "tip_link"}) arm.erase(told);
    for (Json& link : arm.at("links")) link.erase("name");
    const toml::table table = toml_of(arm);
    return read_robot(TomlReader(table, "stored arm", ""), "stored");
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

}  // namespace ikbench::robots
