#include "analysis/inference/convergence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "analysis/figures/axis.hpp"
#include "analysis/figures/convergence_figures.hpp"
#include "analysis/inference/make_study.hpp"
#include "tests/analysis/drawn.hpp"
#include "tests/analysis/folder.hpp"
#include "tests/analysis/synthetic.hpp"
#include "tests/catch.hpp"
#include "tests/contains.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::inference;
using namespace ikbench::figures;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
const char* const with_tolerance = R"({"stop": {"tolerance_cm": 0.5}, "path": {"kind": "random"}, "start": "initial"})";

SolveRecord record_with_trace(std::vector<double> trace_cm, std::int64_t evaluations) {
  SolveRecord solve;
  solve.solver = "A";
  solve.evaluations = evaluations;
  solve.seconds = solve.cpu_seconds = 1e-6 * static_cast<double>(evaluations);
  solve.iterations = static_cast<std::int64_t>(trace_cm.size());
  if (!trace_cm.empty()) solve.position_error_cm = trace_cm.back();
  solve.trace_cm = std::move(trace_cm);
  return solve;
}

// A study of these alone, a run each.
StudyResults traced_study(std::vector<SolveRecord> solves) {
  for (std::size_t i = 0; i < solves.size(); ++i) solves[i].run = static_cast<int>(i) + 1;
  return make_study("s", std::move(solves));
}

// Errors that fall to the final one, as a trace of 40 iterations.
std::vector<SolveRecord> solves_with_traces(const synthetic::Shape& shape) {
  std::vector<SolveRecord> solves = synthetic::solves(shape);
  synthetic::Noise noise;
  for (SolveRecord& solve : solves) {
    solve.iterations = 40;
    const double speed = 0.1 + 0.2 * noise.next();
    for (int i = 1; i <= 40; ++i) solve.trace_cm.push_back(solve.position_error_cm + 50 * std::exp(-speed * i));
    solve.trace_cm.back() = solve.position_error_cm;
  }
  return solves;
}

std::vector<std::string> figure_names(const std::vector<Figure>& figures) {
  std::vector<std::string> names;
  for (const Figure& figure : figures) names.push_back(figure.name);
  return names;
}

const Figure& figure_named(const std::vector<Figure>& figures, const std::string& name) {
  const auto found = std::ranges::find(figures, name, &Figure::name);
  REQUIRE(found != figures.end());
  return *found;
}

bool all_drawn(const std::vector<Figure>& figures) {
  const ScratchFolder folder;
  const std::string failure = drawn_as_svg(figures, folder.path / "figures");
  for (const std::string& file : files_in(folder.path)) CHECK(file.starts_with("figures/"));
  CAPTURE(failure);
  CHECK(failure.empty());
  return failure.empty();
}

}  // namespace

TEST_CASE("a solve of one iteration has the course of its stored improvements", "[convergence]") {
  SolveRecord record = record_with_trace({0.5}, 60);  // as of a library
  record.improved_at = {1, 4, 6, 60};
  record.improved_to_cm = {9, 3, 0.7, 0.5};
  const StudyResults study = traced_study({record});
  const Solve& solve = study.solves.front();
  CHECK(evaluations_axis({{&solve}}).front() == 1);
  CHECK(error_bands({&solve}, std::vector<double>{5}).front().value == 3);
  CHECK(error_bands({&solve}, std::vector<double>{6}).front().value == 0.7);
}

TEST_CASE("a solve that ended before its first iteration has reached its error with all it cost", "[convergence]") {
  StudyResults study = traced_study({record_with_trace({}, 50)});
  Solve& solve = study.solves.to_change().front();
  solve.position_error_cm = 0.2;
  CHECK(has_trace(solve));
  CHECK(error_bands({&solve}, std::vector<double>{49}).front().value == censored);
  CHECK(error_bands({&solve}, std::vector<double>{50}).front().value == 0.2);
  solve.iterations = 7;  // went on, and nobody wrote down how
  CHECK(!has_trace(solve));
}

