#include "results/looks.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "results/store_digests.hpp"

namespace ikbench::results {

namespace {

constexpr std::string_view word = "look after ";  // keys of the table meta: "look after 20 runs: slim2023"
constexpr int patience_ms = 1000;

std::string key_of(const std::string& study, int runs) { return fmt::format("{}{} runs: {}", word, runs, study); }

int runs_in(std::string_view key) {
  int runs = 0;
  std::from_chars(key.data() + std::min(word.size(), key.size()), key.data() + key.size(), runs);
  return runs;
}

}  // namespace

std::map<std::string, std::string> looks_among(const std::map<std::string, std::string>& meta,
                                               const std::string& study) {
  std::map<std::string, std::string> looks = meta;
  std::erase_if(looks, [&](const auto& row) { return row.first != key_of(study, runs_in(row.first)); });
  return looks;
}

Store open_to_look(const std::filesystem::path& store) {
  try {
    return {store, Store::Mode::read};
  } catch (const HalfWritten&) {
    try {
      SQLite::Database(store.string(), SQLite::OPEN_READWRITE, patience_ms).execAndGet("SELECT count(*) FROM meta");
    } catch (const SQLite::Exception&) {  // it is read-only
    }
    return {store, Store::Mode::read};
  }
}

std::vector<Look> looks_at(const std::string& study, const std::filesystem::path& store) {
  std::vector<Look> looks;
  try {
    SQLite::Database sqlite(store.string(), SQLite::OPEN_READONLY, patience_ms);
    for (const auto& [key, when] : looks_among(meta_in(sqlite), study)) looks.push_back({runs_in(key), when});
  } catch (const std::runtime_error&) {  // SQLite's, or damage
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
    SQLite::Transaction transaction(sqlite, SQLite::TransactionBehavior::IMMEDIATE);
    write_look(sqlite, study, key_of(study, runs),
               sqlite.execAndGet("SELECT strftime('%Y-%m-%dT%H:%M:%SZ', 'now')").getString());
    transaction.commit();
  } catch (const SQLite::Exception&) {  // it is read-only
  }
}

}  // namespace ikbench::results
