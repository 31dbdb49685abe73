// ikbench import: adds somebody else's solves to those of a study, in one store and one report.
#include "experiments/import.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/reporting.hpp"
#include "experiments/foreign/program.hpp"
#include "results/csv.hpp"
#include "results/files.hpp"

namespace ikbench::cli {

using namespace results;
using namespace experiments;
using namespace report;

namespace {

std::string words_on(const ImportedSolver& solver) {
  std::string words = fmt::format("{}: {} solves", solver.label, solver.solves);
  if (solver.is_stored_already) words += ", which were in the store already";
  const int not_verified = solver.solves - solver.verified - solver.without_answer;
  words += fmt::format("; {} verified, {} not verified", solver.verified, not_verified);
  if (solver.without_answer > 0) words += fmt::format(", {} without an answer", solver.without_answer);
  if (solver.largest_mistake_cm > 0) {
    words += fmt::format("; the errors in the file are up to {:.2g} cm from those of its answers, which count",
                         solver.largest_mistake_cm);
  }
  return words;
}

report::Json json_of(const ImportedSolver& solver) {
  return {{"solver", solver.label},
          {"solves", solver.solves},
          {"verified", solver.verified},
          {"without_answer", solver.without_answer},
          {"is_stored_already", solver.is_stored_already},
          {"largest_mistake_cm", json_number(solver.largest_mistake_cm)}};
}

std::string text_in(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file))
    throw std::invalid_argument(fmt::format("cannot read {}; expected a CSV of solves", file.string()));
  return csv_text(stream, file.filename().string());
}

}  // namespace

void add_import(CLI::App& app, Invocation& invocation) {
  struct Arguments {
    std::string file, out, study, label;
    ReportArguments report;
    bool without_report = false;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand(
      "import", "Put somebody else's solves of a study's targets beside its own, and write its report");
  command->add_option("FILE", arguments->file, "CSV with a row for each solve")->required();
  command->add_option("--out", arguments->out, "folder of the study's results, which ikbench run has made")->required();
  command->add_option("--study", arguments->study, "name of the study; default: the first in the store");
  command->add_option("--label", arguments->label,
                      "name of the solver, where the file has no column `solver`; default: the file's name");
  add_report_options(*command, arguments->report);
  command->add_flag("--no-report", arguments->without_report, "import, but write no report");
  command->footer(
      "Columns: run, point; answer_rad_1 ... (or answer_deg_1 ...), one for each joint, or position_error_cm; and where\n"
      "they are known solver, orientation_error_deg, evaluations, seconds. Of a joint that slides, metres.\n"
      "With answers the errors are computed here, and the solves are verified. With errors alone they are told as not\n"
      "verified, and none counts as solved. A row with neither is of a solver that gave no answer.\n"
      "Examples:\n"
      "  ikbench run my.toml                                   the study, with some solvers\n"
      "  ikbench export out/my/store.sqlite > targets.csv      its targets: target_position_m_1 ..., target_rotation_1 ...\n"
      "  ikbench import mine.csv --label mine --out out/my     your solves of them, beside the others\n"
      "mine.csv of an arm with two joints:\n"
      "  run,point,answer_deg_1,answer_deg_2,seconds\n"
      "  1,1,30.25,-12.5,0.0021\n"
      "  1,2,31.5,-11.75,0.0019");
  command->callback([arguments, &invocation] {
    refuse_points(arguments->report);
    const std::filesystem::path folder = arguments->out, place = store_in(folder), file = arguments->file;
    if (!std::filesystem::exists(place)) {
      throw std::invalid_argument(
          fmt::format("there is no {}; expected --out to be the folder of a study: ikbench run STUDY --out {}",
                      place.string(), folder.string()));
    }
    const std::string text = text_in(file);
    Store store(place, Store::Mode::write);
    const std::string study = chosen_study(store, arguments->study).name;
    // Refuses a damaged study: the import is verified by its targets and its definition, which are saved anew.
    if (const std::vector<std::string> damages = damages_of(store, study); !damages.empty())
      throw std::invalid_argument(fmt::format("'{}': {}", place.string(), fmt::join(damages, " ")));
    const Imported imported =
        import_solves(store, {.study = study,
                              .source = file.filename().string(),
                              .text = text,
                              .digest = digest_of_text(text),
                              .label = arguments->label.empty() ? file.stem().string() : arguments->label,
                              .command = invocation.command});
    store.finish();
    if (!imported.unread.empty())
      warn(fmt::format("columns that are not imported: {}", fmt::join(imported.unread, ", ")));
    report::Json data{{"imported", report::Json::array()}};
    std::vector<std::string> said;
    for (const ImportedSolver& solver : imported.solvers) {
      data["imported"].push_back(json_of(solver));
      said.push_back(words_on(solver));
    }
    if (!arguments->without_report) {
      write_and_announce(store, {.study = study,
                                 .folder = folder,
                                 .arguments = arguments->report,
                                 .remarks = std::move(said),
                                 .data = std::move(data)});
    } else if (arguments->report.output.is_json) {
      show_json(data);
    } else {
      for (const std::string& words : said) fmt::print("{}\n", wrapped(words));
    }
  });
}

}  // namespace ikbench::cli
