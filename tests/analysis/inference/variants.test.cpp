// Two variants of a solver, judged as a report judges a study of the two.
#include "analysis/inference/variants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "analysis/inference/judged_study.hpp"
#include "analysis/report/variants_table.hpp"
#include "results/analysis_plan_fields.hpp"
#include "tests/analysis/cells.hpp"
#include "tests/analysis/inference/variant_samples.hpp"
#include "tests/catch.hpp"
#include "tests/results/samples.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::statistics;
using namespace ikbench::inference;
using namespace ikbench::report;
using namespace ikbench::variant_samples;

namespace {

std::string verdict_of(const VariantComparison& comparison) {
  const std::vector<VariantComparison> all{comparison};
  return variants_verdict(all, AnalysisPlan{});
}

std::string remark_of(const MetricComparison& metric) {
  const std::vector<VariantComparison> all{{.label = "mine", .metrics = {metric}}};
  const Table table = variants_table(all, AnalysisPlan{});
  return is_empty(table, 0, "remark") ? "" : std::get<std::string>(cell_at(table, 0, "remark"));
}

const MetricComparison& metric_of(const VariantComparison& comparison, Metric metric) {
  return *std::ranges::find(comparison.metrics, metric, &MetricComparison::metric);
}

std::string refusal(const Variant& a, const Variant& b) {
  try {
    compared(a, b);
  } catch (const std::invalid_argument& refused) {
    return refused.what();
  }
  return "";
}

Variant drawn(const std::vector<double>& errors_cm) {
  std::vector<SolveRecord> solves;
  for (const double error : errors_cm) {
    solves.push_back(solve_of(static_cast<int>(solves.size()) + 1, error));
    draw_target(solves.back());
  }
  return variant_of(std::move(solves), drawn_targets);
}

// Runs that repeat one answer.
Variant repeating(double error_cm) {
  return variant(
      {.runs = 20,
       .points = 2,
       .definition = R"({"points": 2, "runs": 20, "path": {"kind": "helix"}, "start": "previous"})"},
      [=](int, int) { return error_cm; },
      [](SolveRecord& solve) {
        solve.answer_rad = {1, 2};
      });
}

}  // namespace

TEST_CASE("what compare says of a metric is what a report says of it", "[variants]") {
  // Over many made-up pairs, with and without blocks, skewed, tied, nearly alike, and some with lost answers.
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform;
  std::normal_distribution<double> normal;
  int decided = 0, alike = 0, with_lost = 0;
  for (int repetition = 0; repetition < 500; ++repetition) {
    const int n = 3 + static_cast<int>(uniform(random) * 20);
    const double apart = 0.4 * normal(random), spread = 0.5 * uniform(random), ties = uniform(random) < 0.3 ? 5 : 1e9;
    const double lost_a = uniform(random) < 0.3 ? 0.1 : 0, lost_b = uniform(random) < 0.3 ? uniform(random) : 0;
    const auto lose = [&](double& value, double share) {
      if (uniform(random) < share)
        value = uniform(random) < 0.5 ? not_defined : std::numeric_limits<double>::infinity();
    };
    std::vector<double> of_a, of_b;
    for (int i = 0; i < n; ++i) {
      const double shared = std::exp(0.3 * normal(random));
      of_a.push_back(std::ceil(ties * shared * std::exp(spread * normal(random))) / ties);
      of_b.push_back(std::ceil(ties * shared * std::exp(apart + spread * normal(random))) / ties);
      lose(of_a.back(), lost_a);
      lose(of_b.back(), lost_b);
    }
    const bool in_blocks = repetition % 2 == 0;
    const Variant a = in_blocks ? drawn(of_a) : variant(of_a), b = in_blocks ? drawn(of_b) : variant(of_b);
    CAPTURE(repetition, n, in_blocks);
    const VariantStudy both = study_of_both(a, b, {});
    const Finding in_report = JudgedStudy(both.study).evidence(Metric::position_error_cm).contrasts.front();
    const MetricComparison compared_alone = error_of(a, b);
    CHECK(compared_alone.finding().relation == in_report.relation);
    CHECK(compared_alone.finding().is_fact == in_report.is_fact);  // where ties made them equal
    CHECK(compared_alone.finding().is_within_margin() == in_report.is_within_margin());
    if (!std::isnan(in_report.p)) CHECK(compared_alone.finding().p == in_report.p);
    const bool is_lost = !std::ranges::all_of(of_a, [](double value) { return std::isfinite(value); });
    with_lost += is_lost && is_decided(in_report) ? 1 : 0;
    // Among several metrics less is decided; nothing else changes.
    const MetricComparison among = compared(a, b).metrics.front();
    if (is_decided(among.finding())) CHECK(among.finding().relation == in_report.relation);
    CHECK((among.finding().relation == Relation::undefined) == (in_report.relation == Relation::undefined));
    decided += is_decided(compared_alone.finding()) ? 1 : 0;
    alike += compared_alone.finding().relation == Relation::undecided ? 1 : 0;
  }
  CHECK(decided > 100);
  CHECK(alike > 100);
  CHECK(with_lost > 10);
}

