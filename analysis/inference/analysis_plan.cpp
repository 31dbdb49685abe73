#include "analysis/inference/analysis_plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "analysis/inference/text.hpp"
#include "numerics/json.hpp"
#include "results/analysis_plan_fields.hpp"

namespace ikbench::inference {

using namespace results;

namespace {

using Json = nlohmann::json;

// Visits the fields of a plan, and takes those that JSON says within their range.
class JsonReader {
 public:
  explicit JsonReader(const Json& object) : object_(object) {}

  void text(const char* key, std::string& field, std::string_view) {
    constexpr std::size_t longest = 200;  // bytes, as in study files
    const auto read = [&](const Json& value) {
      if (!value.is_string() || value.get<std::string>().size() > longest) return false;
      field = value.get<std::string>();
      return true;
    };
    take(key, read);
  }
  template <class Enum>
  void choice(const char* key, Enum& field, const std::vector<std::pair<std::string, Enum>>& choices,
              std::string_view) {
    take(key, [&](const Json& value) {
      const auto found = std::ranges::find_if(choices, [&](const auto& choice) { return value == choice.first; });
      if (found != choices.end()) field = found->second;
      return found != choices.end();
    });
  }
  template <class Enum>
  void chosen(const char* key, std::vector<Enum>& field, const std::vector<std::pair<std::string, Enum>>& choices,
              std::string_view) {
    take(key, [&](const Json& value) {
      std::vector<Enum> found;
      for (const auto& [name, choice] : choices) {
        const auto is_it = [&chosen = name](const Json& element) { return element == chosen; };
        if (value.is_array() && std::ranges::count_if(value, is_it) == 1) found.push_back(choice);
      }
      if (found.empty() || found.size() != value.size()) return false;
      field = std::move(found);
      return true;
    });
  }
  void whole(const char* key, int& field, std::pair<int, int> range, std::string_view) {
    take(key, [&](const Json& value) {
      if (!value.is_number_integer() || !is_within(value, range)) return false;
      field = value.get<int>();
      return true;
    });
  }
  void number(const char* key, double& field, double unit, std::pair<double, double> range, std::string_view) {
    take(key, [&](const Json& value) {
      if (!value.is_number() || !is_within(value, range)) return false;
      field = value.get<double>() * unit;
      return true;
    });
  }

  std::vector<std::string> unreadable;  // present fields with an invalid value: they keep the default

 private:
  // Reads a double: it holds numbers beyond every integer.
  template <class Number>
  static bool is_within(const Json& value, std::pair<Number, Number> range) {
    const auto number = value.get<double>();
    return number >= range.first && number <= range.second;
  }
  template <class Read>
  void take(const char* key, Read read) {
    const auto found = object_.find(key);
    if (found != object_.end() && !read(*found)) unreadable.emplace_back(key);
  }

  const Json& object_;
};

class Lister {
 public:
  void text(std::string_view key, const std::string& field, std::string_view meaning) {
    add(key, field.empty() ? "none" : fmt::format("\"{}\"", field), meaning);
  }
  template <class Enum>
  void choice(std::string_view key, const Enum& field, const std::vector<std::pair<std::string, Enum>>& choices,
              std::string_view meaning) {
    add(key, std::ranges::find(choices, field, &std::pair<std::string, Enum>::second)->first, meaning);
  }
  template <class Enum>
  void chosen(std::string_view key, const std::vector<Enum>& field, const std::vector<std::pair<std::string, Enum>>&,
              std::string_view meaning) {
    std::vector<std::string_view> names;
    for (const Enum value : field) names.push_back(name_of(value));
    add(key, fmt::format("{}", fmt::join(names, " + ")), meaning);
  }
  void whole(std::string_view key, int field, std::pair<int, int>, std::string_view meaning) {
    add(key, fmt::format("{}", field), meaning);
  }
  void number(std::string_view key, double field, double unit, std::pair<double, double>, std::string_view meaning) {
    add(key, fmt::format("{:.12g}", field / unit), meaning);
  }

  std::vector<std::array<std::string, 3>> values;

