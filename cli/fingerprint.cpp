// ikbench fingerprint: one hash of all results of a study.
#include "results/fingerprint.hpp"

#include <fmt/format.h>

#include <memory>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "results/store.hpp"

namespace ikbench::cli {

using namespace results;
using namespace experiments;

void add_fingerprint(CLI::App& app) {
  struct Arguments {
    std::string store, study;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      app.add_subcommand("fingerprint", "One hash of all results of a study: whether two stores have the same bits");
  command->add_option("STORE", arguments->store, "a store.sqlite")->required();
  command->add_option("--study", arguments->study, "which study; all of the store if not given");
  command->footer(
      "Examples:\n"
      "  ikbench fingerprint out/slim2023/store.sqlite\n"
      "  ikbench fingerprint theirs.sqlite --study slim2023\n\n"
      "A line for each study: fingerprint, number of solves, name. Times and sessions are no part of it; of everything "
      "else every bit is.");
  command->callback([arguments] {
    const Store store(arguments->store, Store::Mode::read);
    const std::vector<StudyEntry> studies =
        arguments->study.empty() ? store.studies() : std::vector<StudyEntry>{store.study(arguments->study)};
    for (const StudyEntry& study : studies) {
      const std::vector<SolveRecord> solves = store.solves(study.name);
      fmt::print("{}  {}  {}\n", fingerprint(solves), solves.size(), printable(study.name));
    }
  });
}

}  // namespace ikbench::cli
