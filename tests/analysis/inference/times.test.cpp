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

// Three repeats of each: 1 ms, but of A's run 1, point 2 one took 50 ms, in which the system took the processor away.
std::vector<SolveRecord> solves() {
  std::vector<SolveRecord> all = synthetic::solves({.solvers = {"A", "B"}, .runs = 2, .points = 25});
  for (SolveRecord& solve : all) {
    solve.repeats = 3;
    solve.seconds = solve.cpu_seconds = solve.smallest_seconds = solve.largest_seconds = 0.001;
  }
  all[1].largest_seconds = 0.05;
  all[1].interruptions = 2;
  return all;
}

StudyResults timed_study(std::vector<SolveRecord> solves, const char* stolen = "0.25") {
  return make_study(StudyEntry{.name = "t", .definition = "{}", .series = {}}, std::move(solves),
                    {{.id = 1, .environment = {{"stolen_seconds", stolen}}},
                     {.id = 2, .environment = {{"stolen_seconds", "7"}}}});  // of no solve
}

}  // namespace

TEST_CASE("a repeat that was interrupted is named, with what the machine did", "[times]") {
  CHECK(
      words_of(outlier_doubts(timed_study(solves()))) ==
      "1 of 100 solves took more than 3 times as long as usual. The worst is A, run 1, point 2, in one of its repeats: "
      "50 ms instead of 1 ms. For the verdict such a solve counts as usual, so it decides nothing. The system "
      "interrupted the solves 2 times. The host kept 0.25 s of processor time from this machine.");
  std::vector<SolveRecord> quiet = solves();
  quiet[1].largest_seconds = 0.003;
  CHECK(outlier_doubts(timed_study(quiet)).empty());
}

TEST_CASE("of a store that knows no repeats, a time stands out by its solver's speed", "[times]") {
  std::vector<SolveRecord> all = solves();
  for (SolveRecord& solve : all) {
    solve.repeats = 1;
    solve.smallest_seconds = solve.largest_seconds = solve.interruptions = not_defined;
  }
  all[70].seconds = 0.004;
  all[70].evaluations *= 4;  // so much more was to be done
  CHECK(outlier_doubts(timed_study(all, "nonsense")).empty());
  all[70].evaluations /= 4;
  CHECK(words_of(outlier_doubts(timed_study(all, "nonsense"))) ==
        "1 of 100 solves took more than 3 times as long as usual. The worst is B, run 1, point 21: 4 ms instead of 1 "
        "ms. For the verdict such a solve counts as usual, so it decides nothing.");
}

TEST_CASE("a machine is loaded where more than a twentieth of the solves stand out, and never by one", "[times]") {
  std::vector<SolveRecord> all = solves();
  CHECK(load_doubts(timed_study(all)).empty());
  CHECK(load_doubts(timed_study({all[0], all[1]})).empty());
  for (std::size_t i = 0; i < 6; ++i) all[10 * i].largest_seconds = 0.01;
  CHECK(words_of(load_doubts(timed_study(all)))
            .starts_with("The machine was loaded. 7 of 100 solves took more than 3 times"));
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
