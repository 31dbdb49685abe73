// A study for OMPL's tools. Whether OMPL's own script makes the same database of the log: tests/cli/ompl.sh.
#include "results/ompl.hpp"

#include <SQLiteCpp/SQLiteCpp.h>

#include <limits>

#include "tests/results/samples.hpp"

using namespace ikbench;
using namespace ikbench::results;

namespace {

ExportedStudy small_export() {
  SolveRecord other = sample_record("key-b");
  other.status = Status::ok;
  other.position_error_cm = std::numeric_limits<double>::infinity();
  other.counted_by = CountedBy::nobody;
  other.trace_cm.clear();
  const StudyEntry study{
      .name = "two words",
      .definition = R"({"robot":"iiwa14","seed":7,"points":1,"stop":{"seconds":0.005}})",
      .series = {Series{"key-a", "IK-BA", "ik_bat", R"({"alpha":"0.97"})"}, Series{"key-b", "BA", "bat", "{}"}}};
  const Session session{.id = 1,
                        .environment = {{"date", "2026-11-21T10:00:00Z"}, {"version", "0.1.0"}, {"cpu", "one\ntwo"}}};
  return {.study = study, .sessions = {session}, .solves = {sample_record(), other}};
}

std::string answer(SQLite::Database& sqlite, const char* query) {
  SQLite::Statement statement(sqlite, query);
  std::string text;
  while (statement.executeStep()) {
    for (int i = 0; i < statement.getColumnCount(); ++i) {
      text += (i == 0 ? "" : "|") + (statement.isColumnNull(i) ? "NULL" : statement.getColumn(i).getString());
    }
    text += ";";
  }
  return text;
}

}  // namespace

TEST_CASE("the log for OMPL names what its script asks for, one line each", "[ompl]") {
  const std::string log = to_ompl_log(small_export());
  for (const std::string part :
       {"ikbench version 0.1.0\nExperiment two_words\n2 experiment properties\npoints INTEGER = 1\n",
        "robot TEXT = iiwa14\nRunning on unknown\nStarting at 2026-11-21 10:00:00\n",
        "\n|>>>\n<<<|\none_two\n|>>>\n7 is the random seed\n0.005 seconds per run\n",
        "\n2 planners\nIK-BA\n2 common properties\nsolver TEXT = ik_bat\nalpha TEXT = 0.97\n",
        "\n1; 1; 0.2439; 0.2438; 0; 2; 1; 0.0019; ",
        "\n2 progress properties for each run\ntime REAL\nbest_error_cm REAL\n"}) {
    INFO(log);
    INFO(part);
    CHECK(log.find(part) != std::string::npos);
  }
  CHECK(log.find("nan") == std::string::npos);
}

TEST_CASE("the database for OMPL has what Planner Arena counts on", "[ompl]") {
  const ScratchFolder folder;
  const std::filesystem::path file = folder.path / "benchmark.db";
  write_text(file, "old");
  write_ompl_database(file, small_export());
  SQLite::Database sqlite(file.string());
  CHECK(answer(sqlite, "SELECT name, timelimit, runcount, version, seed FROM experiments") ==
        "two_words|0.005|1|ikbench 0.1.0|7;");
  CHECK(answer(sqlite, "SELECT name FROM pragma_table_info('experiments') WHERE cid >= 12") == "points;robot;");
  CHECK(answer(sqlite, "SELECT name, type FROM pragma_table_info('runs') WHERE cid < 8") ==
        "id|INTEGER;experimentid|INTEGER;plannerid|INTEGER;run|INTEGER;point|INTEGER;time|REAL;cpu_time|REAL;"
        "solved|BOOLEAN;");
  CHECK(answer(sqlite, "SELECT solved, position_error_cm, evaluations, typeof(time) FROM runs") ==
        "0|0.0019|10000|real;1|NULL|NULL|real;");
  CHECK(answer(sqlite, "SELECT description FROM enums JOIN runs ON value = status WHERE name = 'status'") ==
        "limit_violated;ok;");
  CHECK(answer(sqlite, "SELECT runid, best_error_cm FROM progress ORDER BY time") == "1|12.5;1|0.25;1|0.0019;");
  CHECK(answer(sqlite, "SELECT plannerid, avg_solved FROM bestPlannerConfigs") == "2|1.0;1|0.0;");
}
