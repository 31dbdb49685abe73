#include "analysis/papers/repeated.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
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
  for (std::size_t i = 1; i < studies.size(); ++i) {
    if (paper.readings.contains(studies[i].study.name)) all.push_back({paper, studies.subspan(i, 1)});
  }
  return all;
}

std::string Repeated::reading() const {
  const auto words = paper.readings.find(study().study.name);
  return words == paper.readings.end() ? "" : words->second;
}

PrintedRows printed_rows(const Paper& paper, const JudgedMetric& judged) {
  const auto metric = std::ranges::find(metrics(), judged.observations.metric, &Metric::slug);
  return printed_means(paper.name, paper.means, metric->column);
}

show::Cell beside(double ours, const PrintedRow* row, std::size_t statistic) {
  if (row == nullptr || row->digits[statistic].empty()) return ours;
  return show::Printed{ours, row->digits[statistic]};
}

std::vector<show::Cell> beside(const JudgedMetric& judged, const std::string& solver, const PrintedRow* row) {
  const std::size_t place = place_of(judged.observations, solver);
  const Group group = place < judged.described.size() ? judged.observations.groups[place] : Group();
  const Description ours =
      place == judged.described.size() || lost_in(group) > 0 ? Description() : judged.described[place];
  const bool is_time = judged.observations.unit == "s";
  const auto ranges = row && ours.n > 0 && !is_time
                          ? predicted_ranges({values_of(group).begin(), values_of(group).end()}, row->numbers.n)
                          : std::nullopt;
  std::vector<show::Cell> cells;
  for (std::size_t s = 0; s < statistics.size(); ++s) {
    const double number = ours.*statistics[s].of;
    auto* const printed = std::get_if<show::Printed>(&cells.emplace_back(beside(number, row, s)));
    if (printed && ranges) printed->sign = repeats(number, (*ranges)[s], printed->printed) ? '~' : 'x';
  }
  return cells;
}

show::Table means_table(const Repeated& repeated, const SeedCounts& counts) {
  const StudyResults& study = repeated.study().study;
  show::Table table{.name = "means", .columns = {{"solver"}}};
  table.caption = fmt::format("Means of {}, here and as printed", base::counted(study.definition.runs, "runs"));
  bool has_signs = false;
  for (const std::string& solver : study.labels) table.rows.push_back({solver});
  for (const JudgedMetric& judged : repeated.study().metrics) {
    const PrintedRows printed = printed_rows(repeated.paper, judged);
    if (printed.empty() || judged.observations.unit == "s") continue;  // of another machine
    table.columns.push_back({judged.observations.quantity, judged.observations.unit});
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      table.rows[i].push_back(beside(judged, study.labels[i], row_of(printed, study.labels[i])).front());
      const auto* const mean = std::get_if<show::Printed>(&table.rows[i].back());
      has_signs = has_signs || (mean && !mean->sign.empty());
    }
  }
  if (table.columns.size() == 1) {
    table.rows.clear();
    return table;
  }
  table.notes.push_back(has_signs ? std::string(meaning_of_signs)
                                  : "Too few runs to say which numbers repeat; they leave claims open.");
  if (counts.of == 0) return table;
  const std::size_t of_row = static_cast<std::size_t>(counts.of) / counts.rows.size();
  table.columns.push_back({fmt::format("repeat, of {}", of_row)});
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const auto row = counts.rows.find(study.labels[i]);
    table.rows[i].push_back(row == counts.rows.end() ? show::Cell() : show::Cell(span_of(row->second)));
  }
  table.notes.push_back(fmt::format(
      "Repeat: of its statistics in Table 3, by seed (1 to {}); of all {} by the runs of all these seeds at once {}.",
      counts.all.size(), counts.of, counts.together));
  return table;
}

