// JSON: one object with note, columns, study, definition, series, sessions and solves. null stands for NaN and
// infinities, which JSON does not have.
#include "numerics/json.hpp"

#include <fmt/core.h>

#include <type_traits>
#include <utility>

#include "results/export.hpp"

namespace ikbench::results {

using namespace numerics;

namespace {

// The solve as an object with a member a column; null stands for a number that is not finite, or that nobody counted.
OrderedJson json_of(const SolveRecord& record) {
  OrderedJson object = OrderedJson::object();
  for_each_column([&]<class Value>(std::string_view name, Value SolveRecord::*member, std::string_view) {
    if constexpr (std::is_enum_v<Value>)
      object[std::string(name)] = name_of(record.*member);
    else if (is_uncounted(name, record))
      object[std::string(name)] = nullptr;
    else
      object[std::string(name)] = record.*member;
  });
  return object;
}

}  // namespace

void json_text(const Exported& exported, const Write& write) {
  OrderedJson head;
  head["note"] = "null stands for a number that is not finite";
  head["columns"] = OrderedJson::array();
  for (const ColumnInfo& column : columns())
    head["columns"].push_back({{"name", column.name}, {"type", column.type}, {"meaning", column.meaning}});
  head["study"] = exported.study.name;
  head["definition"] = parsed_ordered_json(exported.study.definition);
  head["series"] = OrderedJson::array();
  for (const Series& series : exported.study.series)
    head["series"].push_back({{"key", series.key},
                              {"label", series.label},
                              {"algorithm", series.algorithm},
                              {"options", parsed_ordered_json(series.options)}});
  head["sessions"] = OrderedJson::array();
  for (const Session& session : exported.sessions)
    head["sessions"].push_back({{"id", session.id}, {"environment", session.environment}});

  // Solves follow one by one, so that only one is an object at a time.
  std::string text = text_of(head);
  text.pop_back();
  write(text + ",\"solves\":[");
  std::string_view between = "\n";
  exported.each_solve([&](const SolveRecord& record) {
    write(fmt::format("{}{}", std::exchange(between, ",\n"), text_of(json_of(record))));
  });
  write("]}\n");
}

}  // namespace ikbench::results
