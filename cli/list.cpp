// ikbench list: solvers, robots, studies and so on, or one of them in full.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>

#include "analysis/inference/method.hpp"
#include "analysis/inference/metrics.hpp"
#include "analysis/report/study_pieces.hpp"
#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/robot.hpp"
#include "experiments/study_reader.hpp"
#include "experiments/study_writer.hpp"
#include "numerics/instruction_set.hpp"
#include "numerics/names.hpp"
#include "results/export.hpp"
#include "solvers/registry.hpp"

namespace ikbench::cli {

using namespace numerics;
using namespace robots;
using namespace solvers;
using namespace results;
using namespace experiments;

namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string solver_list() {
  Rows rows{{"NAME", "WHAT", "FROM"}};
  for (const SolverInfo& info : all_solvers()) rows.push_back({info.name, info.summary, info.source});
  for (const MissingPeer& peer : missing_peers()) rows.push_back({peer.name, peer.how, ""});
  return aligned(rows);
}

std::string solver_details(std::string_view name) {
  for (const MissingPeer& peer : missing_peers()) {
    if (peer.name == name) return fmt::format("{}: {}\n", peer.name, peer.how);
  }
  const SolverInfo info = solver(name);
  Rows rows{{"OPTION", "DEFAULT", "EXPECTED", "MEANING"}};
  info.describe([&](const OptionList& list) {
    for (const Option& option : list.options()) {
      rows.push_back({option.name, option.get(), option.expected, option.meaning});
    }
  });
  const std::string library = info.library.empty() ? "" : fmt::format("\nbuilt with {}", info.library);
  return fmt::format("{}: {}\nfrom {}{}\n\n{}", info.name, info.summary, info.source, library, aligned(rows));
}

std::string robot_list() {
  Rows rows{{"NAME", "JOINTS", "WHAT"}};
  for (const Robot& arm : all_robots()) rows.push_back({arm.name, std::to_string(arm.joints()), arm.summary});
  return aligned(rows);
}

std::string study_list() {
  Rows rows{{"NAME", "SOLVERS", "RUNS", "POINTS", "WHAT"}};
  for (const Study& study : studies()) {
    rows.push_back({study.name, std::to_string(study.solvers.size()), std::to_string(study.runs),
                    std::to_string(study.path->points()), study.title});
  }
  return aligned(rows);
}

std::string path_list() {
  Rows rows{{"NAME", "TARGETS", "WHAT"}};
  for (const Path& path : paths()) {
    rows.push_back({std::string(path->name()),
                    path->is_drawn() ? "random, different in every run" : "the same in every run",
                    std::string(path->summary())});
  }
  return aligned(rows);
}

std::string path_details(const std::string& name) {
  std::vector<std::string> names;
  for (const Path& path : paths()) {
    if (path->name() == name) return to_toml(path);
    names.emplace_back(path->name());
  }
  throw std::invalid_argument(unknown_name("kind of path", name, names));
}

// The rows below the titles, or the row with that name in its first column.
std::string rows_or_one(Rows rows, std::string_view what, std::string_view name) {
  if (name.empty()) return aligned(rows);
  std::vector<std::string> names;
  for (auto row = rows.begin() + 1; row != rows.end(); ++row) names.push_back(row->front());
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) throw std::invalid_argument(unknown_name(what, name, names));
  return aligned({rows.front(), rows[static_cast<std::size_t>(found - names.begin()) + 1]});
}

Rows column_list() {
  Rows rows{{"COLUMN", "TYPE", "MEANING"}};
  for (const ColumnInfo& column : columns()) {
    rows.push_back({std::string(column.name), std::string(column.type), std::string(column.meaning)});
  }
  return rows;
}

Rows metric_list() {
  using namespace inference;
  Rows rows{{"METRIC", "UNIT", "BETTER", "OF", "WHAT"}};
  for (const Metric metric : all_metrics()) {
    const MetricInfo& info = info_of(metric);
    rows.push_back({std::string(info.column), std::string(info.unit),
                    info.better == Better::larger ? "larger" : "smaller", is_of_run(metric) ? "run" : "solve",
                    std::string(info.name)});
  }
  return rows;
}

