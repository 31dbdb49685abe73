// The fingerprint: every result counts, and nothing else.
#include "tests/results/samples.hpp"

namespace {

std::vector<SolveRecord> sample_records() {
  return {sample_record("key-a", 1, 1), sample_record("key-a", 1, 2), sample_record("key-a", 2, 1),
          sample_record("key-b", 1, 1)};
}

// The nearest other value of the same type.
void change(std::string& text) { text += '\0'; }
void change(int& number) { ++number; }
void change(std::int64_t& number) { ++number; }
void change(double& number) { number = std::nextafter(number, 1e9); }
void change(std::vector<double>& numbers) {
  if (numbers.empty()) numbers.push_back(0);
  change(numbers.back());
}
template <class Enum>
requires std::is_enum_v<Enum>
void change(Enum& value) { value = value == Enum{} ? Enum{1} : Enum{}; }

}  // namespace

TEST_CASE("a fingerprint is 32 hexadecimal digits, the same on every machine", "[fingerprint]") {
  CHECK(fingerprint({}) == "00000000000000010000000000000002");
  CHECK(fingerprint(sample_records()) == "e997cb37c78400d5c9e9a2e431e77d79");
}

TEST_CASE("every column that a fingerprint covers counts to its last bit, and no other counts", "[fingerprint]") {
  const std::string before = fingerprint(sample_records());
  std::set<std::string> seen{before};
  std::set<std::string_view> covered;
  for_each_column_of_fingerprint([&](std::string_view name, auto) { covered.insert(name); });
  CHECK(covered.size() == 22);
  for_each_column([&](std::string_view name, auto member, std::string_view) {
    CAPTURE(name);
    std::vector<SolveRecord> records = sample_records();
    change(records[2].*member);
    if (covered.contains(name)) {
      CHECK(seen.insert(fingerprint(records)).second);
    } else {
      CHECK(fingerprint(records) == before);
    }
  });
}

TEST_CASE("which source gave the numbers does not count, which configuration does", "[fingerprint]") {
  const auto of_series = [](const char* key) { return fingerprint({sample_record(key, 1, 1)}); };
  CHECK(of_series("key-a@1") == of_series("key-a"));
  CHECK(of_series("key-a@1") == of_series("key-a@2"));
  CHECK(of_series("key-a@1") != of_series("key-b@1"));
}

TEST_CASE("the order of records does not count, which ones there are does", "[fingerprint]") {
  std::vector<SolveRecord> records = sample_records();
  const std::string before = fingerprint(records);
  std::reverse(records.begin(), records.end());
  CHECK(fingerprint(records) == before);
  std::swap(records[1].answer_rad, records[2].reached_position_m);
  CHECK(fingerprint(records) != before);
  records = sample_records();
  records.pop_back();
  CHECK(fingerprint(records) != before);
  records.push_back(records.front());
  CHECK(fingerprint(records) != before);
}

TEST_CASE("what is in one text or list counts as no other's", "[fingerprint]") {
  SolveRecord record = sample_record();
  record.study = std::string("ab");
  record.robot = std::string("c");
  const std::string before = fingerprint({record});
  record.study = std::string("a");
  record.robot = std::string("bc");
  CHECK(fingerprint({record}) != before);
  record = sample_record();
  record.start_rad = {1, 2};
  record.answer_rad = {3};
  const std::string lists = fingerprint({record});
  record.start_rad = {1};
  record.answer_rad = {2, 3};
  CHECK(fingerprint({record}) != lists);
}

TEST_CASE("every NaN is the same, and the sign of zero counts in a list and not in a number of its own",
          "[fingerprint]") {
  const auto with = [](double number, double listed) {
    SolveRecord record = sample_record();
    record.position_error_cm = number;
    record.answer_rad = {listed};
    return fingerprint({record});
  };
  CHECK(with(not_a_number, 1) == with(-not_a_number, 1));
  CHECK(with(1, not_a_number) == with(1, -not_a_number));
  CHECK(with(1, not_a_number) == with(1, std::bit_cast<double>(0x7FF8000000000123)));
  CHECK(with(not_a_number, 1) != with(std::numeric_limits<double>::infinity(), 1));
  CHECK(with(-0.0, 1) == with(0.0, 1));
  CHECK(with(1, -0.0) != with(1, 0.0));
}

