// ikbench export: a store's solves for other programs.
#include "results/export.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <memory>
#include <optional>

#include "base/files.hpp"
#include "cli/console.hpp"
#include "cli/options.hpp"
#include "results/fingerprint.hpp"
#include "results/store.hpp"

namespace ikbench::cli {

void add_export(CLI::App& app, Invocation&) {
  struct Arguments {
    std::string store, study, format = "csv", file = "-";
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("export", "Write all solves as CSV, or their fingerprint");
  command->add_option("STORE", arguments->store, "path of a store.sqlite")->required();
  add_study_option(*command, arguments->study);
  add_with_default(*command, "--format", arguments->format,
                   "csv: a row for each solve; fingerprint: a hash of every bit but of times")
      ->check(CLI::IsMember({"csv", "fingerprint"}));
  add_out_option(*command, arguments->file, "file to write; - for standard output");
  command->footer(
      "  ikbench export out/slim2023/store.sqlite > solves.csv\n"
      "  ikbench export out/slim2023/store.sqlite --format fingerprint\n"
      "Columns: ikbench list columns");
  command->callback([arguments] {
    const Store store(arguments->store, Store::Mode::read);
    const StoredStudy study = store.study(arguments->study);
    const auto write_it = [&](const Contents& contents) {
      if (arguments->file != "-") return write_through(arguments->file, contents);
      contents([](std::string_view part) { std::fwrite(part.data(), 1, part.size(), stdout); });  // which main checks
    };
    if (arguments->format == "fingerprint") {
      const auto found = fingerprint(store, study);
      return write_it([&](const Write& write) {
        write(fmt::format("{}  {}  {}\n", found.text, found.solves, printable(study.name)));
      });
    }
    store.at_one_moment([&] {
      const bool has_bar = arguments->file != "-" || isatty(STDOUT_FILENO) == 0;  // else it would be among the solves
      const std::int64_t all = store.number_of_solves(study);
      const std::vector<std::string> extras = store.names_of_extras(study);
      const PassSolves pass = [&](const TakeSolve& take) {
        std::optional<ProgressBar> bar;
        if (has_bar) bar.emplace("writing " + study.name);
        Progress progress{.total = all};
        store.each_of_study(study, [&](const SolveRecord& solve) {
          take(solve);
          ++progress.done;
          if (bar) bar->show(progress);
        });
      };
      write_it([&](const Write& write) { write_csv(pass, write, extras); });
    });
  });
}

}  // namespace ikbench::cli
