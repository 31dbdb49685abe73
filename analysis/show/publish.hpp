// A report as the files of a folder.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "analysis/show/report.hpp"

namespace ikbench::show {

// Name and meaning of each figure that some report has, whose files begin with it.
std::vector<std::pair<std::string, std::string>> figure_list();

// The types of a figure's pictures that stand there: "svg", "pdf", "png".
std::vector<std::string> picture_formats_of(const figures::Figure& figure, const std::filesystem::path& folder);

// NAME.csv and, of what an article shows, NAME.tex.
void write_table(const Table& table, const Table& article, const std::filesystem::path& folder,
                 const std::string& program);

struct WrittenReport {
  std::filesystem::path page;         // report.html
  std::vector<std::string> files;     // all, from the folder
  std::vector<std::string> warnings;  // figures that were not drawn
};
// Those of tables of these names, and of figures.
std::vector<std::string> report_files(const std::vector<std::string>& tables,
                                      const std::vector<figures::Figure>& figures);
// Before these files are written: refuses those that results.json does not list, and lists them there, so that after a
// kill they are known. Returns what it listed before.
std::vector<std::string> reserve_files(const std::filesystem::path& folder, std::vector<std::string> files);
// Writes report.html, report.md, results.json, tables/ and figures/ beside the study's solves.csv, which whoever reads
// its solves has written (results/export.hpp); removes what an earlier report wrote, and this one does not. `program`
// made it, with its version. Throws as base::refuse_place if the folder cannot be written.
WrittenReport write_report(const Report& report, const std::filesystem::path& folder,
                           const figures::RenderOptions& options, const std::string& program = {});

}  // namespace ikbench::show
