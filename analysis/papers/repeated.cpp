#include "analysis/papers/repeated.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "analysis/figures/plots.hpp"
#include "analysis/show/text.hpp"
#include "base/names.hpp"
#include "base/number.hpp"
#include "results/published.hpp"

namespace ikbench::papers {

using namespace judge;

const JudgedStudy* Repeated::part(std::string_view part) const {
  const std::string name = fmt::format("{}-{}", study().study.name, part);
  const auto found = std::ranges::find(studies, name, [](const JudgedStudy& each) { return each.study.name; });
  return found == studies.end() ? nullptr : &*found;
}

std::vector<Repeated> Repeated::readings() const {
  std::vector<Repeated> all{{paper, studies.first(1)}};
  for (std::size_t i = 1; i < studies.size(); ++i)
    if (paper.readings.contains(studies[i].study.name)) all.push_back({paper, studies.subspan(i, 1)});
  return all;
}

std::string Repeated::reading() const {
  const auto words = paper.readings.find(study().study.name);
  return words == paper.readings.end() ? "" : words->second;
}

PrintedRows printed_rows(const Paper& paper, const JudgedMetric& judged) {
  const auto metric = std::ranges::find(metrics(), judged.samples.metric, &Metric::slug);
  return printed_means(paper.name, paper.means, metric->column);
}

show::Cell beside(double ours, std::string_view printed) {
  return printed.empty() ? show::Cell(ours) : show::PublishedNumber{ours, std::string(printed)};
}

namespace {

// Returns the sign of our statistic beside a printed one (meaning_of_signs).
std::string sign_of(double ours, const Interval& range, std::string_view printed) {
  if (!repeats(ours, range, printed)) return "x";
  return is_wide(range) ? "?" : "~";
}

}  // namespace

std::vector<show::Cell> beside(const JudgedMetric& judged, const std::string& solver, const PrintedRow* row) {
  const std::size_t place = index_of(judged.samples, solver);
  const Group group = place < judged.descriptives.size() ? judged.samples.groups[place] : Group();
  const Descriptives ours =
      place == judged.descriptives.size() || missing_in(group) > 0 ? Descriptives() : judged.descriptives[place];
  const bool is_time = judged.samples.quantity_kind == QuantityKind::time;
  const auto ranges = row && ours.n > 0 && !is_time
                          ? predicted_ranges({values_of(group).begin(), values_of(group).end()}, row->numbers.n)
                          : std::nullopt;
  std::vector<show::Cell> cells;
  for (std::size_t s = 0; s < statistics.size(); ++s) {
    const double number = ours.*statistics[s].of;
    auto* const printed =
        std::get_if<show::PublishedNumber>(&cells.emplace_back(beside(number, row ? row->digits[s] : "")));
    if (printed && ranges) printed->sign = sign_of(number, (*ranges)[s], printed->printed);
  }
  return cells;
}

show::Table means_table(const Repeated& repeated, const SeedCounts& counts) {
  const StudyResults& study = repeated.study().study;
  show::Table table{.name = "means", .columns = {{"solver"}}};
  table.caption = fmt::format("Means of {}, ours and the paper's", base::counted(study.definition.runs, "runs"));
  bool has_signs = false;
  for (const std::string& solver : study.labels) table.rows.push_back({solver});
  for (const JudgedMetric& judged : repeated.study().metrics) {
    const PrintedRows printed = printed_rows(repeated.paper, judged);
    // Printed times are of another machine.
    if (printed.empty() || judged.samples.quantity_kind == QuantityKind::time) continue;
    table.columns.push_back({judged.samples.quantity, judged.samples.unit});
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      table.rows[i].push_back(beside(judged, study.labels[i], row_of(printed, study.labels[i])).front());
      const auto* const mean = std::get_if<show::PublishedNumber>(&table.rows[i].back());
      has_signs = has_signs || (mean && !mean->sign.empty());
    }
  }
  if (table.columns.size() == 1) {
    table.rows.clear();
    return table;
  }
  table.notes.push_back(
      has_signs ? std::string(meaning_of_signs)
                : "There are too few runs to say which numbers are reproduced, so claims may be inconclusive.");
  if (has_signs && !repeated.paper.means_note.empty()) table.notes.push_back(repeated.paper.means_note);
  if (counts.of == 0) return table;
  const std::size_t of_row = static_cast<std::size_t>(counts.of) / counts.rows.size();
  table.columns.push_back({fmt::format("reproduced of {}", of_row)});
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const auto row = counts.rows.find(study.labels[i]);
    table.rows[i].push_back(row == counts.rows.end() ? show::Cell() : show::Cell(span_of(row->second)));
  }
  table.notes.push_back(
      fmt::format("Reproduced: of {} statistics in Table 3, for seeds 1 to {}; all seeds pooled reproduce {} of {}.",
                  of_row, counts.all.size(), counts.together, counts.of));
  table.notes.push_back(fmt::format("Depending on the seed, {} of the {} ranges are wider than a factor of ten.",
                                    span_of(counts.wide), counts.of));
  return table;
}

