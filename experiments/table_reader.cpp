#include "experiments/table_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "experiments/orientation.hpp"
#include "numerics/names.hpp"
#include "numerics/units.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace robots;

namespace {

std::string shown(const toml::node& node) {
  std::ostringstream out;
  out << toml::toml_formatter(node, toml::format_flags::none);
  std::string text = out.str();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text.size() <= 80 ? text : text.substr(0, 77) + "...";
}

std::optional<double> as_number(const toml::node& node) {
  const std::optional<double> value = node.is_number() ? node.value<double>() : std::nullopt;
  return value && std::isfinite(*value) ? value : std::nullopt;
}

}  // namespace

const toml::node* TableReader::find(std::string_view key) {
  if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.emplace_back(key);
  return table_.get(key);
}

const toml::table* TableReader::subtable(std::string_view key) {
  const toml::node* node = find(key);
  if (node != nullptr && !node->is_table()) fail(key, *node, fmt::format("a table: [{}]", key));
  return node == nullptr ? nullptr : node->as_table();
}

void TableReader::refuse_unknown_keys() const {
  for (const auto& [key, node] : table_) {
    if (std::find(known_.begin(), known_.end(), key.str()) == known_.end()) {
      throw std::invalid_argument(where(key.source(), key.str()) + unknown_name("key", key.str(), known_));
    }
  }
}

void TableReader::fail(std::string_view key, const toml::node& node, std::string_view expected) const {
  throw std::invalid_argument(
      fmt::format("{}{}{} is {}; expected {}", where(node.source(), key), prefix_, key, shown(node), expected));
}

std::string TableReader::where(const toml::source_region& region, std::string_view key) const {
  if (region.begin.line == 0 || region.path) return fmt::format("--set {}{}: ", prefix_, key);
  return fmt::format("{}:{}:{}: ", source_, region.begin.line, region.begin.column);
}

bool TableReader::is_plain(std::string_view text) {
  const auto is_control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
  return text.size() <= 200 && std::none_of(text.begin(), text.end(), is_control);
}

void TableReader::on_text(Name name, std::string& field) {
  const toml::node* node = find(name.key);
  if (node == nullptr) return;
  const toml::value<std::string>* value = node->as_string();
  if (value == nullptr) fail(name.key, *node, "a text in quotes");
  if (!is_plain(value->get())) fail(name.key, *node, plain);
  field = value->get();
}

void TableReader::on_choice(Name name, std::size_t& chosen, const std::vector<std::string>& choices) {
  const toml::node* node = find(name.key);
  if (node == nullptr) return;
  const std::optional<std::string> wanted = node->value<std::string>();
  const auto found = wanted ? std::ranges::find(choices, *wanted) : choices.end();
  if (found == choices.end()) fail(name.key, *node, fmt::format("one of \"{}\"", fmt::join(choices, "\", \"")));
  chosen = static_cast<std::size_t>(found - choices.begin());
}

void TableReader::on_whole(Name name, std::int64_t& field, std::pair<std::int64_t, std::int64_t> range) {
  const toml::node* node = find(name.key);
  if (node == nullptr) return;
  const toml::value<std::int64_t>* value = node->as_integer();
  if (value == nullptr || value->get() < range.first || value->get() > range.second) {
    fail(name.key, *node, fmt::format("a whole number from {} to {}", range.first, range.second));
  }
  field = value->get();
}

void TableReader::on_number(Name name, double& field, double unit, std::pair<double, double> range) {
  const toml::node* node = find(name.key);
  if (node == nullptr) return;
  const std::optional<double> value = as_number(*node);
  if (!value || !(*value >= range.first && *value <= range.second)) {
    fail(name.key, *node, fmt::format("a number from {} to {}", range.first, range.second));
  }
  field = *value * unit;
}

void TableReader::on_numbers(Name name, Eigen::VectorXd& field, double unit, int size) {
  const toml::node* node = find(name.key);
  if (node == nullptr) return;
  const toml::array* array = node->as_array();
  const std::string expected = size == 0 ? "a list of numbers" : fmt::format("a list of {} numbers", size);
  if (array == nullptr || (size != 0 && array->size() != static_cast<std::size_t>(size))) {
    fail(name.key, *node, expected);
  }
  field.resize(static_cast<Eigen::Index>(array->size()));
  Eigen::Index index = 0;
  for (const toml::node& element : *array) {
    const std::optional<double> value = as_number(element);
    if (!value || !(std::abs(*value) <= 1e6)) fail(name.key, element, expected + " within +-1e6");
    field[index++] = *value * unit;
  }
}

// A study without them is no study: this key has to be given.
void TableReader::on_poses(Name name, std::vector<Pose>& field) {
  const toml::node* node = find(name.key);
  const std::string expected =
      "a list of 1 to 100000 poses such as { position_cm = [60, 0, 35], rpy_deg = [180, 0, 180] }";
  if (node == nullptr) {
    throw std::invalid_argument(
        fmt::format("{}{}{} is missing; expected {}", where(table_.source(), name.key), prefix_, name.key, expected));
  }
  const toml::array* array = node->as_array();
  if (array == nullptr || array->empty() || array->size() > 100'000) fail(name.key, *node, expected);
  field.clear();
  for (const toml::node& element : *array) field.push_back(read_pose(name.key, element, expected));
}

Pose TableReader::read_pose(std::string_view key, const toml::node& node, std::string_view expected) const {
  const toml::table* const table = node.as_table();
  if (table == nullptr) fail(key, node, expected);
  if (table->contains("position_cm") == table->contains("position_m")) {
    fail(key, node, "a pose with either a position_cm or a position_m");
  }
  TableReader reader = nested(*table, fmt::format("{}{}.", prefix_, key));
  Eigen::Vector3d position = Eigen::Vector3d::Zero(), rpy = Eigen::Vector3d::Zero();
  reader.numbers("position_cm", position, centimetre, 3, "");
  reader.numbers("position_m", position, 1, 3, "");
  reader.numbers("rpy_deg", rpy, degree, 3, "");
  Eigen::VectorXd rotation(9);
  rotation << rotation_from_rpy(rpy).transpose().reshaped();
  reader.numbers("rotation", rotation, 1, 9, "");
  reader.refuse_unknown_keys();
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(rotation.data());
  if (!pose.linear().isUnitary(1e-9) || pose.linear().determinant() < 0) {
    reader.fail("rotation", node, "a rotation matrix, row by row");
  }
  pose.translation() = position;
  return pose;
}

}  // namespace ikbench::experiments
