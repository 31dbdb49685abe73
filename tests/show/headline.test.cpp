// Where the first metric does not tell solvers apart, the headline goes on to the first of the plan that is judged.

#include "tests/show/judged.hpp"

namespace {

// A and B solve all, C few; B takes three times A's time, and as many evaluations.
ReportModel model_of_three(std::vector<double> time_of_b, bool are_times_compared = true,
                           const std::vector<std::string>& tie_breakers = results::default_tie_breakers,
                           const judge::AnalysisPlan& plan = {}) {
  const auto costs = [](judge::MetricSamples of) {
    of.is_paired = true;
    return of;
  };
  judge::MetricSamples times =
      costs(numbers("time", "time", "ms",
                    {{"A", values_around(0.01, 0.2)}, {"B", std::move(time_of_b)}, {"C", values_around(0.001, 0.2)}}));
  times.min_blocks = 4;
  if (!are_times_compared)
    for (judge::Group& group : times.groups)
      group.sample = judge::ExcludedSample{.reason = judge::ExclusionReason::not_comparable};
  return make_report_model(
      std::vector{judged(shares({{"A", solved(20)}, {"B", solved(20)}, {"C", solved(3)}}), plan),
                  judged(std::move(times)),
                  judged(costs(numbers(
                      "evaluations", "evaluations", "",
                      {{"A", values_around(20, 0.1)}, {"B", values_around(40, 0.3)}, {"C", values_around(5, 0.1)}})))},
      0, tie_breakers);
}

}  // namespace

TEST_CASE("of whom the first metric leaves open the first of the plan that is judged is told", "[show]") {
  CHECK(tie_breaker_sentence(model_of_three(values_around(0.03, 0.3))) == "A is fastest; B takes 3x as long.");
  CHECK(tie_breaker_sentence(model_of_three(values_around(0.01, 0.2))) ==
        "No difference in time is shown.");  // a third question would have to share the second's significance
  CHECK(tie_breaker_sentence(model_of_three(values_around(0.03, 0.3), false)) ==
        "Time is not compared (not comparable). A needs the fewest evaluations; B needs 2x as many.");
}

TEST_CASE("ratios of many are told from the least to the largest, or once", "[show]") {
  const auto said = [](double time_of_b) {
    std::vector<std::pair<std::string, std::vector<double>>> all_solved, times;
    for (const char* name : {"A", "B", "C", "D", "E", "F", "G"}) {
      all_solved.emplace_back(name, solved(20));
      times.emplace_back(name, values_around(*name == 'A' ? 0.01 : *name == 'B' ? time_of_b : 0.1, 0.2));
    }
    return tie_breaker_sentence(
        make_report_model(std::vector{judged(shares(all_solved)), judged(numbers("time", "time", "ms", times))}, 0,
                          results::default_tie_breakers));
  };
  CHECK(said(0.02) == "A is fastest; 6 others take 2x to 10x as long.");
  CHECK(said(0.0999) == "A is fastest; 6 others take 10x as long.");
}

TEST_CASE("one that is best alone, and what is no study, have no second question", "[show]") {
  const std::vector<double> time_of_b = values_around(0.03, 0.3);
  CHECK(tie_breaker_sentence(model_of_three(time_of_b, true, {})).empty());
  const ReportModel alone = make_report_model(std::vector{judged(shares({{"A", solved(20)}, {"B", solved(2)}}))}, 0,
                                              results::default_tie_breakers);
  CHECK(tie_breaker_sentence(alone).empty());
  CHECK(tie_breaker_sentence(model_of_three(time_of_b, true, results::default_tie_breakers, {.control = "C"})).empty());
}

TEST_CASE("the plan says what a headline goes on to", "[show]") {
  const ReportModel model = model_of_three(values_around(0.03, 0.3), true, {"evaluations", "time"});
  CHECK(tie_breaker_sentence(model).starts_with("A needs the fewest evaluations"));
  CHECK(ranking_note(model) == "Ranked by targets solved, then evaluations");
}

TEST_CASE("numbers of a headline stand behind their solvers, equal ones together", "[show]") {
  const auto of = [](std::vector<std::pair<std::string, int>> solvers) {
    std::vector<std::pair<std::string, std::vector<double>>> groups;
    for (const auto& [name, count] : solvers) groups.emplace_back(name, solved(count));
    ReportModel model = make_report_model({judged(shares(std::move(groups)))});
    model.noun = "targets";
    return headline(model);
  };
  CHECK(of({{"A", 20}, {"B", 20}, {"C", 18}}) == "No clear winner: A and B solved all 20 targets, C 18.");
  CHECK(of({{"A", 19}, {"B", 18}, {"C", 3}}) == "A solved 19 of 20 targets, B 18 (inconclusive); C (3) is worse.");
  CHECK(of({{"A", 20}, {"B", 20}, {"C", 3}}) == "A and B solved all 20 targets; C (3) is worse.");
  CHECK(of({{"A", 20}, {"B", 20}, {"C", 19}, {"D", 19}, {"E", 18}, {"F", 18}, {"G", 18}}) ==
        "No clear winner: A and B solved all 20 targets, 5 others 18 to 19.");
  CHECK(of({{"A", 20}, {"B", 4}}) == "A is better than B: it solved all 20 targets, B 4.");
  CHECK(of({{"A", 20}}) == "A solved all 20 targets.");
}
