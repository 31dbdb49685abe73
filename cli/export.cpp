// ikbench export: a store's solves as tidy CSV or JSON.
#include "results/export.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "cli/commands.hpp"
#include "cli/reporting.hpp"
#include "results/files.hpp"
#include "results/store.hpp"

namespace ikbench::cli {

using namespace results;
using namespace experiments;
using namespace report;

void add_export(CLI::App& app) {
  struct Arguments {
    std::string store, study, format = "csv", file = "-";
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("export", "Write the solves of a store as tidy CSV or JSON");
  command->add_option("STORE", arguments->store, "path of a store.sqlite")->required();
  command->add_option("--study", arguments->study, "name of the study; default: the first in the store");
  command->add_option("--format", arguments->format, "csv or json")
      ->check(CLI::IsMember({"csv", "json"}))
      ->capture_default_str();
  command->add_option("-o,--output", arguments->file, "file to write; - for standard output")->capture_default_str();
  command->footer(
      "Examples:\n"
      "  ikbench export out/slim2023/store.sqlite > solves.csv\n"
      "  ikbench export out/slim2023/store.sqlite --format json -o solves.json\n"
      "Columns: ikbench list columns");
  command->callback([arguments] {
    const Store store(arguments->store, Store::Mode::read);
    const StudyEntry study = chosen_study(store, arguments->study);
    const std::vector<SolveRecord> solves = store.solves(study.name);
    const std::string text = arguments->format == "csv" ? to_csv(solves) : to_json(study, store.sessions(), solves);
    if (arguments->file == "-") {
      std::fwrite(text.data(), 1, text.size(), stdout);  // main sees whether it could be written
    } else {
      for (const char* part : {"", "-wal", "-shm", "-journal"}) {
        std::error_code error;
        if (!std::filesystem::equivalent(arguments->file, arguments->store + part, error)) continue;
        throw std::invalid_argument(
            fmt::format("-o {} is the store itself or part of it; choose another file", arguments->file));
      }
      write_file(arguments->file, text);
    }
  });
}

}  // namespace ikbench::cli
