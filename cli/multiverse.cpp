// ikbench multiverse: tests the claims of a paper in every combination of what it leaves open.
#include "cli/multiverse.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <utility>

#include "analysis/inference/make_study.hpp"
#include "analysis/papers.hpp"
#include "analysis/report/report.hpp"
#include "analysis/statistics/quantile.hpp"
#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/plan_options.hpp"
#include "cli/reporting.hpp"
#include "experiments/environment.hpp"

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
  bool list = false, small = false, without_figures = false;
  OutputArguments output;
};

RunMeans run_means(const Study& study, std::vector<SolveRecord> solves) {
  const StudyResults results = make_study(study.name, std::move(solves));
  const auto means = [&](Metric metric) {
    std::vector<double> values = samples(results, metric).front().values;
    for (double& value : values) value = std::isfinite(value) ? value : statistics::worse_than_every_number;
    return values;
  };
  return {.error_cm = means(Metric::position_error_cm), .variation_deg = means(Metric::variation_deg)};
}

// Shows progress. After Ctrl-C returns the series before the first missing one.
std::vector<RunMeans> solved(const std::vector<Study>& series, const SeriesArguments& arguments) {
  SeriesMeans kept(arguments.folder / "series.csv");
  ProgressBar bar(arguments.title);
  return solve_series(series, kept,
                      {.means_of = run_means,
                       .jobs = arguments.jobs,
                       .progress = [&](const Progress& progress) { bar.show(progress); },
                       .cancelled = arguments.cancelled});
}

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

