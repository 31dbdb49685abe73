// Metrics of whole runs and of turned answers, by hand; and the metrics that a report
// shows.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/inference/design.hpp"
#include "analysis/inference/make_study.hpp"
#include "analysis/inference/metrics.hpp"
#include "analysis/report/study_tables.hpp"
#include "tests/analysis/synthetic.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::statistics;
using namespace ikbench::inference;

namespace {

constexpr double degree = std::numbers::pi / 180;

// A run of one solver that goes through these angles [deg] of two joints, the first start being zeros.
std::vector<SolveRecord> run_through(const std::vector<std::vector<double>>& answers_deg, int run = 1,
                                     const std::string& solver = "A") {
  std::vector<SolveRecord> solves;
  std::vector<double> at(answers_deg.front().size(), 0);
  for (const std::vector<double>& answer : answers_deg) {
    SolveRecord solve{.solver = solver, .run = run, .point = static_cast<int>(solves.size()) + 1};
    solve.start_rad = at;
    double sum = 0;
    for (std::size_t joint = 0; joint < answer.size(); ++joint) {
      solve.answer_rad.push_back(answer[joint] * degree);
      const double move = std::abs(answer[joint] * degree - at[joint]) / degree;
      sum += move * move;
      solve.largest_move_deg = std::max(solve.largest_move_deg, move);
    }
    solve.variation_deg = std::sqrt(sum);
    solve.target_position_m = {0.1 * solve.point, 0, 0};
    solve.target_rotation = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    at = solve.answer_rad;
    solves.push_back(solve);
  }
  return solves;
}

StudyResults recorded_study(std::vector<SolveRecord> solves, const std::string& definition = "{}") {
  StudyEntry entry{.name = "s", .definition = definition, .series = {}};
  return make_study(entry, std::move(solves));
}

Metric metric(std::string_view column) {
  const std::vector<Metric> all = all_metrics();
  return *std::ranges::find(all, column, [](Metric metric) { return name_of(metric); });
}

double only_value(const StudyResults& study, std::string_view column) {
  const std::vector<Sample> all = samples(study, metric(column));
  REQUIRE(all.size() == 1);
  REQUIRE(all[0].values.size() == 1);
  return all[0].values[0];
}

const std::vector<std::vector<double>> corner{{10, 0}, {13, 4}, {13, 44}, {10, 0}};

}  // namespace

TEST_CASE("a run bends by the mean second difference of its angles", "[run_metrics]") {
  // (13, 44) - 2 (13, 4) + (10, 0) = (-3, 36), and (10, 0) - 2 (13, 44) + (13, 4) = (-3, -84).
  CHECK(only_value(recorded_study(run_through(corner)), "bend_deg") == Approx((3 + 36 + 3 + 84) / 4.0));
  CHECK(only_value(recorded_study(run_through({{0, 0}, {1, 2}, {2, 4}, {3, 6}})), "bend_deg") ==
        Approx(0).margin(1e-12));
  CHECK(std::isnan(only_value(recorded_study(run_through({{1, 2}})), "bend_deg")));
  std::vector<SolveRecord> reversed = run_through(corner);
  std::ranges::reverse(reversed);
  CHECK(only_value(recorded_study(reversed), "bend_deg") == Approx(31.5));
}

TEST_CASE("the angle of an orientation error is that of the rotation", "[run_metrics]") {
  // ||R - I||_F of a turn by t about an axis is 2 sqrt 2 sin(t / 2), and ||I||_F is sqrt 3.
  for (const double angle : {1e-9, 0.001, 1.0, 60.0, 90.0, 179.0, 180.0}) {
    std::vector<SolveRecord> solves = run_through({{1, 2}});
    solves[0].orientation_error = 2 * std::sqrt(2.0) * std::sin(angle * degree / 2) / std::sqrt(3.0);
    CHECK(only_value(recorded_study(solves), "orientation_error_deg") == Approx(angle).epsilon(1e-6));
    CHECK(std::isnan(only_value(recorded_study(solves, R"({"search": "all_joints"})"), "orientation_error_deg")));
  }
}

