#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

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

TEST_CASE("identical variants are the same to the bit in every metric", "[variants]") {
  for (const Change& change : {Change(), Change(draw_target)}) {
    for (const std::vector<double>& errors :
         std::vector<std::vector<double>>{about(1, 0.5), {1}, {0, 0}, {not_defined, 1}}) {
      const VariantComparison comparison = compared(variant(errors, change), variant(errors, change));
      REQUIRE(comparison.metrics.size() == compared_metrics().size());
      for (const MetricComparison& metric : comparison.metrics) {
        CHECK(metric.outcome == Outcome::same);
        CHECK(metric.remark == "equal bit for bit");
        CHECK(std::isnan(metric.p_worse));
      }
      const std::vector<VariantComparison> all{comparison};
      CHECK(variants_verdict(all, {}) == "No regression beyond 5 %. Of 5 comparisons: 5 the same within 5 %.");
    }
  }
}

TEST_CASE("two that always succeed, but by other solves, are not the same after two runs", "[variants]") {
  const std::vector<double> two{1, 1.1}, others{1.1, 1};
  const MetricComparison few = compared(variant(two), variant(others), {"solved"}).metrics.front();
  CHECK(few.outcome == Outcome::undecided);
  CHECK(few.n_to_decide == 62);  // 1.05^-62 = 0.0486
  std::vector<double> one(65), other(65);
  for (std::size_t i = 0; i < 65; ++i) {
    one[i] = 1 + 0.01 * static_cast<double>(i);
    other[i] = 2 * one[i];
  }
  // 1 - 0.05^(1 / 65) = 0.0450
  const MetricComparison many = compared(variant(one), variant(other), {"solved"}).metrics.front();
  CHECK(many.outcome == Outcome::same);
  CHECK(many.remark == "as far as 65 runs can show: a failure in up to 4.5 % of them is not excluded");
}

TEST_CASE("of variants that repeat themselves the difference is a fact, and no p is made of copies", "[variants]") {
  const auto with = [](double error_cm) {
    return variant(std::vector<double>(20, error_cm), [](SolveRecord& solve) { solve.answer_rad = {1, 2}; });
  };
  const auto told = [&](double error_cm) {
    return compared(with(1), with(error_cm), {"position_error_cm"}).metrics.front();
  };
  CHECK(told(2).outcome == Outcome::worse);
  CHECK(told(0.5).outcome == Outcome::better);
  CHECK(told(1.01).outcome == Outcome::same);
  CHECK(told(2).is_fact);
  CHECK(std::isnan(told(2).p_worse));
  CHECK(told(2).remark == "all runs of each are equal: a fact of these targets, without a test");
  const std::vector<VariantComparison> all{compared(with(1), with(2), {"position_error_cm"})};
  CHECK_THAT(variants_verdict(all, {}),
             ContainsSubstring("Regression beyond 5 %: position_error_cm (2 times A's, no test)"));
}

TEST_CASE("poses are compared by their orientation too, where no metric is named", "[variants]") {
  Variant a = variant(about(1, 0.1)), b = variant(about(1, 0.1));
  const auto columns = [&] {
    std::vector<std::string_view> result;
    for (const MetricComparison& metric : compared(a, b).metrics) result.push_back(metric.metric);
    return result;
  };
  CHECK(columns().size() == compared_metrics().size());
  a.study.facts.pose = b.study.facts.pose = true;
  CHECK(columns().size() == compared_metrics().size() + 1);
  CHECK(columns()[1] == "orientation_error_deg");
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
  const Variant ours = variant(about(1, 0.1));
  Variant program = variant(about(1, 0.1), is_program);
  VariantComparison comparison = compared(ours, program, {"seconds", "evaluations"});
  for (const MetricComparison& metric : comparison.metrics) CHECK(metric.outcome == Outcome::not_compared);
  CHECK(comparison.notes[0] ==
        "Times are not comparable: those of B have messages and another process in them. analysis.program_times = "
        "\"compared\" compares them all the same.");
  CHECK(comparison.notes[1] ==
        "Evaluations are not comparable: those of B are its own word, and the other's were counted.");
  comparison = compared(program, program, {"seconds", "evaluations"});
  for (const MetricComparison& metric : comparison.metrics) CHECK(metric.outcome == Outcome::same);
  program.study.plan.program_times = ProgramTimes::compared;
  CHECK(compared(program, ours, {"seconds"}).metrics.front().outcome == Outcome::same);
}

