// From planned solves to observations: each solve is counted once.
#include <algorithm>

#include "analysis/inference/make_study.hpp"
#include "analysis/report/study_tables.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::inference;
using namespace ikbench::report;

TEST_CASE("the flow counts each planned solve once, and the observations of complete runs", "[flow]") {
  std::vector<SolveRecord> solves;
  const std::vector<Status> seen{Status::ok,      Status::declined,          Status::crashed,        Status::timed_out,
                                 Status::refused, Status::claimed_but_wrong, Status::limit_violated, Status::ok};
  for (int run = 1; run <= 4; ++run) {
    for (int point = 1; point <= 2; ++point) {
      SolveRecord solve{.solver = "mine", .run = run, .point = point};
      solve.status = seen[static_cast<std::size_t>(2 * (run - 1) + point - 1)];
      solve.position_error_cm = run + 0.1 * point;
      solves.push_back(solve);
      solve.solver = "other";
      solve.status = Status::ok;
      if (run < 4 || point < 2) solves.push_back(solve);  // the last is missing
    }
  }
  const Table table = status_table(make_study("study", std::move(solves)));
  const auto cell = [&](std::size_t row, const std::string& column) {
    const auto found = std::ranges::find(table.columns, column);
    REQUIRE(found != table.columns.end());
    return std::get<std::int64_t>(table.rows.at(row)[static_cast<std::size_t>(found - table.columns.begin())]);
  };
  for (const char* one : {"declined", "crashed", "timed_out", "refused", "claimed_but_wrong", "limit_violated"}) {
    CAPTURE(one);
    CHECK(cell(0, one) == 1);
    CHECK(cell(1, one) == 0);
  }
  CHECK(cell(0, "not_finite") == 0);
  CHECK(cell(0, "ok") == 2);
  CHECK(cell(0, "not_solved") == 0);
  CHECK(cell(0, "observations") == 4);
  CHECK(cell(1, "planned") == 8);
  CHECK(cell(1, "not_solved") == 1);
  CHECK(cell(1, "ok") == 7);
  CHECK(cell(1, "observations") == 3);
}
