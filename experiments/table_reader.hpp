// Reads the fields of one TOML table: what is wrong is said with its place, its value and what was expected.
#pragma once

#include <toml++/toml.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/fields.hpp"

namespace ikbench::experiments {

// Fields whose keys are not given stay as they are; the others are set, or std::invalid_argument. It knows which keys
// there are once it was led along the fields. The table outlives it.
class TableReader final : public Fields {
 public:
  // `source`: the name of the file; `prefix`: of the keys in messages, "path.".
  TableReader(const toml::table& table, std::string_view source, std::string prefix)
      : table_(table), source_(source), prefix_(std::move(prefix)) {}

  // The value of a key, remembered as known; null where it is not given.
  const toml::node* find(std::string_view key);
  // The same of a table; another value is refused.
  const toml::table* subtable(std::string_view key);
  // To be called when all keys were asked for.
  void refuse_unknown_keys() const;
  [[noreturn]] void fail(std::string_view key, const toml::node& node, std::string_view expected) const;
  // "study.toml:3:8: ", or for what no file says "--set path.tool: ".
  std::string where(const toml::source_region& region, std::string_view key) const;

  // A text that may stand in a message, a table or a file's name: at most 200 bytes, no control characters.
  static bool is_plain(std::string_view text);
  static constexpr std::string_view plain = "a text of at most 200 bytes without control characters";

  TableReader nested(const toml::table& table, std::string prefix) const { return {table, source_, std::move(prefix)}; }
  const toml::table& table() const { return table_; }

 private:
  void on_text(Name name, std::string& field) override;
  void on_choice(Name name, std::size_t& chosen, const std::vector<std::string>& choices) override;
  void on_whole(Name name, std::int64_t& field, std::pair<std::int64_t, std::int64_t> range) override;
  void on_number(Name name, double& field, double unit, std::pair<double, double> range) override;
  void on_numbers(Name name, Eigen::VectorXd& field, double unit, int size) override;
  void on_poses(Name name, std::vector<robots::Pose>& field) override;
  robots::Pose read_pose(std::string_view key, const toml::node& node, std::string_view expected) const;

  const toml::table& table_;
  std::string source_;
  std::string prefix_;
  std::vector<std::string> known_;
};

}  // namespace ikbench::experiments
