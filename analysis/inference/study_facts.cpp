#include "analysis/inference/study_facts.hpp"

#include <utility>

#include "numerics/json.hpp"

namespace ikbench::inference {

namespace {

using Json = nlohmann::json;

// The value at a path of keys, such as "/stop/seconds"; null if there is none.
Json value_at(const Json& all, const std::string& path) {
  const Json::json_pointer pointer(path);
  return all.is_object() && all.contains(pointer) ? all.at(pointer) : Json();
}

std::string text_at(const Json& all, const std::string& path) {
  const Json value = value_at(all, path);
  return value.is_string() ? value.get<std::string>() : std::string();
}

double number_at(const Json& all, const std::string& path) {
  const Json value = value_at(all, path);
  return value.is_number() ? value.get<double>() : not_defined;
}

std::vector<std::string> texts_at(const Json& all, const std::string& path) {
  std::vector<std::string> texts;
  for (const Json& each : value_at(all, path)) {
    if (each.is_string()) texts.push_back(each.get<std::string>());
  }
  return texts;
}

std::set<std::size_t> slides_of(const Json& links) {
  std::set<std::size_t> slides;
  for (std::size_t joint = 0; links.is_array() && joint < links.size(); ++joint) {
    if (text_at(links[joint], "/joint") == "slides") slides.insert(joint);
  }
  return slides;
}

}  // namespace

StudyFacts facts_of(std::string definition) {
  const Json all = numerics::parsed_json(definition);
  return facts_of(all, std::move(definition));
}

StudyFacts facts_of(const Json& all, std::string definition) {
  const std::string search = text_at(all, "/search"), path = text_at(all, "/path/kind");
  return {.json = std::move(definition),
          .title = text_at(all, "/title"),
          .published = text_at(all, "/published"),
          .robot = text_at(all, "/robot"),
          .start = text_at(all, "/start"),
          .departures = texts_at(all, "/departures"),
          .missing_solvers = texts_at(all, "/missing_solvers"),
          .enforces_limits = text_at(all, "/limits") == "enforced",
          .draws_targets = text_at(all, "/path/targets") == "drawn" || path == "random",
          .orientation = search != "all_joints",
          .pose = search == "pose",
          .wrist = search == "wrist",
          .slides = slides_of(value_at(all, "/arm/links")),
          .seed = number_at(all, "/seed"),
          .deadline_ms = number_at(all, "/deadline_ms"),
          .stop = {.tolerance_cm = number_at(all, "/stop/tolerance_cm"),
                   .tolerance_deg = number_at(all, "/stop/tolerance_deg"),
                   .iterations = number_at(all, "/stop/iterations"),
                   .evaluations = number_at(all, "/stop/evaluations"),
                   .seconds = number_at(all, "/stop/seconds")},
          .path = path,
          .out_of_reach = {.points = number_at(all, "/out_of_reach/points"),
                           .farthest_point = number_at(all, "/out_of_reach/farthest_point"),
                           .farthest_cm = number_at(all, "/out_of_reach/farthest_cm"),
                           .reach_cm = number_at(all, "/out_of_reach/reach_cm")},
          .arm = value_at(all, "/arm")};
}

std::string text_option(std::string_view options, const std::string& name) {
  return text_at(numerics::parsed_json(options), "/" + name);
}

}  // namespace ikbench::inference
