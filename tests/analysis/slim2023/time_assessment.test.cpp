#include "analysis/slim2023/time_assessment.hpp"

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

TEST_CASE("what the tolerance costs in time counts unsuccessful solves too", "[time]") {
  const Table table = *table_7_cost(timed_study(by_hand));
  CHECK(table.name == "table-7-cost");
  CHECK(number_at(table, 0, "ert_ms") == Approx(5));
  CHECK(number_at(table, 1, "ert_ms") == Approx(100.0 / 3));
  CHECK(number_at(table, 1, "ert_ratio") == Approx(100.0 / 15));
  CHECK(number_at(table, 0, "median_ratio") == Approx(1));
  CHECK(number_at(table, 1, "median_ratio") == Approx(1));  // 5 by 5 ms
  CHECK(number_at(table, 1, "A12") == Approx(9.0 / 16));    // of 16 pairs: 1 + 2 + 2 + 4
  CHECK(number_at(table, 0, "ratio_reached") == Approx(1));
  CHECK(number_at(table, 1, "mean_reached_ms") == Approx(13.0 / 3));
  CHECK(number_at(table, 1, "ratio_reached") == Approx(13.0 / 15));
  CHECK(number_at(table, 1, "paper_ratio") == Approx(61.09 / 48.01));
  CHECK(has_note(table, "There are no intervals: 4 targets, and intervals need 10."));
  CHECK(has_note(table, "ert_ms per bat: 12 bats 0.417, 15 bats 2.22."));  // 5 / 12, 100/3 / 15
}

TEST_CASE("a ratio of successful solves may have the other sign, and does not decide", "[time]") {
  // 12 bats: 23 targets in 10 ms. 30 bats: 18 of them in 2.8 ms, 5 given up after 39.96 ms: (50.4 + 199.8) / 18 = 13.9.
  std::vector<Timed> timed;
  for (int i = 0; i < 23; ++i) timed.push_back({"12 bats", i % 2 == 0 ? 9.5 : i == 1 ? 11 : 10.5});
  for (int i = 0; i < 23; ++i) timed.push_back(i < 18 ? Timed{"30 bats", 2.8} : Timed{"30 bats", 39.96, 5, 1000});
  const StudyResults study = timed_study(timed);
  const Table table = *table_7_cost(study);
  CHECK(number_at(table, 1, "ratio_reached") == Approx(0.28));
  CHECK(number_at(table, 1, "ert_ratio") == Approx(1.39));
  CHECK(has_note(table, "1.39 times (interval"));
  CHECK(has_note(table, "as the paper counts: 0.28 times"));
  CHECK(!has_note(table, "does not grow as printed: 0.28"));
  const auto* interval = std::get_if<Range>(&cell_at(table, 1, "ert_ratio interval"));
  REQUIRE(interval != nullptr);
  CHECK(interval->low > 0.28);
  CHECK(interval->low < 1.39);
  CHECK(interval->high > 1.39);
}

TEST_CASE("solves that never reach the tolerance are counted, and their times stay in", "[time]") {
  CHECK(has_note(*table_7(timed_study(by_hand)), "Here 1 never reach the tolerance: 12 bats 0 of 4, 15 bats 1 of 4."));
  CHECK(has_note(*table_7(timed_study({{"12 bats", 1}})), "Here every solve reaches the tolerance."));
  const Table not_finite = *table_7(timed_study({{"12 bats", 1, NAN}}));
  CHECK(number_at(not_finite, 0, "never_reached") == 1);
  CHECK(number_at(not_finite, 0, "mean_ms") == 1);
  CHECK(!std::isfinite(number_at(*table_7_cost(timed_study({{"12 bats", 1, NAN}})), 0, "mean_reached_ms")));
  // As the verifier: what rounding makes of the tolerance is within it.
  CHECK(number_at(*table_7(timed_study({{"12 bats", 1, 0.1 + 1e-8}})), 0, "never_reached") == 0);
}

TEST_CASE("the real-time verdict names who is not in time, and the worst", "[time]") {
  CHECK(real_time_verdict(timed_study(by_hand)) ==
        "Real time here, 0.1 cm reached in less than 50 ms: 7 of 8 solves (12 bats 4 of 4, 15 bats 3 of 4); the "
        "longest solve took 87 ms (15 bats). Printed times, in MATLAB on another machine: 12 bats: mean 48.01 ms, "
        "maximum 67.2 ms; on average yes, in the worst case no.");
  CHECK(real_time_verdict(timed_study({{"12 bats", 2}, {"30 bats", 3.25}}))
            .find("all 2 solves; the longest solve took 3.25 ms (30 bats).") != std::string::npos);
  // Quick, but the tolerance is never reached: not in time.
  const StudyResults quick = timed_study({{"12 bats", 2}, {"12 bats", 3, 7.5}});
  CHECK(real_time_verdict(quick).find("1 of 2 solves (12 bats 1 of 2)") != std::string::npos);
  CHECK(number_at(*table_7(quick), 0, "share_in_time") == Approx(0.5));
  CHECK(has_note(*table_7(timed_study(by_hand)), "Real time here"));
}

