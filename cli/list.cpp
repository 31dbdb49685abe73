// ikbench list: solvers, robots, studies and so on, or one of them in full.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "analysis/compare/observe.hpp"
#include "analysis/show/block.hpp"
#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/reporting.hpp"
#include "experiments/study_reader.hpp"
#include "experiments/study_writer.hpp"
#include "numerics/embedded_file.hpp"
#include "numerics/inputs.hpp"
#include "numerics/instruction_set.hpp"
#include "numerics/json.hpp"
#include "numerics/names.hpp"
#include "numerics/toml_table.hpp"
#include "results/export.hpp"
#include "solvers/registry.hpp"

namespace ikbench::cli {

using namespace numerics;
using namespace robots;
using namespace solvers;
using namespace results;
using namespace experiments;

namespace {

std::string cited_for(std::string_view name) { return fmt::format("{}", fmt::join(references_of(name), ", ")); }

// A list for a reader and for a program.
struct Listed {
  std::string text;
  numerics::OrderedJson json;
};

// Of a text or a whole number.
std::string words_of(const show::Cell& cell) {
  if (const auto* number = std::get_if<std::int64_t>(&cell)) return fmt::to_string(*number);
  const auto* text = std::get_if<std::string>(&cell);
  return text == nullptr ? "" : *text;
}

// The rows of the table. For a reader the names of its columns are in capitals.
Listed listed(const show::Table& table) {
  Rows rows(1);
  for (const show::Column& column : table.columns) {
    std::string& head = rows.front().emplace_back(column.name);
    std::ranges::transform(head, head.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  }
  for (const auto& cells : table.rows) {
    std::vector<std::string>& row = rows.emplace_back();
    for (const show::Cell& cell : cells) row.push_back(words_of(cell));
  }
  return {aligned(rows), show::to_json(table)};
}

Listed solver_details(std::string_view name) {
  for (const MissingPeer& peer : missing_peers()) {
    if (peer.name == name) {
      return {wrapped(fmt::format("{}: {}", peer.name, peer.how)) + '\n', {{"name", peer.name}, {"what", peer.how}}};
    }
  }
  const SolverInfo info = solver(name);
  show::Table table{.name = "options", .caption = "", .columns = {{"option"}, {"default"}, {"expected"}, {"meaning"}}};
  info.describe([&](const OptionList& list) {
    for (const Option& option : list.options()) {
      table.rows.push_back({option.name, option.get(), option.expected, option.meaning});
    }
  });
  const Listed options = listed(table);
  const std::string library = info.library.empty() ? "" : fmt::format("\nbuilt with {}", info.library);
  return {fmt::format("{}\n\n{}",
                      wrapped(fmt::format("{}: {}\nsource: {}; cite {}{}", info.name, info.summary, info.source,
                                          cited_for(info.name), library)),
                      options.text),
          {{"name", info.name},
           {"what", info.summary},
           {"from", info.source},
           {"cite", cited_for(info.name)},
           {"library", info.library},
           {"options", options.json}}};
}

show::Table list_of(std::string_view kind) {
  show::Table table{.name = std::string(kind), .caption = ""};
  const auto row = [&](std::vector<show::Cell> cells) { table.rows.push_back(std::move(cells)); };
  if (kind == "solvers") {
    table.columns = {{"name"}, {"what"}, {"cite"}};
    for (const SolverInfo& info : all_solvers()) row({info.name, info.summary, cited_for(info.name)});
    for (const MissingPeer& peer : missing_peers()) row({peer.name, peer.how, cited_for(peer.name)});
  } else if (kind == "robots") {
    table.columns = {{"name"}, {"joints"}, {"what"}, {"cite"}};
    for (const Robot& arm : all_robots()) row({arm.name, std::int64_t{arm.joints()}, arm.summary, cited_for(arm.name)});
  } else if (kind == "studies") {
    table.columns = {{"name"}, {"solvers"}, {"runs"}, {"points"}, {"what"}};
    for (const Study& study : studies())
      row({study.name, std::ssize(study.solvers), std::int64_t{study.runs}, std::int64_t{study.path->points()},
           study.title});
  } else if (kind == "paths") {
    table.columns = {{"name"}, {"targets"}, {"what"}};
    for (const Path& path : paths())
      row({std::string(path->name()), path->is_drawn() ? "random, different in every run" : "the same in every run",
           std::string(path->summary())});
  } else if (kind == "columns") {
    table.columns = {{"column"}, {"type"}, {"meaning"}};
    for (const ColumnInfo& column : columns())
      row({std::string(column.name), std::string(column.type), std::string(column.meaning)});
  } else if (kind == "metrics") {
    table.columns = {{"metric"}, {"unit"}, {"better"}, {"of"}, {"what"}};
    for (const compare::Metric& metric : compare::metrics())
      row({std::string(metric.column), std::string(metric.unit),
           metric.kind == compare::Kind::share ? "larger" : "smaller", metric.is_of_run ? "run" : "solve",
           std::string(metric.name)});
  } else {
    table.columns = {{"name"}, {"in use"}};
    for (const InstructionSet each : instruction_sets())
      row({std::string(name_of(each)), each == instruction_set() ? "yes" : "no"});
  }
  return table;
}

Listed study_details(const std::string& name) {
  if (std::error_code none; std::filesystem::is_regular_file(name, none)) {  // perhaps a stranger's
    const toml::table study = parse_toml(text_of_file(name), name);
    const toml::array* const solvers = study["solvers"].as_array();
    const auto is_program = [](const toml::node& entry) {
      return entry.is_table() && entry.as_table()->contains("process");
    };
    if (solvers != nullptr && std::any_of(solvers->begin(), solvers->end(), is_program))
      throw std::invalid_argument(
          fmt::format("{} names programs, and a list starts none; read it, or try one: ikbench check-solver", name));
  }
  const Study study = load_study(name);
  return {to_toml(study), parsed_ordered_json(to_json(study))};
}

Listed listed(const std::string& kind, const std::string& name) {
  if (name.empty()) return listed(list_of(kind));
  if (kind == "solvers") return solver_details(name);
  if (kind == "robots") throw std::invalid_argument(fmt::format("an arm is shown by: ikbench robot {}", name));
  if (kind == "studies") return study_details(name);
  show::Table table = list_of(kind);
  std::vector<std::string> names;
  for (const auto& row : table.rows) names.push_back(words_of(row.front()));
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) throw std::invalid_argument(unknown_name(kind.substr(0, kind.size() - 1), name, names));
  const auto which = static_cast<std::size_t>(found - names.begin());
  if (kind == "paths") {
    const Path path = paths()[which];
    const std::string toml = to_toml(path);
    return {toml, {{"name", name}, {"what", path->summary()}, {"toml", toml}}};
  }
  table.rows = {table.rows[which]};
  return listed(table);
}

}  // namespace

void add_list(CLI::App& app, Invocation&) {
  struct Arguments {
    std::string kind, name;
    bool is_json = false;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      app.add_subcommand("list", "List solvers, arms, studies, paths, columns, metrics or instruction sets");
  const std::vector<std::string> kinds{"solvers", "robots",  "studies",         "paths",
                                       "columns", "metrics", "instruction-sets"};
  command->add_option("KIND", arguments->kind, fmt::format("{}; default: these names", fmt::join(kinds, ", ")));
  command->add_option(
      "NAME", arguments->name,
      "show this one in full; a study or a path is printed as TOML, ready to edit; an arm: ikbench robot");
  add_json_option(*command, arguments->is_json);
  command->footer(
      "Examples:\n"
      "  ikbench list solvers\n"
      "  ikbench list solvers ik_bat              its options with defaults and ranges\n"
      "  ikbench list studies slim2023 > my.toml\n"
      "  ikbench list instruction-sets            those of this machine; set IKBENCH_INSTRUCTION_SET to choose one");
  command->callback([arguments, kinds] {
    if (arguments->kind.empty() && arguments->is_json) return show_json(kinds);
    if (arguments->kind.empty()) return fmt::print("{}\n", fmt::join(kinds, "\n"));
    if (std::ranges::find(kinds, arguments->kind) == kinds.end())
      throw std::invalid_argument(unknown_name("kind of list", arguments->kind, kinds));
    const Listed found = listed(arguments->kind, arguments->name);
    if (arguments->is_json)
      show_json(found.json);
    else
      fmt::print("{}", isatty(STDOUT_FILENO) != 0 ? printable(found.text) : found.text);  // a file keeps every letter
  });
}

}  // namespace ikbench::cli
