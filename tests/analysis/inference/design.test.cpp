// Solves of a study as observations, and as solves of the same problem.
#include "analysis/inference/design.hpp"

#include <cmath>
#include <set>

#include "analysis/inference/make_study.hpp"
#include "analysis/inference/study_facts.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::inference;

namespace {

struct Shape {
  std::string path = "helix";
  std::string start = "previous";
  int runs = 2;
  int points = 3;
};

// Solver A's error at run r and point p is 100 r + p, that of B twice as much. Targets differ from point to point, and
// on a random path from run to run; starts are the solver's own where solves are chained.
std::vector<SolveRecord> solves_of(const Shape& shape) {
  std::vector<SolveRecord> solves;
  for (const char* solver : {"A", "B"}) {
    for (int run = 1; run <= shape.runs; ++run) {
      for (int point = 1; point <= shape.points; ++point) {
        SolveRecord solve;
        solve.solver = solver;
        solve.run = run;
        solve.point = point;
        solve.target_position_m = {0.1 * point, shape.path == "random" ? 0.1 * run : 0, 0};
        solve.position_error_cm = (100.0 * run + point) * (solve.solver == "A" ? 1 : 2);
        solve.start_rad = {shape.start == "initial" ? 0 : solve.position_error_cm};
        solves.push_back(solve);
      }
    }
  }
  return solves;
}

StudyResults study_of(const Shape& shape, std::vector<SolveRecord> solves) {
  const std::string definition = R"({"path": {"kind": ")" + shape.path + R"("}, "start": ")" + shape.start +
                                 R"(", "runs": )" + std::to_string(shape.runs) + R"(, "points": )" +
                                 std::to_string(shape.points) + "}";
  StudyEntry entry{.name = "s", .definition = definition};
  std::set<std::string> labels;
  for (const SolveRecord& solve : solves) labels.insert(solve.solver);
  if (labels.empty()) labels = {"A", "B"};
  for (const std::string& label : labels) entry.series.push_back({.label = label});
  return make_study(entry, std::move(solves));
}

StudyResults study_of(const Shape& shape) { return study_of(shape, solves_of(shape)); }

// Judged with points as observations.
StudyResults by_point(StudyResults study) {
  study.plan.unit = Unit::point;
  return study;
}

constexpr Metric metric_of_errors = Metric::position_error_cm;
using Values = std::vector<double>;
using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("on a chained path observations are run means in independent groups, and there are no blocks", "[design]") {
  const StudyResults study = study_of({});
  const Observations found = observations(study, metric_of_errors);
  CHECK(found.name == "error");
  CHECK(found.quantity == "position error [cm]");
  CHECK(found.better == Better::smaller);
  REQUIRE(found.groups.size() == 2);
  CHECK(found.groups[0].name == "A");
  CHECK(found.groups[0].values == Values{102, 202});  // the means of 101 102 103 and of 201 202 203
  CHECK(found.groups[1].values == Values{204, 404});
  CHECK(found.blocks.empty());
  CHECK(found.block.empty());
  CHECK(found.replicate == "the mean of a run over its 3 points");
  CHECK(found.notes ==
        Names{"There are no blocks: each solve starts where the solver's previous answer left the arm."});
  CHECK(found.flaws.empty());
  CHECK(observations(study, metric_of_errors, Estimand::mean).blocks.empty());
  CHECK(words_of(why_not_blocked(study)) == found.notes.front());
}

TEST_CASE("points as observations have a flaw, and the report says which", "[design]") {
  const Observations found = observations(by_point(study_of({})), metric_of_errors);
  CHECK(found.groups[0].values == Values{101, 102, 103, 201, 202, 203});
  CHECK(words_of(found.flaws) ==
        "Points of one run depend on each other; used as observations because --force was given.");
  CHECK(observations(by_point(study_of({.path = "random"})), metric_of_errors).blocks.empty());
}

