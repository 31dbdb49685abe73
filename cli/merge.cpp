// ikbench merge: the stores of several machines as one.
#include "results/merge.hpp"

#include <fmt/format.h>

#include <memory>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/reporting.hpp"
#include "cli/shards.hpp"

namespace ikbench::cli {

using namespace results;

namespace {

namespace fs = std::filesystem;

// Stores, without those that are `out` itself, and each once.
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

}  // namespace

void add_merge(CLI::App& app, Invocation& invocation) {
  struct Arguments {
    std::string out;
    std::vector<std::string> places;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("merge", "Put the stores of several shards or machines together into one");
  command->add_option("OUT", arguments->out, "folder of the store that gets all; it may have one already")->required();
  command
      ->add_option("IN", arguments->places,
                   "stores, folders with a store.sqlite, or a folder of such folders, as out/<study>/shards")
      ->required();
  command->footer(
      "Examples:\n"
      "  ikbench merge out/slim2023 out/slim2023/shards\n"
      "  ikbench merge out/both laptop/store.sqlite desktop/store.sqlite\n\n"
      "A solve that two stores have must have the same bits in both. What is missing is named with the command that\n"
      "solves it; the exit code is then 5. A merge that was killed has added nothing: give the same command again.");
  command->callback([arguments, &invocation] {
    const fs::path folder = arguments->out, out = store_in(folder);
    const std::vector<fs::path> stores = stores_to_merge(out, arguments->places);
    const Merged merged = merge(out, stores);
    fmt::print("{}: {} solves added from {} stores, {} were there with the same bits\n", printable(out.string()),
               merged.added, stores.size(), merged.known);
    const Store store(out, Store::Mode::read);
    for (const StudyEntry& study : store.studies()) {
      for (const std::string& line : missing_parts(store, study, folder)) {
        say(line);
        invocation.exit_code = 5;
      }
    }
  });
}

}  // namespace ikbench::cli
