// Where the first metric does not tell solvers apart, the headline goes on to the next that does.
#include "analysis/show/then.hpp"

#include "tests/show/judged.hpp"

namespace {

// A and B solve all, C few; B takes three times A's time, and as many evaluations.
Answer answer_of_three(std::vector<double> time_of_b, bool are_times_compared = true) {
  const auto costs = [](judge::Observations of) {
    of.is_paired = true;
    return of;
  };
  judge::Observations times =
      costs(numbers("time", "time", "ms",
                    {{"A", values_around(0.01, 0.2)}, {"B", std::move(time_of_b)}, {"C", values_around(0.001, 0.2)}}));
  times.fewest = 4;
  if (!are_times_compared)
    for (judge::Group& group : times.groups) group.sample = judge::Untold{.why = judge::Untold::Why::apart};
  Answer answer = answer_of(
      std::vector{judged(shares({{"A", solved(20)}, {"B", solved(20)}, {"C", solved(3)}})), judged(std::move(times)),
                  judged(costs(numbers(
                      "evaluations", "evaluations", "",
                      {{"A", values_around(20, 0.1)}, {"B", values_around(40, 0.3)}, {"C", values_around(5, 0.1)}})))});
  answer.goes_on = true;
  return answer;
}

}  // namespace

TEST_CASE("whom the first metric leaves open is told apart by the next that does", "[then]") {
  CHECK(then_of(answer_of_three(values_around(0.03, 0.3))) == "A is the fastest; B takes 3 times as long.");
  CHECK(then_of(answer_of_three(values_around(0.01, 0.2))) ==
        "Time tells none of them apart. A needs the fewest evaluations; B takes 2 times as many.");
  CHECK(then_of(answer_of_three(values_around(0.03, 0.3), false)) ==
        "Times are not compared. A needs the fewest evaluations; B takes 2 times as many.");
}

TEST_CASE("one that is best alone, and what is no study, have no second question", "[then]") {
  Answer answer = answer_of_three(values_around(0.03, 0.3));
  answer.goes_on = false;
  CHECK(then_of(answer).empty());
  Answer alone = answer_of(std::vector{judged(shares({{"A", solved(20)}, {"B", solved(2)}}))});
  alone.goes_on = true;
  CHECK(then_of(alone).empty());
  answer.goes_on = true;
  answer.metrics.front().plan.control = "C";
  CHECK(then_of(answer).empty());
}
