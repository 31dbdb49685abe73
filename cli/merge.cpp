// ikbench merge: merges the stores of several machines into one.
#include "results/merge.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/reporting.hpp"
#include "cli/screen.hpp"
#include "cli/shards.hpp"
#include "results/files.hpp"

namespace ikbench::cli {

using namespace results;
using namespace report;

namespace {

namespace fs = std::filesystem;

// The stores without `out` itself, each once.
std::vector<fs::path> stores_to_merge(const fs::path& out, const std::vector<std::string>& places) {
  std::vector<fs::path> stores;
  const auto is_one_of_them = [&](const fs::path& file) {
    std::error_code error;
    return fs::equivalent(file, out, error) ||
           std::ranges::any_of(stores, [&](const fs::path& known) { return fs::equivalent(file, known, error); });
  };
  for (const std::string& place : places)
    for (const fs::path& file : stores_in(place))
      if (!is_one_of_them(file)) stores.push_back(file);
  return stores;
}

// Nothing if a signal stopped it.
std::optional<Merged> merged_or_stopped(const fs::path& out, const std::vector<fs::path>& stores) {
  const EndOnSignal at_once("Stopped. All was merged, or nothing; give the same command again.");
  CancelOnSignal signals("Stopping the merge.");
  try {
    ProgressBar bar("merging", "stores");
    Merged merged = merge(out, stores, &signals.requested(),
                          [&](std::int64_t done, std::int64_t all) { bar.show({.done = done, .total = all}); });
    if (!signals.end()) return merged;
    say("Stopped. All was merged; give the same command again to see what is missing.");
  } catch (const MergeCancelled&) {
    say("Stopped. Nothing was merged; give the same command again.");
  }
  return std::nullopt;
}

}  // namespace

void add_merge(CLI::App& app, Invocation& invocation) {
  struct Arguments {
    std::string out;
    std::vector<std::string> places;
    OutputArguments output;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("merge", "Put the stores of several shards or machines together into one");
  command->add_option("OUT", arguments->out, "folder of the store that gets all; it may have one already")
      ->required()
      ->check(not_empty());
  command
      ->add_option("IN", arguments->places,
                   "stores, folders with a store.sqlite, or a folder of such folders, as out/<study>/shards")
      ->required()
      ->check(not_empty());
  add_json_option(*command, arguments->output);
  command->footer(
      "Examples:\n"
      "  ikbench merge out/slim2023 out/slim2023/shards\n"
      "  ikbench merge out/both laptop/store.sqlite desktop/store.sqlite\n\n"
      "A solve that two stores have must have the same bits in both. Solves are copied as they are: `ikbench\n"
      "report` and `compare` find what is damaged. A store whose sessions or studies were changed is refused. A store that a kill left half-written is left out, and named.\n"
      "What is missing is named, with the command that solves it where that is known; the exit code is then 5. A\n"
      "merge that was killed has added nothing, or all: give the same command again.");
  command->callback([arguments, &invocation] {
    const fs::path out = store_in(arguments->out);
    const std::vector<fs::path> stores = stores_to_merge(out, arguments->places);
    remove_litter(arguments->out);
    const std::optional<Merged> done = merged_or_stopped(out, stores);
    if (!done) {
      invocation.exit_code = cancelled_exit_code();
      return;
    }
    const Merged& merged = *done;
    const EndOnSignal signals("Stopped. All was merged; give the same command again to see what is missing.");
    const std::size_t taken = stores.size() - merged.half_written.size();
    if (!arguments->output.is_json) {
      fmt::print("{}\n", wrapped(fmt::format("{}: {} solve{} added from {} store{}, {} were there with the same bits",
                                             out.string(), merged.added, merged.added == 1 ? "" : "s", taken,
                                             taken == 1 ? "" : "s", merged.known)));
    }
    for (const std::string& sentence : merged.half_written) warn("left out: " + sentence);
    const Store store(out, Store::Mode::read);
    report::Json missing = report::Json::object();
    for (const StudyEntry& study : store.studies()) {
      const std::vector<std::string> lines = missing_parts(store, study);
      for (const std::string& line : lines) (line.starts_with(' ') ? say_command : say)(line);
      if (!lines.empty()) invocation.exit_code = 5;
      if (const std::int64_t lacks = solves_missing(store, study); lacks > 0) missing[study.name] = lacks;
    }
    if (!arguments->output.is_json) return;
    show_json({{"store", out.string()},
               {"stores", taken},
               {"added", merged.added},
               {"known", merged.known},
               {"half_written", merged.half_written},
               {"missing", std::move(missing)}});
  });
}

}  // namespace ikbench::cli