TEST_CASE("the time of a run is the median of its points, as in a report", "[variants]") {
  const auto one_is_late = [](SolveRecord& solve) {
    solve.seconds = solve.cpu_seconds = solve.point == 2 ? 60 : 0.001 * solve.point;
  };
  const auto error = [](int, int) { return 1.0; };
  const Variant a = variant({.runs = 4, .points = 5, .definition = "{}"}, error, one_is_late);
  CHECK(compared(a, a, {"seconds"}).metrics.front().a.mean == Approx(0.004));
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
    CHECK(comparison.metrics.front().outcome == Outcome::not_counted);
    CHECK(comparison.metrics.front().remark == "nobody counted");
    const std::vector<VariantComparison> all{comparison};
    CHECK(variants_verdict(all, {}) ==
          "No regression beyond 5 % was found. Of 1 comparison: 1 not compared: nobody counted.");
  }
  CHECK(compared(a, b).notes.front() ==
        "Solves without an answer: none of A's 20; 3 of B's 20 (crashed 2, timed_out 1).");
  for (const std::string& note : compared(a, a).notes) CHECK_FALSE(note.starts_with("Solves without"));
  CHECK(metric_of(compared(a, b), "position_error_cm").outcome == Outcome::same);
}

TEST_CASE("in what two variants differ beside their numbers is told", "[variants]") {
  const Variant a = variant(about(1, 0.1));
  const std::string none = "The stores show no difference between A and B except their sessions.";
  CHECK(compared(a, a).notes.back() == none);
  Variant without = a, empty = a;
  without.series.options = "";
  empty.series.options = "{}";
  CHECK(compared(without, empty).notes.back() == none);
  Variant b = a;
  b.study.facts = facts_of(R"({"points": 1, "runs": 20, "stop": {"iterations": 100}, "name": "other"})");
  b.series.options = R"({"alpha": "0.8"})";
  b.sessions[0].environment["commit"] = "def";
  CHECK(compared(a, b).notes.back() ==
        "B differs from A in alpha (0.9, 0.8), commit (abc, def), stop.iterations (200, 100).");
  Variant named = a;
  named.series.options = R"({"runs": "7", "alpha": "0.9"})";
  CHECK(compared(a, named).notes.back() == "B differs from A in option runs (none, 7).");
  Variant edited = a;
  edited.sessions[0].environment["source"] = "1f";
  edited.sessions[0].environment["source." + a.series.algorithm] = "2e";
  CHECK(compared(a, edited).notes.back() ==
        "B differs from A in source (unknown, 1f), source of the solver (unknown, 2e).");
  b.study.facts = facts_of("no JSON");
  b.series.options = "[1";
  b.sessions.clear();
  CHECK_THAT(compared(a, b).notes.back(), ContainsSubstring("alpha (0.9, none)"));
}

TEST_CASE("a question out of range and a metric that there is not are refused", "[variants]") {
  const Variant a = variant(about(1, 0.1));
  for (const MarginQuestion& question :
       {MarginQuestion{.margin = 1}, MarginQuestion{.margin = -0.1}, MarginQuestion{.margin = not_defined},
        MarginQuestion{.significance = 0}, MarginQuestion{.significance = 0.3}, MarginQuestion{.power = 0.3},
        MarginQuestion{.power = 1}}) {
    CHECK_THROWS_AS(compared(a, a, {}, question), std::invalid_argument);
  }
  CHECK_THROWS_WITH(compared(a, a, {"speed"}), ContainsSubstring("unknown metric \"speed\""));
  CHECK(compared(a, a, {"solved", "seconds", "solved"}).metrics.size() == 2);
}

TEST_CASE("every question that a plan may ask is answered", "[variants]") {
  const Variant a = variant(about(1, 0.3)), b = variant(about(1.15, 0.3));
  for (const double margin : {margins_percent.first / 100, margins_percent.second / 100}) {
    for (const double significance : {significances.first, significances.second}) {
      for (const double power : {powers.first, powers.second}) {
        CHECK_NOTHROW(compared(a, b, {}, {.margin = margin, .significance = significance, .power = power}));
      }
    }
  }
}

