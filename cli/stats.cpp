// ikbench stats: compares the groups of a user's CSV file, or of printed means and standard deviations.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "analysis/csv/user_csv.hpp"
#include "analysis/figures/of_study.hpp"
#include "analysis/show/phrases.hpp"
#include "analysis/show/report.hpp"
#include "analysis/show/result_tables.hpp"
#include "analysis/show/terminal.hpp"
#include "base/csv.hpp"
#include "base/inputs.hpp"
#include "base/json.hpp"
#include "cli/console.hpp"
#include "cli/file_kind.hpp"
#include "cli/reporting.hpp"

namespace ikbench::cli {

namespace {

struct StatsArguments {
  std::string file, test, margin, out, decimal;
  csv::Request csv;
  results::AnalysisPlan plan;
  ReportArguments report;
};

// Returns the name of a file in messages.
std::string name_of_source(const std::string& file) { return file == "-" ? "standard input" : file; }

std::string contents_of(const std::string& file) {
  if (file == "-") return base::csv_text(std::cin, name_of_source(file));
  std::error_code none;
  if (std::filesystem::is_regular_file(file, none)) return base::text_of_file(file, base::max_csv_bytes);
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file, none))
    throw std::invalid_argument(fmt::format("cannot read {}; expected a CSV file, or - for standard input", file));
  return base::csv_text(stream, file);
}

// Returns "smaller is better (quality: larger)".
std::string direction_text(const std::vector<judge::JudgedMetric>& metrics) {
  std::vector<std::string> larger;
  for (const judge::JudgedMetric& metric : metrics)
    if (metric.samples.better == judge::Better::larger) larger.push_back(metric.samples.quantity);
  if (larger.size() == metrics.size()) return "larger is better";
  return "smaller is better" + (larger.empty() ? "" : fmt::format(" ({}: larger)", fmt::join(larger, ", ")));
}

// Reads and judges the file. If there is a folder for a report, draws figures too, and sets `style` to their look.
show::Report judge_file(const StatsArguments& arguments, FigureStyle& style) {
  const std::string text = contents_of(arguments.file), source = name_of_source(arguments.file);
  refuse_no_table(text, arguments.file);
  csv::Quantities quantities = csv::read(text, source, arguments.csv);
  std::vector<judge::JudgedMetric> metrics;
  for (judge::MetricSamples& samples : quantities.samples) {
    const results::AnalysisPlan plan = csv::with_margin(arguments.plan, arguments.margin, samples);
    if (arguments.margin.empty() && plan.margin == 0)
      quantities.notes.push_back(fmt::format("{} may be negative, so no margin is used.", samples.quantity));
    metrics.push_back(judge::judge(std::move(samples), plan));
  }
  show::Report reported;
  if (!arguments.out.empty()) {
    std::vector<results::Series> groups;
    for (const judge::Group& group : metrics.front().samples.groups)
      groups.push_back({.label = group.name, .algorithm = group.name});
    style = apply_style({}, labels_of({.series = groups}), arguments.report);
    const figures::Look look = figures::look_of(groups, style);
    reported.figures = figures::of_file(metrics, look);
    style = look.style;
  }
  const std::string direction = direction_text(metrics);
  reported.model = show::make_report_model(std::move(metrics));
  reported.model.direction = direction;
  if (reported.model.primary().samples.is_paired) reported.model.noun = "blocks";
  reported.study.name = std::filesystem::path(source).filename().string();
  reported.model.notes = std::move(quantities.notes);
  return reported;
}

void stats(const StatsArguments& arguments) {
  for (const char* file : {"store.sqlite", "solves.csv"}) {
    std::error_code unknown;  // if the place cannot be looked at, writing says why
    if (!arguments.out.empty() && std::filesystem::exists(std::filesystem::path(arguments.out) / file, unknown))
      throw std::invalid_argument(
          fmt::format("--out {}: the folder has the {} of a study; choose another folder", arguments.out, file));
  }
  FigureStyle style;
  show::Report reported = judge_file(arguments, style);
  if (!arguments.out.empty()) return write_and_print(std::move(reported), arguments.out, arguments.report, style);
  if (arguments.report.is_json) return show_json(show::to_json(reported.model));
  if (reported.model.primary().comparisons.size() > show::max_pairs)
    reported.model.notes.emplace_back("For a report with all pairs, rerun with --out NEW.");
  fmt::print("{}", printable(show::terminal_report(reported.model, "")));
}

