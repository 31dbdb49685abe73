// Reports for the commands that read stores or tables: reads and checks solves, writes the report into a folder, and
// prints the screen or the JSON.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analysis/judge/data/study_results.hpp"
#include "cli/options.hpp"
#include "results/store.hpp"

namespace ikbench::show {
struct Report;
struct WrittenReport;
}  // namespace ikbench::show
namespace ikbench::judge {
struct JudgedStudy;
}
namespace ikbench::figures {
struct RenderOptions;
}

namespace ikbench::cli {

// The options of a report, as given on the command line.
struct ReportArguments {
  bool is_json = false;
  std::vector<std::string> figures = {};       // names; empty: all
  std::vector<std::string> styles = {};        // shipped, or files; their keys replace those of the study
  std::vector<std::string> requirements = {};  // of --require
  bool is_strict = false;                      // an inconclusive requirement fails the command
  std::string beside = {};                     // imported results: the archive, or a store; empty: none
};

// Returns the names of figures, and the keys of their look.
std::string figure_list_text();
// Adds the options of a report; --beside only if the report is of a study.
void add_report_options(const Command& command, ReportArguments& arguments, bool is_of_study = false);
// Returns the study's style with the styles of --style applied in their order. Throws std::invalid_argument if a
// figure, a solver or a font is not known. Commands that solve call this function first, because solving may take
// hours.
results::FigureStyle apply_style(results::FigureStyle style, const std::vector<std::string>& labels,
                                 const ReportArguments& arguments);
// Returns the labels of the study's series, in their order.
std::vector<std::string> labels_of(const results::StoredStudy& stored);

// Judges a study with the results of --beside, and checks the requirements of the command, otherwise those of the
// study.
judge::JudgedStudy judge_with_requirements(judge::StudyResults results, const results::StoredStudy& study,
                                           const ReportArguments& arguments,
                                           const std::optional<judge::StudyResults>& beside = {});
// Prints which solvers gave no answer in any solve, for JSON on standard error; returns false if there are none.
bool print_never_answering(const judge::StudyResults& results, bool is_json);
// Writes a report with a progress bar of the figures, and prints the warnings. `write` gets the options.
show::WrittenReport write_with_progress(
    const ReportArguments& arguments, const results::FigureStyle& style,
    const std::function<show::WrittenReport(const figures::RenderOptions& options)>& write);

// Returns the keys of docs/references.bib whose keywords name this solver, arm or paper.
std::vector<std::string> citation_keys_of(std::string_view name);
// Writes the report into the folder, and prints JSON or `screen`. An empty `screen` stands for the report's own.
void write_and_print(show::Report report, const std::filesystem::path& folder, const ReportArguments& arguments,
                     const results::FigureStyle& style, const std::string& screen = {});
// Returns the results that --beside names; nullopt if the option is not given. Throws std::invalid_argument if the
// results are of a different study.
std::optional<judge::StudyResults> imported_results(const results::StoredStudy& study,
                                                    const ReportArguments& arguments);
// Writes the report of a study in the store, and prints its screen or JSON. Returns the exit code: 3 if a solver gave
// no answer in any solve, after a message that names the solvers; otherwise the code of the requirements.
int write_and_announce(const results::Store& store, const results::StoredStudy& study,
                       const std::filesystem::path& folder, const ReportArguments& arguments,
                       const std::optional<judge::StudyResults>& beside);

// Prints the judged study as JSON, and writes nothing. Returns the exit code as above.
int show_answer(const results::Store& store, const results::StoredStudy& study, const ReportArguments& arguments,
                const std::optional<judge::StudyResults>& beside);
// Checks the requirements of the command or the study, and prints a sentence per check. Returns the exit code as above.
// Call it where no report is written.
int check_requirements_only(const results::Store& store, const results::StoredStudy& study,
                            const ReportArguments& arguments, const std::optional<judge::StudyResults>& beside);
// Throws std::invalid_argument if a text of --require is not a requirement, or names a label or a share that the study
// does not have.
void refuse_wrong_requirements(const ReportArguments& arguments, const results::StudySpec& study,
                               const std::vector<std::string>& labels);

// Reads a study, checks each solve by experiments/stored_checks.hpp, and passes the solve on to `also`. Throws
// std::invalid_argument if a check fails, or if the study's solvers have no solve in the store.
judge::StudyResults read_checked(const results::Store& store, const results::StoredStudy& entry,
                                 const results::SolveVisitor& also = {});
// Reads a study as read_checked does, and writes the solves into solves.csv of the report's folder.
judge::StudyResults read_and_export(const results::Store& store, const results::StoredStudy& entry,
                                    const std::filesystem::path& folder);

}  // namespace ikbench::cli
