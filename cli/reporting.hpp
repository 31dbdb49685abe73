// Shared by `reproduce`, `run` and `report`: options, writing and announcement of a report.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/inference/metrics.hpp"
#include "analysis/report/claims.hpp"
#include "analysis/report/paper.hpp"
#include "analysis/report/report.hpp"
#include "analysis/report/table.hpp"
#include "cli/screen.hpp"
#include "experiments/runner.hpp"
#include "experiments/study_reader.hpp"
#include "results/figure_style.hpp"
#include "results/store.hpp"

namespace ikbench::cli {

// Refuses an empty folder name: it comes from an unset variable of a script.
CLI::Validator not_empty();

// Adds PAPER, the name of a paper; the first by default. The help names the offered ones.
void add_paper_option(CLI::App& command, std::string& paper, bool (*is_offered)(const report::Paper& of));

struct ReportArguments {
  std::string unit = {};    // replaces the study's
  int quartiles = 0;        // replaces the study's; 0: not given
  double significance = 0;  // replaces the study's; 0: not given
  bool forced = false;      // points of a run may be observations
  bool without_figures = false;
  std::string style = {};  // a file; its keys replace those of the study's [figures]
  OutputArguments output = {};
};

void add_report_options(CLI::App& command, ReportArguments& arguments);
// Reads the style file, if there is one. Call it before anything is solved.
results::FigureStyle styled(results::FigureStyle style, const ReportArguments& arguments);
// Throws std::invalid_argument if points are to be observations and --force is not given. Call it before anything is
// solved.
void refuse_points(const ReportArguments& arguments);

// Throws std::invalid_argument if the folder has the report of a reproduction, which also has interpretations that no
// store of the study holds. Call it before anything is solved.
void refuse_reproduction(const std::filesystem::path& folder);

// A report to write: its study, its place, and a command's additions to it.
struct WrittenReport {
  std::string study;
  std::filesystem::path folder;
  ReportArguments arguments = {};
  std::vector<std::string> remarks = {};       // printed after the results
  report::Json data = report::Json::object();  // printed with the verdict as JSON
  std::vector<report::Table> tables = {};
  std::vector<figures::Figure> figures = {};
  std::vector<report::ClaimShares> shares = {};
  bool tells_of_further = false;  // says which studies of the store it is not about
};

// Writes tables, figures, report.md and report.html into the folder; prints the verdict, the claims or the results, the
// remarks and, as the last line, the path of report.html.
void write_and_announce(const results::Store& store, WrittenReport wanted);

// Shows how far a report is, a bar for each step and study.
class ReportProgress {
 public:
  void show(report::ReportStep step, std::int64_t done, std::int64_t all);
  void end() { bar_.reset(); }

 private:
  std::optional<report::ReportStep> step_ = {};
  std::optional<ProgressBar> bar_ = {};
};

// Writes figures into the folder, draws them, with the program's name in them, and warns of those that were not drawn.
void draw(const std::vector<figures::Figure>& figures, const std::filesystem::path& folder,
          figures::RenderOptions options);

// Opens a store for reading, and checks the errors of all solves that are read (experiments/recheck.hpp).
results::Store checked_store(const std::filesystem::path& file);

// The study of that name, or the store's first if the name is empty.
results::StudyEntry chosen_study(const results::Store& store, const std::string& name);

// Adds --set and --sweep, which change the study.
void add_overrides(CLI::App& command, experiments::Overrides& overrides);

struct RunArguments {
  std::string out;
  int jobs = 1;
};

void add_run_options(CLI::App& command, RunArguments& arguments);

// Warns on standard error of unreachable targets, if there are any.
void warn_of_unreachable(const experiments::Study& study);

enum class Ended { complete, stopped };

// Counts what was solved into a store, to be told after the verdict of its report.
struct Solved {
  std::string study;  // the last one
  int studies = 0;
  std::int64_t solves = 0, reused = 0;

  std::string words(const std::filesystem::path& store) const;  // "six: 288 solves in out/six/store.sqlite"
};

// Runs a study into the folder's store.sqlite, opened in this mode, with progress. Warns of targets out of reach, and
// says after Ctrl-C how to continue.
Ended run_study(const experiments::Study& study, const std::filesystem::path& folder, experiments::RunRequest request,
                Solved& solved, results::Store::Mode mode = results::Store::Mode::write);
// The same, and says what was solved.
Ended run_and_tell(const experiments::Study& study, const std::filesystem::path& folder,
                   experiments::RunRequest request, const OutputArguments& output,
                   results::Store::Mode mode = results::Store::Mode::write);

Tone tone_of(report::Verdict verdict);
Tone tone_of(inference::Relation relation);  // of the first

std::filesystem::path store_in(const std::filesystem::path& folder);

}  // namespace ikbench::cli
