#include "results/merge.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sqlite3.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

#include "results/files.hpp"
#include "results/fingerprint.hpp"
#include "results/same_solves.hpp"
#include "results/store_codec.hpp"
#include "results/store_file.hpp"
#include "results/store_tables.hpp"

namespace ikbench::results {
namespace {

// Of what was solved by ikbench.
std::vector<std::string> own_keys(const StudyEntry& study) {
  std::vector<std::string> keys;
  for (const Series& series : study.series) {
    if (!is_imported(series)) keys.push_back(series.key);
  }
  return keys;
}

std::vector<std::string> own_configurations(const StudyEntry& study) {
  std::vector<std::string> keys = own_keys(study);
  for (std::string& key : keys) key = configuration_of(key);
  return keys;
}

// What was imported stays, whichever of two definitions is taken.
StudyEntry with_imports(StudyEntry study, const StudyEntry& other) {
  for (const Series& series : other.series) {
    const bool is_there = std::ranges::find(study.series, series.key, &Series::key) != study.series.end();
    if (!is_imported(series) || is_there) continue;
    if (std::ranges::find(study.series, series.label, &Series::label) != study.series.end())
      throw std::invalid_argument(fmt::format(
          "the study '{}' has two different imports of the label {}; nothing was merged; import one of them "
          "with another --label",
          study.name, excerpt(series.label)));
    study.series.push_back(series);
  }
  return study;
}

namespace fs = std::filesystem;

int runs_of(const StudyEntry& study) { return nlohmann::json::parse(study.definition).at("runs").get<int>(); }

// Whether two are one session: all facts are the same, but for those that are known at its end.
bool is_same(const Session& a, const Session& b) {
  const auto facts = [](const Session& session) {
    auto environment = session.environment;
    std::erase_if(environment, [](const auto& fact) {
      return fact.first == "stolen_seconds" || fact.first.starts_with("program.");
    });
    return environment;
  };
  return a.began == b.began && facts(a) == facts(b);
}

// A store to be taken. What others were put together into says where it has its studies and sessions from.
struct Source {
  const fs::path& of_study(const std::string& name) const {
    const auto found = studies.find(name);
    return found == studies.end() ? file : found->second;
  }
  const fs::path& of_session(std::int64_t number) const {
    const auto found = sessions.find(number);
    return found == sessions.end() ? file : found->second;
  }

