#include "analysis/claims/printed.hpp"

#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "numerics/number.hpp"
#include "results/published.hpp"

namespace ikbench::claims {

using namespace numerics;
using namespace results;
using namespace statistics;
using namespace inference;

namespace {

Words words_of(const CsvTable& table, std::size_t row) {
  Words words;
  for (std::size_t column = 0; column < table.header.size(); ++column) {
    words[table.header[column]] = table.rows[row][column];
  }
  return words;
}

// The statistics of a row that the table has, in columns such as mean_ms.
Description description_of(const CsvTable& table, std::size_t row, std::string_view unit) {
  Description of{.n = static_cast<int>(table.number(row, "n"))};
  for (const auto& [name, field] : printed_statistics) {
    const std::string column = fmt::format("{}{}", name, unit);
    if (std::ranges::count(table.header, column) > 0) of.*field = table.number(row, column);
  }
  return of;
}

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

}  // namespace

double half_unit(std::string_view printed) {
  const std::size_t e = std::min(printed.find_first_of("eE"), printed.size());
  const std::size_t point = printed.find('.');
  const std::size_t decimals = point < e ? e - point - 1 : 0;
  return number_from(fmt::format("0.5e-{}", decimals)).value() *
         (e < printed.size() ? number_from(fmt::format("1{}", printed.substr(e))).value() : 1.0);
}

CsvTable printed_table(std::string_view paper, std::string_view name) {
  const auto names = published::tables(paper);
  return std::ranges::count(names, name) > 0 ? published::table(paper, name) : CsvTable();
}

std::vector<PrintedRow> printed_rows(std::string_view paper, std::string_view name) {
  std::vector<PrintedRow> rows;
  const CsvTable table = printed_table(paper, name);
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const Words words = words_of(table, i);
    PrintedRow row{.algorithm = word(words, "algorithm"), .printed = description_of(table, i, "")};
    for (std::size_t s = 0; s < printed_statistics.size(); ++s) {
      const auto digits = words.find(printed_statistics[s].first);
      if (digits != words.end()) row.digits[s] = digits->second;
    }
    for (const Metric metric : all_metrics()) {
      if (name_of(metric) != word(words, "metric")) continue;
      row.metric = metric;
      rows.push_back(row);
    }
  }
  return rows;
}

std::vector<PrintedRow> printed_rows(std::string_view paper, std::string_view table, Metric metric) {
  std::vector<PrintedRow> rows = printed_rows(paper, table);
  std::erase_if(rows, [metric](const PrintedRow& row) { return row.metric != metric; });
  return rows;
}

std::vector<PrintedTime> printed_times(std::string_view paper, std::string_view name, const std::string& row) {
  const CsvTable table = printed_table(paper, name);
  std::vector<PrintedTime> times;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    times.push_back({filled(row, words_of(table, i)), description_of(table, i, "_ms")});
  }
  return times;
}

std::optional<AnovaTable> printed_anova(std::string_view paper, std::string_view name) {
  const CsvTable table = printed_table(paper, name);
  if (table.rows.empty()) return std::nullopt;
  constexpr std::size_t between = 0, within = 1, total = 2;
  AnovaTable printed;
  printed.ss_between = table.number(between, "ss");
  printed.ss_within = table.number(within, "ss");
  printed.ss_total = table.number(total, "ss");
  printed.df_between = static_cast<int>(table.number(between, "df"));
  printed.df_within = static_cast<int>(table.number(within, "df"));
  printed.ms_between = table.number(between, "ms");
  printed.ms_within = table.number(within, "ms");
  printed.F = table.number(between, "f");
  printed.p = table.number(between, "p");
  return printed;
}

std::optional<AnovaTable> comparable_anova(const StudyResults& study, const std::vector<PrintedRow>& rows,
                                           std::string_view table) {
  std::set<std::string> ours(study.solvers.begin(), study.solvers.end()), printed;
  for (const PrintedRow& row : rows) printed.insert(row.algorithm);
  const bool is_same = study.plan.unit == Unit::run && ours == printed;
  return is_same ? printed_anova(study.facts.published, table) : std::nullopt;
}

const std::string& word(const Words& words, std::string_view name) {
  const auto found = words.find(name);
  if (found == words.end()) throw std::runtime_error(fmt::format("no column {{{}}}", name));
  return found->second;
}

std::string filled(const std::string& text, const Words& words) {
  std::string result;
  std::size_t end = 0;
  for (std::size_t open = text.find('{'); open != std::string::npos; open = text.find('{', end)) {
    const std::size_t close = std::min(text.find('}', open), text.size() - 1);
    result += text.substr(end, open - end) + word(words, text.substr(open + 1, close - open - 1));
    end = close + 1;
  }
  return result + text.substr(end);
}

SQLite::Database printed_database(std::string_view paper) {
  SQLite::Database database(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  CsvTable said{.header = {"paper"}, .rows = {{std::string(paper)}}};
  for (const std::string_view name : published::tables(paper)) {
    const CsvTable table = published::table(paper, name);
    std::string sql_name(name);
    std::ranges::replace(sql_name, '-', '_');
    add_table(database, sql_name, table);
    if (name != "statements") continue;
    for (const std::vector<std::string>& row : table.rows) {
      said.header.push_back(row[table.column("name")]);
      said.rows.front().push_back(row[table.column("value")]);
    }
  }
  add_table(database, "said", said);
  return database;
}

}  // namespace ikbench::claims
