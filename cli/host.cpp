// ikbench host: the child process in which a shared object solves, so that even its crash is only a row of the study.
#include "experiments/foreign/host.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "cli/commands.hpp"

namespace ikbench::cli {

void add_host(CLI::App& app, Invocation&) {
  struct Arguments {
    std::string object, name;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("host", "Speak the protocol of programs for a solver in a shared object");
  command->group("");  // a study starts it; nobody types it
  command->add_option("OBJECT", arguments->object, "a shared object with solvers (ikbench_plugin.h)")->required();
  command->add_option("SOLVER", arguments->name, "the name of one of them; without it the first");
  command->footer(
      "Examples:\n"
      "  ikbench host ./libmine.so\n\n"
      "A study with shared_object = \"./libmine.so\" starts it. docs/solvers-in-any-language.md has the messages.");
  command->callback([arguments] {
    try {
      experiments::host(arguments->object, arguments->name);
    } catch (const std::invalid_argument& error) {
      fmt::print(stderr, "ikbench: {}\n", error.what());  // one line: the parent reads the last
      throw CLI::RuntimeError(1);
    }
  });
}

}  // namespace ikbench::cli
