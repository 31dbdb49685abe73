// ikbench merge: merges the stores of several machines into one.
#include "results/merge.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/options.hpp"
#include "cli/reporting.hpp"
#include "experiments/shard.hpp"
#include "results/files.hpp"

namespace ikbench::cli {

using namespace results;

namespace {

namespace fs = std::filesystem;

// The stores that a place means: a file itself; a folder's store.sqlite; or, if it has none, those of the folders in
// it, by name. Throws std::invalid_argument if there is none, or if a folder cannot be read.
std::vector<fs::path> stores_in(const fs::path& place) {
  std::error_code error;
  if (!fs::is_directory(place, error)) return {place};  // opening it says what is wrong
  if (fs::exists(store_in(place), error)) return {store_in(place)};
  std::vector<fs::path> stores;
  for (fs::directory_iterator entry(place, error), end; !error && entry != end; entry.increment(error)) {
    std::error_code unknown;  // of a store that cannot be looked at, opening it says why
    if (fs::exists(store_in(entry->path()), unknown) || unknown) stores.push_back(store_in(entry->path()));
  }
  if (error) throw std::invalid_argument(fmt::format("cannot read '{}': {}", place.string(), error.message()));
  if (stores.empty())
    throw std::invalid_argument(fmt::format("'{}' has no store.sqlite, and no folder in it has one", place.string()));
  std::ranges::sort(stores);
  return stores;
}

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
    bool is_json = false;
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
  add_json_option(*command, arguments->is_json);
  command->footer(
      "Examples:\n"
      "  ikbench merge out/slim2023 out/slim2023/shards\n"
      "  ikbench merge out/both laptop/store.sqlite desktop/store.sqlite\n\n"
      "A solve that two stores have must have the same bits in both. A store that a kill left half-written is left\n"
      "out, and named.\n"
      "What is missing is counted; the exit code is then 5. A\n"
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
    if (!arguments->is_json) {
      fmt::print("{}\n", wrapped(fmt::format("{}: {} solve{} added from {} store{}, {} were there with the same bits",
                                             out.string(), merged.added, merged.added == 1 ? "" : "s", taken,
                                             taken == 1 ? "" : "s", merged.known)));
    }
    for (const std::string& sentence : merged.half_written) warn("left out: " + sentence);
    const Store store(out, Store::Mode::read);
    numerics::OrderedJson missing = numerics::OrderedJson::object();
    for (const StudyEntry& study : store.studies()) {
      const std::int64_t all = experiments::solves_of({}, experiments::size_of(study));
      const std::int64_t lacks = all - experiments::solves_within(study, store);
      if (lacks == 0) continue;
      say(fmt::format("{} lacks {} of {} solves; solve its missing shards, then merge again", study.name, lacks, all));
      invocation.exit_code = 5;
      missing[study.name] = lacks;
    }
    if (!arguments->is_json) return;
    show_json({{"store", out.string()},
               {"stores", taken},
               {"added", merged.added},
               {"known", merged.known},
               {"half_written", merged.half_written},
               {"missing", std::move(missing)}});
  });
}

}  // namespace ikbench::cli