TEST_CASE("a store keeps the fingerprint, of numbers that are not finite too", "[fingerprint]") {
  ScratchStore store;
  store.save_study(sample_study());
  std::vector<SolveRecord> records = sample_records();
  records[1].position_error_cm = -std::numeric_limits<double>::quiet_NaN();
  records[1].answer_rad = {-0.0, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::quiet_NaN()};
  records[2].variation_deg = -0.0;
  records[3].reported_error_cm = std::numeric_limits<double>::infinity();
  store.append({records[3], records[1]});
  store.append({records[0], records[2]});
  CHECK(fingerprint(solves_of(store, "table-3")) == fingerprint(records));
  CHECK(fingerprint(store, sample_study()).text == fingerprint(records));  // solve by solve
}

namespace {

// Writes a store with a row in every table; its sessions have a fact `seal`.
void write_full_store(const std::filesystem::path& file) {
  Store store(file, Store::Mode::write_shared);
  store.save_study(sample_study());
  store.begin_session({{"cpu", "one"}, {std::string(seal_fact), "0"}});
  std::vector<SolveRecord> records = sample_records();
  records[0].extras = {{"stalls", 3}};
  store.append(records);
}

std::string seal_after(const std::string& sql) {
  const ScratchFolder folder;
  const std::filesystem::path file = folder.path / "store.sqlite";
  write_full_store(file);
  // The moment of writing is another in each store.
  edit(file, "UPDATE studies SET saved = ''; UPDATE sessions SET began = ''; " + sql);
  return seal_of(Store(file, Store::Mode::read));
}

}  // namespace

TEST_CASE("every column of every table counts in a seal", "[fingerprint]") {
  const ScratchFolder folder;
  write_full_store(folder.path / "store.sqlite");
  SQLite::Database store((folder.path / "store.sqlite").string());
  SQLite::Statement columns(store,
                            "SELECT tables.name, columns.name, columns.type FROM sqlite_master AS tables, "
                            "pragma_table_info(tables.name) AS columns WHERE tables.type = 'table'");
  std::set<std::string> seals{seal_after("")};
  while (columns.executeStep()) {
    const std::string table = columns.getColumn(0), column = columns.getColumn(1), type = columns.getColumn(2);
    CAPTURE(table, column);
    const std::string value = type == "TEXT" ? column + " || 'x'" : fmt::format("coalesce({}, 0) + 9", column);
    const std::string first = table == "extras" ? "true" : fmt::format("rowid IN (SELECT min(rowid) FROM {})", table);
    CHECK(seals.insert(seal_after(fmt::format("UPDATE {} SET {} = {} WHERE {}", table, column, value, first))).second);
  }
  CHECK(seals.size() > 50);
  for (const char* sql : {"DELETE FROM extras", "DELETE FROM solves WHERE run = 2", "DELETE FROM environment",
                          "INSERT INTO sessions VALUES (9, '')"})
    CHECK(seals.insert(seal_after(sql)).second);
}

TEST_CASE("a seal depends on the rows alone, and not on the fact that keeps it", "[fingerprint]") {
  const std::string seal = seal_after("");
  CHECK(seal.size() == 64);
  CHECK(seal_after("UPDATE environment SET value = 'another' WHERE key = 'seal'") == seal);
  CHECK(seal_after("CREATE TABLE copy AS SELECT * FROM solves; DELETE FROM solves; "
                   "INSERT INTO solves SELECT * FROM copy ORDER BY rowid DESC; DROP TABLE copy; VACUUM") == seal);
}

TEST_CASE("the studies of the papers have a reference, others none", "[fingerprint]") {
  for (const char* study : {"slim2023", "slim2023-context", "beeson2015", "haviland2023"}) {
    const std::string_view reference = reference_fingerprint(study);
    CHECK(reference.size() == 32);
    CHECK(reference.find_first_not_of("0123456789abcdef") == std::string_view::npos);
  }
  CHECK(reference_fingerprint("mine").empty());
}
