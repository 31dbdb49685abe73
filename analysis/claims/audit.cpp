#include "analysis/claims/audit.hpp"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sqlite3.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "analysis/claims/printed.hpp"
#include "analysis/claims/tables_of.hpp"
#include "analysis/statistics/anova.hpp"
#include "analysis/statistics/multiple_comparisons.hpp"
#include "analysis/statistics/welch.hpp"
#include "numerics/number.hpp"
#include "results/published.hpp"

namespace ikbench::claims {

using namespace numerics;
using namespace report;
using namespace results;
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
      slack += std::abs(anova_from_summaries(moved).statistic - anova_from_summaries(groups).statistic);
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
    {"anova_f", 3, [](const Rows& rows) { return anova_from_summaries(groups_of(rows)).statistic; }},
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

Rows*& rows_in(sqlite3_context* context) {
  return *static_cast<Rows**>(sqlite3_aggregate_context(context, sizeof(Rows*)));
}

void add_row(sqlite3_context* context, int count, sqlite3_value** values) {
  Rows*& rows = rows_in(context);
  if (rows == nullptr) rows = std::make_unique<Rows>().release();  // null at first; end_rows takes it
  rows->push_back(row_of(count, values));
}

void end_rows(sqlite3_context* context) {
  const std::unique_ptr<Rows> rows(rows_in(context));
  if (rows) sqlite3_result_double(context, static_cast<const Function*>(sqlite3_user_data(context))->of(*rows));
}

void half_unit_of(sqlite3_context* context, int, sqlite3_value** values) {
  const auto* text = reinterpret_cast<const char*>(sqlite3_value_text(values[0]));
  if (text == nullptr) return;
  try {
    sqlite3_result_double(context, half_unit(text));
  } catch (const std::runtime_error& error) {  // SQLite passes no exception on
    sqlite3_result_error(context, error.what(), -1);
  }
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

void add_functions(SQLite::Database& database) {
  for (const Function& each : of_groups) {
    database.createFunction(each.name, each.arguments, true, const_cast<Function*>(&each), nullptr, add_row, end_rows);
  }
  database.createFunction("half_unit", 1, true, nullptr, half_unit_of);
  database.createFunction("f_tail", 3, true, nullptr, f_tail_of);
  database.createFunction("impossible", 6, true, nullptr, impossible_of);
}

constexpr std::string_view printed_suffix = "_as_printed";

void add_table(SQLite::Database& database, const std::string& name, const CsvTable& table) {
  std::vector<std::string> columns, places;
  for (const std::string& column : table.header) {
    columns.push_back(fmt::format("\"{0}\" REAL, \"{0}{1}\" TEXT", column, printed_suffix));
    places.emplace_back("?, ?");
  }
  database.exec(fmt::format("CREATE TABLE \"{}\" ({})", name, fmt::join(columns, ", ")));
  for (const std::vector<std::string>& row : table.rows) {
    SQLite::Statement insert(database, fmt::format("INSERT INTO \"{}\" VALUES ({})", name, fmt::join(places, ", ")));
    for (std::size_t i = 0; i < 2 * row.size(); ++i) insert.bind(static_cast<int>(i) + 1, row[i / 2]);
    insert.exec();
  }
}

// Adds all tables of a paper: table-3.csv is table_3, its rows in order. A column has its numbers, and
// COLUMN_as_printed its digits. `said` is one row with the statements of statements.csv, one column per name. Returns
// the statements.
Words add_tables(SQLite::Database& database, std::string_view paper) {
  Words statements{{"paper", std::string(paper)}};
  CsvTable said{.header = {}, .rows = {{}}};
  for (const std::string_view name : published::tables(paper)) {
    const CsvTable table = published::table(paper, name);
    std::string sql_name(name);
    std::ranges::replace(sql_name, '-', '_');
    add_table(database, sql_name, table);
    if (name != "statements") continue;
    for (const std::vector<std::string>& row : table.rows) {
      statements[row[table.column("name")]] = row[table.column("value")];
    }
  }
  for (const auto& [name, value] : statements) {
    said.header.push_back(name);
    said.rows.front().push_back(value);
  }
  add_table(database, "said", said);
  return statements;
}

const Choices<std::pair<Verdict, bool>> faults{{"misprint", {Verdict::fails, true}},
                                               {"not supported", {Verdict::undecided, false}},
                                               {"contradiction", {Verdict::fails, false}}};

// An entry of audit.toml; each row of its query is an item.
struct AuditEntry {
  std::string id, query, holds, where, printed, follows, why;
  std::vector<std::string> needs;                             // statements without which it is left out
  std::pair<Verdict, bool> otherwise = faults.back().second;  // if it does not hold
};

AuditEntry read_entry(TomlReader reader) {
  AuditEntry entry;
  reader.text("id", entry.id, "");
  reader.texts("needs", entry.needs, "");
  read_prose(reader, "query", entry.query);
  read_prose(reader, "holds", entry.holds);
  for (const auto& [key, field] : {std::pair("where", &entry.where), std::pair("printed", &entry.printed),
                                   std::pair("follows", &entry.follows), std::pair("why", &entry.why)}) {
    read_prose(reader, key, *field);
    if (field->empty()) throw std::runtime_error(fmt::format("an item without {}; expected a text", key));
  }
  reader.choice("otherwise", entry.otherwise, faults, "");
  reader.refuse_unknown_keys();
  if (entry.query.empty() && entry.holds.empty()) throw std::runtime_error("an item without a query or holds");
  if (!entry.holds.empty()) entry.query = fmt::format("SELECT ({}) AS holds FROM said", entry.holds);
  return entry;
}

std::vector<Words> rows_of(SQLite::Database& database, const std::string& query) {
  SQLite::Statement statement(database, query);
  std::vector<Words> rows;
  while (statement.executeStep()) {
    Words& row = rows.emplace_back();
    for (int i = 0; i < statement.getColumnCount(); ++i)
      row[statement.getColumnName(i)] = statement.getColumn(i).getString();
  }
  if (rows.empty()) throw std::runtime_error("a query without a row");
  return rows;
}

// "a" to "z", then "aa", "ab", ...
std::string letters_of(int number) {
  return (number < 26 ? "" : letters_of(number / 26 - 1)) + static_cast<char>('a' + number % 26);
}

AuditItem item_of(const AuditEntry& entry, const Words& row) {
  const auto number = [&](std::string_view column) { return number_from(word(row, column)).value_or(0); };
  AuditItem item{.id = entry.id,
                 .where = filled(entry.where, row),
                 .printed = filled(entry.printed, row),
                 .follows = filled(entry.follows, row),
                 .verdict = Verdict::fails,
                 .why = filled(entry.why, row)};
  if (row.contains("number")) {
    item.verdict = judged(item.printed, number("number"), row.contains("slack") ? number("slack") : 0);
  } else if (number("holds") != 0) {
    item.verdict = Verdict::holds;
  }
  if (item.verdict == Verdict::fails) std::tie(item.verdict, item.is_misprint) = entry.otherwise;
  return item;
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

Verdict judged(std::string_view printed, double follows, double slack) {
  if (agrees(follows, printed)) return Verdict::holds;
  return agrees(follows, printed, slack) ? Verdict::in_part : Verdict::fails;
}

std::vector<AuditItem> audited(std::string_view paper, std::string_view text, std::string_view source) {
  const toml::table table = parse_toml(text, source);
  TomlReader file(table, source, "");
  SQLite::Database database(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  const Words said = add_tables(database, paper);
  add_functions(database);
  std::string views;
  read_prose(file, "views", views);
  std::vector<AuditItem> items;
  std::map<std::string, int> numbers;  // of items, by id
  const toml::node* at = &table;
  try {
    database.exec(views);
    for (const TomlReader& reader : tables_of(file, "items")) {
      at = &reader.table();
      const AuditEntry entry = read_entry(reader);
      if (!std::ranges::all_of(entry.needs, [&](const std::string& name) { return said.contains(name); })) continue;
      for (Words& row : rows_of(database, entry.query)) {
        row.insert(said.begin(), said.end());
        AuditItem& item = items.emplace_back(item_of(entry, row));
        item.id += letters_of(numbers[item.id]++);
      }
    }
  } catch (const std::runtime_error& error) {  // also SQLite's errors
    throw std::invalid_argument(file.where(at->source(), "") + error.what());
  }
  file.refuse_unknown_keys();
  return items;
}

}  // namespace ikbench::claims
