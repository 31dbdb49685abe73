#include "analysis/variants.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

#include "tests/analysis/cells.hpp"
#include "tests/analysis/synthetic.hpp"
#include "tests/catch.hpp"
#include "tests/results/samples.hpp"

using namespace ikbench;

namespace {

// One solve a run, clean, of one machine; every run has the same target.
SolveRecord solve_of(int run, double error_cm) {
  SolveRecord solve;
  solve.solver = "mine";
  solve.robot = "arm";
  solve.run = run;
  solve.target_position_m = {0.6, 0.2, 0.1};
  solve.target_rotation = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  solve.start_rad = {0, 0};
  solve.position_error_cm = error_cm;
  solve.variation_deg = 10;
  solve.evaluations = 100;
  solve.seconds = solve.cpu_seconds = 0.001 * run;
  solve.session = 1;
  return solve;
}

using Change = std::function<void(SolveRecord&)>;

Variant variant(const std::vector<double>& errors_cm, const Change& change = {}) {
  std::vector<SolveRecord> solves;
  for (const double error : errors_cm) {
    solves.push_back(solve_of(static_cast<int>(solves.size()) + 1, error));
    if (change) change(solves.back());
  }
  const Series series{.key = "key", .label = "mine", .algorithm = "bat", .options = R"({"alpha": "0.9"})"};
  const StudyEntry entry{
      .name = "study",
      .definition = fmt::format(R"({{"points": 1, "runs": {}, "stop": {{"iterations": 200}}}})", errors_cm.size()),
      .series = {series}};
  return {.series = series,
          .study = make_study(entry, std::move(solves)),
          .sessions = {{.id = 1, .environment = {{"cpu", "one"}, {"commit", "abc"}}}}};
}

// Every run has a target of its own.
void draw_target(SolveRecord& solve) { solve.target_position_m[0] = 0.01 * solve.run; }

VariantComparison compared(const Variant& a, const Variant& b, const std::vector<std::string>& metrics = {},
                           const MarginQuestion& question = {}) {
  return compare_variants(a, b, metrics, question);
}

// The error alone.
MetricComparison error_of(const Variant& a, const Variant& b, const MarginQuestion& question = {}) {
  return compared(a, b, {"position_error_cm"}, question).metrics.front();
}

const MetricComparison& metric_of(const VariantComparison& comparison, std::string_view name) {
  return *std::ranges::find(comparison.metrics, name, &MetricComparison::metric);
}

// Twenty values about `centre`, evenly within `spread` on either side.
std::vector<double> about(double centre, double spread) {
  std::vector<double> values;
  for (int i = 0; i < 20; ++i) values.push_back(centre + spread * ((i * 7 % 20) - 9.5) / 9.5);
  return values;
}

}  // namespace

TEST_CASE("a variant twice as far from its targets is worse, one half as far is better", "[variants]") {
  const Variant a = variant(about(1, 0.1)), b = variant(about(2, 0.2));
  const MetricComparison worse = error_of(a, b), better = error_of(b, a);
  CHECK(worse.outcome == Outcome::worse);
  CHECK(worse.ratio.ratio == Approx(2));
  CHECK(worse.p_worse < 1e-10);
  CHECK(worse.b_better.value == 0);  // every run of b is above every run of a
  CHECK(worse.remark.empty());
  CHECK(better.outcome == Outcome::better);
  CHECK(better.ratio.ratio == Approx(0.5));
  CHECK(better.b_better.value == 1);
}

TEST_CASE("a and b the other way round, what was worse is better", "[variants]") {
  synthetic::Noise noise;
  int decided = 0;
  for (int repetition = 0; repetition < 100; ++repetition) {
    std::vector<double> a, b;
    const double factor = std::exp(2 * noise.next() - 1);
    for (int run = 0; run < 8; ++run) {
      a.push_back(0.5 + noise.next());
      b.push_back(factor * (0.5 + noise.next()));
    }
    const auto is_drawn = repetition % 2 == 0 ? Change(draw_target) : Change();
    const MetricComparison there = error_of(variant(a, is_drawn), variant(b, is_drawn), {.margin = 0});
    const MetricComparison back = error_of(variant(b, is_drawn), variant(a, is_drawn), {.margin = 0});
    CHECK((there.outcome == Outcome::worse) == (back.outcome == Outcome::better));
    CHECK((there.outcome == Outcome::better) == (back.outcome == Outcome::worse));
    CHECK(there.ranks_favour == -back.ranks_favour);
    CHECK(there.p_worse == Approx(back.p_better).margin(1e-12));
    decided += there.outcome == Outcome::worse || there.outcome == Outcome::better ? 1 : 0;
  }
  CHECK(decided > 20);
  CHECK(decided < 100);
}

