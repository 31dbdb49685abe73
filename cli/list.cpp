// ikbench list: lists solvers, robots, studies and so on, or shows one of them in full.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "analysis/judge/data/sampling.hpp"
#include "base/inputs.hpp"
#include "base/names.hpp"
#include "base/toml_table.hpp"
#include "cli/console.hpp"
#include "cli/reporting.hpp"
#include "experiments/study/reader.hpp"
#include "experiments/study/writer.hpp"
#include "numerics/instruction_set.hpp"
#include "results/export.hpp"
#include "solvers/registry.hpp"

namespace ikbench::cli {

using namespace numerics;
using namespace robots;
using namespace solvers;

namespace {

std::string cited_for(std::string_view name) { return fmt::format("{}", fmt::join(citation_keys_of(name), ", ")); }

std::string solver_details(std::string_view name) {
  const SolverInfo& info = solver(solver_named(std::string(name)));
  Rows options{{"OPTION", "DEFAULT", "EXPECTED", "MEANING"}};
  info.describe([&](const OptionList& list) {
    for (const solvers::Option& option : list.options())
      options.push_back({option.name, text_of(option.get()), option.expected, option.meaning});
  });
  const std::string library = info.library.empty() ? "" : fmt::format("\nbuilt with {}", info.library);
  return fmt::format("{}\n\n{}",
                     wrapped(fmt::format("{}: {}\nsource: {}; cite {}{}", info.name, info.summary, info.source,
                                         cited_for(info.name), library)),
                     align_columns(options));
}

std::string study_details(const std::string& name) {
  if (std::error_code none; std::filesystem::is_regular_file(name, none)) {  // the file may be foreign
    const toml::table study = parse_toml(text_of_file(name), name);
    const toml::array* const solvers = study["solvers"].as_array();
    const auto is_program = [](const toml::node& entry) {
      return entry.is_table() && entry.as_table()->contains("process");
    };
    if (solvers != nullptr && std::any_of(solvers->begin(), solvers->end(), is_program))
      throw std::invalid_argument(
          fmt::format("{} names programs, and `ikbench list` starts no programs; read the file, or check a "
                      "program: ikbench check-solver -- COMMAND",
                      name));
  }
  return to_toml(load_study(name));
}

Rows list_of(std::string_view kind) {
  Rows rows;
  if (kind == "solvers") {
    rows = {{"NAME", "WHAT", "CITE"}};
    for (const SolverInfo& info : all_solvers()) rows.push_back({info.name, info.summary, cited_for(info.name)});
    for (const MissingPeer& peer : missing_peers()) rows.push_back({peer.name, peer.how, cited_for(peer.name)});
  } else if (kind == "robots") {
    rows = {{"NAME", "JOINTS", "WHAT", "CITE"}};
    for (const Robot& arm : all_robots())
      rows.push_back({arm.name, fmt::to_string(arm.joints()), arm.summary, cited_for(arm.name)});
  } else if (kind == "studies") {
    rows = {{"NAME", "SOLVERS", "RUNS", "POINTS", "WHAT"}};
    for (const Study& study : built_in_studies())
      rows.push_back({study.name, fmt::to_string(study.solvers.size()), fmt::to_string(study.runs),
                      fmt::to_string(study.path->points()), study.title});
  } else if (kind == "paths") {
    rows = {{"NAME", "TARGETS", "WHAT"}};
    for (const Path& path : target_sets())
      rows.push_back({std::string(path->name()),
                      path->is_random() ? "random, different in every run" : "the same in every run",
                      std::string(path->summary())});
  } else if (kind == "columns") {
    rows = {{"COLUMN", "TYPE", "MEANING"}};
    for (const ColumnInfo& column : columns())
      rows.push_back({std::string(column.name), std::string(column.type), std::string(column.meaning)});
  } else if (kind == "metrics") {
    rows = {{"METRIC", "UNIT", "BETTER", "PER", "WHAT"}};
    for (const judge::Metric& metric : judge::metrics())
      rows.push_back({std::string(metric.column), std::string(metric.unit),
                      metric.kind == judge::MetricKind::success_rate ? "larger" : "smaller",
                      metric.kind == judge::MetricKind::per_run ? "run" : "solve", std::string(metric.name)});
  } else {
    rows = {{"NAME", "IN USE"}};
    for (const InstructionSet set : instruction_sets())
      rows.push_back({std::string(name_of(set)), set == instruction_set() ? "yes" : "no"});
  }
  return rows;
}

std::string list_text(const std::string& kind, const std::string& name) {
  if (kind == "figures" && name.empty()) return figure_list_text();
  if (name.empty()) return align_columns(list_of(kind));
  if (kind == "solvers") return solver_details(name);
  if (kind == "studies") return study_details(name);
  if (kind == "paths")
    return to_toml(find_named("path", name, target_sets(), [](const Path& path) { return path->name(); }));
  throw std::invalid_argument(kind == "robots"
                                  ? fmt::format("list robots takes no name; to show this arm: ikbench robot {}", name)
                                  : fmt::format("list {} takes no name; leave {} out", kind, name));
}

}  // namespace

void add_list(const Command& command, Invocation&) {
  struct Arguments {
    std::string kind, name;
  };
  auto arguments = std::make_shared<Arguments>();
  const std::vector<std::string> kinds{"solvers", "robots",  "studies", "paths",
                                       "columns", "metrics", "figures", "instruction-sets"};
  command.add("KIND", &arguments->kind, fmt::format("{}; default: list these kinds", fmt::join(kinds, ", ")));
  command.add("NAME", &arguments->name,
              "show this solver with its options, or print this study or path as TOML, ready to edit");
  command.footer(
      "  ikbench list solvers\n"
      "  ikbench list solvers ik_bat              its options with defaults and ranges\n"
      "  ikbench list studies slim2023 > my.toml\n"
      "  ikbench list instruction-sets            to choose one, set IKBENCH_INSTRUCTION_SET");
  command.callback([arguments, kinds] {
    if (arguments->kind.empty()) return fmt::print("{}\n", fmt::join(kinds, "\n"));
    if (std::ranges::find(kinds, arguments->kind) == kinds.end())
      throw std::invalid_argument(unknown_name("kind of list", arguments->kind, kinds) +
                                  "; `figures` also lists the styles");
    const std::string text = list_text(arguments->kind, arguments->name);
    fmt::print("{}", isatty(STDOUT_FILENO) != 0 ? printable(text) : text);  // a file keeps every letter
  });
}

}  // namespace ikbench::cli
