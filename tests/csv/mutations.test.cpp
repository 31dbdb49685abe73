// Files as users break them: whatever is in one, it is judged or refused in one sentence.
#include <cmath>

#include "analysis/compare/judge.hpp"
#include "analysis/csv/user_csv.hpp"
#include "tests/catch.hpp"
#include "tests/mutator.hpp"

TEST_CASE("whatever is in a CSV, it is judged or refused in one sentence", "[mutations]") {
  const std::string wide = "A,B,C\n1,2,3\n2.5,3,4.1\n1.5,2.5,3.25\n-1,1.1,1.2\n";
  const std::string rows = "problem;solver;run;error\np1;A;1;1\np1;B;1;2\np1;C;1;2,5\np2;A;2;2\np2;B;2;3\np2;C;2;3\n";
  const std::string printed =
      "metric,name,mean,sd,n\nerror,A,1,0.1,20\nerror,B,2,0.2,20\ntime,A,1,0,3\ntime,B,1,0.5,3\n";
  const std::vector<std::pair<std::string, ikbench::csv::Request>> cases{
      {wide, {}},
      {rows, {.values = {"error"}}},
      {rows, {.values = {"error"}, .block = {"problem"}}},
      {rows, {.values = {"error"}, .block = {"problem"}, .run = "run"}},
      {rows, {.values = {"error"}, .run = "run", .where = {"problem=p1"}}},
      {printed, {}}};
  ikbench::Mutator mutator(2023);
  int judged = 0, refused = 0;
  for (std::size_t i = 0; i < 3000; ++i) {
    const auto& [whole, request] = cases[i % cases.size()];
    const std::string text = mutator.mutated(whole);
    CAPTURE(i, text);
    try {
      ikbench::csv::Quantities read = whole == printed ? ikbench::csv::read_summaries(text, "m.csv", request)
                                                       : ikbench::csv::read(text, "m.csv", request);
      for (ikbench::compare::Observations& each : read.observed) {
        const ikbench::compare::Plan plan = ikbench::csv::with_margin({}, "", each);
        const ikbench::compare::Judged of = ikbench::compare::judge(std::move(each), plan);
        for (const ikbench::compare::Group& group : of.observations.groups) {
          for (const double value : group.values) CHECK(!std::isnan(value));
        }
      }
      ++judged;
    } catch (const std::invalid_argument& mistake) {
      ++refused;
      CHECK(std::string_view(mistake.what()).find('\n') == std::string_view::npos);
    }
  }
  CHECK(judged > 100);
  CHECK(refused > 100);
}
