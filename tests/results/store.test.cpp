// A store returns what it was given: every value, in the promised order.
#include "tests/results/samples.hpp"

namespace {

// Writes with one Store, reads with another.
SolveRecord through_a_store(const SolveRecord& record) {
  const ScratchFolder folder;
  Store(folder.path / "a.ikb", Store::Mode::write).append({record});
  const auto records = series_of(Store(folder.path / "a.ikb", Store::Mode::read), record.series);
  REQUIRE(records.size() == 1);
  return records.front();
}

std::vector<std::string> places(const std::vector<SolveRecord>& records) {
  std::vector<std::string> list;
  for (const auto& record : records)
    list.push_back(record.series + " " + std::to_string(record.run) + " " + std::to_string(record.point));
  return list;
}

}  // namespace

TEST_CASE("a solve comes back as it was, in every column", "[store]") {
  CHECK(same(through_a_store(sample_record()), sample_record()));
  CHECK(same(through_a_store(SolveRecord{}), SolveRecord{}));
}

TEST_CASE("every double comes back bit for bit, finite or not", "[store]") {
  using limits = std::numeric_limits<double>;
  std::vector<double> numbers = {0.0,
                                 0.1,
                                 1.0 / 3.0,
                                 -1e300,
                                 1e22,
                                 9007199254740993.0,
                                 limits::denorm_min(),
                                 -limits::min() / 3,
                                 limits::max(),
                                 limits::lowest(),
                                 limits::infinity(),
                                 -limits::infinity(),
                                 limits::quiet_NaN()};
  std::mt19937_64 random(754);  // any bits are a double (IEEE 754)
  for (int i = 0; i < 200; ++i) numbers.push_back(std::bit_cast<double>(random()));

  ScratchStore store;
  std::vector<SolveRecord> records;
  for (const double number : numbers) {
    records.push_back(sample_record("doubles", static_cast<int>(records.size()) + 1));
    records.back().position_error_cm = std::abs(number);
    records.back().trace_cm = {number, 1.5, number, -0.0};
  }
  store.append(records);
  const auto again = series_of(store, "doubles");
  REQUIRE(again.size() == records.size());
  for (std::size_t i = 0; i < records.size(); ++i) {
    CAPTURE(numbers[i]);
    CHECK(same(again[i], records[i]));
  }
  SolveRecord record = sample_record();
  record.position_error_cm = -0.0;
  CHECK(same(through_a_store(record).position_error_cm, 0.0));  // SQLite drops its sign
}

TEST_CASE("any text comes back as it was", "[store]") {
  for (const std::string& text :
       {std::string("'); DROP TABLE solves; --"), std::string("\"quoted\" 'single' `back` [x]"),
        std::string("a\nb\r\nc\t"), std::string("<script>alert(1)</script>"), std::string("θ₁ 蝙蝠 🦇"),
        std::string("nul\0inside", 10), std::string(), std::string("caf\xE9 is not UTF-8"),
        std::string("?1 :name %s {}"), std::string(1'000'000, 'x')}) {
    CAPTURE(text.substr(0, 40));
    SolveRecord record = sample_record();
    record.study = record.robot = record.label = record.series = text;
    CHECK(same(through_a_store(record), record));

    ScratchStore store;
    StoredStudy study = sample_study(text);
    study.series[0].key = study.series[0].algorithm = text;
    study.series[0].label = record.label = text.substr(0, 1000);
    store.save_study(study);
    CHECK(store.study(text).series[0].label == record.label);
    store.append({record});
    CHECK(solves_of(store, text).size() == 1);
    const auto id = store.begin_session({{text, text}});
    CHECK(store.sessions().front().id == id);
    CHECK(store.sessions().front().environment == std::map<std::string, std::string>{{text, text}});
  }
}

TEST_CASE("studies come back with their series, in the order in which they were first saved", "[store]") {
  ScratchStore store;
  store.save_study(sample_study("zebra"));
  store.save_study(sample_study("aardvark"));
  StoredStudy changed = sample_study("zebra");
  changed.definition = parse_definition(R"({"runs":3,"points":1})");
  std::swap(changed.series[0], changed.series[1]);
  store.save_study(changed);

  const auto studies = store.studies();
  REQUIRE(studies.size() == 2);
  CHECK(studies[0].name == "zebra");
  CHECK(studies[0].definition.json == changed.definition.json);
  REQUIRE(studies[0].series.size() == 2);
  CHECK(studies[0].series[0].key == "key-b");
  CHECK(studies[0].series[0].label == "BA");
  CHECK(studies[0].series[0].algorithm == "ba");
  CHECK(studies[0].series[1].options == R"({"gamma":0.1})");
  CHECK(studies[1].name == "aardvark");
}