Rows test_list() {
  constexpr std::array<std::string_view, 3> needs{"summaries", "values", "blocks"};
  Rows rows{{"TEST", "NEEDS", "WHAT", "FROM"}};
  for (const DecidingTest& test : deciding_tests()) {
    const auto method =
        std::ranges::find(inference::methods(), test.name, [](const inference::Method* each) { return each->name; });
    rows.push_back({std::string(test.name), std::string(needs[static_cast<std::size_t>(test.needs)]),
                    std::string(test.meaning), std::string((*method)->source)});
  }
  return rows;
}

Rows piece_list() {
  Rows rows{{"PIECE", "KIND", "UNDER", "FILES AND CONTENTS"}};
  for (const report::StudyPiece& piece : report::all_study_pieces()) {
    if (!piece.tables && !piece.figures) continue;  // a place only
    rows.push_back({std::string(piece.name), piece.tables ? "table" : "figure", std::string(piece.heading),
                    std::string(piece.meaning)});
  }
  return rows;
}

Rows instruction_set_list() {
  Rows rows{{"NAME", "IN USE"}};
  for (const InstructionSet each : instruction_sets()) {
    rows.push_back({std::string(name_of(each)), each == instruction_set() ? "yes" : "no"});
  }
  return rows;
}

std::string listed(const std::string& kind, const std::string& name) {
  if (kind == "solvers") return name.empty() ? solver_list() : solver_details(name);
  if (kind == "robots")
    return name.empty() ? robot_list() : robot_text(is_arm_file(name) ? load_robot(name) : robot(name));
  if (kind == "paths") return name.empty() ? path_list() : path_details(name);
  if (kind == "columns") return rows_or_one(column_list(), "column", name);
  if (kind == "metrics") return rows_or_one(metric_list(), "metric", name);
  if (kind == "tests") return rows_or_one(test_list(), "test", name);
  if (kind == "pieces") return rows_or_one(piece_list(), "piece", name);
  if (kind == "instruction-sets") return rows_or_one(instruction_set_list(), "instruction set", name);
  return name.empty() ? study_list() : to_toml(load_study(name, {}, PointsAsObservations::forced));
}

}  // namespace

void add_list(CLI::App& app, Invocation&) {
  struct Arguments {
    std::string kind, name;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand(
      "list",
      "List solvers, robots, studies, kinds of path, result columns, metrics, tests, pieces of a report or instruction sets");
  const std::vector<std::string> kinds{"solvers", "robots", "studies", "paths",           "columns",
                                       "metrics", "tests",  "pieces",  "instruction-sets"};
  command->add_option("KIND", arguments->kind, fmt::format("one of: {}", fmt::join(kinds, ", ")));
  command->add_option("NAME", arguments->name,
                      "show this one in full; a study or a path is printed as TOML, ready to edit");
  command->footer(
      "Examples:\n"
      "  ikbench list solvers\n"
      "  ikbench list solvers ik_bat              its options with defaults and ranges\n"
      "  ikbench list studies slim2023 > my.toml\n"
      "  ikbench list pieces                      the tables and figures of a study without a paper\n"
      "  ikbench list instruction-sets            those of this machine; set IKBENCH_INSTRUCTION_SET to choose one");
  command->callback([arguments, kinds] {
    if (arguments->kind.empty()) {
      throw std::invalid_argument(fmt::format("list lacks its KIND; expected one of: {}", fmt::join(kinds, ", ")));
    }
    if (std::ranges::find(kinds, arguments->kind) == kinds.end())
      throw std::invalid_argument(unknown_name("kind of list", arguments->kind, kinds));
    fmt::print("{}", listed(arguments->kind, arguments->name));
  });
}

}  // namespace ikbench::cli
