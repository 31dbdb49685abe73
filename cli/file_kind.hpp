// What a file is that somebody gave where another kind of file was expected, and the command for it.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace ikbench::cli {

// True of a file that begins as those of SQLite do.
bool is_store(const std::string& file);
// True of a URDF file, by its name, and of a TOML file that has links and no solvers.
bool is_arm(const std::string& file);
// Throws std::invalid_argument if the file, given as an arm, is a store or a study.
void refuse_as_arm(const std::string& file);

// A file, given as a table, that is something else. The command makes a table of it, or shows what it has.
struct NotATable : std::invalid_argument {
  NotATable(const std::string& what, std::string with) : std::invalid_argument(what), command(std::move(with)) {}
  std::string command;
};
// Throws NotATable if the text of a file, or of - for standard input, is none: a store, JSON, something compressed, a
// spreadsheet.
void refuse_no_table(std::string_view text, const std::string& file);

}  // namespace ikbench::cli
