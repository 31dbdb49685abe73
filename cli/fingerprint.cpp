// ikbench fingerprint: one hash of all results of a study.
#include "results/fingerprint.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/screen.hpp"
#include "results/store.hpp"

namespace ikbench::cli {

using namespace results;
using namespace experiments;
using namespace report;

void add_fingerprint(CLI::App& app, Invocation&) {
  struct Arguments {
    std::string store, study;
    OutputArguments output;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand(
      "fingerprint", "Print a hash of a study's results, to check that two stores agree bit for bit");
  command->add_option("STORE", arguments->store, "path of a store.sqlite")->required();
  command->add_option("--study", arguments->study, "name of the study; default: all in the store");
  add_json_option(*command, arguments->output);
  command->footer(
      "Examples:\n"
      "  ikbench fingerprint out/slim2023/store.sqlite\n"
      "  ikbench fingerprint theirs.sqlite --study slim2023\n\n"
      "Prints a line for each study: fingerprint, number of solves, name. The fingerprint covers every bit of the\n"
      "results. It leaves out times and sessions.");
  command->callback([arguments] {
    const Store store(arguments->store, Store::Mode::read);
    const std::vector<StudyEntry> studies =
        arguments->study.empty() ? store.studies() : std::vector<StudyEntry>{store.study(arguments->study)};
    report::Json all = report::Json::array();
    for (const StudyEntry& study : studies) {
      const auto [text, solves] = fingerprint(store, study);
      if (!arguments->output.is_json) fmt::print("{}  {}  {}\n", text, solves, printable(study.name));
      all.push_back({{"fingerprint", text}, {"solves", solves}, {"study", study.name}});
    }
    if (arguments->output.is_json) show_json(all);
  });
}

}  // namespace ikbench::cli
