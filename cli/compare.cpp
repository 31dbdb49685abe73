// ikbench compare: is a variant of a solver better, the same or worse than its baseline?
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>

#include "analysis/inference/analysis_plan.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/variants_table.hpp"
#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/plan_options.hpp"
#include "cli/reporting.hpp"
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

struct CompareArguments {
  std::string a, b, store, study, output;
  std::vector<std::string> labels, metrics;
  AnalysisPlan plan = {};             // where the options say it
  std::optional<double> margin = {};  // given; else the study of A says it
  std::optional<double> significance = {};
  bool strict = false;
};

// What is held against what, and by which margin.
struct Compared {
  std::string headline;
  MarginQuestion question;
  std::vector<VariantComparison> comparisons;
  std::vector<std::string> notes;
};

MarginQuestion question_of(const CompareArguments& arguments, const StudyEntry& study) {
  const AnalysisPlan plan = plan_of(study);
  return {.margin = arguments.margin.value_or(plan.margin),
          .significance = arguments.significance.value_or(plan.significance),
          .power = plan.power};
}

std::vector<std::string> labels_of(const std::vector<Variant>& variants) {
  std::vector<std::string> labels;
  for (const Variant& variant : variants) labels.push_back(variant.series.label);
  return labels;
}

const Variant* find(const std::vector<Variant>& variants, const std::string& label) {
  const auto found = std::ranges::find(variants, label, [](const Variant& variant) { return variant.series.label; });
  return found == variants.end() ? nullptr : &*found;
}

const Variant& the(const std::vector<Variant>& variants, const std::string& label, const std::string& where) {
  if (const Variant* found = find(variants, label)) return *found;
  throw std::invalid_argument(where + unknown_name("label", label, labels_of(variants)));
}

std::string asked(const MarginQuestion& question) {
  return fmt::format("margin {}, significance {:g} for each test", percent(question.margin), question.significance);
}

Compared compare_labels(const CompareArguments& arguments) {
  if (!arguments.labels.empty())
    throw std::invalid_argument("--label needs two stores; with --store, A and B are already labels");
  if (arguments.a == arguments.b)
    throw std::invalid_argument(fmt::format("A and B are both the label {}", arguments.a));
  const Store store(arguments.store, Store::Mode::read);
  const StudyEntry study = chosen_study(store, arguments.study);
  const std::vector<Variant> all = variants(store, study);
  Compared compared{.question = question_of(arguments, study)};
  compared.headline = fmt::format("B: {}, against A: {}, in study {}; {}.", arguments.b, arguments.a, study.name,
                                  asked(compared.question));
  const Variant &baseline = the(all, arguments.a, "A: "), &candidate = the(all, arguments.b, "B: ");
  compared.comparisons.push_back(compare_variants(baseline, candidate, arguments.metrics, compared.question));
  return compared;
}

Store opened(const std::string& file) {
  if (std::filesystem::exists(file)) return Store(file, Store::Mode::read);
  throw std::invalid_argument(
      fmt::format("store '{}' does not exist; to compare two labels of one store, add --store FILE", file));
}

// Of the name of A's study, where the store has one and no other is asked for.
StudyEntry partner(const Store& store, const CompareArguments& arguments, const StudyEntry& of_a) {
  if (!arguments.study.empty()) return store.study(arguments.study);
  for (StudyEntry& study : store.studies()) {
    if (study.name == of_a.name) return std::move(study);
  }
  return chosen_study(store, "");
}

std::vector<std::string> common_labels(const std::vector<Variant>& a, const std::vector<Variant>& b,
                                       Compared& compared) {
  std::vector<std::string> common, alone;
  for (const std::string& label : labels_of(a)) (find(b, label) != nullptr ? common : alone).push_back(label);
  for (const std::string& label : labels_of(b)) {
    if (find(a, label) == nullptr) alone.push_back(label);
  }
  if (common.empty()) {
    throw std::invalid_argument(fmt::format("A and B have no label in common (A: {}; B: {})",
                                            fmt::join(labels_of(a), ", "), fmt::join(labels_of(b), ", ")));
  }
  if (!alone.empty())
    compared.notes.push_back(fmt::format("Not compared, because only one store has them: {}.", fmt::join(alone, ", ")));
  return common;
}

Compared compare_stores(const CompareArguments& arguments) {
  const Store of_a = opened(arguments.a), of_b = opened(arguments.b);
  const StudyEntry first = chosen_study(of_a, arguments.study), second = partner(of_b, arguments, first);
  const std::vector<Variant> a = variants(of_a, first), b = variants(of_b, second);
  Compared compared{.question = question_of(arguments, first)};
  compared.headline = fmt::format("B: {} in {}, against A: {} in {}; {}.", second.name, arguments.b, first.name,
                                  arguments.a, asked(compared.question));
  const std::vector<std::string> labels = arguments.labels.empty() ? common_labels(a, b, compared) : arguments.labels;
  for (const std::string& label : labels) {
    const Variant &baseline = the(a, label, "A: "), &candidate = the(b, label, "B: ");
    compared.comparisons.push_back(compare_variants(baseline, candidate, arguments.metrics, compared.question));
  }
  return compared;
}

// "a, b or c"
std::string metric_names() {
  std::vector<std::string_view> names;
  for (const Metric metric : compared_metrics()) names.push_back(name_of(metric));
  return fmt::format("{} or {}", fmt::join(names.begin(), names.end() - 1, ", "), names.back());
}