namespace {

// Returns the value without rounding errors: 98.55 for 98.55000000000001, which may have another first decimal.
double rounded(double value) { return std::round(1e10 * value) / 1e10; }

// A share of the repeated study, with the printed share that belongs to it.
struct SharePair {
  std::string row;
  double share = 0, n = 0;  // of the repeated study
  std::string_view digits;  // as printed, in parts of `unit`
  double n_printed = 0;
  double unit = 1;  // the printed number for a share of 1: 100 for percent, or the number of targets
};

Rate make_rate(SharePair pair, const Repeated& repeated) {
  const double unit = pair.unit;
  const double printed = base::number_from(pair.digits).value();
  const Interval difference =
      newcombe_interval({.share = pair.share, .n = pair.n}, {.share = printed / unit, .n = pair.n_printed},
                        1 - repeated.paper.rates.level);
  return {
      .row = std::move(pair.row),
      .digits = std::string(pair.digits),
      .printed = printed,
      .ours = unit * pair.share,
      .interval = {std::max(0.0, printed + unit * difference.low), std::min(unit, printed + unit * difference.high)},
      .margin = unit * repeated.study().study.definition.plan.margin,
      .n = pair.n,
      .n_printed = pair.n_printed};
}

std::vector<RateColumn> columns_of_means(const Repeated& repeated) {
  std::vector<RateColumn> columns;
  for (const PrintedColumn& column : repeated.paper.rates.numbers) {
    const JudgedStudy* const judged = column.study.empty() ? &repeated.study() : repeated.part(column.study);
    if (judged == nullptr) continue;
    const base::CsvTable table = results::published::table(repeated.paper.name, column.table);
    const MetricSamples samples = make_samples(judged->study, *column.metric);
    RateColumn& of = columns.emplace_back(RateColumn{.name = column.name});
    for (std::size_t row = 0; row < table.rows(); ++row) {
      const std::size_t place = index_of(samples, table.cell(row, 0));
      if (place == samples.groups.size()) continue;
      const Descriptives descriptives = describe(samples.groups[place]);
      if (descriptives.n == 0) continue;
      const std::string_view digits = table.cell(row, table.column(column.column));
      const double n = table.number(row, "n"), ours = descriptives.mean;
      if (column.metric->kind == MetricKind::success_rate) {  // printed is the number of targets that are not solved
        of.rates.push_back(make_rate({.row = samples.groups[place].name,
                                      .share = 1 - ours,
                                      .n = static_cast<double>(descriptives.n),
                                      .digits = digits,
                                      .n_printed = n,
                                      .unit = n},
                                     repeated));
        continue;
      }
      constexpr double margin = 0.1;  // as a share, since a few hard targets decide a mean
      constexpr int least = 20;       // with fewer values the spread is not known
      const double printed = base::number_from(digits).value(),
                   sd = descriptives.n < least ? std::numeric_limits<double>::infinity() : descriptives.sd,
                   half = critical_z(1 - repeated.paper.rates.level) * sd * std::sqrt(1. / descriptives.n + 1 / n);
      of.rates.push_back({.row = samples.groups[place].name,
                          .digits = std::string(digits),
                          .printed = printed,
                          .ours = ours,
                          .interval = {ours - half, ours + half},
                          .margin = margin * printed,
                          .n = static_cast<double>(descriptives.n)});
    }
  }
  return columns;
}

}  // namespace

std::vector<RateColumn> rates_of(const Repeated& repeated, std::string name) {
  const Rates& plan = repeated.paper.rates;
  if (!plan.is_of_arms()) return columns_of_means(repeated);
  if (name.empty()) name = plan.tables.begin()->first;
  const base::CsvTable table = results::published::table(repeated.paper.name, name);
  const base::CsvTable* const programs = repeated.programs;
  std::vector<RateColumn> columns;
  for (const auto& [solver, title] : plan.columns) {
    RateColumn of{.name = solver};
    const std::size_t column = table.column(title);
    for (std::size_t row = 0; row < table.rows(); ++row) {
      const auto add = [&](double solved, double n) -> Rate& {
        return of.rates.emplace_back(make_rate({.row = std::string(table.cell(row, 0)),
                                                .share = solved / n,
                                                .n = n,
                                                .digits = table.cell(row, column),
                                                .n_printed = table.number(row, "n"),
                                                .unit = 100},
                                               repeated));
      };
      const auto is_of_row = [&](std::string_view robot) {
        const auto arm = plan.rows.find(std::string(robot));
        return arm != plan.rows.end() && table.cell(row, 0) == arm->second;
      };
      for (const JudgedStudy& judged : repeated.studies) {
        const Solves solves = judged.study.of(solver);
        if (is_of_row(judged.study.definition.robot) && !solves.empty())
          add(static_cast<double>(std::ranges::count(solves, results::Status::ok, &SolveSummary::status)),
              static_cast<double>(solves.size()));
      }
      for (std::size_t i = 0; programs != nullptr && i < programs->rows(); ++i) {
        const auto cell_in = [&](std::string_view column_name) {
          return programs->cell(i, programs->column(column_name));
        };
        if (cell_in("solver") != solver || !is_of_row(cell_in("robot"))) continue;
        Rate& rate = add(programs->number(i, "solved"), programs->number(i, "n"));
        rate.mean_ms = programs->number(i, "mean_ms");
        rate.printed_ms = table.cell(row, table.column(title.substr(0, title.rfind('_')) + "_ms"));
      }
    }
    if (!of.rates.empty()) columns.push_back(std::move(of));
  }
  return columns;
}