TEST_CASE("a trace whose answer the verifier does not confirm reaches nothing", "[convergence]") {
  StudyResults study = traced_study({record_with_trace({8, 3, 0.5}, 300)});
  Solve& solve = study.solves.to_change().front();
  for (const Status status : {Status::claimed_but_wrong, Status::refused, Status::not_finite, Status::crashed,
                              Status::timed_out, Status::broke_protocol, Status::declined}) {
    solve.status = status;
    CHECK(error_bands({&solve}, std::vector<double>{300}).front().value == censored);
  }
  for (const Status status : {Status::ok, Status::tolerance_missed, Status::limit_violated}) {
    solve.status = status;
    CHECK(error_bands({&solve}, std::vector<double>{100}).front().value == 8);
  }
}

TEST_CASE("the band at a number of evaluations is that of the errors that the solves had then", "[convergence]") {
  const StudyResults study =
      traced_study({record_with_trace({16, 8, 4, 2}, 400), record_with_trace({20, 10}, 200),
                    record_with_trace({12, 6, 3, 1}, 400), record_with_trace({40, 30, 20, 10}, 400)});
  const std::vector<statistics::Estimate> bands =
      error_bands(solves_by_solver(study)[0], std::vector<double>{99, 100, 250, 400});
  CHECK(bands[0].value == censored);  // before the first iteration is done
  // Type 5 of four values: the quartiles lie midway between neighbours. 12 16 20 40 at 100 evaluations.
  CHECK(bands[1].low == 14);
  CHECK(bands[1].value == 18);
  CHECK(bands[1].high == 30);
  // 8, 10 (it has ended), 6, 30 at 250.
  CHECK(bands[2].low == 7);
  CHECK(bands[2].value == 9);
  CHECK(bands[2].high == 20);
  // 2 10 1 10 at 400.
  CHECK(bands[3].low == 1.5);
  CHECK(bands[3].value == 6);
  CHECK(bands[3].high == 10);
}

TEST_CASE("an answer that is not finite is worse than every number, not left out of a band", "[convergence]") {
  const StudyResults study =
      traced_study({record_with_trace({1}, 10), record_with_trace({2}, 10), record_with_trace({not_a_number}, 10)});
  const statistics::Estimate band = error_bands(solves_by_solver(study)[0], std::vector<double>{10}).front();
  CHECK(band.value == 2);
  CHECK(band.high == censored);
}

TEST_CASE("every iteration counts as done at its own number of evaluations, whatever the rounding", "[convergence]") {
  for (const int n : {3, 7, 49, 200, 1000}) {
    std::vector<double> trace;
    for (int i = n; i > 0; --i) trace.push_back(i);
    const StudyResults study = traced_study({record_with_trace(trace, 12345)});
    const Solve& solve = study.solves.front();
    for (int i = 1; i <= n; ++i) {
      const double evaluations = 12345 * (static_cast<double>(i) / n);
      CHECK(error_bands({&solve}, std::vector<double>{evaluations}).front().value ==
            trace[static_cast<std::size_t>(i) - 1]);
    }
  }
}

TEST_CASE("the axis of evaluations goes from the cheapest first iteration to the dearest solve", "[convergence]") {
  const StudyResults study = traced_study({record_with_trace({3, 2, 1, 1, 1}, 60), record_with_trace({3, 2}, 5000)});
  const std::vector<double> axis = evaluations_axis({{&study.solves[0]}, {&study.solves[1]}});
  CHECK(axis.size() == 200);
  CHECK(axis.front() == 12);
  CHECK(axis.back() == 5000);
  CHECK(std::ranges::is_sorted(axis));
  const StudyResults single = traced_study({record_with_trace({3}, 60)});
  CHECK(evaluations_axis({{&single.solves[0]}}) == std::vector<double>{60});
  CHECK(evaluations_axis({{}, {}}).empty());
}

TEST_CASE("the share within a value counts what never comes in the whole alone", "[convergence]") {
  const std::vector<Share> shares = shares_within({3, censored, 1, 3});
  REQUIRE(shares.size() == 2);
  CHECK(shares[0].at == 1);
  CHECK(shares[0].share == 0.25);
  CHECK(shares[1].at == 3);
  CHECK(shares[1].share == 0.75);
  CHECK(shares_within({censored, censored}).empty());
  CHECK(shares_within({}).empty());
}

TEST_CASE("a distribution of many values is drawn at few positions, and is exact there", "[convergence]") {
  std::vector<double> values{0};
  for (int i = 1; i < 10000; ++i) values.push_back(i);
  const std::vector<Share> shares = shares_within(values);
  CHECK(shares.size() == 200);
  CHECK(shares.front().at == 0);
  CHECK(shares.front().share == 1e-4);
  CHECK(shares.back().at == 9999);
  CHECK(shares.back().share == 1);
  for (const Share& share : shares) CHECK(share.share == Approx((std::floor(share.at) + 1) / 10000).epsilon(1e-12));
}