TEST_CASE("a margin is to be exceeded: 8 % more is worse by more than 5 %, and not by more than 10 %", "[variants]") {
  const Variant a = variant(about(1, 0.01)), b = variant(about(1.08, 0.01));
  CHECK(error_of(a, b, {.margin = 0.05}).outcome == Outcome::worse);
  CHECK(error_of(a, b, {.margin = 0.10}).outcome == Outcome::same);
}

TEST_CASE("equivalent is a claim that is shown, and few or wide runs do not show it", "[variants]") {
  CHECK(error_of(variant(about(1, 0.01)), variant(about(1.001, 0.01))).outcome == Outcome::same);
  const MetricComparison wide = error_of(variant(about(1, 0.5)), variant(about(1.001, 0.4)));
  CHECK(wide.outcome == Outcome::undecided);
  CHECK_THAT(wide.remark, ContainsSubstring("not told apart; about "));
  CHECK(wide.runs_to_decide > 20);
}

TEST_CASE("worse, but not shown to be by more than the margin, is undecided and says so", "[variants]") {
  // By hand: standard deviation of about(1, 0.04) 0.0249, standard error of the difference 0.0079; 0.05 is 6 of them
  // from 0, and the margin's end.
  const MetricComparison comparison = error_of(variant(about(1, 0.04)), variant(about(1.05, 0.04)));
  CHECK(comparison.outcome == Outcome::undecided);
  CHECK(comparison.remark.starts_with("worse, but not shown to be by more than 5 %"));
}

TEST_CASE("what is shown not to be worse by the margin need not be shown better or the same", "[variants]") {
  const MetricComparison comparison = error_of(variant(about(1, 0.04)), variant(about(0.95, 0.04)));
  CHECK(comparison.outcome == Outcome::not_worse);
  CHECK(comparison.remark.starts_with("better, but not shown to be by more than 5 %"));
}

TEST_CASE("as many runs as are said to decide do decide, mostly", "[variants]") {
  const MetricComparison few = error_of(variant(about(1, 0.3)), variant(about(1.15, 0.3)));
  REQUIRE(few.outcome == Outcome::undecided);
  // By hand: (1.645 + 0.842)^2 (s_b^2 + 1.05^2 s_a^2) / 0.1^2 with s = 0.3 * sqrt(665 / 19) / 9.5 = 0.18682 is 45.4;
  // Welch's test needs one more.
  CHECK(few.runs_to_decide == Approx(46).margin(1));
}

TEST_CASE("pairs of runs need as many as Student's test of pairs needs", "[variants]") {
  std::vector<double> a = about(1, 0.3), b;
  synthetic::Noise noise;
  for (const double value : a) b.push_back(1.06 * value + 0.2 * (noise.next() - 0.5));
  const MetricComparison comparison = error_of(variant(a, draw_target), variant(b, draw_target));
  REQUIRE(comparison.outcome == Outcome::undecided);
  std::vector<double> rest;
  for (std::size_t i = 0; i < a.size(); ++i) rest.push_back(b[i] - 1.05 * a[i]);
  const GroupSummary summary = summarise(rest);
  // (z_.95 + z_.8)^2 s^2 / d^2, and z_.95^2 / 2 more for t instead of z (Guenther, The American Statistician 35 (1981)
  // 243).
  const double normal = std::pow((1.64485 + 0.84162) * summary.std / summary.mean, 2);
  CHECK(comparison.runs_to_decide == Approx(normal + 1.64485 * 1.64485 / 2).margin(1.5));
}