TEST_CASE("a sweep is saved in place of the sweep of that name, in its order", "[store]") {
  const ScratchFolder folder;
  Store store(folder.path / "a.ikb", Store::Mode::write);
  const auto swept = [](const std::string& value) {
    results::StoredStudy study = sample_study("my near_deg=" + value);
    study.definition = results::parse_definition(fmt::format(
        R"({{"robot":"iiwa14","sweep":{{"name":"my-by-near_deg","values":[{{"key":"near_deg","value":"{}"}}]}}}})",
        value));
    return study;
  };
  CHECK(store.sweep("").empty());
  store.save_sweep({swept("1"), swept("45")});
  store.append({sample_record()});
  store.save_study(sample_study("other"));
  store.save_sweep({swept("1"), swept("10"), swept("45")});
  const std::vector<results::StoredStudy> sweep = store.sweep("my-by-near_deg");
  REQUIRE(sweep.size() == 3);
  CHECK(sweep[1].definition.sweep.label() == "10");
  store.save_sweep({swept("10")});
  CHECK(store.sweep("my-by-near_deg").size() == 1);
  CHECK(store.studies().size() == 2);
  CHECK(series_of(store, "key-a").size() == 1);  // solves stay
  CHECK(store.study("other").name == "other");
  Store first(folder.path / "b.ikb", Store::Mode::write);
  first.save_sweep({swept("1"), swept("10")});
  CHECK(first.sweep("").size() == 2);
  CHECK(contains(complaint<std::invalid_argument>([&] { first.study(""); }), "--study 'my near_deg=1'"));
  CHECK(first.study("my near_deg=10").definition.sweep.label() == "10");
}

TEST_CASE("a study that is not there is told which are", "[store]") {
  const ScratchFolder folder;
  const auto file = folder.path / "a.ikb";
  Store store(file, Store::Mode::write);
  CHECK_THAT(complaint<std::invalid_argument>([&] { store.study(""); }), StartsWith(quoted(file) + " has no study"));
  store.save_study(sample_study("helix"));
  store.save_study(sample_study("circle"));
  CHECK(complaint<std::invalid_argument>([&] { solves_of(store, "x"); }) ==
        "there is no study 'x' in " + quoted(file) + "; expected one of: helix, circle");
  CHECK(store.study("").name == "helix");
}

TEST_CASE("a definition that cannot be is refused with its study, and other studies of its store are read", "[store]") {
  ScratchStore store;
  store.save_study(sample_study("helix"));
  StoredStudy changed = sample_study("circle");
  changed.definition.json = R"({"name":"circle","runs":"many"})";
  store.save_study(changed);
  CHECK_THAT(complaint<std::invalid_argument>([&] { store.study("circle"); }),
             ContainsSubstring("damaged (study circle: runs is \"many\"; expected"));
  for (const char* name : {"helix", ""}) CHECK(store.study(name).definition.runs == 20);
  CHECK_THROWS_WITH(store.study("x"), ContainsSubstring("expected one of: helix, circle"));
}

TEST_CASE("solves of a study are those of its current series, runs and points, in its order", "[store]") {
  ScratchStore store;
  StoredStudy study = sample_study();
  study.definition = parse_definition(R"({"runs":2,"points":2})");
  study.series = {{.key = "z", .label = "IK-BA", .algorithm = "ba", .options = "{}"},
                  {.key = "a", .label = "second", .algorithm = "ba", .options = "{}"}};
  store.save_study(study);
  const auto second = [](int run, int point) {
    SolveRecord record = sample_record("a", run, point);
    record.label = "second";
    return record;
  };
  store.append({second(1, 2), second(1, 1), sample_record("old", 1, 1)});
  store.append({sample_record("z", 10, 1), sample_record("z", 2, 1), sample_record("z", 1, 1), sample_record("z", 2, 2),
                sample_record("z", 1, 3)});
  CHECK(places(solves_of(store, "table-3")) == std::vector<std::string>{"z 1 1", "z 2 1", "z 2 2", "a 1 1", "a 1 2"});
  CHECK(places(series_of(store, "z")) == std::vector<std::string>{"z 1 1", "z 1 3", "z 2 1", "z 2 2", "z 10 1"});

  // Other options are another series; the solves of the former stay in the file.
  study.series = {{.key = "old", .label = "IK-BA", .algorithm = "ba", .options = R"({"gamma":0.5})"}};
  store.save_study(study);
  CHECK(places(solves_of(store, "table-3")) == std::vector<std::string>{"old 1 1"});
  CHECK(series_of(store, "z").size() == 5);

  study.name = "again";
  store.save_study(study);
  CHECK(solves_of(store, "again").front().study == "again");  // though the first one solved it
}

