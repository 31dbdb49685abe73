// ikbench trend: one metric over the stores of several versions, and the version where it changed.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/figures/figure_parts.hpp"
#include "analysis/inference/analysis_plan.hpp"
#include "analysis/inference/judged_study.hpp"
#include "analysis/inference/make_study.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/inference/variant_comparison.hpp"
#include "analysis/report/variants_table.hpp"
#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/plan_options.hpp"
#include "cli/reporting.hpp"
#include "numerics/names.hpp"
#include "results/files.hpp"
#include "results/store.hpp"

namespace ikbench::cli {

using namespace numerics;
using namespace results;
using namespace inference;
using namespace report;
using namespace figures;

namespace {

constexpr std::size_t most_versions = 200;

struct TrendArguments {
  std::vector<std::string> stores, labels;
  std::string metric = "position_error_cm", study, out;
  double margin = 0;  // 0: the plan's
  OutputArguments output = {};
};

struct Version {
  std::string name;  // the store's folder, or its file where that has a name of its own
  Store store;
  std::vector<Variant> variants = {};
  std::map<std::string, Estimate> means = {};  // of the metric, by label
};

// A label's value in one version, and how it compares with the version where it changed last.
struct Point {
  std::size_t version = 0;
  Estimate mean = {};
  std::string verdict = {};      // "better by more than 5 %"; empty for the first
  std::size_t base = 0;          // the version that it is compared with
  std::string differences = {};  // settings, program and machine that differ from that version
  bool has_changed = false;
  bool is_compared = true, is_open = false;
};

struct Trend {
  std::string label;
  std::vector<Point> points = {};
};

std::vector<Version> versions_of(const TrendArguments& arguments, Metric metric) {
  if (arguments.stores.size() < 2 || arguments.stores.size() > most_versions)
    throw std::invalid_argument(fmt::format("{} stores; expected 2 to {}", arguments.stores.size(), most_versions));
  std::vector<Version> versions;
  versions.reserve(arguments.stores.size());  // the variants refer to their stores
  for (const std::string& file : arguments.stores) {
    versions.push_back({.name = store_name(file), .store = Store(file, Store::Mode::read)});
    Version& version = versions.back();
    const StudyEntry study = chosen_study(version.store, arguments.study);
    for (const std::string& damage : damages_of(version.store, study.name)) throw std::invalid_argument(damage);
    version.variants = variants(version.store, study);
    if (version.variants.empty()) throw std::invalid_argument(fmt::format("'{}': the study has no solver", file));
    const JudgedStudy judged(read_study(version.store, study));
    for (const GroupEvidence& group : judged.evidence(metric).groups) version.means[group.name] = group.mean;
  }
  return versions;
}

const Variant* find_label(const Version& version, const std::string& label) {
  const auto found =
      std::ranges::find(version.variants, label, [](const Variant& variant) { return variant.series.label; });
  return found == version.variants.end() ? nullptr : &*found;
}

// The labels asked for, or those of the last version, each in two versions at least.
std::vector<std::string> labels_of(const std::vector<Version>& versions, const TrendArguments& arguments) {
  std::vector<std::string> labels, known;
  for (const Variant& variant : versions.back().variants) known.push_back(variant.series.label);
  for (const std::string& label : arguments.labels.empty() ? known : arguments.labels) {
    const auto count = std::ranges::count_if(versions, [&](const Version& each) { return find_label(each, label); });
    if (count == 0) throw std::invalid_argument(unknown_name("label", label, known));
    const bool is_known = std::ranges::find(labels, label) != labels.end();
    if (count > 1 && !is_known) labels.push_back(label);
    if (count == 1 && !arguments.labels.empty())
      throw std::invalid_argument(fmt::format("--label {}: only one of the stores has it", label));
  }
  if (labels.empty()) throw std::invalid_argument("no label is in two of the stores; name stores of one study");
  return labels;
}

// Compares a version with the one where the label changed last.
void compare(const Version& base, const Version& next, const std::string& label, const AnalysisPlan& plan,
             const std::string& metric, Point& point) {
  const std::vector<VariantStudy> studies{
      study_of_both(*find_label(base, label), *find_label(next, label), plan, base.name, next.name)};
  const std::vector<VariantComparison> comparisons = compare_variants(studies, std::vector{metric});
  const MetricComparison& compared = comparisons.at(0).metrics.at(0);
  const Finding found = compared.finding();
  point.verdict = verdict_of(comparisons, compared, plan);
  point.differences = studies[0].differences;
  point.has_changed = is_decided(found) && found.is_beyond_margin();
  point.is_compared = compared.is_compared();
  point.is_open = is_open(compared);
}

// A change is a difference beyond the margin.
Trend trend_of(const std::string& label, const std::vector<Version>& versions, const AnalysisPlan& plan,
               const std::string& metric) {
  Trend trend{.label = label};
  for (std::size_t i = 0; i < versions.size(); ++i) {
    if (!find_label(versions[i], label)) continue;
    Point point{.version = i};
    if (const auto mean = versions[i].means.find(label); mean != versions[i].means.end()) point.mean = mean->second;
    if (!trend.points.empty()) {
      const Point& before = trend.points.back();
      point.base = before.has_changed || trend.points.size() == 1 ? before.version : before.base;
      compare(versions[point.base], versions[i], label, plan, metric, point);
    }
    trend.points.push_back(std::move(point));
  }
  return trend;
}

Table table_of(const std::vector<Trend>& trends, const std::vector<Version>& versions, Metric metric,
               const AnalysisPlan& plan) {
  Table table{
      .name = "trend",
      .caption = fmt::format("{} over {} versions", capitalised(quantity(metric)), versions.size()),
      .columns = {"label", "version", quantity(metric), "it is", "compared with",
                  percent(1 - plan.significance) + " interval"},
      .notes = {fmt::format("Each version is compared with the one where the label changed last. All "
                            "comparisons together find a difference where there is none in at most {} of cases.",
                            percent(plan.significance))}};
  std::vector<VariantComparison> differences;
  for (const Trend& trend : trends) {
    VariantComparison& of_label = differences.emplace_back(VariantComparison{.label = trend.label});
    for (const Point& point : trend.points) of_label.notes.push_back(point.differences);
  }
  std::ranges::move(variants_notes(differences), std::back_inserter(table.notes));
  for (const Trend& trend : trends) {
    for (const Point& point : trend.points) {
      table.rows.push_back({trend.label, versions[point.version].name, point.mean.value,
                            point.has_changed ? point.verdict + " (changed)" : point.verdict,
                            point.verdict.empty() ? std::string() : versions[point.base].name,
                            Range{point.mean.low, point.mean.high}});
    }
  }
  return table;
}

Figure figure_of(const std::vector<Trend>& trends, const std::vector<Version>& versions, Metric metric) {
  Figure figure{.name = "trend",
                .caption = fmt::format("{} of each version, with its interval. A ring: it changed there.",
                                       capitalised(quantity(metric))),
                .width_cm = two_columns_cm,
                .data = "# a block a label: version, mean, low, high, changed\n"};
  std::vector<std::string> clauses{"NaN"}, labels;
  bool is_logarithmic = info_of(metric).kind != Kind::share;
  for (std::size_t i = 0; i < trends.size(); ++i) {
    figure.data += fmt::format("{}# {}\n", i == 0 ? "" : "\n\n", one_line(trends[i].label));
    for (const Point& point : trends[i].points) {
      figure.data += fmt::format("{} {} {} {} {}\n", point.version + 1, data_number(point.mean.value),
                                 data_number(point.mean.low), data_number(point.mean.high), point.has_changed ? 1 : 0);
      is_logarithmic = is_logarithmic && point.mean.low > 0;
    }
    labels.push_back(shortened(trends[i].label, longest_label));
    clauses.push_back(fmt::format("data index {} using 1:3:(0):($4-$3) with vectors nohead ls {}", i, i + 1));
    clauses.push_back(fmt::format("data index {} using 1:2 with linespoints ls {} title {}", i, i + 1,
                                  gnuplot_string(labels.back())));
    clauses.push_back(
        fmt::format("data index {} using 1:($5==1 ? $2 : NaN) with points ls {} pt 6 ps 1.6 lw 1.4", i, i + 1));
  }
  const std::size_t step = (versions.size() + 9) / 10;
  std::vector<std::string> ticks;
  for (std::size_t i = 0; i < versions.size(); i += step)
    ticks.push_back(fmt::format("{} {}", tick_label(shortened(versions[i].name, 12)), i + 1));
  figure.settings = fmt::format("set xrange [0.5:{}.5]\nset xtics ({}) nomirror\nset ylabel {}\n{}", versions.size(),
                                fmt::join(ticks, ", "), gnuplot_string(quantity(metric)),
                                is_logarithmic ? "set logscale y\nset format y '%g'\n" : "");
  add_legend(figure, labels);
  figure.plot = plot_command(clauses);
  return figure;
}

// "position error: undecided for FD in v2, v3; for DLS in v3."; empty if no point is `is`.
std::string open_words(const std::vector<Trend>& trends, const std::vector<Version>& versions, const std::string& what,
                       const std::function<bool(const Point&)>& is) {
  std::vector<std::string> labels;
  for (const Trend& trend : trends) {
    std::vector<std::string> in;
    for (const Point& point : trend.points) {
      if (is(point)) in.push_back(versions[point.version].name);
    }
    if (!in.empty()) labels.push_back(fmt::format("for {} in {}", trend.label, fmt::join(in, ", ")));
  }
  return labels.empty() ? "" : fmt::format("{} {}.", what, fmt::join(labels, "; "));
}

void tell(const std::vector<Trend>& trends, const std::vector<Version>& versions, Metric metric, const Table& table,
          const std::filesystem::path& picture, const OutputArguments& output) {
  const std::string name(info_of(metric).name);
  std::vector<std::string> said;
  report::Json changes = report::Json::array();
  for (const Trend& trend : trends) {
    for (const Point& point : trend.points) {
      if (!point.has_changed) continue;
      const std::string &version = versions[point.version].name, &base = versions[point.base].name;
      said.push_back(fmt::format("{} of {} changed in {}: {} than in {}.", capitalised(name), trend.label, version,
                                 point.verdict, base));
      changes.push_back({{"label", trend.label}, {"version", version}, {"is", point.verdict}, {"than_in", base}});
    }
  }
  if (output.is_json) return show_json({{"changes", changes}, {"rows", rows_json(table)}, {"notes", table.notes}});
  if (said.empty())
    said = {
        fmt::format("{}: no change beyond the margin was found in {} versions.", capitalised(name), versions.size())};
  said.push_back(open_words(trends, versions, capitalised(name) + ": undecided",
                            [](const Point& point) { return point.is_compared && point.is_open; }));
  said.push_back(open_words(trends, versions, capitalised(name) + ": not compared",
                            [](const Point& point) { return !point.is_compared; }));
  std::erase(said, "");
  said.push_back(fmt::format("No other metric than {} was looked at; --metric names another.", name));
  constexpr std::size_t of_changes = 8, of_table = 12, of_notes = 4;
  std::vector<Part> parts{sentences(said, of_changes),         {.items = {""}},
                          table_rows(table, output, of_table), {.items = {""}},
                          sentences(table.notes, of_notes),    {}};
  if (!picture.empty()) parts.back().items = {printable(picture.string())};
  show_screen(parts, output, picture.empty() ? ", and --out FOLDER writes it" : ", and trend.md has it");
}

void show_trend(const TrendArguments& arguments) {
  const Metric metric = metric_named(arguments.metric);
  const std::vector<Version> versions = versions_of(arguments, metric);
  const std::vector<std::string> labels = labels_of(versions, arguments);
  AnalysisPlan plan = plan_of(versions.front().variants.front().study);
  if (arguments.margin > 0) plan.margin = arguments.margin;
  AnalysisPlan of_one = plan;  // Bonferroni's level over labels and steps
  of_one.significance /= static_cast<double>(labels.size() * (versions.size() - 1));
  std::vector<Trend> trends;
  for (const std::string& label : labels) trends.push_back(trend_of(label, versions, of_one, arguments.metric));
  const Table table = table_of(trends, versions, metric, plan);
  if (arguments.out.empty()) return tell(trends, versions, metric, table, "", arguments.output);
  const std::filesystem::path folder = arguments.out;
  std::filesystem::create_directories(folder);
  write_file(folder / "trend.csv", to_csv(table));
  write_file(folder / "trend.md", to_markdown(table));
  draw({figure_of(trends, versions, metric)}, folder, {.jobs = 1});
  const std::filesystem::path picture = folder / "trend.svg";
  tell(trends, versions, metric, table, exists(picture) ? picture : folder / "trend.md", arguments.output);
}

}  // namespace

void add_trend(CLI::App& app, Invocation&) {
  auto arguments = std::make_shared<TrendArguments>();
  CLI::App* command =
      app.add_subcommand("trend", "Show a metric over the stores of several versions, and where it changed");
  command->add_option("STORE", arguments->stores, "the stores of the versions, oldest first")->required();
  command->add_option("--metric", arguments->metric, "one of ikbench list metrics")->capture_default_str();
  command->add_option("--label", arguments->labels, "only this label; repeat for more; default: all of the last store")
      ->allow_extra_args(false);
  command->add_option("--study", arguments->study, "name of the study; default: the first in each store");
  add_margin_option(*command, arguments->margin)
      ->description("smallest relative change that matters; default: the plan's");
  command->add_option("--out", arguments->out,
                      "also write trend.csv, trend.md and trend.svg, .pdf, .png into this folder");
  add_output_options(*command, arguments->output);
  command->footer(
      "Examples:\n"
      "  ikbench trend v1.sqlite v2.sqlite v3.sqlite\n"
      "  ikbench trend releases/*/store.sqlite --metric evaluations --label mine --out out/trend\n\n"
      "A version's name is that of its store's file, or of its folder where the file is store.sqlite.");
  command->callback([arguments] { show_trend(*arguments); });
}

}  // namespace ikbench::cli
