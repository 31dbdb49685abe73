// What `reproduce`, `run` and `report` share: how a report is asked for, written and announced.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/report/claims.hpp"
#include "analysis/report/paper.hpp"
#include "analysis/report/repetitions.hpp"
#include "analysis/report/table.hpp"
#include "experiments/runner.hpp"
#include "results/store.hpp"

namespace ikbench::cli {

// A folder has a name: an empty one is a variable of a script that is not set.
CLI::Validator not_empty();

// PAPER, the name of a collection of studies; the first where none is given. The help names those that are offered.
void add_paper_option(CLI::App& command, std::string& paper, bool (*is_offered)(const report::Collection& of));

struct ReportArguments {
  std::string unit = {};    // instead of what the study says
  int quartiles = 0;        // instead of what the study says; 0: not given
  double significance = 0;  // likewise
  bool forced = false;      // points of a run may be observations
  bool without_figures = false;
};

void add_report_options(CLI::App& command, ReportArguments& arguments);
// std::invalid_argument where points are asked for as observations and nobody insists; to be called before anything is
// solved.
void refuse_points(const ReportArguments& arguments);

// Which report is written where, and what a command adds to it.
struct WrittenReport {
  std::string study;
  std::filesystem::path folder;
  ReportArguments arguments = {};
  std::vector<std::string> remarks = {};  // printed after the summary
  std::vector<report::Table> tables = {};
  std::vector<figures::Figure> figures = {};
  std::vector<report::RepeatedSolver> repetitions = {};
  std::vector<report::ClaimShares> shares = {};
};

// Writes tables, figures, report.md and report.html into the folder; prints the summary, the remarks and, as the last
// line, the path of report.html. Where the store is damaged, the report says so first, and std::invalid_argument is
// thrown after it.
void write_and_announce(const results::Store& store, WrittenReport wanted);

// Writes figures into the folder, draws them, and warns of those that were not drawn.
void draw(const std::vector<figures::Figure>& figures, const std::filesystem::path& folder,
          const figures::RenderOptions& options);

// What of a study in the store does not follow from its answers (experiments/recheck.hpp), was changed since it was
// written, or names a session that the store does not have, in sentences. Its solves are read for that, and passed on.
std::vector<std::string> damages_of(const results::Store& store, const std::string& study,
                                    const std::function<void(results::SolveRecord)>& take = {});

// The study of that name, or the first of the store where the name is empty.
results::StudyEntry chosen_study(const results::Store& store, const std::string& name);

struct RunArguments {
  std::string out;
  int jobs = 1;
};

void add_run_options(CLI::App& command, RunArguments& arguments);

// On standard error, where there are any.
void warn_of_unreachable(const experiments::Study& study);

enum class Ended { complete, stopped };

// Runs a study into the folder's store.sqlite, opened in this mode, with progress; warns of targets out of reach; says
// what was done, and after Ctrl-C how to go on.
Ended run_and_tell(const experiments::Study& study, const std::filesystem::path& folder,
                   experiments::RunRequest request, results::Store::Mode mode = results::Store::Mode::write);

std::filesystem::path store_in(const std::filesystem::path& folder);

}  // namespace ikbench::cli
