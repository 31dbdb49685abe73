#include "analysis/report/provenance.hpp"

#include <fmt/format.h>

#include <map>
#include <set>
#include <utility>

#include "analysis/inference/comparable.hpp"
#include "analysis/report/words.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "numerics/json.hpp"

namespace ikbench::report {

using namespace results;
using namespace statistics;
using namespace inference;
using namespace fmt::literals;

namespace {

using SortedJson = nlohmann::json;

std::string text_of_json(const SortedJson& value) {
  return value.is_string() ? value.get<std::string>() : numerics::text_of(value);
}

// One row per value: path.kind, helix.
void add_values(std::vector<std::vector<Cell>>& rows, const SortedJson& value, const std::vector<Cell>& before,
                const std::string& path) {
  if (value.is_object() && !value.empty()) {
    for (const auto& [key, inner] : value.items()) {
      add_values(rows, inner, before, path.empty() ? key : fmt::format("{}.{}", path, key));
    }
    return;
  }
  std::vector<Cell> row = before;
  row.emplace_back(path);
  row.emplace_back(value.is_object() ? std::string() : text_of_json(value));
  rows.push_back(std::move(row));
}

// Text that is no JSON is shown as it stands.
SortedJson parsed(const std::string& text) {
  SortedJson value = numerics::parsed_json(text);
  return value.is_discarded() ? SortedJson(text) : value;
}

}  // namespace

Table definition_table(const StudyEntry& entry) {
  Table table{.name = "definition", .caption = "Definition of the study", .columns = {"setting", "value"}};
  add_values(table.rows, parsed(entry.definition), {}, "");
  return table;
}

Table options_table(const StudyEntry& entry) {
  Table table{
      .name = "options", .caption = "Options of the solvers", .columns = {"solver", "algorithm", "option", "value"}};
  for (const Series& series : entry.series) {
    add_values(table.rows, parsed(series.options), {series.label, series.algorithm}, "");
  }
  return table;
}

Table plan_table(const StudyEntry& entry, const AnalysisPlan& used, std::vector<std::string> notes) {
  Table table{.name = "analysis-plan",
              .caption = "How the study is judged",
              .columns = {"method", "value", "meaning"},
              .notes = std::move(notes)};
  for (const auto& [field, text, meaning] : values_of(used)) table.rows.push_back({field, text, meaning});
  if (const std::string given = changes_between(plan_of(entry), used); !given.empty()) {
    table.notes.push_back(fmt::format(words::plan_changed, "changes"_a = given));
  }
  return table;
}

Table environment_table(const StudyResults& study, const std::vector<Session>& sessions) {
  Table table{.name = "environment", .caption = "Environment", .columns = {"fact", "value", "sessions"}};
  const SolvesOfSessions solves = solves_of_sessions(study);
  std::map<std::pair<std::string, std::string>, std::string> where;  // (fact, value) to its sessions
  for (const Session& session : sessions) {
    if (!solves.contains(session.id)) continue;
    for (const auto& fact : session.environment) {
      std::string& list = where[fact];
      list += fmt::format("{}{}", list.empty() ? "" : ", ", session.id);
    }
  }
  for (const auto& [fact, list] : where) table.rows.push_back({fact.first, fact.second, list});
  std::string note = "Solves by session:";
  for (const auto& [session, count] : solves) note += fmt::format(" {} ({})", session, count);
  table.notes.push_back(note + ".");
  return table;
}

namespace {

// Splits words as a shell does, but keeps quotes.
std::vector<std::string> shell_words(std::string_view command) {
  std::vector<std::string> words(1);
  bool is_quoted = false;
  for (std::size_t i = 0; i < command.size(); ++i) {
    if (command[i] == ' ' && !is_quoted) {
      words.emplace_back();
      continue;
    }
    if (command[i] == '\'') is_quoted = !is_quoted;
    if (command[i] == '\\' && !is_quoted && i + 1 < command.size()) words.back() += command[i++];
    words.back() += command[i];
  }
  return words;
}

// Turns the command of a part into that of the whole study: removes the part and its folder.
std::string of_whole(std::string_view command) {
  std::string whole;
  bool is_value = false;
  for (const std::string& word : shell_words(command)) {
    const bool is_option = word == "--shard" || word == "--out";
    const std::string_view unquoted = std::string_view(word).substr(word.starts_with('\'') ? 1 : 0);
    if (!is_option && !is_value && !unquoted.starts_with("--shard=") && !unquoted.starts_with("--out=")) {
      whole += (whole.empty() ? "" : " ") + word;
    }
    is_value = is_option;
  }
  return whole;
}

}  // namespace

std::string command_of(const StudyResults& study, const std::vector<Session>& sessions) {
  std::int64_t last = 0;
  for (const auto& [session, count] : solves_of_sessions(study)) last = std::max(last, session);
  for (const Session& session : sessions) {
    const auto command = session.environment.find("command");
    if (session.id != last || command == session.environment.end()) continue;
    return session.environment.contains("shard") ? of_whole(command->second) : command->second;
  }
  return "";
}

bool same_targets(const StudyResults& a, const StudyResults& b) {
  const auto place = [](const Solve* solve) { return std::pair(solve->run, solve->point); };
  const std::vector<const Solve*> places = places_of(a);
  bool met = false;
  for (const Solve& solve : b.solves) {
    const auto found = std::ranges::lower_bound(places, place(&solve), {}, place);
    if (found == places.end() || place(*found) != place(&solve)) continue;
    if (!same_target(problem_of(a, **found), problem_of(b, solve))) return false;
    met = true;
  }
  return met && a.points == b.points;
}

Table baselines_table(const JudgedStudies& studies) {
  const std::vector<Metric> metrics = reported_metrics();
  Table table{.name = "baselines",
              .caption = "Other studies with the same targets",
              .columns = {"study", "algorithm", "observations", "not_finite"}};
  for (const Metric metric : metrics) {
    table.columns.push_back(fmt::format("mean_{}", name_of(metric)));
    table.columns.push_back(fmt::format("median_{}", name_of(metric)));
  }
  for (const StudyResults& study : studies) {
    const std::size_t first = table.rows.size();
    for (const SolverCounts& count : counts(study)) {
      table.rows.push_back({study.name, count.solver, std::int64_t{0}, std::int64_t{count.of(Status::not_finite)}});
    }
    for (const Metric metric : metrics) {
      std::size_t row = first;
      for (const Sample& sample : samples(study, metric)) {
        const Description description = statistics::describe(sample.values);
        table.rows[row][2] = std::int64_t{description.n};
        table.rows[row].emplace_back(description.mean);
        table.rows[row].emplace_back(description.median);
        ++row;
      }
    }
    for (const std::string& note : status_notes(study)) table.notes.push_back(study.name + ": " + note);
    for (const std::string& note : list_of(times_doubts(study))) table.notes.push_back(study.name + ": " + note);
  }
  return table;
}

}  // namespace ikbench::report