TEST_CASE("the views have the current solves under the present labels, and the means of their runs", "[store]") {
  const ScratchFolder folder;
  const auto file = folder.path / "a.ikb";
  {
    Store store(file, Store::Mode::write);
    StoredStudy study = sample_study();
    study.definition = parse_definition(R"({"runs":2,"points":2})");
    study.series = {{.key = "key-a", .label = "now", .algorithm = "ba", .options = "{}"}};
    store.save_study(study);
    std::vector<SolveRecord> solves{sample_record("key-a", 1, 1), sample_record("key-a", 1, 2),
                                    sample_record("key-a", 2, 1), sample_record("key-a", 3, 1),
                                    sample_record("key-a", 1, 3), sample_record("of an older program", 1, 1)};
    solves[0].status = Status::ok;
    solves[0].position_error_cm = 1;
    solves[1].position_error_cm = 2;
    solves[2].counted_by = CountedBy::none;
    store.append(solves);
    CHECK(store.solve_count(study) == 3);
  }
  SQLite::Database sqlite(file.string());
  CHECK(sqlite.execAndGet("SELECT group_concat(study || label || run || point, ' ') FROM current_solves").getString() ==
        "table-3now11 table-3now12 table-3now21");
  CHECK(sqlite
            .execAndGet("SELECT group_concat(study || label || run || solves || ' ' || solved || ' ' || "
                        "position_error_cm || ' ' || ifnull(evaluations, '-')) FROM run_means")
            .getString() == "table-3now12 0.5 1.5 10000.0,table-3now21 0.0 0.0019 -");
}

TEST_CASE("solves of a configuration by other sources are counted", "[store]") {
  ScratchStore store;
  store.append({sample_record("00@1", 1, 1), sample_record("00@1", 1, 2), sample_record("00@2", 1, 1),
                sample_record("001@1", 1, 1), sample_record("0@1", 1, 1)});
  CHECK(store.stale_solve_count("00@1") == 1);
  CHECK(store.stale_solve_count("00@3") == 3);
  CHECK(store.stale_solve_count("0@1") == 0);
  CHECK(store.stale_solve_count("1@1") == 0);
}

TEST_CASE("a solve that is already there is refused, and nothing of its batch is kept", "[store]") {
  ScratchStore store;
  store.append({sample_record("a", 1, 1)});
  CHECK_THAT(complaint<std::invalid_argument>([&] {
               store.append({sample_record("a", 1, 2), sample_record("a", 1, 1)});
             }),
             ContainsSubstring("another ikbench is running the same study into"));
  CHECK(series_of(store, "a").size() == 1);
  store.append({sample_record("a", 1, 2)});  // the store is usable as before
  store.append({});
  CHECK(series_of(store, "a").size() == 2);
}

TEST_CASE("a store makes its folders, and is one plain file when closed", "[store]") {
  const ScratchFolder folder;
  const auto file = folder.path / "new" / "folder with ? and %20" / "a.ikb";
  {
    Store store(file, Store::Mode::write);
    store.append({sample_record()});
  }
  const auto entries = std::filesystem::directory_iterator(file.parent_path());
  CHECK(std::distance(begin(entries), end(entries)) == 1);
  CHECK(text_in(file).substr(18, 2) == "\x01\x01");  // rollback journal, www.sqlite.org/fileformat.html section 1.3
  std::filesystem::copy_file(file, folder.path / "copy.ikb");
  CHECK(series_of(Store(folder.path / "copy.ikb", Store::Mode::read), "key-a").size() == 1);
}

TEST_CASE("the file names its program and the version of its schema", "[store]") {
  const ScratchFolder folder;
  { const Store store(folder.path / "a.ikb", Store::Mode::write); }
  SQLite::Database sqlite((folder.path / "a.ikb").string());
  CHECK(sqlite.execAndGet("PRAGMA application_id").getInt64() == 0x494B424E);  // "IKBN"
  CHECK(sqlite.execAndGet("PRAGMA user_version").getInt64() == 4);
  // The first 27: ikbench list columns.
  CHECK(
      sqlite
          .execAndGet("SELECT group_concat(name || ' ' || type) FROM (SELECT * FROM pragma_table_info('solves') "
                      "ORDER BY cid LIMIT 27)")
          .getString() ==
      "study TEXT,robot TEXT,label TEXT,series TEXT,run INTEGER,point INTEGER,target_position_m TEXT,"
      "target_rotation TEXT,start_rad TEXT,answer_rad TEXT,reached_position_m TEXT,position_error_cm "
      "REAL,reported_error_cm REAL,"
      "orientation_error REAL,variation_deg REAL,largest_move_deg REAL,limit_violation_deg REAL,evaluations INTEGER,"
      "iterations INTEGER,stop_reason TEXT,status TEXT,seconds REAL,wall_seconds REAL,cpu_seconds REAL,timing TEXT,session INTEGER,"
      "trace_cm TEXT");
}

TEST_CASE("what is known of a session at its end is added to it, and to no other", "[store]") {
  ScratchStore store;
  const std::int64_t first = store.begin_session({{"cpu", "x"}}), second = store.begin_session({{"cpu", "y"}});
  store.add_to_session(second, {{"stolen_seconds", "0.25"}});
  const std::vector<Session> sessions = store.sessions();
  REQUIRE(sessions.size() == 2);
  CHECK(sessions[0].id == first);
  CHECK(sessions[0].environment == std::map<std::string, std::string>{{"cpu", "x"}});
  CHECK(sessions[1].environment == std::map<std::string, std::string>{{"cpu", "y"}, {"stolen_seconds", "0.25"}});
}
