// Table 7: times to the tolerance at random targets.
#include <cmath>

#include "analysis/inference/make_study.hpp"
#include "analysis/slim2023/paper_tables.hpp"
#include "tests/analysis/cells.hpp"
#include "tests/analysis/synthetic.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::inference;
using namespace ikbench::report;
using namespace ikbench::slim2023;

namespace {

const char* const definition = R"({"published": "slim2023", "runs": 1, "points": 4, "path": {"kind": "random"},
                                   "start": "initial", "stop": {"iterations": 1000, "tolerance_cm": 0.1}})";

struct Timed {
  std::string solver;
  double ms;
  double error_cm = 0.09;
  int iterations = 100;
};

StudyResults timed_study(const std::vector<Timed>& timed, const char* as_defined = definition) {
  std::vector<SolveRecord> solves;
  for (const Timed& one : timed) {
    SolveRecord solve;
    solve.solver = one.solver;
    solve.seconds = solve.cpu_seconds = one.ms / 1000;
    solve.position_error_cm = one.error_cm;
    solve.iterations = one.iterations;
    solve.evaluations = std::llround(1000 * one.ms);  // every solver has the same speed
    for (const SolveRecord& before : solves) {
      if (before.solver == one.solver) solve.point = before.point + 1;
    }
    solve.target_position_m = {0.01 * solve.point, 0, 0};
    solves.push_back(solve);
  }
  return make_study(StudyEntry{.name = "t", .definition = as_defined, .series = {}}, solves);
}

// Times by hand: 12 bats 2, 4, 6, 8 ms; 15 bats 3, 5, 5, 87 ms.
const std::vector<Timed> by_hand{{"12 bats", 2}, {"12 bats", 4}, {"12 bats", 6}, {"12 bats", 8, 0.09, 140},
                                 {"15 bats", 3}, {"15 bats", 5}, {"15 bats", 5}, {"15 bats", 87, 7.5, 1000}};

}  // namespace

TEST_CASE("Table 7 has the times in milliseconds beside the printed ones", "[time]") {
  const Table table = *table_7(timed_study(by_hand));
  CHECK(table.name == "table-7");
  REQUIRE(table.rows.size() == 2);
  CHECK(number_at(table, 0, "mean_ms") == Approx(5));
  CHECK(number_at(table, 0, "median_ms") == Approx(5));
  CHECK(number_at(table, 0, "std_ms") == Approx(std::sqrt(20.0 / 3)));  // squares 9 + 1 + 1 + 9
  CHECK(number_at(table, 0, "max_ms") == Approx(8));
  CHECK(number_at(table, 0, "min_ms") == Approx(2));
  CHECK(number_at(table, 0, "iterations_median") == Approx(100));
  CHECK(number_at(table, 0, "evaluations_median") == Approx(5000));
  CHECK(number_at(table, 0, "share_in_time") == Approx(1));
  CHECK(number_at(table, 0, "never_reached") == 0);
  CHECK(number_at(table, 1, "mean_ms") == Approx(25));
  CHECK(number_at(table, 1, "share_in_time") == Approx(0.75));
  CHECK(number_at(table, 1, "never_reached") == 1);
  CHECK(readable(cell_at(table, 1, "mean_ms")) == "25 (printed 61.09)");  // the printed Table 7
  CHECK(readable(cell_at(table, 1, "min_ms")) == "3 (printed 41.81)");
  CHECK(to_csv(table).find("mean_ms,mean_ms printed,median_ms,median_ms printed") != std::string::npos);
}

TEST_CASE("solves that never reach the tolerance are counted, and their times stay in", "[time]") {
  const Table not_finite = *table_7(timed_study({{"12 bats", 1, NAN}}));
  CHECK(number_at(not_finite, 0, "never_reached") == 1);
  CHECK(number_at(not_finite, 0, "mean_ms") == 1);
  // As the verifier: what rounding makes of the tolerance is within it.
  CHECK(number_at(*table_7(timed_study({{"12 bats", 1, 0.1 + 1e-8}})), 0, "never_reached") == 0);
  // Quick, but the tolerance is never reached: not in time.
  CHECK(number_at(*table_7(timed_study({{"12 bats", 2}, {"12 bats", 3, 7.5}})), 0, "share_in_time") == Approx(0.5));
}

TEST_CASE("times that are not clean are told beside Table 7", "[time]") {
  StudyResults study = timed_study(by_hand);
  for (Solve& solve : study.solves.to_change()) solve.timing = Timing::debug_build;
  CHECK(has_note(*table_7(study), "Times are not comparable"));
}

TEST_CASE("Table 7 stands without the printed reference, a tolerance, or anything solved", "[time]") {
  const Table others = *table_7(timed_study({{"40 bats", 1}, {"<b>`|", 2}}));
  CHECK(readable(cell_at(others, 0, "mean_ms")) == "1");
  CHECK(to_markdown(others).find("<b>") == std::string::npos);
  const char* const no_tolerance = R"({"published": "slim2023", "path": {"kind": "random"}})";
  CHECK(is_empty(*table_7(timed_study({{"12 bats", 1}}, no_tolerance)), 0, "never_reached"));
  CHECK(table_7(timed_study({}))->rows.empty());
}

TEST_CASE("only random targets that claim to be the paper's have a Table 7", "[time]") {
  CHECK(!table_7(timed_study(by_hand, R"({"published": "slim2023", "path": {"kind": "helix"}})")));
  CHECK(!table_7(timed_study(by_hand, R"({"path": {"kind": "random"}})")));
  CHECK(!table_7(timed_study(by_hand, R"({"published": "nothing", "path": {"kind": "random"}})")));
  CHECK(!table_7(timed_study(by_hand, "no JSON")));
}

TEST_CASE("a study of random targets is not held against Table 3", "[time]") {
  const StudyResults study = timed_study({{"IK-BA", 1}});
  CHECK(std::holds_alternative<double>(table_3(study).rows[0][2]));
  std::vector<std::string> names;
  for (const Table& table : paper_tables(study)) names.push_back(table.name);
  CHECK(names == std::vector<std::string>{"table-3", "table-4", "table-5", "table-6", "table-7"});
}
