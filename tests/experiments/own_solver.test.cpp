// A C++ class as a solver that does not do what a solver has to do: what comes of it is a row that every reader takes,
// or the run ends with its label, run and point.
#include <array>
#include <cfenv>

#include "base/names.hpp"
#include "tests/base/processes.hpp"
#include "tests/experiments/samples.hpp"

namespace {

// Of the second and third target it does `fault` where it is asked for, notes under that name, and may ask nothing.
class Faulty final : public Solver {
 public:
  struct Options {
    void list(OptionList&) {}
  };
  explicit Faulty(Options) {}
  void start(const Problem& problem, Objective& objective, numerics::Random&) override {
    const double here = place_of(objective.goal().target);
    is_faulty_ = here == middle[0] || here == middle[1];
    best_ = {problem.start, is_faulty_ && !asks ? 1 : objective.error(problem.start)};
    if (is_faulty_ && !noted.empty()) objective.note(noted, 1);
    if (is_faulty_ && place == "start") fault(best_);
  }
  void step(Objective& objective, numerics::Random&) override {
    if (is_faulty_ && !noted.empty()) objective.note(noted, 2);
    if (is_faulty_ && place == "step") fault(best_);
  }
  const Best& best() const override {
    Best ignored;
    if (is_faulty_ && place == "best") fault(ignored);
    return best_;
  }
  bool finished() const override { return is_faulty_ && place == "finished"; }

  static double place_of(const Pose& target) { return target.translation().dot(Eigen::Vector3d(1, 2, 3)); }
  static inline std::array<double, 2> middle{};  // of targets
  static inline bool asks = true;
  static inline std::string noted;
  static inline std::string place;
  static inline std::function<void(Best&)> fault;

 private:
  Best best_;
  bool is_faulty_ = false;
};

// Four solves of it.
Study study_of_faulty(const std::string& search) {
  Study study = parse_study("robot = 'kuka_iiwa14'\nsearch = '" + search +
                                "'\nstart = 'initial'\nruns = 1\nturns = 1\npath = { kind = 'circle', points = 4 }\n"
                                "stop = { iterations = 3 }\nsolvers = [{ solver = 'random_search' }]\n",
                            "a study");
  const std::vector<Pose> poses = targets(study, 1);
  Faulty::middle = {Faulty::place_of(poses[1]), Faulty::place_of(poses[2])};
  const SolverInfo faulty = solver_info<Faulty>("faulty", "does not do as it should", "this test");
  study.solvers = {{.label = "mine", .solver = faulty.name, .own = std::make_shared<SolverInfo>(faulty)}};
  return study;
}

// What the run says of a fault; its type has to be `Exception`. One solve is stored.
template <class Exception>
std::string said_of(const std::string& place, const std::function<void(Best&)>& fault,
                    const std::string& search = "all_joints") {
  Faulty::place = place;
  Faulty::fault = fault;
  const ScratchFolder folder;
  const Study study = study_of_faulty(search);
  static std::map<std::string, StoredStudy> known;  // each has a digest of this whole program
  if (!known.contains(search)) known.emplace(search, stored_study(study));
  Store store(folder.path / "store.sqlite", Store::Mode::write);
  std::string said = complaint<Exception>([&] { run(study, known.at(search), store, {}); });
  CHECK(store.solves(study.name).size() == 1);
  return said;
}

}  // namespace