TEST_CASE("equal runs of a solver are one observation, and what is measured anew in each stays", "[design]") {
  std::vector<SolveRecord> solves = solves_of({.runs = 3});
  for (SolveRecord& solve : solves) {
    solve.seconds = solve.cpu_seconds = 0.1 * solve.run;
    if (solve.solver == "A") solve.position_error_cm = solve.start_rad[0] = 100.0 + solve.point;
    solve.answer_rad = {solve.position_error_cm};
  }
  const StudyResults study = study_of({.runs = 3}, solves);
  CHECK(repeats_itself(study, "A"));
  CHECK_FALSE(repeats_itself(study, "B"));
  const Observations found = observations(study, metric_of_errors);
  CHECK(found.groups[0].values == Values{102});
  CHECK(found.groups[1].values == Values{204, 404, 604});
  REQUIRE(found.notes.size() == 2);
  CHECK(found.notes[1].starts_with("Equal runs are one observation: A (3 runs) gave the same answers in every run"));
  CHECK(observations(study, Metric::seconds).groups[0].values.size() == 3);
  CHECK(observations(by_point(study), metric_of_errors).groups[0].values == Values{101, 102, 103});

  SECTION("one point of one run that differs makes all runs count") {
    for (SolveRecord& solve : solves) {
      if (solve.solver == "A" && solve.run == 2 && solve.point == 3) solve.answer_rad = {104};
    }
    CHECK_FALSE(repeats_itself(study_of({.runs = 3}, solves), "A"));
  }
  SECTION("another target makes another run") {
    for (SolveRecord& solve : solves) solve.target_position_m[1] = 0.1 * solve.run;
    CHECK_FALSE(repeats_itself(study_of({.runs = 3}, solves), "A"));
  }
}

TEST_CASE("a definition says whether targets were drawn, of any kind of path, older ones by the kind alone",
          "[design]") {
  CHECK(facts_of(R"({"path": {"kind": "spiral", "targets": "drawn"}})").draws_targets);
  CHECK(facts_of(R"({"path": {"kind": "random"}})").draws_targets);
  CHECK_FALSE(facts_of(R"({"path": {"kind": "spiral"}})").draws_targets);
  CHECK_FALSE(facts_of("{}").draws_targets);
}

TEST_CASE("targets drawn anew in every run make a block of each run", "[design]") {
  const StudyResults study = study_of({.path = "random", .runs = 3});
  const Observations found = observations(study, metric_of_errors);
  CHECK(found.blocks == Names{"run 1", "run 2", "run 3"});
  CHECK(found.groups[0].values == Values{102, 202, 302});
  CHECK(found.groups[1].values == Values{204, 404, 604});
  CHECK(found.replicate == "the mean of a run over its 3 points");
  CHECK(found.block == "a run with its own random targets, the same for all solvers");
}

TEST_CASE("drawn targets that are solved from the same configuration are blocks each", "[design]") {
  const StudyResults study = study_of({.path = "random", .start = "initial", .runs = 1});
  const Observations found = observations(study, metric_of_errors, Estimand::mean);
  CHECK(found.blocks == Names{"run 1, point 1", "run 1, point 2", "run 1, point 3"});
  CHECK(found.groups[1].values == Values{202, 204, 206});
  CHECK(found.replicate == "the only solve of a target");
  CHECK(observations(study, metric_of_errors).blocks == found.blocks);
  CHECK(observations(by_point(study), metric_of_errors).blocks.empty());
}

TEST_CASE("targets of a path that are solved from the same configuration are blocks, with the mean over the runs",
          "[design]") {
  const StudyResults study = study_of({.start = "initial"});
  const Observations found = observations(study, metric_of_errors, Estimand::mean);
  CHECK(found.blocks == Names{"point 1", "point 2", "point 3"});
  CHECK(found.groups[0].values == Values{151, 152, 153});  // of 101 and 201, ...
  CHECK(found.replicate == "the mean of a target over 2 runs");
  CHECK(observations(study, metric_of_errors).blocks == found.blocks);
  CHECK(observations(study, metric_of_errors).groups[0].values == found.groups[0].values);
  std::vector<SolveRecord> solves = solves_of({.points = 1});  // nothing is chained to
  for (SolveRecord& solve : solves) solve.start_rad = {0};
  CHECK(words_of(why_not_blocked(study_of({.points = 1}, solves))) ==
        "There are no blocks to compare, because there is only one.");
}

