// ikbench multiverse: tests the claims of a paper in every combination of what it leaves open.
#include "cli/multiverse.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "analysis/collections.hpp"
#include "analysis/report/report.hpp"
#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/reporting.hpp"

namespace ikbench::cli {

using namespace results;
using namespace experiments;
using namespace inference;
using namespace figures;
using namespace report;

namespace {

struct MultiverseArguments {
  std::string paper, out;
  std::vector<std::string> dimensions;
  Overrides overrides;
  int seeds = 1, jobs = 1;
  bool list = false, small = false, one_at_a_time = false, without_figures = false;

  Combined combined() const { return one_at_a_time ? Combined::one_at_a_time : Combined::every; }
};

Multiverse with_values(const MultiversePlan& plan, const std::vector<RunMeans>& means) {
  Multiverse multiverse{.dimensions = plan.dimensions, .solvers = plan.solvers, .studies = {}};
  for (const MultiversePlan::OfStudy& each : plan.studies) {
    multiverse.studies.push_back(
        {.chosen = each.chosen, .weight = each.weight, .out_of_reach = each.out_of_reach, .solvers = {}});
    for (const std::vector<MultiversePlan::ChosenSolver>& of_solver : each.solvers) {
      auto& solver = multiverse.studies.back().solvers.emplace_back();
      for (const MultiversePlan::ChosenSolver& from : of_solver) {
        Multiverse::ChosenSolver& own = solver.emplace_back();
        own.chosen = from.chosen;
        for (const std::size_t part : from.parts) {
          own.error_cm.push_back(means[part].error_cm);
          own.variation_deg.push_back(means[part].variation_deg);
        }
      }
    }
  }
  return multiverse;
}

// Lists every dimension with its alternatives; marks those that vary by default.
std::string dimension_list(const Study& study, const std::vector<Dimension>& all, const std::vector<Dimension>& varied,
                           Combined combined) {
  std::vector<std::vector<std::string>> rows{{"ALTERNATIVE", "NOTES", "IN", "WHERE"}};
  for (const Dimension& each : all) {
    for (const Alternative& one : each.alternatives) {
      const bool is_default = &one == &each.alternatives.front();
      rows.push_back({one.set, each.section,
                      is_default                  ? "the default"
                      : one.scope == Scope::small ? "small and default"
                      : one.scope == Scope::usual ? "default"
                                                  : "",
                      one.where});
    }
  }
  std::vector<std::string> labels;
  for (const SolverEntry& entry : study.solvers) labels.push_back(entry.label);
  const MultiverseSize size = size_of(varied, labels, combined);
  return aligned(rows) +
         fmt::format("\n{} interpretations of {} dimensions: {} choices for the study, {} series for a seed\n",
                     size.universes, varied.size(), size.studies, size.series);
}

void tell(const Table& table) {
  fmt::print("{}\n", aligned(readable_cells(table)));
  for (const std::string& note : table.notes) fmt::print("{}\n", printable(note));
}

void tell(const MultiverseReport& report, const MultiverseArguments& arguments, const std::filesystem::path& folder) {
  for (const ClaimShares& claim : report.claims) fmt::print("{}\n", printable(claim.sentence));
  for (const std::string& sentence : report.sentences) fmt::print("{}\n", printable(sentence));
  fmt::print("\n");
  tell(report.tables.front());
  for (const Table& table : report.tables) write_table(table, folder / "tables");
  draw(report.figures, folder / "figures", {.render = !arguments.without_figures, .jobs = 1});
  fmt::print(
      "Tables: {}\nFigure: {}\n", printable((folder / "tables").string()),
      printable((folder / "figures" / (arguments.without_figures ? "multiverse.gp" : "multiverse.png")).string()));
}

void solve_and_tell(const Paper& paper, const MultiverseArguments& arguments, const std::vector<Dimension>& varied,
                    Invocation& invocation) {
  const std::string& study = arguments.paper;
  const std::filesystem::path folder =
      arguments.out.empty() ? default_folder(study + "-multiverse") : std::filesystem::path(arguments.out);
  CancelOnSignal signals;
  const auto solved = solved_multiverse(
      study, varied, {.seeds = arguments.seeds, .overrides = arguments.overrides, .combined = arguments.combined()},
      {"multiverse", folder, arguments.jobs, &signals.requested()});
  if (signals.end() || !solved) {
    say(fmt::format("Stopped. What is solved is in {}; to continue: {}", (folder / "series.csv").string(),
                    invocation.command));
    invocation.exit_code = cancelled_exit_code();
    return;
  }
  if (!arguments.one_at_a_time) return tell(paper.multiverse(solved->multiverse, solved->plan), arguments, folder);
  const Table table = paper.one_at_a_time(solved->multiverse, solved->plan);
  tell(table);
  write_table(table, folder / "tables");
  fmt::print("Table: {}\n", printable((folder / "tables" / (table.name + ".md")).string()));
}

}  // namespace

std::optional<SolvedMultiverse> solved_multiverse(const std::string& study, const std::vector<Dimension>& varied,
                                                  MultiverseRequest request, const SeriesArguments& arguments) {
  request.cancelled = arguments.cancelled;
  const MultiversePlan plan = plan_multiverse(study, varied, request);
  if (*arguments.cancelled) return std::nullopt;
  const std::vector<RunMeans> means = solved(plan.parts, arguments);
  if (means.size() < plan.parts.size()) return std::nullopt;
  return SolvedMultiverse{with_values(plan, means), plan.parts.front().analysis};
}

void add_multiverse(CLI::App& app, Invocation& invocation) {
  auto arguments = std::make_shared<MultiverseArguments>();
  CLI::App* command =
      app.add_subcommand("multiverse", "Judge the claims of a paper in every combination of what it leaves open");
  add_paper_option(*command, arguments->paper, [](const Collection& of) { return of.paper && of.paper->multiverse; });
  command->add_flag("--list", arguments->list, "list the dimensions and the size, without solving");
  CLI::Option* small =
      command->add_flag("--small", arguments->small, "fewer dimensions: what `ikbench reproduce` shows");
  command
      ->add_option("--dimensions", arguments->dimensions,
                   "vary these, with all their alternatives, instead of the default ones: bounds,population")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->excludes(small);
  command
      ->add_flag("--one-at-a-time", arguments->one_at_a_time,
                 "each alternative alone beside the defaults: what it changes; of all dimensions or of --dimensions")
      ->excludes(small);
  add_series_options(*command, arguments->seeds, arguments->jobs);
  command->add_option("--set", arguments->overrides, "change a key in every interpretation: runs=5, path.points=10")
      ->allow_extra_args(false);
  command
      ->add_option("--out", arguments->out,
                   "folder for tables, figures and series.csv, which keeps what is solved; default: "
                   "out/STUDY-multiverse")
      ->check(not_empty());
  command->add_flag("--no-figures", arguments->without_figures,
                    "write the script and data of the figure, but do not draw it");
  command->footer(
      "Examples:\n"
      "  ikbench multiverse slim2023 --jobs 2\n"
      "  ikbench multiverse slim2023 --list\n"
      "  ikbench multiverse slim2023 --small --seeds 2 --out out/small\n"
      "  ikbench multiverse slim2023 --dimensions bounds,population,wrist_branch\n"
      "  ikbench multiverse slim2023 --one-at-a-time --seeds 3 --jobs 2\n\n"
      "An interpretation is one choice in every dimension. Each solver is solved once for each of its own choices; claims are\n"
      "counted over all combinations. After Ctrl-C the same command continues.");
  command->callback([arguments, &invocation] {
    const Paper& paper = analysis::paper(arguments->paper);
    const std::string& study = arguments->paper;
    const std::vector<Dimension> all = dimensions(study);
    if (!paper.multiverse || all.empty())
      throw std::invalid_argument(fmt::format("the program has no multiverse of the paper {}", study));
    const Scope scope = arguments->small ? Scope::small : arguments->one_at_a_time ? Scope::none : Scope::usual;
    const std::vector<Dimension> varied =
        arguments->dimensions.empty() ? within(scope, all) : named(arguments->dimensions, all);
    if (arguments->list) {
      refuse_varied(arguments->overrides, varied);
      fmt::print("{}", dimension_list(load_study(study, arguments->overrides), all, varied, arguments->combined()));
      return;
    }
    solve_and_tell(paper, *arguments, varied, invocation);
  });
}

}  // namespace ikbench::cli
