// The table, the interactions and the figures of swept settings, and how hostile definitions end.
#include "analysis/inference/sweep.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "analysis/inference/make_study.hpp"
#include "analysis/report/study_pieces.hpp"
#include "tests/analysis/cells.hpp"
#include "tests/analysis/synthetic.hpp"
#include "tests/catch.hpp"
#include "tests/contains.hpp"

// Two functions of pieces/, which have no header.
namespace ikbench::report {
std::vector<Table> sweep_tables(const inference::StudyResults& study, const std::vector<inference::Metric>& metrics);
std::vector<figures::Figure> sweep_figures(const inference::StudyResults& study,
                                           const std::vector<inference::Metric>& metrics);
}  // namespace ikbench::report

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::inference;
using namespace ikbench::figures;
using namespace ikbench::report;

namespace {

// A is swept by a and b, two values each. The error of run r is r + 10 a + 100 b, and at both last values 5 more.
const char* const swept_by_two =
    R"({"stop": {"iterations": 9}, "path": {"kind": "helix"}, "start": "previous", "swept": {
  "A a=1 b=0": {"family": "A", "settings": {"a": "1", "b": "0"}},
  "A a=1 b=1": {"family": "A", "settings": {"a": "1", "b": "1"}},
  "A a=50 b=0": {"family": "A", "settings": {"a": "50", "b": "0"}},
  "A a=50 b=1": {"family": "A", "settings": {"a": "50", "b": "1"}}}})";

StudyResults swept_study(const std::string& json = swept_by_two) {
  std::vector<SolveRecord> solves = synthetic::solves(
      {.solvers = {"A a=1 b=0", "A a=1 b=1", "A a=50 b=0", "A a=50 b=1", "other"}, .runs = 4, .points = 1});
  for (std::size_t i = 0; i < solves.size(); ++i) {
    const int cell = static_cast<int>(i / 4);
    solves[i].position_error_cm = solves[i].run + 10.0 * (cell / 2 % 2) + 100.0 * (cell % 2) + (cell == 3 ? 5 : 0);
  }
  StudyResults study = make_study("swept", std::move(solves));
  study.facts = facts_of(json);
  return study;
}

const Table& swept_table_named(const std::vector<Table>& tables, const std::string& name) {
  return *std::ranges::find(tables, name, &Table::name);
}

std::vector<Table> tables_of(const StudyResults& study) { return sweep_tables(study, shown_metrics(study)); }

}  // namespace

TEST_CASE("each combination of swept settings is a row, and the best mean of a family is marked", "[sweep]") {
  const std::vector<Table> tables = tables_of(swept_study());
  const Table& table = swept_table_named(tables, "sweep");
  REQUIRE(table.rows.size() == 4);
  CHECK(table.columns[0] == "family");
  CHECK(table.columns[1] == "a");
  CHECK(table.columns[2] == "b");
  CHECK(number_at(table, 0, "position error [cm]") == Approx(2.5));
  CHECK(number_at(table, 3, "position error [cm]") == Approx(117.5));
  CHECK(contains(readable(cell_at(table, 0, "best in")), "error"));
  CHECK_FALSE(contains(readable(cell_at(table, 3, "best in")), "error"));
  // Student's t of four values 1 to 4: 2.5 +- 3.182446 sqrt(5 / 3) / 2.
  CHECK(std::get<Range>(cell_at(table, 0, "error interval")).high == Approx(2.5 + 3.182446 * std::sqrt(5.0 / 12)));
}

TEST_CASE("an interaction has its F and the difference of differences, by hand", "[sweep]") {
  // The corners differ by 5; each mean has the variance (5 / 3) / 4, so F = 25 / (4 x 5 / 12) = 15 with 1 and 12.
  const std::vector<Table> tables = tables_of(swept_study());
  const Table& table = swept_table_named(tables, "sweep-interactions");
  CHECK(readable(cell_at(table, 0, "settings")) == "a, b");
  CHECK(readable(cell_at(table, 0, "depends")) == "yes");
  CHECK(number_at(table, 0, "F") == Approx(15));
  CHECK(number_at(table, 0, "df within") == Approx(12));
  CHECK(number_at(table, 0, "difference or ratio") == Approx(5));
  CHECK(readable(cell_at(table, 0, "effect of")) == "a 1 to 50, at b 1 and 0");
}

TEST_CASE("a figure has a curve for each value of the other setting, and a logarithmic axis for wide values",
          "[sweep]") {
  const StudyResults study = swept_study();
  const std::vector<Figure> figures = sweep_figures(study, shown_metrics(study));
  REQUIRE_FALSE(figures.empty());
  const Figure& figure = figures.front();
  CHECK(figure.name == "sweep-error");
  CHECK(contains(figure.settings, "set logscale x"));
  CHECK(contains(figure.data, "# b 0: a, mean, low, high\n1 2.5 "));
  CHECK(contains(figure.data, "# b 1: a, mean, low, high\n1 102.5 "));
  CHECK_FALSE(contains(figure.data, "# b 2"));
  for (const int look : {style_of(study, "A a=1 b=0"), style_of(study, "A a=1 b=1")}) {
    CAPTURE(look);
    CHECK(contains(figure.plot, fmt::format("with lines ls {}", look)));
  }
}