// Lists every dimension with its alternatives; --verbose explains them and marks those that vary by default.
std::string dimension_list(const Study& study, const std::vector<Dimension>& all, const std::vector<Dimension>& varied,
                           bool is_verbose) {
  Rows rows{{"ALTERNATIVE", "NOTES", "IN", "WHERE"}},
      in_short{{"DIMENSION", "ALTERNATIVES, THE DEFAULT FIRST (--verbose explains them)"}};
  for (const Dimension& each : all) {
    in_short.push_back({each.name, ""});
    for (const Alternative& one : each.alternatives) {
      in_short.back().back() += (in_short.back().back().empty() ? "" : ", ") + one.set.substr(one.set.find('=') + 1);
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
  const MultiverseSize size = size_of(varied, labels);
  return fmt::format("{} interpretations of {} dimensions: {} choices for the study, {} series for a seed\n{}",
                     size.universes, varied.size(), size.studies, size.series, aligned(is_verbose ? rows : in_short));
}

// The verdict, a table with what is said of it, and at the end where the files are.
void show(const std::string& verdict, const Table& table, std::vector<std::string> said,
          const std::vector<std::string>& places, const OutputArguments& output) {
  if (output.is_json) return show_json(rows_json(table));
  std::ranges::copy(table.notes, std::back_inserter(said));
  constexpr std::size_t of_table = 15;
  show_screen({{.items = {wrapped(verdict), ""}},
               table_rows(table, output, of_table),
               {.items = {""}},
               sentences(said),
               {.items = places}},
              output, ", and the tables have it");
}

std::string majority_words(const std::vector<ClaimShares>& claims) {
  const auto in_most = [&](double ClaimShares::*share) {
    return std::ranges::count_if(claims, [&](const ClaimShares& claim) { return claim.*share > 0.5; });
  };
  const auto holds = in_most(&ClaimShares::holds), fails = in_most(&ClaimShares::fails),
             in_doubt = in_most(&ClaimShares::undecided), rest = std::ssize(claims) - holds - fails - in_doubt;
  return fmt::format(
      "Of {} claim{}, {} {} in most interpretations of what the paper leaves open, {} {} in most, {} {} undecided in "
      "most{}.",
      claims.size(), claims.size() == 1 ? "" : "s", holds, holds == 1 ? "holds" : "hold", fails,
      fails == 1 ? "fails" : "fail", in_doubt, in_doubt == 1 ? "is" : "are",
      rest == 0 ? "" : fmt::format(", and {} {} no majority", rest, rest == 1 ? "has" : "have"));
}

void tell(const MultiverseReport& report, const MultiverseArguments& arguments, const std::filesystem::path& folder) {
  for (const Table& table : report.tables) write_table(table, folder / "tables", program_name());
  draw(report.figures, folder / "figures", {.render = !arguments.without_figures, .jobs = 1});
  std::vector<std::string> said;
  std::ranges::copy(report.sentences, std::back_inserter(said));
  for (const ClaimShares& claim : report.claims) said.push_back(claim.sentence);  // the table has most of it
  const std::filesystem::path figure =
      folder / "figures" / (arguments.without_figures ? "multiverse.gp" : "multiverse.png");
  show(majority_words(report.claims), report.tables.front(), std::move(said),
       {fmt::format("Tables: {}", printable((folder / "tables").string())),
        fmt::format("Figure: {}", printable(figure.string()))},
       arguments.output);
}

void solve_and_tell(const Paper& paper, const MultiverseArguments& arguments, const std::vector<Dimension>& varied,
                    Invocation& invocation) {
  const std::string& study = arguments.paper;
  const std::filesystem::path folder =
      arguments.out.empty() ? default_folder(study + "-multiverse") : std::filesystem::path(arguments.out);
  CancelOnSignal signals;
  const auto solved = solved_multiverse(study, varied, {.seeds = arguments.seeds, .overrides = arguments.overrides},
                                        {"multiverse", folder, arguments.jobs, &signals.requested()});
  if (signals.end() || !solved) {
    say(fmt::format("Stopped. What is solved is in {}; to continue: {}", (folder / "series.csv").string(),
                    invocation.command));
    invocation.exit_code = cancelled_exit_code();
    return;
  }
  WorkingLine judging("Judging the claims ...");
  const MultiverseReport report = paper.multiverse(solved->multiverse, solved->plan);
  judging.end();
  tell(report, arguments, folder);
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
  add_paper_option(*command, arguments->paper, [](const Paper& of) { return bool(of.multiverse); });
  command->add_flag("--list", arguments->list, "list the dimensions and the size, without solving");
  CLI::Option* small =
      command->add_flag("--small", arguments->small, "fewer dimensions: what `ikbench reproduce` shows");
  command
      ->add_option("--dimensions", arguments->dimensions,
                   "vary these, with all their alternatives, instead of the default ones: bounds,population")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->excludes(small);
  command->add_option("--seeds", arguments->seeds, "number of seeds, counted from 1; each is a study of its own")
      ->check(whole_number({1, 1000}))
      ->capture_default_str();
  command->add_option("--jobs", arguments->jobs, "number of series at once; the results do not depend on it")
      ->check(whole_number({1, 1024}))
      ->capture_default_str();
  command->add_option("--set", arguments->overrides, "change a key in every interpretation: runs=5, path.points=10")
      ->allow_extra_args(false);
  command
      ->add_option("--out", arguments->out,
                   "folder for tables, figures and series.csv, which keeps what is solved; default: "
                   "out/STUDY-multiverse")
      ->check(not_empty());
  command->add_flag("--no-figures", arguments->without_figures,
                    "write the script and data of the figure, but do not draw it");
  add_output_options(*command, arguments->output);
  command->footer(
      "Examples:\n"
      "  ikbench multiverse slim2023 --jobs 2\n"
      "  ikbench multiverse slim2023 --list\n"
      "  ikbench multiverse slim2023 --small --seeds 2 --out out/small\n"
      "  ikbench multiverse slim2023 --dimensions bounds,population,wrist_branch\n\n"
      "An interpretation is one choice in every dimension. Each solver is solved once for each of its own choices; claims are\n"
      "counted over all combinations. After Ctrl-C the same command continues.");
  command->callback([arguments, &invocation] {
    const Paper& paper = analysis::paper(arguments->paper);
    const std::string& study = arguments->paper;
    const std::vector<Dimension> all = dimensions(study);
    if (!paper.multiverse || all.empty())
      throw std::invalid_argument(fmt::format("the program has no multiverse of the paper {}", study));
    const Scope scope = arguments->small ? Scope::small : Scope::usual;
    const std::vector<Dimension> varied =
        arguments->dimensions.empty() ? within(scope, all) : named(arguments->dimensions, all);
    if (arguments->list) {
      refuse_varied(arguments->overrides, varied);
      fmt::print("{}",
                 dimension_list(load_study(study, arguments->overrides), all, varied, arguments->output.is_verbose));
      return;
    }
    solve_and_tell(paper, *arguments, varied, invocation);
  });
}

}  // namespace ikbench::cli
