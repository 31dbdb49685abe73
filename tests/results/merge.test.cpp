// Merged stores: nothing twice, nothing lost, nothing mixed up.
#include "experiments/stored_checks.hpp"
#include "tests/results/samples.hpp"

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

// Without a check of the made-up solves.
MergeResult merge(const fs::path& out, const std::vector<fs::path>& stores) {
  return results::merge(out, stores, [](const StoredStudy&) { return [](const SolveRecord&) {}; });
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
  const MergeResult merged = merge(folder.path / "out", {folder.path / "a", folder.path / "b"});
  CHECK(merged.added == 4);
  CHECK(merged.duplicates == 0);
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

TEST_CASE("extras come back with their solves, in a table that only stores with some have", "[merge]") {
  const ScratchFolder folder;
  make_store(folder.path / "a", "one", {1});
  {
    Store store(folder.path / "b", Store::Mode::write);
    store.save_study(sample_study());
    SolveRecord record = sample_record("key-a", 2);
    record.extras = {{"restarts", 3}, {"answers", -0.5}};
    store.append({record, sample_record("key-a", 3)});
    record.run = 4;
    record.extras = {{"restarts", std::numeric_limits<double>::quiet_NaN()}};
    store.append({record});
  }
  merge(folder.path / "out", {folder.path / "a", folder.path / "b", folder.path / "b"});
  edit(folder.path / "b", "INSERT INTO extras VALUES ('key-a', 3, 1, 'late', 1)");
  merge(folder.path / "out", {folder.path / "b"});  // whose solves are known
  const Store store(folder.path / "out", Store::Mode::read);
  CHECK(store.extra_names(sample_study()) == std::vector<std::string>{"answers", "restarts"});
  CHECK(Store(folder.path / "a", Store::Mode::read).extra_names(sample_study()).empty());
  const std::vector<SolveRecord> solves = series_of(store, "key-a");
  CHECK(solves[0].extras.empty());
  CHECK(solves[1].extras == std::map<std::string, double>{{"restarts", 3}, {"answers", -0.5}});
  CHECK(solves[2].extras.empty());
  CHECK(std::isnan(solves[3].extras.at("restarts")));
  edit(folder.path / "out", "UPDATE extras SET name = name || char(10)");
  CHECK_THROWS_WITH(store.extra_names(sample_study()), ContainsSubstring("as the name of an extra"));
  CHECK_THROWS_WITH(series_of(store, "key-a"), ContainsSubstring("as the name of an extra"));
  edit(folder.path / "out", "DROP TABLE extras; CREATE TABLE extras (series, run, point, name, value)");
  CHECK_THROWS_AS(Store(folder.path / "out", Store::Mode::read), std::invalid_argument);
}

TEST_CASE("a solve with other bits is named, with both stores, and its store is not merged", "[merge]") {
  const ScratchFolder folder;
  make_store(folder.path / "a", "one", {1, 2});
  make_store(folder.path / "b", "two", {3, 2});
  edit(folder.path / "b", "UPDATE solves SET evaluations = 7 WHERE run = 2");
  const auto merging = [&] { merge(folder.path / "out", {folder.path / "a", folder.path / "b"}); };
  const std::string said = complaint<std::invalid_argument>(merging);
  CHECK_THAT(said, ContainsSubstring("run 2, point 1"));
  CHECK_THAT(said, ContainsSubstring("other bits in " + quoted(folder.path / "b") + " than in " +
                                     quoted(folder.path / "out")));
  CHECK_THAT(said, ContainsSubstring("(evaluations)"));
  CHECK(series_of(Store(folder.path / "out", Store::Mode::read), "key-a").size() == 2);
  edit(folder.path / "b", "UPDATE solves SET evaluations = 10000, all_answers_rad = answer_rad WHERE run = 2");
  CHECK_THAT(complaint<std::invalid_argument>(merging), ContainsSubstring("(all_answers_rad)"));
}

TEST_CASE("a store with a solve that the check refuses is named and left out, and the others are merged", "[merge]") {
  const ScratchFolder folder;
  for (const char* name : {"a", "b", "c", "d"}) make_store(folder.path / name, name, {name[0] - 'a' + 1});
  edit(folder.path / "b", "UPDATE solves SET evaluations = 7, run = 99");  // beyond the study's runs
  edit(folder.path / "c", "UPDATE solves SET status = 'fine'");
  const MakeCheck check_of = [](const StoredStudy&) {
    return [](const SolveRecord& solve) {
      if (solve.evaluations == 7) throw std::invalid_argument("wrong");
    };
  };
  const auto merging = [&](const std::vector<fs::path>& stores) {
    return results::merge(folder.path / "out", stores, check_of);
  };
  CHECK(complaint<std::invalid_argument>([&] { merging({folder.path / "b"}); }) ==
        quoted(folder.path / "b") + ": wrong");
  CHECK_FALSE(fs::exists(folder.path / "out"));
  const MergeResult merged = merging({folder.path / "a", folder.path / "b", folder.path / "c", folder.path / "d"});
  CHECK(merged.added == 2);
  CHECK(merged.stores == 2);
  REQUIRE(merged.skipped.size() == 2);
  CHECK_THAT(merged.skipped[0], StartsWith(quoted(folder.path / "b")));
  CHECK(merged.skipped[1].rfind(quoted(folder.path / "c")) == 0);  // once
  edit(folder.path / "out", "UPDATE solves SET evaluations = 7 WHERE run = 4");
  CHECK_THAT(complaint<std::invalid_argument>([&] { merging({folder.path / "a"}); }),
             StartsWith(quoted(folder.path / "out")));
}

TEST_CASE("solves that no study of their store has are counted and left out, with what belongs to them", "[merge]") {
  for (const char* change : {"DELETE FROM studies; DELETE FROM series", "UPDATE studies SET name = 'other'",
                             "UPDATE studies SET name = 'other'; UPDATE series SET study = 'other', key = key || 'x'",
                             "UPDATE solves SET point = 21"}) {
    CAPTURE(change);
    const ScratchFolder folder;
    make_store(folder.path / "a", "one", {1});
    make_store(folder.path / "b", "two", {1, 2});  // the first has other bits than in a
    edit(folder.path / "b", std::string("UPDATE solves SET evaluations = 7; ") + change);
    const MergeResult merged = merge(folder.path / "out", {folder.path / "a", folder.path / "b"});
    CHECK(merged.added == 1);
    CHECK(merged.duplicates == 0);
    REQUIRE(merged.skipped.size() == 1);
    CHECK(merged.skipped[0] ==
          "2 of 2 solves in " + quoted(folder.path / "b") + ", because none of its studies has them");
    const Store store(folder.path / "out", Store::Mode::read);
    CHECK(series_of(store, "key-a").size() == 1);
    CHECK(machines(store) == std::vector<std::string>{"one"});
    CHECK(store.study("table-3").series.size() == 2);
  }
}

TEST_CASE("a solve is checked by each study that takes it, whatever the study is called that brings it", "[merge]") {
  const ScratchFolder folder;
  make_store(folder.path / "a", "one", {1});
  make_store(folder.path / "b", "two", {2});
  edit(folder.path / "b", "UPDATE studies SET name = 'lenient'; UPDATE series SET study = 'lenient'");
  edit(folder.path / "b", "UPDATE solves SET evaluations = 7");
  const MakeCheck check_of = [](const StoredStudy& study) {
    return [is_lenient = study.name == "lenient"](const SolveRecord& solve) {
      if (solve.evaluations == 7 && !is_lenient) throw std::invalid_argument("wrong");
    };
  };
  CHECK(complaint<std::invalid_argument>([&] {
          results::merge(folder.path / "out", {folder.path / "a", folder.path / "b"}, check_of);
        }) == quoted(folder.path / "b") + ": wrong");
  const Store store(folder.path / "out", Store::Mode::read);
  CHECK(series_of(store, "key-a").size() == 1);
  CHECK(store.studies().size() == 1);
}

TEST_CASE("times and studies may differ, and what a NaN was be the same", "[merge]") {
  const ScratchFolder folder;
  for (const char* name : {"a", "b"}) {
    Store store(folder.path / name, Store::Mode::write);
    store.save_study(sample_study());
    store.begin_session({{"machine", name}});
    SolveRecord record = sample_record();
    record.position_error_cm = std::numeric_limits<double>::quiet_NaN();
    record.seconds = name[0] == 'a' ? 1 : 2;
    store.append({record});
  }
  edit(folder.path / "b", "UPDATE solves SET study = 'another'");  // that solved it first
  CHECK(merge(folder.path / "out", {folder.path / "a", folder.path / "b"}).duplicates == 1);
  CHECK(series_of(Store(folder.path / "out", Store::Mode::read), "key-a").front().seconds == 1);
}

TEST_CASE("another study of the same name is refused with the field that differs", "[merge]") {
  const ScratchFolder folder;
  make_store(folder.path / "a", "one", {1});
  StoredStudy other = sample_study();
  other.definition = parse_definition(R"({"robot":"iiwa7","runs":20,"points":20})");
  Store(folder.path / "b", Store::Mode::write).save_study(other);
  other = sample_study();
  other.series.front().key += "@another";
  Store(folder.path / "c", Store::Mode::write).save_study(other);
  other.series.front().key = "key-of-another-option";
  Store(folder.path / "d", Store::Mode::write).save_study(other);
  const auto said = [&](const char* name) {
    return complaint<std::invalid_argument>([&] { merge(folder.path / "a", {folder.path / name}); });
  };
  CHECK_THAT(said("b"), ContainsSubstring("robot is \"iiwa14\" and \"iiwa7\""));
  CHECK_THAT(said("c"), ContainsSubstring("use one version of ikbench"));
  CHECK_THAT(said("d"), ContainsSubstring("its solvers or their options differ"));
  other = sample_study();
  other.series.front().label += " again";
  Store(folder.path / "e", Store::Mode::write).save_study(other);
  CHECK_THAT(said("e"), ContainsSubstring("the labels of its solvers differ"));
}

TEST_CASE("the difference of two definitions names the field, and values that fit", "[merge]") {
  const std::string alike(60, 'x');
  const auto with = [](const std::string& note) { return R"({"runs":20,"urdf":")" + note + "\"}"; };
  CHECK(difference_in_solves(with("a"), with("b")) == R"(urdf is "a" and "b")");
  CHECK(difference_in_solves(with("a"), R"({"runs":30})") == R"(urdf is "a" and missing)");
  CHECK(difference_in_solves(with(alike + "a"), with(alike + "b")) == "urdf differs");
  CHECK(difference_in_solves(with("a"), with(alike + "b")) == R"(urdf is "a" and another)");
  CHECK(difference_in_solves(with(alike), with(alike)).empty());
  CHECK(difference_in_solves(R"({"stop":{"seconds":1}})", R"({"stop":{"seconds":2}})") == "stop.seconds is 1 and 2");
  CHECK(difference_in_solves(R"({"runs":3,"departures":["runs"]})", R"({"runs":20,"departures":[]})").empty());
  const auto with_tip = [](const char* named, const char* taken) {
    return fmt::format(R"({{"urdf":{{"tip":"{}"}},"arm":{{"tip_link":"{}"}}}})", named, taken);
  };
  CHECK(difference_in_solves(with_tip("", "tool0"), with_tip("tool0", "tool0")).empty());
  CHECK(difference_in_solves(with_tip("", "tool0"), with_tip("flange", "flange")) ==
        R"(arm.tip_link is "tool0" and "flange")");
  for (const char* key : {"figures", "name", "published", "rounds", "title", "unreachable_targets"})
    CHECK(difference_in_solves(fmt::format(R"({{"{}":1}})", key), R"({})").empty());
}

