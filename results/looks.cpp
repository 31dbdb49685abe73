#include "results/looks.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace ikbench::results {

namespace {

constexpr std::string_view word = "look after ";  // keys of the table meta: "look after 20 runs: slim2023"
constexpr int patience_ms = 1000;

std::string key_of(const std::string& study, int runs) { return fmt::format("{}{} runs: {}", word, runs, study); }

}  // namespace

std::vector<Look> looks_at(const std::string& study, const std::filesystem::path& store) {
  std::vector<Look> looks;
  try {
    SQLite::Database sqlite(store.string(), SQLite::OPEN_READONLY, patience_ms);
    SQLite::Statement query(sqlite, "SELECT key, value FROM meta WHERE substr(key, 1, ?1) = ?2");
    SQLite::bind(query, static_cast<int>(word.size()), std::string(word));
    while (query.executeStep()) {
      const std::string key = query.getColumn(0).getString();
      Look look{.when = query.getColumn(1).getString()};
      std::from_chars(key.data() + word.size(), key.data() + key.size(), look.runs);
      if (key == key_of(study, look.runs)) looks.push_back(std::move(look));
    }
  } catch (const SQLite::Exception&) {
    return {};
  }
  std::ranges::sort(looks, {}, &Look::runs);
  return looks;
}

void remember_look(const std::string& study, int runs, const std::filesystem::path& store) {
  const std::vector<Look> known = looks_at(study, store);
  if (runs < 1 || std::ranges::find(known, runs, &Look::runs) != known.end()) return;
  try {
    SQLite::Database sqlite(store.string(), SQLite::OPEN_READWRITE, patience_ms);
    SQLite::Statement insert(
        sqlite, "INSERT OR IGNORE INTO meta (key, value) VALUES (?1, strftime('%Y-%m-%dT%H:%M:%SZ', 'now'))");
    insert.bind(1, key_of(study, runs));
    insert.exec();
  } catch (const SQLite::Exception&) {  // it may only be read
  }
}

}  // namespace ikbench::results