TEST_CASE("pairs show what independent runs do not", "[variants]") {
  std::vector<double> a, b;
  for (int run = 1; run <= 10; ++run) {
    a.push_back(run);
    b.push_back(1.2 * run + (run % 2 == 0 ? 0.01 : -0.01));
  }
  const VariantComparison paired = compared(variant(a, draw_target), variant(b, draw_target), {"position_error_cm"});
  CHECK(paired.paired);
  CHECK(paired.metrics.front().outcome == Outcome::worse);
  CHECK_THAT(paired.design, ContainsSubstring("10 pairs of runs"));
  CHECK(paired.metrics.front().p_ranks == Approx(2 / 1024.0));  // all ten differences of one sign: 2 / 2^10
  const VariantComparison independent = compared(variant(a), variant(b), {"position_error_cm"});
  CHECK_FALSE(independent.paired);
  CHECK(independent.metrics.front().outcome == Outcome::undecided);
  CHECK_THAT(independent.design, ContainsSubstring("Independent runs, 10 of A and 10 of B"));
}

TEST_CASE("identical variants are the same to the bit in every metric", "[variants]") {
  for (const Change& change : {Change(), Change(draw_target)}) {
    for (const std::vector<double>& errors :
         std::vector<std::vector<double>>{about(1, 0.5), {1}, {0, 0}, {not_defined, 1}}) {
      const VariantComparison comparison = compared(variant(errors, change), variant(errors, change));
      REQUIRE(comparison.metrics.size() == compared_metrics.size());
      for (const MetricComparison& metric : comparison.metrics) {
        CHECK(metric.outcome == Outcome::same);
        CHECK(metric.remark == "to the bit");
        CHECK(std::isnan(metric.p_worse));
      }
      const std::vector<VariantComparison> all{comparison};
      CHECK(variants_verdict(all, {}) == "No regression beyond 5 %: none of 5 metrics is worse by more.");
    }
  }
}

TEST_CASE("what is constant in both is a fact, decided by the margin alone", "[variants]") {
  const auto evaluations = [](std::int64_t count) {
    return variant(about(1, 0.1), [count](SolveRecord& solve) { solve.evaluations = count; });
  };
  const auto outcome = [&](std::int64_t count) {
    const VariantComparison comparison = compared(evaluations(100), evaluations(count), {"evaluations"});
    CHECK(comparison.metrics.front().is_fact);
    return comparison.metrics.front().outcome;
  };
  CHECK(outcome(100) == Outcome::same);
  CHECK(outcome(105) == Outcome::same);  // at the margin, not beyond it
  CHECK(outcome(106) == Outcome::worse);
  CHECK(outcome(95) == Outcome::same);
  CHECK(outcome(94) == Outcome::better);
}

TEST_CASE("answers that only one of two has not finite are a fact against it", "[variants]") {
  std::vector<double> finite = about(1, 0.1), diverged = finite;
  diverged[3] = not_defined;
  const MetricComparison worse = error_of(variant(finite), variant(diverged));
  CHECK(worse.outcome == Outcome::worse);
  CHECK(worse.remark == "not finite: 0 of 20 runs of A, 1 of 20 of B");
  CHECK(error_of(variant(diverged), variant(finite)).outcome == Outcome::better);
  CHECK(error_of(variant({1}), variant({std::numeric_limits<double>::infinity()})).outcome == Outcome::worse);
}

TEST_CASE("where both have answers that are not finite, their numbers are compared", "[variants]") {
  std::vector<double> once = about(1, 0.1), often = once;
  once[0] = not_defined;
  for (std::size_t i = 0; i < 15; ++i) often[i] = not_defined;
  const MetricComparison worse = error_of(variant(once), variant(often));
  CHECK(worse.outcome == Outcome::worse);  // Fisher's exact test of 1 and 15 of 20: p = 1e-5
  CHECK(worse.p_worse < 1e-4);
  std::vector<double> twice = once;
  twice[1] = not_defined;
  const MetricComparison open = error_of(variant(once), variant(twice));
  CHECK(open.outcome == Outcome::undecided);
  CHECK(open.remark.starts_with("not finite: 1 of 20 runs of A, 2 of 20 of B"));
}

TEST_CASE("of a baseline whose mean is 0 there is no ratio, and the difference decides", "[variants]") {
  const auto share = [](int every) {
    return variant(about(1, 0.1), [every](SolveRecord& solve) {
      solve.status = solve.run % every == 0 ? Status::ok : Status::tolerance_missed;
    });
  };
  const VariantComparison better = compared(share(1000), share(2), {"solved"}),
                          worse = compared(share(2), share(1000), {"solved"});
  CHECK(better.metrics.front().outcome == Outcome::better);
  CHECK(std::isnan(better.metrics.front().ratio.ratio));
  CHECK(worse.metrics.front().outcome == Outcome::worse);
  CHECK(compared(share(1000), share(20), {"solved"}).metrics.front().outcome == Outcome::undecided);
}

