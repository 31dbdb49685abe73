#include "cli/file_kind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "base/files.hpp"
#include "base/inputs.hpp"
#include "base/json.hpp"
#include "base/toml_table.hpp"
#include "cli/console.hpp"
#include "robots/urdf.hpp"

namespace ikbench::cli {

namespace {

constexpr std::string_view start_of_store = "SQLite format 3", start_of_gzip = "\x1f\x8b", start_of_zip = "PK\x03\x04";

// Returns the table in a TOML file; nullopt if the file cannot be read as TOML. The file's reader then says what is
// wrong.
std::optional<toml::table> toml_in(const std::string& file) {
  std::error_code error;
  if (!file.ends_with(".toml") || !std::filesystem::is_regular_file(file, error)) return std::nullopt;
  try {
    return base::parse_toml(base::text_of_file(file), file);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

// Returns the name of a file in messages.
std::string name_of(const std::string& file) { return file == "-" ? "standard input" : file; }

// Returns a command whose output goes to a new file beside the input.
std::string command_into_csv(std::string_view program, std::vector<std::string> arguments, const std::string& file) {
  if (file != "-") arguments.push_back(file);
  return fmt::format("{} {}", shell_command(program, arguments),
                     shell_command(">", {file == "-" ? "table.csv" : file + ".csv"}));
}

bool is_flat(const base::Json& row) {
  return row.is_object() && std::ranges::none_of(row, [](const base::Json& value) { return value.is_structured(); });
}

// Returns the command that makes a table of objects with the same members. `option` says how jq reads the objects.
std::string command_for_objects(const char* option, const std::string& file) {
  return command_into_csv("jq", {option, "(.[0] | keys_unsorted) as $names | $names, (.[] | [.[$names[]]]) | @csv"},
                          file);
}

bool has_list(const base::Json& json, const char* list, const char* member) {
  const auto found = json.find(list);
  return found != json.end() && found->is_array() && !found->empty() && found->front().is_object() &&
         found->front().contains(member);
}

void refuse_json(std::string_view text, const std::string& file) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos || (text[begin] != '{' && text[begin] != '[')) return;
  const base::Json json = base::parsed_json(text);
  if (json.is_object() && has_list(json, "results", "times"))
    throw NotATable(
        fmt::format("{} is JSON from hyperfine; expected a table; this command makes one:", name_of(file)),
        command_into_csv("jq", {"-r", R"(["command", "time_s"], (.results[] | [.command] + (.times[] | [.])) | @csv)"},
                         file));
  if (json.is_object() && has_list(json, "benchmarks", "real_time"))
    throw NotATable(
        fmt::format("{} is JSON from Google Benchmark; expected a table; this command makes one:", name_of(file)),
        command_into_csv(
            "jq",
            {"-r", R"(["name", "time [\(.benchmarks[0].time_unit // "ns")]"], )"
                   R"((.benchmarks[] | select(.run_type != "aggregate") | [.run_name // .name, .real_time]) | @csv)"},
            file));
  if (json.is_array() && !json.empty() && std::ranges::all_of(json, is_flat))
    throw NotATable(fmt::format("{} is JSON; expected a table; this command makes one:", name_of(file)),
                    command_for_objects("-r", file));
  if (!json.is_discarded())
    throw NotATable(fmt::format("{} is JSON; expected a table with one row per value, such as CSV", name_of(file)), "");
  const base::Json first = base::parsed_json(text.substr(begin, text.find('\n', begin) - begin));
  if (first.is_object())
    throw NotATable(
        fmt::format("{} is JSON with one object per line; expected a table; this command makes one:", name_of(file)),
        command_for_objects("-rs", file));
}

}  // namespace

bool is_store(const std::string& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return false;
  return base::read_file(file, start_of_store.size()).value_or("").starts_with(start_of_store);
}

bool is_arm(const std::string& file) {
  if (robots::is_urdf_file(file)) return true;
  const std::optional<toml::table> table = toml_in(file);
  return table && table->contains("links") && !table->contains("solvers");
}

void refuse_as_arm(const std::string& file) {
  if (is_store(file))
    throw std::invalid_argument(fmt::format(
        "{0} is a store, not an arm; to solve its study again: ikbench run {0} --out NEW; to show its results: ikbench report {0}",
        file));
  const std::optional<toml::table> table = toml_in(file);
  if (table && table->contains("solvers"))
    throw std::invalid_argument(fmt::format("{0} is a study, not an arm; to solve it: ikbench run {0}", file));
}

void refuse_no_table(std::string_view text, const std::string& file) {
  if (text.starts_with(start_of_store))
    throw NotATable(
        fmt::format("{} is a store; expected a table, such as CSV; this command shows its results:", name_of(file)),
        shell_command("ikbench", {"report", file}));
  if (text.starts_with(start_of_gzip))
    throw NotATable(fmt::format("{} is compressed; expected a table; this command unpacks it:", name_of(file)),
                    shell_command("gunzip", {"-k", file}));
  if (text.starts_with(start_of_zip))
    throw NotATable(fmt::format("{} is a spreadsheet or another zip file; expected a table; save its first sheet "
                                "as CSV, in the program that wrote it or by this command:",
                                name_of(file)),
                    shell_command("libreoffice", {"--headless", "--convert-to", "csv", file}));
  refuse_json(text, file);
}

}  // namespace ikbench::cli
