// ikbench multiverse: the claims of a paper in every reading of what it leaves open.
#include "experiments/multiverse.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "analysis/show/publish.hpp"
#include "base/names.hpp"
#include "cli/console.hpp"
#include "cli/reporting.hpp"
#include "cli/running.hpp"
#include "experiments/environment.hpp"
#include "experiments/study_reader.hpp"

namespace ikbench::cli {

namespace {

struct MultiverseArguments {
  std::string paper, out;
  std::vector<std::string> dimensions;
  Overrides overrides;
  int seeds = 1, jobs = 1;
  bool list = false, small = false;
};

// Lists every question with its answers, the default first.
std::string dimension_list(const Study& study, const std::vector<Dimension>& all,
                           const std::vector<Dimension>& varied) {
  Rows rows{{"ANSWER", "NOTES", "VARIED", "WHERE"}};
  for (const Dimension& dimension : all) {
    for (const Alternative& answer : dimension.alternatives) {
      const auto place = std::ranges::find(varied, dimension.name, &Dimension::name);
      const bool is_varied = place != varied.end() && std::ranges::find(place->alternatives, answer.set,
                                                                        &Alternative::set) != place->alternatives.end();
      const bool is_default = &answer == &dimension.alternatives.front();
      rows.push_back({answer.set, dimension.section, is_default ? "default" : is_varied ? "yes" : "no", answer.where});
    }
  }
  const Multiverse choices = choices_of(varied, labels_of(study));
  std::int64_t settings = 0;
  for (const auto& of_study : choices.studies)
    for (const auto& of_solver : of_study.solvers) settings += std::ssize(of_solver);
  return fmt::format("{:.0f} readings of {}: {} for the study, {} for a seed\n{}", choices.readings(),
                     counted(std::ssize(varied), "questions"), counted(std::ssize(choices.studies), "choices"),
                     counted(settings, "solver settings"), aligned(rows));
}

void solve_and_tell(const papers::Paper& paper, const MultiverseArguments& arguments,
                    const std::vector<Dimension>& varied, const Plan& plan) {
  const std::filesystem::path folder = folder_for(paper.name + "-multiverse", arguments.out);
  show::claim(folder, show::files_of({"multiverse"}, {}));
  const show::Table table =
      papers::judged(paper,
                     solved_multiverse(paper.name, varied, {.seeds = arguments.seeds, .overrides = arguments.overrides},
                                       arguments.jobs),
                     plan)
          .table;
  show::write_table(table, table, folder / "tables", program_name());
  fmt::print("{}\nTable: {}\n", printable(fmt::format("{}:\n\n{}", table.caption, show::to_text(table))),
             printable((folder / "tables" / (table.name + ".csv")).string()));
}

}  // namespace

void add_multiverse(CLI::App& app, Invocation&) {
  auto arguments = std::make_shared<MultiverseArguments>();
  CLI::App* command =
      app.add_subcommand("multiverse", "Judge the claims of a paper in every reading of what it leaves open");
  add_paper_option(*command, arguments->paper);
  command->add_flag("--list", arguments->list, "list the open questions and the size, without solving");
  CLI::Option* small =
      command->add_flag("--small", arguments->small, "fewer questions: what `ikbench reproduce` shows");
  add_with_default(*command, "--dimensions", arguments->dimensions,
                   "vary these questions instead, with all their answers: bounds,population")
      ->delimiter(',')
      ->excludes(small);
  add_number(*command, "--seeds", arguments->seeds, {1, 1000},
             "number of seeds, counted from 1; each is a study of its own");
  add_number(*command, "--jobs", arguments->jobs, {1, 1024},
             "number of solvers at once; the results do not depend on it");
  add_with_default(*command, "--set", arguments->overrides, "change a key in every reading: runs=5, path.points=10");
  add_out_option(*command, arguments->out, "folder for the table; default: out/PAPER-multiverse");
  command->footer(
      "  ikbench multiverse slim2023 --list\n"
      "  ikbench multiverse slim2023 --small --seeds 2 --out out/small\n"
      "  ikbench multiverse slim2023 --dimensions bounds,population,wrist_branch\n\n"
      "A reading is one choice for every question. Each solver is solved once for each of its own choices; claims are "
      "judged in all combinations.");
  command->callback([arguments] {
    const papers::Paper& paper = papers::paper_named(arguments->paper);
    const std::vector<Dimension> all = dimensions(arguments->paper);
    if (all.empty())
      throw std::invalid_argument(fmt::format("the program has no open questions of {}", arguments->paper));
    const Scope scope = arguments->small ? Scope::small : Scope::usual;
    const std::vector<Dimension> varied =
        arguments->dimensions.empty() ? within(scope, all) : named(arguments->dimensions, all);
    refuse_varied(arguments->overrides, varied);
    const Study study = load_study(paper.name, arguments->overrides);
    check_plan(study);
    if (arguments->list) return fmt::print("{}", dimension_list(study, all, varied));
    solve_and_tell(paper, *arguments, varied, study.plan);
  });
}

}  // namespace ikbench::cli