std::map<std::string, std::vector<Rate>> rates_of(const Repeated& repeated) {
  const Rates& plan = repeated.paper.rates;
  std::map<std::string, std::vector<Rate>> rates;
  const base::CsvTable table = results::published::table(repeated.paper.name, plan.table);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto add = [&](const std::string& heading, const std::string& name, double solved, double n,
                         const std::string& column) -> Rate& {
      const double printed = table.number(row, column) / 100;
      const Interval difference = newcombe(solved / n, n, printed, table.number(row, "n"), 1 - plan.level);
      return rates[heading].emplace_back(Rate{
          .row = name,
          .is_picked = std::ranges::any_of(plan.picked, [&](const auto& arm) { return plan.rows.at(arm) == name; }),
          .printed = printed,
          .share = solved / n,
          .interval = {std::max(0.0, printed + difference.low), std::min(1.0, printed + difference.high)},
          .margin = repeated.study().study.definition.plan.margin});
    };
    const auto add_solves = [&](const std::string& heading, const std::string& name, const Solves& solves,
                                const std::string& column) {
      const auto solved = std::ranges::count(solves, results::Status::ok, &Solve::status);
      if (!solves.empty()) add(heading, name, static_cast<double>(solved), static_cast<double>(solves.size()), column);
    };
    const auto is_of_row = [&](auto arm) { return arm != plan.rows.end() && table.cell(row, 0) == arm->second; };
    for (const JudgedStudy& judged : repeated.studies) {
      const auto arm = plan.rows.find(judged.study.definition.robot);
      if (!is_of_row(arm)) continue;
      for (const auto& [solver, column] : plan.columns)
        add_solves(solver, arm->second, judged.study.of(solver), column);
    }
    const base::CsvTable* const programs = repeated.programs;
    for (std::size_t i = 0; programs != nullptr && i < programs->rows(); ++i) {
      const auto solver = plan.columns.find(std::string(programs->cell(i, programs->column("solver"))));
      const auto arm = plan.rows.find(std::string(programs->cell(i, programs->column("robot"))));
      if (!is_of_row(arm) || solver == plan.columns.end()) continue;
      const auto& [name, column] = *solver;
      Rate& rate = add(name, arm->second, programs->number(i, "solved"), programs->number(i, "n"), column);
      rate.mean_ms = programs->number(i, "mean_ms");
      rate.printed_ms = table.cell(row, table.column(column.substr(0, column.rfind('_')) + "_ms"));
    }
    if (const std::string solver(table.cell(row, 0)); !plan.is_of_arms())
      add_solves("solved", solver, repeated.study().study.of(solver), plan.column);
  }
  return rates;
}

std::vector<std::string> rates_sentences(const Repeated& repeated) {
  std::vector<std::string> counts, sentences, undecided;
  const bool is_of_arms = repeated.paper.rates.is_of_arms();
  for (const auto& [solver, rates] : rates_of(repeated)) {
    std::vector<std::string> others;
    for (const Rate& rate : rates) {
      if (rate.sign() == "x")  // "Jaco2 31 % (printed 26.23)"
        others.push_back(fmt::format("{} {:.1f} % (printed {:.2f})", rate.row, 100 * rate.share, 100 * rate.printed));
    }
    const auto repeat = std::ranges::count(rates, "~", &Rate::sign);
    const auto open = std::ssize(rates) - repeat - std::ssize(others);
    if (open == std::ssize(rates)) {
      undecided.push_back(solver);
      continue;
    }
    const std::string count =
        fmt::format("{}{} of {}", repeat, open > 0 ? fmt::format(" (not decided on {})", open) : "", rates.size());
    counts.push_back(fmt::format("{} {}{}", is_of_arms ? fmt::format("by {} on", solver) : "for", count,
                                 !counts.empty() ? ""
                                 : is_of_arms    ? " arms"
                                                 : " solvers"));
    if (!others.empty())
      sentences.push_back(
          fmt::format("{}: {}.", is_of_arms ? solver + " not on" : "Not for", show::listed(others, ", ")));
  }
  for (const auto& [solver, rates] : rates_of(repeated)) {
    std::vector<double> times;
    for (const Rate& rate : rates) {
      if (!rate.printed_ms.empty()) times.push_back(rate.mean_ms / base::number_from(rate.printed_ms).value());
    }
    if (!times.empty())
      sentences.push_back(fmt::format("The mean times of {} are {:.2g} to {:.2g} times the printed ones.", solver,
                                      std::ranges::min(times), std::ranges::max(times)));
  }
  if (!undecided.empty())
    sentences.push_back(is_of_arms ? fmt::format("Too few targets to decide on any arm: the printed rates of {}.",
                                                 show::listed(undecided))
                                   : "Too few targets to decide whether any printed rate repeats.");
  if (!counts.empty())
    sentences.insert(sentences.begin(), fmt::format("The printed rates repeat {}.", show::listed(counts)));
  return sentences;
}

