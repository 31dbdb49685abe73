#include "analysis/claims/row_agreement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "analysis/claims/printed.hpp"
#include "analysis/claims/tables_of.hpp"
#include "analysis/report/words.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "analysis/statistics/draw.hpp"
#include "analysis/statistics/proportion.hpp"

namespace ikbench::claims {

using namespace numerics;
using namespace results;
using namespace report;
using namespace inference;
using namespace statistics;
using namespace fmt::literals;

namespace {

// Holds what a statistic of searches needs of a solve.
struct Search {
  double iterations, searches;
  bool is_found, is_outside, is_solved;  // the solver did not give up; outside the joint limits; the status is ok
};
// Reads a record, or the numbers that the analysis keeps.
template <class Solve>
Search search_of(const Solve& solve, bool is_outside) {
  using enum StopReason;
  const bool is_found = solve.stop_reason == finished || solve.stop_reason == tolerance;
  return {.iterations = static_cast<double>(solve.iterations),
          .searches = solve.restarts + 1.0,
          .is_found = is_found,
          .is_outside = is_found && is_outside,
          .is_solved = solve.status == Status::ok};
}

using Searches = std::span<const Search>;

struct SearchStatistic {
  std::string_view column, heading;  // in results/published; of our table
  double (*of)(Searches);
  bool is_whole = false;  // printed as an integer
  bool has_range = true;  // false: resamples say nothing of it
  bool is_percentage = false;
};

std::vector<double> of_found(Searches all, double Search::*value) {
  std::vector<double> found;
  for (const Search& search : all) {
    if (search.is_found) found.push_back(search.*value);
  }
  return found;
}

// The values are whole numbers, so that their sum is exact.
double mean_of_found(Searches all, double Search::*value) {
  const std::vector<double> found = of_found(all, value);
  return std::accumulate(found.begin(), found.end(), 0.0) / static_cast<double>(found.size());
}

// The middle one of the sorted iterations, the upper of two.
double median_of_found(Searches all) {
  std::vector<double> found = of_found(all, &Search::iterations);
  if (found.empty()) return not_defined;
  const auto middle = found.begin() + static_cast<std::ptrdiff_t>(found.size() / 2);
  std::ranges::nth_element(found, middle);
  return *middle;
}

double most_searches(Searches all) {
  const std::vector<double> found = of_found(all, &Search::searches);
  return found.empty() ? 0 : std::ranges::max(found);
}

double count_of(Searches all, bool Search::*is_it, bool wanted) {
  return static_cast<double>(std::ranges::count(all, wanted, is_it));
}

constexpr SearchStatistic search_statistics[]{
    {"iterations_mean", "mean iterations", [](Searches all) { return mean_of_found(all, &Search::iterations); }},
    {"iterations_median", "median iterations", median_of_found, true},
    {"infeasible", "no solution", [](Searches all) { return count_of(all, &Search::is_found, false); }, true},
    {"searches_mean", "mean searches", [](Searches all) { return mean_of_found(all, &Search::searches); }},
    {"searches_most", "most searches", most_searches, true, false},
    {"violations", "outside the limits", [](Searches all) { return count_of(all, &Search::is_outside, true); }, true},
    {.column = "error_rate_percent",
     .heading = "not solved [%]",
     .of =
         [](Searches all) { return 100 * count_of(all, &Search::is_solved, false) / static_cast<double>(all.size()); },
     .is_percentage = true}};

// Finds those that the printed table has.
std::vector<const SearchStatistic*> statistics_in(const CsvTable& printed) {
  std::vector<const SearchStatistic*> found;
  for (const SearchStatistic& statistic : search_statistics) {
    if (std::ranges::count(printed.header, statistic.column) > 0) found.push_back(&statistic);
  }
  return found;
}

// The central 95 % of what the statistic would be with other targets: ours plus the difference of two resamples. For a
// percentage it is Wilson's interval, since resamples of no failure have none.
Range range_of_chance(Searches all, const SearchStatistic& statistic) {
  constexpr int resamples = 400;
  constexpr double level = 0.95;
  const double ours = statistic.of(all);
  if (statistic.is_percentage) {
    const auto [share, low, high] = wilson_of_mean(ours / 100, static_cast<int>(all.size()), level);
    return {100 * low, 100 * high};
  }
  Draws draws(1);
  std::vector<Search> drawn(all.size());
  const auto of_resample = [&] {
    for (Search& search : drawn) search = all[draws.below(all.size())];
    return statistic.of(drawn);
  };
  std::vector<double> differences;
  for (int i = 0; i < resamples; ++i) {
    const double one = of_resample();
    differences.push_back(one - of_resample());
  }
  std::ranges::sort(differences);
  const auto outside = static_cast<std::size_t>(resamples * (1 - level) / 2);
  return {ours + differences[outside], ours + differences[differences.size() - 1 - outside]};
}

// Grades the agreement of a printed number with ours, the nearest first; a row agrees like the farthest of its numbers.
// open: it does not agree, and resamples say nothing of it.
enum class Agreed { digits, open, rounding, chance, outside, not_attempted };
using Counts = std::map<Agreed, int>;

std::vector<Search> searches_of(const StudyResults& study, std::string_view solver) {
  std::vector<Search> all;
  for (const Solve& solve : solves_of(study, solver)) all.push_back(search_of(solve, solve.is_outside_limits));
  return all;
}

// `copies` have other last bits.
std::pair<Agreed, OursAndPrinted> compared(const std::vector<Search>& own,
                                           const std::vector<std::vector<Search>>& copies,
                                           const SearchStatistic& statistic, const std::string& printed) {
  OursAndPrinted cell{
      .ours = statistic.of(own), .printed = printed, .nearness = Nearness::within, .decimals = decimals_of(printed)};
  if (agrees(cell.ours, printed)) return {Agreed::digits, cell};
  Range range{cell.ours, cell.ours};  // of rounding
  for (const std::vector<Search>& copy : copies) {
    const double other = statistic.of(copy);
    range = {std::min(range.low, other), std::max(range.high, other)};
  }
  cell.nearness = Nearness::near;
  if (can_be(range.low, range.high, printed)) {
    cell.words = fmt::format(words::within_rounding, "range"_a = readable(range));
    return {Agreed::rounding, cell};
  }
  if (!statistic.has_range) {
    cell.nearness = Nearness::unknown;
    return {Agreed::open, cell};
  }
  range = range_of_chance(own, statistic);
  const bool is_in = can_be(range.low, range.high, printed);
  if (!is_in) cell.nearness = Nearness::far;
  cell.words =
      fmt::format(fmt::runtime(is_in ? words::within_chance : words::outside_chance), "range"_a = readable(range));
  return {is_in ? Agreed::chance : Agreed::outside, cell};
}

// Counts the row, too.
Graded graded(const Counts& numbers, Counts& rows) {
  int all = 0;
  for (const auto& [agreed, count] : numbers) all += count;
  Agreed farthest = numbers.empty() ? Agreed::digits : numbers.rbegin()->first;
  if (farthest == Agreed::open) farthest = Agreed::chance;
  ++rows[farthest];
  if (farthest == Agreed::digits) return {std::string(words::every_digit), Nearness::within};
  const bool is_outside = farthest == Agreed::outside;
  const std::string_view sentence = is_outside                   ? words::row_outside
                                    : farthest == Agreed::chance ? words::row_by_chance
                                                                 : words::row_by_rounding;
  const auto agree = numbers.find(Agreed::digits);
  return {
      fmt::format(fmt::runtime(sentence), "agree"_a = agree == numbers.end() ? 0 : agree->second, "numbers"_a = all),
      is_outside ? Nearness::far : Nearness::near};
}

const StudyResults* study_named(const Reported& reported, const std::string& name) {
  if (reported.study.name == name) return &reported.study;
  const auto found =
      std::ranges::find_if(reported.companions, [&](const JudgedStudy& study) { return study.name == name; });
  return found == reported.companions.end() ? nullptr : &found->get();
}

double mean_seconds(const StudyResults& study, const std::string& solver) {
  std::vector<double> seconds;
  for (const Solve& solve : solves_of(study, solver)) seconds.push_back(solve.seconds);
  return mean(seconds);
}

// Times of different machines are not comparable, so their ratios are shown, and not judged.
Cell ratio_of_times(double ours, double printed) {
  const std::string ratio = fmt::format("{:.2f}", printed);
  if (!std::isfinite(ours)) return ratio;
  return OursAndPrinted{.ours = ours, .printed = ratio, .nearness = Nearness::unknown, .decimals = 2};
}

Table table_of(const Reported& reported, const CsvTable& printed, const PrintedTable& plan, Counts& rows) {
  const StudyResults& study = *study_named(reported, plan.study);
  const StudyResults* const beside = study_named(reported, plan.beside);
  const auto study_of = [&](const std::string& solver) -> const StudyResults& {
    return beside != nullptr && solves_of(study, solver).empty() ? *beside : study;
  };
  const std::vector<const SearchStatistic*> columns = statistics_in(printed);
  const std::size_t names = printed.column("solver");
  const bool has_shares = std::ranges::any_of(columns, &SearchStatistic::is_percentage);
  Table table{.name = "rows-" + plan.table,
              .caption = plan.caption + ", here and printed",
              .columns = {"solver", "agreement"},
              .notes = {std::string(has_shares ? words::range_of_chance_of_shares : words::range_of_chance)},
              .legend = std::string(words::legend_of_rows)};
  for (const SearchStatistic* const statistic : columns) table.columns.emplace_back(statistic->heading);
  const auto unit = std::ranges::find(printed.rows, plan.times_to, [&](const auto& row) { return row[names]; });
  if (!plan.times_to.empty()) {
    if (unit == printed.rows.end())
      throw std::invalid_argument(fmt::format("{}: times_to names {}, which no row has", plan.table, plan.times_to));
    table.columns.push_back(fmt::format("mean time / that of {}", plan.times_to));
    table.notes.emplace_back(words::ratios_of_times);
  }
  for (std::size_t i = 0; i < printed.rows.size(); ++i) {
    const std::string& solver = printed.rows[i][names];
    const std::vector<Search> own = searches_of(study_of(solver), solver);
    std::vector<std::vector<Search>> copies;
    for (const StudyResults& copy : copies_of(study_of(solver), reported)) copies.push_back(searches_of(copy, solver));
    std::vector<Cell>& row = table.rows.emplace_back(std::vector<Cell>{solver, Cell()});
    Counts numbers;
    for (const SearchStatistic* const statistic : columns) {
      const std::string& of_print = printed.rows[i][printed.column(statistic->column)];
      if (own.empty()) {
        row.emplace_back(of_print);
      } else if (of_print.empty()) {
        row.emplace_back(statistic->of(own));
      } else {
        const auto [agreed, cell] = compared(own, copies, *statistic, of_print);
        ++numbers[agreed];
        row.emplace_back(cell);
      }
    }
    if (own.empty()) {
      const auto why = plan.not_attempted.find(solver);
      row[1] = "not attempted" + (why == plan.not_attempted.end() ? "" : ": " + why->second);
      ++rows[Agreed::not_attempted];
    } else {
      row[1] = graded(numbers, rows);
    }
    if (plan.times_to.empty()) continue;
    const auto us_of = [&](std::ptrdiff_t of) { return printed.number(static_cast<std::size_t>(of), "us_mean"); };
    row.push_back(
        ratio_of_times(mean_seconds(study_of(solver), solver) / mean_seconds(study_of(plan.times_to), plan.times_to),
                       us_of(static_cast<std::ptrdiff_t>(i)) / us_of(unit - printed.rows.begin())));
  }
  return table;
}

PrintedNumbers agreeing(const CsvTable& printed, std::span<const SolveRecord> solves,
                        std::span<const std::string> solvers) {
  std::map<std::string, std::vector<Search>> searches;
  for (const SolveRecord& solve : solves) {
    searches[solve.solver].push_back(search_of(solve, solve.limit_violation_deg > 0 || solve.limit_violation_m > 0));
  }
  const auto columns = statistics_in(printed);
  const bool has_integers = std::ranges::any_of(columns, &SearchStatistic::is_whole);
  PrintedNumbers found;
  for (const std::vector<std::string>& row : printed.rows) {
    const std::string& solver = row[printed.column("solver")];
    if (std::ranges::count(solvers, solver) == 0) continue;
    for (const SearchStatistic* const statistic : columns) {
      const std::string& of_print = row[printed.column(statistic->column)];
      const std::vector<Search>& ours = searches[solver];
      const bool does_agree = agrees(statistic->of(ours), of_print);
      ++found.numbers;
      found.agreeing += does_agree ? 1 : 0;
      found.integers += statistic->is_whole ? 1 : 0;
      found.agreeing_integers += statistic->is_whole && does_agree ? 1 : 0;
      if (has_integers || ours.empty()) continue;
      const Range chance = range_of_chance(ours, *statistic);
      found.by_chance += can_be(chance.low, chance.high, of_print) ? 1 : 0;
    }
  }
  return found;
}

}  // namespace

StudyPieces compared_rows(const Reported& reported, const std::string& paper, const std::vector<PrintedTable>& tables) {
  StudyPieces result;
  Counts rows;
  for (const PrintedTable& plan : tables) {
    const StudyResults* const study = study_named(reported, plan.study);
    if (study == nullptr || study->solves.empty()) continue;
    result.tables.push_back(table_of(reported, printed_table(paper, plan.table), plan, rows));
  }
  const int attempted = rows[Agreed::digits] + rows[Agreed::rounding] + rows[Agreed::chance] + rows[Agreed::outside];
  if (attempted == 0) return result;
  result.verdict = {{"", fmt::format(words::rows_agree, "digits"_a = rows[Agreed::digits], "attempted"_a = attempted,
                                     "rounding"_a = rows[Agreed::rounding], "chance"_a = rows[Agreed::chance],
                                     "outside"_a = rows[Agreed::outside], "missing"_a = rows[Agreed::not_attempted])}};
  return result;
}

Lock read_lock(TomlReader reader, const std::string& paper) {
  Lock lock;
  std::string table;
  reader.text("study", lock.study, "");
  reader.text("table", table, "");
  reader.texts("solvers", lock.solvers, "");
  for (TomlReader& point : tables_of(reader, "points")) {
    SetUpPoint& read = lock.points.emplace_back();
    point.text("open", read.open, "");
    for (TomlReader& each : tables_of(point, "alternatives")) {
      SetUpPoint::Alternative& alternative = read.alternatives.emplace_back();
      each.texts("set", alternative.set, "");
      each.text("where", alternative.where, "");
      each.refuse_unknown_keys();
    }
    point.refuse_unknown_keys();
  }
  reader.refuse_unknown_keys();
  const CsvTable printed = printed_table(paper, table);
  for (const std::string& solver : lock.solvers) {
    const bool is_printed =
        std::ranges::any_of(printed.rows, [&](const auto& row) { return row[printed.column("solver")] == solver; });
    if (!is_printed) throw std::invalid_argument(fmt::format("the table {} has no row \"{}\"", table, solver));
  }
  lock.compared = [printed, solvers = lock.solvers](std::span<const SolveRecord> solves) {
    return agreeing(printed, solves, solvers);
  };
  return lock;
}

}  // namespace ikbench::claims
