// Stores that are put together: nothing twice, nothing lost, nothing mixed up.
#include "results/merge.hpp"

#include <SQLiteCpp/SQLiteCpp.h>

#include "results/fingerprint.hpp"
#include "tests/catch.hpp"
#include "tests/results/samples.hpp"

using namespace ikbench;
using namespace ikbench::results;

namespace {

namespace fs = std::filesystem;

// A store with a session of that machine, and solves of the sample study.
void make_store(const fs::path& file, const std::string& machine, const std::vector<int>& runs) {
  Store store(file, Store::Mode::write);
  store.save_study(sample_study());
  const std::int64_t session = store.begin_session({{"machine", machine}});
  for (const int run : runs) {
    SolveRecord record = sample_record("key-a", run);
    record.session = session;
    store.append({record});
  }
}

std::vector<std::string> machines(const Store& store) {
  std::vector<std::string> list;
  for (const Session& session : store.sessions()) list.push_back(session.environment.at("machine"));
  return list;
}

}  // namespace

TEST_CASE("a merged store has the studies, solves and sessions of all", "[merge]") {
  const ScratchFolder folder;
  make_store(folder.path / "a", "one", {1, 3});
  make_store(folder.path / "b", "two", {2, 4});
  const Merged merged = merge(folder.path / "out", {folder.path / "a", folder.path / "b"});
  CHECK(merged.added == 4);
  CHECK(merged.known == 0);
  const Store store(folder.path / "out", Store::Mode::read);
  REQUIRE(store.studies().size() == 1);
  CHECK(store.studies().front().series.size() == 2);
  CHECK(machines(store) == std::vector<std::string>{"one", "two"});
  const std::vector<SolveRecord> solves = series_of(store, "key-a");
  REQUIRE(solves.size() == 4);
  for (const SolveRecord& solve : solves) {
    SolveRecord expected = sample_record("key-a", solve.run);
    expected.session = 2 - solve.run % 2;  // odd runs are of the first store
    CHECK(same(solve, expected));
  }
}

TEST_CASE("merging again changes nothing, and a session that ended meanwhile is the same one", "[merge]") {
  const ScratchFolder folder;
  make_store(folder.path / "a", "one", {1, 2});
  merge(folder.path / "out", {folder.path / "a"});
  Store(folder.path / "a", Store::Mode::write).add_to_session(1, {{"stolen_seconds", "0.5"}});
  const Merged again = merge(folder.path / "out", {folder.path / "a", folder.path / "a"});
  CHECK(again.added == 0);
  CHECK(again.known == 4);
  const Store store(folder.path / "out", Store::Mode::read);
  REQUIRE(store.sessions().size() == 1);
  CHECK(store.sessions().front().environment.at("stolen_seconds") == "0.5");
}

TEST_CASE("a solve with other bits is named, with both stores, and nothing is merged", "[merge]") {
  const ScratchFolder folder;
  make_store(folder.path / "a", "one", {1, 2});
  make_store(folder.path / "b", "two", {3, 2});
  SQLite::Database(folder.path / "b", SQLite::OPEN_READWRITE).exec("UPDATE solves SET evaluations = 7 WHERE run = 2");
  const auto merging = [&] { merge(folder.path / "out", {folder.path / "a", folder.path / "b"}); };
  const std::string said = complaint<std::invalid_argument>(merging);
  CHECK_THAT(said, ContainsSubstring("run 2, point 1"));
  CHECK_THAT(said,
             ContainsSubstring("other bits in " + quoted(folder.path / "b") + " than in " + quoted(folder.path / "a")));
  CHECK_THAT(said, ContainsSubstring("(evaluations)"));
  CHECK_FALSE(fs::exists(folder.path / "out"));
}

TEST_CASE("times and what a NaN was may differ and be the same", "[merge]") {
  const ScratchFolder folder;
  for (const char* name : {"a", "b"}) {
    Store store(folder.path / name, Store::Mode::write);
    store.begin_session({{"machine", name}});
    SolveRecord record = sample_record();
    record.position_error_cm = std::numeric_limits<double>::quiet_NaN();
    record.seconds = name[0] == 'a' ? 1 : 2;
    store.append({record});
  }
  CHECK(merge(folder.path / "out", {folder.path / "a", folder.path / "b"}).known == 1);
  CHECK(series_of(Store(folder.path / "out", Store::Mode::read), "key-a").front().seconds == 1);
}

TEST_CASE("another study of the same name is refused with the field that differs", "[merge]") {
  const ScratchFolder folder;
  make_store(folder.path / "a", "one", {1});
  StudyEntry other = sample_study();
  other.definition = R"({"robot":"iiwa14","runs":21,"points":20})";
  Store(folder.path / "b", Store::Mode::write).save_study(other);
  other = sample_study();
  other.series.front().key = "key-of-another-source";
  Store(folder.path / "c", Store::Mode::write).save_study(other);
  const auto said = [&](const char* name) {
    return complaint<std::invalid_argument>([&] { merge(folder.path / "a", {folder.path / name}); });
  };
  CHECK_THAT(said("b"), ContainsSubstring("runs is 20 and 21"));
  CHECK_THAT(said("c"), ContainsSubstring("use one version of ikbench"));
}

TEST_CASE("a store of the first version is merged into one of today", "[merge]") {
  const ScratchFolder folder;
  const fs::path old = "tests/data/store-of-4de262c.sqlite";
  const Merged merged = merge(folder.path / "out", {old});
  CHECK(merged.added > 0);
  const Store store(folder.path / "out", Store::Mode::read), before(old, Store::Mode::read);
  for (const StudyEntry& study : before.studies())
    CHECK(fingerprint(store.solves(study.name)) == fingerprint(before.solves(study.name)));
  CHECK(merge(folder.path / "out", {old}).known == merged.added);
}

TEST_CASE("a store with a solve of no session, or a BLOB in it, is damaged", "[merge]") {
  for (const char* edit :
       {"UPDATE solves SET session = 9", "UPDATE solves SET answer_rad = x'00'", "UPDATE solves SET run = 'one'"}) {
    const ScratchFolder folder;
    make_store(folder.path / "a", "one", {1});
    SQLite::Database(folder.path / "a", SQLite::OPEN_READWRITE).exec(edit);
    const auto merging = [&] { merge(folder.path / "out", {folder.path / "a"}); };
    CHECK_THAT(complaint<std::invalid_argument>(merging), ContainsSubstring(quoted(folder.path / "a") + " is damaged"));
  }
}
