// ikbench export: a store's solves for other programs.
#include "results/export.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/reporting.hpp"
#include "results/files.hpp"
#include "results/fingerprint.hpp"
#include "results/store.hpp"

namespace ikbench::cli {

using namespace results;
using namespace experiments;

namespace {

// One hash of a study's results, to check that two stores agree bit for bit.
constexpr std::string_view fingerprint_format = "fingerprint";

}  // namespace

void add_export(CLI::App& app, Invocation&) {
  struct Arguments {
    std::string store, study, format = "csv", file = "-";
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("export", "Write all solves as CSV or JSON, or for other programs");
  command->add_option("STORE", arguments->store, "path of a store.sqlite")->required();
  command->add_option("--study", arguments->study, "name of the study; default: the first in the store");
  std::vector<std::string> names, meanings;
  for (const ExportFormat& format : export_formats()) {
    names.emplace_back(format.name);
    meanings.push_back(fmt::format("{}: {}", format.name, format.meaning));
  }
  names.emplace_back(fingerprint_format);
  meanings.push_back(fmt::format("{}: a hash of every bit but of times", fingerprint_format));
  command->add_option("--format", arguments->format, fmt::format("{}", fmt::join(meanings, "; ")))
      ->check(CLI::IsMember(names))
      ->capture_default_str();
  command->add_option("-o,--output", arguments->file, "file to write, or new folder; - for standard output")
      ->capture_default_str();
  command->footer(
      "Examples:\n"
      "  ikbench export out/slim2023/store.sqlite > solves.csv\n"
      "  ikbench export out/slim2023/store.sqlite --format json -o solves.json\n"
      "  ikbench export out/slim2023/store.sqlite --format iohprofiler -o ioh\n"
      "  ikbench export out/slim2023/store.sqlite --format fingerprint\n"
      "Columns: ikbench list columns");
  command->callback([arguments] {
    const Store store(arguments->store, Store::Mode::read);
    const StoredStudy study = chosen_study(store, arguments->study);
    if (arguments->format == fingerprint_format) {
      const auto [text, solves] = fingerprint(store, study);
      const std::string line = fmt::format("{}  {}  {}\n", text, solves, printable(study.name));
      if (arguments->file == "-") return fmt::print("{}", line);
      return write_through(arguments->file, [&](const Write& write) { write(line); });
    }
    const ExportFormat& format = export_format(arguments->format);
    if (format.write_folder && arguments->file == "-")
      throw std::invalid_argument(fmt::format("--format {} is a folder; expected -o FOLDER", format.name));
    store.at_one_moment([&] {
      const std::vector<Session> sessions = store.sessions();
      const bool has_bar = arguments->file != "-" || isatty(STDOUT_FILENO) == 0;  // else it would be among the solves
      const std::int64_t all = store.number_of_solves(study);
      const Exported exported{.study = study, .sessions = sessions, .each_solve = [&](const auto& take) {
                                std::optional<ProgressBar> bar;
                                if (has_bar) bar.emplace("writing " + study.name);
                                Progress progress{.total = all};
                                store.each_of_study(study, [&](const SolveRecord& solve) {
                                  take(solve);
                                  ++progress.done;
                                  if (bar) bar->show(progress);
                                });
                              }};
      if (format.write_folder) {
        for (const std::string& warning : format.write_folder(exported, arguments->file)) warn(warning);
      } else if (arguments->file == "-") {
        // main checks that it could be written
        format.write_text(exported, [](std::string_view part) { std::fwrite(part.data(), 1, part.size(), stdout); });
      } else {
        write_through(arguments->file, [&](const Write& write) { format.write_text(exported, write); });
      }
    });
  });
}

}  // namespace ikbench::cli
