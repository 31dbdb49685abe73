// ikbench count: the example of docs/adding-anything.md.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "results/store.hpp"

namespace ikbench::cli {

using namespace results;

void add_count(CLI::App& app, Invocation& invocation) {
  auto file = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("count", "Count the solves of each study in a store");
  command->add_option("STORE", *file, "path of a store.sqlite")->required();
  command->callback([file, &invocation] {
    const Store store(*file, Store::Mode::read);
    for (const StudyEntry& study : store.studies())
      fmt::print("{} {}\n", store.solves_of(study.series), printable(study.name));
    if (store.studies().empty()) invocation.exit_code = 5;
  });
}

}  // namespace ikbench::cli