TEST_CASE("identical variants are the same to the bit in every metric", "[variants]") {
  for (const std::vector<double>& errors :
       std::vector<std::vector<double>>{about(1, 0.5), {1}, {0, 0}, {not_defined, 1}}) {
    const VariantComparison comparison = compared(variant(errors), variant(errors));
    REQUIRE(comparison.metrics.size() == compared_metrics().size());
    for (const MetricComparison& metric : comparison.metrics) {
      CHECK(metric.finding().relation == Relation::same);
      CHECK(remark_of(metric) == "equal bit for bit");
      CHECK(metric.finding().is_fact);
    }
    CHECK(verdict_of(comparison) ==
          "No regression beyond 5 % (shares: 5 percentage points). Of 5 comparisons: 5 the same, bit for bit.");
  }
}

TEST_CASE("a difference beyond the margin is a regression, one on both sides of it is not", "[variants]") {
  const Variant a = variant(about(1, 0.1));
  CHECK(is_regression(error_of(a, variant(about(2, 0.1)))));
  CHECK(!is_regression(error_of(variant(about(2, 0.1)), a)));
  const MetricComparison across = error_of(a, variant(about(1.07, 0.1)));
  CHECK(across.finding().relation == Relation::better);
  CHECK(across.finding().is_across_margin());
  CHECK(!is_regression(across));
  CHECK(is_open(across));
  const MetricComparison less = error_of(a, variant(about(1.2, 0.1)), {.margin = 0.5});
  CHECK(less.finding().relation == Relation::better);
  CHECK(less.finding().is_within_margin());
  CHECK(!is_open(less));
  CHECK(!is_regression(error_of(a, variant(about(1.2, 0.1)), {.margin = 0, .margin_cm = 1})));
}

TEST_CASE("answers that are not finite are worse than numbers, but one of twenty may be chance", "[variants]") {
  const auto failing = [](int failures) {
    std::vector<double> errors = about(1, 0.1);
    for (int i = 0; i < failures; ++i) errors[static_cast<std::size_t>(i)] = std::numeric_limits<double>::infinity();
    return variant(errors);
  };
  const Variant a = variant(about(1, 0.1));
  const MetricComparison many = error_of(a, failing(10));
  CHECK(is_regression(many));
  CHECK(remark_of(many).starts_with("not finite: 10 of 20 runs of B"));
  CHECK(is_open(error_of(a, failing(1))));
  CHECK(error_of(failing(10), a).finding().relation == Relation::worse);
  // Fewer values, and better ones: neither is better.
  std::vector<double> fewer = about(0.2, 0.01);
  for (std::size_t i = 0; i < 10; ++i) fewer[i] = not_defined;
  CHECK(is_open(error_of(a, variant(fewer))));
  // Nothing is finite on one side.
  CHECK(is_regression(error_of(a, variant(std::vector<double>(20, not_defined)))));
}

TEST_CASE("a share of a mean is no margin where values may be negative", "[variants]") {
  const auto varied = [](SolveRecord& solve) { solve.variation_deg = solve.position_error_cm; };
  const Variant a = variant(about(0.1, 1), varied), b = variant(about(5, 1), varied);
  const MetricComparison without = compared(a, b, {"variation_deg"}).metrics.front();
  CHECK(!without.is_compared());
  CHECK_THAT(remark_of(without), ContainsSubstring("negative"));
  CHECK(is_regression(compared(a, b, {"variation_deg"}, {.margin = 0}).metrics.front()));
}

