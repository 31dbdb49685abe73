// Reads the fields of a study from a TOML table.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/fields.hpp"
#include "numerics/toml_table.hpp"

namespace ikbench::experiments {

// Sets the fields whose keys are given and leaves the others. Throws std::invalid_argument (numerics/toml_table.hpp).
class TableReader final : public Fields {
 public:
  explicit TableReader(numerics::TomlReader& table) : table_(table) {}

 private:
  void on_text(Name name, std::string& field) override;
  void on_texts(Name name, std::vector<std::string>& field) override;
  void on_choice(Name name, std::size_t& chosen, const std::vector<std::string>& choices) override;
  void on_whole(Name name, std::int64_t& field, std::pair<std::int64_t, std::int64_t> range) override;
  void on_number(Name name, double& field, double unit, std::pair<double, double> range) override;
  void on_numbers(Name name, Eigen::VectorXd& field, double unit, int size) override;
  void on_poses(Name name, std::vector<robots::Pose>& field) override;
  robots::Pose read_pose(std::string_view key, const toml::node& node, std::string_view expected) const;

  numerics::TomlReader& table_;
};

// An exception about the value of a key, or about its absence if `node` is null.
std::invalid_argument mistake(const numerics::TomlReader& reader, const toml::node* node, std::string_view key,
                              std::string_view message);

}  // namespace ikbench::experiments
