#include "experiments/table_reader.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "numerics/units.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace robots;

void TableReader::on_text(Name name, std::string& field) { table_.text(name.key, field, name.meaning); }

void TableReader::on_texts(Name name, std::vector<std::string>& field) { table_.texts(name.key, field, name.meaning); }

void TableReader::on_choice(Name name, std::size_t& chosen, const std::vector<std::string>& choices) {
  Choices<std::size_t> numbered;
  for (const std::string& choice : choices) numbered.emplace_back(choice, numbered.size());
  table_.choice(name.key, chosen, numbered, name.meaning);
}

void TableReader::on_whole(Name name, std::int64_t& field, std::pair<std::int64_t, std::int64_t> range) {
  table_.whole(name.key, field, range, name.meaning);
}

void TableReader::on_number(Name name, double& field, double unit, std::pair<double, double> range) {
  table_.number(name.key, field, unit, range, name.meaning);
}

void TableReader::on_numbers(Name name, Eigen::VectorXd& field, double unit, int size) {
  table_.numbers(name.key, field, unit, size, name.meaning);
}

// This key is required: a study needs targets.
void TableReader::on_poses(Name name, std::vector<Pose>& field) {
  const toml::node* node = table_.find(name.key);
  const std::string expected =
      "a list of 1 to 100000 poses such as { position_cm = [60, 0, 35], rpy_deg = [180, 0, 180] }";
  if (node == nullptr) {
    throw std::invalid_argument(fmt::format("{}{}{} is missing; expected {}",
                                            table_.where(table_.table().source(), name.key), table_.prefix(), name.key,
                                            expected));
  }
  const toml::array* array = node->as_array();
  if (array == nullptr || array->empty() || array->size() > 100'000) table_.fail(name.key, *node, expected);
  field.clear();
  for (const toml::node& element : *array) field.push_back(read_pose(name.key, element, expected));
}

Pose TableReader::read_pose(std::string_view key, const toml::node& node, std::string_view expected) const {
  const toml::table* const table = node.as_table();
  if (table == nullptr) table_.fail(key, node, expected);
  if (table->contains("position_cm") == table->contains("position_m")) {
    table_.fail(key, node, "a pose with either a position_cm or a position_m");
  }
  TomlReader reader = table_.nested(*table, fmt::format("{}{}.", table_.prefix(), key));
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

std::invalid_argument mistake(const TomlReader& reader, const toml::node* node, std::string_view key,
                              std::string_view message) {
  return std::invalid_argument(reader.where(node == nullptr ? reader.table().source() : node->source(), key) +
                               std::string(message));
}

}  // namespace ikbench::experiments
