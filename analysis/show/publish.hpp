// Writes a report as the files of a folder: page, tables, figures and data. Commands that report on a study or a file
// call write_report. A command that writes other files into such a folder calls reserve_files first, so that no foreign
// file is overwritten. The files are documented in docs/reference/report.md.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/show/report.hpp"
#include "base/json.hpp"

namespace ikbench::show {

// Returns the name and the meaning of each figure that some report has. The names of the figure's files begin with the
// figure's name.
std::vector<std::pair<std::string, std::string>> figure_list();

// Returns the types ("svg", "pdf", "png") of a figure's pictures that exist in the folder figures/ of `folder`.
std::vector<std::string> picture_formats_of(const figures::Figure& figure, const std::filesystem::path& folder);

// Writes NAME.csv from `table` and NAME.tex from `article`, where NAME is the name of `table`. The LaTeX ends with a
// comment that names `program`, unless `program` is empty.
void write_table(const Table& table, const Table& article, const std::filesystem::path& folder,
                 const std::string& program);

// The files of a report that was written.
struct WrittenReport {
  std::filesystem::path page;         // report.html
  std::vector<std::string> files;     // all files, relative to the folder, sorted
  std::vector<std::string> warnings;  // figures that were not drawn, unused words of the style, no moving arm
};
// Returns the files of tables with these names and of these figures, relative to the folder of a report. Pictures that
// gnuplot may fail to draw are among them.
std::vector<std::string> report_files(const std::vector<std::string>& tables,
                                      const std::vector<figures::Figure>& figures);
// Reserves files for a report, before the files are written: adds the files to the list in results.json, so that the
// next report knows them even if the program is killed. Returns the files that were listed before. Throws
// std::invalid_argument if a file exists and was not listed, or if a folder of the report is a symbolic link.
std::vector<std::string> reserve_files(const std::filesystem::path& folder, std::vector<std::string> files);
// The parts of a report that are written.
struct Publication {
  std::string title;
  std::vector<Blocks> sections;
  base::OrderedJson json;                  // results.json, without the list of files
  const Report* report = nullptr;          // of one study, whose article is written, too; null: no article
  std::optional<std::string> arm = {};     // the moving arm of the page (moving_arm.hpp)
  std::vector<std::string> warnings = {};  // beside those of the figures
};
// Writes the parts, as write_report does.
WrittenReport publish(Publication publication, const std::filesystem::path& folder,
                      const figures::RenderOptions& options, const std::string& program);
// Writes report.html, report.md, results.json, tables/, figures/ and article/. The study's solves.csv must have been
// written before (results/export.hpp). Removes the files of an earlier report that this report does not have. `program`
// is the name and version that the files mention. Throws as base::refuse_place if the folder cannot be written.
WrittenReport write_report(const Report& report, const std::filesystem::path& folder,
                           const figures::RenderOptions& options, const std::string& program = {});

}  // namespace ikbench::show