TEST_CASE("Table 7 tells of the printed mean beyond its maximum and of the printed time per bat", "[time]") {
  const Table table = *table_7(timed_study(by_hand));
  CHECK(has_note(table, "20 bats (83.75 by 80.06)"));
  CHECK(has_note(table, "printed: 12 bats 4, 15 bats 4.07, 20 bats 4.19, 30 bats 6.03."));  // 48.01 / 12 and so on
  CHECK(has_note(table, "its longest solves take at most 2.5 times the mean"));             // 448.44 / 180.94
}

TEST_CASE("Table 7 tells whether our time grows with the bats as the printed does", "[time]") {
  // Printed 180.94 / 48.01 = 3.77; its standard error 3.77 sqrt((10.1 / 48.01)^2 + (149.67 / 180.94)^2) / sqrt(20).
  // 20 targets each, whose times lie 1 ms about 10 ms and the second number.
  const auto cost_of = [](double ms) {
    std::vector<Timed> timed;
    for (int i = 0; i < 20; ++i) timed.push_back({"12 bats", i % 2 == 0 ? 9.0 : 11.0});
    for (int i = 0; i < 20; ++i) timed.push_back({"30 bats", i % 4 < 2 ? ms - 1 : ms + 1, 0.09, i < 10 ? 100 : 50});
    return *table_7_cost(timed_study(timed));
  };
  const Table flat = cost_of(10);
  CHECK(has_note(flat, "expected running time does not grow as printed: 1 times (interval 0.9"));
  CHECK(has_note(flat, "printed means: 3.77 times (standard error 0.72)"));
  CHECK(has_note(flat, "Median iterations of these solves: 100 -> 75. These are 20 and 20 solves"));
  CHECK(has_note(cost_of(38), "is compatible with the printed growth: 3.8 times"));
  CHECK(has_note(cost_of(20), "grows, but less than printed: 2 times"));
  CHECK(has_note(cost_of(200), "grows more than printed: 20 times"));
  CHECK(!has_note(*table_7_cost(timed_study(by_hand)), "Scaling:"));
  CHECK(has_note(*table_7_cost(timed_study({{"12 bats", 4}, {"12 bats", 6}, {"30 bats", 5}})),
                 "Scaling: open, with 2 targets, and intervals need 10."));
}

TEST_CASE("times that are not clean are told beside Table 7, and judge nothing", "[time]") {
  StudyResults study = timed_study(by_hand);
  for (Solve& solve : study.solves.to_change()) solve.timing = Timing::debug_build;
  const Table table = *table_7(study);
  CHECK(has_note(table, "Times are not comparable"));
  CHECK(has_note(table, "Real time: not judged, because times are not comparable."));
  CHECK(!has_note(table, "Real time here"));
  CHECK(!table_7_cost(study));
}

TEST_CASE("Table 7 stands without the printed reference, a tolerance, or anything solved", "[time]") {
  const Table others = *table_7(timed_study({{"40 bats", 1}, {"<b>`|", 2}}));
  const Table costs = *table_7_cost(timed_study({{"40 bats", 1}, {"<b>`|", 2}}));
  CHECK(!std::isfinite(number_at(costs, 0, "ratio_reached")));
  CHECK(!std::isfinite(number_at(costs, 0, "ert_ratio")));
  CHECK(is_empty(costs, 0, "paper_ratio"));
  CHECK(readable(cell_at(others, 0, "mean_ms")) == "1");
  CHECK(to_markdown(others).find("<b>") == std::string::npos);
  const char* const no_tolerance = R"({"published": "slim2023", "path": {"kind": "random"}})";
  CHECK(is_empty(*table_7(timed_study({{"12 bats", 1}}, no_tolerance)), 0, "never_reached"));
  CHECK(!table_7_cost(timed_study({{"12 bats", 1}}, no_tolerance)));
  CHECK(!table_7_cost(timed_study({})));
  CHECK(table_7(timed_study({}))->rows.empty());
  CHECK(real_time_verdict(timed_study({})) == "Real time: there are no solves yet.");
}

TEST_CASE("only random targets that claim to be the paper's have a Table 7", "[time]") {
  CHECK(!table_7(timed_study(by_hand, R"({"published": "slim2023", "path": {"kind": "helix"}})")));
  CHECK(!table_7(timed_study(by_hand, R"({"path": {"kind": "random"}})")));
  CHECK(!table_7(timed_study(by_hand, R"({"published": "nothing", "path": {"kind": "random"}})")));
  CHECK(!table_7(timed_study(by_hand, "no JSON")));
  CHECK(real_time_verdict(timed_study(by_hand, "{}")).empty());
}

TEST_CASE("a study of random targets is not held against Table 3", "[time]") {
  StudyResults study = timed_study({{"IK-BA", 1}});
  for (const Comparison& row : compare(study)) CHECK(!std::isfinite(row.paper_mean));
  std::vector<std::string> names;
  for (const Table& table : paper_tables(study)) names.push_back(table.name);
  CHECK(names ==
        std::vector<std::string>{"table-3", "table-4", "table-5", "table-6", "table-7", "table-7-cost", "status"});
}
