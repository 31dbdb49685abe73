#include "results/merge.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/Savepoint.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sqlite3.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <limits>
#include <map>
#include <optional>
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

namespace fs = std::filesystem;

// The facts of a session that are known at its start. Two sessions with the same facts are one.
std::string facts_of(const Session& session) {
  std::string facts = session.began;
  for (const auto& [key, value] : session.environment) {
    if (key == "stolen_seconds" || key.starts_with("program.")) continue;
    for (const std::string& text : {key, value}) facts += fmt::format(" {}:{}", text.size(), text);
  }
  return facts;
}

// A store to merge. A merged store names the stores that its studies and sessions came from.
struct Source {
  std::string of_study(const std::string& name) const {
    const auto found = studies.find(name);
    return found == studies.end() ? quoted(file) : found->second;
  }
  std::string of_session(std::int64_t number) const {
    const auto found = sessions.find(number);
    return found == sessions.end() ? quoted(file) : found->second;
  }
  static std::string quoted(const fs::path& place) { return fmt::format("'{}'", place.string()); }

  fs::path file;
  std::optional<StoreFile::Identity> identity = StoreFile::identity_of(file.string());
  std::map<std::string, std::string> studies = {};
  std::map<std::int64_t, std::string> sessions = {};
};

// The URI by which SQLite opens a file read-only (https://www.sqlite.org/uri.html).
std::string read_only(const fs::path& file) {
  std::string uri = "file://";
  for (const char c : fs::absolute(file).string()) {
    const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '/';
    uri += is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return uri + "?mode=ro";
}

// Attaches a file as the connection's database `source`. A transaction that has read it keeps it until the connection
// ends.
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

// A range of solves by their rowids, both ends included.
struct Rows {
  std::int64_t first = std::numeric_limits<std::int64_t>::min();
  std::int64_t last = std::numeric_limits<std::int64_t>::max();
};

// The store that receives the others.
class MergedStore {
 public:
  explicit MergedStore(StoreFile& file) : file_(file) {
    const Store before(file.name(), Store::Mode::read);
    for (const StudyEntry& study : before.studies())
      studies_.emplace(study.name, Known{study, Source::quoted(file.name())});
    for (const Session& session : before.sessions()) {
      same_[facts_of(session)].push_back(session.id);
      sessions_[session.id] = session;
    }
    file_.sqlite().exec("CREATE TEMP TABLE numbers (theirs INTEGER PRIMARY KEY, ours INTEGER NOT NULL)");
  }

  // Takes everything that a store has now.
  void take(const Store& store, const Source& source) {
    const Attached attached(file_.sqlite(), source.file);
    const Rows rows{.last = file_.number("SELECT coalesce(max(rowid), 0) FROM source.solves")};
    if (StoreFile::identity_of(source.file.string()) != source.identity)
      throw std::runtime_error(fmt::format("{} was replaced while it was merged; nothing was merged; merge again",
                                           Source::quoted(source.file)));
    for (const StudyEntry& study : store.studies()) take(study, source);
    take(store.sessions(), source);
    take_solves(source, rows);
  }

  // This store as a source for another one.
  Source as_source() const {
    Source source{.file = file_.name(), .sessions = origins_};
    for (const auto& [name, known] : studies_) source.studies.emplace(name, known.place);
    return source;
  }

  Merged merged;

 private:
  struct Known {
    StudyEntry study;
    std::string place;
  };

  void take(const StudyEntry& study, const Source& source) {
    const std::string place = source.of_study(study.name);
    const auto [found, is_new] = studies_.try_emplace(study.name, Known{study, place});
    Known& known = found->second;
    const std::string why = why_not_one(known.study, study);
    if (!why.empty())
      throw std::invalid_argument(
          fmt::format("the study '{}' is not the same in {} and {}: {}; nothing was merged; solve one of them again "
                      "as the other is, or leave one store out",
                      study.name, known.place, place, why));
    const bool is_larger = last_of(study).run > last_of(known.study).run;
    if (is_larger) known = {study, place};
    if (is_new || is_larger) write_study(file_.sqlite(), known.study);
  }

  // Takes sessions. Of several with the same facts the first is our first, and so on.
  void take(const std::vector<Session>& sessions, const Source& source) {
    SQLite::Savepoint all_at_once(file_.sqlite(), "sessions");
    file_.sqlite().exec("DELETE FROM temp.numbers");
    SQLite::Statement note(file_.sqlite(), "INSERT INTO temp.numbers VALUES (?, ?)");
    std::map<std::string, std::size_t> seen;
    for (const Session& session : sessions) {
      const std::string facts = facts_of(session);
      std::vector<std::int64_t>& same = same_[facts];
      const std::size_t place = seen[facts]++;
      const bool is_new = place == same.size();
      if (is_new) same.push_back(begin(session));
      add_facts(same[place], session);
      SQLite::bind(note, session.id, same[place]);
      note.exec();
      note.reset();
      note_origin(same[place], is_new, source.of_session(session.id));
    }
    all_at_once.release();
  }

  std::int64_t begin(const Session& session) {
    SQLite::Statement add(file_.sqlite(), "INSERT INTO sessions (began) VALUES (?)");
    add.bind(1, session.began);
    add.exec();
    const std::int64_t number = file_.sqlite().getLastInsertRowid();
    sessions_[number] = {.id = number, .began = session.began};
    return number;
  }

  void add_facts(std::int64_t number, const Session& session) {
    std::map<std::string, std::string>& known = sessions_[number].environment;
    std::map<std::string, std::string> further = session.environment;
    std::erase_if(further, [&](const auto& fact) { return known.contains(fact.first); });
    write_environment(file_.sqlite(), number, further);
    known.merge(further);
  }

  // Notes the store of a new session; several stores may have the same one.
  void note_origin(std::int64_t number, bool is_new, const std::string& place) {
    if (is_new)
      origins_[number] = place;
    else if (const auto found = origins_.find(number);
             found != origins_.end() && found->second.find(place) == std::string::npos)
      found->second += " or " + place;
  }

  // Takes solves, some at a time: a writer to a store without a log waits for the end of a query, and gives up after
  // some seconds.
  void take_solves(const Source& source, Rows all) {
    SQLite::Statement next(
        file_.sqlite(),
        "SELECT max(rowid), count(*) FROM (SELECT rowid FROM source.solves WHERE rowid BETWEEN ? AND "
        "? ORDER BY rowid LIMIT 1000)");
    SQLite::Statement copy(file_.sqlite(), copy_of_solves());
    for (;; ++all.first) {
      SQLite::bind(next, all.first, all.last);
      next.executeStep();
      const Rows rows{.first = all.first, .last = next.getColumn(0).getInt64()};
      const std::int64_t number = next.getColumn(1).getInt64();
      next.reset();
      if (number == 0) return;
      SQLite::bind(copy, rows.first, rows.last);
      const std::int64_t added = copy.exec();
      copy.reset();
      merged.added += added;
      merged.known += number - added;
      if (added < number) refuse_other_bits(source, rows);
      if (rows.last == all.last) return;
      all.first = rows.last;
    }
  }

  // The SQL that copies solves unchanged.
  std::string copy_of_solves() {
    std::vector<std::string> columns;
    for_each_column([&](std::string_view name, auto, auto) { columns.emplace_back(name); });
    std::vector<std::string> values = columns;
    std::ranges::replace(values, "session", "(SELECT ours FROM temp.numbers WHERE theirs = session)");
    return fmt::format(
        "INSERT INTO main.solves ({}) SELECT {} FROM source.solves WHERE rowid BETWEEN ? AND ? "
        "ON CONFLICT DO NOTHING",
        fmt::join(columns, ", "), fmt::join(values, ", "));
  }

  // Refuses rows of which this store has other bits. All of these rows are in this store by now.
  void refuse_other_bits(const Source& source, const Rows& rows) {
    std::vector<std::string_view> columns(in_fingerprint.begin(), in_fingerprint.end());
    std::erase(columns, "study");  // the same solve may belong to two studies
    std::vector<std::string> differ;
    for (const std::string_view column : columns) differ.push_back(fmt::format("theirs.{0} IS NOT ours.{0}", column));
    SQLite::Statement query(
        file_.sqlite(),
        fmt::format("SELECT {}, theirs.run AS run, theirs.point AS point, theirs.solver AS label, theirs.session AS "
                    "their_session, ours.session AS our_session FROM source.solves AS theirs JOIN main.solves AS "
                    "ours USING (series, run, point) WHERE theirs.rowid BETWEEN ? AND ? AND ({}) LIMIT 1",
                    fmt::join(differ, ", "), fmt::join(differ, " OR ")));
    SQLite::bind(query, rows.first, rows.last);
    if (!query.executeStep()) return;
    int index = 0;
    std::erase_if(columns, [&](std::string_view) { return query.getColumn(index++).getInt() == 0; });
    const auto origin = origins_.find(query.getColumn("our_session").getInt64());
    throw std::invalid_argument(fmt::format(
        "the solve of run {}, point {} by {} has other bits in {} than in {} ({}); nothing was merged; find out "
        "which machine, compiler or edit changed them (ikbench export --format fingerprint)",
        excerpt(query.getColumn("run")), excerpt(query.getColumn("point")), excerpt(query.getColumn("label")),
        source.of_session(query.getColumn("their_session").getInt64()),
        origin == origins_.end() ? Source::quoted(file_.name()) : origin->second, fmt::join(columns, ", ")));
  }

  StoreFile& file_;
  std::map<std::string, Known> studies_;
  std::map<std::string, std::vector<std::int64_t>> same_;  // sessions, by their facts
  std::map<std::int64_t, Session> sessions_;
  std::map<std::int64_t, std::string> origins_;  // of new sessions
};

void end_if(const std::atomic<bool>* cancelled) {
  if (cancelled != nullptr && *cancelled) throw MergeCancelled();
}

// Makes statements of the connection end with an error once `cancelled` is set.
void end_where(SQLite::Database& sqlite, const std::atomic<bool>* cancelled) {
  constexpr int instructions = 1000;  // between two checks
  const auto is_set = [](void* flag) { return static_cast<const std::atomic<bool>*>(flag)->load() ? 1 : 0; };
  if (cancelled != nullptr)
    sqlite3_progress_handler(sqlite.getHandle(), instructions, is_set, const_cast<std::atomic<bool>*>(cancelled));
}

// Reports the error that ended the copying of one store into another.
[[noreturn]] void refuse_copy(const SQLite::Exception& error, const fs::path& from, const fs::path& to) {
  const int code = error.getExtendedErrorCode();
  constexpr std::array writing{SQLITE_IOERR_WRITE, SQLITE_IOERR_FSYNC, SQLITE_IOERR_DIR_FSYNC, SQLITE_IOERR_TRUNCATE,
                               SQLITE_IOERR_DELETE};
  const bool is_of_writing = error.getErrorCode() == SQLITE_FULL || std::ranges::find(writing, code) != writing.end();
  results::refuse(is_of_writing ? to.string() : from.string(), error);
}

// Gathers all stores in a new one. It is nobody else's, so it needs no journal.
std::pair<Source, Merged> gather(const fs::path& file, const fs::path& out, const std::vector<fs::path>& stores,
                                 const std::atomic<bool>* cancelled, const MergeProgress& progress) {
  return guarded(out.string(), [&] {
    StoreFile target(file, Store::Mode::write_shared);
    target.sqlite().exec("PRAGMA journal_mode = MEMORY; PRAGMA synchronous = OFF");
    end_where(target.sqlite(), cancelled);
    MergedStore all(target);
    std::int64_t done = 0;
    for (const fs::path& place : stores) {
      if (progress) progress(done++, std::ssize(stores));
      const Source source{.file = place};
      std::optional<Store> store;
      try {
        store.emplace(place, Store::Mode::read);
      } catch (const HalfWritten& error) {
        all.merged.half_written.emplace_back(error.what());
        continue;
      }
      try {
        all.take(*store, source);
      } catch (const SQLite::Exception& error) {
        refuse_copy(error, place, out);
      }
    }
    if (!stores.empty() && all.merged.half_written.size() == stores.size())
      throw std::invalid_argument(all.merged.half_written.front());
    // This change makes SQLite wait until all is on the disk.
    target.sqlite().exec(fmt::format("PRAGMA synchronous = FULL; PRAGMA user_version = {}", store_version));
    return std::pair(all.as_source(), all.merged);
  });
}

// Adds the gathered store to `out`; all or nothing.
Merged take_into(const fs::path& out, const Source& gathered, const std::atomic<bool>* cancelled) {
  return guarded(out.string(), [&] {
    StoreFile target(out, Store::Mode::write_shared);
    target.sqlite().exec("PRAGMA cache_size = -65536");  // once it is full, readers are locked out
    end_where(target.sqlite(), cancelled);
    SQLite::Transaction transaction(target.sqlite(), SQLite::TransactionBehavior::IMMEDIATE);
    MergedStore all(target);
    all.take(Store(gathered.file, Store::Mode::read), gathered);
    end_if(cancelled);
    target.commit(transaction);
    return all.merged;
  });
}

// Renames a file, unless the name exists: then EEXIST.
std::error_code publish(const fs::path& file, const fs::path& name) {
  if (::renameat2(AT_FDCWD, file.c_str(), AT_FDCWD, name.c_str(), RENAME_NOREPLACE) == 0) return {};
  if (errno != EEXIST && ::link(file.c_str(), name.c_str()) == 0) return {};  // NFS knows no RENAME_NOREPLACE
  return {errno, std::generic_category()};
}

Merged merge_all(const fs::path& out, const std::vector<fs::path>& stores, const std::atomic<bool>* cancelled,
                 const MergeProgress& progress) {
  try {
    std::error_code none;
    if (fs::exists(out, none)) Store(out, Store::Mode::read);  // refuses what is no store before the long copy
  } catch (const HalfWritten&) {                               // opening it for writing mends it
  }
  const TemporaryFolder scratch(out.parent_path());
  const fs::path file = scratch.path() / out.filename();
  auto [gathered, merged] = gather(file, out, stores, cancelled, progress);
  end_if(cancelled);
  const std::error_code error = publish(file, out);
  if (!error) return merged;
  if (error != std::errc::file_exists)
    throw std::invalid_argument(
        fmt::format("cannot write '{}': {}; choose a place that you can write to", out.string(), error.message()));
  const Merged into_it = take_into(out, gathered, cancelled);
  merged.added = into_it.added;
  merged.known += into_it.known;
  return merged;
}

}  // namespace

Merged merge(const fs::path& out, const std::vector<fs::path>& stores, const std::atomic<bool>* cancelled,
             const MergeProgress& progress) {
  try {
    return merge_all(out, stores, cancelled, progress);
  } catch (const std::exception&) {
    end_if(cancelled);  // whatever the error was
    throw;
  }
}

}  // namespace ikbench::results
