#include "analysis/slim2023/slim2023.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "analysis/figures/of_study.hpp"
#include "analysis/figures/rows.hpp"
#include "analysis/judge/statistics/omnibus.hpp"
#include "analysis/papers/claims.hpp"
#include "analysis/show/text.hpp"
#include "base/json.hpp"
#include "base/names.hpp"
#include "base/units.hpp"
#include "results/published.hpp"

namespace ikbench::slim2023 {

using namespace figures;
using namespace judge;
using namespace papers;
using base::CsvTable;
using results::SolveRecord;
using show::Cell;
using show::Table;

namespace {

std::string with(const std::string& reading) { return reading.empty() ? "" : " with " + reading; }

std::string_view predicate(Holds conclusion) {
  switch (conclusion) {
    case Holds::holds:
      return "holds";
    case Holds::in_part:
      return "holds in part";
    case Holds::fails:
      return "fails";
    case Holds::inconclusive:
      return "is inconclusive";
    case Holds::not_tested:
      return "is not tested";
  }
  return "";
}

std::string first_sentence(Holds conclusion, const std::vector<JudgedClaim>& claims) {
  const JudgedClaim* const other = claim_named(claims, "best_compromise_50");
  const std::string by = other != nullptr && other->holds == conclusion ? " with 20 and with 50 agents" : "";
  const auto open = std::ranges::count_if(
      claims, [](const JudgedClaim& claim) { return !claim.is_ours && claim.holds == Holds::inconclusive; });
  std::string besides;
  if (open > 0)
    besides =
        fmt::format("; with so few runs, {} {} inconclusive", base::counted(open, "claims"), open == 1 ? "is" : "are");
  return fmt::format("The conclusion of Slim et al. 2023 {}{}{}.", predicate(conclusion), by, besides);
}

// Returns how close our program is to the authors'. The scale is how many statistics the row of another solver would
// match, and how many the same program would.
std::string_view closeness_text(const SeedCounts& counts) {
  const auto [least, most] = std::ranges::minmax(counts.all);
  if (least >= std::ranges::min(counts.same)) return "our program reproduces as many as theirs would";
  if (most <= std::ranges::max(counts.other_rows)) return "our program is no closer to theirs than another solver is";
  return "our program is close to theirs but not the same";
}

// Returns how many printed statistics each interpretation reproduces, and how close our program therefore is to the
// authors'.
std::string scale_sentence(const std::vector<SeedCounts>& counts) {
  std::vector<std::string> repeated;
  for (const SeedCounts& each : counts) {
    const bool is_first = repeated.empty();
    repeated.push_back(fmt::format(
        "{}{}{}", span_of(each.all),
        is_first ? fmt::format(" of the {} error and motion statistics in Table 3", each.of) : "", with(each.reading)));
  }
  const SeedCounts& own = counts.front();
  return fmt::format(
      "We reproduce {}, over {} seeds. Another solver's row would match {}, the authors' own program "
      "{}: {}.",
      show::listed(repeated), own.all.size(), span_of(own.other_rows), span_of(own.same), closeness_text(own));
}

bool holds(const JudgedClaim* claim) { return claim != nullptr && claim->holds == Holds::holds; }

constexpr std::string_view error = "position_error_cm", motion = "variation_deg", time = "seconds";

// The figures that have values, named by their numbers in the paper.
struct Numbered {
  std::vector<Figure> all = {};

