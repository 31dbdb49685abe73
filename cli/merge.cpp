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
    throw std::invalid_argument(fmt::format("neither '{}' nor a folder in it has a store.sqlite", place.string()));
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
           "first the folder to merge into (unless -o names it), then stores, folders with a store.sqlite, "
           "or a folder of such folders, such as out/<study>/shards")
      .required();
  add_out_option(command, arguments->out, "folder to merge into; it may have a store already");
  command.footer(
      "  ikbench merge out/slim2023 out/slim2023/shards\n"
      "  ikbench merge out/both laptop/store.sqlite desktop/store.sqlite\n\n"
      "If two stores have the same solve, it must have the same bits in both. After a merge that was killed, give the "
      "same command again.\n"
      "Exit codes, first match wins:\n"
      "  1  a store with a wrong solve was left out, or solves of former settings, which no study has any more\n"
      "  5  solves are missing, and their number is shown\n"
      "  0  otherwise");
  command.callback([arguments, &invocation] {
    if (arguments->out.empty()) {
      arguments->out = arguments->places.front();
      arguments->places.erase(arguments->places.begin());
    }
    if (arguments->places.empty())
      throw std::invalid_argument(
          "there is nothing to merge; expected two folders or more, such as ikbench merge out/both out/laptop out/desktop");
    const fs::path out = store_path(arguments->out);
    std::vector<fs::path> stores;
    for (const std::string& place : arguments->places) std::ranges::copy(stores_in(place), std::back_inserter(stores));
    const MergeResult merged = [&] {
      ProgressBar bar("merging", "stores");
      return merge(out, stores, experiments::stored_solve_check,
                   [&](std::int64_t done, std::int64_t total) { bar.show({.done = done, .total = total}); });
    }();
    fmt::print("{}\n", wrapped(fmt::format("{}: {} added from {}; {} were there already, with the same bits",
                                           out.string(), base::counted(merged.added, "solves"),
                                           base::counted(merged.stores, "stores"), merged.duplicates)));
    for (const std::string& lack : merged.incomplete)
      print_message(lack + "; solve its missing shards, then run the same merge again");
    for (const std::string& reason : merged.skipped) print_message("left out: " + reason);
    if (!merged.incomplete.empty()) invocation.exit_code = 5;
    if (!merged.skipped.empty()) invocation.exit_code = 1;
  });
}

}  // namespace ikbench::cli
