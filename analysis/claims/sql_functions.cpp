#include "analysis/claims/sql_functions.hpp"

#include <sqlite3.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "analysis/claims/printed.hpp"
#include "analysis/statistics/anova.hpp"
#include "analysis/statistics/multiple_comparisons.hpp"
#include "analysis/statistics/welch.hpp"

namespace ikbench::claims {

using namespace statistics;

namespace {

using Row = std::vector<double>;
using Rows = std::vector<Row>;
using OfRows = double (*)(const Rows& rows);

struct Function {
  const char* name;
  int arguments;
  OfRows of;
};

std::vector<GroupSummary> groups_of(const Rows& rows) {
  std::vector<GroupSummary> groups;
  for (const Row& row : rows) groups.push_back({row[0], row[1], static_cast<int>(row[2])});
  return groups;
}

// The possible change of F by half a unit of every mean and standard deviation, all in the same direction.
double anova_slack(const Rows& rows) {
  const std::vector<GroupSummary> groups = groups_of(rows);
  double slack = 0;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    std::vector<GroupSummary> mean_moved = groups, std_moved = groups;
    mean_moved[i].mean += rows[i][3];
    std_moved[i].std += rows[i][4];
    for (const auto& moved : {mean_moved, std_moved})
      slack += std::abs(anova_from_summaries(moved).F - anova_from_summaries(groups).F);
  }
  return slack;
}

// The p of the pair whose rows end with a 1.
double p_of_pair(const Rows& rows, const std::vector<MeanDifference>& pairs) {
  const auto pair = std::ranges::find_if(
      pairs, [&](const MeanDifference& each) { return rows[each.first][3] == 1 && rows[each.second][3] == 1; });
  return pair == pairs.end() ? not_defined : pair->p;
}

constexpr Function of_groups[]{
    {"anova_f", 3, [](const Rows& rows) { return anova_from_summaries(groups_of(rows)).F; }},
    {"anova_level", 3, [](const Rows& rows) { return level_of_anova(groups_of(rows), 0.05); }},
    {"anova_slack", 5, anova_slack},
    {"welch_f", 3, [](const Rows& rows) { return welch_anova(groups_of(rows)).statistic; }},
    {"welch_p", 3, [](const Rows& rows) { return welch_anova(groups_of(rows)).p; }},
    {"tukey_p", 4, [](const Rows& rows) { return p_of_pair(rows, tukey(groups_of(rows), 0.95)); }},
    {"games_howell_p", 4, [](const Rows& rows) { return p_of_pair(rows, games_howell(groups_of(rows), 0.95)); }}};

Row row_of(int count, sqlite3_value** values) {
  Row row;
  for (int i = 0; i < count; ++i) row.push_back(sqlite3_value_double(values[i]));
  return row;
}

Rows*& rows_of(sqlite3_context* context) {
  return *static_cast<Rows**>(sqlite3_aggregate_context(context, sizeof(Rows*)));
}

void add_row(sqlite3_context* context, int count, sqlite3_value** values) {
  Rows*& rows = rows_of(context);
  if (rows == nullptr) rows = std::make_unique<Rows>().release();  // null at first; end_rows takes it
  rows->push_back(row_of(count, values));
}

void end_rows(sqlite3_context* context) {
  const std::unique_ptr<Rows> rows(rows_of(context));
  if (rows) sqlite3_result_double(context, static_cast<const Function*>(sqlite3_user_data(context))->of(*rows));
}

void half_unit_of(sqlite3_context* context, int, sqlite3_value** values) {
  const auto* text = reinterpret_cast<const char*>(sqlite3_value_text(values[0]));
  if (text != nullptr) sqlite3_result_double(context, half_unit(text));
}

void f_tail_of(sqlite3_context* context, int, sqlite3_value** values) {
  const Row row = row_of(3, values);
  sqlite3_result_double(context, f_upper_tail(row[0], row[1], row[2]));
}

void impossible_of(sqlite3_context* context, int, sqlite3_value** values) {
  const Row row = row_of(6, values);
  const std::string reason = impossible(row[0], row[1], row[2], row[3], row[4], row[5]);
  sqlite3_result_text(context, reason.c_str(), -1, SQLITE_TRANSIENT);
}

}  // namespace

std::string impossible(double mean, double median, double std, double max, double min, double n) {
  if (mean > max) return "the mean exceeds the maximum";
  if (mean < min) return "the mean is below the minimum";
  if (median > max || median < min) return "the median is outside the extremes";
  // Popoviciu's inequality for the sample standard deviation.
  if (std > (max - min) / 2 * std::sqrt(n / (n - 1))) return "the standard deviation exceeds what the extremes allow";
  // The mean and the median are at most one standard deviation (divided by n) apart.
  if (std::abs(mean - median) > std * std::sqrt((n - 1) / n)) return "mean and median are too far apart";
  return "";
}

void add_functions(SQLite::Database& database) {
  for (const Function& each : of_groups) {
    database.createFunction(each.name, each.arguments, true, const_cast<Function*>(&each), nullptr, add_row, end_rows);
  }
  database.createFunction("half_unit", 1, true, nullptr, half_unit_of);
  database.createFunction("f_tail", 3, true, nullptr, f_tail_of);
  database.createFunction("impossible", 6, true, nullptr, impossible_of);
}

}  // namespace ikbench::claims
