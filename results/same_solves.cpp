#include "results/same_solves.hpp"

#include <fmt/core.h>

#include <set>

#include "numerics/json.hpp"

namespace ikbench::results {

namespace {

// Parts of a definition that may differ: how it is judged and drawn, which targets are out of reach, how often; and
// what follows from the rest.
const std::set<std::string> decide_no_solve{"analysis", "departures", "figures", "out_of_reach", "repeats", "runs"};

std::vector<std::string> keys_of(const StudyEntry& study) {
  std::vector<std::string> keys;
  for (const Series& series : study.series) keys.push_back(series.key);
  return keys;
}

std::vector<std::string> configurations_of(const StudyEntry& study) {
  std::vector<std::string> keys = keys_of(study);
  for (std::string& key : keys) key = configuration_of(key);
  return keys;
}

}  // namespace

std::string difference_in_solves(const std::string& definition, const std::string& other) {
  const auto left = numerics::parsed_json(definition);
  const auto right = numerics::parsed_json(other);
  if (!left.is_object() || !right.is_object()) return left == right ? "" : "one definition cannot be read";
  const auto text_of = [](const nlohmann::json& json, const std::string& key) {
    constexpr std::size_t most = 60;
    if (!json.contains(key)) return std::string("not there");
    const std::string text = numerics::text_of(json[key]);
    return text.size() <= most ? text : "another";
  };
  std::set<std::string> keys;
  for (const auto* json : {&left, &right})
    for (const auto& [key, value] : json->items()) keys.insert(key);
  for (const std::string& key : keys) {
    if (decide_no_solve.contains(key)) continue;
    if (left.contains(key) && right.contains(key) && left[key] == right[key]) continue;
    const std::string one = text_of(left, key), two = text_of(right, key);
    return one == two ? fmt::format("{} is another", key) : fmt::format("{} is {} and {}", key, one, two);
  }
  return "";
}

std::string why_not_one(const StudyEntry& study, const StudyEntry& other) {
  const std::string difference = difference_in_solves(study.definition, other.definition);
  if (!difference.empty()) return difference;
  if (configurations_of(study) != configurations_of(other)) return "its solvers or their options are others";
  if (keys_of(study) != keys_of(other))
    return "the version of the solvers or of shared code is another, so use one version of ikbench for all";
  return "";
}

}  // namespace ikbench::results
