#include "analysis/inference/definition.hpp"

#include <algorithm>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::inference {

using namespace statistics;

const nlohmann::json* Definition::find(const std::string& pointer) const {
  const nlohmann::json::json_pointer at(pointer);
  return json_.contains(at) ? &json_.at(at) : nullptr;
}

std::string Definition::text(const std::string& pointer) const {
  const nlohmann::json* const value = find(pointer);
  return value != nullptr && value->is_string() ? value->get<std::string>() : std::string();
}

double Definition::number(const std::string& pointer) const {
  const nlohmann::json* const value = find(pointer);
  return value != nullptr && value->is_number() ? value->get<double>() : not_defined;
}

std::vector<double> Definition::numbers(const std::string& pointer) const {
  const nlohmann::json* const value = find(pointer);
  const auto is_number = [](const nlohmann::json& element) { return element.is_number(); };
  const bool fits = value != nullptr && value->is_array() && std::ranges::all_of(*value, is_number);
  return fits ? value->get<std::vector<double>>() : std::vector<double>();
}

}  // namespace ikbench::inference