// Prints the question with the commands that answer it.
void ask(const csv::MissingOption& question, const Invocation& invocation) {
  print_error(question.what());
  if (!question.columns.empty()) {
    const std::string table = align_columns(question.columns);
    print_message(std::string_view(table).substr(0, table.size() - 1));
  }
  for (const std::vector<std::string>& answer : question.answers)
    print_command(shell_command(invocation.command, answer));
  if (!question.options.empty()) print_command(shell_command(invocation.command, question.options));
  if (!question.advice.empty()) print_message(question.advice + " Examples: docs/your-own-csv.md");
}

// Sets what the options imply, and compares the groups. A question or a file that is not a table makes exit code 1.
void run_stats(StatsArguments& arguments, Invocation& invocation) {
  if (arguments.test == "means" || arguments.csv.are_summaries)
    arguments.plan.test = results::AnalysisPlan::Test::means;
  if (!arguments.decimal.empty()) arguments.csv.decimal = arguments.decimal[0];
  arguments.csv.are_means = arguments.plan.test == results::AnalysisPlan::Test::means;
  if (arguments.csv.are_means && arguments.csv.missing == "worst")
    throw std::invalid_argument(
        "--missing worst: a mean cannot count a value without an answer; use --missing drop, or --test ranks");
  try {
    stats(arguments);
  } catch (const csv::MissingOption& question) {
    ask(question, invocation);
    invocation.exit_code = 1;
  } catch (const NotATable& mistake) {
    print_error(mistake.what());
    if (!mistake.command.empty()) print_command(mistake.command);
    invocation.exit_code = 1;
  }
}

}  // namespace

void add_stats(const Command& command, Invocation& invocation) {
  auto arguments = std::make_shared<StatsArguments>();
  csv::Request& csv = arguments->csv;
  command
      .add("FILE", &arguments->file,
           "CSV with a column of names and one of values, or a column of values per solver; - for standard input")
      .required();
  command.add("--better", &csv.better,
              "required: smaller or larger is better; COLUMN=larger for one of several columns; repeatable");
  command.add("--label", &csv.label,
              "column (or several) with the names of what is compared; `columns`: each column of numbers is one");
  command.add("--value", &csv.values, "column of values; repeatable; not needed if only one is left");
  command.add(
      "--block", &csv.block,
      "column (or several) of the problem that all of them had; compares within it; row, with --label columns: each "
      "row is one");
  command.add("--run", &csv.run, "column of repeats, whose rows are averaged; row: each row is one repeat");
  command.add("--where", &csv.where, "COLUMN=VALUE: use only these rows; repeatable");
  command.add("--summaries", &csv.are_summaries,
              "FILE has published means: columns name, n, mean, sd and, if there are several, metric");
  command.add("--n", &csv.n, "number of values of each published mean, if the file has no column n")
      .whole_number({2, 1'000'000'000})
      .needs("--summaries");
  command
      .add("--missing", &csv.missing,
           "required if rows have no value: drop leaves them out, worst counts each as no answer")
      .one_of({"drop", "worst"})
      .excludes("--summaries");
  command.add("--decimal", &arguments->decimal, "decimal mark [found in the file]").one_of({".", ","});
  command.add("--test", &arguments->test, "compare ranks or means [ranks]").one_of({"ranks", "means"});
  command.add("--control", &arguments->plan.control, "compare only with this group");
  command.add("--margin", &arguments->margin, "difference that matters: 5%, or 0.1 in the unit of the values [5%]");
  command.add("--significance", &arguments->plan.significance, "level for all pairs together").number_in({0.0001, 0.2});
  add_out_option(command, arguments->out, "folder to write a report to");
  add_report_options(command, arguments->report);
  for (const char* name : {"--figures", "--style"}) command.option(name).needs("--out");
  command.footer(
      "  ikbench stats results.csv --better smaller\n"
      "  ikbench stats benchmark.csv --label solver --value error --block target \\\n"
      "      --run seed --better smaller\n"
      "  ikbench stats --summaries published.csv --better smaller\n\n"
      "docs/your-own-csv.md has a command for each of eight kinds of table.");
  command.callback([arguments, &invocation] { run_stats(*arguments, invocation); });
}

}  // namespace ikbench::cli
