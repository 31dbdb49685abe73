#include "results/merge.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "results/fingerprint.hpp"
#include "results/store.hpp"
#include "results/store_file.hpp"
#include "results/store_tables.hpp"

namespace ikbench::results {
namespace {

namespace fs = std::filesystem;

// The first field in which two definitions of a study differ, with both values; empty where they are the same.
std::string difference(const StudyEntry& a, const StudyEntry& b) {
  const auto is_same = [](const Series& one, const Series& other) { return one.key == other.key; };
  if (a.definition == b.definition && std::ranges::equal(a.series, b.series, is_same)) return "";
  const auto left = nlohmann::json::parse(a.definition), right = nlohmann::json::parse(b.definition);
  for (const auto& [key, value] : left.items()) {
    if (right.contains(key) && right[key] == value) continue;
    constexpr std::size_t most = 60;
    const std::string other = right.contains(key) ? right[key].dump() : "not there";
    return fmt::format("{} is {} and {}", key, value.dump().substr(0, most), other.substr(0, most));
  }
  return "the version of the solvers or of shared code is another, so use one version of ikbench for all";
}

// The studies of all stores, and of each the store that has it.
class Studies {
 public:
  void take(const fs::path& file, Store::Mode mode = Store::Mode::read) {
    for (StudyEntry& study : Store(file, mode).studies()) {
      const auto [found, is_new] = places_.try_emplace(study.name, studies_.size());
      if (is_new) {
        studies_.emplace_back(std::move(study), file);
      } else if (const auto& [known, first] = studies_[found->second]; !difference(known, study).empty()) {
        throw std::invalid_argument(fmt::format(
            "the study '{}' is not the same in '{}' and '{}': {}; nothing was merged; run one of them again "
            "as the other is",
            study.name, first.string(), file.string(), difference(known, study)));
      }
    }
  }
  const std::vector<std::pair<StudyEntry, fs::path>>& all() const { return studies_; }

 private:
  std::vector<std::pair<StudyEntry, fs::path>> studies_;  // in the order in which they were met
  std::map<std::string, std::size_t> places_;
};

// Whether two are one session: no fact says otherwise. One may have been read before it ended.
bool is_same(const Session& a, const Session& b) {
  return a.began == b.began && std::ranges::all_of(a.environment, [&](const auto& fact) {
           const auto found = b.environment.find(fact.first);
           return found == b.environment.end() || found->second == fact.second;
         });
}

class Target {
 public:
  explicit Target(const fs::path& file) : sessions_(read_sessions(file)), store_(file, Store::Mode::write) {
    // A journal of what was there before: new rows are written once. It needs the store for itself.
    store_.sqlite().exec("PRAGMA journal_mode = DELETE; PRAGMA cache_size = -65536");
  }

  SQLite::Database& sqlite() { return store_.sqlite(); }
  const std::string& name() const { return store_.name(); }
  void commit(SQLite::Transaction& transaction) { store_.commit(transaction); }

  // The number that a session of another store has in this one.
  std::int64_t number_of(const Session& session, const fs::path& origin) {
    auto known = std::ranges::find_if(sessions_, [&](const Session& ours) { return is_same(ours, session); });
    if (known == sessions_.end()) {
      SQLite::Statement add(sqlite(), "INSERT INTO sessions (began) VALUES (?)");
      add.bind(1, session.began);
      add.exec();
      sessions_.push_back({.id = sqlite().getLastInsertRowid(), .began = session.began});
      known = sessions_.end() - 1;
      origins_[known->id] = origin;
    }
    std::map<std::string, std::string> further = session.environment;
    std::erase_if(further, [&](const auto& fact) { return known->environment.contains(fact.first); });
    write_environment(sqlite(), known->id, further);
    known->environment.merge(further);
    return known->id;
  }

  // Where a session came from.
  std::string origin_of(std::int64_t session) const {
    const auto found = origins_.find(session);
    return found == origins_.end() ? name() : found->second.string();
  }

 private:
  static std::vector<Session> read_sessions(const fs::path& file) {
    return Store(file, Store::Mode::write).sessions();  // makes it where it is missing
  }

  std::vector<Session> sessions_;
  StoreFile store_;
  std::map<std::int64_t, fs::path> origins_;
};

// The solves of one store on their way into another, row by row and value by value.
class Solves {
 public:
  Solves(StoreFile& source, Target& target)
      : source_(source), target_(target), rows_(source.sqlite(), "SELECT * FROM solves") {
    std::string names, values;
    for (int i = 0; i < rows_.getColumnCount(); ++i) {
      names_.emplace_back(rows_.getColumnName(i));
      names += fmt::format("{}{}", i == 0 ? "" : ", ", names_.back());
      values += i == 0 ? "?" : ", ?";
    }
    insert_.emplace(target.sqlite(),
                    fmt::format("INSERT INTO solves ({}) VALUES ({}) ON CONFLICT DO NOTHING", names, values));
    std::string sql = "SELECT session FROM solves WHERE series = ?1 AND run = ?2 AND point = ?3";
    for (const std::size_t i : compared()) sql += fmt::format(" AND {} IS ?{}", names_[i], i + 4);
    same_.emplace(target.sqlite(), sql);
  }

