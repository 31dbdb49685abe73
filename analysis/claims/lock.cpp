#include "analysis/claims/lock.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "analysis/claims/printed.hpp"
#include "analysis/claims/search_statistics.hpp"
#include "analysis/claims/tables_of.hpp"

namespace ikbench::claims {

using namespace numerics;
using namespace report;
using namespace results;

namespace {

PrintedNumbers compared(const CsvTable& printed, std::span<const SolveRecord> solves,
                        std::span<const std::string> solvers) {
  std::map<std::string, std::vector<Search>> searches;
  for (const SolveRecord& solve : solves) {
    const bool is_outside = solve.limit_violation_deg > 0 || solve.limit_violation_m > 0;
    searches[solve.solver].push_back(
        search_of(solve.iterations, solve.restarts, solve.stop_reason, solve.status, is_outside));
  }
  const auto columns = statistics_in(printed);
  const bool has_integers = std::ranges::any_of(columns, &SearchStatistic::is_whole);
  PrintedNumbers found;
  for (const std::vector<std::string>& row : printed.rows) {
    const std::string& solver = row[printed.column("solver")];
    if (std::ranges::find(solvers, solver) == solvers.end()) continue;
    for (const SearchStatistic* const statistic : columns) {
      const std::string& digits = row[printed.column(statistic->column)];
      const std::vector<Search>& ours = searches[solver];
      const bool does_agree = agrees(statistic->of(ours), digits);
      ++found.numbers;
      found.agreeing += does_agree ? 1 : 0;
      if (!has_integers && !ours.empty()) found.by_chance += can_be(range_of_chance(ours, *statistic), digits) ? 1 : 0;
      found.integers += statistic->is_whole ? 1 : 0;
      found.agreeing_integers += statistic->is_whole && does_agree ? 1 : 0;
    }
  }
  return found;
}

SetUpPoint::Alternative read_alternative(TomlReader reader) {
  SetUpPoint::Alternative alternative;
  reader.texts("set", alternative.set, "");
  reader.text("where", alternative.where, "");
  reader.refuse_unknown_keys();
  return alternative;
}

}  // namespace

Lock read_lock(TomlReader reader, const std::string& paper) {
  Lock lock;
  std::string table;
  reader.text("study", lock.study, "");
  reader.text("table", table, "");
  reader.texts("solvers", lock.solvers, "");
  for (TomlReader& point : tables_of(reader, "points")) {
    SetUpPoint& read = lock.points.emplace_back();
    point.text("open", read.open, "");
    for (const TomlReader& each : tables_of(point, "alternatives")) read.alternatives.push_back(read_alternative(each));
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
    return compared(printed, solves, solvers);
  };
  return lock;
}

}  // namespace ikbench::claims
