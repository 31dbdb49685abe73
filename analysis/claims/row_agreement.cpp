#include "analysis/claims/row_agreement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "analysis/claims/printed.hpp"
#include "analysis/claims/search_statistics.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/words.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "numerics/number.hpp"

namespace ikbench::claims {

using namespace numerics;
using namespace results;
using namespace report;
using namespace inference;
using namespace statistics;
using namespace fmt::literals;

namespace {

std::vector<Search> searches_of(const StudyResults& study, std::string_view solver) {
  std::vector<Search> all;
  for (const Solve& solve : solves_of(study, solver)) {
    all.push_back(
        search_of(solve.iterations, solve.restarts, solve.stop_reason, solve.status, solve.is_outside_limits));
  }
  return all;
}

// A row so far.
struct RowFindings {
  int numbers = 0, agree = 0, by_rounding = 0, by_chance = 0, outside = 0;
};

// Compares a printed number with ours.
struct Compared {
  const std::vector<Search>& ours;
  const std::vector<std::vector<Search>>& copies;  // with other last bits
};

// From the smallest to the largest value of the solves and their copies.
Range range_of_rounding(const Compared& of, const SearchStatistic& statistic) {
  const double ours = statistic.of(of.ours);
  Range range{ours, ours};
  for (const std::vector<Search>& copy : of.copies) {
    const double other = statistic.of(copy);
    range = {std::min(range.low, other), std::max(range.high, other)};
  }
  return range;
}

// Compares a printed number with ours.
Cell compared(const Compared& of, const SearchStatistic& statistic, const std::string& printed, RowFindings& row) {
  const double ours = statistic.of(of.ours);
  const int decimals = static_cast<int>(std::max(0.0, std::round(-std::log10(2 * half_unit(printed)))));
  ++row.numbers;
  OursAndPrinted cell{.ours = ours, .printed = printed, .nearness = Nearness::within, .decimals = decimals};
  if (agrees(ours, printed)) {
    ++row.agree;
    return cell;
  }
  if (const Range rounding = range_of_rounding(of, statistic); can_be(rounding, printed)) {
    ++row.by_rounding;
    cell.nearness = Nearness::near;
    cell.words = fmt::format(words::within_rounding, "range"_a = readable(rounding));
  } else if (!statistic.has_range) {
    cell.nearness = Nearness::unknown;
  } else {
    const Range chance = range_of_chance(of.ours, statistic);
    const bool is_in = can_be(chance, printed);
    ++(is_in ? row.by_chance : row.outside);
    cell.nearness = is_in ? Nearness::near : Nearness::far;
    cell.words =
        fmt::format(fmt::runtime(is_in ? words::within_chance : words::outside_chance), "range"_a = readable(chance));
  }
  return cell;
}

Graded graded(const RowFindings& row, RowAgreement& found) {
  if (row.agree == row.numbers) {
    ++found.every_digit;
    return {std::string(words::every_digit), Nearness::within};
  }
  const bool is_outside = row.outside > 0, is_by_chance = row.by_chance > 0 || row.by_rounding == 0;
  ++(is_outside ? found.outside : is_by_chance ? found.by_chance : found.by_rounding);
  const std::string_view sentence = is_outside     ? words::row_outside
                                    : is_by_chance ? words::row_by_chance
                                                   : words::row_by_rounding;
  return {fmt::format(fmt::runtime(sentence), "agree"_a = row.agree, "numbers"_a = row.numbers),
          is_outside ? Nearness::far : Nearness::near};
}

const StudyResults* study_named(const Reported& reported, const std::string& name) {
  if (reported.study.name == name) return &reported.study;
  const auto found =
      std::ranges::find_if(reported.companions, [&](const JudgedStudy& study) { return study.name == name; });
  return found == reported.companions.end() ? nullptr : &found->get();
}

// The studies that have a table's solvers.
struct Sources {
  const StudyResults* study;
  const StudyResults* beside;  // may be null

