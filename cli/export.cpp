// ikbench export: writes a store's solves for other programs.
#include "results/export.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "base/files.hpp"
#include "base/names.hpp"
#include "cli/console.hpp"
#include "cli/options.hpp"
#include "experiments/known_answers.hpp"
#include "experiments/stored_checks.hpp"
#include "experiments/targets.hpp"
#include "results/fingerprint.hpp"
#include "results/merge.hpp"
#include "results/store.hpp"

namespace ikbench::cli {

namespace {

// Writes a store into one file, after the solves were checked, and returns the digest (seal) that the file has.
std::string write_archive(const std::filesystem::path& store, const std::filesystem::path& file) {
  const TemporaryFolder folder(std::filesystem::absolute(file).parent_path(), file);
  const std::filesystem::path merged = folder.path() / "store.sqlite";
  for (const std::string& reason : merge(merged, {store}, answer_check).skipped) print_message("left out: " + reason);
  std::string seal;
  {
    Store archive(merged, Store::Mode::write_shared);
    const std::int64_t session = archive.begin_session({});  // begins before the seal, which covers sessions
    seal = seal_of(archive);
    archive.add_to_session(session, {{std::string(seal_fact), seal}});
  }
  write_through(file, [&](const Write& write) {
    base::read_in_parts(merged, [&](std::string_view part) {
      write(part);
      return true;
    });
  });
  return seal;
}

}  // namespace

void add_export(const Command& command, Invocation&) {
  struct Arguments {
    std::string store, study, format = "csv", file = "-";
  };
  auto arguments = std::make_shared<Arguments>();
  command.add("STORE", &arguments->store, "path of a store.sqlite").required();
  add_study_option(command, arguments->study);
  command
      .add(
          "--format", &arguments->format,
          "csv: one row per solve; targets: one row per target, for solvers elsewhere; answers: one row per answer, where "
          "solvers give several; fingerprint: a hash of all results "
          "except times; archive: one file with its seal, a hash of all its content")
      .one_of({"csv", "targets", "answers", "fingerprint", "archive"});
  add_out_option(command, arguments->file, "file to write; - for standard output");
  command.footer(
      "  ikbench export out/slim2023/store.sqlite > solves.csv\n"
      "  ikbench export out/slim2023/store.sqlite --format fingerprint\n"
      "  ikbench export out/mine/store.sqlite --format targets > targets.csv\n"
      "  ikbench export out/mine/store.sqlite --format archive -o mine.sqlite\n"
      "Columns: ikbench list columns");
  command.callback([arguments] {
    if (arguments->format == "archive") {
      if (arguments->file == "-") throw std::invalid_argument("--format archive needs -o FILE, such as -o mine.sqlite");
      if (!arguments->study.empty())
        throw std::invalid_argument("an archive has all studies of its store; give no --study");
      fmt::print("{}: seal {}\n", printable(base::one_line(arguments->file)),
                 write_archive(arguments->store, arguments->file));
      return;
    }
    const Store store(arguments->store, Store::Mode::read);
    const StoredStudy study = store.study(arguments->study);
    const auto write_out = [&](const Contents& contents) {
      if (arguments->file != "-") return write_through(arguments->file, contents);
      // main checks standard output for all commands.
      contents([](std::string_view part) { std::fwrite(part.data(), 1, part.size(), stdout); });
    };
    if (arguments->format == "fingerprint") {
      const auto found = fingerprint(store, study);
      return write_out([&](const Write& write) {
        write(fmt::format("{}  {}  {}\n", found.text, found.solves, printable(study.name)));
      });
    }
    if (arguments->format == "targets") {
      store.in_snapshot(
          [&] { write_out([&](const Write& write) { experiments::write_targets(store, study, write); }); });
      return;
    }
    if (arguments->format == "answers") {
      store.in_snapshot(
          [&] { write_out([&](const Write& write) { experiments::write_answers(store, study, write); }); });
      return;
    }
    store.in_snapshot([&] {
      const std::vector<std::string> extras = store.extra_names(study);
      const SolveSource pass = [&](const SolveVisitor& take) { store.for_each_in_study(study, take); };
      write_out([&](const Write& write) { write_csv(pass, write, extras); });
    });
  });
}

}  // namespace ikbench::cli
