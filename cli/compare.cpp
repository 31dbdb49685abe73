// ikbench compare: is a variant of a solver better, the same or worse than its baseline?
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <map>
#include <memory>
#include <span>
#include <stdexcept>
#include <utility>

#include "analysis/inference/text.hpp"
#include "analysis/report/assessment_words.hpp"
#include "analysis/report/variants_table.hpp"
#include "cli/commands.hpp"
#include "cli/comparing.hpp"
#include "cli/console.hpp"
#include "cli/plan_options.hpp"
#include "numerics/names.hpp"
#include "results/files.hpp"

namespace ikbench::cli {

using namespace numerics;
using namespace solvers;
using namespace results;
using namespace experiments;
using namespace inference;
using namespace report;

namespace {

constexpr int regression = 3, undecided = 4;  // exit codes

// "a, b or c"
std::string metric_names() {
  std::vector<std::string_view> names;
  for (const Metric metric : compared_metrics()) names.push_back(name_of(metric));
  return fmt::format("{} or {}", fmt::join(names.begin(), names.end() - 1, ", "), names.back());
}

// A note of each label; once if it is that of all labels.
std::vector<std::string> notes_of(const ComparedLabels& compared, const std::vector<std::string>& notes) {
  std::vector<VariantComparison> bare;
  for (std::size_t i = 0; i < compared.comparisons.size(); ++i)
    bare.push_back({.label = compared.comparisons[i].label, .notes = {notes[i]}});
  return variants_notes(bare);
}

std::vector<std::string> failures_of(const ComparedLabels& compared) {
  std::vector<std::string> failures;
  for (const VariantComparison& comparison : compared.comparisons) failures.push_back(comparison.failures);
  return notes_of(compared, failures);
}

// The notes without those on settings, failures and what is not compared.
std::vector<std::string> other_notes(const ComparedLabels& compared) {
  std::vector<VariantComparison> others = compared.comparisons;
  for (std::size_t i = 0; i < others.size(); ++i) {
    std::vector<std::string>& notes = others[i].notes;
    std::erase(notes, compared.differences[i]);
    std::erase(notes, others[i].failures);
    for (const MetricComparison& metric : others[i].metrics) {
      for (const std::string& why : list_of(metric.why_not)) std::erase(notes, why);
    }
  }
  return variants_notes(others);
}

// Returns whether a row says no more than that the two are not compared, or are equal in every bit.
bool is_bare(const MetricComparison& metric) {
  const Finding finding = metric.finding();
  return !metric.is_compared() || (finding.is_fact && finding.relation == Relation::same);
}

// Says the bare rows in sentences: "Equal bit for bit: solved, evaluations of DLS."
std::vector<std::string> bare_rows(const ComparedLabels& compared, const Table& table) {
  std::map<std::string, std::map<std::string, std::vector<std::string>>> said;  // labels by metric by what is said
  std::size_t row = 0;
  for (const VariantComparison& comparison : compared.comparisons) {
    for (const MetricComparison& metric : comparison.metrics) {
      const std::vector<Cell>& cells = table.rows[row++];
      if (!is_bare(metric)) continue;
      const std::string remark = metric.is_compared() ? capitalised(readable(cells.back()))
                                 : metric.why_not.empty()
                                     ? fmt::format("Not compared: {}", readable(cells.back()))
                                     : fmt::format("{} Not compared", list_of(metric.why_not).front());
      said[remark][readable(cells[1])].push_back(comparison.label);
    }
  }
  std::vector<std::string> sentences;
  for (const auto& [what, metrics] : said) {
    std::vector<std::string> names;
    for (const auto& [metric, labels] : metrics) {
      const bool is_of_all = labels.size() == compared.comparisons.size();
      names.push_back(is_of_all ? metric : fmt::format("{} of {}", metric, listed(labels)));
    }
    sentences.push_back(fmt::format("{}: {}.", what, fmt::join(names, ", ")));
  }
  return sentences;
}

// The metrics in the order of a reader: what is worse, what is open, the others. Numbers of rows of the table.
struct Shown {
  std::vector<std::size_t> rows;
  std::vector<Tone> tones;
};

Shown shown_first(const std::vector<VariantComparison>& comparisons, bool with_bare) {
  struct Row {
    int place;
    std::size_t row;
    Tone tone;
  };
  std::vector<Row> rows;
  std::size_t number = 0;
  for (const VariantComparison& comparison : comparisons) {
    for (const MetricComparison& metric : comparison.metrics) {
      const int place = is_regression(metric) ? 0 : is_open(metric) ? 1 : 2;
      if (with_bare || !is_bare(metric)) rows.push_back({place, number, tone_of(reversed(metric.finding().relation))});
      ++number;
    }
  }
  std::ranges::stable_sort(rows, {}, &Row::place);
  Shown shown;
  for (const Row& row : rows) {
    shown.rows.push_back(row.row);
    shown.tones.push_back(row.tone);
  }
  return shown;
}

Table in_order(Table table, const std::vector<std::size_t>& order) {
  std::vector<std::vector<Cell>> rows;
  for (const std::size_t row : order) rows.push_back(table.rows[row]);
  table.rows = std::move(rows);
  return table;
}

// The remarks on metrics that are not decided.
std::vector<std::string> remarks_on_open(const Table& table, const std::vector<VariantComparison>& comparisons) {
  std::vector<std::string> remarks;
  std::size_t row = 0;
  for (const VariantComparison& comparison : comparisons) {
    for (const MetricComparison& metric : comparison.metrics) {
      const std::vector<Cell>& cells = table.rows[row++];
      const std::string remark = readable(cells.back());
      if (!metric.is_compared() || !is_open(metric) || remark.empty()) continue;
      remarks.push_back(
          fmt::format("{}{}: {}.", comparisons.size() == 1 ? "" : comparison.label + ", ", readable(cells[1]), remark));
    }
  }
  return remarks;
}

// The verdict, what is compared, the rows with their tones, and the notes.
std::vector<Part> screen_of(const ComparedLabels& compared, const OutputArguments& output, bool counts_as_failure) {
  constexpr std::array<std::string_view, 11> columns{"label", "metric", "B_is", "mean_A", "mean_B", "B_by_A",
                                                     "low",   "high",   "p",    "level",  "remark"};
  constexpr std::size_t of_rows = 14, of_settings = 3, of_notes = 6;
  Shown order = shown_first(compared.comparisons, output.is_verbose);
  Tones tones{.column = 2};
  tones.of_rows = std::move(order.tones);
  const auto is_unknown = [](const MetricComparison& metric) { return is_open(metric); };
  const Tone tone = any_metric(compared.comparisons, is_regression) ? Tone::bad
                    : any_metric(compared.comparisons, is_unknown)  ? Tone::open
                                                                    : Tone::good;
  const std::string verdict = variants_verdict(compared.comparisons, compared.plan);
  const Table table = variants_table(compared.comparisons, compared.plan);
  std::vector<std::string> notes;  // with --verbose the table has the remarks
  if (!output.is_verbose) notes = remarks_on_open(table, compared.comparisons);
  std::ranges::copy(compared.notes, std::back_inserter(notes));
  std::ranges::move(other_notes(compared), std::back_inserter(notes));
  const bool is_of_two = compared.comparisons.front().is_of_two;
  const std::vector<std::string> settings = notes_of(compared, compared.differences);
  std::vector<Part> parts{
      {.items = {coloured(wrapped(verdict + (counts_as_failure ? " With --strict this counts as a failure." : "")),
                          tone)}},
      sentences(failures_of(compared), of_settings),
      sentences(is_of_two ? std::vector<std::string>() : settings, of_settings),
      {.items = {wrapped(compared.headline), ""}}};
  if (!order.rows.empty()) {
    const Table ordered = in_order(table, order.rows);  // sentences of a short screen have the remarks
    const Table shown = output.is_verbose ? with_columns(ordered, columns) : short_table(ordered);
    parts.push_back(table_rows(shown, output, of_rows, tones));
    parts.push_back({.items = {""}});
  }
  parts.push_back(sentences(bare_rows(compared, table), of_settings));
  if (is_of_two) parts.push_back(sentences(settings, of_settings));  // two solvers differ in many
  parts.push_back(sentences(notes, of_notes));
  parts.emplace_back();
  return parts;
}

// The verdict, the columns of a reader, and folded all columns and notes.
std::string markdown(const ComparedLabels& compared, const Table& table) {
  std::vector<std::string> notes{compared.headline};
  std::ranges::move(notes_of(compared, compared.differences), std::back_inserter(notes));
  for (const std::vector<std::string>& more :
       {failures_of(compared), bare_rows(compared, table), table.notes, compared.notes, other_notes(compared)})
    std::ranges::copy(more, std::back_inserter(notes));
  Table whole = in_order(table, shown_first(compared.comparisons, true).rows);
  whole.notes.clear();
  const std::string in_short = to_markdown(short_table(whole));
  whole.notes = std::move(notes);
  return fmt::format("{}\n\n{}\n<details>\n<summary>All columns and notes</summary>\n\n{}\n</details>\n",
                     markdown_text(variants_verdict(compared.comparisons, compared.plan)), in_short,
                     to_markdown(whole));
}

void refuse_output(const CompareArguments& arguments, const std::filesystem::path& file) {
  const std::string type = file.extension().string();
  if (type != ".md" && type != ".csv" && type != ".json") {
    throw std::invalid_argument(
        fmt::format("-o {}: expected a file name that ends in .md, .csv or .json", file.string()));
  }
  for (const std::string& store : {arguments.a, arguments.b, arguments.store}) {
    std::error_code error;
    if (std::filesystem::equivalent(file, store, error)) {
      throw std::invalid_argument(fmt::format("-o {} is one of the stores; choose another file", file.string()));
    }
  }
}

void write_output(const ComparedLabels& compared, const std::string& file, const Outcome& outcome) {
  const std::string type = std::filesystem::path(file).extension().string();
  const Table table = variants_table(compared.comparisons, compared.plan);
  write_through(file, type == ".md"    ? markdown(compared, table)
                      : type == ".csv" ? to_csv(table)
                                       : variants_json(compared.comparisons, compared.plan, outcome));
}

constexpr std::string_view outcome_name(int code) {
  return code == regression ? "worse" : code == undecided ? "undecided" : "passed";
}

int exit_code(const ComparedLabels& compared, const CompareArguments& arguments) {
  if (any_metric(compared.comparisons, is_regression)) return regression;
  // Times that nobody asked for do not count: those of two sessions cannot be compared.
  const auto counts = [&](const MetricComparison& metric) {
    return is_open(metric) && (metric.metric != Metric::seconds || !arguments.metrics.empty());
  };
  return arguments.strict && any_metric(compared.comparisons, counts) ? undecided : 0;
}

int tell(const ComparedLabels& compared, const CompareArguments& arguments) {
  const int code = exit_code(compared, arguments);
  const Outcome outcome{.name = outcome_name(code), .exit_code = code};
  for (const std::string& file : arguments.outputs) write_output(compared, file, outcome);
  if (arguments.output_as.is_json)
    fmt::print("{}", variants_json(compared.comparisons, compared.plan, outcome));
  else
    show_screen(screen_of(compared, arguments.output_as, code == undecided), arguments.output_as,
                arguments.outputs.empty() ? ", and -o FILE writes it"
                                          : fmt::format(", and {} has it", arguments.outputs.front()));
  return code;
}

void refuse_labels(const CompareArguments& arguments) {
  if (!arguments.other_study.empty())
    throw std::invalid_argument("--other-study needs two stores; with --store, A and B are labels of one study");
  if (!arguments.labels.empty())
    throw std::invalid_argument("--label needs two stores; with --store, A and B are already labels");
  if (arguments.a == arguments.b)
    throw std::invalid_argument(fmt::format("A and B are both the label {}; name two labels", arguments.a));
}

void refuse_margin(const CompareArguments& arguments) {
  const std::vector<std::string>& metrics = arguments.metrics;
  const auto is_in_cm = [](const std::string& metric) { return split_unit(metric).unit == "cm"; };
  if (arguments.margin_cm.value_or(0) == 0 || metrics.empty() || std::ranges::any_of(metrics, is_in_cm)) return;
  throw std::invalid_argument(
      "--margin-cm: no metric is in cm; expected --metric position_error_cm, or no --margin-cm");
}

int compare(const CompareArguments& arguments) {
  for (const std::string& file : arguments.outputs) refuse_output(arguments, file);
  refuse_margin(arguments);
  if (arguments.store.empty()) return tell(judged(labels_of_stores(arguments), arguments), arguments);
  refuse_labels(arguments);
  return tell(judged(labels_of_store(arguments, arguments.store, arguments.study), arguments), arguments);
}

}  // namespace

void add_compare(CLI::App& app, Invocation& invocation) {
  auto arguments = std::make_shared<CompareArguments>();
  CLI::App* command =
      app.add_subcommand("compare", "Decide whether a variant of a solver is better, the same or worse");
  command->add_option("A", arguments->a, "baseline: path of a store.sqlite, or a label with --store")->required();
  command->add_option("B", arguments->b, "candidate: path of a store.sqlite, or a label with --store")->required();
  command->add_option("--store", arguments->store, "store in which A and B are labels");
  command->add_option("--study", arguments->study, "name of the study; default: the first in A's store");
  command->add_option("--other-study", arguments->other_study,
                      "with two stores, which may be one file: name of B's study; default: as A's");
  command
      ->add_option("--label", arguments->labels,
                   "with two stores: compare only this label; repeat for more; default: all that both stores have")
      ->allow_extra_args(false);
  command
      ->add_option(
          "--metric", arguments->metrics,
          metric_names() +
              ", which are the default (of poses also orientation_error_deg), or another of ikbench list metrics; repeat for more")
      ->allow_extra_args(false);
  command
      ->add_option_function<std::string>(
          "--estimand",
          [arguments](const std::string& name) {
            arguments->estimand =
                static_cast<Estimand>(std::ranges::find(estimand_names, name) - estimand_names.begin());
          },
          "what of errors is compared; mean: their mean, which the worst cases decide; typical: their geometric mean; "
          "reliability: the share of solves within the tolerance; default: that of A's study")
      ->check(CLI::IsMember(std::vector<std::string>(estimand_names.begin(), estimand_names.end())));
  const CLI::Option *margin = add_margin_option(*command, arguments->plan.margin),
                    *margin_cm = add_margin_cm_option(*command, arguments->plan.margin_cm),
                    *significance = add_significance_option(*command, arguments->plan.significance);
  command->get_option("--significance")->description("significance level of all tests together");
  command->add_flag("--strict", arguments->strict,
                    "exit with 4 if nothing is worse but a metric is undecided or not compared; times count only with "
                    "--metric seconds");
  command
      ->add_option("-o,--output", arguments->outputs,
                   "also write the full table to this .md, .csv or .json file; repeat for more")
      ->allow_extra_args(false);
  add_output_options(*command, arguments->output_as);
  command->footer(
      "Examples:\n"
      "  ikbench compare before/store.sqlite after/store.sqlite\n"
      "  ikbench compare both.sqlite both.sqlite --study before --other-study after\n"
      "  ikbench compare IK-BA mine --store out/my/store.sqlite --metric position_error_cm --margin 10%\n"
      "In continuous integration, with the store of the last release as base.sqlite:\n"
      "  ikbench run my.toml --no-report --out new\n"
      "  ikbench compare base.sqlite new/store.sqlite --strict -o comparison.md\n\n"
      "A and B are judged as a report judges a study of these two solvers, by the test of A's plan. B is a regression where\n"
      "the whole interval of the difference is beyond the margin. All labels and metrics are judged together: if A and B are\n"
      "alike, the probability of exit code 3 is at most --significance.\n"
      "--margin, --margin-cm and --significance default to those of A's study.\n\n"
      "Exit codes: 0 no regression found, 1 a mistake in the request or a damaged store, 2 a failure of the program or the system\n"
      "(a full disk), 3 a regression beyond the margin, 4 (--strict only) nothing is worse, but something is undecided or not compared\n"
      "(evaluations that nobody counted do not matter), 128 + number of the signal (130: Ctrl-C).");
  command->callback([arguments, margin, margin_cm, significance, &invocation] {
    if (margin->count() > 0) arguments->margin = arguments->plan.margin;
    if (margin_cm->count() > 0) arguments->margin_cm = arguments->plan.margin_cm;
    if (significance->count() > 0) arguments->significance = arguments->plan.significance;
    invocation.exit_code = compare(*arguments);
  });
}

}  // namespace ikbench::cli
