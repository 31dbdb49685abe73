// Each solve is timed several times, and the answer is the same every time.
#include "tests/experiments/samples.hpp"

namespace {

// The first solve of a study's first solver.
struct FirstSolve {
  explicit FirstSolve(Study of) : study(std::move(of)) {}

  SolveRecord made(int repeats) const { return made(repeats, *SolveRunner(study, entry(), "", arm, 1).make_solver()); }
  SolveRecord made(int repeats, Solver& solver) const {
    const SolveRunner runner(study, entry(), "", arm, repeats);
    runner.warm_up(solver, targets(study, 1).front(), study.initial, 1, 1);
    return runner.solve(solver, targets(study, 1).front(), study.initial, 1, 1);
  }
  const SolverEntry& entry() const { return study.solvers.front(); }

  Study study;
  Robot arm = arm_of(study);
};

// Does not forget: each start is a little farther from the first.
class Remembering final : public Solver {
 public:
  void start(const Problem& problem, Objective&, numerics::Random&) override {
    best_.q = problem.start.array() + 1e-15 * ++starts;
    best_.error = 1;
  }
  void step(Objective&, numerics::Random&) override {}
  const Best& best() const override { return best_; }

  int starts = 0;

 private:
  Best best_;
};

}  // namespace

TEST_CASE("a solve that is repeated has the answer of one that is not, and the median of its times", "[repeats]") {
  for (const Trace trace : {Trace::none, Trace::best_error}) {
    Study study = small_study();
    study.trace = trace;
    const FirstSolve solve(study);
    const SolveRecord once = solve.made(1), often = solve.made(5), even = solve.made(2);
    CHECK(same(without_times(once), without_times(often)));
    CHECK(once.repeats == 1);
    CHECK(once.smallest_seconds == once.seconds);
    CHECK(once.largest_seconds == once.seconds);
    CHECK(often.repeats == 5);
    CHECK(often.smallest_seconds <= often.seconds);
    CHECK(often.seconds <= often.largest_seconds);
    CHECK(often.smallest_seconds > 0);
    CHECK(often.cpu_seconds > 0);
    CHECK(often.interruptions >= 0);
    CHECK(even.seconds == even.smallest_seconds);  // a time that was measured
    const auto is_between = [](const SolveRecord& of) { return of.smallest_seconds < of.seconds; };
    std::vector<SolveRecord> many;
    for (int i = 0; i < 20; ++i) many.push_back(solve.made(5));
    CHECK(std::ranges::any_of(many, is_between));  // not the fastest
  }
}

TEST_CASE("a solver that gives another answer when it solves a problem again is told of", "[repeats]") {
  const FirstSolve solve(small_study());
  Remembering solver;
  CHECK_THAT(complaint<std::runtime_error>([&] { solve.made(2, solver); }),
             StartsWith("IK-BA gives another answer when it solves run 1, point 1 again; "));
  CHECK(solver.starts == 3);  // the first one is not timed
  CHECK(solve.made(1, solver).repeats == 1);
}

TEST_CASE("a solve that ends by its wall time is made once", "[repeats]") {
  Study study = small_study();
  study.stop.seconds = 10;
  CHECK(FirstSolve(study).made(5).repeats == 1);
}

TEST_CASE("solves are repeated where their times can be compared, and nowhere else", "[repeats]") {
  Study study = small_study();
  const int repeats = is_debug_build() ? 1 : study.repeats;
  CHECK(study.repeats == 5);
  for (const SolveRecord& record : solves_of(study)) CHECK(record.repeats == repeats);
  for (const SolveRecord& record : solves_of(study, 2)) CHECK(record.repeats == 1);
  solve_study(study, 1, [](const SolveRecord& record) { CHECK(record.repeats == 1); });
  CHECK(solve_once(study, study.solvers.front(), targets(study, 1).front()).repeats == 1);
  study.repeats = 1;
  for (const SolveRecord& record : solves_of(study)) CHECK(record.repeats == 1);
}

TEST_CASE("a session says how much time the host kept from the machine meanwhile", "[repeats]") {
  const double before = stolen_seconds();
  const ScratchFolder folder;
  Store store(folder.path / "store.sqlite", Store::Mode::write);
  run(small_study(), store, {});
  const double all = stolen_seconds() - before;
  if (!(before >= 0)) return;  // no /proc/stat
  const double stolen = std::stod(store.sessions().front().environment.at("stolen_seconds"));
  CHECK(stolen >= 0);
  CHECK(stolen <= all + 0.01);
}
