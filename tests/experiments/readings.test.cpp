#include "experiments/readings.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <stdexcept>

#include "experiments/runner.hpp"
#include "experiments/study_writer.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/samples.hpp"

using namespace ikbench;
using namespace ikbench::solvers;
using namespace ikbench::results;
using namespace ikbench::experiments;

namespace {

const Overrides small{"runs=2", "path.points=3", "stop.iterations=5", "population=6"};

const ReadingsPlan::Row& row_of(const ReadingsPlan& plan, const std::string& set) {
  const auto found = std::ranges::find_if(
      plan.rows, [&](const auto& row) { return row.readings.size() == 1 && row.readings.front().set == set; });
  REQUIRE(found != plan.rows.end());
  return *found;
}

// The solvers that a reading moves.
std::set<std::string> moved(const ReadingsPlan& plan, const std::string& set) {
  std::set<std::string> labels;
  for (std::size_t s = 0; s < plan.solvers.size(); ++s) {
    if (row_of(plan, set).parts[s] != plan.rows.front().parts[s]) labels.insert(plan.solvers[s]);
  }
  return labels;
}

}  // namespace

TEST_CASE("every reading is an override of slim2023 that changes a series", "[readings]") {
  const ReadingsPlan plan = plan_readings("slim2023", one_at_a_time(readings("slim2023")), 1);
  CHECK(plan.rows.size() == readings("slim2023").size() + 1);
  std::set<std::string> names;
  for (const Reading& reading : readings("slim2023")) {
    CAPTURE(reading.set);
    CHECK(names.insert(reading.set).second);
    CHECK(reading.section.starts_with("2."));
    CHECK(reading.sentence.ends_with('.'));
    CHECK_FALSE(moved(plan, reading.set).empty());
  }
}

TEST_CASE("every built-in list of readings is of a built-in study, which each of them changes", "[readings]") {
  int lists = 0;
  for (const auto& file : std::filesystem::directory_iterator("experiments/multiverse")) {
    const std::string study = file.path().stem().string();
    CAPTURE(study);
    const Study usual = load_study(study);
    CHECK_FALSE(readings(study).empty());
    for (const Reading& reading : readings(study)) {
      CAPTURE(reading.set);
      CHECK(to_toml(load_study(study, {reading.set})) != to_toml(usual));
    }
    ++lists;
  }
  CHECK(lists > 0);
  CHECK(readings("slim2023-context").empty());
}

TEST_CASE("only the solvers that a reading moves are solved again, and each series once", "[readings]") {
  const ReadingsPlan plan = plan_readings("slim2023", one_at_a_time(readings("slim2023")), 2);
  CHECK(moved(plan, "search=all_joints").size() == 6);
  CHECK(moved(plan, "BA.best_of=evaluated") == std::set<std::string>{"BA"});
  CHECK(moved(plan, "bounds=clamp") == std::set<std::string>{"IK-BA"});  // the others are clamped already
  const auto ik_ba = std::ranges::find(plan.solvers, "IK-BA") - plan.solvers.begin();
  const auto s = static_cast<std::size_t>(ik_ba);
  CHECK(row_of(plan, "bounds=clamp").parts[s] == row_of(plan, "IK-BA.bounds=clamp").parts[s]);
  std::set<std::string> keys;
  for (const Study& part : plan.parts) {
    REQUIRE(part.solvers.size() == 1);
    CHECK(keys.insert(series_key(part, part.solvers.front())).second);
  }
}

TEST_CASE("a part alone has the numbers that it has in the whole study", "[readings]") {
  const ReadingsPlan plan = plan_readings("slim2023", {{}}, 1, small);
  const std::vector<SolveRecord> whole = solves_of(load_study("slim2023", small));
  std::vector<SolveRecord> parts;
  for (const Study& part : plan.parts) {
    for (SolveRecord& record : solves_of(part)) parts.push_back(std::move(record));
  }
  REQUIRE(parts.size() == whole.size());
  for (const SolveRecord& record : parts) {
    const auto same = std::ranges::find_if(whole, [&](const SolveRecord& other) {
      return other.solver == record.solver && other.run == record.run && other.point == record.point;
    });
    REQUIRE(same != whole.end());
    CHECK(same->answer_rad == record.answer_rad);
    CHECK(same->series == record.series);
  }
}

TEST_CASE("the default reaches all targets, Eq. 27 does not", "[readings]") {
  const ReadingsPlan plan = plan_readings("slim2023", one_at_a_time(readings("slim2023")), 1);
  CHECK(plan.rows.front().out_of_reach == 0);
  CHECK(row_of(plan, "path.tool=eq27").out_of_reach > 0);
}

TEST_CASE("a grid has every combination, of alternatives at most one", "[readings]") {
  const auto grid = full_grid(readings("slim2023"), {"search=all_joints", "IK-BA.acceptance=loudness",
                                                     "IK-BA.acceptance=yang2020", "DE.bounds=reflect"});
  CHECK(grid.size() == 2 * 3 * 2);
  CHECK(grid.front().empty());
  for (const Combination& combination : grid) {
    std::set<std::string> settings;
    for (const Reading& reading : combination) {
      CHECK(settings.insert(reading.set.substr(0, reading.set.find('='))).second);
    }
  }
}

TEST_CASE("a grid refuses what it does not know, what stands twice, and what is too much", "[readings]") {
  CHECK_THROWS_WITH(
      full_grid(readings("slim2023"), {"search=all_joint"}),
      Catch::Matchers::StartsWith("unknown interpretation \"search=all_joint\"; did you mean \"search=all_joints\""));
  CHECK_THROWS_AS(full_grid(readings("slim2023"), {"DE.bounds=reflect", "DE.bounds=reflect"}), std::invalid_argument);
  std::vector<std::string> all;
  for (const Reading& reading : readings("slim2023")) all.push_back(reading.set);
  CHECK_THROWS_AS(full_grid(readings("slim2023"), all), std::invalid_argument);
}

TEST_CASE("solving without a store ends when it is cancelled", "[readings]") {
  std::atomic<bool> cancelled{false};
  int taken = 0;
  solve_study(
      small_study(), 1,
      [&](const SolveRecord&) {
        ++taken;
        cancelled = true;
      },
      &cancelled);
  CHECK(taken == 1);
}