TEST_CASE("more solves that are ok are better, not worse", "[variants]") {
  const Variant all = variant(about(1, 0.1)), none = variant(about(1, 0.1), [](SolveRecord&solve) {
                                                if (solve.run % 3 != 0) solve.status = Status::tolerance_missed;
                                              });
  const MetricComparison fewer = compared(all, none, {"solved"}).metrics.front();
  CHECK(fewer.outcome == Outcome::worse);
  CHECK(fewer.a.mean == 1);
  CHECK(fewer.b.mean == Approx(0.3));  // of the runs 1 to 20, six are multiples of 3
  CHECK(fewer.b_better.value == Approx(0.15));
  CHECK(compared(none, all, {"solved"}).metrics.front().outcome == Outcome::better);
}

TEST_CASE("errors that the verifier takes for rounding are the same", "[variants]") {
  CHECK(error_of(variant(about(1e-13, 1e-14)), variant(about(5e-13, 1e-14))).outcome == Outcome::same);
  CHECK(error_of(variant(about(1e-13, 1e-14)), variant(about(5e-3, 1e-4))).outcome == Outcome::worse);
}

TEST_CASE("of one run nothing can be said, and how to get more is", "[variants]") {
  for (const auto& [a, b] :
       {std::pair(about(1, 0.1), std::vector{3.0}), std::pair(std::vector{1.0}, std::vector{3.0})}) {
    const MetricComparison comparison = error_of(variant(a), variant(b));
    CHECK(comparison.outcome == Outcome::undecided);
    CHECK_THAT(comparison.remark, ContainsSubstring("--set runs=20"));
    CHECK(std::isnan(comparison.p_worse));
  }
}

TEST_CASE("worse is corrected for the number of metrics that are looked at", "[variants]") {
  // The ratio's p_above is between 0.05 / 5 and 0.05.
  const Variant a = variant(about(1, 0.3), [](SolveRecord& solve) { solve.variation_deg = 10 + solve.run; });
  const Variant b = variant(about(1.17, 0.3), [](SolveRecord& solve) {
    solve.variation_deg = 30.5 - solve.run;
    solve.evaluations += solve.run;
    solve.seconds *= 1.5;
    if (solve.run == 3) solve.status = Status::refused;
  });
  const MetricComparison alone = error_of(a, b);
  REQUIRE(alone.p_worse < 0.05);
  REQUIRE(alone.p_worse > 0.02);
  CHECK(alone.outcome == Outcome::worse);
  const MetricComparison among =
      metric_of(compared(a, b, {"variation_deg", "solved", "position_error_cm"}), "position_error_cm");
  CHECK(among.p_worse > 2 * alone.p_worse);
  CHECK(among.outcome == Outcome::undecided);
  CHECK(among.remark.starts_with("worse by its own p, not by Holm's"));
}

TEST_CASE("ranks that say other than the mean are told", "[variants]") {
  // Nineteen runs of b are a little better, one is far off: the mean cannot tell.
  std::vector<double> a = about(1, 0.01), b = about(0.9, 0.01);
  b[0] = 3;
  const MetricComparison comparison = error_of(variant(a), variant(b));
  CHECK(comparison.outcome == Outcome::undecided);
  CHECK_THAT(comparison.remark, ContainsSubstring("by ranks B is better (p "));
  // Where a third is far off, the mean is worse and most runs are better.
  for (std::size_t i = 0; i < 6; ++i) b[i] = 5;
  const MetricComparison opposed = error_of(variant(a), variant(b), {.significance = 0.1});
  CHECK(opposed.outcome == Outcome::worse);
  CHECK_THAT(opposed.remark, ContainsSubstring("the ranks contradict the mean: by them B is better (p "));
}