TEST_CASE("of two numbers of runs the larger is taken, and how a study is judged may differ", "[merge]") {
  const ScratchFolder folder;
  make_store(folder.path / "a", "one", {1});
  make_store(folder.path / "b", "two", {30});
  StoredStudy larger = sample_study();
  larger.definition = parse_definition(R"({"robot":"iiwa14","runs":30,"points":20,"analysis":{"significance":0.01}})");
  Store(folder.path / "b", Store::Mode::write).save_study(larger);
  for (const auto& order : {std::vector{"a", "b"}, std::vector{"b", "a"}}) {
    const fs::path out = folder.path / "out" / order.front();
    merge(out, {folder.path / order[0], folder.path / order[1]});
    const Store store(out, Store::Mode::read);
    CHECK(store.study("table-3").definition.json == larger.definition.json);
    CHECK(series_of(store, "key-a").size() == 2);
  }
}

TEST_CASE("shards with other files of answers are refused by the solver's label", "[merge]") {
  const ScratchFolder folder;
  for (const char* const file : {"a", "b"}) {
    StoredStudy study = sample_study();
    study.series = {{fmt::format("1@{}", file), "MoveIt", "elsewhere", R"({"answers":"moveit.csv"})"}};
    Store(folder.path / file, Store::Mode::write).save_study(study);
  }
  CHECK_THROWS_WITH(merge(folder.path / "out", {folder.path / "a", folder.path / "b"}),
                    ContainsSubstring("'MoveIt' was solved with another file of answers"));
}