  fs::path file;
  std::map<std::string, fs::path> studies = {};
  std::map<std::int64_t, fs::path> sessions = {};
};

// How SQLite opens a file to read only (https://www.sqlite.org/uri.html).
std::string read_only(const fs::path& file) {
  std::string uri = "file:";
  for (const char c : fs::absolute(file).string()) {
    const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '/';
    uri += is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return uri + "?mode=ro";
}

// The database `source` of a connection. Within a transaction that has read it, it stays until the connection ends.
class Attached {
 public:
  Attached(SQLite::Database& sqlite, const fs::path& file) : sqlite_(sqlite) {
    SQLite::Statement attach(sqlite_, "ATTACH ? AS source");
    attach.bind(1, read_only(file));
    attach.exec();
  }
  ~Attached() { sqlite_.tryExec("DETACH source"); }
  Attached(const Attached&) = delete;
  Attached& operator=(const Attached&) = delete;

 private:
  SQLite::Database& sqlite_;
};

// Solves by their rowids.
struct Rows {
  std::int64_t after = 0;
  std::int64_t to = 0;
};

// The store that gets all.
class MergedStore {
 public:
  explicit MergedStore(StoreFile& file) : file_(file) {
    const Store before(file.name(), Store::Mode::read);
    for (const StudyEntry& study : before.studies()) studies_.emplace(study.name, Known{study, file.name()});
    sessions_ = before.sessions();
    file_.sqlite().exec("CREATE TEMP TABLE numbers (theirs INTEGER PRIMARY KEY, ours INTEGER NOT NULL)");
  }

  // All that a store has now.
  void take(const Store& store, const Source& source) {
    const Attached attached(file_.sqlite(), source.file);
    const std::int64_t last = file_.number("SELECT coalesce(max(rowid), 0) FROM source.solves");
    std::vector<StudyEntry> studies;
    store.at_one_moment([&] { studies = store.studies(); });
    for (const StudyEntry& study : studies) take(study, source);
    take(store.sessions(), source);
    take_solves(source, last);
  }

  // Of this store, for a store that takes it.
  Source as_source() const {
    Source source{.file = file_.name(), .sessions = origins_};
    for (const auto& [name, known] : studies_) source.studies.emplace(name, known.place);
    return source;
  }

  Merged merged;

 private:
  struct Known {
    StudyEntry study;
    fs::path place;
  };

  void take(const StudyEntry& study, const Source& source) {
    const fs::path& place = source.of_study(study.name);
    const auto [found, is_new] = studies_.try_emplace(study.name, Known{study, place});
    Known& known = found->second;
    const std::string why = why_not_one(known.study, study);
    if (!why.empty())
      throw std::invalid_argument(fmt::format(
          "the study '{}' is not the same in '{}' and '{}': {}; nothing was merged; solve one of them again "
          "as the other is, or leave one store out",
          study.name, known.place.string(), place.string(), why));
    const bool is_larger = runs_of(study) > runs_of(known.study);
    const std::size_t before = known.study.series.size();
    known.study = is_larger ? with_imports(study, known.study) : with_imports(known.study, study);
    if (is_larger) known.place = place;
    const bool is_changed = is_larger || known.study.series.size() > before;
    if (is_new || is_changed) write_study(file_.sqlite(), known.study);
  }

  void take(const std::vector<Session>& sessions, const Source& source) {
    file_.sqlite().exec("DELETE FROM temp.numbers");
    SQLite::Statement note(file_.sqlite(), "INSERT INTO temp.numbers VALUES (?, ?)");
    std::set<std::int64_t> taken;  // two of one store are two
    for (const Session& session : sessions) {
      const std::size_t before = sessions_.size();
      const std::int64_t number = number_of(session, taken);
      taken.insert(number);
      SQLite::bind(note, session.id, number);
      note.exec();
      note.reset();
      if (sessions_.size() > before) origins_.emplace(number, source.of_session(session.id));
    }
  }

  std::int64_t number_of(const Session& session, const std::set<std::int64_t>& taken) {
    auto known = std::ranges::find_if(
        sessions_, [&](const Session& ours) { return is_same(ours, session) && !taken.contains(ours.id); });
    if (known == sessions_.end()) {
      SQLite::Statement add(file_.sqlite(), "INSERT INTO sessions (began) VALUES (?)");
      add.bind(1, session.began);
      add.exec();
      sessions_.push_back({.id = file_.sqlite().getLastInsertRowid(), .began = session.began});
      known = sessions_.end() - 1;
    }
    std::map<std::string, std::string> further = session.environment;
    std::erase_if(further, [&](const auto& fact) { return known->environment.contains(fact.first); });
    write_environment(file_.sqlite(), known->id, further);
    known->environment.merge(further);
    return known->id;
  }

  // Some at a time: who writes to a store without a log waits for the end of a query, and gives up some seconds later.
  void take_solves(const Source& source, std::int64_t last) {
    SQLite::Statement next(file_.sqlite(),
                           "SELECT max(rowid), count(*) FROM (SELECT rowid FROM source.solves WHERE rowid > ?1 AND "
                           "rowid <= ?2 ORDER BY rowid LIMIT 1000)");
    SQLite::Statement copy(file_.sqlite(), copy_of_solves());
    for (Rows rows{.to = std::numeric_limits<std::int64_t>::min()}; rows.to < last;) {
      SQLite::bind(next, rows.to, last);
      next.executeStep();
      rows = {rows.to, next.getColumn(0).getInt64()};
      const std::int64_t number = next.getColumn(1).getInt64();
      next.reset();
      if (number == 0) return;
      SQLite::bind(copy, rows.after, rows.to);
      const std::int64_t added = copy.exec();
      copy.reset();
      merged.added += added;
      merged.known += number - added;
      if (added < number) refuse_other_bits(source, rows);
    }
  }

  // As they are: whether numbers follow from answers is found by who reads the store.
  std::string copy_of_solves() {
    const std::vector<std::string_view> columns = columns_of_solves(file_.number("PRAGMA source.user_version"));
    std::vector<std::string> values(columns.begin(), columns.end());
    std::ranges::replace(values, "session", "(SELECT ours FROM temp.numbers WHERE theirs = session)");
    return fmt::format(
        "INSERT INTO main.solves ({}) SELECT {} FROM source.solves WHERE rowid > ? AND rowid <= ? "
        "ON CONFLICT DO NOTHING",
        fmt::join(columns, ", "), fmt::join(values, ", "));
  }

  // Of these rows all are in this store now.
  void refuse_other_bits(const Source& source, const Rows& rows) {
    std::vector<std::string_view> columns(in_fingerprint.begin(), in_fingerprint.end());
    std::erase(columns, "study");  // the same solve may be of two
    std::vector<std::string> differ;
    for (const std::string_view column : columns) differ.push_back(fmt::format("theirs.{0} IS NOT ours.{0}", column));
    SQLite::Statement query(
        file_.sqlite(),
        fmt::format("SELECT {}, theirs.run AS run, theirs.point AS point, theirs.solver AS label, theirs.session AS "
                    "their_session, ours.session AS our_session FROM source.solves AS theirs JOIN main.solves AS "
                    "ours USING (series, run, point) "
                    "WHERE theirs.rowid > ? AND theirs.rowid <= ? AND ({}) LIMIT 1",
                    fmt::join(differ, ", "), fmt::join(differ, " OR ")));
    SQLite::bind(query, rows.after, rows.to);
    if (!query.executeStep()) return;
    int index = 0;
    std::erase_if(columns, [&](std::string_view) { return query.getColumn(index++).getInt() == 0; });
    const auto origin = origins_.find(query.getColumn("our_session").getInt64());
    throw std::invalid_argument(fmt::format(
        "the solve of run {}, point {} by {} has other bits in '{}' than in '{}' ({}); nothing was merged; find out "
        "which machine, compiler or edit changed them (ikbench fingerprint)",
        excerpt(query.getColumn("run")), excerpt(query.getColumn("point")), excerpt(query.getColumn("label")),
        source.of_session(query.getColumn("their_session").getInt64()).string(),
        origin == origins_.end() ? file_.name() : origin->second.string(), fmt::join(columns, ", ")));
  }

  StoreFile& file_;
  std::map<std::string, Known> studies_;
  std::vector<Session> sessions_;
  std::map<std::int64_t, fs::path> origins_;  // of sessions that are new
};

// What ends the copying of one store into another.
[[noreturn]] void refuse_copy(const SQLite::Exception& error, const fs::path& from, const fs::path& to) {
  const int code = error.getExtendedErrorCode();
  if (code == SQLITE_CONSTRAINT_NOTNULL)
    results::refuse(from.string(), Damage(fmt::format("a solve lacks a value, or is of a session that is not there: {}",
                                                      error.what())));
  const bool is_of_reading = code == SQLITE_IOERR_READ || code == SQLITE_IOERR_SHORT_READ;
  const bool is_of_writing =
      error.getErrorCode() == SQLITE_FULL || (error.getErrorCode() == SQLITE_IOERR && !is_of_reading);
  results::refuse(is_of_writing ? to.string() : from.string(), error);
}

// All of them in a new store, which is nobody else's: it needs no journal.
std::pair<Source, Merged> gather(const fs::path& file, const fs::path& out, const std::vector<fs::path>& stores) {
  return guarded(out.string(), [&] {
    StoreFile target(file, Store::Mode::write_shared);
    target.sqlite().exec("PRAGMA journal_mode = MEMORY; PRAGMA synchronous = OFF");
    MergedStore all(target);
    for (const fs::path& place : stores) {
      std::optional<Store> store;
      try {
        store.emplace(place, Store::Mode::read);
      } catch (const HalfWritten& error) {
        all.merged.half_written.emplace_back(error.what());
        continue;
      }
      try {
        all.take(*store, {.file = place});
      } catch (const SQLite::Exception& error) {
        refuse_copy(error, place, out);
      }
    }
    if (!stores.empty() && all.merged.half_written.size() == stores.size())
      throw std::invalid_argument(all.merged.half_written.front());
    target.sqlite().exec(
        "PRAGMA synchronous = FULL; UPDATE meta SET value = value");  // what was written is on the disk
    return std::pair(all.as_source(), all.merged);
  });
}

// All or nothing.
Merged take_into(const fs::path& out, const Source& gathered) {
  return guarded(out.string(), [&] {
    StoreFile target(out, Store::Mode::write_shared);
    SQLite::Transaction transaction(target.sqlite(), SQLite::TransactionBehavior::IMMEDIATE);
    MergedStore all(target);
    all.take(Store(gathered.file, Store::Mode::read), gathered);
    target.commit(transaction);
    return all.merged;
  });
}

// Gives a file its name unless there is one of that name: then EEXIST.
std::error_code publish(const fs::path& file, const fs::path& name) {
  if (::renameat2(AT_FDCWD, file.c_str(), AT_FDCWD, name.c_str(), RENAME_NOREPLACE) == 0) return {};
  if (errno != EEXIST && ::link(file.c_str(), name.c_str()) == 0) return {};  // NFS knows no RENAME_NOREPLACE
  return {errno, std::generic_category()};
}

}  // namespace

std::string why_not_one(const StudyEntry& study, const StudyEntry& other) {
  const std::string difference = difference_in_solves(study.definition, other.definition);
  if (!difference.empty()) return difference;
  if (own_keys(study) == own_keys(other)) return "";
  if (own_configurations(study) != own_configurations(other)) return "its solvers or their options are others";
  return "the version of the solvers or of shared code is another, so use one version of ikbench for all";
}

Merged merge(const fs::path& out, const std::vector<fs::path>& stores) {
  const TemporaryFolder scratch(out.parent_path());
  const fs::path file = scratch.path() / out.filename();
  auto [gathered, merged] = gather(file, out, stores);
  const std::error_code error = publish(file, out);
  if (!error) return merged;
  if (error != std::errc::file_exists)
    throw std::invalid_argument(
        fmt::format("cannot write '{}': {}; choose a place that you can write to", out.string(), error.message()));
  const Merged into_it = take_into(out, gathered);
  merged.added = into_it.added;
  merged.known += into_it.known;
  return merged;
}

}  // namespace ikbench::results