TEST_CASE("times are compared where both are clean and of one CPU", "[variants]") {
  const auto slower = [](SolveRecord& solve) { solve.cpu_seconds = solve.seconds *= 10; };
  const Variant a = variant(about(1, 0.1)), b = variant(about(1, 0.1), slower);
  CHECK(compared(a, b, {"seconds"}).metrics.front().outcome == Outcome::worse);

  const auto refused = [&](const Variant& other) {
    const VariantComparison comparison = compared(a, other, {"seconds"});
    CHECK(comparison.metrics.front().outcome == Outcome::not_compared);
    return comparison.notes.front();
  };
  const Variant parallel = variant(about(1, 0.1), [](SolveRecord& solve) { solve.timing = Timing::parallel; });
  CHECK_THAT(refused(parallel), ContainsSubstring("B: Times are not comparable: of 20 solves, 20"));
  Variant elsewhere = b;
  elsewhere.sessions[0].environment["cpu"] = "another";
  CHECK_THAT(refused(elsewhere), ContainsSubstring("several CPUs (another, one)"));
  elsewhere.sessions[0].environment.erase("cpu");
  CHECK_THAT(refused(elsewhere), ContainsSubstring("do not say on which CPU"));
  elsewhere.sessions.clear();
  CHECK_THAT(refused(elsewhere), ContainsSubstring("do not say on which CPU"));

  Variant later = b;
  later.sessions[0].environment["date"] = "tomorrow";
  CHECK_THAT(compared(a, later, {"seconds"}).notes.front(), ContainsSubstring("separate sessions"));
}

TEST_CASE("solvers that were given other things to do are not compared", "[variants]") {
  const Variant a = variant(about(1, 0.1));
  const auto complaint_of = [](const Variant& one, const Variant& other) {
    return complaint<std::invalid_argument>([&] { compared(one, other); });
  };
  CHECK_THAT(complaint_of(a, variant(about(1, 0.1), [](SolveRecord& solve) { solve.target_position_m[1] = 0.3; })),
             ContainsSubstring("other targets (run 1 and 1, point 1: 60 20 10 cm and 60 30 10 cm)"));
  CHECK_THAT(complaint_of(a, variant(about(1, 0.1), [](SolveRecord& solve) { solve.target_rotation[0] = -1; })),
             ContainsSubstring("other targets"));
  CHECK_THAT(complaint_of(a, variant(about(1, 0.1), [](SolveRecord& solve) { solve.robot = "leg"; })),
             ContainsSubstring("another robot (arm and leg)"));
  CHECK_THAT(complaint_of(a, variant(about(1, 0.1), [](SolveRecord& solve) { solve.start_rad[1] = 1; })),
             ContainsSubstring("another configuration to start from"));
  CHECK_THAT(complaint_of(a, variant(about(1, 0.1), draw_target)), ContainsSubstring("other targets"));
  CHECK_THAT(complaint_of(a, variant({})), ContainsSubstring("B has no complete run of mine"));
  CHECK_THAT(complaint_of(variant({}), a), ContainsSubstring("A has no complete run of mine"));
  const auto shift = [](SolveRecord& solve) {
    draw_target(solve);
    solve.run += 100;
  };
  CHECK_THAT(complaint_of(variant(about(1, 0.1), draw_target), variant(about(1, 0.1), shift)),
             ContainsSubstring("no run in common"));
}

TEST_CASE("drawn targets pair the runs that both have, and the others are counted", "[variants]") {
  const Variant a = variant(about(1, 0.1), draw_target), b = variant({1, 1.1, 0.9}, draw_target);
  const VariantComparison comparison = compared(a, b, {"position_error_cm"});
  CHECK(comparison.paired);
  CHECK(comparison.metrics.front().a.n == 3);
  CHECK_THAT(comparison.notes.front(), ContainsSubstring("A: 17 of 20 runs are left out"));
}

TEST_CASE("a run with points missing gives no observation", "[variants]") {
  std::vector<SolveRecord> solves;
  for (int run = 1; run <= 3; ++run) {
    for (int point = 1; point <= (run == 2 ? 1 : 2); ++point) {
      solves.push_back(solve_of(run, 10.0 * run + point));
      solves.back().point = point;
    }
  }
  Variant a = variant({1});
  a.study = make_study(StudyEntry{.name = "study", .definition = R"({"points": 2, "runs": 3})", .series = {a.series}},
                       solves);
  const VariantComparison comparison = compared(a, a, {"position_error_cm"});
  CHECK(comparison.metrics.front().a.n == 2);
  CHECK(comparison.metrics.front().a.mean == Approx((11.5 + 31.5) / 2));
  CHECK_THAT(comparison.notes.front(), ContainsSubstring("A: 1 of 3 runs are left out"));
}

