// The fields of a struct as text and as JSON. Only the writer of studies (writer.cpp) and the keys of stored solves
// (series_key.cpp) include this file.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <any>
#include <string>
#include <utility>
#include <vector>

#include "base/fields.hpp"
#include "base/json.hpp"
#include "base/number.hpp"
#include "robots/robot.hpp"

namespace ikbench::experiments {

// Returns the values in a unit of files, such as 0.01 for cm.
template <class Values>
std::vector<double> in_units(const Values& values, double unit) {
  std::vector<double> result;
  for (const double value : values) result.push_back(base::in_unit(value, unit));
  return result;
}

// Returns the values as text that has every bit of them.
template <class Values>
std::string exact_text(const Values& values) {
  std::string text;
  for (const double value : values) text += fmt::format("{} ", value);
  return text;
}

// A field of a struct, as it is written.
struct WrittenField {
  std::string key;
  base::OrderedJson json;  // in the units of files; null for poses
  std::string text;        // with every bit, for the key of a series
  std::string meaning;     // of a choice with the names of its values
  base::InKey in_key = base::InKey::by_name;
  const std::vector<robots::Pose>* poses = nullptr;  // null for all fields but a list of poses
};
using WrittenFields = std::vector<WrittenField>;

// A visitor that writes the fields of a list.
class FieldWriter final : public base::Fields {
 public:
  WrittenFields fields;

 private:
  void on_text(Name name, std::string& field) override { add(name, field, field); }
  void on_texts(Name name, std::vector<std::string>& field) override {
    std::vector<std::string> words;
    for (const std::string& word : field) words.push_back(base::text_of(base::Json(word)));
    add(name, field, field.empty() ? "" : fmt::format("{} {}", field.size(), fmt::join(words, "\n")));
  }
  void on_choice(Name name, std::size_t& chosen, const std::vector<std::string>& choices) override {
    add(name, choices.at(chosen), choices.at(chosen), choices);
  }
  void on_whole(Name name, std::int64_t& field, std::pair<std::int64_t, std::int64_t>) override {
    add(name, field, fmt::format("{}", field));
  }
  void on_number(Name name, double& field, double unit, std::pair<double, double>) override {
    add(name, base::in_unit(field, unit), fmt::format("{}", field));
  }
  void on_numbers(Name name, std::vector<double>& field, double unit, int) override {
    add(name, in_units(field, unit), exact_text(field));
  }
  void on_poses(Name name, const std::any& field) override {
    add(name, {}, "");
    fields.back().poses = std::any_cast<std::vector<robots::Pose>*>(field);
  }

  void add(Name name, base::OrderedJson json, std::string text, const std::vector<std::string>& choices = {}) {
    const std::string names = choices.empty() ? "" : fmt::format("{}: ", fmt::join(choices, " | "));
    fields.push_back({.key = std::string(name.key),
                      .json = std::move(json),
                      .text = std::move(text),
                      .meaning = names + std::string(name.meaning),
                      .in_key = name.in_key});
  }
};

// Returns the fields of a struct. The result refers to its poses, so `fields` must outlive the result.
template <class Struct>
WrittenFields written_fields(Struct& fields) {
  FieldWriter writer;
  list_fields(writer, fields);
  return std::move(writer.fields);
}

}  // namespace ikbench::experiments