TEST_CASE("times in blocks, and a plan of ranks, can be a regression", "[variants]") {
  const auto with = [](double factor, const std::string& plan) {
    std::vector<SolveRecord> solves;
    for (int run = 1; run <= 40; ++run) {
      solves.push_back(solve_of(run, factor * (1 + 0.01 * (run % 7))));
      const double own = factor > 1 ? 1 + 0.001 * (run % 3) : 1;
      solves.back().seconds = solves.back().cpu_seconds = 0.001 * factor * own * (1 + 0.01 * (run % 5));
      draw_target(solves.back());
    }
    return variant_of(
        std::move(solves),
        fmt::format(R"({{"points": 1, "runs": 40, "path": {{"kind": "random"}}, "start": "initial"{}}})", plan));
  };
  const std::string ranks = R"(, "analysis": {"test": "kruskal_wallis"})";
  for (const std::string& plan : {std::string(), ranks}) {
    const VariantComparison slower = compared(with(1, plan), with(10, plan), {"seconds", "position_error_cm"});
    for (const MetricComparison& metric : slower.metrics) CHECK(is_regression(metric));
    const Finding of_times = slower.metrics[0].finding();
    CHECK((plan == ranks ? of_times.ratio : of_times.estimate).value == Approx(0.1).epsilon(0.1));
    const VariantComparison barely = compared(with(1, plan), with(1.02, plan), {"seconds"});
    CHECK(barely.metrics[0].finding().relation == Relation::better);
    CHECK(barely.metrics[0].finding().is_within_margin());
  }
}

TEST_CASE("a plan without means is compared by what it has", "[variants]") {
  const auto of = [&](double factor) {
    return variant({.runs = 20, .points = 1}, [=](int run, int) { return factor * (1 + 0.02 * run); });
  };
  const MetricComparison typical = error_of(of(1), of(3), {.estimands = {Estimand::typical}});
  CHECK(typical.estimand == Estimand::typical);
  CHECK(is_regression(typical));
  CHECK(typical.evidence.groups[1].described.mean / typical.evidence.groups[0].described.mean == Approx(3));
  // None of 20 runs is within the distance: shares of 0, which are no rounding errors.
  const MetricComparison share = error_of(of(1), of(3), {.estimands = {Estimand::reliability}});
  CHECK(share.evidence.groups[0].described.mean == 0);
  CHECK(share.finding().relation == Relation::undecided);
  CHECK(remark_of(share).find("rounding") == std::string::npos);
}

TEST_CASE("copies of an answer that is not finite are the worse ones", "[variants]") {
  const double infinite = std::numeric_limits<double>::infinity();
  CHECK(error_of(repeating(infinite), repeating(1)).finding().relation == Relation::worse);
  CHECK(is_regression(error_of(repeating(1), repeating(infinite))));
}

TEST_CASE("arms of one name with other links are not compared", "[variants]") {
  const auto with = [](const std::string& links) {
    return variant({.runs = 3,
                    .points = 1,
                    .definition = fmt::format(R"({{"points": 1, "runs": 3, "arm": {{"links": {}}}}})", links)},
                   [](int, int) { return 1.0; });
  };
  CHECK_THAT(refusal(with("[1]"), with("[2]")), ContainsSubstring("arms of one name, whose links differ"));
  CHECK(refusal(with("[1]"), with("[1]")).empty());
}

TEST_CASE("several metrics are tested at Holm's levels", "[variants]") {
  const auto more_evaluations = [](SolveRecord& solve) { solve.evaluations = 150 + solve.run; };
  const auto some_evaluations = [](SolveRecord& solve) { solve.evaluations = 100 + solve.run; };
  const Variant a = variant(about(1, 0.3), some_evaluations), b = variant(about(1.1, 0.3), more_evaluations);
  const VariantComparison both = compared(a, b, {"position_error_cm", "evaluations"});
  CHECK(metric_of(both, Metric::evaluations).level() == Approx(0.025));       // the smallest p first
  CHECK(metric_of(both, Metric::position_error_cm).level() == Approx(0.05));  // what is left
  CHECK(is_regression(metric_of(both, Metric::evaluations)));
}

