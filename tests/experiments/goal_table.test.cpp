// The goals of performance, on measurements made up by hand.
#include "experiments/microbenchmarks/goal_table.hpp"

#include <algorithm>
#include <stdexcept>

#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::microbenchmarks;

namespace {

nlohmann::json repetition(const std::string& name, int index, double time, const std::string& unit = "ns") {
  return {{"name", name},      {"run_name", name}, {"run_type", "iteration"}, {"repetition_index", index},
          {"real_time", time}, {"cpu_time", time}, {"time_unit", unit}};
}

nlohmann::json with_counter(nlohmann::json entry, const std::string& counter, double value) {
  entry[counter] = value;
  return entry;
}

nlohmann::json document(const std::vector<nlohmann::json>& benchmarks,
                        const std::string& peers = "KDL 1.5.1, pagmo 2.18.0") {
  return {{"context", {{"instruction_set", "x86-64-v4"}, {"peers", peers}}}, {"benchmarks", benchmarks}};
}

Measurements measured(const std::vector<nlohmann::json>& benchmarks,
                      const std::string& peers = "KDL 1.5.1, pagmo 2.18.0") {
  Measurements measurements;
  measurements.add(document(benchmarks, peers));
  return measurements;
}

Row row(const Measurements& measurements, const std::string& number, const std::string& instruction_set = "x86-64-v4") {
  const std::vector<Row> rows = goal_rows(measurements, instruction_set);
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row& each) { return each.number == number; });
  REQUIRE(found != rows.end());
  return *found;
}

const std::string ours = "forward_kinematics/ours", kdl = "forward_kinematics/kdl";

}  // namespace

TEST_CASE("a ratio is taken repetition by repetition, and its median is held against the bound", "[goals]") {
  // 60, 70 and 120 times; the medians of the times alone would give 300 / 5.
  const Measurements all = measured({repetition(kdl, 2, 60), repetition(kdl, 0, 300), repetition(kdl, 1, 350),
                                     repetition(ours, 0, 5), repetition(ours, 1, 5), repetition(ours, 2, 0.5)});
  const Row g1 = row(all, "G1");
  CHECK(g1.measured == "70 (60 to 120)");
  CHECK(g1.required == ">= 60");
  CHECK(g1.verdict == Verdict::met);
}

TEST_CASE("the bound depends on the instruction set, and one without a bound has no goal", "[goals]") {
  const Measurements all = measured({repetition(kdl, 0, 59), repetition(ours, 0, 1)});
  CHECK(row(all, "G1", "x86-64-v4").verdict == Verdict::not_met);
  CHECK(row(all, "G1", "x86-64-v3").verdict == Verdict::met);
  CHECK(row(all, "G1", "x86-64").verdict == Verdict::no_goal);
  CHECK(row(all, "G1", "x86-64").required == "no goal");
}

TEST_CASE("a time is compared in its unit, whatever the file's", "[goals]") {
  CHECK(row(measured({repetition("study/threads/1", 0, 800, "ms")}), "G9").verdict == Verdict::met);
  CHECK(row(measured({repetition("study/threads/1", 0, 0.81, "s")}), "G9").verdict == Verdict::not_met);
  CHECK(row(measured({repetition("study/threads/1", 0, 0.81, "s")}), "G9").measured == "0.81 s");
}

TEST_CASE("the manner of a run is no part of a benchmark's name, and means are no repetitions", "[goals]") {
  nlohmann::json mean = repetition("ik_bat/to_tolerance/iterations:1/manual_time", 0, 500, "us");
  mean["run_type"] = "aggregate";
  const Measurements all = measured({repetition("ik_bat/to_tolerance/iterations:1/manual_time", 0, 39, "us"), mean});
  CHECK(row(all, "G14").measured == "39 us");
  CHECK(row(all, "G14").verdict == Verdict::met);
}

