// A user's class as a solver that breaks the rules of solvers. The result is a row that every reader takes, or the run
// ends with label, run and point of the solve.
#include <cfenv>

#include "analysis/judge/judge.hpp"
#include "analysis/show/publish.hpp"
#include "base/names.hpp"
#include "experiments/stored_checks.hpp"
#include "tests/experiments/samples.hpp"

namespace {

// A solver with a fault. For the second and third target it does `fault` at the given place, and notes a number with
// the given name. It may evaluate nothing.
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
    if (is_faulty_ && !noted.empty()) objective.note(noted, last_noted);
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
  static inline double last_noted = 2;
  static inline std::string place;
  static inline std::function<void(Best&)> fault;

 private:
  Best best_;
  bool is_faulty_ = false;
};

// Returns a study with four solves of the faulty solver.
Study study_of_faulty(const std::string& search) {
  Study study = read("search = '" + search +
                     "'\nstart = 'initial'\nruns = 1\nrounds = 1\npath = { kind = 'circle', points = 4 }\n"
                     "stop = { iterations = 3 }\nsolvers = [{ solver = 'random_search' }]\n");
  const std::vector<Pose> poses = targets_of_run(study, 1);
  Faulty::middle = {Faulty::place_of(poses[1]), Faulty::place_of(poses[2])};
  const SolverInfo faulty = solver_info<Faulty>("faulty", "does not do as it should", "this test");
  study.solvers = {{.label = "mine", .solver = faulty.name, .custom = std::make_shared<SolverInfo>(faulty)}};
  return study;
}

// Returns what the run says of a fault, which must be of the type `Exception`. One solve is stored.
template <class Exception>
std::string statements_of(const std::string& place, const std::function<void(Best&)>& fault,
                          const std::string& search = "all_joints") {
  Faulty::place = place;
  Faulty::fault = fault;
  const ScratchFolder folder;
  const Study study = study_of_faulty(search);
  static std::map<std::string, StoredStudy> known;  // each has a digest of this whole program
  if (!known.contains(search)) known.emplace(search, to_stored(study));
  Store store(folder.path / "store.sqlite", Store::Mode::write);
  std::string said = complaint<Exception>([&] { run(study, known.at(search), store, {}); });
  CHECK(solves_of(store, study.name).size() == 1);
  return said;
}

// Checks that every reader takes the solves of a store: the check of rows, a merge, an export, a report.
void check_that_all_read(const StoredStudy& study, const Store& store, const std::filesystem::path& folder) {
  const std::vector<SolveRecord> solves = solves_of(store, study.name);
  CHECK(complaint<std::invalid_argument>([&] { std::ranges::for_each(solves, stored_solve_check(study)); }) == "");
  std::filesystem::remove(folder / "merged.sqlite");
  CHECK(results::merge(folder / "merged.sqlite", {folder / "store.sqlite"}, stored_solve_check).added ==
        std::ssize(solves));
  CHECK(fingerprint(Store(folder / "merged.sqlite", Store::Mode::read), study).text == fingerprint(store, study).text);
  std::string csv;
  write_csv([&](const SolveVisitor& take) { store.for_each_in_study(study, take); },
            [&](std::string_view part) { csv += part; }, store.extra_names(study));
  CHECK(parse_csv(csv, "solves.csv").rows() == solves.size());
  show::write_report(show::make_report(judge::judge(judge::read_study(store, study)), {}), folder / "report",
                     {.only = {"none"}});
  CHECK(parsed_json(text_in(folder / "report/results.json")).is_object());
}

}  // namespace

