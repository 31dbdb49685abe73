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
  CHECK(of({{"A", 19}, {"B=2", 18}, {"C", 3}}) == "A solved 19 of 20 targets, B=2 (18, inconclusive); C (3) is worse.");
  CHECK(of({{"A", 19}, {"B=2", 18}, {"B=3", 17}, {"C", 3}}) ==
        "A solved 19 of 20 targets, B=2 (18), B=3 (17), inconclusive; C (3) is worse.");
  CHECK(of({{"A", 20}, {"B", 20}, {"C", 3}}) == "A and B solved all 20 targets; C (3) is worse.");
  CHECK(of({{"A", 20}, {"B", 20}, {"C", 19}, {"D", 19}, {"E", 18}, {"F", 18}, {"G", 18}}) ==
        "No clear winner: A and B solved all 20 targets, 5 others 18 to 19.");
  CHECK(of({{"A", 20}, {"B", 4}}) == "A is better than B: it solved all 20 targets, B 4.");
  CHECK(of({{"A", 20}}) == "A solved all 20 targets.");
}

TEST_CASE("a headline says who wins, over whom, and what is unsure", "[show]") {
  using Shares = std::vector<std::pair<std::string, int>>;
  using Errors = std::vector<std::pair<std::string, std::vector<double>>>;
  const auto shares_of = [](const Shares& solvers) {
    Errors groups;
    for (const auto& [name, count] : solvers) groups.emplace_back(name, solved(count, 100));
    return shares(std::move(groups));
  };
  const auto times_of = [](const Shares& solvers, double slower) {
    Errors groups;
    double middle = 0.01;
    for (const auto& [name, count] : solvers) {
      groups.emplace_back(name, values_around(middle, 0.2));
      middle *= slower;
    }
    judge::MetricSamples times = numbers("time", "time", "ms", groups);
    times.is_paired = true;
    return times;
  };
  std::string all;
  const auto add = [&](const std::string& what, ReportModel model, const std::string& time_limit = "") {
    model.noun = "targets";
    model.time_limit = time_limit;
    all += fmt::format("{}:\n  {}\n", what, headline(model));
  };
  const auto with_times = [&](const Shares& solvers, double slower) {
    return make_report_model({judged(shares_of(solvers)), judged(times_of(solvers, slower))}, 0,
                             results::default_tie_breakers);
  };
  const Shares many{{"LM", 100}, {"DLS", 100}, {"Newton", 100}, {"SLSQP", 99}, {"DE", 43}, {"PSO", 35}, {"IK-BA", 9}};
  const Errors far{{"PSO", values_around(175, 1)}, {"DE", values_around(183, 1)}, {"IK-BA", values_around(900, 0.2)}};
  const auto nothing_solved = [&](const Errors& errors) {
    Shares none;
    for (const auto& [name, values] : errors) none.emplace_back(name, 0);
    judge::MetricSamples samples = numbers("error", "position error", "mm", errors);
    return make_report_model({judged(shares_of(none)), judged(std::move(samples))}, 1);
  };
  const auto of_file = [](Errors groups, bool is_paired) {
    judge::MetricSamples samples = numbers("yield", "yield", "t", std::move(groups));
    samples.is_paired = is_paired;
    return make_report_model({judged(std::move(samples))});
  };
  add("all solved", with_times(many, 3));
  add("one best", with_times({{"DLS", 100}, {"PSO", 88}, {"mine", 54}}, 3));
  add("one best, not all solved", with_times({{"DLS", 97}, {"PSO", 60}, {"mine", 20}}, 3));
  add("nothing decided", with_times({{"LM", 100}, {"DLS", 100}, {"SLSQP", 98}}, 1));
  add("nothing decided, one is faster", with_times({{"LM", 100}, {"DLS", 100}, {"SLSQP", 98}}, 2));
  add("nothing solved", nothing_solved(far));
  add("nothing solved, one is closest", nothing_solved({far[2], {"PSO", values_around(150, 0.1)}}));
  add("nothing solved, ten solvers", nothing_solved({far[0],
                                                     far[1],
                                                     {"A", values_around(178, 1)},
                                                     {"B", values_around(179, 1)},
                                                     {"C", values_around(180, 1)},
                                                     {"D", values_around(181, 1)},
                                                     {"E", values_around(182, 1)}}));
  add("a limit", with_times({{"LM", 100}, {"DLS", 97}, {"SLSQP", 60}}, 3), "1 ms");
  add("a limit, one best", with_times({{"LM", 100}, {"DLS", 60}, {"SLSQP", 40}}, 3), "1 ms");
  add("a limit, nothing decided", with_times({{"LM", 100}, {"DLS", 97}}, 1), "1 ms");
  add("stats", of_file({{"ours", values_around(0.11, 0.2)}, {"theirs", values_around(0.17, 0.2)}}, true));
  add("stats, one inconclusive",
      of_file({{"B", values_around(138, 0.5)}, {"A", values_around(140, 0.5)}, {"placebo", values_around(300, 0.5)}},
              false));
  add("stats, few blocks", of_file({{"NPK", {4.1, 4.3, 3.9, 4.0, 4.2, 4.4, 3.8}},
                                    {"NP", {4.0, 4.35, 3.7, 3.9, 4.25, 4.3, 3.75}},
                                    {"N", {3.5, 3.6, 3.3, 3.4, 3.7, 3.8, 3.2}},
                                    {"none", {2.4, 2.5, 2.2, 2.3, 2.6, 2.7, 2.1}}},
                                   true));
  add("stats, too few", of_file({{"NPK", {4.08, 4.1}}, {"N", {3.87, 3.9}}, {"none", {2.44, 2.5}}}, true));
  check_golden("headline-table.txt", all);
}