show::Table rates_table(const Repeated& repeated) {
  const Rates& plan = repeated.paper.rates;
  show::Table table{.name = plan.table,
                    .caption = fmt::format("Solved of {} targets{}, here and as printed",
                                           repeated.study().study.definition.runs, plan.is_of_arms() ? " an arm" : ""),
                    .columns = {{plan.is_of_arms() ? "arm" : "solver"}},
                    .is_of_study = !plan.is_of_arms()};
  std::set<std::string_view> signs;
  for (const auto& [solver, rates] : rates_of(repeated)) {
    table.columns.push_back({solver, "%"});
    table.rows.resize(rates.size());  // arms, in each solver's order
    for (std::size_t i = 0; i < rates.size(); ++i) {
      const Rate& rate = rates[i];
      if (table.rows[i].empty()) table.rows[i].emplace_back(rate.row + (rate.is_picked ? " *" : ""));
      table.rows[i].emplace_back(show::Printed{std::round(1e12 * rate.share) / 1e10,
                                               fmt::format("{:.2f}", 100 * rate.printed), std::string(rate.sign())});
      signs.insert(rate.sign());
    }
    if (rates.front().printed_ms.empty()) continue;  // is no program's
    table.columns.push_back({"mean time", "ms"});
    for (std::size_t i = 0; i < rates.size(); ++i)
      table.rows[i].emplace_back(show::Printed{rates[i].mean_ms, rates[i].printed_ms});
  }
  std::vector<std::string> key;
  if (signs.contains("~")) key.emplace_back("~ it contains 0");
  if (signs.contains("x")) key.emplace_back("x it excludes 0");
  if (signs.contains("?"))
    key.push_back(fmt::format("? it is wider than {:g} points", 200 * repeated.study().study.definition.plan.margin));
  table.notes.push_back(
      fmt::format("{:g} % interval of ours minus the printed: {}.", 100 * plan.level, fmt::join(key, "; ")));
  if (!plan.picked.empty())
    table.notes.emplace_back("* of several files or sides of the arm, the one nearest to the printed.");
  if (!plan.note.empty()) table.notes.push_back(plan.note);
  if (const base::CsvTable* const of = repeated.programs; of != nullptr && of->rows() > 0)
    table.notes.push_back(fmt::format("{}: {} poses an arm by {}, {}, {}.", of->cell(0, of->column("solver")),
                                      of->cell(0, of->column("n")), of->cell(0, of->column("program")),
                                      of->cell(0, of->column("machine")), of->cell(0, of->column("day"))));
  return table;
}

std::optional<figures::Figure> rates_figure(const Repeated& repeated) {
  std::vector<figures::IntervalRow> rows;
  for (const auto& [solver, rates] : rates_of(repeated)) {
    for (const Rate& rate : rates) {
      const auto minus_printed = [&](double share) { return 100 * (share - rate.printed); };
      rows.push_back({.label = repeated.paper.rates.is_of_arms() ? fmt::format("{}: {}", solver, rate.row) : rate.row,
                      .estimate = minus_printed(rate.share),
                      .low = minus_printed(rate.interval.low),
                      .high = minus_printed(rate.interval.high),
                      .verdict = rate.sign() == "x"   ? "not as printed"
                                 : rate.sign() == "~" ? "as printed"
                                                      : "not decided",
                      .style = rate.sign() == "x" ? 1 : 0});
    }
  }
  return differences(
      {"printed",
       fmt::format("Share solved minus the printed one, with its {:g} % interval.", 100 * repeated.paper.rates.level),
       "ours minus printed", "points"},
      rows, false);
}

}  // namespace ikbench::papers
