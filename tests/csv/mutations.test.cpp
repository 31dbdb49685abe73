// Files as users break them: whatever is in one, it is judged or refused in one sentence.

#include "analysis/csv/user_csv.hpp"
#include "analysis/judge/judge.hpp"
#include "tests/mutator.hpp"

TEST_CASE("whatever is in a CSV, it is judged or refused in one sentence", "[mutations]") {
  const std::string wide = "A,B,C\n1,2,3\n2.5,3,4.1\n1.5,2.5,3.25\n-1,1.1,1.2\n";
  const std::string rows = "problem;solver;run;error\np1;A;1;1\np1;B;1;2\np1;C;1;2,5\np2;A;2;2\np2;B;2;3\np2;C;2;3\n";
  const std::string printed =
      "metric,name,mean,sd,n\nerror,A,1,0.1,20\nerror,B,2,0.2,20\ntime,A,1,0,3\ntime,B,1,0.5,3\n";
  const std::string two = "solver,score\nA,0.91\nA,0.9\nB,0.81\nB,0.8\n", unequal = "A,B\n1,2\n2.5,3\n1.5,\n";
  const std::vector<std::string> better{"smaller"};
  const std::vector<std::pair<std::string, csv::Request>> cases{
      {wide, {}},
      {wide, {.label = {"columns"}, .block = {"row"}, .better = better}},
      {unequal, {.label = {"columns"}, .run = "row", .better = better}},
      {two, {.better = better}},
      {rows, {.values = {"error"}, .block = {"problem"}, .run = "run", .better = better}},
      {rows, {.values = {"error"}, .label = {"solver"}, .block = {"problem", "run"}, .better = better}},
      {rows, {.label = {"solver"}, .run = "run", .where = {"problem=p1"}, .better = better}},
      {printed, {.better = better, .are_summaries = true}}};
  for (const auto& each_case : cases) {
    const std::string& whole = each_case.first;
    const csv::Request& request = each_case.second;
    const bool is_refused = request.better.empty() || !request.where.empty();  // which asks, and has too few rows
    const auto judge_it = [&](const std::string& text) {
      csv::Quantities read = csv::read(text, "m.csv", request);
      for (judge::MetricSamples& each : read.samples) {
        const judge::AnalysisPlan plan = csv::with_margin({}, "", each);
        for (const judge::Group& group : judge::judge(std::move(each), plan).samples.groups)
          CHECK(std::ranges::none_of(values_of(group), [](double value) { return std::isnan(value); }));
      }
    };
    read_mutated(Mutator(2023), whole, 250, "", judge_it, is_refused ? 0 : 0.5);
  }
}
