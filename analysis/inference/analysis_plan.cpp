#include "analysis/inference/analysis_plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "numerics/json.hpp"
#include "numerics/toml_table.hpp"
#include "results/analysis_plan_fields.hpp"

namespace ikbench::inference {

using namespace results;

namespace {

using Json = nlohmann::json;

// Reads the fields of a stored plan or style like those of a study file. Leaves other keys alone.
template <class Of>
void read_fields(const Json& object, std::string_view source, Of& of) {
  const toml::table table = numerics::parse_toml("stored = " + numerics::toml_of(object), source);
  numerics::TomlReader reader(*table.get("stored")->as_table(), source, "");
  list_fields(reader, of);
}

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
  read_fields(json, "the analysis plan of a study", plan);
  return plan;
}

Json plan_json(const StudyEntry& entry) {
  const Json definition = numerics::parsed_json(entry.definition);
  return definition.is_object() && definition.contains("analysis") ? definition["analysis"] : Json();
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

double count_of(const SolvesOfSessions& solves) {
  double all = 0;
  for (const auto& [id, count] : solves) all += static_cast<double>(count);
  return all;
}

// The plan that a session recorded.
std::optional<AnalysisPlan> recorded_plan(const std::vector<Session>& sessions, std::int64_t id) {
  const auto session = std::ranges::find(sessions, id, &Session::id);
  if (session == sessions.end() || !session->environment.contains("analysis")) return std::nullopt;
  return plan_in(numerics::parsed_json(session->environment.at("analysis")));
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

FigureStyle figure_style_of(const StudyEntry& entry) {
  const Json definition = numerics::parsed_json(entry.definition);
  FigureStyle style;
  if (!definition.is_object() || !definition.contains("figures") || !definition["figures"].is_object()) return style;
  constexpr std::string_view source = "the look of figures of a study";
  Json figures = definition["figures"];
  if (figures.contains("solvers") && figures["solvers"].empty()) figures.erase("solvers");  // all, which no file lists
  read_fields(figures, source, style);
  const Json& colours = figures.contains("colours") ? figures["colours"] : Json::object();
  for (const auto& [label, colour] : colours.items()) {
    if (colour.is_string()) style.colours.emplace(label, colour.get<std::string>());
  }
  if (const auto mistake = mistake_in(style)) {
    throw std::invalid_argument(fmt::format("{}: {}; expected {}", source, mistake->first, mistake->second));
  }
  return style;
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
  const AnalysisPlan plan = plan_of(entry);
  const double all = count_of(solves);
  Doubts doubts;
  for (const auto& [id, count] : solves) {
    const auto then = recorded_plan(sessions, id);
    const std::string changes = then ? changes_between(*then, plan) : "";
    if (changes.empty()) continue;
    auto same = std::ranges::find(doubts, changes, &Doubt::what);
    if (same == doubts.end()) same = doubts.insert(same, {.kind = DoubtKind::plan_changed, .of = all, .what = changes});
    same->count += static_cast<double>(count);
  }
  const Doubts dropped = dropped_doubts(entry, sessions);
  const auto written = plan_in(plan_json(entry));
  if (dropped.empty() && written && written->control != plan.control)
    doubts.push_back({.kind = DoubtKind::control_absent, .who = {written->control}});
  return doubts + dropped;
}

std::vector<std::string> plan_notes(const StudyEntry& entry, const std::vector<Session>& sessions,
                                    const SolvesOfSessions& solves) {
  Doubts doubts = plan_changes(entry, sessions, solves);
  Doubt unrecorded{.kind = DoubtKind::plan_not_recorded, .of = count_of(solves)};
  for (const auto& [id, count] : solves)
    unrecorded.count += recorded_plan(sessions, id) ? 0 : static_cast<double>(count);
  if (unrecorded.count > 0) doubts.push_back(unrecorded);
  if (!plan_json(entry).is_object()) doubts.push_back({.kind = DoubtKind::no_plan});
  if (!doubts.empty()) return list_of(doubts);
  std::vector<std::string> values;
  for (const auto& [field, text, meaning] : values_of(plan_of(entry))) values.push_back(field + ' ' + text);
  return {fmt::format("The methods {} ({}).",
                      solves.empty() ? "are fixed in the study, which has no solves yet"
                                     : "were fixed in the study before its first solve in this store",
                      fmt::join(values, ", "))};
}

}  // namespace ikbench::inference
