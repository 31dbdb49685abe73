// ikbench check-solver: checks a program for its author before a study runs it.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/options.hpp"
#include "experiments/foreign/check.hpp"

namespace ikbench::cli {

using namespace experiments;

void add_check_solver(CLI::App& app, Invocation& invocation) {
  struct Arguments {
    std::vector<std::string> words;
    double patience = 5;
    bool is_json = false;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("check-solver", "Check a solver that is a program");
  command->add_option("COMMAND", arguments->words, "the program and its arguments, after --")->required();
  command->add_option("--patience", arguments->patience, "seconds after which a solve is given up")
      ->check(CLI::Range(0.1, 3600.0))
      ->capture_default_str();
  add_json_option(*command, arguments->is_json);
  command->footer(
      "Examples:\n"
      "  ikbench check-solver -- python3 my_solver.py\n"
      "  ikbench check-solver --patience 60 -- octave-cli --quiet my_solver.m\n\n"
      "Exit code 1 where a check fails. docs/solvers-in-any-language.md describes what a program has to say.");
  command->callback([arguments, &invocation] {
    std::vector<std::string> failed;
    numerics::OrderedJson all = numerics::OrderedJson::array();
    check_program({.process = arguments->words, .patience = arguments->patience}, [&](const CheckLine& line) {
      all.push_back({{"check", line.what}, {"passed", line.passed}, {"seen", line.seen}});
      if (!line.passed) failed.push_back(line.what);
      if (arguments->is_json) return;
      constexpr std::size_t length_of_state = 8;
      const std::string text = wrapped(fmt::format("{}{}{}", line.what, line.seen.empty() ? "" : ": ", line.seen),
                                       text_width() - length_of_state);
      fmt::print("{}{}\n", line.passed ? coloured("ok      ", Tone::good) : coloured("FAILED  ", Tone::bad), text);
      std::fflush(stdout);
    });
    if (!failed.empty()) invocation.exit_code = 1;
    if (arguments->is_json) return show_json(all);
    const std::string verdict =
        failed.empty() ? fmt::format("All {} checks passed", all.size())
                       : fmt::format("{} of {} checks failed: {}", failed.size(), all.size(), fmt::join(failed, "; "));
    fmt::print("\n{}\n{}\n", coloured(wrapped(verdict + '.'), failed.empty() ? Tone::good : Tone::bad),
               wrapped("They ask for positions. Whole poses (search = \"pose\") are not checked."));
  });
}

}  // namespace ikbench::cli