TEST_CASE("the figures of convergence are those that a study has the data for", "[convergence]") {
  const auto names = [](std::vector<SolveRecord> solves, const char* definition) {
    StudyResults study = make_study("s", std::move(solves));
    study.facts = facts_of(definition);
    return figure_names(convergence_figures(study));
  };
  using Names = std::vector<std::string>;
  const synthetic::Shape two{.solvers = {"A", "B"}, .runs = 1};
  CHECK(names({}, "").empty());
  CHECK(names(synthetic::solves(two), "").empty());
  CHECK(names(synthetic::solves(two), with_tolerance) == Names{"statistics-solved-evaluations"});
  CHECK(names(solves_with_traces(two), "") == Names{"statistics-convergence"});
  CHECK(names(solves_with_traces(two), with_tolerance) ==
        Names{"statistics-convergence", "statistics-solved-evaluations"});
}

TEST_CASE("the trace of a pose is drawn as the error of the pose", "[convergence]") {
  StudyEntry entry{.name = "s", .definition = R"({"search": "pose", "stop": {"tolerance_cm": 0.5}})", .series = {}};
  const StudyResults study = make_study(entry, solves_with_traces({.solvers = {"A", "B"}, .runs = 2}));
  const std::vector<Figure> figures = convergence_figures(study);
  CHECK(contains(figure_named(figures, "statistics-convergence").caption,
                 "Best error of the pose [cm] against evaluations"));
  CHECK(contains(figure_named(figures, "statistics-convergence").settings, "error of the pose [cm]"));
}

TEST_CASE("success is drawn against the budget: failures count as never solved", "[convergence]") {
  // Two of four solves of A are ok after 100 and 400 evaluations; the others end earlier and fail, as do all of B.
  std::vector<SolveRecord> solves = synthetic::solves({.solvers = {"A", "B"}, .runs = 4, .points = 1});
  for (std::size_t i = 0; i < solves.size(); ++i) {
    solves[i].evaluations = std::array{100, 400, 50, 80}[i % 4];
    solves[i].status = i < 2 ? Status::ok : Status::tolerance_missed;
  }
  StudyResults study = make_study("s", std::move(solves));
  study.facts = facts_of(R"({"search": "pose", "start": "middle", "path": {"kind": "random"},
                         "stop": {"tolerance_cm": 0.1, "tolerance_deg": 2}})");
  const std::vector<Figure> figures = convergence_figures(study);
  // The corners of each solver's stairs, from the left edge to the right.
  using Stairs = std::vector<std::pair<double, double>>;
  const auto stairs = [&](const char* name) {
    std::istringstream lines(figure_named(figures, name).data);
    std::vector<Stairs> found;
    for (std::string line; std::getline(lines, line);) {
      std::istringstream numbers(line);
      std::pair<double, double> corner;
      if (line == "# A" || line == "# B") found.emplace_back();
      if (!line.starts_with('#') && numbers >> corner.first >> corner.second) found.back().push_back(corner);
    }
    return found;
  };
  const std::vector<Stairs> by_evaluations = stairs("statistics-solved-evaluations");
  REQUIRE(by_evaluations.size() == 2);
  const Stairs& a = by_evaluations[0];
  REQUIRE(a.size() == 6);
  CHECK(a.front().second == 0);
  CHECK(Stairs(a.begin() + 1, a.end() - 1) == Stairs{{100, 0}, {100, 0.25}, {400, 0.25}, {400, 0.5}});
  CHECK(a.back().second == 0.5);
  CHECK(std::ranges::all_of(by_evaluations[1], [](const auto& corner) { return corner.second == 0; }));
  CHECK(contains(figure_named(figures, "statistics-solved-evaluations").caption,
                 "within 0.1 cm and 2 deg, inside the joint limits"));
}

TEST_CASE("a caption says what the solves depend on", "[convergence]") {
  StudyResults study = make_study("s", solves_with_traces({.runs = 2}));
  study.facts = facts_of(R"({"path": {"kind": "helix"}, "start": "previous"})");
  const std::vector<Figure> chained = convergence_figures(study);
  CHECK(contains(figure_named(chained, "statistics-convergence").caption, "solves of a run depend on each other"));
  study.facts = facts_of(with_tolerance);
  const std::vector<Figure> independent = convergence_figures(study);
  CHECK(!contains(figure_named(independent, "statistics-convergence").caption, "depend on each other"));
}

