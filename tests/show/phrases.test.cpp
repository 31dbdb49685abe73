#include "tests/show/judged.hpp"

using judge::MetricSamples;

namespace {

ReportModel of(MetricSamples observations, const results::AnalysisPlan& plan = {}) {
  ReportModel result = make_report_model({judged(std::move(observations), plan)});
  result.noun = "targets";
  return result;
}

MetricSamples errors(std::vector<std::pair<std::string, std::vector<double>>> groups) {
  return numbers("error", "error", "mm", std::move(groups));
}

// Beats the middle of the others at most values; its few large values are far larger.
std::vector<double> heavy(double middle) {
  std::vector<double> values = values_around(middle, 0.1);
  values[3] = 1000 * middle;
  return values;
}

// `lower` of a hundred lie around the first, the others around the second.
std::vector<double> two_modes(double first, int lower, double second) {
  std::vector<double> values;
  for (int i = 0; i < 100; ++i) values.push_back((i < lower ? first : second) * (1 + 0.001 * i));
  return values;
}

std::string table_of_verdicts(const ReportModel& model) {
  std::string text;
  for (const judge::JudgedMetric& judged : model.metrics) {
    for (const judge::Comparison& comparison : judged.comparisons)
      text += fmt::format("  {} vs {}: {}\n", comparison.first, comparison.second, comparison_text(comparison, judged));
  }
  return text;
}

}  // namespace

TEST_CASE("what is better where most values are equal says how often", "[show]") {
  std::vector<double> at_tolerance(60, 0.01), some = at_tolerance;
  for (std::size_t i = 0; i < 15; ++i) some[i] = 1 + static_cast<double>(i);
  const judge::JudgedMetric error = judged(errors({{"A", at_tolerance}, {"B", some}}));
  CHECK(comparison_text(error.comparisons.front(), error) == "better");
  CHECK(dominance_text(error.comparisons.front()) == "better in 25 % and worse in 0 % of value pairs");
}

TEST_CASE("an end of an interval that p excludes says so", "[show]") {
  MetricSamples unpaired = shares({{"A", solved(0)}, {"B", solved(33, 200)}});
  unpaired.is_paired = false;
  const judge::JudgedMetric error = of(unpaired).metrics[0];
  const judge::Comparison& pair = error.comparisons.front();
  CHECK(interval_text(*pair.estimate->interval, {0}) == "above 0 to 22.3");
}

TEST_CASE("a doubt that several metrics have alike is told once", "[show]") {
  const auto metric = [](const char* name) {
    judge::JudgedMetric of = judged(numbers(name, name, "", {{"A", {1, 2, 3}}, {"B", {5}}}));
    of.samples.warnings.push_back({.kind = judge::WarningKind::dominated_by_few, .solvers = {"A"}, .detail = name});
    return of;
  };
  const std::vector<judge::Warning> warnings =
      make_report_model({metric("time"), metric("evaluations")}).all_warnings();
  REQUIRE(warnings.size() == 1);
  CHECK(warnings.front().detail == "time, evaluations");
}

TEST_CASE("a limit of one is one", "[show]") {
  judge::StudyResults study = judged_study().study;
  study.definition.stop = {.iterations = 1, .evaluations = 1, .seconds = 0.001};
  CHECK(budget_text(study) == "after 1 iteration, 1 evaluation or 1 ms");
}

