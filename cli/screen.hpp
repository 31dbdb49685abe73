// The last screen of a command: its answer first, in at most 30 lines, and where the rest is; data with --json.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/report/json.hpp"
#include "analysis/report/table.hpp"
#include "cli/console.hpp"

namespace CLI {
class App;
}

namespace ikbench::cli {

constexpr std::size_t screen_lines = 30;

struct OutputArguments {
  bool is_verbose = false, is_json = false;
};

void add_json_option(CLI::App& command, OutputArguments& arguments);
void add_output_options(CLI::App& command, OutputArguments& arguments);  // --verbose and --json

// A part of a screen. What does not fit is counted, and a line before the last part says so.
struct Part {
  std::vector<std::string> items;         // printable, each one line or several
  std::string noun = {};                  // of an item: "row"; empty: all are shown
  std::size_t least = 0;                  // lines that it may take before other parts take more
  bool are_warnings = false;              // they go to standard error
  std::vector<std::string> columns = {};  // columns of a table that are left out already
};

Part sentences(const std::vector<std::string>& texts, std::size_t least = 0);
Part warnings(const std::vector<std::string>& texts);
constexpr std::size_t longest_cell = 36;

// Longer cells are wrapped, longer words are shortened. Columns that do not fit are left out from the right, unless all
// is shown. Tones are of the rows below the head.
Part table_rows(const report::Table& table, const OutputArguments& output, std::size_t least, Tones tones = {},
                std::size_t longest = longest_cell);

// Shows the parts, all of each with --verbose, in the room that messages before have left. `where` follows the words
// "--verbose shows all": ", and report.md has it".
void show_screen(const std::vector<Part>& parts, const OutputArguments& output, const std::string& where);

void show_json(const report::Json& json);

}  // namespace ikbench::cli
