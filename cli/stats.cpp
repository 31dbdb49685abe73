// ikbench stats: the statistics of any data: a CSV of observations, or of published means and standard deviations.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <memory>
#include <set>
#include <stdexcept>

#include "analysis/inference/margin.hpp"
#include "analysis/inference/observations_csv.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/assessment.hpp"
#include "analysis/report/publish.hpp"
#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/plan_options.hpp"
#include "cli/reporting.hpp"
#include "experiments/environment.hpp"
#include "results/csv.hpp"

namespace ikbench::cli {

using namespace results;
using namespace experiments;
using namespace inference;
using namespace report;

namespace {

struct StatsArguments {
  std::string file, summaries;
  std::vector<std::string> values;
  CsvRequest csv;
  bool wide = false, rows_are_blocks = false, larger = false, forced = false, without_figures = false;
  std::string quantity, out, estimand = "mean";
  AnalysisPlan plan;
  double margin = 0;  // absolute; replaces the plan's
  OutputArguments output;
};

std::string name_of_source(const std::string& file) { return file == "-" ? "standard input" : file; }

// Reads the file, or standard input for "-".
std::string contents_of(const std::string& file) {
  if (file == "-") return csv_text(std::cin, name_of_source(file));
  if (std::filesystem::is_directory(file)) {
    throw std::invalid_argument(fmt::format("{} is a folder; expected a CSV file", file));
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    throw std::invalid_argument(fmt::format("cannot read {}; expected a CSV file, or - for standard input", file));
  }
  std::error_code error;  // a pipe has no size
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  return csv_text(stream, name_of_source(file), error ? 0 : size);
}

// A name for the files of a quantity; if two quantities share a name, the later one gets a number.
std::string distinct(const std::string& name, std::set<std::string>& taken) {
  std::string result = name;
  for (int number = 2; !taken.insert(result).second; ++number) result = fmt::format("{}-{}", name, number);
  return result;
}

std::vector<Assessment> assessments_of(const StatsArguments& arguments, ReportProgress& progress) {
  std::vector<Assessment> result;
  std::set<std::string> names;
  const Better better = arguments.larger ? Better::larger : Better::smaller;
  const auto add = [&](Observations observations, std::int64_t all) {
    progress.show(ReportStep::judging, std::ssize(result), all);
    observations.better = better;
    observations.name = distinct(observations.name, names);
    if (!arguments.quantity.empty()) {
      observations.quantity = arguments.quantity;
      observations.unit = split_unit(arguments.quantity).unit;
    }
    observations.margin = arguments.margin;
    check_margin(observations, arguments.plan);
    result.push_back(assess(observations, arguments.plan));
  };
  if (!arguments.summaries.empty()) {
    std::vector<Observations> all =
        read_summaries(contents_of(arguments.summaries), name_of_source(arguments.summaries));
    if (!arguments.quantity.empty() && all.size() > 1) {
      throw std::invalid_argument(
          fmt::format("--quantity names one quantity, but {} has {}", arguments.summaries, all.size()));
    }
    for (Observations& summaries : all) add(std::move(summaries), std::ssize(all));
    return result;
  }
  CsvRequest request = arguments.csv;
  request.better = better;
  request.takes_any_rows = arguments.forced;
  request.scale = arguments.estimand == name_of(Estimand::typical) ? ValueScale::log10 : ValueScale::plain;
  request.is_wide = arguments.wide;
  request.rows_are_blocks = arguments.rows_are_blocks;
  const std::string text = contents_of(arguments.file);
  std::vector<std::string> values = arguments.values;
  if (values.empty()) values.emplace_back();
  for (const std::string& value : values) {
    request.value = value;
    add(read_observations(text, name_of_source(arguments.file), request), std::ssize(values));
  }
  return result;
}

void check(const StatsArguments& arguments) {
  if (arguments.file.empty() == arguments.summaries.empty()) {
    throw std::invalid_argument("expected either a CSV file of observations or --summaries FILE.csv; see --help");
  }
  if (!arguments.summaries.empty()) {
    if (!arguments.values.empty() || arguments.wide || arguments.rows_are_blocks || !arguments.csv.group.empty() ||
        !arguments.csv.block.empty() || !arguments.csv.run.empty()) {
      throw std::invalid_argument(
          "--summaries has its own columns (name, mean, sd, n); leave out --value, --group, --block, --run, --wide and "
          "--rows-are-blocks");
    }
    if (arguments.estimand != name_of(Estimand::mean)) {
      throw std::invalid_argument(
          fmt::format("--estimand is {}; expected mean with --summaries, which have no values", arguments.estimand));
    }
    return;
  }
  const std::set<std::string> different(arguments.values.begin(), arguments.values.end());
  if (different.size() < arguments.values.size()) {
    throw std::invalid_argument("--value names a column twice; expected each column once");
  }
  if (!arguments.quantity.empty() && arguments.values.size() > 1) {
    throw std::invalid_argument(
        fmt::format("--quantity names one quantity, but --value is given {} times", arguments.values.size()));
  }
  if (!arguments.wide && arguments.values.empty()) {
    throw std::invalid_argument(
        "expected --value COLUMN, the column of the numbers (and --group COLUMN); or --wide if every column is a "
        "group");
  }
  if (arguments.wide && arguments.values.size() > 1) {
    throw std::invalid_argument(
        "with --wide every column is a group; expected at most one --value, which names the quantity");
  }
  if (arguments.rows_are_blocks && !arguments.wide) {
    throw std::invalid_argument("--rows-are-blocks needs --wide; with one value per row, use --block COLUMN");
  }
}

// Refuses a margin in cm if no quantity is in cm.
void check_margin_cm(const AnalysisPlan& plan, const std::vector<Assessment>& all) {
  if (plan.margin_cm == 0 || std::ranges::count(all, "cm", &Assessment::unit) > 0) return;
  throw std::invalid_argument(
      "--margin-cm: no quantity is in cm; expected a column whose name ends in _cm, or --quantity \"NAME [cm]\"");
}

// The answer of each quantity, then the groups of each, the pairs of each, the tests, and what else is to be said.
std::vector<Part> screen_of(const std::vector<Assessment>& all, const Report& report, const OutputArguments& output) {
  std::vector<Part> parts;
  for (const Assessment& assessment : all) {
    const std::string first = assessment.sentences.empty() ? "" : words_of(assessment.sentences.front());
    parts.push_back({.items = {fmt::format("{}\n{}", wrapped(heading_of(assessment)),
                                           coloured(wrapped(first), tone_of(assessment.findings.lead)))},
                     .noun = "answer",
                     .least = screen_lines});
  }
  for (const std::string_view kind : {"groups", "contrasts", "tests"}) {
    for (const Assessment& assessment : all) {
      for (const Table& table : assessment.tables) {
        if (!table.name.ends_with(kind)) continue;
        Part rows = table_rows(table, output, 0);
        rows.items.front().insert(0, fmt::format("\n{}\n", wrapped(table.caption)));
        parts.push_back(std::move(rows));
      }
    }
  }
  for (const Assessment& assessment : all) {
    std::vector<std::string> said = words_of(assessment.sentences);
    if (!said.empty()) said.erase(said.begin());
    if (all.size() > 1) {
      for (std::string& sentence : said) sentence.insert(0, assessment.quantity + ": ");
    }
    parts.push_back(sentences(said));
  }
  parts.push_back(warnings(report.warnings));
  parts.push_back({.items = {fmt::format("Report: {}", printable(report.page.string()))}});
  return parts;
}

report::Json json_of(const std::vector<Assessment>& all, const Report& report) {
  report::Json json{
      {"report", report.page.string()}, {"quantities", report::Json::array()}, {"warnings", report.warnings}};
  for (const Assessment& assessment : all) {
    json["quantities"].push_back({{"quantity", assessment.quantity},
                                  {"is_flawed", !assessment.flaws.empty()},
                                  {"lead", name_of(assessment.findings.lead)},
                                  {"pairs", rows_json(assessment.findings.pairs)}});
  }
  return json;
}

}  // namespace

void add_stats(CLI::App& app, Invocation& invocation) {
  auto arguments = std::make_shared<StatsArguments>();
  CLI::App* command =
      app.add_subcommand("stats", "Compare groups in a CSV: which is better, by how much, on what evidence");
  command->add_option("FILE", arguments->file, "CSV of observations, one value per row; - for standard input");
  command->add_option(
      "--summaries", arguments->summaries,
      "instead of FILE: CSV of published numbers with columns name, mean, sd, n and, for several quantities, metric");
  command->add_option("--value", arguments->values, "column of the numbers; repeat for several")
      ->allow_extra_args(false);
  command->add_option("--group", arguments->csv.group, "column of the groups; default: group, solver or algorithm");
  command->add_option("--block", arguments->csv.block,
                      "column of the blocks: the problem or target that all groups shared");
  command->add_option("--run", arguments->csv.run,
                      "column of the runs: the rows of a run are averaged into one observation; with --block, the "
                      "runs of each block");
  command->add_flag("--wide", arguments->wide, "every column is a group");
  command->add_flag("--rows-are-blocks", arguments->rows_are_blocks, "with --wide: each row is a block");
  command->add_flag("--larger-is-better", arguments->larger, "larger values are better; default: smaller");
  command
      ->add_option("--estimand", arguments->estimand,
                   "what of positive values is compared; mean: their mean, which the worst cases decide if they span "
                   "decades; typical: their geometric mean")
      ->check(CLI::IsMember({name_of(Estimand::mean), name_of(Estimand::typical)}))
      ->capture_default_str();
  command->add_option("--quantity", arguments->quantity, "name of the quantity with its unit: \"position error [cm]\"");
  command->add_flag("--force", arguments->forced,
                    "accept repeated rows of a run as observations, and average incomplete runs and blocks; the "
                    "report says so");
  add_plan_options(*command, arguments->plan);
  command
      ->add_option("--margin-absolute", arguments->margin,
                   "in place of --margin: smallest difference that matters, in the unit of the values; for values that "
                   "may be negative, such as temperatures")
      ->check(number_in({0, 1e300}))
      ->excludes("--margin");
  command->add_option("--out", arguments->out, "folder for the report; default: out/stats-<file>");
  command->add_flag("--no-figures", arguments->without_figures, "write tables, but draw no figures");
  add_output_options(*command, arguments->output);
  command->footer(
      "Examples:\n"
      "  ikbench stats results.csv --value error --group solver\n"
      "  ikbench stats auc.csv --value auc --group classifier --block dataset --larger-is-better\n"
      "  ikbench stats benchmark.csv --value error --group solver --block problem --run seed\n"
      "  ikbench export out/slim2023/store.sqlite | ikbench stats - --value position_error_cm --group solver --run "
      "run\n"
      "  ikbench stats --summaries published.csv --quantity \"position error [cm]\"\n\n"
      "Several problems with several seeds each: --block problem --run seed. If their scales differ, the largest decide\n"
      "a mean: --estimand typical compares ratios within each problem.\n"
      "Rows that depend on each other, such as the points of one path: --run.\n\n"
      "Write Inf for a run that crashed (-Inf where larger is better): it then ranks last. A missing, empty or NaN\n"
      "value makes its run or block incomplete. Incomplete runs and blocks are left out, and the first lines warn.\n\n"
      "docs/reading-a-report.md explains every line of the output, docs/your-own-csv.md has examples.\n\n"
      "Exit codes: 0 the report is written, whatever it says, also that nothing is decided or can be judged (ikbench\n"
      "compare --strict is the gate), 1 a mistake in the request or the data, 2 a failure of the program or the system.");
  command->callback([arguments, &invocation] {
    check(*arguments);
    if (arguments->margin > 0) arguments->plan.margin = 0;
    const std::string& source = arguments->summaries.empty() ? arguments->file : arguments->summaries;
    const std::string stem = source == "-" ? "input" : std::filesystem::path(source).stem().string();
    const EndOnSignal at_once("Stopped. No report was written.");
    ReportProgress progress;
    const std::vector<Assessment> assessments = assessments_of(*arguments, progress);
    check_margin_cm(arguments->plan, assessments);
    const Report report = write_statistics(
        {.study = source,
         .kind = "Statistics of the file",
         .title = fmt::format("Statistics of {}",
                              source == "-" ? "standard input" : std::filesystem::path(source).filename().string()),
         .command = invocation.command,
         .assessments = assessments},
        arguments->out.empty() ? default_folder("stats-" + stem) : std::filesystem::path(arguments->out),
        {.render = !arguments->without_figures,
         .progress = [&](std::int64_t drawn,
                         std::int64_t figures) { progress.show(ReportStep::drawing, drawn, figures); },
         .program = program_name()});
    progress.end();
    if (!arguments->output.is_json) {
      return show_screen(screen_of(assessments, report, arguments->output), arguments->output,
                         fmt::format(", and {} has it", report.file.string()));
    }
    for (const std::string& warning : report.warnings) warn(warning);
    show_json(json_of(assessments, report));
  });
}

}  // namespace ikbench::cli