TEST_CASE("the verdict names every regression, or counts what is not decided", "[variants]") {
  const Variant a = variant(about(1, 0.5)), wide = variant(about(1.01, 0.5)), worse = variant(about(2, 0.5));
  const std::vector<std::string> error{"position_error_cm"}, all{};
  std::vector<VariantComparison> comparisons{compared(a, worse, error)};
  CHECK_THAT(variants_verdict(comparisons, {}),
             ContainsSubstring("Regression beyond 5 %: position_error_cm (2 times A's, 90 % interval 1.") &&
                 ContainsSubstring("). Of 1 comparison: 1 worse by more than 5 %."));
  CHECK(count(comparisons, Outcome::worse) == 1);
  comparisons.push_back(compared(a, wide, error));
  comparisons.back().label = "other";
  CHECK_THAT(
      variants_verdict(comparisons, {}),
      ContainsSubstring("Regression beyond 5 %: mine: position_error_cm (2 times") &&
          ContainsSubstring("Of 2 comparisons: 1 worse by more than 5 %, 1 undecided (at this spread it takes about "));
  comparisons = {compared(a, wide)};
  CHECK(
      variants_verdict(comparisons, {}) ==
      fmt::format(
          "No regression beyond 5 % was found. Of 5 comparisons: 3 the same within 5 %, 2 undecided (at this spread it "
          "takes about 62 to {:.0f} runs a side).",
          comparisons.front().metrics.front().n_to_decide));
}

TEST_CASE("the table has a row for every label and metric, and facts have no p", "[variants]") {
  const std::vector<VariantComparison> comparisons{compared(variant(about(1, 0.1)), variant(about(2, 0.1)))};
  const Table table = variants_table(comparisons, {});
  REQUIRE(table.rows.size() == 5);
  CHECK(std::get<std::string>(cell_at(table, 0, "B_is")) == "worse");
  CHECK(number_at(table, 0, "B_by_A") == Approx(2));
  CHECK(number_at(table, 0, "n_A") == 20);
  CHECK_FALSE(is_empty(table, 0, "p_worse"));
  CHECK(std::get<std::string>(cell_at(table, 1, "remark")) == "equal bit for bit");
  CHECK(is_empty(table, 1, "p_worse"));
  CHECK(is_empty(table, 1, "p_ranks"));
  const std::string json = variants_json(comparisons, {});
  CHECK_THAT(json, ContainsSubstring(R"("verdict": "Regression beyond 5 %: position_error_cm (2 times A's, )"));
  CHECK_THAT(json, ContainsSubstring(R"("p_worse": null)"));
  CHECK_THAT(table.notes.front(), ContainsSubstring("an observation of B is better than one of A, ignoring pairs"));
}

TEST_CASE("what is known of targets and runs is that of either side, not of A for both", "[variants]") {
  const auto beyond_reach_by = [](double distance_cm) {
    return variant(about(9, 0.1), [=](SolveRecord& solve) { solve.unavoidable_error_cm = distance_cm; });
  };
  const MetricComparison excess = compared(beyond_reach_by(5), beyond_reach_by(7), {"excess_error_cm"}).metrics.front();
  CHECK(excess.a.mean == Approx(4));
  CHECK(excess.b.mean == Approx(2));
  CHECK(excess.outcome == Outcome::better);
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

TEST_CASE("in a study with a tolerance, a variant that solves nothing is not cheaper", "[variants]") {
  const Solved shape{.runs = 20, .definition = R"({"points": 1, "runs": 20, "stop": {"tolerance_cm": 0.1}})"};
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
  for (const MetricComparison& metric : comparison.metrics) {
    CAPTURE(metric.metric);
    CHECK(metric.mean_favours == -1);
    CHECK(metric.outcome != Outcome::better);
    CHECK(metric.outcome != Outcome::better_by_less);
  }
  CHECK(metric_of(comparison, "evaluations").b.mean == Approx(10 * 120));  // of the dearest solve, which took 120
}
