// Writing and announcement of a report, for the commands that do it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/judge/data/study_results.hpp"
#include "cli/options.hpp"
#include "results/store.hpp"

namespace ikbench::show {
struct Report;
}

namespace ikbench::cli {

struct ReportArguments {
  bool is_json = false;
  std::vector<std::string> figures = {};  // names; empty: all
  std::vector<std::string> styles = {};   // shipped, or files; their keys replace those of the study
  std::string beside = {};                // the archive, or a store; empty: nothing
};

// The names of figures, and the keys of their look.
std::string figure_list_text();
void add_report_options(const Command& command, ReportArguments& arguments, bool is_of_study = false);
// Of a study of these labels, with the style file, if there is one. Throws std::invalid_argument for what cannot be
// drawn. Call it before anything is solved.
results::FigureStyle apply_style(results::FigureStyle style, const std::vector<std::string>& labels,
                                 const ReportArguments& arguments);
std::vector<std::string> labels_of(const results::StoredStudy& stored);

// The keys of docs/references.bib whose keywords name a solver, an arm or a paper.
std::vector<std::string> citation_keys_of(std::string_view name);
// Writes the report into the folder, and prints its screen (the study's, if it is empty) or JSON.
void write_and_print(show::Report reported, const std::filesystem::path& folder, const ReportArguments& arguments,
                     const results::FigureStyle& style, const std::string& screen = {});
// What stands beside a study; none if nothing does. Throws std::invalid_argument if it is of another.
std::optional<judge::StudyResults> imported_results(const results::StoredStudy& study,
                                                    const ReportArguments& arguments);
// The report of a study of the store, written and announced. Says first which solvers gave no answer in any solve, and
// returns whether there are such.
bool write_and_announce(const results::Store& store, const results::StoredStudy& study,
                        const std::filesystem::path& folder, const ReportArguments& arguments,
                        const std::optional<judge::StudyResults>& beside);

// Prints the answer of a study of the store as JSON, without a report; returns as write_and_announce does.
bool show_answer(const results::Store& store, const results::StoredStudy& study,
                 const std::optional<judge::StudyResults>& beside);

// Reads a study, computes the errors of all its solves again (experiments/runner.hpp), and passes each on to `also`.
judge::StudyResults read_checked(const results::Store& store, const results::StoredStudy& entry,
                                 const results::SolveVisitor& also = {});
// The same, and writes the solves into the folder's solves.csv, which belongs to its report.
judge::StudyResults read_and_export(const results::Store& store, const results::StoredStudy& entry,
                                    const std::filesystem::path& folder);

}  // namespace ikbench::cli
