#include "results/merge.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <deque>
#include <future>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include "results/files.hpp"
#include "results/fingerprint.hpp"
#include "results/same_solves.hpp"
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

// A store to be read: its tables, and its rows as they are.
struct Source {
  explicit Source(const fs::path& of) : place(of), store(of, Store::Mode::read), file(of, Store::Mode::read) {}

  fs::path place;
  Store store;
  StoreFile file;
};

// The store that gets all, within one transaction.
class MergedStore {
 public:
  MergedStore(StoreFile& file, const Checker& check) : file_(file), check_(check) {
    const Store before(file.name(), Store::Mode::read);
    for (const StudyEntry& study : before.studies()) studies_.emplace(study.name, Known{study, file.name()});
    sessions_ = before.sessions();
  }

  // All that a store has now. Its solves are looked at by another thread meanwhile.
  void take(Source& source) {
    const std::int64_t last = guarded(source.place.string(),
                                      [&] { return source.file.number("SELECT coalesce(max(rowid), 0) FROM solves"); });
    looks_.push_back({source.place, std::async(std::launch::async, check_, source.place)});
    std::vector<StudyEntry> studies;
    source.store.at_one_moment([&] { studies = source.store.studies(); });
    for (const StudyEntry& study : studies) take(study, source.place);
    take_solves(source, last);
    if (looks_.size() > std::thread::hardware_concurrency()) end_first_look();
  }

  // std::invalid_argument where something is wrong with what was taken.
  void end_looks() {
    while (!looks_.empty()) end_first_look();
  }

  Merged merged;

 private:
  struct Known {
    StudyEntry study;
    fs::path place;
  };

  struct Look {
    fs::path place;
    std::future<std::string> wrong;
  };

  void end_first_look() {
    Look look = std::move(looks_.front());
    looks_.pop_front();
    const std::string wrong = look.wrong.get();
    if (!wrong.empty())
      throw std::invalid_argument(fmt::format("'{}': {} Nothing was merged; solve its studies again into a new store",
                                              look.place.string(), wrong));
  }

  void take(const StudyEntry& study, const fs::path& place) {
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
    if (is_new || is_changed) guarded(file_.name(), [&] { write_study(file_.sqlite(), known.study); });
  }

  // The numbers of sessions, there and here.
  std::map<std::int64_t, std::int64_t> take(const std::vector<Session>& sessions, const fs::path& place) {
    std::map<std::int64_t, std::int64_t> numbers;
    std::set<std::int64_t> taken;  // two of one store are two
    for (const Session& session : sessions) {
      const std::size_t before = sessions_.size();
      const std::int64_t number = guarded(file_.name(), [&] { return number_of(session, taken); });
      taken.insert(number);
      numbers[session.id] = number;
      if (sessions_.size() > before) origins_.emplace(number, place);
    }
    return numbers;
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

  void take_solves(Source& source, std::int64_t last) {
    std::map<std::int64_t, std::int64_t> numbers = take(source.store.sessions(), source.place);
    SQLite::Statement insert(file_.sqlite(), insert_solve(source.file.version()) + " ON CONFLICT DO NOTHING");
    const auto take_row = [&](SQLite::Statement& row) {
      const int session = row.getColumnIndex("session");
      auto number = numbers.find(value_in<std::int64_t>(row.getColumn(session)));
      if (number == numbers.end()) {  // it has begun since
        numbers = take(source.store.sessions(), source.place);
        number = numbers.find(row.getColumn(session).getInt64());
      }
      if (number == numbers.end()) throw Damage("a solve is of a session that the table of sessions does not have");
      bind_row(insert, row);
      insert.bind(session + 1, number->second);
      const bool is_new = guarded(file_.name(), [&] { return insert.exec() == 1; });
      insert.reset();
      ++(is_new ? merged.added : merged.known);
      if (!is_new) refuse_other_bits(solve_in(row), source.place);
    };
    guarded(source.place.string(), [&] { source.file.each_row(take_row, last); });
  }

  void refuse_other_bits(const SolveRecord& solve, const fs::path& place) {
    if (!select_)
      select_.emplace(file_.sqlite(), select_solves(schema_version) + " WHERE series = ? AND run = ? AND point = ?");
    SQLite::bind(*select_, solve.series, solve.run, solve.point);
    select_->executeStep();
    const auto origin = origins_.find(select_->getColumn(select_->getColumnIndex("session")).getInt64());
    const std::string other = origin == origins_.end() ? file_.name() : origin->second.string();
    std::vector<std::string_view> columns =
        guarded(other, [&] { return at_solve(*select_, [&] { return differences(solve_in(*select_), solve); }); });
    select_->reset();
    std::erase(columns, "study");  // the same solve may be of two
    if (columns.empty()) return;
    end_looks();  // rather than other bits they tell which are wrong
    throw std::invalid_argument(fmt::format(
        "the solve of run {}, point {} by {} has other bits in '{}' than in '{}' ({}); nothing was merged; find out "
        "which machine, compiler or edit changed them (ikbench fingerprint)",
        solve.run, solve.point, excerpt(solve.solver), place.string(), other, fmt::join(columns, ", ")));
  }

  StoreFile& file_;
  const Checker& check_;
  std::deque<Look> looks_;
  std::optional<SQLite::Statement> select_;
  std::map<std::string, Known> studies_;
  std::vector<Session> sessions_;
  std::map<std::int64_t, fs::path> origins_;  // of sessions that are new
};

Merged merge_into(const fs::path& file, const std::vector<fs::path>& stores, const Checker& check) {
  return guarded(file.string(), [&] {
    StoreFile target(file, Store::Mode::write_shared);
    target.sqlite().exec("PRAGMA cache_size = -65536");
    SQLite::Transaction transaction(target.sqlite(), SQLite::TransactionBehavior::IMMEDIATE);
    MergedStore store(target, check);
    for (const fs::path& place : stores) {
      std::optional<Source> source;
      try {
        guarded(place.string(), [&] { source.emplace(place); });
      } catch (const HalfWritten& error) {
        store.merged.half_written.emplace_back(error.what());
        continue;
      }
      store.take(*source);
    }
    if (!stores.empty() && store.merged.half_written.size() == stores.size())
      throw std::invalid_argument(store.merged.half_written.front());
    store.end_looks();
    target.commit(transaction);
    return store.merged;
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

Merged merge(const fs::path& out, const std::vector<fs::path>& stores, const Checker& check) {
  std::error_code error;
  if (fs::exists(out, error)) return merge_into(out, stores, check);
  const TemporaryFolder scratch(out.parent_path());
  const fs::path made = scratch.path() / out.filename();
  Merged merged = merge_into(made, stores, check);
  error = publish(made, out);
  if (!error) return merged;
  if (error == std::errc::file_exists) return merge_into(out, stores, check);  // another merge was faster
  throw std::invalid_argument(
      fmt::format("cannot write '{}': {}; choose a place that you can write to", out.string(), error.message()));
}

}  // namespace ikbench::results