 private:
  void add(std::string_view key, std::string text, std::string_view meaning) {
    values.push_back({std::string(key), std::move(text), std::string(meaning)});
  }
};

std::optional<AnalysisPlan> plan_in(const Json& json) {
  if (!json.is_object()) return std::nullopt;
  AnalysisPlan plan;
  JsonReader reader(json);
  list_fields(reader, plan);
  return plan;
}

Json plan_json(const StudyEntry& entry) {
  const Json definition = numerics::parsed_json(entry.definition);
  return definition.is_object() && definition.contains("analysis") ? definition["analysis"] : Json();
}

// Finds invalid fields of the plan: somebody edited the store.
Doubts unreadable_doubts(const StudyEntry& entry) {
  const Json json = plan_json(entry);
  if (!json.is_object()) return {};
  AnalysisPlan plan;
  JsonReader reader(json);
  list_fields(reader, plan);
  if (!plan.control.empty() && std::ranges::find(entry.series, plan.control, &Series::label) == entry.series.end()) {
    reader.unreadable.emplace_back("control");
  }
  if (reader.unreadable.empty()) return {};
  return {{.kind = DoubtKind::plan_unreadable, .who = {reader.unreadable.begin(), reader.unreadable.end()}}};
}

// Finds solvers that sessions of the study solved and that it no longer has.
Doubts dropped_doubts(const StudyEntry& entry, const std::vector<Session>& sessions) {
  std::vector<std::string> dropped;
  for (const Session& session : sessions) {
    const auto study = session.environment.find("study"), solvers = session.environment.find("solvers");
    if (study == session.environment.end() || study->second != entry.name || solvers == session.environment.end())
      continue;
    const Json labels = numerics::parsed_json(solvers->second);
    for (const Json& label : labels.is_array() ? labels : Json::array()) {
      if (!label.is_string()) continue;
      const auto name = label.get<std::string>();
      const bool is_there = std::ranges::find(entry.series, name, &Series::label) != entry.series.end();
      if (!is_there && std::ranges::find(dropped, name) == dropped.end()) dropped.push_back(name);
    }
  }
  if (dropped.empty()) return {};
  return {{.kind = DoubtKind::solvers_dropped, .who = dropped}};
}

std::int64_t all_of(const SolvesOfSessions& solves) {
  std::int64_t all = 0;
  for (const auto& [session, count] : solves) all += count;
  return all;
}

// Counts solves by the plan that their session recorded.
struct Recorded {
  std::int64_t nowhere = 0;
  std::vector<std::pair<std::string, std::int64_t>>
      changed;  // solves by changes since their plan, in the order of the sessions
};

Recorded recorded(const StudyEntry& entry, const std::vector<Session>& sessions, const SolvesOfSessions& solves) {
  const AnalysisPlan plan = plan_of(entry);
  Recorded result;
  for (const auto& [id, count] : solves) {
    const auto session = std::ranges::find(sessions, id, &Session::id);
    std::optional<AnalysisPlan> then;
    if (session != sessions.end() && session->environment.contains("analysis")) {
      then = plan_in(numerics::parsed_json(session->environment.at("analysis")));
    }
    if (!then) {
      result.nowhere += count;
    } else if (const std::string changes = changes_between(*then, plan); !changes.empty()) {
      const auto same = std::ranges::find(result.changed, changes, &std::pair<std::string, std::int64_t>::first);
      if (same != result.changed.end()) {
        same->second += count;
      } else {
        result.changed.emplace_back(changes, count);
      }
    }
  }
  return result;
}

}  // namespace

std::vector<std::array<std::string, 3>> values_of(AnalysisPlan plan) {  // list_fields serves readers too
  Lister lister;
  list_fields(lister, plan);
  return lister.values;
}

AnalysisPlan plan_of(const StudyEntry& entry) {
  AnalysisPlan plan = plan_in(plan_json(entry)).value_or(AnalysisPlan{});
  if (std::ranges::find(entry.series, plan.control, &Series::label) == entry.series.end()) plan.control.clear();
  return plan;
}

std::string changes_between(const AnalysisPlan& before, const AnalysisPlan& after) {
  const auto old = values_of(before), now = values_of(after);
  std::vector<std::string> changes;
  for (std::size_t i = 0; i < now.size(); ++i) {
    const auto& [field, text, meaning] = now[i];
    if (old[i][1] != text) changes.push_back(fmt::format("{} {} -> {}", field, old[i][1], text));
  }
  return fmt::format("{}", fmt::join(changes, ", "));
}

Doubts plan_changes(const StudyEntry& entry, const std::vector<Session>& sessions, const SolvesOfSessions& solves) {
  Doubts doubts;
  for (const auto& [changes, count] : recorded(entry, sessions, solves).changed) {
    doubts.push_back({.kind = DoubtKind::plan_changed,
                      .count = static_cast<double>(count),
                      .of = static_cast<double>(all_of(solves)),
                      .what = changes});
  }
  return doubts + dropped_doubts(entry, sessions) + unreadable_doubts(entry);
}

std::vector<std::string> plan_notes(const StudyEntry& entry, const std::vector<Session>& sessions,
                                    const SolvesOfSessions& solves) {
  Doubts doubts = plan_changes(entry, sessions, solves);
  if (const std::int64_t nowhere = recorded(entry, sessions, solves).nowhere; nowhere > 0) {
    doubts.push_back({.kind = DoubtKind::plan_not_recorded,
                      .count = static_cast<double>(nowhere),
                      .of = static_cast<double>(all_of(solves))});
  }
  if (!plan_json(entry).is_object()) doubts.push_back({.kind = DoubtKind::no_plan});
  if (!doubts.empty()) return list_of(doubts);
  std::vector<std::string> values;
  for (const auto& [field, text, meaning] : values_of(plan_of(entry))) values.push_back(field + ' ' + text);
  return {fmt::format("The methods {} ({}).",
                      solves.empty() ? "are fixed in the study, which has no solves yet"
                                     : "were fixed in the study before its first solve in this store",
                      fmt::join(values, ", "))};
}

double level_of_look(const std::vector<Look>& looks, int runs, double significance) {
  const auto earlier = std::ranges::count_if(looks, [runs](const Look& look) { return look.runs != runs; });
  return earlier == 0 ? significance : significance / static_cast<double>((earlier + 1) * earlier);
}

Doubts look_doubts(const std::vector<Look>& looks, int runs, double significance) {
  std::vector<std::string> earlier;
  for (const Look& look : looks) {
    if (look.runs != runs) earlier.push_back(fmt::format("{} ({})", look.runs, look.when.substr(0, 10)));
  }
  if (earlier.empty()) return {};
  constexpr std::size_t most_named = 5;
  const std::size_t number_of_earlier = earlier.size();
  if (number_of_earlier > most_named) earlier.erase(earlier.begin(), earlier.end() - most_named);
  return {{.kind = DoubtKind::looked_before,
           .who = earlier,
           .count = static_cast<double>(number_of_earlier + 1),
           .of = static_cast<double>(runs),
           .value = level_of_look(looks, runs, significance),
           .limit = 100 * significance,
           .what = number_of_earlier > most_named ? "the latest before it" : "earlier ones"}};
}

}  // namespace ikbench::inference