TEST_CASE("observations have the numbers of whole runs", "[run_metrics]") {
  std::vector<SolveRecord> solves = run_through(corner);
  std::ranges::copy(run_through({{10, 0}, {13, 4}}, 2), std::back_inserter(solves));  // two points are missing
  std::ranges::copy(run_through({{10, 0}, {13, 4}, {16, 8}, {19, 12}}, 3), std::back_inserter(solves));
  const StudyResults study = recorded_study(solves, R"({"points": 4, "runs": 3})");
  const Observations bends = observations(study, metric("bend_deg"));
  REQUIRE(bends.groups[0].values.size() == 2);
  CHECK(bends.groups[0].values[0] == Approx(31.5));
  CHECK(bends.groups[0].values[1] == Approx(0).margin(1e-12));
  CHECK(bends.replicate == "the value of a run over its 4 points");
}

TEST_CASE("a report shows what differs between runs, and names what it leaves out", "[run_metrics]") {
  std::vector<SolveRecord> solves = run_through(corner);
  std::ranges::copy(run_through({{10, 0}, {13, 4}, {16, 8}, {19, 12}}, 2), std::back_inserter(solves));
  for (SolveRecord& solve : solves) {
    solve.variation_m = 0.1 * solve.run;
    solve.orientation_error = 1e-12 * solve.run;  // rounding: the closed form of the wrist
  }
  const StudyResults study = recorded_study(solves);
  const std::vector<Metric> shown = shown_metrics(study);
  const auto has = [&](std::string_view column) { return std::ranges::find(shown, metric(column)) != shown.end(); };
  CHECK(has("position_error_cm"));
  CHECK(has("variation_m"));
  CHECK_FALSE(has("bend_deg"));
  CHECK_FALSE(has("orientation_error_deg"));
  StudyResults of_paper = study;
  of_paper.facts.published = "slim2023";
  CHECK(shown_metrics(of_paper) == reported_metrics());
}

TEST_CASE("solved solves are counted with Wilson's interval, by what is independent", "[run_metrics]") {
  std::vector<SolveRecord> solves;
  for (int run = 1; run <= 10; ++run) {
    for (int point = 1; point <= 2; ++point) {
      SolveRecord solve{.solver = "A", .run = run, .point = point};
      solve.target_position_m = {0.01 * run, 0.01 * point, 0};
      solve.status = run <= 8 ? Status::ok : Status::tolerance_missed;
      solves.push_back(solve);
    }
  }
  // Wilson's score interval of 16 of 20 and of 8 of 10, by its formula: centre p + z^2/2n, reach z sqrt(p q/n +
  // z^2/4n^2).
  const auto row = [&](const char* definition) {
    return report::solved_table(recorded_study(solves, definition)).rows.at(0);
  };
  const auto of_targets = row(R"({"start": "middle", "path": {"kind": "random"}})");
  CHECK(std::get<double>(of_targets[3]) == 0.8);
  CHECK(std::get<report::Range>(of_targets[4]).low == Approx(0.583982568).epsilon(1e-8));
  CHECK(std::get<report::Range>(of_targets[4]).high == Approx(0.919342337).epsilon(1e-8));
  const auto of_runs = row(R"({"start": "previous", "path": {"kind": "random"}})");
  CHECK(std::get<report::Range>(of_runs[4]).low == Approx(0.490162472).epsilon(1e-8));
  CHECK(std::get<report::Range>(of_runs[4]).high == Approx(0.943317849).epsilon(1e-8));
}

TEST_CASE("times are told by quantiles, the longest, and the share over the deadline", "[run_metrics]") {
  std::vector<SolveRecord> solves;
  for (int run = 1; run <= 100; ++run) {
    SolveRecord solve{.solver = "A", .run = run, .point = 1};
    solve.seconds = 0.001 * run;
    solves.push_back(solve);
  }
  const auto times = [&](const char* definition) {
    return report::times_table(recorded_study(solves, definition)).rows.at(0);
  };
  const auto row = times(R"({"deadline_ms": 90})");
  CHECK(std::get<double>(row[1]) == Approx(50.5));
  CHECK(std::get<double>(row[2]) == Approx(95.5));  // Hyndman and Fan's type 5: 0.95 * 100 + 0.5 = 95.5th
  CHECK(std::get<double>(row[3]) == Approx(99.5));
  CHECK(std::get<double>(row[4]) == Approx(100));
  CHECK(std::get<double>(row[5]) == Approx(0.1));  // 91 to 100 ms
  CHECK(std::holds_alternative<std::monostate>(times("{}")[5]));
  CHECK(std::get<double>(times(R"({"stop": {"seconds": 0.05}})")[5]) == Approx(0.5));
}
