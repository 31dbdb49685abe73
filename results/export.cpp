#include "results/export.hpp"

#include <algorithm>
#include <type_traits>

namespace ikbench::results {

#define EXPORT_TEXT(name, meaning) void name##_text(const Exported&, const Write&);
#define EXPORT_FOLDER(name, meaning) \
  std::vector<std::string> write_##name(const Exported&, const std::filesystem::path&);
#include "results/export_formats.inc"
#undef EXPORT_TEXT
#undef EXPORT_FOLDER

namespace {

constexpr ExportFormat formats[]{
#define EXPORT_TEXT(name, meaning) {#name, meaning, name##_text, nullptr},
#define EXPORT_FOLDER(name, meaning) {#name, meaning, nullptr, write_##name},
#include "results/export_formats.inc"
#undef EXPORT_TEXT
#undef EXPORT_FOLDER
};

template <class Value>
constexpr std::string_view type_name() {
  if constexpr (std::is_enum_v<Value>) return "name";
  if constexpr (std::is_integral_v<Value>) return "integer";
  if constexpr (std::is_floating_point_v<Value>) return "number";
  if constexpr (std::is_same_v<Value, std::vector<double>>) return "list of numbers";
  return "text";
}

}  // namespace

std::span<const ExportFormat> export_formats() { return formats; }

const ExportFormat& export_format(std::string_view name) {
  return *std::ranges::find(formats, name, &ExportFormat::name);
}

std::vector<ColumnInfo> columns() {
  std::vector<ColumnInfo> list;
  for_each_column([&]<class Value>(std::string_view name, Value SolveRecord::*, std::string_view meaning) {
    list.push_back({name, type_name<Value>(), meaning});
  });
  return list;
}

bool is_uncounted(std::string_view column, const SolveRecord& record) {
  return column == "evaluations" && record.counted_by == CountedBy::nobody;
}

}  // namespace ikbench::results
