// The fields of settings, one by one. A function list_fields(io, settings) names each field of a struct once, with its
// range and its meaning. A class derived from Fields visits that list to read or write the fields: TOML, JSON, the
// command line, help texts and the key of a series. So a new setting is one member and one line.
#pragma once

#include <algorithm>
#include <any>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ikbench::base {

constexpr std::int64_t no_limit = std::numeric_limits<std::int64_t>::max();

// How a field of a study contributes to the key of a series (experiments/study/series_key.hpp). A change of this, or of
// a name, makes stored solves obsolete.
enum class InKey {
  by_name,  // as "name value", unless it has its default: the usual case
  in_text,  // always: configuration_key writes the field, or the settings that follow from it
  no        // never: the field decides no number of a solve
};

// The meaning of a field, and how the field enters the key of a series. Made of a text.
struct FieldInfo {
  FieldInfo() = default;
  template <std::convertible_to<std::string_view> Text>
  FieldInfo(const Text& text, InKey how = InKey::by_name) : meaning(text), in_key(how) {}

  std::string_view meaning;
  InKey in_key = InKey::by_name;
};

// A visitor of fields. The public functions take a field of any type; a derived class implements the private ones.
class Fields {
 public:
  struct Name {
    std::string_view key, meaning;
    InKey in_key;
  };

  virtual ~Fields() = default;

  void text(std::string_view key, std::string& field, const FieldInfo& info = {}) {
    on_text({key, info.meaning, info.in_key}, field);
  }

  void texts(std::string_view key, std::vector<std::string>& field, const FieldInfo& info = {}) {
    on_texts({key, info.meaning, info.in_key}, field);
  }

  // A field with the value of an enum. `choices` are the names of its values, in their order.
  template <class Enum, class Names = std::initializer_list<std::string_view>>
  void choice(std::string_view key, Enum& field, const Names& choices, const FieldInfo& info = {}) {
    auto chosen = static_cast<std::size_t>(field);
    on_choice({key, info.meaning, info.in_key}, chosen, std::vector<std::string>(choices.begin(), choices.end()));
    field = static_cast<Enum>(chosen);
  }

  // A field with a whole number; `range` has the smallest and the largest value.
  template <class Whole>
  void whole(std::string_view key, Whole& field, std::pair<std::int64_t, std::int64_t> range,
             const FieldInfo& info = {}) {
    auto value = static_cast<std::int64_t>(field);
    on_whole({key, info.meaning, info.in_key}, value, range);
    field = static_cast<Whole>(value);
  }

  // A field with a number in metres, radians or seconds. `unit` is the unit of its text, such as 0.01 for cm, in which
  // `range` is given.
  void number(std::string_view key, double& field, double unit, std::pair<double, double> range,
              const FieldInfo& info = {}) {
    on_number({key, info.meaning, info.in_key}, field, unit, range);
  }

  // A field with a list of numbers; `size` 0 allows any number of values.
  template <class Vector>
  void numbers(std::string_view key, Vector& field, double unit, int size, const FieldInfo& info = {}) {
    std::vector<double> values(field.begin(), field.end());
    on_numbers({key, info.meaning, info.in_key}, values, unit, size);
    field.resize(static_cast<decltype(field.size())>(values.size()));
    std::ranges::copy(values, field.begin());
  }

  // A field with a list of poses, Eigen::Isometry3d. Lists without poses do not include Eigen.
  template <class Pose>
  void poses(std::string_view key, std::vector<Pose>& field) {
    on_poses({key, "", InKey::by_name}, &field);
  }

 private:
  virtual void on_text(Name name, std::string& field) = 0;
  virtual void on_texts(Name name, std::vector<std::string>& field) = 0;
  virtual void on_choice(Name name, std::size_t& chosen, const std::vector<std::string>& choices) = 0;
  virtual void on_whole(Name name, std::int64_t& field, std::pair<std::int64_t, std::int64_t> range) = 0;
  virtual void on_number(Name name, double& field, double unit, std::pair<double, double> range) = 0;
  virtual void on_numbers(Name name, std::vector<double>& field, double unit, int size) = 0;
  virtual void on_poses(Name, const std::any&) {}  // holds std::vector<Pose>*
};

}  // namespace ikbench::base
