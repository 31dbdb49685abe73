// The fields of a study, one by one. A list of fields (study_fields.hpp, paths/) names each field once, with its range
// and its meaning. A class derived from Fields visits that list to read, write or compare studies.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "numerics/names.hpp"
#include "robots/robot.hpp"

namespace ikbench::experiments {

using numerics::Choices;

constexpr std::int64_t no_limit = std::numeric_limits<std::int64_t>::max();

// Says how a field enters the key of a series (series_key.hpp).
enum class InKey {
  by_name,  // "name value" if it is not the default: the usual case
  in_text,  // in the text of the first stores, directly or as part of the effective settings
  no        // never: the field decides no number
};

class Fields {
 public:
  struct Name {
    std::string_view key;
    std::string_view meaning;
  };

  virtual ~Fields() = default;

  void text(std::string_view key, std::string& field, std::string_view meaning, InKey in_key = InKey::by_name) {
    if (visits(in_key)) on_text({key, meaning}, field);
  }

  void texts(std::string_view key, std::vector<std::string>& field, std::string_view meaning) {
    if (visits(InKey::by_name)) on_texts({key, meaning}, field);
  }

  template <class Enum>
  void choice(std::string_view key, Enum& field, const Choices<Enum>& choices, std::string_view meaning,
              InKey in_key = InKey::by_name) {
    if (!visits(in_key)) return;
    std::vector<std::string> names;
    std::size_t chosen = 0;
    for (const auto& [name, value] : choices) {
      if (value == field) chosen = names.size();
      names.push_back(name);
    }
    on_choice({key, meaning}, chosen, names);
    field = choices[chosen].second;
  }

  template <class Whole>
  void whole(std::string_view key, Whole& field, std::pair<std::int64_t, std::int64_t> range, std::string_view meaning,
             InKey in_key = InKey::by_name) {
    if (!visits(in_key)) return;
    auto value = static_cast<std::int64_t>(field);
    on_whole({key, meaning}, value, range);
    field = static_cast<Whole>(value);
  }

  // `range` is in units.
  void number(std::string_view key, double& field, double unit, std::pair<double, double> range,
              std::string_view meaning, InKey in_key = InKey::by_name) {
    if (visits(in_key)) on_number({key, meaning}, field, unit, range);
  }

  // `size` 0 allows any number of values.
  template <class Vector>
  void numbers(std::string_view key, Vector& field, double unit, int size, std::string_view meaning,
               InKey in_key = InKey::by_name) {
    if (!visits(in_key)) return;
    Eigen::VectorXd values = field;
    on_numbers({key, meaning}, values, unit, size);
    field = values;
  }

  void poses(std::string_view key, std::vector<robots::Pose>& field, std::string_view meaning) {
    if (visits(InKey::by_name)) on_poses({key, meaning}, field);
  }

 private:
  // Says whether to visit fields with this mark.
  virtual bool visits(InKey) const { return true; }

  virtual void on_text(Name name, std::string& field) = 0;
  virtual void on_texts(Name name, std::vector<std::string>& field) = 0;
  virtual void on_choice(Name name, std::size_t& chosen, const std::vector<std::string>& choices) = 0;
  virtual void on_whole(Name name, std::int64_t& field, std::pair<std::int64_t, std::int64_t> range) = 0;
  virtual void on_number(Name name, double& field, double unit, std::pair<double, double> range) = 0;
  virtual void on_numbers(Name name, Eigen::VectorXd& field, double unit, int size) = 0;
  virtual void on_poses(Name name, std::vector<robots::Pose>& field) = 0;
};

}  // namespace ikbench::experiments