TEST_CASE("two studies of one name with other requirements are refused", "[merge]") {
  const ScratchFolder folder;
  for (const char* const share : {"95", "90"}) {
    StoredStudy study = sample_study();
    study.definition = parse_definition(fmt::format(
        R"({{"robot": "iiwa14", "runs": 20, "points": 20, "stop": {{"tolerance_cm": 1}}, "require": {{"solved": "{}%"}}}})",
        share));
    Store(folder.path / share, Store::Mode::write).save_study(study);
  }
  CHECK_THROWS_WITH(merge(folder.path / "out", {folder.path / "95", folder.path / "90"}),
                    ContainsSubstring("its [require] is solved=95% and solved=90%"));
}

TEST_CASE("a store that a kill left half-written is mended, and merged", "[merge]") {
  const ScratchFolder folder;
  make_store(folder.path / "a", "one", {1, 3});
  std::vector<int> runs(40);
  std::iota(runs.begin(), runs.end(), 101);
  make_store(folder.path / "b", "killed", runs);
  leave_half_written(folder.path / "b");
  write_text(folder.path / "c", "");
  const MergeResult merged = merge(folder.path / "out", {folder.path / "a", folder.path / "b", folder.path / "c"});
  CHECK(merged.added == 42);
  CHECK(merged.stores == 2);
  CHECK(merge(folder.path / "out", {folder.path / "a", folder.path / "out"}).stores == 1);
  const auto merge_nothing = [&] { merge(folder.path / "new", {folder.path / "c"}); };
  CHECK_THAT(complaint<std::invalid_argument>(merge_nothing), ContainsSubstring("it is empty"));
}