TEST_CASE("of variants that repeat themselves the difference is a fact, and no p is made of copies", "[variants]") {
  const auto told = [](double error_cm) { return error_of(repeating(1), repeating(error_cm)); };
  CHECK(is_regression(told(2)));
  CHECK(told(0.5).finding().relation == Relation::worse);
  CHECK(told(1.01).finding().relation == Relation::same);
  CHECK(told(2).finding().is_fact);
  CHECK(remark_of(told(2)) == "all runs of each are equal: a fact of these targets, without a test");
  CHECK_THAT(verdict_of(compared(repeating(1), repeating(2), {"position_error_cm"})),
             ContainsSubstring("Regression beyond 5 %: position_error_cm (from 1 to 2, 2 times A's, no test)"));
}

TEST_CASE("poses are compared by their orientation too, where no metric is named", "[variants]") {
  const auto columns = [](const std::string& definition) {
    const Variant each = variant({.runs = 3, .points = 1, .definition = definition}, [](int run, int) { return run; });
    std::vector<Metric> result;
    for (const MetricComparison& metric : compared(each, each).metrics) result.push_back(metric.metric);
    return result;
  };
  CHECK(columns(R"({"points": 1, "runs": 3})").size() == compared_metrics().size());
  CHECK(columns(R"({"points": 1, "runs": 3, "search": "pose"})")[1] == Metric::orientation_error_deg);
}

TEST_CASE("times are compared where both are clean and of one session", "[variants]") {
  const auto slower = [](SolveRecord& solve) { solve.cpu_seconds = solve.seconds *= 10; };
  const Variant a = variant(about(1, 0.1)), b = variant(about(1, 0.1), slower);
  CHECK(compared(a, b, {"seconds"}).metrics.front().finding().relation == Relation::better);
  const auto refused = [&](const Variant& other) {
    const VariantComparison comparison = compared(a, other, {"seconds"});
    CHECK(!comparison.metrics.front().is_compared());
    CHECK(is_open(comparison.metrics.front()));
    return fmt::format("{}", fmt::join(comparison.notes, "\n"));
  };
  const Variant parallel = variant(about(1, 0.1), [](SolveRecord& solve) { solve.timing = Timing::parallel; });
  CHECK_THAT(refused(parallel), ContainsSubstring("Times are not comparable: of 40 solves, 20 ran in parallel"));
  Variant elsewhere = b;
  elsewhere.sessions[0].environment["cpu"] = "another";
  CHECK_THAT(refused(elsewhere), ContainsSubstring("different machines (another, one)"));
  elsewhere.sessions[0].environment.erase("cpu");
  CHECK_THAT(refused(elsewhere), ContainsSubstring("do not name the CPU"));
  elsewhere.sessions.clear();
  CHECK_THAT(refused(elsewhere), ContainsSubstring("do not name the CPU"));
  Variant later = b;
  later.sessions[0].environment["date"] = "tomorrow";
  CHECK_THAT(refused(later), ContainsSubstring("separate sessions"));
}

TEST_CASE("a program's times and claims are held against no numbers of ours", "[variants]") {
  const auto is_program = [](SolveRecord& solve) {
    solve.timing = Timing::process;
    solve.counted_by = CountedBy::solver;
    solve.evaluations = 1;
  };
  const Variant ours = variant(about(1, 0.1)), program = variant(about(1, 0.1), is_program);
  const VariantComparison comparison = compared(ours, program, {"seconds", "evaluations"});
  for (const MetricComparison& metric : comparison.metrics) CHECK(!metric.is_compared());
  const std::string notes = fmt::format("{}", fmt::join(comparison.notes, "\n"));
  CHECK_THAT(notes, ContainsSubstring("have messages and another process in them"));
  CHECK_THAT(notes, ContainsSubstring("Evaluations of B are not compared: these were counted by the solver itself"));
}

