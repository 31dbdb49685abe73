// Files as users break them: whatever is in one, the whole way from its text to the words ends in a result or in the
// one sentence of a std::invalid_argument. The sanitizers and assertions of a debug build look on.
#include <nlohmann/json.hpp>
#include <random>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/inference/observations_csv.hpp"
#include "analysis/report/assessment.hpp"
#include "results/analysis_plan_fields.hpp"
#include "tests/catch.hpp"
#include "tests/mutator.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::inference;
using namespace ikbench::report;

namespace {

const std::string three_wide = "A,B,C\n1,2,3\n2.5,3,4.1\n1.5,2.5,3.25\n",
                  two_wide = "A,B\n1,2\n2.5,3\n1.5,2.5\n1.1,1.2\n", one_row = "A,B,C\n1,2,3\n",
                  with_blocks =
                      "problem,solver,run,error\np1,A,1,1\np1,B,1,2\np1,C,1,2.5\np2,A,2,2\np2,B,2,3\np2,C,2,3\n",
                  summaries =
                      "metric,name,mean,sd,n\nerror,A,1,0.1,20\nerror,B,2,0.2,20\nerror,C,7,,1\n"
                      "time,A,1,0,3\ntime,B,1,0.5,3\n";

void expect_words(const Assessment& assessment) {
  CHECK_FALSE(assessment.sentences.empty());
  CHECK_FALSE(assessment.tables.empty());
  CHECK(nlohmann::json::accept(assessment.json));
}

struct Case {
  const std::string& text;
  CsvRequest request = {};
};

}  // namespace

TEST_CASE("whatever is in a CSV, its statistics are words or one sentence that refuses it", "[assessment][mutations]") {
  const CsvRequest of_wide{.is_wide = true}, of_rows{.is_wide = true, .rows_are_blocks = true};
  const std::vector<Case> cases{{three_wide, of_wide},
                                {three_wide, of_rows},
                                {two_wide, of_wide},
                                {two_wide, of_rows},
                                {one_row, of_rows},
                                {with_blocks, {.value = "error"}},
                                {with_blocks, {.value = "error", .block = "problem"}},
                                {with_blocks, {.value = "error", .block = "problem", .run = "run"}},
                                {with_blocks, {.value = "error", .run = "run"}}};
  Mutator mutator(2023);
  std::minstd_rand random(2023);  // its sequence is the standard's
  const auto below = [&](std::size_t end) { return static_cast<std::size_t>(random() % end); };
  int judged = 0, refused = 0;
  const auto expect = [&](const auto& judge) {
    try {
      judge();
      ++judged;
    } catch (const std::invalid_argument& mistake) {
      ++refused;
      CHECK(std::string_view(mistake.what()).find('\n') == std::string_view::npos);
    }
  };
  for (int i = 0; i < 1500; ++i) {
    const AnalysisPlan plan{.test = choices_of_tests()[below(deciding_tests().size() + 1)].second,
                            .control = below(8) == 0 ? "A" : ""};
    if (below(8) == 0) {
      const std::string text = mutator.mutated(summaries);
      CAPTURE(i, text);
      expect([&] {
        for (const Observations& each : read_summaries(text, "m.csv")) expect_words(assess(each, plan));
      });
      continue;
    }
    const Case& of = cases[below(cases.size())];
    CsvRequest request = of.request;
    if (below(2) == 0) request.better = Better::larger;
    if (below(4) == 0) request.takes_any_rows = true;
    const std::string text = mutator.mutated(of.text);
    CAPTURE(i, text);
    expect([&] { expect_words(assess(read_observations(text, "m.csv", request), plan)); });
  }
  CHECK(judged > 100);
  CHECK(refused > 100);
}
