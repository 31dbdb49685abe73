// ikbench reproduce: every study of a paper in one store, the interpretations, with one report.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>

#include "analysis/inference/make_study.hpp"
#include "analysis/papers.hpp"
#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/multiverse.hpp"
#include "cli/plan_options.hpp"
#include "cli/reporting.hpp"
#include "experiments/runner.hpp"
#include "experiments/study_reader.hpp"
#include "experiments/study_writer.hpp"
#include "results/fingerprint.hpp"

namespace ikbench::cli {

using namespace results;
using namespace experiments;
using namespace report;

namespace {

// The fingerprint of a study, and the reference that every machine should give; empty if there is none for this seed
// and number of runs.
struct Fingerprints {
  std::string study, ours, reference;
};

Fingerprints fingerprints_of(const Store& store, const std::string& name) {
  const bool is_as_built_in = store.study(name).definition == to_json(load_study(name));
  return {.study = name,
          .ours = fingerprint(store, store.study(name)).text,
          .reference = std::string(is_as_built_in ? reference_fingerprint(name) : "")};
}

report::Json json_of(const std::vector<Fingerprints>& all) {
  report::Json rows = report::Json::array();
  for (const auto& [study, ours, reference] : all) {
    rows.push_back({{"study", study},
                    {"fingerprint", ours},
                    {"reference", reference.empty() ? report::Json(nullptr) : report::Json(reference)},
                    {"is_equal", reference.empty() ? report::Json(nullptr) : report::Json(ours == reference)}});
  }
  return rows;
}

// Says how many equal their reference and which differ; with `is_verbose`, also each fingerprint.
std::vector<std::string> words_on(const std::vector<Fingerprints>& all, bool is_verbose) {
  std::vector<std::string> lines, different;
  std::size_t compared = 0;
  for (const auto& [study, ours, reference] : all) {
    compared += reference.empty() ? 0 : 1;
    if (!reference.empty() && ours != reference) different.push_back(study);
    if (is_verbose) {
      lines.push_back(fmt::format("Fingerprint of {}: {}, {}", study, ours,
                                  reference.empty()   ? "no reference for this seed and number of runs"
                                  : ours == reference ? "equal to the reference"
                                                      : "different from the reference " + reference));
    }
  }
  const std::size_t without = all.size() - compared;
  lines.insert(lines.begin(),
               compared == 0
                   ? "Fingerprints: no reference for this seed and number of runs"
                   : fmt::format("Fingerprints: {} of {} equal the reference{}{}{}", compared - different.size(),
                                 compared, different.empty() ? "" : "; different: ", fmt::join(different, ", "),
                                 without == 0 ? "" : fmt::format("; {} have none for this number of runs", without)));
  return lines;
}

// Prints the paper's table of results from its first study; with --verbose also the other tables of its first
// `solved` studies, except those already `shown`.
void show_tables(const Store& store, const Paper& paper, std::size_t solved, const OutputArguments& output,
                 std::set<std::string>& shown) {
  if (output.is_json || (!output.is_verbose && solved > 1)) return;
  std::vector<inference::JudgedStudy> studies;
  for (std::size_t i = 0; i < solved; ++i) {
    const std::string& name = paper.studies[i].name;
    studies.emplace_back(inference::read_study(store, store.study(name)));
  }
  const StudyPieces pieces = pieces_of({studies.front(), {studies.begin() + 1, studies.end()}}, paper);
  std::vector<std::string> names{pieces.results};
  const auto sections = output.is_verbose ? paper.sections.further : std::vector<SectionPlan>();
  for (const SectionPlan& section : sections) {
    std::ranges::copy(section.names, std::back_inserter(names));
    std::ranges::copy(section.folded, std::back_inserter(names));
  }
  for (const std::string& name : names) {
    const auto table = std::ranges::find(pieces.tables, name, &Table::name);
    if (table == pieces.tables.end() || !shown.insert(name).second) continue;
    show_screen({{.items = {"", wrapped(numbered_caption(*table))}}, table_rows(*table, output, 0), {.items = {""}}},
                output, ", and the report will have it");
  }
}

// The paper's studies, each with the overrides that it takes.
std::vector<std::pair<std::string, Overrides>> studies_of(const Paper& paper, const Overrides& of_all,
                                                          const std::string& runs) {
  std::vector<std::pair<std::string, Overrides>> studies;
  for (const PaperStudy& study : paper.studies) {
    Overrides& overrides = studies.emplace_back(study.name, of_all).second;
    if (study.takes_runs) overrides.push_back(runs);
  }
  return studies;
}

struct Arguments {
  std::string paper;
  std::int64_t seed = 1;
  int runs = 20;
  int seeds = 3;
  bool is_quick = false;
  RunArguments run;
  ReportArguments report;
};

// Adds claims over the smaller set of interpretations, as tables and a figure.
void add_small_multiverse(WrittenReport& wanted, const std::string& name, const Paper& paper,
                          const SolvedMultiverse& solved) {
  MultiverseReport report = paper.multiverse(solved.multiverse, solved.plan);
  std::vector<std::string>& notes = report.tables.front().notes;
  for (const ClaimShares& claim : report.claims) notes.push_back(claim.sentence);
  notes.insert(notes.end(), report.sentences.begin(), report.sentences.end());
  notes.push_back(fmt::format("This is the small multiverse, of {} dimensions; `ikbench multiverse {}` varies more.",
                              solved.multiverse.dimensions.size(), name));
  for (Table& table : report.tables) wanted.tables.push_back(std::move(table));
  for (figures::Figure& figure : report.figures) wanted.figures.push_back(std::move(figure));
  wanted.shares = std::move(report.claims);
}

// Solves the interpretations. It measures no time, so all processors may work. False if it was stopped.
bool solve_besides(const Arguments& arguments, const Paper& paper, WrittenReport& wanted) {
  if (arguments.is_quick || arguments.seeds == 0 || !paper.multiverse) return true;
  const std::string& first = wanted.study;
  const int jobs = std::max(arguments.run.jobs, static_cast<int>(std::max(1u, std::thread::hardware_concurrency())));
  CancelOnSignal signals;
  const auto solved =
      solved_multiverse(first, within(Scope::small, dimensions(first)),
                        {.seeds = arguments.seeds, .overrides = {fmt::format("runs={}", arguments.runs)}},
                        {"multiverse", wanted.folder, jobs, &signals.requested()});
  if (!solved) return false;
  add_small_multiverse(wanted, first, paper, *solved);
  return !signals.end();
}

// True if an option applies to a paper.
bool takes(const Paper& paper, std::string_view option) {
  if (option == "--readings") return bool(paper.multiverse);
  return std::ranges::any_of(paper.studies, &PaperStudy::takes_runs);
}

// Names the papers that the option applies to, for its help.
std::string papers_with(std::string_view option) {
  std::vector<std::string> names;
  for (const Paper& each : analysis::papers()) {
    if (takes(each, option)) names.push_back(each.name);
  }
  return fmt::format("{}: ", fmt::join(names, ", "));
}

void refuse_others(const CLI::App& command, const Paper& paper) {
  for (const char* option : {"--runs", "--readings"}) {
    if (command.count(option) == 0 || takes(paper, option)) continue;
    throw std::invalid_argument(
        fmt::format("{} is not an option of {}; leave it out (of one study: ikbench run {} --set runs=10)", option,
                    paper.name, paper.studies.front().name));
  }
}

}  // namespace

void add_reproduce(CLI::App& app, Invocation& invocation) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      app.add_subcommand("reproduce", "Repeat the experiments of a paper and report beside the printed results");
  add_paper_option(*command, arguments->paper, [](const Paper&) { return true; });
  add_run_options(*command, arguments->run);
  command->add_option("--seed", arguments->seed, "seed of the studies")->check(whole_number())->capture_default_str();
  command->add_option("--runs", arguments->runs, papers_with("--runs") + "runs of each solver on the helix")
      ->check(whole_number({1, 1'000'000}))
      ->capture_default_str();
  command
      ->add_option("--readings", arguments->seeds,
                   papers_with("--readings") + "number of seeds for the multiverse of the interpretations; 0: skip it")
      ->check(whole_number({0, 1000}))
      ->capture_default_str();
  command->add_flag("--quick", arguments->is_quick, "skip the interpretations");
  add_report_options(*command, arguments->report);
  command->footer(
      "Examples:\n"
      "  ikbench reproduce\n"
      "  ikbench reproduce beeson2015             TRAC-IK's table of solve rates\n"
      "  ikbench reproduce --seed 2 --out out/seed-2\n"
      "  ikbench reproduce --quick                faster: skip the interpretations\n"
      "  ikbench reproduce --jobs 2               faster: two solves at once, but times are not comparable");
  command->callback([arguments, command, &invocation] {
    refuse_points(arguments->report);
    static_cast<void>(styled({}, arguments->report));  // a mistake in it shows before hours are spent
    const Paper& paper = analysis::paper(arguments->paper);
    refuse_others(*command, paper);
    const std::string& first = paper.studies.front().name;
    const std::filesystem::path folder =
        arguments->run.out.empty() ? default_folder(first) : std::filesystem::path(arguments->run.out);
    const auto studies =
        studies_of(paper, {fmt::format("seed={}", arguments->seed)}, fmt::format("runs={}", arguments->runs));
    const RunRequest request{.jobs = arguments->run.jobs, .command = invocation.command};
    const auto is_stopped = [&](const Study& study) {
      if (run_and_tell(study, folder, request, arguments->report.output) != Ended::stopped) return false;
      invocation.exit_code = cancelled_exit_code();
      return true;
    };
    std::set<std::string> shown;
    for (std::size_t i = 0; i < studies.size(); ++i) {
      const auto& [name, overrides] = studies[i];
      if (is_stopped(load_study(name, overrides))) return;
      if (i == 0 || i + 1 == studies.size()) {
        show_tables(checked_store(store_in(folder)), paper, i + 1, arguments->report.output, shown);
      }
    }
    WrittenReport wanted{.study = first, .folder = folder, .arguments = arguments->report};
    if (!solve_besides(*arguments, paper, wanted)) {
      say("Stopped before the report. The solves are kept; run the same command again to continue.");
      invocation.exit_code = cancelled_exit_code();
      return;
    }
    const EndOnSignal signals(
        "Stopped before the report was complete. All solves are kept; run the same command again to write it.");
    const Store store = checked_store(store_in(folder));
    std::vector<Fingerprints> fingerprints;
    for (const auto& [name, overrides] : studies) {
      check_is_stored(load_study(name, overrides), store);
      fingerprints.push_back(fingerprints_of(store, name));
    }
    std::ranges::move(words_on(fingerprints, arguments->report.output.is_verbose), std::back_inserter(wanted.remarks));
    wanted.data["fingerprints"] = json_of(fingerprints);
    write_and_announce(store, std::move(wanted));
  });
}

}  // namespace ikbench::cli