TEST_CASE("evaluations that nobody counted are no regression, and solves without an answer are told", "[variants]") {
  const auto uncounted = [](SolveRecord& solve) {
    solve.counted_by = CountedBy::nobody;
    solve.evaluations = 0;
    if (solve.run <= 3) solve.status = solve.run == 3 ? Status::timed_out : Status::crashed;
  };
  const Variant a = variant(about(1, 0.1)), b = variant(about(1, 0.1), uncounted);
  for (const auto& [first, second] : {std::pair(a, b), std::pair(b, a)}) {
    const VariantComparison comparison = compared(first, second, {"evaluations"});
    CHECK(!comparison.metrics.front().is_counted);
    CHECK(!is_open(comparison.metrics.front()));
    CHECK(remark_of(comparison.metrics.front()) == "nobody counted");
    CHECK(verdict_of(comparison) ==
          "No regression beyond 5 % was found. Of 1 comparison: 1 not compared: nobody counted.");
  }
  CHECK_THAT(fmt::format("{}", fmt::join(compared(a, b).notes, "\n")),
             ContainsSubstring("Solves without an answer: none of A's 20; 3 of B's 20 (crashed 2, timed_out 1)."));
}

TEST_CASE("what was not given the same to do is refused", "[variants]") {
  const Variant a = variant(about(1, 0.1));
  const auto changed = [&](const Change& change) { return refusal(a, variant(about(1, 0.1), change)); };
  CHECK_THAT(changed([](SolveRecord& solve) { solve.robot = "other"; }),
             ContainsSubstring("cannot compare A and B: they have different robots (arm and other)"));
  CHECK_THAT(changed([](SolveRecord& solve) { solve.target_position_m[0] = 0.5; }),
             ContainsSubstring("different targets (run 1, point 1: 60 20 10 cm and 50 20 10 cm)"));
  CHECK_THAT(changed([](SolveRecord& solve) {
               solve.start_rad = {1, 0};
             }),
             ContainsSubstring("different start configurations (run 1, point 1)"));
  Variant empty = variant(std::vector<double>{});
  empty.series.label = "theirs";
  CHECK_THAT(refusal(a, empty), ContainsSubstring("B has no complete run of theirs, so there is nothing to compare"));
  const Variant longer = variant({.runs = 20, .points = 2, .definition = "{}"}, [](int, int) { return 1.0; });
  CHECK_THAT(refusal(a, longer), ContainsSubstring("different targets (1 and 2 points per run)"));
}

TEST_CASE("runs that only one side has are left out of pairs, and told", "[variants]") {
  const VariantComparison comparison = compared(drawn(about(1, 0.1)), drawn({1, 1.1, 1.2}), {"position_error_cm"});
  CHECK(comparison.metrics.front().evidence.groups[0].described.n == 3);
  CHECK(variants_notes({&comparison, 1}).front() ==
        "3 pairs of targets: one observation is the only solve of a target; a pair is a random "
        "target, the same for all solvers.");
  CHECK(std::ranges::count(comparison.notes,
                           "Left out: 17 of 20 runs, because they are not complete for all solvers.") == 1);
}

TEST_CASE("a metric that there is not is refused, and one named twice is compared once", "[variants]") {
  const Variant a = variant(about(1, 0.1));
  CHECK_THROWS_WITH(compared(a, a, {"speed"}), ContainsSubstring("unknown metric \"speed\""));
  CHECK(compared(a, a, {"solved", "seconds", "solved"}).metrics.size() == 2);
}

