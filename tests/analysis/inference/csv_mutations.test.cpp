// Files as users break them: whatever is in one, the whole way from its text to the words ends in a result or in the
// one sentence of a std::invalid_argument. The sanitizers and assertions of a debug build look on.
#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <random>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/inference/observations_csv.hpp"
#include "analysis/report/assessment.hpp"
#include "results/analysis_plan_fields.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::inference;
using namespace ikbench::report;

namespace {

using Rows = std::vector<std::vector<std::string>>;

const Rows wide_rows{{"A", "B", "C"}, {"1", "2", "3"}, {"2.5", "3", "4.1"}, {"1.5", "2.5", "3.25"}};
const Rows two_wide{{"A", "B"}, {"1", "2"}, {"2.5", "3"}, {"1.5", "2.5"}, {"1.1", "1.2"}};
const Rows one_row{{"A", "B", "C"}, {"1", "2", "3"}};
const Rows with_blocks{{"problem", "solver", "run", "error"},
                       {"p1", "A", "1", "1"},
                       {"p1", "B", "1", "2"},
                       {"p1", "C", "1", "2.5"},
                       {"p2", "A", "2", "2"},
                       {"p2", "B", "2", "3"},
                       {"p2", "C", "2", "3"}};
const Rows summary_rows{{"metric", "name", "mean", "sd", "n"}, {"error", "A", "1", "0.1", "20"},
                        {"error", "B", "2", "0.2", "20"},      {"error", "C", "7", "", "1"},
                        {"time", "A", "1", "0", "3"},          {"time", "B", "1", "0.5", "3"}};

class Mutator {
 public:
  std::size_t below(std::size_t end) { return static_cast<std::size_t>(random_() % end); }

  std::string mutated(Rows rows) {
    const std::size_t changes = below(4);
    for (std::size_t i = 0; i < changes && !rows.empty(); ++i) change(rows);
    std::string text;
    for (const auto& row : rows) {
      for (std::size_t i = 0; i < row.size(); ++i) text += (i == 0 ? "" : ",") + row[i];
      text += "\n";
    }
    if (below(16) == 0) text.resize(below(text.size() + 1));
    return text;
  }

 private:
  std::string odd_cell() {
    static constexpr std::array<std::string_view, 28> cells{
        "NaN",    "nan",     "inf",    "-Inf",   "",        "NA",   "1e308",
        "-1e308", "1.7e308", "5e-324", "1e-320", "1e999",   "0",    "-0",
        "1",      "1",       "\"",     "\"1",    "\"a,b\"", "a\"b", "1,5",
        "0x1p3",  " ",       "A",      "\xff",   "\"\n\"",  "0.1",  "0.30000000000000004"};
    return std::string(cells[below(cells.size())]);
  }

  void change(Rows& rows) {
    const std::size_t line = below(rows.size()), other_line = below(rows.size());
    std::vector<std::string>& row = rows[line];
    const std::size_t cell = row.empty() ? 0 : below(row.size());
    const auto at = static_cast<std::ptrdiff_t>(cell);
    switch (below(11)) {
      case 0:
        rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(line));
        return;
      case 1:
        rows.insert(rows.begin() + static_cast<std::ptrdiff_t>(other_line), std::vector<std::string>(row));
        return;
      case 2:
        std::swap(rows[line], rows[other_line]);
        return;
      case 3:  // a column goes
        for (auto& each : rows) {
          if (cell < each.size()) each.erase(each.begin() + at);
        }
        return;
      case 4:  // a column comes twice
        for (auto& each : rows) {
          if (cell < each.size()) each.insert(each.begin() + at, std::string(each[cell]));
        }
        return;
      case 5:  // a column is one value
        for (std::size_t i = 1; i < rows.size(); ++i) {
          if (cell < rows[i].size()) rows[i][cell] = rows.back().empty() ? "" : rows.back().back();
        }
        return;
      default:
        break;
    }
    if (row.empty()) return;
    switch (below(4)) {
      case 0:
        row.erase(row.begin() + at);
        break;
      case 1:
        row.insert(row.begin() + at, std::string(row[cell]));
        break;
      case 2:
        std::swap(row[cell], row[below(row.size())]);
        break;
      default:
        row[cell] = odd_cell();
    }
  }

  std::minstd_rand random_{2023};  // its sequence is the standard's
};

void expect_words(const Assessment& assessment) {
  CHECK_FALSE(assessment.sentences.empty());
  CHECK_FALSE(assessment.tables.empty());
  CHECK(nlohmann::json::accept(assessment.json));
}

struct Case {
  const Rows& rows;
  CsvRequest request = {};
};

}  // namespace

TEST_CASE("whatever is in a CSV, its statistics are words or one sentence that refuses it", "[assessment][mutations]") {
  const CsvRequest of_wide{.is_wide = true}, of_rows{.is_wide = true, .rows_are_blocks = true};
  const std::vector<Case> cases{{wide_rows, of_wide},
                                {wide_rows, of_rows},
                                {two_wide, of_wide},
                                {two_wide, of_rows},
                                {one_row, of_rows},
                                {with_blocks, {.value = "error"}},
                                {with_blocks, {.value = "error", .block = "problem"}},
                                {with_blocks, {.value = "error", .block = "problem", .run = "run"}},
                                {with_blocks, {.value = "error", .run = "run"}}};
  Mutator mutator;
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
    const AnalysisPlan plan{.test = choices_of_tests()[mutator.below(deciding_tests().size() + 1)].second,
                            .control = mutator.below(8) == 0 ? "A" : ""};
    if (mutator.below(8) == 0) {
      const std::string text = mutator.mutated(summary_rows);
      CAPTURE(i, text);
      expect([&] {
        for (const Observations& each : read_summaries(text, "m.csv")) expect_words(assess(each, plan));
      });
      continue;
    }
    const Case& of = cases[mutator.below(cases.size())];
    CsvRequest request = of.request;
    if (mutator.below(2) == 0) request.better = Better::larger;
    if (mutator.below(4) == 0) request.takes_any_rows = true;
    const std::string text = mutator.mutated(of.rows);
    CAPTURE(i, text);
    expect([&] { expect_words(assess(read_observations(text, "m.csv", request), plan)); });
  }
  CHECK(judged > 500);
  CHECK(refused > 500);
}
