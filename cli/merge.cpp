// ikbench merge: merges the stores of several machines into one.
#include "results/merge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <stdexcept>

#include "base/files.hpp"
#include "base/names.hpp"
#include "cli/console.hpp"
#include "cli/running.hpp"
#include "experiments/stored_checks.hpp"

namespace ikbench::cli {

namespace {

namespace fs = std::filesystem;

// Returns the stores that a place stands for: a file stands for itself, and a folder for the store.sqlite inside. A
// folder without store.sqlite stands for the stores of the folders inside, by name. Throws std::invalid_argument if
// there is no store, or if a folder cannot be read.
std::vector<fs::path> stores_in(const fs::path& place) {
  std::error_code error;
  if (!fs::is_directory(place, error)) return {place};  // opening the place says what is wrong
  if (fs::exists(store_path(place), error)) return {store_path(place)};
  std::vector<fs::path> stores;
  for (fs::directory_iterator entry(place, error), end; !error && entry != end; entry.increment(error)) {
    std::error_code unknown;  // if a store cannot be looked at, opening the store says why
    if (fs::exists(store_path(entry->path()), unknown) || unknown) stores.push_back(store_path(entry->path()));
  }
  if (error) base::refuse_place("read", place, error.value());
  if (stores.empty())
    throw std::invalid_argument(fmt::format("'{}' has no store.sqlite, and no folder in it has one", place.string()));
  std::ranges::sort(stores);
  return stores;
}

}  // namespace

void add_merge(const Command& command, Invocation& invocation) {
  struct Arguments {
    std::string out;
    std::vector<std::string> places;
  };
  auto arguments = std::make_shared<Arguments>();
  command
      .add("FOLDERS", &arguments->places,
           "first that of the store that gets all, unless -o names it; then stores, folders with a "
           "store.sqlite, or a folder of such folders, as out/<study>/shards")
      .required();
  add_out_option(command, arguments->out, "folder of the store that gets all; it may have one already");
  command.footer(
      "  ikbench merge out/slim2023 out/slim2023/shards\n"
      "  ikbench merge out/both laptop/store.sqlite desktop/store.sqlite\n\n"
      "A solve that two stores have must have the same bits in both. What is missing is counted; the exit code is "
      "then 5. A store with a wrong solve is named and left out, as are solves that no study of their store has (former "
      "settings); the exit code is then 1. After a merge that was killed give the same command again.");
  command.callback([arguments, &invocation] {
    if (arguments->out.empty()) {
      arguments->out = arguments->places.front();
      arguments->places.erase(arguments->places.begin());
    }
    if (arguments->places.empty()) throw std::invalid_argument("nothing to merge; expected merge OUT IN ...");
    const fs::path out = store_path(arguments->out);
    std::vector<fs::path> stores;
    for (const std::string& place : arguments->places) std::ranges::copy(stores_in(place), std::back_inserter(stores));
    const MergeResult merged = [&] {
      ProgressBar bar("merging", "stores");
      return merge(out, stores, experiments::stored_solve_check,
                   [&](std::int64_t done, std::int64_t total) { bar.show({.done = done, .total = total}); });
    }();
    fmt::print("{}\n", wrapped(fmt::format("{}: {} added from {}, {} were there with the same bits", out.string(),
                                           base::counted(merged.added, "solves"),
                                           base::counted(merged.stores, "stores"), merged.duplicates)));
    for (const std::string& lack : merged.incomplete)
      print_message(lack + "; solve its missing shards, then merge again");
    for (const std::string& reason : merged.skipped) print_message("left out: " + reason);
    if (!merged.incomplete.empty()) invocation.exit_code = 5;
    if (!merged.skipped.empty()) invocation.exit_code = 1;
  });
}

}  // namespace ikbench::cli