TEST_CASE("the table has a row for every label and metric, and facts have no p", "[variants]") {
  const std::vector<VariantComparison> comparisons{compared(variant(about(1, 0.1)), variant(about(2, 0.1)))};
  const AnalysisPlan by_default;
  const Table table = variants_table(comparisons, by_default);
  REQUIRE(table.rows.size() == 5);
  CHECK(std::get<std::string>(cell_at(table, 0, "B_is")) == "worse by more than 5 %");
  CHECK(number_at(table, 0, "B_by_A") == Approx(2));
  CHECK(number_at(table, 0, "low") < 2);
  CHECK(number_at(table, 0, "high") > 2);
  CHECK(number_at(table, 0, "a12") == 0);  // none of B's is better
  CHECK_FALSE(is_empty(table, 0, "p"));
  CHECK(std::get<std::string>(cell_at(table, 1, "remark")) == "equal bit for bit");
  CHECK(is_empty(table, 1, "p"));
  const Table in_short = short_table(table);
  CHECK(in_short.columns ==
        std::vector<std::string>{"label", "metric", "B_is", "mean_A", "mean_B", "B_by_A", "interval", "p"});
  CHECK(std::get<Range>(cell_at(in_short, 0, "interval")).low == number_at(table, 0, "low"));
  CHECK(is_empty(in_short, 1, "interval"));
  const std::string json = variants_json(comparisons, by_default, {"worse", 3});
  CHECK_THAT(
      json,
      ContainsSubstring(
          R"("verdict": "Regression beyond 5 % (shares: 5 percentage points): position_error_cm (from 1 to 2, 2 times A's, interval 1.)"));
  CHECK_THAT(json, ContainsSubstring(R"("p": null)"));
}

TEST_CASE("in a study with a tolerance, a variant that solves nothing is not cheaper", "[variants]") {
  const Solved shape{
      .runs = 20,
      .definition =
          R"({"points": 1, "runs": 20, "path": {"kind": "helix"}, "start": "previous", "stop": {"tolerance_cm": 0.1}})"};
  const auto spent = [](SolveRecord& solve) { solve.evaluations = 100 + solve.run; };
  const auto returns_the_start = [](SolveRecord& solve) {
    solve.status = Status::tolerance_missed;
    solve.evaluations = 1;
    solve.variation_deg = 0;
  };
  const VariantComparison comparison = compared(variant(
                                                    shape, [](int, int) { return 0.01; }, spent),
                                                variant(
                                                    shape, [](int, int) { return 5.0; }, returns_the_start),
                                                {"evaluations", "variation_deg"});
  for (const MetricComparison& metric : comparison.metrics) CHECK(metric.finding().relation == Relation::better);
  CHECK(metric_of(comparison, Metric::evaluations).evidence.groups[1].described.mean ==
        Approx(10 * 120));  // of the dearest solve, which took 120
  CHECK_THAT(fmt::format("{}", fmt::join(comparison.notes, " ")),
             ContainsSubstring("10 times what the dearest solve of A and B cost, 120"));
  const Variant solved = variant(
      shape, [](int, int) { return 0.01; }, spent);
  CHECK_THAT(fmt::format("{}", fmt::join(compared(solved, solved, {"evaluations"}).notes, " ")),
             !ContainsSubstring("without status ok"));
}

TEST_CASE("equal solves are the same only where they are judged alike", "[variants]") {
  const auto study = [](const char* stop) {
    return Solved{.runs = 20,
                  .definition = fmt::format(R"({{"points": 1, "runs": 20, "path": {{"kind": "helix"}},
                                                "start": "previous", "stop": {{{}}}}})",
                                            stop)};
  };
  const auto spent = [](SolveRecord& solve) { solve.evaluations = 100 + solve.run; };
  const auto missed = [&](SolveRecord& solve) {
    spent(solve);
    solve.status = Status::tolerance_missed;
  };
  const auto error = [](int, int) { return 0.2; };
  const VariantComparison comparison = compared(variant(study(R"("tolerance_cm": 0.1)"), error, missed),
                                                variant(study(""), error, spent), {"evaluations"});
  CHECK(remark_of(metric_of(comparison, Metric::evaluations)) != "equal bit for bit");
  CHECK(metric_of(comparison, Metric::evaluations).finding().relation == Relation::worse);
}

TEST_CASE("a store's labels become variants, each with its own solves and sessions", "[variants]") {
  const ScratchFolder folder;
  Store store(folder.path / "store.sqlite", Store::Mode::write);
  const StudyEntry study = sample_study();
  store.save_study(study);
  const std::int64_t first = store.begin_session({{"cpu", "one"}}), second = store.begin_session({{"cpu", "two"}});
  SolveRecord of_a = sample_record("key-a"), of_b = sample_record("key-b");
  of_a.session = first;
  of_b.session = second;
  store.append({of_a, of_b});
  const std::vector<Variant> found = variants(store, study);
  REQUIRE(found.size() == 2);
  CHECK(found[0].series.label == "IK-BA");
  std::vector<std::int64_t> sessions;
  found[1].each_solve([&](const SolveRecord& solve) { sessions.push_back(solve.session); });
  CHECK(sessions == std::vector{second});
}