TEST_CASE("of two merges into a new store both have their solves in it, and a refused one removes nothing", "[merge]") {
  for (int attempt = 0; attempt < 5; ++attempt) {
    const ScratchFolder folder;
    const fs::path out = folder.path / "out" / "store";
    make_store(folder.path / "a", "one", {1, 3});
    make_store(folder.path / "b", "two", {2, 4});
    write_text(folder.path / "bad", "no store");
    std::vector<pid_t> merges;
    for (const char* name : {"a", "b", "bad"})
      merges.push_back(in_a_process([&] { return merge(out, {folder.path / name}).added == 2; }));
    CHECK(exit_code(merges[0]) == 0);
    CHECK(exit_code(merges[1]) == 0);
    CHECK(exit_code(merges[2]) == 2);
    CHECK(series_of(Store(out, Store::Mode::read), "key-a").size() == 4);
    CHECK(std::distance(fs::directory_iterator(out.parent_path()), fs::directory_iterator()) == 1);
  }
}

TEST_CASE("two sessions of one store stay two, and one without solves is left out", "[merge]") {
  const ScratchFolder folder;
  make_store(folder.path / "a", "one", {1});
  {
    Store store(folder.path / "a", Store::Mode::write);
    store.begin_session({{"machine", "none"}});
    SolveRecord record = sample_record("key-a", 2);
    record.session = store.begin_session({{"machine", "two"}});
    store.append({record});
  }
  merge(folder.path / "out", {folder.path / "a"});
  CHECK(machines(Store(folder.path / "out", Store::Mode::read)) == std::vector<std::string>{"one", "two"});
}

TEST_CASE("a store in a shared folder has no log", "[store]") {
  const ScratchFolder folder;
  const fs::path file = folder.path / "a";
  make_store(file, "one", {1});
  int ready[2], done[2];
  REQUIRE(pipe(ready) == 0);
  REQUIRE(pipe(done) == 0);
  const pid_t writer = in_a_process([&] {
    Store store(file, Store::Mode::write_shared);
    store.append({sample_record("key-a", 2)});
    char byte = 'x';
    return write(ready[1], &byte, 1) == 1 && read(done[0], &byte, 1) == 1;
  });
  char byte = 0;
  REQUIRE(read(ready[0], &byte, 1) == 1);
  CHECK_FALSE(fs::exists(file.string() + "-wal"));
  CHECK_FALSE(fs::exists(file.string() + "-shm"));
  CHECK(series_of(Store(file, Store::Mode::read), "key-a").size() == 2);
  REQUIRE(write(done[1], &byte, 1) == 1);
  CHECK(exit_code(writer) == 0);
  CHECK(std::distance(fs::directory_iterator(folder.path), fs::directory_iterator()) == 1);
}

TEST_CASE("a text with a NUL character in it is not cut off there and taken for another", "[merge]") {
  const ScratchFolder folder;
  make_store(folder.path / "a", "one", {1});
  make_store(folder.path / "b", "two", {1});
  edit(folder.path / "b",
       "UPDATE studies SET name = 'other'; UPDATE series SET study = 'other', key = key || char(0) || 'x'; "
       "UPDATE solves SET series = series || char(0) || 'x'");
  CHECK(merge(folder.path / "out", {folder.path / "a", folder.path / "b"}).added == 2);
}

TEST_CASE("more stores than SQLite attaches at once, into a store that is there", "[merge]") {
  const ScratchFolder folder;
  std::vector<fs::path> stores;
  for (int run = 1; run <= 30; ++run) {
    stores.push_back(folder.path / fmt::format("100% of #{}?mode=rw&x", run));  // in a URI, too, only a name
    make_store(stores.back(), std::to_string(run), {run});
  }
  make_store(folder.path / "out", "first", {31});
  CHECK(merge(folder.path / "out", stores).added == 30);
  CHECK(merge(folder.path / "out", stores).duplicates == 30);
  CHECK(Store(folder.path / "out", Store::Mode::read).sessions().size() == 31);
}
