#include "analysis/claims/audit.hpp"

#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include "analysis/claims/printed.hpp"
#include "analysis/claims/sql_functions.hpp"
#include "analysis/claims/tables_of.hpp"
#include "numerics/number.hpp"

namespace ikbench::claims {

using namespace numerics;
using namespace report;

namespace {

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

// The paper's statements outside its tables, as printed.
Words statements(SQLite::Database& database) {
  const Words row = rows_of(database, "SELECT * FROM said").front();
  Words said;
  for (const auto& [column, words] : row) {
    if (column.ends_with(printed_suffix)) said[column.substr(0, column.size() - printed_suffix.size())] = words;
  }
  return said;
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

Verdict judged(std::string_view printed, double follows, double slack) {
  const double half = half_unit(printed);
  const double distance = std::abs(number_from(printed).value() - follows);
  constexpr double room = 1 + 1e-9;  // 2.5 printed as 2 is half a unit off, and doubles are not exact
  if (distance <= half * room) return Verdict::holds;
  return distance <= (half + slack) * room ? Verdict::in_part : Verdict::fails;
}

std::vector<AuditItem> audited(std::string_view paper, std::string_view text, std::string_view source) {
  const toml::table table = parse_toml(text, source);
  TomlReader file(table, source, "");
  SQLite::Database database = printed_database(paper);
  add_functions(database);
  std::string views;
  read_prose(file, "views", views);
  std::vector<AuditItem> items;
  std::map<std::string, char> letters;  // the next letter, by id
  const toml::node* at = &table;
  try {
    database.exec(views);
    const Words said = statements(database);
    for (const TomlReader& reader : tables_of(file, "items")) {
      at = &reader.table();
      const AuditEntry entry = read_entry(reader);
      if (!std::ranges::all_of(entry.needs, [&](const std::string& name) { return said.contains(name); })) continue;
      for (Words& row : rows_of(database, entry.query)) {
        row.insert(said.begin(), said.end());
        AuditItem& item = items.emplace_back(item_of(entry, row));
        item.id += letters.try_emplace(item.id, 'a').first->second++;
      }
    }
  } catch (const std::runtime_error& error) {  // also SQLite's errors
    throw std::invalid_argument(file.where(at->source(), "") + error.what());
  }
  file.refuse_unknown_keys();
  return items;
}

}  // namespace ikbench::claims