  Merged move() {
    std::map<std::int64_t, std::int64_t> numbers;  // of sessions, here and there
    for (const Session& session : Store(source_.name(), Store::Mode::read).sessions())
      numbers[session.id] = guarded(target_.name(), [&] { return target_.number_of(session, source_.name()); });
    const int series = column("series"), run = column("run"), point = column("point"), session = column("session");
    Merged merged;
    while (rows_.executeStep()) {
      value_in<std::string>(rows_.getColumn(series));
      value_in<int>(rows_.getColumn(run));
      value_in<int>(rows_.getColumn(point));
      const auto number = numbers.find(value_in<std::int64_t>(rows_.getColumn(session)));
      if (number == numbers.end()) throw Damage("a solve is of a session that the table of sessions does not have");
      bind_row(session, number->second);
      const bool is_new = guarded(target_.name(), [&] { return insert(); });
      if (!is_new) check_same();
      ++(is_new ? merged.added : merged.known);
    }
    return merged;
  }

 private:
  int column(const char* name) const { return rows_.getColumnIndex(name); }

  // Those of which a fingerprint is made, but for the key, the name of the study, and columns that older stores lack.
  std::vector<std::size_t> compared() const {
    std::vector<std::size_t> list;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      const std::string& name = names_[i];
      if (name == "study" || name == "series" || name == "run" || name == "point") continue;
      if (std::ranges::find(in_fingerprint, name) != in_fingerprint.end()) list.push_back(i);
    }
    return list;
  }

  void pass_on(SQLite::Statement& to, int index, int from) {
    const SQLite::Column value = rows_.getColumn(from);
    switch (value.getType()) {
      case SQLITE_INTEGER:
        return to.bind(index, value.getInt64());
      case SQLITE_FLOAT:
        return to.bind(index, value.getDouble());
      case SQLITE_TEXT:
        return to.bind(index, value.getString());
      case SQLITE_NULL:
        return to.bind(index);
      default:
        throw Damage(fmt::format("{} is a BLOB in a row of table solves", names_[static_cast<std::size_t>(from)]));
    }
  }

  void bind_row(int session_column, std::int64_t session) {
    for (int i = 0; i < rows_.getColumnCount(); ++i) {
      if (i == session_column)
        insert_->bind(i + 1, session);
      else
        pass_on(*insert_, i + 1, i);
    }
  }

  // Whether it was not there.
  bool insert() {
    const bool is_new = insert_->exec() == 1;
    insert_->reset();
    return is_new;
  }

  void check_same() {
    bind_place(*same_);
    for (const std::size_t i : compared()) pass_on(*same_, static_cast<int>(i) + 4, static_cast<int>(i));
    const bool is_same = same_->executeStep();
    same_->reset();
    if (!is_same) refuse_other_bits();
  }

  void bind_place(SQLite::Statement& query) {
    pass_on(query, 1, column("series"));
    pass_on(query, 2, column("run"));
    pass_on(query, 3, column("point"));
  }

  [[noreturn]] void refuse_other_bits() {
    std::string what;
    std::int64_t session = 0;
    for (const std::size_t i : compared()) {
      SQLite::Statement query(target_.sqlite(),
                              fmt::format("SELECT {} IS ?4, session FROM solves WHERE series = ?1 AND run = ?2 AND "
                                          "point = ?3",
                                          names_[i]));
      bind_place(query);
      pass_on(query, 4, static_cast<int>(i));
      query.executeStep();
      session = query.getColumn(1).getInt64();
      if (query.getColumn(0).getInt() == 0) what += fmt::format("{}{}", what.empty() ? "" : ", ", names_[i]);
    }
    throw std::invalid_argument(fmt::format(
        "the solve of run {}, point {} by {} has other bits in '{}' than in '{}' ({}); nothing was merged; find out which "
        "machine, compiler or edit changed them (ikbench fingerprint)",
        excerpt(rows_.getColumn(column("run"))), excerpt(rows_.getColumn(column("point"))),
        excerpt(rows_.getColumn(column("solver"))), source_.name(), target_.origin_of(session), what));
  }

  StoreFile& source_;
  Target& target_;
  SQLite::Statement rows_;
  std::vector<std::string> names_;
  std::optional<SQLite::Statement> insert_, same_;
};

Merged merge_into(Target& target, const Studies& studies, const std::vector<fs::path>& stores) {
  SQLite::Transaction transaction(target.sqlite(), SQLite::TransactionBehavior::IMMEDIATE);
  for (const auto& [study, origin] : studies.all())
    if (origin != target.name()) write_study(target.sqlite(), study);
  Merged merged;
  for (const fs::path& file : stores) {
    const Merged of_store = guarded(file.string(), [&] {
      StoreFile source(file, Store::Mode::read);
      return Solves(source, target).move();
    });
    merged.added += of_store.added;
    merged.known += of_store.known;
  }
  target.commit(transaction);
  return merged;
}

}  // namespace

Merged merge(const fs::path& out, const std::vector<fs::path>& stores) {
  std::error_code error;
  const bool is_new = !fs::exists(out, error);
  Studies studies;
  if (!is_new) studies.take(out, Store::Mode::write);  // which undoes what a killed merge has begun
  for (const fs::path& file : stores) studies.take(file);
  try {
    return guarded(out.string(), [&] {
      Target target(out);
      return merge_into(target, studies, stores);
    });
  } catch (...) {
    if (is_new) fs::remove(out, error);
    throw;
  }
}

}  // namespace ikbench::results
