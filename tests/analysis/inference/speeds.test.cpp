// A machine that went at two speeds.
#include <vector>

#include "analysis/inference/make_study.hpp"
#include "analysis/inference/times.hpp"
#include "tests/analysis/synthetic.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::inference;

namespace {

// 20 solves a run; from the slow run on, everything takes so many times as long.
std::string note_of(double ratio, int slow_run, const std::string& only = "") {
  std::vector<SolveRecord> solves = synthetic::solves({.solvers = {"IK-BA", "BA", "DE"}, .runs = 10});
  for (SolveRecord& solve : solves) {
    if (solve.run >= slow_run && (only.empty() || solve.solver == only)) solve.seconds *= ratio;
  }
  return words_of(speed_doubts(make_study("s", std::move(solves))));
}

}  // namespace

TEST_CASE("two groups of times in every solver are two speeds of the machine", "[times]") {
  const std::string note = note_of(1.4, 8);
  CHECK(
      note.starts_with("The machine had two speeds: the solves of every solver are in two groups, and an evaluation of "
                       "the slow ones took 1.4 times as long. Slow solves: IK-BA 30 %, BA 30 %, DE 30 %."));
}

TEST_CASE("one speed, two speeds of one solver and a single slow run are no two speeds of the machine", "[times]") {
  CHECK(note_of(1, 8).empty());
  CHECK(note_of(1.4, 8, "BA").empty());
  CHECK(note_of(5, 11).empty());
}

TEST_CASE("solves that end early are slower for each evaluation, and are no speed of the machine", "[times]") {
  std::vector<SolveRecord> solves = synthetic::solves({.solvers = {"IK-BA", "BA"}, .runs = 10});
  for (SolveRecord& solve : solves) {
    if (solve.run < 8) continue;
    solve.evaluations /= 10;
    solve.seconds /= 5;
  }
  CHECK(speed_doubts(make_study("s", std::move(solves))).empty());
}