  void add(int number, std::optional<Figure> figure) {
    if (!figure) return;
    figure->name = fmt::format("figure-{}", number);
    figure->caption = fmt::format("Figure {}. {}", number, figure->caption);
    all.push_back(std::move(*figure));
  }
};

// Returns a metric by runs, as in the paper, in which times are by runs, too; empty if the study has no such metric.
std::optional<JudgedMetric> by_runs(const JudgedStudy& judged, std::string_view column) {
  const JudgedMetric* const found = find_metric(judged, column);
  if (found == nullptr) return {};
  const Metric& metric = metric_named(column);
  return is_time_metric(metric) ? judge::judge(judge::make_samples_by_target(judged.study, metric), found->plan)
                                : *found;
}

PrintedRows in_print(std::string_view column) {
  return column == time ? PrintedRows() : printed_means("slim2023", "table-3", column);
}

std::vector<Figure> of_helix(const JudgedStudy& judged, const Look& look) {
  const StudyResults& study = judged.study;
  Numbered figures;
  const auto add_printed = [](Dot& dot) {  // the means of Table 3
    const auto printed = [&](std::string_view column) {
      const PrintedRows rows = in_print(column);
      const auto* const row = row_of(rows, dot.label);
      return row == nullptr ? nowhere : row->numbers.mean;
    };
    dot.printed_x = printed(motion);
    dot.printed_y = printed(error);
  };
  if (auto overview = overview_of(judged, look, add_printed)) {
    overview->name = "overview";
    overview->caption += " Rings: the paper's.";
    figures.all.push_back(std::move(*overview));
  }
  figures.add(5, path_of(study, look, 1, ", with the arm."));
  Numbered of_runs;
  for (const PaperMetric& metric : paper_metrics) {
    const bool is_time = metric.column == time;
    const std::string_view average = is_time ? "median" : "mean";
    const Metric& drawn = metric_named(metric.column);
    About about = about_of(study, drawn, fmt::format("The {} at each point, {} of the runs.", drawn.name, average));
    figures.add(metric.curves, curves(about, {.title = "point"},
                                      by_point(study, metric.column, look, is_time ? Average::median : Average::mean)));
    const std::optional<JudgedMetric> values = by_runs(judged, metric.column);
    if (!values) continue;
    about = about_of(
        study, drawn,
        fmt::format("The {}: a dot is the {} of a run; box: quartiles and median; whiskers: smallest and largest.",
                    drawn.name, average));
    if (metric.column == error) about.floor = 0.00005;  // errors are printed with four decimals
    std::vector<BoxRow> boxed =
        box_rows(values->samples, drawn_unit(study, values->samples.unit), drawn_solvers(study, look), look);
    const PrintedRows printed = in_print(metric.column);
    for (BoxRow& row : boxed)
      if (const auto* const printed_row = row_of(printed, row.label))
        row.printed = {printed_row->numbers.smallest, printed_row->numbers.median, printed_row->numbers.largest};
    of_runs.add(metric.boxes, boxes(about, boxed));
  }
  figures.add(9, joints({.caption = "Joint angles along the path, first run of each solver. Dashed: limits."},
                        joint_rows(study, look)));
  std::ranges::move(of_runs.all, std::back_inserter(figures.all));
  return figures.all;
}

std::vector<Figure> of_circle(const StudyResults& study, const Look& look) {
  Numbered figures;
  figures.add(15, path_of(study, look, 3, ", with the arm at three of them."));
  figures.add(16, joints({.caption = "Joint angles along the circle. Dashed: limits."}, joint_rows(study, look)));
  std::vector<Line> errors = by_point(study, error, look, Average::mean);
  const CsvTable printed = results::published::table("slim2023", "table-8");
  Line& beside = errors.emplace_back(Line{.label = "paper", .style = 0});
  for (std::size_t row = 0; row < printed.rows(); ++row)
    beside.rows.push_back({printed.number(row, "point"), printed.number(row, "error_cm")});
  About about = about_of(study, metric_named(error), "The error at each point, beside Table 8's.");
  about.floor = 0;  // all differences are rounding
  figures.add(17, curves(about, {.title = "point"}, errors));
  about.caption = "Best error after each iteration, mean of all solves.";
  figures.add(18, curves(about, {.title = "iteration"}, by_iteration(study, look, Average::mean)));
  return figures.all;
}

}  // namespace

Table table_1(const StudyResults& study) {
  Table table{.name = "table-1",
              .caption = "Table 1: settings, ours and the paper's",
              .columns = {{"solver"}, {"parameter"}, {"ours"}},
              .notes = {"\"-\" under *ours*: drawn at random instead. All options: Set-up."}};
  const CsvTable printed = results::published::table("slim2023", "table-1");
  for (std::size_t row = 0; row < printed.rows(); ++row) {
    const auto series = std::ranges::find(study.series, printed.cell(row, 0), &results::Series::label);
    if (series == study.series.end()) continue;
    const base::Json used = base::parsed_json(series->options);
    table.rows.push_back({series->label, std::string(printed.cell(row, 1)),
                          show::PublishedNumber{used.value(std::string(printed.cell(row, 2)), unknown),
                                                std::string(printed.cell(row, 3))}});
  }
  return table;
}

Table table_2(const StudyResults& study) {
  Table table{.name = "table-2",
              .caption = "Table 2: the arm, ours and the paper's",
              .columns = {{"joint"}, {"alpha", "deg"}, {"a", "m"}, {"d", "m"}, {"limit", "deg"}},
              .notes = {"The paper gives no lengths: ours are the manufacturer's."}};
  const CsvTable printed = results::published::table("slim2023", "table-2");
  const base::Json arm = base::parsed_json(study.definition.arm);
  for (const base::Json& link : arm.is_object() ? arm.value("links", base::Json::array()) : base::Json::array()) {
    const std::size_t row = table.rows.size();
    if (row == printed.rows()) break;
    std::vector<Cell>& cells = table.rows.emplace_back(std::vector<Cell>{static_cast<std::int64_t>(row + 1)});
    for (const auto& [key, column] : {std::pair("alpha_deg", 1U), {"a_m", 2U}, {"d_m", 3U}})
      cells.push_back(show::PublishedNumber{link.value(key, unknown), std::string(printed.cell(row, column))});
    cells.push_back(show::PublishedNumber{link.at("limits_deg").at(1), std::string(printed.cell(row, 4))});
  }
  return table;
}

Table table_3(const Repeated& repeated) {
  const std::vector<std::string>& solvers = repeated.study().study.labels;
  Table table{
      .name = "table-3" + repeated.suffix(),
      .caption = fmt::format("Table 3{}: statistics of the runs", with(repeated.reading())),
      .columns = {{"solver"}, {"statistic"}},
      .notes = {std::string(meaning_of_signs), repeated.paper.means_note,
                "The paper's times are from another machine and language. Our time of a run is the median over its "
                "points."}};
  for (const Statistic& statistic : statistics)
    for (const std::string& solver : solvers) table.rows.push_back({solver, std::string(statistic.column)});
  for (const auto& [column, name, anova, curves, boxes] : paper_metrics) {
    const Metric& metric = metric_named(column);
    const std::optional<JudgedMetric> judged = by_runs(repeated.study(), column);
    if (!judged) continue;
    table.columns.push_back({std::string(name), std::string(metric.unit)});
    const PrintedRows printed = printed_rows(repeated.paper, *judged);
    for (std::size_t i = 0; i < solvers.size(); ++i) {
      const std::vector<Cell> cells = beside(*judged, solvers[i], row_of(printed, solvers[i]));
      for (std::size_t s = 0; s < cells.size(); ++s) table.rows[s * solvers.size() + i].push_back(cells[s]);
    }
  }
  return table;
}

std::vector<Table> anova_tables(const Repeated& repeated) {
  std::vector<Table> tables;
  for (const auto& [column, name, anova, curves, boxes] : paper_metrics) {
    const std::string number = fmt::format("table-{}", anova);
    const std::optional<JudgedMetric> judged = by_runs(repeated.study(), column);
    if (!judged) continue;
    Table& table =
        tables.emplace_back(Table{.name = number + repeated.suffix(),
                                  .caption = fmt::format("Table {}{}: ANOVA of the {} [{}]", anova,
                                                         with(repeated.reading()), name, metric_named(column).unit),
                                  .columns = {{"source"}, {"SS"}, {"df"}, {"MS"}, {"F"}, {"p"}}});
    const CsvTable printed = results::published::table(repeated.paper.name, number);
    const std::vector<OmnibusTest> tests = judge::anova(judged->samples);
    if (tests.empty()) table.notes.emplace_back("Ours is not tested, because values are missing or not comparable.");
    const OmnibusTest ours = tests.empty() ? OmnibusTest() : tests.front();
    const double between = ours.ss_between, within = ours.ss_within;
    for (const auto& numbers : {std::array{between, ours.df, between / ours.df, ours.statistic, ours.p},
                                {within, ours.df_within, within / ours.df_within, unknown, unknown},
                                {between + within, ours.df + ours.df_within, unknown, unknown, unknown}}) {
      const std::size_t r = table.rows.size();
      auto& row = table.rows.emplace_back(std::vector<Cell>{std::string(printed.cell(r, 0))});
      for (const double each : numbers) row.push_back(beside(each, printed.cell(r, row.size())));
    }
  }
  return tables;
}

std::optional<Table> table_7(const StudyResults& study) {
  constexpr double limit_ms = 50, verifier_rounding_cm = 1e-7;
  const PrintedRows printed = printed_means("slim2023", "table-7", "milliseconds");
  if (study.definition.path != "random" || study.solves.empty()) return {};
  const double tolerance = study.definition.stop.tolerance_cm();
  Table table{.name = "table-7",
              .caption = fmt::format("Table 7: computing time until the error is {:g} cm", tolerance),
              .columns = {{"solver"}, {"solves"}, {"reached"}, {fmt::format("reached in {:g} ms", limit_ms)}},
              .notes = {"Every solve counts, even one that does not reach the tolerance."}};
  for (const Statistic& statistic : statistics) table.columns.push_back({std::string(statistic.column), "ms"});
  table.columns.push_back({"median iterations"});
  for (const std::string& solver : study.labels) {
    std::int64_t reached = 0, in_time = 0;  // also outside the joint limits
    std::vector<double> ms, iterations;
    for (const SolveSummary& solve : study.of(solver)) {
      ms.push_back(1000 * solve.seconds);
      iterations.push_back(static_cast<double>(solve.iterations));
      const bool is_near = solve.position_error_cm <= tolerance + verifier_rounding_cm;
      reached += is_near;
      in_time += is_near && ms.back() < limit_ms;
    }
    auto& row = table.rows.emplace_back(std::vector<Cell>{solver, std::ssize(ms), reached, in_time});
    const PrintedRow* const printed_row = row_of(printed, solver);
    for (std::size_t s = 0; s < statistics.size(); ++s)
      row.push_back(beside(describe_values(ms).*statistics[s].of, printed_row ? printed_row->digits[s] : ""));
    row.emplace_back(describe_values(iterations).median);
  }
  return table;
}

std::optional<Table> table_8(const StudyResults& study) {
  const CsvTable printed = results::published::table("slim2023", "table-8");
  if (study.definition.path != "circle" || study.solves.empty()) return {};
  Table table{.name = "table-8",
              .caption = "Table 8: joint angles and position error along the circle",
              .columns = {{"point"}}};
  const std::vector<std::size_t> joints{0, 1, 2, 0};  // theta 4 is theta 1
  for (std::size_t angle = 1; angle <= joints.size(); ++angle)
    table.columns.push_back({fmt::format("theta {}", angle), "deg"});
  table.columns.push_back({"position error", "cm"});
  std::size_t agreeing = 0;
  for (const SolveRecord& solve : study.first_run_of(study.labels.front())) {
    auto& row = table.rows.emplace_back(std::vector<Cell>{std::int64_t{solve.point}});
    const auto in_print = [&] { return printed.cell(static_cast<std::size_t>(solve.point - 1), row.size()); };
    for (const std::size_t joint : joints) {
      const double ours = solve.answer_rad.at(joint) / base::degree;
      agreeing += agrees(ours, in_print());
      row.push_back(beside(ours, in_print()));
    }
    row.push_back(beside(solve.position_error_cm, in_print()));
  }
  table.notes = {fmt::format(
      "{} of {} angles of the paper agree with ours to the printed digit; theta 4 is set equal to theta 1. The paper "
      "gives no lengths of the arm: ours were fitted to these angles.",
      agreeing, table.rows.size() * joints.size())};
  return table;
}

std::vector<std::string> sentences(const std::vector<JudgedClaim>& claims, const std::vector<SeedCounts>& counts) {
  const JudgedClaim *const best = claim_named(claims, "best_compromise"),
                           *const accurate = claim_named(claims, "most_accurate"),
                           *const classical = claim_named(claims, "better_than_classical");
  std::vector<std::string> all{first_sentence(best->holds, claims)};
  if (!counts.empty() && counts.front().of > 0 && !counts.front().same.empty()) all.push_back(scale_sentence(counts));
  if (accurate->number.empty()) return all;
  std::string words =
      fmt::format("The paper concludes that {}; this {} ({})", best->sentence, predicate(best->holds), best->number);
  if (holds(best) && holds(accurate) && holds(claim_named(claims, "least_variation")))
    words =
        "IK-BA is the \"best compromise\": it has the smallest error and, with MO-PSO, the least joint motion. Times, which "
        "the conclusion also names, are not compared";
  all.push_back(words + '.');
  words = fmt::format("\"{}\" {} in the default interpretation ({})", accurate->sentence, predicate(accurate->holds),
                      accurate->number);
  if (const InReadings& of = accurate->in_readings; of.all() > 0)
    words += fmt::format(". Of {}, it holds in {}, is inconclusive in {} and fails in {}{}",
                         interpretations_text(of.all() / of.seeds, of.seeds), of.hold, of.open, of.fail,
                         of.most_fail.empty() ? "" : " (" + of.most_fail + ')');
  all.push_back(words + '.');
  if (classical != nullptr && classical->holds == Holds::fails)
    all.push_back(fmt::format("Not in the paper, but more accurate: {} cm.", classical->rival));
  return all;
}

std::vector<show::Blocks> sections(const Repeated& repeated, const std::vector<figures::Figure>& figures_of_circle) {
  std::vector<show::Blocks> sections;
  const auto add = [&](std::string heading, show::Blocks blocks) {
    if (blocks.empty()) return;
    blocks.insert(blocks.begin(), show::Heading{std::move(heading)});
    sections.push_back(std::move(blocks));
  };
  add("Tables 1 and 2", {table_1(repeated.study().study), table_2(repeated.study().study)});
  show::Blocks means, anovas, circle(figures_of_circle.begin(), figures_of_circle.end()), times;
  for (const Repeated& reading : repeated.readings()) {
    means.emplace_back(table_3(reading));
    std::ranges::move(anova_tables(reading), std::back_inserter(anovas));
  }
  add("Table 3", std::move(means));
  add("Tables 4 to 6", std::move(anovas));
  const auto eps = [](const StudyResults& study) {
    return base::parsed_json(study.series.front().options).value("epsilon", std::string());
  };
  for (const JudgedStudy& judged : repeated.studies) {
    for (const auto& [blocks, made] : {std::pair(&times, &table_7), {&circle, &table_8}}) {
      std::optional<Table> table = made(judged.study);
      if (!table) continue;
      if (const std::string here = eps(judged.study), there = eps(repeated.study().study); here != there)
        table->notes.push_back(fmt::format(
            "IK-BA's eps is {} here, and {} in Table 3 (docs/papers/slim2023-notes.md, 2.12).", here, there));
      blocks->emplace_back(std::move(*table));
    }
  }
  add("Real time", std::move(times));
  add("The Dobot's circle", std::move(circle));
  return sections;
}

std::vector<Figure> figures_of(const JudgedStudy& judged, const Look& look) {
  if (drawn_solvers(judged.study, look).empty()) return {};
  return judged.study.definition.path == "circle" ? of_circle(judged.study, look) : of_helix(judged, look);
}

}  // namespace ikbench::slim2023
