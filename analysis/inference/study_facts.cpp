#include "analysis/inference/study_facts.hpp"

#include <algorithm>
#include <utility>

#include "numerics/json.hpp"

namespace ikbench::inference {

namespace {

using Json = nlohmann::json;

const Json* find(const Json& object, const std::string& key) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  return found == object.end() ? nullptr : &*found;
}

Json part(const Json& object, const std::string& key) {
  const Json* const found = find(object, key);
  return found != nullptr ? *found : Json();
}

std::string text(const Json& object, const std::string& key) {
  const Json* const found = find(object, key);
  return found != nullptr && found->is_string() ? found->get<std::string>() : std::string();
}

double number(const Json& object, const std::string& key) {
  const Json* const found = find(object, key);
  return found != nullptr && found->is_number() ? found->get<double>() : not_defined;
}

std::set<std::size_t> slides_of(const Json& arm) {
  std::set<std::size_t> slides;
  const Json links = part(arm, "links");
  for (std::size_t joint = 0; links.is_array() && joint < links.size(); ++joint) {
    if (text(links[joint], "joint") == "slides") slides.insert(joint);
  }
  return slides;
}

StudyFacts::Stop stop_of(const Json& stop) {
  return {.tolerance_cm = number(stop, "tolerance_cm"),
          .tolerance_deg = number(stop, "tolerance_deg"),
          .iterations = number(stop, "iterations"),
          .evaluations = number(stop, "evaluations"),
          .seconds = number(stop, "seconds")};
}

StudyFacts::OutOfReach out_of_reach_of(const Json& targets) {
  return {.points = number(targets, "points"),
          .farthest_point = number(targets, "farthest_point"),
          .farthest_cm = number(targets, "farthest_cm"),
          .reach_cm = number(targets, "reach_cm")};
}

std::vector<std::string> texts(const Json& list) {
  std::vector<std::string> result;
  for (const Json& each : list.is_array() ? list : Json::array()) {
    if (each.is_string()) result.push_back(each.get<std::string>());
  }
  return result;
}

}  // namespace

StudyFacts facts_of(std::string definition) {
  const Json all = numerics::parsed_json(definition);
  return facts_of(all, std::move(definition));
}

StudyFacts facts_of(const Json& all, std::string definition) {
  const std::string search = text(all, "search");
  const Json path = part(all, "path"), arm = part(all, "arm");
  return {.json = std::move(definition),
          .title = text(all, "title"),
          .published = text(all, "published"),
          .robot = text(all, "robot"),
          .start = text(all, "start"),
          .departures = texts(part(all, "departures")),
          .missing_solvers = texts(part(all, "missing_solvers")),
          .enforces_limits = text(all, "limits") == "enforced",
          .draws_targets = text(path, "targets") == "drawn" || text(path, "kind") == "random",
          .orientation = search != "all_joints",
          .pose = search == "pose",
          .wrist = search == "wrist",
          .slides = slides_of(arm),
          .seed = number(all, "seed"),
          .repeats = number(all, "repeats"),
          .perturbed = number(all, "perturbed"),
          .deadline_ms = number(all, "deadline_ms"),
          .stop = stop_of(part(all, "stop")),
          .path = text(path, "kind"),
          .out_of_reach = out_of_reach_of(part(all, "out_of_reach")),
          .arm = arm};
}

std::string text_option(std::string_view options, const std::string& name) {
  return text(numerics::parsed_json(options), name);
}

}  // namespace ikbench::inference