TEST_CASE("a run that is not complete for all solvers is in no block, and that is said", "[design]") {
  for (const Shape& shape : {Shape{.path = "random", .runs = 3}, Shape{.start = "initial", .runs = 3}}) {
    CAPTURE(shape.path);
    std::vector<SolveRecord> solves = solves_of(shape);
    solves.pop_back();  // B's last point of run 3
    const StudyResults study = study_of(shape, solves);
    const Observations found = observations(study, metric_of_errors, Estimand::mean);
    CHECK(found.groups[0].values == (shape.path == "random" ? Values{102, 202} : Values{151, 152, 153}));
    CHECK(found.groups[0].values.size() == found.blocks.size());
    CHECK(found.notes == Names{"Left out: 1 of 3 runs, because they are not complete for all solvers."});
  }
  std::vector<SolveRecord> solves = solves_of({});
  solves.pop_back();
  const Observations independent = observations(study_of({}, solves), metric_of_errors);
  CHECK(independent.groups[0].values == Values{102, 202});  // A loses nothing by what B has not done
  CHECK(independent.notes.back() == "B: 1 of its runs lack points and give no observation.");
}

TEST_CASE("with fewer than two blocks there is no blocked design, and why is said", "[design]") {
  CHECK(words_of(why_not_blocked(study_of({.path = "random", .runs = 1}))) ==
        "There are no blocks to compare, because there is only one.");
  const Observations alone = observations(study_of({.path = "random", .runs = 1}), metric_of_errors);
  CHECK(alone.groups[0].values == Values{102});
  CHECK(alone.notes == Names{"There are no blocks to compare, because there is only one."});
  CHECK(observations(by_point(study_of({.path = "random", .runs = 1})), metric_of_errors).notes.empty());
  std::vector<SolveRecord> solves = solves_of({.path = "random", .runs = 1});
  solves.pop_back();
  CHECK(words_of(why_not_blocked(study_of({.path = "random", .runs = 1}, solves))) ==
        "There are no blocks: no run is complete for all solvers.");
  CHECK(!why_not_blocked(study_of({.path = "random"}, {})).empty());
  CHECK(observations(study_of({.path = "random"}, {}), metric_of_errors).groups.size() == 2);
  CHECK(words_of(why_not_blocked(make_study("a CSV", solves_of({})))) ==
        "There are no blocks: the study does not state its path.");
}

TEST_CASE("a store that claims the same targets for all, and has others, has no blocks", "[design]") {
  std::vector<SolveRecord> solves = solves_of({.path = "random"});
  solves.back().target_position_m[2] = 1e-9;
  CHECK(words_of(why_not_blocked(study_of({.path = "random"}, solves))) ==
        "There are no blocks: the solvers did not have the same targets and starts.");
  solves = solves_of({.start = "initial"});
  solves.back().start_rad = {0.1};
  CHECK(observations(study_of({.start = "initial"}, solves), metric_of_errors, Estimand::mean).blocks.empty());
}

TEST_CASE("what is not finite stays in its place and is counted, and times that are not clean are said", "[design]") {
  std::vector<SolveRecord> solves = solves_of({.path = "random"});
  solves[0].position_error_cm = std::nan("");
  solves[1].timing = Timing::parallel;
  const StudyResults study = study_of({.path = "random"}, solves);
  const Observations found = observations(study, metric_of_errors);
  CHECK(std::isnan(found.groups[0].values[0]));
  CHECK(found.groups[0].values[1] == 202);
  CHECK(found.notes == Names{"A: 1 of 2 observations is not finite and worse than any number; differences of means are "
                             "those of finite observations."});
  const Observations times = observations(study, Metric::seconds);
  CHECK(times.name == "time");
  CHECK((words_of(times.flaws).starts_with("Times are not comparable: of 12 solves, 1 ran in parallel")));
}

TEST_CASE("every measure is read as a name with its unit, and has a name of its own for files", "[design]") {
  std::set<std::string_view> slugs;
  for (const Metric metric : {Metric::position_error_cm, Metric::variation_deg, Metric::seconds, Metric::evaluations}) {
    CHECK(quantity(metric).starts_with(info_of(metric).name));
    CHECK(slugs.insert(info_of(metric).slug).second);
    CHECK(info_of(metric).slug.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string_view::npos);
  }
  CHECK(quantity(Metric::variation_deg) == "angles variation [deg]");  // Table 3
}
