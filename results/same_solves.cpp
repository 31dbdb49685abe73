#include "results/same_solves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

namespace ikbench::results {

std::string difference_in_solves(const std::string& definition, const std::string& other) {
  const auto left = nlohmann::json::parse(definition, nullptr, false);
  const auto right = nlohmann::json::parse(other, nullptr, false);
  if (!left.is_object() || !right.is_object()) return left == right ? "" : "one definition cannot be read";
  const auto text_of = [](const nlohmann::json& json, const std::string& key) {
    constexpr std::size_t most = 60;
    return json.contains(key) ? json[key].dump().substr(0, most) : "not there";
  };
  std::set<std::string> keys;
  for (const auto* json : {&left, &right})
    for (const auto& [key, value] : json->items()) keys.insert(key);
  for (const std::string& key : keys) {
    if (key == "runs" || std::ranges::find(decide_no_solve, key) != decide_no_solve.end()) continue;
    if (left.contains(key) && right.contains(key) && left[key] == right[key]) continue;
    return fmt::format("{} is {} and {}", key, text_of(left, key), text_of(right, key));
  }
  return "";
}

}  // namespace ikbench::results