TEST_CASE("whatever a class answers, every reader takes the store, and its neighbour has the same solves",
          "[own_solver]") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  struct Odd {
    std::string place;
    std::function<void(Best&)> fault;
    Status status;
    std::string told = "", noted = "";
    bool asks = true;
  };
  const auto fill = [](double value) { return [value](Best& best) { best.q.setConstant(value); }; };
  const auto claim = [](double error) { return [error](Best& best) { best.error = error; }; };
  const auto resize = [](Eigen::Index size) { return [size](Best& best) { best.q = Eigen::VectorXd::Zero(size); }; };
  const auto nothing = [](Best&) {};
  const std::string finite = "not finite", cut = "are cut";
  const std::vector<Odd> all{{"step", nothing, Status::ok},
                             {"finished", nothing, Status::ok},
                             {"", nothing, Status::claimed_but_wrong, "nobody counts", "", false},
                             {"step", fill(nan), Status::not_finite, finite},
                             {"step", fill(infinity), Status::not_finite, finite},
                             {"step", fill(1e308), Status::not_finite, finite},
                             {"step", fill(100), Status::claimed_but_wrong},
                             {"step", claim(nan), Status::not_finite, finite},
                             {"start", claim(infinity), Status::not_finite, finite},
                             {"step", claim(0), Status::claimed_but_wrong},
                             {"step", claim(-1), Status::claimed_but_wrong},
                             {"step", resize(0), Status::not_finite, finite},
                             {"start", resize(6), Status::not_finite, finite},
                             {"step", resize(10), Status::not_finite, finite},
                             {"step", [](Best&) { std::fesetround(FE_UPWARD); }, Status::ok},
                             {"", nothing, Status::ok, "", "stalls"},
                             {"", nothing, Status::ok, cut, "my\tcount"},
                             {"", nothing, Status::ok, cut, std::string(100'000, 'x')},
                             {"", nothing, Status::ok, cut, "\x1b]0;x\x07\xc2\x9b\xff"},
                             {"", nothing, Status::ok, cut, std::string(199, 'x') + "\u00e9"}};
  for (const std::string search : {"all_joints", "pose"}) {
    Study study = study_of_faulty(search);
    study.wrap = Wrap::no;  // which would turn a huge angle to a near one
    study.solvers.push_back({.label = "RS", .solver = "random_search"});
    const StoredStudy stored = stored_study(study);
    std::vector<SolveRecord> neighbours;
    for (const auto& [place, fault, status, told, noted, asks] : all) {
      INFO(search << ", " << place << ", " << name_of(status) << ", " << one_line(front(noted, 40)));
      Faulty::place = place, Faulty::fault = fault, Faulty::noted = noted, Faulty::asks = asks;
      const ScratchFolder folder;
      Progress progress;
      {
        Store store(folder.path / "store.sqlite", Store::Mode::write);
        progress = run(study, stored, store, {.jobs = told.size() % 2 == 0 ? 1 : 2});
      }
      const Store store(folder.path / "store.sqlite", Store::Mode::read);
      const std::vector<SolveRecord> solves = store.solves(study.name), odd = only("mine", solves);
      CHECK(complaint<std::invalid_argument>([&] { std::ranges::for_each(solves, recheck_of(stored)); }) == "");
      if (neighbours.empty()) neighbours = only("RS", solves);
      CHECK(same_numbers(only("RS", solves), neighbours));
      REQUIRE(odd.size() == 4);
      CHECK(odd[2].status == status);
      CHECK((odd[2].counted_by == CountedBy::suite) == asks);
      for (const std::string& name : store.names_of_extras(stored)) CHECK(is_plain(name));
      CHECK(store.names_of_extras(stored).empty() == noted.empty());
      if (noted == "stalls")
        CHECK(odd[2].extras == std::map<std::string, double>{{noted, 2}});  // the last that it said
      REQUIRE(progress.notes.size() == (told.empty() ? 0 : 1));
      if (!told.empty()) CHECK_THAT(progress.notes[0], StartsWith("mine: ") && ContainsSubstring(told));
    }
    Faulty::noted = "", Faulty::asks = true;
  }
}

TEST_CASE("a solve that no reader would take ends the run with its place, and those before are stored",
          "[own_solver]") {
  Study study = study_of_faulty("all_joints");
  study.solvers.front().solver = "newton";  // whose evaluations are always counted
  const StoredStudy stored = stored_study(study);
  Faulty::place = "", Faulty::asks = false;
  ScratchStore store;
  const auto request = RunRequest{.patience = std::chrono::milliseconds(10'000)};
  CHECK_THAT(complaint<std::runtime_error>([&] { run(study, stored, store, request); }),
             ContainsSubstring("mine, run 1, point 2: it has 0 evaluations"));
  CHECK(store.solves(study.name).size() == 1);
  Faulty::asks = true;
}

TEST_CASE("an exception of a solver is told of with solver, run and point", "[own_solver]") {
  for (const char* place : {"start", "step", "best"}) {
    CHECK(said_of<std::runtime_error>(place, [](Best&) { throw std::runtime_error("no"); }) ==
          "mine, run 1, point 2: no");
    CHECK(said_of<std::invalid_argument>(place, [](Best&) { throw std::invalid_argument("not this"); }) ==
          "mine, run 1, point 2: not this");
    CHECK(said_of<std::runtime_error>(place, [](Best&) { throw std::bad_alloc(); }) ==
          "mine, run 1, point 2: std::bad_alloc");
    CHECK_THAT(said_of<std::runtime_error>(place, [](Best&) { throw 5; }), StartsWith("mine, run 1, point 2: "));
  }
}

TEST_CASE("a solve during which a stop came is stored if it solved, and else left for the next time", "[own_solver]") {
  std::atomic<bool> cancelled{false};
  Faulty::place = "step";
  Faulty::fault = [&](Best&) { cancelled = true; };
  Study study = study_of_faulty("all_joints");
  for (const double tolerance : {0.0, 1e-9}) {
    study.stop.tolerance = tolerance;
    ScratchStore store;
    cancelled = false;
    CHECK(run(study, store, {.cancelled = &cancelled}).done == (tolerance == 0 ? 2 : 1));
  }
}

TEST_CASE("a solver that ends the process does not end it as if all were solved", "[own_solver]") {
  Faulty::place = "step";
  Faulty::fault = [](Best&) { std::exit(0); };
  const Study study = study_of_faulty("all_joints");
  const ScratchFolder folder;
  for (const int jobs : {1, 2}) {
    const std::filesystem::path store = folder.path / fmt::format("{}.sqlite", jobs), said = folder.path / "said";
    const pid_t process = in_a_process([&] {
      if (std::freopen(said.c_str(), "w", stderr) == nullptr) return false;
      Store mine(store, Store::Mode::write);
      run(study, mine, {.jobs = jobs});
      return true;
    });
    CHECK(exit_code(process) == 2);
    CHECK_THAT(text_in(said), StartsWith("ikbench: mine, run 1, point "));  // 2, or of two jobs 3
    CHECK(Store(store, Store::Mode::read).solves(study.name).size() <= 1);
  }
  CHECK(exit_code(in_a_process([&]() -> bool { std::exit(0); })) == 0);  // outside of a solve
}