TEST_CASE("whatever a class answers, every reader takes the store, and its neighbour has the same solves",
          "[own_solver]") {
  struct Odd {
    std::string place;
    std::function<void(Best&)> fault;
    Status status;
    std::string anomaly = "", noted = "";
    bool asks = true;
    double last_noted = 2;
  };
  const auto fill = [](double value) { return [value](Best& best) { best.q.setConstant(value); }; };
  const auto claim = [](double error) { return [error](Best& best) { best.error = error; }; };
  const auto resize = [](Eigen::Index size) { return [size](Best& best) { best.q = Eigen::VectorXd::Zero(size); }; };
  const auto nothing = [](Best&) {};
  const std::string finite = "not finite", cut = "are cut";
  const std::vector<Odd> all{{"step", nothing, Status::ok},
                             {"finished", nothing, Status::ok},
                             {"", nothing, Status::misreported, "are not counted", "", false},
                             {"step", fill(not_a_number), Status::not_finite, finite},
                             {"step", fill(infinity), Status::not_finite, finite},
                             {"step", fill(1e308), Status::not_finite, finite},
                             {"step", fill(100), Status::misreported},
                             {"step", fill(-100), Status::misreported},
                             {"step", claim(1e308), Status::misreported},
                             {"step", claim(not_a_number), Status::not_finite, finite},
                             {"start", claim(infinity), Status::not_finite, finite},
                             {"step", claim(0), Status::misreported},
                             {"step", claim(-1), Status::misreported},
                             {"step", resize(0), Status::not_finite, finite},
                             {"start", resize(6), Status::not_finite, finite},
                             {"step", resize(10), Status::not_finite, finite},
                             {"step", [](Best&) { std::fesetround(FE_UPWARD); }, Status::ok},
                             {"", nothing, Status::ok, "", "stalls"},
                             {"", nothing, Status::ok, "", "not a number", true, not_a_number},
                             {"", nothing, Status::ok, "", "=1,\"\"", true, -infinity},
                             {"", nothing, Status::ok, "", "seconds", true, 1e308},
                             {"", nothing, Status::ok, "", "refused_1", true, -0.0},
                             {"", nothing, Status::ok, cut, "my\tcount"},
                             {"", nothing, Status::ok, cut, std::string(100'000, 'x')},
                             {"", nothing, Status::ok, cut, "\x1b]0;x\x07\xc2\x9b\xff"},
                             {"", nothing, Status::ok, cut, std::string(199, 'x') + "\u00e9"}};
  for (const std::string search : {"all_joints", "pose"}) {
    Study study = study_of_faulty(search);
    study.wrap = WrapPolicy::no;  // which would turn a huge angle to a near one
    study.solvers.push_back({.label = "RS", .solver = "random_search"});
    const StoredStudy stored = to_stored(study);
    std::vector<SolveRecord> neighbours;
    for (const auto& [place, fault, status, anomaly, noted, asks, last_noted] : all) {
      INFO(search << ", " << place << ", " << name_of(status) << ", " << one_line(front(noted, 40)));
      Faulty::place = place, Faulty::fault = fault, Faulty::noted = noted, Faulty::asks = asks;
      Faulty::last_noted = last_noted;
      const ScratchFolder folder;
      Progress progress;
      {
        Store store(folder.path / "store.sqlite", Store::Mode::write);
        progress = run(study, stored, store, {.jobs = anomaly.size() % 2 == 0 ? 1 : 2});
      }
      const Store store(folder.path / "store.sqlite", Store::Mode::read);
      const std::vector<SolveRecord> solves = solves_of(store, study.name), odd = only("mine", solves);
      check_that_all_read(stored, store, folder.path);
      if (neighbours.empty()) neighbours = only("RS", solves);
      CHECK(same_numbers(only("RS", solves), neighbours));
      REQUIRE(odd.size() == 4);
      CHECK(odd[2].status == status);
      CHECK((odd[2].counted_by == CountedBy::ikbench) == asks);
      for (const std::string& name : store.extra_names(stored)) CHECK(is_plain(name));
      CHECK(store.extra_names(stored).empty() == noted.empty());
      if (noted == "stalls")
        CHECK(odd[2].extras == std::map<std::string, double>{{noted, 2}});  // the last that it said
      std::vector<SolveRecord> made;
      solve_without_store(study, 1, [&](SolveRecord solve) { made.push_back(std::move(solve)); });
      if (noted.size() < 20) CHECK(same_numbers(only("mine", made), odd));  // longer ones are cut
      REQUIRE(progress.anomalies.size() == (anomaly.empty() ? 0 : 1));
      if (!anomaly.empty()) CHECK_THAT(progress.anomalies[0], StartsWith("mine: ") && ContainsSubstring(anomaly));
    }
    Faulty::noted = "", Faulty::asks = true;
  }
}

// Also numbers that a clock could give that jumps, or another program.
TEST_CASE("of records with any odd number, every reader takes what may be written", "[own_solver]") {
  Study study = study_of_faulty("pose");
  study.runs = 1000;
  Faulty::place = "";
  const StoredStudy stored = to_stored(study);
  SolveRecord odd = solve_once(study, study.solvers.front(), targets_of_run(study, 1).front());
  odd.session = 1;
  const SolveRecord good = odd;
  std::vector<SolveRecord> taken;
  int offered = 0;
  const auto offer = [&, check = answer_check(stored)](auto member, const auto& value) {
    odd = good;
    odd.*member = value;
    odd.run = static_cast<int>(taken.size()) + 1;
    ++offered;
    if (complaint<std::invalid_argument>([&] { check(odd); }).empty()) taken.push_back(odd);
  };
  for_each_column([&]<class Value>(std::string_view name, Value SolveRecord::*member, std::string_view) {
    if (name == "run" || name == "session") return;
    if constexpr (std::is_enum_v<Value>) {
      for (std::size_t i = 0; i < names_of(Value{}).size(); ++i) offer(member, static_cast<Value>(i));
    } else if constexpr (std::is_same_v<Value, std::vector<double>>) {
      for (const std::size_t size : {(good.*member).size(), std::size_t{1000}})
        for (const double value : {not_a_number, infinity, -1e308, -0.0})
          offer(member, std::vector<double>(size, value));
    } else if constexpr (std::is_floating_point_v<Value>) {
      for (const double value : {not_a_number, infinity, -infinity, 1e308, -1.0, 5e-324}) offer(member, value);
    } else if constexpr (std::is_integral_v<Value>) {
      for (const Value value : {Value(0), Value(-1), std::numeric_limits<Value>::max()}) offer(member, value);
    }
  });
  CHECK(offered - std::ssize(taken) > 30);
  REQUIRE(taken.size() > 60);
  const ScratchFolder folder;
  {
    Store store(folder.path / "store.sqlite", Store::Mode::write);
    store.save_study(stored);
    store.begin_session({});
    store.append(taken);
  }
  const Store store(folder.path / "store.sqlite", Store::Mode::read);
  CHECK(same_numbers(solves_of(store, study.name), taken));
  check_that_all_read(stored, store, folder.path);
}

TEST_CASE("a solve that no reader would take ends the run with its place, and those before are stored",
          "[own_solver]") {
  Study study = study_of_faulty("all_joints");
  study.solvers.front().solver = "newton";  // whose evaluations are always counted
  const StoredStudy stored = to_stored(study);
  Faulty::place = "", Faulty::asks = false;
  ScratchStore store;
  const auto request = RunRequest{.flush_interval = std::chrono::milliseconds(10'000)};
  CHECK_THAT(complaint<std::runtime_error>([&] { run(study, stored, store, request); }),
             ContainsSubstring("mine, run 1, point 2: it has 0 evaluations"));
  CHECK(solves_of(store, study.name).size() == 1);
  Faulty::asks = true;
}

TEST_CASE("an exception of a solver is told of with solver, run and point", "[own_solver]") {
  for (const char* place : {"start", "step", "best"}) {
    CHECK(statements_of<std::runtime_error>(place, [](Best&) { throw std::runtime_error("no"); }) ==
          "mine, run 1, point 2: no");
    CHECK(statements_of<std::invalid_argument>(place, [](Best&) { throw std::invalid_argument("not this"); }) ==
          "mine, run 1, point 2: not this");
    CHECK(statements_of<std::runtime_error>(place, [](Best&) { throw std::bad_alloc(); }) ==
          "mine, run 1, point 2: std::bad_alloc");
    CHECK_THAT(statements_of<std::runtime_error>(place, [](Best&) { throw 5; }), StartsWith("mine, run 1, point 2: "));
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
    CHECK(solves_of(Store(store, Store::Mode::read), study.name).size() <= 1);
  }
  CHECK(exit_code(in_a_process([&]() -> bool { std::exit(0); })) == 0);  // outside of a solve
}