namespace {

// Returns sentences about columns of means. They say how many numbers are as printed, which solvers leave nearly as
// many targets unsolved as printed, and which numbers are not as printed.
std::vector<std::string> means_sentences(const std::vector<RateColumn>& columns) {
  std::int64_t all = 0, repeat = 0, open = 0;
  std::vector<std::string> same, others;
  std::size_t counted = 0;
  constexpr double most = 2;
  for (const auto& [name, rates] : columns) {
    for (const Rate& rate : rates) {
      const std::string ours = show::number_text(rate.ours);
      ++all;
      repeat += rate.sign() == "~";
      open += rate.sign() == "?";
      if (rate.sign() == "x")
        others.push_back(fmt::format("{} of {} {} (paper {})", name, rate.row, ours, rate.digits));
      if (rate.n != rate.n_printed) continue;
      ++counted;
      if (std::abs(rate.ours - rate.printed) < most + 0.5) same.push_back(fmt::format("{}/{}", ours, rate.digits));
    }
  }
  const std::string inconclusive = open > 0 ? fmt::format(", {} are inconclusive", open) : "";
  const std::string nearly =
      same.empty()
          ? ""
          : fmt::format(
                "; on the paper's own poses, {} of {} solvers miss as many targets as in the paper, within {:g} ({})",
                same.size(), counted, most, fmt::join(same, ", "));
  std::vector<std::string> sentences{
      all == open ? "There are too few targets to say whether we reproduce any number of the paper."
                  : fmt::format("We reproduce {} of {} numbers of the paper{}{}.", repeat, all, inconclusive, nearly)};
  if (!others.empty()) sentences.push_back(fmt::format("Not reproduced: {}.", show::listed(others, ", ")));
  return sentences;
}

}  // namespace

std::vector<std::string> rates_sentences(const Repeated& repeated) {
  const Rates& plan = repeated.paper.rates;
  if (!plan.is_of_arms()) return means_sentences(rates_of(repeated));
  std::vector<std::string> sentences, who;
  for (const auto& [name, words] : plan.tables) {
    const bool is_first = sentences.empty();
    std::vector<std::string> counts, inconclusive;
    for (const RateColumn& column : rates_of(repeated, name)) {
      std::vector<std::string> others;
      std::int64_t repeat = 0, open = 0;
      double least = 1e9, most = 0;  // ratios of times
      for (const Rate& rate : column.rates) {
        repeat += rate.sign() == "~";
        open += rate.sign() == "?";
        if (rate.sign() == "x")
          others.push_back(fmt::format("{} {:.1f} % (paper {})", rate.row, rounded(rate.ours), rate.digits));
        if (rate.printed_ms.empty()) continue;
        const double ratio = rate.mean_ms / base::number_from(rate.printed_ms).value();
        least = std::min(least, ratio);
        most = std::max(most, ratio);
      }
      if (open == std::ssize(column.rates))
        inconclusive.push_back(column.name);
      else
        counts.push_back(fmt::format("for {} on {}{} of {}{}", column.name, repeat,
                                     open > 0 ? fmt::format(" (inconclusive on {})", open) : "", column.rates.size(),
                                     counts.empty() ? " arms" : ""));
      if (is_first && !others.empty())
        who.push_back(fmt::format("Not reproduced for {}: {}.", column.name, show::listed(others, ", ")));
      if (is_first && most > 0)
        who.push_back(
            fmt::format("The mean times of {} are {:.2g}x to {:.2g}x those of the paper.", column.name, least, most));
    }
    if (!counts.empty())
      sentences.push_back(fmt::format("We reproduce the rates of {} {}.", words, show::listed(counts)));
    if (!inconclusive.empty())
      sentences.push_back(fmt::format("All rates of {} are inconclusive for {}.", words, show::listed(inconclusive)));
  }
  std::ranges::move(who, std::back_inserter(sentences));
  return sentences;
}

