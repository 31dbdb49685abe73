#include "analysis/report/page_data.hpp"

#include <algorithm>

#include "analysis/inference/text.hpp"
#include "numerics/embedded_file.hpp"

namespace ikbench::report {

namespace {

constexpr numerics::EmbeddedFile templates[]{
#include "templates.inc"
};

}  // namespace

std::string_view template_named(std::string_view name) {
  return std::ranges::find(templates, name, &numerics::EmbeddedFile::name)->text;
}

kainjow::mustache::data page_data(const Json& json) {
  using Data = kainjow::mustache::data;
  if (json.is_string() && !json.get_ref<const std::string&>().empty())
    return Data(inference::one_line(json.get<std::string>()));
  if (json.is_array()) {
    Data list(Data::type::list);
    for (const Json& item : json) list.push_back(page_data(item));
    return list;
  }
  if (!json.is_object()) return Data(json.is_boolean() && json.get<bool>());
  Data object;
  for (const auto& [key, value] : json.items()) {
    object.set(key, page_data(value));
    if (value.is_array()) object.set("has_" + key, Data(!value.empty()));
  }
  return object;
}

std::string id_of(std::string_view name) {
  std::string id;
  for (const char c : name) {
    const bool is_safe = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-';
    id += is_safe ? c : '-';
  }
  return id;
}

}  // namespace ikbench::report