TEST_CASE("CPU time counts, unless the benchmark asks for the clock's", "[goals]") {
  const auto disturbed = [](const std::string& name) {  // by another program, which had the core half of the time
    nlohmann::json entry = repetition(name, 0, 2e9);
    entry["cpu_time"] = 1e9;
    return entry;
  };
  CHECK(row(measured({disturbed("study/threads/1")}), "G9").measured == "1 s");
  CHECK(row(measured({disturbed("study/threads/1/iterations:1/real_time")}), "G9").measured == "2 s");
  CHECK(row(measured({disturbed("study/threads/1/manual_time")}), "G9").measured == "2 s");
}

TEST_CASE("what was not measured says why", "[goals]") {
  const std::vector<nlohmann::json> only_ours{repetition(ours, 0, 5)};
  CHECK(row(measured(only_ours), "G1").verdict == Verdict::not_measured);
  CHECK(row(measured(only_ours), "G1").why == "no run of forward_kinematics/kdl");
  CHECK(row(measured(only_ours, "pagmo 2.18.0"), "G1").why == "KDL is not installed");
  nlohmann::json failed = repetition(kdl, 0, 0);
  failed["error_occurred"] = true;
  failed["error_message"] = "the position is 1 m away";
  CHECK(row(measured({repetition(ours, 0, 5), failed}), "G1").why == "the position is 1 m away");
  for (const Row& each : goal_rows(Measurements(), "x86-64-v4")) CHECK(each.verdict == Verdict::not_measured);
}

TEST_CASE("accuracy and allocations are judged by the worst, for every instruction set", "[goals]") {
  const Measurements all = measured({with_counter(repetition("allocations/a", 0, 1), "allocations", 0),
                                     with_counter(repetition("allocations/b", 0, 1), "allocations", 3),
                                     with_counter(repetition("accuracy/sin_cos", 0, 1), "ulp", 0.6)});
  for (const std::string set : {"x86-64", "x86-64-v3", "x86-64-v4"}) {
    CHECK(row(all, "G13", set).measured == "3");
    CHECK(row(all, "G13", set).verdict == Verdict::not_met);
  }
}

TEST_CASE("results are the same where there is one hash only", "[goals]") {
  const auto hash = [](const std::string& name, const std::string& value) {
    return nlohmann::json{{"name", "result_hash/" + name}, {"hash", value}};
  };
  CHECK(row(measured({hash("a/threads:1", "17"), hash("a/threads:2", "17")}), "G11").verdict == Verdict::met);
  CHECK(row(measured({hash("a/threads:1", "17"), hash("a/threads:2", "18")}), "G11").verdict == Verdict::not_met);
  CHECK(row(measured({hash("a/threads:1", "17")}), "G11").verdict == Verdict::not_measured);
}

TEST_CASE("growth is the dearest joint of a candidate over the cheapest", "[goals]") {
  const auto size = [](const std::string& name, double time, double joints) {
    return with_counter(repetition("forward_kinematics/joints/" + name, 0, time), "candidate_joints", joints);
  };
  CHECK(row(measured({size("4", 400, 200), size("32", 3400, 1600)}), "growth").verdict == Verdict::met);
  CHECK(row(measured({size("4", 400, 200), size("32", 4000, 1600)}), "growth").measured == "1.25");
}

TEST_CASE("a file that no benchmark wrote is refused", "[goals]") {
  Measurements measurements;
  CHECK_THROWS_AS(measurements.add(nlohmann::json::array()), std::invalid_argument);
  CHECK_THROWS_AS(measurements.add(nlohmann::json{{"context", "none"}}), std::invalid_argument);
}

TEST_CASE("the table has a line for each goal, as text and as Markdown", "[goals]") {
  const std::vector<Row> rows = goal_rows(measured({repetition(kdl, 0, 300), repetition(ours, 0, 5)}), "x86-64-v4");
  const auto lines = [](const std::string& text) { return std::count(text.begin(), text.end(), '\n'); };
  CHECK(lines(as_text(rows)) == static_cast<long>(rows.size()) + 1);
  CHECK(lines(as_markdown(rows)) == static_cast<long>(rows.size()) + 2);
  CHECK(as_markdown(rows).find("| G1 | KDL's forward kinematics / ours, batch of 50 | >= 60 | 60 | met |") !=
        std::string::npos);
}