// What a terminal is wide enough for.
Table narrow(const Table& table) {
  constexpr std::array<std::string_view, 11> shown{"label", "metric", "B_is", "mean_A",  "mean_B", "B_by_A",
                                                   "low",   "high",   "a12",  "p_ranks", "remark"};
  Table result{.name = table.name, .caption = table.caption};
  result.rows.resize(table.rows.size());
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    if (std::ranges::find(shown, table.columns[c].name) == shown.end()) continue;
    result.columns.push_back(table.columns[c]);
    for (std::size_t r = 0; r < table.rows.size(); ++r) result.rows[r].push_back(table.rows[r][c]);
  }
  return result;
}

std::string markdown(const Compared& compared, Table table) {
  table.notes.insert(table.notes.begin(),
                     {compared.headline, variants_verdict(compared.comparisons, compared.question)});
  for (const std::string& note : compared.notes) table.notes.push_back(note);
  for (const std::string& note : variants_notes(compared.comparisons)) table.notes.push_back(note);
  return to_markdown(table);
}

void refuse_output(const CompareArguments& arguments) {
  const std::filesystem::path file(arguments.output);
  const std::string type = file.extension().string();
  if (type != ".md" && type != ".csv" && type != ".json") {
    throw std::invalid_argument(
        fmt::format("-o {}: expected a file name that ends in .md, .csv or .json", arguments.output));
  }
  for (const std::string& store : {arguments.a, arguments.b, arguments.store}) {
    std::error_code error;
    if (std::filesystem::equivalent(file, store, error)) {
      throw std::invalid_argument(fmt::format("-o {} is one of the stores; choose another file", arguments.output));
    }
  }
}

void write_output(const Compared& compared, const std::string& file) {
  const std::string type = std::filesystem::path(file).extension().string();
  const Table table = variants_table(compared.comparisons, compared.question);
  write_file(file, type == ".md"    ? markdown(compared, table)
                   : type == ".csv" ? to_csv(table)
                                    : variants_json(compared.comparisons, compared.question));
}

int exit_code(const Compared& compared, const CompareArguments& arguments) {
  const auto is_there = [&](Outcome outcome) { return count(compared.comparisons, outcome) > 0; };
  if (is_there(Outcome::worse)) return regression;
  return arguments.strict && (is_there(Outcome::undecided) || is_there(Outcome::not_compared)) ? undecided : 0;
}

void compare(const CompareArguments& arguments, Invocation& invocation) {
  if (!arguments.output.empty()) refuse_output(arguments);
  const Compared compared = arguments.store.empty() ? compare_stores(arguments) : compare_labels(arguments);
  if (!arguments.output.empty()) write_output(compared, arguments.output);
  fmt::print("{}\n\n{}\n", printable(compared.headline),
             aligned(readable_cells(narrow(variants_table(compared.comparisons, compared.question)))));
  for (const std::string& note : compared.notes) fmt::print("{}\n", printable(note));
  for (const std::string& note : variants_notes(compared.comparisons)) fmt::print("{}\n", printable(note));
  invocation.exit_code = exit_code(compared, arguments);
  fmt::print("{}{}\n", printable(variants_verdict(compared.comparisons, compared.question)),
             invocation.exit_code == undecided ? " With --strict this counts as a failure." : "");
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
  command
      ->add_option("--label", arguments->labels,
                   "with two stores: compare only this label; repeat for more; default: all that both stores have")
      ->allow_extra_args(false);
  command->add_option("--metric", arguments->metrics, metric_names() + "; repeat for more; default: all")
      ->allow_extra_args(false);
  const CLI::Option *margin = add_margin_option(*command, arguments->plan.margin),
                    *significance = add_significance_option(*command, arguments->plan.significance);
  command->get_option("--significance")
      ->description("significance level of each one-sided test; intervals have level 1 minus twice this");
  command->add_flag("--strict", arguments->strict,
                    "exit with 4 if nothing is worse but a metric is undecided or not compared");
  command->add_option("-o,--output", arguments->output, "also write the full table to this .md, .csv or .json file");
  command->footer(
      "Examples:\n"
      "  ikbench compare before/store.sqlite after/store.sqlite\n"
      "  ikbench compare IK-BA mine --store out/my/store.sqlite --metric position_error_cm --margin 10%\n"
      "In continuous integration, with the store of the last release as base.sqlite:\n"
      "  ikbench run my.toml --no-report --out new\n"
      "  ikbench compare base.sqlite new/store.sqlite --metric position_error_cm --metric evaluations --metric solved "
      "\\\n"
      "    --strict -o comparison.md\n\n"
      "Tests of the ratio of means against the margin decide whether B is better, the same or worse. Otherwise the\n"
      "metric is undecided, and the table says how many runs or targets would decide. --margin and --significance\n"
      "default to those of A's study.\n\n"
      "Exit codes: 0 no regression found, 1 a mistake in the request, 2 a failure of the program, the disk or the store,\n"
      "3 a regression beyond the margin, 4 (--strict only) nothing is worse, but something is undecided or not compared.");
  command->callback([arguments, margin, significance, &invocation] {
    if (margin->count() > 0) arguments->margin = arguments->plan.margin;
    if (significance->count() > 0) arguments->significance = arguments->plan.significance;
    compare(*arguments, invocation);
  });
}

}  // namespace ikbench::cli
