// ikbench store: what is in a store, and removing from it.
#include "results/store.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/reporting.hpp"
#include "numerics/json.hpp"
#include "results/prune.hpp"

namespace ikbench::cli {

using namespace numerics;
using namespace results;
using namespace experiments;

namespace {

std::string text_in(const Session& session, const char* key) {
  const auto found = session.environment.find(key);
  return found == session.environment.end() ? "" : found->second;
}

// A table with rows of such objects: their values, below the names in capitals.
Rows rows_of(const report::Json& objects, const std::vector<std::string>& heads) {
  Rows rows{heads};
  for (const report::Json& object : objects) {
    rows.emplace_back();
    for (const auto& [key, value] : object.items())
      rows.back().push_back(value.is_string() ? value.get<std::string>() : numerics::text_of(value));
  }
  return rows;
}

void list(const std::string& file, const OutputArguments& output) {
  const Store store(file, Store::Mode::read);
  report::Json studies = report::Json::array();
  for (const StudyEntry& study : store.studies()) {
    const report::Json definition = parsed_ordered_json(study.definition);
    studies.push_back({{"study", study.name},
                       {"solvers", study.series.size()},
                       {"runs", definition.value("runs", report::Json(nullptr))},
                       {"points", definition.value("points", report::Json(nullptr))},
                       {"solves", store.solves_of(study.series)}});
  }
  const Unused unused = unused_in(file);
  if (output.is_json)
    return show_json({{"studies", studies}, {"unused", {{"solves", unused.solves}, {"sessions", unused.sessions}}}});
  fmt::print("{}", aligned(rows_of(studies, {"STUDY", "SOLVERS", "RUNS", "POINTS", "SOLVES"})));
  if (unused.solves + unused.sessions > 0) {
    fmt::print(
        "\nunused: {} solves of earlier settings or sources, {} sessions without a solve; ikbench store gc removes them\n",
        unused.solves, unused.sessions);
  }
}

void show(const std::string& file, const std::string& name, const OutputArguments& output) {
  const Store store(file, Store::Mode::read);
  const StudyEntry study = chosen_study(store, name);
  report::Json solvers = report::Json::array(), sessions = report::Json::array();
  for (const Series& series : study.series) {
    solvers.push_back({{"solver", series.label},
                       {"algorithm", series.algorithm},
                       {"solves", store.solves_of({series})},
                       {"series", series.key}});
  }
  const std::vector<std::int64_t> of_study = store.sessions_of(study.series);
  for (const Session& session : store.sessions()) {
    if (std::ranges::find(of_study, session.id) == of_study.end()) continue;
    sessions.push_back({{"session", session.id},
                        {"began", session.began},
                        {"cpu", text_in(session, "cpu")},
                        {"commit", text_in(session, "commit")}});
  }
  if (output.is_json) return show_json({{"study", study.name}, {"solvers", solvers}, {"sessions", sessions}});
  fmt::print("{}\n\n{}\n{}", printable(study.name),
             aligned(rows_of(solvers, {"SOLVER", "ALGORITHM", "SOLVES", "SERIES"})),
             aligned(rows_of(sessions, {"SESSION", "BEGAN", "CPU", "COMMIT"})));
}

void remove(const std::string& file, const std::string& study, const OutputArguments& output) {
  {
    const Store store(file, Store::Mode::read);
    for (const StudyEntry& each : store.studies()) {
      for (const std::string& damage : damages_of(store, each.name))
        throw std::invalid_argument(fmt::format("{} Nothing was removed.", damage));
    }
  }
  const auto before = std::filesystem::file_size(file);
  const Unused removed = prune(file, study);
  if (output.is_json) {
    return show_json({{"study", study.empty() ? report::Json(nullptr) : report::Json(study)},
                      {"solves", removed.solves},
                      {"sessions", removed.sessions},
                      {"bytes_before", before},
                      {"bytes", std::filesystem::file_size(file)}});
  }
  fmt::print("removed {}{} solves and {} sessions; {:.1f} MB are {:.1f} MB now\n",
             study.empty() ? "" : fmt::format("the study {}, ", printable(study)), removed.solves, removed.sessions,
             static_cast<double>(before) / 1e6, static_cast<double>(std::filesystem::file_size(file)) / 1e6);
}

}  // namespace

void add_store(CLI::App& app, Invocation&) {
  struct Arguments {
    std::string file, study;
    OutputArguments output = {};
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("store", "Show what a store has, or remove a study or what no study uses");
  command->require_subcommand(1);
  command->footer(
      "Examples:\n"
      "  ikbench store ls out/slim2023/store.sqlite\n"
      "  ikbench store show out/slim2023/store.sqlite --study slim2023-limits\n"
      "  ikbench store rm out/slim2023/store.sqlite slim2023-dobot\n"
      "  ikbench store gc out/my/store.sqlite      solves of settings and sources that changed since");
  const auto add = [&](const char* name, const char* words) {
    CLI::App* action = command->add_subcommand(name, words);
    action->add_option("STORE", arguments->file, "path of a store.sqlite")->required();
    add_json_option(*action, arguments->output);
    return action;
  };
  add("ls", "List the studies with their solves")->callback([arguments] { list(arguments->file, arguments->output); });
  CLI::App* shown = add("show", "Show the solvers of a study and the sessions that solved it");
  shown->add_option("--study", arguments->study, "name of the study; default: the first in the store");
  shown->callback([arguments] { show(arguments->file, arguments->study, arguments->output); });
  CLI::App* removed = add("rm", "Remove a study, with the solves that no other study uses");
  removed->add_option("STUDY", arguments->study, "name of the study")->required()->check(not_empty());
  removed->callback([arguments] { remove(arguments->file, arguments->study, arguments->output); });
  add("gc", "Remove the solves of earlier settings and sources, and sessions without a solve")->callback([arguments] {
    remove(arguments->file, "", arguments->output);
  });
}

}  // namespace ikbench::cli
