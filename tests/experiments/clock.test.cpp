// The clock: each solve is one timed call, and a study is done in sessions, each with all solvers that it compares.
#include "tests/experiments/samples.hpp"

namespace {

// A solver that notes its calls: which label was asked for which target, in the order of the calls.
struct Calls {
  static inline std::vector<std::pair<std::string, double>> all;  // name and the target's x [m]
};
template <char name>
class Recorded final : public Solver {
 public:
  struct Options {
    void list(OptionList&) {}
  };
  explicit Recorded(Options) {}
  void start(const Problem& problem, Objective& objective, numerics::Random&) override {
    Calls::all.emplace_back(std::string(1, name), objective.goal().target.translation().x());
    best_ = {problem.start, objective.error(problem.start)};
    best_.q.array() += 1e-3 * shift * ++starts_;
  }
  void step(Objective&, numerics::Random&) override {}
  bool finished() const override { return true; }
  const Best& best() const override { return best_; }

  static inline double shift = 0;  // of every answer from the one before: it remembers

 private:
  Best best_;
  int starts_ = 0;
};

template <char name>
SolverEntry recorded() {
  const SolverInfo info = solver_info<Recorded<name>>(std::string(1, name), "writes down", "this test");
  return {.label = info.name, .solver = info.name, .custom = std::make_shared<SolverInfo>(info)};
}

// Returns a study with targets of a circle, each from the initial configuration.
Study study_of_calls(int points) {
  Study study =
      read(fmt::format("search = 'all_joints'\nstart = 'initial'\nruns = 1\npath = {{ kind = 'circle', points = {} }}\n"
                       "stop = {{ iterations = 1 }}\nsolvers = [{{ solver = 'random_search' }}]\n",
                       points));
  study.solvers = {recorded<'a'>(), recorded<'b'>()};
  Calls::all.clear();
  return study;
}

// Returns by session the places of each label.
std::map<std::int64_t, std::map<std::string, std::set<std::pair<int, int>>>> places_in(const Store& store,
                                                                                       const Study& study) {
  std::map<std::int64_t, std::map<std::string, std::set<std::pair<int, int>>>> all;
  for (const SolveRecord& solve : solves_of(store, study.name))
    all[solve.session][solve.label].insert({solve.run, solve.point});
  return all;
}

}  // namespace

TEST_CASE("a solve is one timed call, and says under what circumstances its time was taken", "[clock]") {
  const Timing alone = is_debug_build() ? Timing::debug_build : Timing::clean;
  const Timing together = is_debug_build() ? Timing::debug_build : Timing::parallel;
  for (const SolveRecord& solve : solve_all(small_study(), 2)) CHECK(solve.timing == together);
  for (const SolveRecord& solve : solve_all(small_study())) {
    CHECK(solve.timing == alone);
    CHECK(solve.batch_size == 1);
    CHECK(solve.seconds > 0);
    CHECK(solve.wall_seconds == solve.seconds);
    CHECK(solve.cpu_seconds > 0);
  }
}

TEST_CASE("a study is done in sessions, in each of which all solvers have the same targets, and a shard in one",
          "[clock]") {
  for (const auto& [points, rounds, sessions] : {std::tuple(12, 6, 6), {4, 6, 4}, {12, 1, 1}, {13, 3, 3}}) {
    Study study = study_of_calls(points);
    study.rounds = rounds;
    ScratchStore store;
    run(study, store, {});
    const auto places = places_in(store, study);
    CHECK(std::ssize(places) == sessions);
    for (const auto& [session, of] : places) CHECK(of.at("a") == of.at("b"));
    for (const Session& session : store.sessions()) CHECK(session.environment.at("state") == "first");
  }
  const Study study = study_of_calls(12);
  ScratchStore store;
  run(study, store, {.shard = {2, 3}});
  CHECK(places_in(store, study).size() == 1);
}

TEST_CASE("all solvers solve a target before the next, and take turns at being first", "[clock]") {
  Study study = study_of_calls(8);
  study.rounds = 2;
  ScratchStore store;
  run(study, store, {});
  constexpr std::size_t warm_ups = 6, solves = 8;  // of both, in each session
  REQUIRE(Calls::all.size() == 2 * (warm_ups + solves));
  std::string first;
  for (std::size_t turn = 0; turn < 2; ++turn) {
    const auto begin = Calls::all.begin() + static_cast<std::ptrdiff_t>(turn * (warm_ups + solves) + warm_ups);
    for (std::size_t i = 0; i < solves; i += 2) {
      CHECK(begin[static_cast<std::ptrdiff_t>(i)].second == begin[static_cast<std::ptrdiff_t>(i) + 1].second);
      CHECK(begin[static_cast<std::ptrdiff_t>(i)].first != begin[static_cast<std::ptrdiff_t>(i) + 1].first);
      first += begin[static_cast<std::ptrdiff_t>(i)].first;
    }
  }
  CHECK((first == "ababbaba" || first == "babaabab"));
}

TEST_CASE("warm is the second call, after one on another target", "[clock]") {
  Study study = study_of_calls(5);
  study.rounds = 1;
  study.state = CacheState::warm;
  study.solvers.pop_back();
  ScratchStore store;
  run(study, store, {});
  CHECK(store.sessions().front().environment.at("state") == "warm");
  const std::vector<Pose> poses = targets_of_run(study, 1);
  std::vector<double> asked, expected;
  for (const auto& [name, x] : Calls::all) asked.push_back(x);
  for (const int target : {4, 4, 4, 0, 1, 0, 1, 2, 3, 4, 2, 3, 4})
    expected.push_back(poses[static_cast<std::size_t>(target)].translation().x());
  CHECK(asked == expected);
  const auto key_of = [&](CacheState state) {
    study.state = state;
    return series_key(study, study.solvers.front());
  };
  CHECK(key_of(CacheState::warm) != key_of(CacheState::first));
}

TEST_CASE("a stop cuts one session, and all others have the same targets of all solvers", "[clock]") {
  for (const std::int64_t solves : {1, 3, 4, 7}) {
    Study study = study_of_calls(12);
    study.rounds = 3;
    ScratchStore store;
    std::atomic<bool> cancelled{false};
    const auto look = [&](const Progress& now) { cancelled = now.done >= solves; };
    run(study, store, {.progress = look, .cancelled = &cancelled});
    run(study, store, {});
    CHECK(solves_of(store, study.name).size() == 24);
    int apart = 0;
    for (const auto& [session, of] : places_in(store, study)) apart += of.size() < 2 || of.at("a") != of.at("b");
    CHECK(apart <= 2);  // that which was cut, and the rest of its target
  }
}

TEST_CASE("a class that remembers is told of", "[clock]") {
  Study study = study_of_calls(20);
  study.rounds = 1;
  ScratchStore store;
  Recorded<'a'>::shift = 1;
  const Progress progress = run(study, store, {});
  Recorded<'a'>::shift = 0;
  REQUIRE(progress.anomalies.size() == 1);
  CHECK(progress.anomalies.front() == "a: it gave other answers to the same question in 2 of 2 repeats");
  study.stop.seconds = 1e-9;  // what the clock ends says nothing of it
  ScratchStore another;
  CHECK(run(study, another, {}).anomalies.empty());
}
