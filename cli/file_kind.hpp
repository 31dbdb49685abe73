// Recognises files that were given where another kind of file was expected, so that a message can name the command for
// them. The commands run, robot and stats call these functions.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace ikbench::cli {

// Returns true if the file begins as SQLite files do; false if the file cannot be read.
bool is_store(const std::string& file);
// Returns true for the name of a URDF file, and for a TOML file that has links and no solvers.
bool is_arm(const std::string& file);
// Throws std::invalid_argument if the file, given as an arm, is a store or a study.
void refuse_as_arm(const std::string& file);

// The exception for a file that was given as a table and is something else. The command makes a table of the file, or
// shows the file's results; empty: there is no command.
struct NotATable : std::invalid_argument {
  NotATable(const std::string& what, std::string with) : std::invalid_argument(what), command(std::move(with)) {}
  std::string command;
};
// Throws NotATable if the text is a store, JSON, compressed or a spreadsheet. `file` is the text's source for messages;
// "-" is standard input.
void refuse_no_table(std::string_view text, const std::string& file);

}  // namespace ikbench::cli
