#include "results/same_solves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "numerics/json.hpp"

namespace ikbench::results {

namespace {

// Keys of the series that ikbench solved.
std::vector<std::string> own_keys(const StudyEntry& study) {
  std::vector<std::string> keys;
  for (const Series& series : study.series) {
    if (!is_imported(series)) keys.push_back(series.key);
  }
  return keys;
}

std::vector<std::string> own_configurations(const StudyEntry& study) {
  std::vector<std::string> keys = own_keys(study);
  for (std::string& key : keys) key = configuration_of(key);
  return keys;
}

int runs_of(const StudyEntry& study) { return numerics::parsed_json(study.definition).at("runs").get<int>(); }

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
    if (key == "runs" || std::ranges::find(decide_no_solve, key) != decide_no_solve.end()) continue;
    if (left.contains(key) && right.contains(key) && left[key] == right[key]) continue;
    const std::string one = text_of(left, key), two = text_of(right, key);
    return one == two ? fmt::format("{} is another", key) : fmt::format("{} is {} and {}", key, one, two);
  }
  return "";
}

std::string why_not_one(const StudyEntry& study, const StudyEntry& other) {
  const std::string difference = difference_in_solves(study.definition, other.definition);
  if (!difference.empty()) return difference;
  if (own_configurations(study) != own_configurations(other)) return "its solvers or their options are others";
  if (own_keys(study) != own_keys(other))
    return "the version of the solvers or of shared code is another, so use one version of ikbench for all";
  for (const Series& series : study.series) {
    const auto other_label = std::ranges::find(other.series, series.key, &Series::key);
    if (other_label != other.series.end() && other_label->label != series.label)
      return fmt::format("one solver has the label '{}' in the first and '{}' in the second", series.label,
                         other_label->label);
    const auto same = std::ranges::find(other.series, series.label, &Series::label);
    if (same != other.series.end() && same->key != series.key)
      return fmt::format("they are two imports of the label '{}', so import one of them with another --label",
                         series.label);
  }
  return "";
}

StudyEntry joined(const StudyEntry& study, const StudyEntry& other) {
  const bool is_larger = runs_of(other) > runs_of(study);
  StudyEntry both = is_larger ? other : study;
  for (const Series& series : (is_larger ? study : other).series) {
    const bool is_there = std::ranges::find(both.series, series.key, &Series::key) != both.series.end();
    if (is_imported(series) && !is_there) both.series.push_back(series);
  }
  return both;
}

}  // namespace ikbench::results