TEST_CASE("solves without a trace among those with one are left out of the curves, and counted", "[convergence]") {
  std::vector<SolveRecord> solves = solves_with_traces({.solvers = {"A", "B"}, .runs = 1});
  solves[3].trace_cm.clear();
  const std::vector<Figure> figures = convergence_figures(make_study("s", std::move(solves)));
  CHECK(contains(figure_named(figures, "statistics-convergence").caption, "1 solves without a trace are left out"));
}

TEST_CASE("no curve of a large study has more than some hundred rows", "[convergence]") {
  const StudyResults study = make_study("s", solves_with_traces({.runs = 20}));
  for (const Figure& figure : convergence_figures(study)) {
    std::istringstream lines(figure.data);
    int rows = 0;
    for (std::string line; std::getline(lines, line);) rows = line.starts_with('#') ? 0 : rows + 1;
    CAPTURE(figure.name);
    CHECK(rows > 2);
    CHECK(rows <= static_cast<int>(2 * 200 + 2));
  }
}

TEST_CASE("figures of convergence are drawn of few, odd and hostile data too", "[convergence]") {
  const auto drawn = [](std::vector<SolveRecord> solves) {
    StudyResults study = make_study("s", std::move(solves));
    study.facts = facts_of(with_tolerance);
    return all_drawn(convergence_figures(study));
  };
  CHECK(drawn(solves_with_traces({.solvers = {"A"}, .runs = 1, .points = 1})));
  CHECK(drawn(solves_with_traces(
      {.solvers = {"`touch pwned`", "'; system('x'); '", "a\nb", "%d {}^a_b", "@svg", "\"", ""}, .runs = 1})));
  for (const double value : {0.0, not_a_number, 1e308, std::numeric_limits<double>::infinity(), -1.0, 1e-320}) {
    std::vector<SolveRecord> solves = solves_with_traces({.solvers = {"A", "B"}, .runs = 1, .points = 3});
    for (SolveRecord& solve : solves) {
      if (solve.solver == "B" && solve.point == 1) continue;
      solve.position_error_cm = solve.seconds = value;
      solve.trace_cm.assign(40, value);
      solve.evaluations = value > 1 ? std::numeric_limits<std::int64_t>::max() : 0;
    }
    CAPTURE(value);
    CHECK(drawn(solves));
  }
}

TEST_CASE("an axis of costs is wider than its values, and has round ticks", "[convergence]") {
  const Axis wide = ratio_axis(44, 22000, {});
  CHECK(wide.low < 44);
  CHECK(wide.high > 22000);
  CHECK(contains(wide.settings, "set logscale x"));
  CHECK(contains(wide.settings, "set xtics enhanced ('50' 50, '100' 100, '200' 200"));
  CHECK(contains(ratio_axis(3e-12, 0.02, {}).settings, "('10^{-12}' 1e-12, '10^{-10}' 1e-10"));
  CHECK(contains(ratio_axis(1000, 1100, {}).settings, "('1000' 1000, '1050' 1050, '1100' 1100)"));
  CHECK(contains(ratio_axis(censored, 0, {}).settings, "unset xtics"));  // nobody solves anything
}

TEST_CASE("a convergence curve ends with the longest solve of its solver, whatever others spend", "[convergence]") {
  std::vector<SolveRecord> solves{record_with_trace({4, 2, 1}, 300), record_with_trace({4, 2, 1}, 30000)};
  solves[1].solver = "B";
  solves[1].series = "b";
  const std::vector<Figure> figures = convergence_figures(make_study("s", std::move(solves)));
  std::istringstream lines(figure_named(figures, "statistics-convergence").data);
  std::vector<double> last;  // position of each curve
  for (std::string line; std::getline(lines, line);) {
    if (line == "# A" || line == "# B") last.push_back(0);
    if (!line.empty() && line[0] != '#') last.back() = std::stod(line);
  }
  REQUIRE(last.size() == 2);
  CHECK(last[0] >= 300);
  CHECK(last[0] < 320);  // the first position of the axis beyond it
  CHECK(last[1] == 30000);
}