  const StudyResults& of(const std::string& solver) const {
    return beside != nullptr && solves_of(*study, solver).empty() ? *beside : *study;
  }
  double mean_seconds(const std::string& solver) const {
    std::vector<double> seconds;
    for (const Solve& solve : solves_of(of(solver), solver)) seconds.push_back(solve.seconds);
    return mean(seconds);
  }
};

constexpr std::string_view printed_time = "us_mean";

double printed_us(const CsvTable& printed, std::size_t row) {
  return number_from(printed.rows[row][printed.column(printed_time)]).value();
}

// The times of one solver, by which others are divided.
struct TimeUnit {
  double ours, printed;
};

TimeUnit unit_of_times(const Sources& from, const CsvTable& printed, const std::string& solver) {
  TimeUnit unit{from.mean_seconds(solver), not_defined};
  for (std::size_t i = 0; i < printed.rows.size(); ++i) {
    if (printed.rows[i][printed.column("solver")] == solver) unit.printed = printed_us(printed, i);
  }
  return unit;
}

// Times of different machines are not comparable, so their ratios are shown, and not judged.
Cell ratio_of_times(const Sources& from, const CsvTable& printed, std::size_t row, const TimeUnit& unit) {
  const std::string ratio = fmt::format("{:.2f}", printed_us(printed, row) / unit.printed);
  const double ours = from.mean_seconds(printed.rows[row][printed.column("solver")]) / unit.ours;
  if (!std::isfinite(ours)) return ratio;
  return OursAndPrinted{.ours = ours, .printed = ratio, .nearness = Nearness::unknown, .decimals = 2};
}

std::optional<Table> table_of(const Reported& reported, const std::string& paper, const PrintedTable& plan,
                              RowAgreement& found) {
  const Sources from{study_named(reported, plan.study), study_named(reported, plan.beside)};
  if (from.study == nullptr || from.study->solves.empty()) return std::nullopt;
  const CsvTable printed = printed_table(paper, plan.table);
  const std::vector<const SearchStatistic*> columns = statistics_in(printed);
  Table table{
      .name = "rows-" + plan.table, .caption = plan.caption + ", here and printed", .columns = {"solver", "agreement"}};
  for (const SearchStatistic* const statistic : columns) table.columns.emplace_back(statistic->heading);
  std::optional<TimeUnit> unit;
  if (!plan.times_to.empty()) {
    table.columns.push_back(fmt::format("mean time / that of {}", plan.times_to));
    unit = unit_of_times(from, printed, plan.times_to);
  }
  for (std::size_t i = 0; i < printed.rows.size(); ++i) {
    const std::string& solver = printed.rows[i][printed.column("solver")];
    const StudyResults& study = from.of(solver);
    const std::vector<Search> all = searches_of(study, solver);
    std::vector<Cell>& row = table.rows.emplace_back(std::vector<Cell>{solver, Cell()});
    if (all.empty()) {
      const auto why = plan.not_attempted.find(solver);
      row[1] = "not attempted" + (why == plan.not_attempted.end() ? "" : ": " + why->second);
      for (const SearchStatistic* statistic : columns)
        row.emplace_back(printed.rows[i][printed.column(statistic->column)]);
      ++found.not_attempted;
    } else {
      std::vector<std::vector<Search>> perturbed;
      for (const StudyResults& copy : copies_of(study, reported)) perturbed.push_back(searches_of(copy, solver));
      const Compared both{all, perturbed};
      RowFindings findings;
      for (const SearchStatistic* statistic : columns) {
        const std::string& digits = printed.rows[i][printed.column(statistic->column)];
        row.push_back(digits.empty() ? Cell(statistic->of(all)) : compared(both, *statistic, digits, findings));
      }
      row[1] = graded(findings, found);
    }
    if (unit) row.push_back(ratio_of_times(from, printed, i, *unit));
  }
  const bool has_shares = std::ranges::any_of(columns, &SearchStatistic::is_percentage);
  table.notes = {std::string(has_shares ? words::range_of_chance_of_shares : words::range_of_chance)};
  if (unit) table.notes.emplace_back(words::ratios_of_times);
  table.legend = words::legend_of_rows;
  return table;
}

}  // namespace

ComparedRows compared_rows(const Reported& reported, const std::string& paper,
                           const std::vector<PrintedTable>& tables) {
  ComparedRows rows;
  for (const PrintedTable& plan : tables) {
    if (std::optional<Table> table = table_of(reported, paper, plan, rows.found)) rows.tables.push_back(*table);
  }
  return rows;
}

std::string agreement_sentence(const RowAgreement& found) {
  const int attempted = found.every_digit + found.by_rounding + found.by_chance + found.outside;
  if (attempted == 0) return {};
  return fmt::format(words::rows_agree, "digits"_a = found.every_digit, "attempted"_a = attempted,
                     "rounding"_a = found.by_rounding, "chance"_a = found.by_chance, "outside"_a = found.outside,
                     "missing"_a = found.not_attempted);
}

}  // namespace ikbench::claims