TEST_CASE("in what two variants differ beside their numbers is told", "[variants]") {
  const Variant a = variant(about(1, 0.1));
  CHECK(compared(a, a).notes.back() == "The stores tell no difference between A and B but their sessions.");
  Variant b = a;
  b.study.definition = R"({"points": 1, "runs": 20, "stop": {"iterations": 100}, "name": "other"})";
  b.series.options = R"({"alpha": "0.8"})";
  b.sessions[0].environment["commit"] = "def";
  CHECK(compared(a, b).notes.back() ==
        "B differs from A in alpha (0.9, 0.8), commit (abc, def), stop.iterations (200, 100).");
  b.study.definition = "no JSON";
  b.series.options = "[1";
  b.sessions.clear();
  CHECK_THAT(compared(a, b).notes.back(), ContainsSubstring("alpha (0.9, none)"));
}

TEST_CASE("values beyond double precision are undecided with a reason, not a number", "[variants]") {
  for (const std::vector<double>& huge : {std::vector{1e308, 1.5e308, 0.7e308}, std::vector{1e308, 0.0, 1e-308}}) {
    const MetricComparison comparison = error_of(variant({1, 1.1, 0.9}), variant(huge));
    CHECK_FALSE(comparison.outcome == Outcome::same);
    CHECK_FALSE(comparison.outcome == Outcome::better);
  }
}

TEST_CASE("a question out of range and a metric that there is not are refused", "[variants]") {
  const Variant a = variant(about(1, 0.1));
  for (const MarginQuestion& question :
       {MarginQuestion{.margin = 1}, MarginQuestion{.margin = -0.1}, MarginQuestion{.margin = not_defined},
        MarginQuestion{.significance = 0}, MarginQuestion{.significance = 0.3}}) {
    CHECK_THROWS_AS(compared(a, a, {}, question), std::invalid_argument);
  }
  CHECK_THROWS_WITH(compared(a, a, {"speed"}), ContainsSubstring("unknown metric \"speed\""));
  CHECK(compared(a, a, {"solved", "seconds", "solved"}).metrics.size() == 2);
}

TEST_CASE("the verdict names every regression, or counts what is not decided", "[variants]") {
  const Variant a = variant(about(1, 0.5)), wide = variant(about(1.01, 0.5)), worse = variant(about(2, 0.5));
  const std::vector<std::string> error{"position_error_cm"}, all{};
  std::vector<VariantComparison> comparisons{compared(a, worse, error)};
  CHECK(variants_verdict(comparisons, {}) == "Regression beyond 5 %: position_error_cm (2 times).");
  CHECK(count(comparisons, Outcome::worse) == 1);
  comparisons.push_back(compared(a, wide, error));
  comparisons.back().label = "other";
  CHECK(variants_verdict(comparisons, {}) == "Regression beyond 5 %: mine: position_error_cm (2 times).");
  comparisons = {compared(a, wide)};
  CHECK(variants_verdict(comparisons, {}) == "No regression beyond 5 % is shown; 1 of 5 metrics is undecided.");
}

TEST_CASE("the table has a row for every label and metric, and facts have no p", "[variants]") {
  const std::vector<VariantComparison> comparisons{compared(variant(about(1, 0.1)), variant(about(2, 0.1)))};
  const Table table = variants_table(comparisons, {});
  REQUIRE(table.rows.size() == 5);
  CHECK(std::get<std::string>(cell_at(table, 0, "B_is")) == "worse");
  CHECK(number_at(table, 0, "B_by_A") == Approx(2));
  CHECK(number_at(table, 0, "runs_A") == 20);
  CHECK_FALSE(is_empty(table, 0, "p_worse"));
  CHECK(std::get<std::string>(cell_at(table, 1, "remark")) == "to the bit");
  CHECK(is_empty(table, 1, "p_worse"));
  CHECK(is_empty(table, 1, "p_ranks"));
  const std::string json = variants_json(comparisons, {});
  CHECK_THAT(json, ContainsSubstring(R"("verdict": "Regression beyond 5 %: position_error_cm (2 times).")"));
  CHECK_THAT(json, ContainsSubstring(R"("p_worse": null)"));
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
  CHECK(found[0].study.solves.size() == 1);
  CHECK(found[1].study.solvers == std::vector<std::string>{"BA"});
  REQUIRE(found[1].sessions.size() == 1);
  CHECK(found[1].sessions[0].environment.at("cpu") == "two");
}
