// The effect of one interruption on a time: it is reported, and decides nothing.
#include "analysis/inference/times.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/inference/make_study.hpp"
#include "tests/analysis/synthetic.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::statistics;
using namespace ikbench::inference;

namespace {

// A hundred solves of 1 ms.
std::vector<SolveRecord> solves() {
  std::vector<SolveRecord> all = synthetic::solves({.solvers = {"A", "B"}, .runs = 2, .points = 25});
  for (SolveRecord& solve : all) solve.seconds = solve.cpu_seconds = 0.001;
  return all;
}

StudyResults timed_study(std::vector<SolveRecord> solves) {
  return make_study(StudyEntry{.name = "t", .definition = "{}", .series = {}}, std::move(solves));
}

}  // namespace

TEST_CASE("a time stands out by its solver's speed, unless it was repeated", "[times]") {
  std::vector<SolveRecord> all = solves();
  all[70].seconds = 0.004;
  all[70].evaluations *= 4;  // so much more was to be done
  CHECK(outlier_doubts(timed_study(all)).empty());
  all[70].evaluations /= 4;
  all[3].seconds = 0.0031;
  CHECK(words_of(outlier_doubts(timed_study(all))) ==
        "2 of 100 solves took more than 3 times as long as usual. The worst is B, run 1, point 21: 4 ms instead of 1 "
        "ms. For the verdict such a solve counts as usual, so it decides nothing.");
  for (SolveRecord& solve : all) {
    solve.repeats = 3;
    solve.smallest_seconds = 0.001;
  }
  CHECK(outlier_doubts(timed_study(all)).empty());
}

TEST_CASE("at the median speed a solve takes what its evaluations take", "[times]") {
  std::vector<SolveRecord> all = solves();  // 1 ms for 10000 evaluations
  all[0].seconds = 0.05;
  all[3].evaluations = 20000;
  all[4].seconds = not_defined;
  all[5].evaluations = 0;
  const StudyResults study = at_median_speed(timed_study(all));
  CHECK(seconds_of(study, study.solves[0]) == Approx(0.001));
  CHECK(seconds_of(study, study.solves[3]) == Approx(0.002));
  CHECK(std::isnan(seconds_of(study, study.solves[4])));
  CHECK(seconds_of(study, study.solves[5]) == 0.001);
}

TEST_CASE("the time of a run is the median of its points", "[times]") {
  std::vector<SolveRecord> all = synthetic::solves({.solvers = {"A"}, .runs = 2, .points = 3});
  for (SolveRecord& solve : all) solve.seconds = 0.001 * solve.point;
  all[2].seconds = 5;
  CHECK(samples(timed_study(all), Metric::seconds).front().values == std::vector<double>{0.002, 0.002});
}

TEST_CASE("where solves end by their time it is said that schedules did not end", "[times]") {
  const auto has_note = [](const StudyResults& study, std::string_view sentence) {
    const std::vector<std::string> notes = status_notes(study);
    return std::ranges::any_of(notes, [&](const std::string& note) { return note.starts_with(sentence); });
  };
  std::vector<SolveRecord> all = solves();
  CHECK_FALSE(has_note(timed_study(all), "0 of 100"));
  all[0].stop_reason = all[3].stop_reason = StopReason::time;
  CHECK(has_note(timed_study(all), "2 of 100 solves ended by their time. Schedules that end with a solve did not end"));
}