show::Table rates_table(const Repeated& repeated, const std::string& name) {
  const Rates& plan = repeated.paper.rates;
  const bool is_of_arms = plan.is_of_arms(), is_first = name.empty();
  std::string table_name = "numbers";
  if (is_of_arms) table_name = is_first ? plan.tables.begin()->first : name;
  show::Table table{.name = table_name, .columns = {{is_of_arms ? "arm" : "solver"}}, .is_of_study = !is_of_arms};
  table.caption =
      fmt::format("{} {}{}, ours and the paper's{}", is_of_arms ? "Solved of" : "Means of",
                  base::counted(repeated.study().study.definition.runs, "targets"), is_of_arms ? " per arm" : "",
                  is_of_arms ? fmt::format(" ({})", plan.tables.at(table.name)) : "");
  std::set<std::string_view> signs;
  for (const auto& [column, rates] : rates_of(repeated, name)) {
    const std::size_t before = table.columns.size();
    table.columns.push_back({.name = column, .unit = is_of_arms ? "%" : "", .boundaries = {0, 100}});
    for (const Rate& rate : rates) {
      const bool is_picked =
          std::ranges::any_of(plan.picked, [&](const auto& arm) { return plan.rows.at(arm) == rate.row; });
      const std::string row_name = rate.row + (is_picked ? " *" : "");
      const auto is_its = [&](const auto& row) {
        return row.size() <= before && std::get<std::string>(row[0]) == row_name;
      };
      auto row = std::ranges::find_if(table.rows, is_its);
      if (row == table.rows.end()) row = table.rows.insert(row, {show::Cell(row_name)});
      row->resize(before);  // an earlier column may lack this row
      row->emplace_back(show::PublishedNumber{rounded(rate.ours), rate.digits, std::string(rate.sign())});
      if (!rate.printed_ms.empty()) row->emplace_back(show::PublishedNumber{rate.mean_ms, rate.printed_ms});
      signs.insert(rate.sign());
    }
    if (!rates.empty() && !rates.front().printed_ms.empty()) table.columns.push_back({"mean time", "ms"});
  }
  for (auto& row : table.rows) row.resize(table.columns.size());
  std::vector<std::string> key;
  if (signs.contains("~")) key.emplace_back("~ contains 0");
  if (signs.contains("x")) key.emplace_back("x excludes 0");
  if (signs.contains("?")) key.emplace_back("? is too wide");
  table.notes.push_back(
      fmt::format("{:g} % interval of ours minus the paper's number: {}.", 100 * plan.level, fmt::join(key, "; ")));
  if (!is_first) return table;
  if (!plan.picked.empty())
    table.notes.emplace_back("* of several files or sides of the arm, the one nearest to the paper's number.");
  if (!plan.note.empty()) table.notes.push_back(plan.note);
  if (const base::CsvTable* const of = repeated.programs; of != nullptr && of->rows() > 0)
    table.notes.push_back(fmt::format("{}: {} poses per arm by {}, {}, {}.", of->cell(0, of->column("solver")),
                                      of->cell(0, of->column("n")), of->cell(0, of->column("program")),
                                      of->cell(0, of->column("machine")), of->cell(0, of->column("day"))));
  return table;
}

namespace {

std::string verdict_text(const Rate& rate) {
  if (rate.sign() == "x") return "not reproduced";
  return rate.sign() == "~" ? "reproduced" : "inconclusive";
}

}  // namespace

std::optional<figures::Figure> rates_figure(const Repeated& repeated) {
  const Rates& plan = repeated.paper.rates;
  std::vector<figures::IntervalRow> rows;
  std::vector<RateColumn> columns = rates_of(repeated);
  if (!plan.is_of_arms()) columns.resize(std::min<std::size_t>(columns.size(), 1));  // other columns have other units
  for (const auto& [solver, rates] : columns) {
    for (const Rate& rate : rates)
      rows.push_back({.label = plan.is_of_arms() ? fmt::format("{}: {}", solver, rate.row) : rate.row,
                      .estimate = rate.ours - rate.printed,
                      .low = rate.interval.low - rate.printed,
                      .high = rate.interval.high - rate.printed,
                      .verdict = verdict_text(rate),
                      .style = rate.sign() == "x" ? 1 : 0});
  }
  const std::string what = plan.is_of_arms() || columns.empty() ? "Share solved" : "Targets " + columns[0].name;
  return differences(
      {"printed", fmt::format("{}: ours minus the paper's, with the {:g} % interval.", what, 100 * plan.level),
       "ours minus the paper's", plan.is_of_arms() ? "points" : "targets"},
      rows, false);
}

}  // namespace ikbench::papers