TEST_CASE("one sentence says who is best, or why nobody is", "[show]") {
  std::string all;
  const auto add = [&](const std::string& what, const ReportModel& model) {
    all += fmt::format("{}:\n  {}\n{}", what, headline(model), table_of_verdicts(model));
  };
  const auto a = values_around(1, 0.5), b = values_around(3, 0.5), c = values_around(3.1, 0.5);
  add("best of three", of(shares({{"mine", solved(6)}, {"PSO", solved(13)}, {"DLS", solved(20)}})));
  add("better of two", of(shares({{"mine", solved(9)}, {"DLS", solved(20)}})));
  add("all", of(shares({{"LM", solved(20)}, {"DLS", solved(20)}})));
  add("all of three, enough to be the same",
      of(shares({{"LM", solved(200, 200)}, {"DLS", solved(200, 200)}, {"KDL", solved(200, 200)}})));
  add("none", of(shares({{"LM", solved(0)}, {"DLS", solved(0)}})));
  add("inconclusive", of(shares({{"LM", solved(18)}, {"DLS", solved(20)}})));
  add("two best, of errors", of(errors({{"A", c}, {"B", a}, {"C", b}, {"D", a}})));
  add("inconclusive between the first two",
      of(errors({{"A", a}, {"B", values_around(1.25, 0.5)}, {"C", values_around(1.55, 0.5)}})));
  add("worse than another than the first",
      of(errors({{"A", values_around(1, 2)}, {"B", values_around(1.2, 0.1)}, {"C", values_around(1.5, 0.1)}})));
  add("too few", of(errors({{"A", {1, 2, 3}}, {"B", {4, 5, 6}}})));
  add("without values", of(errors({{"A", {1, 2, 3}}, {"B", {}}})));
  add("by means, few decide", of(errors({{"A", heavy(1)}, {"B", b}}), {.test = results::AnalysisPlan::Test::means}));
  add("better by ranks, by the mean worse", of(errors({{"A", heavy(1)}, {"B", b}})));
  add("better by ranks, by the median worse",
      of(errors({{"A", two_modes(0.5, 48, 5.5)}, {"B", two_modes(1, 55, 10.6)}})));
  add("two best, of shares",
      of(shares({{"LM", solved(20)}, {"PSO", solved(4)}, {"DLS", solved(20)}, {"mine", solved(2)}})));
  add("the same", of(errors({{"A", values_around(1, 0.01)}, {"B", values_around(1.001, 0.01)}})));
  add("the same as the first, too few among themselves",
      of(errors({{"A", {1, 1.01, 1.02, 1.04}}, {"B", {1.005, 1.03, 1.06}}, {"C", {1.0151, 1.05, 1.07}}}),
         {.significance = 0.2, .margin = 0.5}));
  add("equal, and too few to be the same",
      of(errors({{"A", std::vector<double>(20, 1)}, {"B", std::vector<double>(20, 1)}})));
  add("better by little", of(errors({{"A", values_around(1, 0.01)}, {"B", values_around(1.02, 0.01)}})));
  add("with a control", of(errors({{"A", a}, {"old", b}, {"C", c}}), {.control = "old"}));
  add("many", of(errors({{"A", a}, {"B", b}, {"C", b}, {"D", b}, {"E", b}, {"F", b}, {"G", b}})));
  add("alone", of(errors({{"A", a}})));

  MetricSamples two_fields =
      shares({{"LM", {1}}, {"PSO", {0.2, 0.4, 0.3, 0.5, 0.4}}, {"BA", {0, 0.01, 0.02, 0.01, 0}}});
  two_fields.groups[0].sample = judge::Sample{.values = {1}, .is_deterministic = true};
  two_fields.groups.push_back({.name = "DLS", .sample = judge::Sample{.values = {1}, .is_deterministic = true}});
  two_fields.is_paired = false;
  two_fields.kind = judge::Proportions{.trials_per_value = 20};
  add("two fields that no test joins", of(two_fields));
  MetricSamples repeated = errors({{"A", {1}}, {"B", {2}}});
  repeated.groups[0].sample = judge::Sample{.values = {1}, .is_deterministic = true},
  repeated.groups[1].sample = judge::Sample{.values = {2}, .is_deterministic = true};
  add("deterministic solvers", of(repeated));
  MetricSamples lost = errors({{"A", a}, {"B", b}});
  lost.groups[1].sample = judge::ExcludedSample{.missing = 3, .values = b};
  add("lost values", of(lost));
  MetricSamples bound = errors({{"A", std::vector<double>(20, 0.1)}, {"B", b}});
  bound.groups[0].tolerance = 0.1;
  add("at the tolerance", of(bound));
  MetricSamples several = shares({{"A", {0.5, 0.75, 1, 0.75}}, {"B", {1, 1, 1, 0.75}}});
  several.kind = judge::Proportions{.trials_per_value = 4};
  add("several runs a target", of(several));
  check_golden("headlines.txt", all);
}

TEST_CASE("a pair is told from the better one, and from the control's other", "[show]") {
  const ReportModel plain = of(errors({{"bad", values_around(3, 0.5)}, {"good", values_around(1, 0.5)}}));
  const judge::Comparison& comparison = plain.metrics[0].comparisons[0];
  const judge::EffectEstimate& amount = *comparison.estimate;
  CHECK(comparison.first == "good");
  CHECK(verdict_of(comparison) == judge::Verdict::better);
  CHECK(amount.value == Approx(1 / 3.0).epsilon(1e-9));
  CHECK(amount.interval->low < amount.value);
  CHECK(amount.value < amount.interval->high);
  CHECK(std::get<judge::TestResult>(comparison.result).dominance->a12() > 0.9);

  const ReportModel regression =
      of(errors({{"old", values_around(1, 0.5)}, {"new", values_around(3, 0.5)}}), {.control = "old"});
  CHECK(regression.metrics[0].comparisons[0].first == "new");
  CHECK(verdict_of(regression.metrics[0].comparisons[0]) == judge::Verdict::worse);
  CHECK(regression.metrics[0].comparisons[0].estimate->value == Approx(3).epsilon(1e-9));
}