TEST_CASE("words of several families have places without gaps", "[sweep]") {
  const StudyResults study = swept_study(R"({"swept": {
    "A a=1 b=0": {"family": "A", "settings": {"a": "x"}}, "A a=1 b=1": {"family": "A", "settings": {"a": "y"}},
    "A a=50 b=0": {"family": "B", "settings": {"a": "x"}}, "A a=50 b=1": {"family": "B", "settings": {"a": "y"}}}})");
  CHECK(contains(sweep_figures(study, shown_metrics(study)).front().settings, "set xrange [0.92:2.08]"));
}

TEST_CASE("an interval that is not defined has a low and a high end all the same", "[sweep]") {
  StudyResults study = make_study(
      "swept",
      synthetic::solves({.solvers = {"A a=1 b=0", "A a=1 b=1", "A a=50 b=0", "A a=50 b=1"}, .runs = 1, .points = 1}));
  study.facts = facts_of(swept_by_two);
  for (const Table& table : tables_of(study)) {
    if (table.name == "sweep") CHECK(std::holds_alternative<Range>(cell_at(table, 0, "error interval")));
  }
}

TEST_CASE("a family that nobody counted has no figure of evaluations and no interaction in them", "[sweep]") {
  StudyResults study = swept_study();
  study.facts = facts_of(R"({"stop": {"iterations": 9, "tolerance_cm": 0.5}, "swept": {
    "A a=1 b=0": {"family": "A", "settings": {"a": "1", "b": "0"}},
    "A a=1 b=1": {"family": "A", "settings": {"a": "1", "b": "1"}},
    "A a=50 b=0": {"family": "B", "settings": {"c": "1", "d": "0"}},
    "A a=50 b=1": {"family": "B", "settings": {"c": "1", "d": "1"}}}})");
  for (Solve& solve : study.solves.to_change()) {
    if (solver_of(study, solve).starts_with("A a=1 ")) solve.counted_by = CountedBy::nobody;
  }
  const std::vector<Table> tables = tables_of(study);
  std::set<std::string> in_evaluations;
  for (const auto& row : swept_table_named(tables, "sweep-interactions").rows) {
    if (contains(readable(row[2]), "evaluations")) in_evaluations.insert(readable(row[0]));
  }
  CHECK(in_evaluations == std::set<std::string>{"B"});
  CHECK(has_note(swept_table_named(tables, "sweep"), "Nobody counted the evaluations of A a=1 b=0, A a=1 b=1."));
  std::set<std::string> names;
  for (const Figure& figure : sweep_figures(study, shown_metrics(study))) {
    names.insert(figure.name);
    if (figure.name == "sweep-error")
      CHECK(contains(figure.caption, "An error below the tolerance of 0.5 cm counts as"));
  }
  CHECK_FALSE(names.contains("sweep-evaluations"));
  CHECK(names.contains("sweep-evaluations-2"));
}

TEST_CASE("seeds of a study and of a training are compared as whole numbers", "[sweep]") {
  const auto are_equal = [](const std::string& study, const std::string& training) {
    const StudyFacts facts = facts_of(R"({"seed": )" + study + R"(, "tuned": {"A": {"seed": )" + training + "}}}");
    return facts.tuned.at("A").is_on_seed;
  };
  CHECK(are_equal("9007199254740993", "9007199254740993"));
  CHECK_FALSE(are_equal("9007199254740992", "9007199254740993"));
  CHECK_FALSE(are_equal("1", "2"));
}

TEST_CASE("without a sweep, or with a definition that is none, there are no pieces", "[sweep]") {
  for (const std::string json :
       {R"({"start": "previous"})", R"({"swept": 5})", R"({"swept": {"A a=1 b=0": 7}})",
        R"({"swept": {"A a=1 b=0": {}}})", R"({"swept": {"A a=1 b=0": {"family": "A", "settings": {"a": 1}}}})",
        R"({"swept": {"nobody": {"family": "A", "settings": {"a": "1"}}}})"}) {
    INFO(json);
    const StudyResults study = swept_study(json);
    CHECK(tables_of(study).empty());
    CHECK(sweep_figures(study, shown_metrics(study)).empty());
  }
}

TEST_CASE("a family with combinations missing, or with one member, is shown as it is", "[sweep]") {
  const StudyResults study = swept_study(R"({"swept": {
    "A a=1 b=0": {"family": "A", "settings": {"a": "1", "b": "x"}},
    "A a=1 b=1": {"family": "A", "settings": {"a": "nan", "b": "1"}},
    "A a=50 b=0": {"family": "A", "settings": {"a": "1e999"}},
    "other": {"family": "\n\"`rm`{", "settings": {"a": "1"}}}})");
  const std::vector<Table> tables = tables_of(study);
  CHECK(swept_table_named(tables, "sweep").rows.size() == 3);
  CHECK(contains(readable(cell_at(swept_table_named(tables, "sweep-interactions"), 0, "depends")), "not defined"));
  for (const Figure& figure : sweep_figures(study, shown_metrics(study))) CHECK_FALSE(contains(figure.plot, "`rm`"));
}
