// What commands share: checks of options, running a study, writing and announcement of a report.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "analysis/judge/study.hpp"
#include "analysis/papers/multiverse.hpp"
#include "analysis/show/report.hpp"
#include "base/json.hpp"
#include "cli/commands.hpp"
#include "experiments/multiverse.hpp"
#include "experiments/runner.hpp"
#include "results/figure_style.hpp"
#include "results/store.hpp"

namespace ikbench::cli {

// Checks of options, and JSON as an answer.

// Accepts a decimal number in the range: CLI11 accepts more texts as numbers.
CLI::Validator number_in(std::pair<double, double> range);

constexpr std::int64_t largest_whole = 999'999'999'999'999'999;
// Accepts numbers in the range, written in decimal digits only: CLI11 alone reads 010 as 8 and takes what is too large
// for the largest.
CLI::Validator whole_number(std::pair<std::int64_t, std::int64_t> range = {0, largest_whole});

// Refuses an empty folder name: it comes from an unset variable of a script.
CLI::Validator not_empty();

void add_json_option(CLI::App& command, bool& is_json);
void show_json(const base::OrderedJson& json);

// Adds --study, the name of one of a store.
void add_study_option(CLI::App& command, std::string& study);
// Adds PAPER, the name of a paper; the first by default.
void add_paper_option(CLI::App& command, std::string& paper);

struct ReportArguments {
  bool is_json = false;
  std::vector<std::string> figures = {};  // names; empty: all
  std::string style = {};                 // shipped, or a file; its keys replace those of the study
};

// The names of figures, and the keys of their look.
std::string list_of_figures();
void add_report_options(CLI::App& command, ReportArguments& arguments);
struct Style {
  results::FigureStyle figures = {};
  results::TableStyle tables = {};
};
// Of a study of these labels, with the style file, if there is one. Throws std::invalid_argument for what cannot be
// drawn. Call it before anything is solved.
Style styled(Style style, const std::vector<std::string>& labels, const ReportArguments& arguments);
// The same of a stored study.
Style styled(const results::StoredStudy& entry, const ReportArguments& arguments);
std::vector<std::string> labels_of(const results::StoredStudy& stored);
// Throws std::invalid_argument if the plan names no metric. Call it before anything is solved.
void check_plan(const experiments::Study& study);

// The keys of docs/references.bib whose keywords name a solver, an arm or a paper.
std::vector<std::string> references_of(std::string_view name);
// Writes the report into the folder, and prints its screen (the study's, if it is empty) or JSON.
void announce(show::Report reported, const std::filesystem::path& folder, const ReportArguments& arguments,
              const Style& style, const std::string& screen = {});
// The report of a study of the store, written and announced.
void write_and_announce(const results::Store& store, const results::StoredStudy& study,
                        const std::filesystem::path& folder, const ReportArguments& arguments);

// Reads a study, computes the errors of all its solves again (experiments/runner.hpp), and passes each on to `also`.
judge::StudyResults checked_study(const results::Store& store, const results::StoredStudy& entry,
                                  const results::TakeSolve& also = {});
// The same, and writes the solves into the folder's solves.csv, which belongs to its report.
judge::StudyResults exported_study(const results::Store& store, const results::StoredStudy& entry,
                                   const std::filesystem::path& folder);

struct RunArguments {
  std::string out;
  int jobs = 1;
};

void add_run_options(CLI::App& command, RunArguments& arguments);

// Runs a study, and its stored_study, into the folder's store.sqlite, opened in this mode, with progress, and warns of
// targets out of reach. Returns "six: 288 solves in out/six/store.sqlite"; after Ctrl-C it says how to continue, and
// throws Cancelled.
std::string run_study(const experiments::Study& study, const results::StoredStudy& stored,
                      const std::filesystem::path& folder, experiments::RunRequest request,
                      results::Store::Mode mode = results::Store::Mode::write);

// Solves all combinations of what a paper leaves open, with progress. After Ctrl-C it says so, and
// throws Cancelled: shares need all readings.
papers::SolvedMultiverse solved_multiverse(const std::string& study, const std::vector<results::Dimension>& varied,
                                           experiments::MultiverseRequest request, int jobs);

// Writes and draws a figure, and warns if it was not drawn.
void draw(const figures::Figure& figure, const std::filesystem::path& folder, const figures::RenderOptions& options);
std::filesystem::path store_in(const std::filesystem::path& folder);

}  // namespace ikbench::cli
