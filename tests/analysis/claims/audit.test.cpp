// Items of an audit.toml, by SQL over the printed tables of a paper; here of slim2023, whose audit has its own tests.
#include "analysis/claims/audit.hpp"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "analysis/claims/printed.hpp"
#include "numerics/toml_table.hpp"
#include "tests/analysis/folder.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::claims;
using namespace ikbench::report;

namespace {

const std::string texts = "where = \"here\"\nprinted = \"{runs}\"\nfollows = \"f\"\nwhy = \"W.\"\n";

std::vector<AuditItem> items(const std::string& text) { return audited("slim2023", text, "audit.toml"); }

AuditItem item(const std::string& lines) { return items("[[items]]\nid = \"1\"\n" + lines + texts).at(0); }

}  // namespace

TEST_CASE("half a unit of the last printed digit", "[audit]") {
  CHECK(half_unit("40.7685") == Approx(0.00005));
  CHECK(half_unit("1.7824e-4") == Approx(0.00005e-4));
  CHECK(half_unit("45.8") == Approx(0.05));
  CHECK(half_unit("114") == 0.5);
  CHECK(half_unit("6e3") == 500);
  CHECK(half_unit("0.0000") == Approx(0.00005));
}

TEST_CASE("a printed number holds to its last digit, in part within what rounding may change, or fails", "[audit]") {
  CHECK(judged("1.25", 1.2549, 0) == Verdict::holds);
  CHECK(judged("2", 2.5, 0) == Verdict::holds);
  CHECK(judged("1.25", 1.26, 0.005) == Verdict::in_part);
  CHECK(judged("1.25", 1.27, 0.005) == Verdict::fails);
}

TEST_CASE("an item is consistent where its condition holds, and else what it says", "[audit]") {
  CHECK(words_of(item("holds = \"runs = 20\"\n")) == "consistent");
  CHECK(words_of(item("holds = \"runs = 21\"\n")) == "contradiction");
  CHECK(words_of(item("holds = \"runs = 21\"\notherwise = \"misprint\"\n")) == "misprint");
  CHECK(words_of(item("holds = \"runs = 21\"\notherwise = \"not supported\"\n")) == "not supported");
  CHECK(item("holds = \"1\"\n").printed == "20");  // as statements.csv has it
}

TEST_CASE("an item whose statements a paper does not have is left out", "[audit]") {
  CHECK(items("[[items]]\nid = \"1\"\nneeds = [\"runs\"]\nholds = \"1\"\n" + texts).size() == 1);
  CHECK(items("[[items]]\nid = \"1\"\nneeds = [\"runs\", \"not_there\"]\nholds = \"not_there\"\n" + texts).empty());
}

// One row of statements that breaks each rule of analysis/claims/audit.toml, and one that keeps it.
TEST_CASE("each rule that is asked of every paper holds and fails by the paper's statements", "[audit]") {
  const std::string source = "analysis/claims/audit.toml";
  const toml::table file = numerics::parse_toml(text_of_file(source), source);
  const std::vector<std::pair<std::string, std::string>> cases{
      {"0 AS gradient_methods", "1 AS gradient_methods"},
      {"1 AS targets", "2 AS targets"},
      {"10 AS fewest_evaluations, 20 AS most_evaluations", "10 AS fewest_evaluations, 19 AS most_evaluations"},
      {"'not stated' AS joint_limits_as_printed", "'+-170 deg' AS joint_limits_as_printed"},
      {"'cm2' AS unit_of_errors_as_printed", "'cm' AS unit_of_errors_as_printed"},
      {"1e-17 AS smallest_error_m, 1 AS reach_m", "1e-15 AS smallest_error_m, 1 AS reach_m"},
      {"1 AS smallest_averaged, 1000 AS largest_averaged", "1 AS smallest_averaged, 999 AS largest_averaged"}};
  const toml::array& rules = *file["items"].as_array();
  REQUIRE(rules.size() == cases.size());
  SQLite::Database database(":memory:");
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const std::string holds = *(*rules[i].as_table())["holds"].value<std::string>();
    CAPTURE(holds);
    const auto verdict = [&](const std::string& row) {
      return database.execAndGet("SELECT (" + holds + ") FROM (SELECT " + row + ")").getInt();
    };
    CHECK(verdict(cases[i].first) == 0);
    CHECK(verdict(cases[i].second) == 1);
  }
}

TEST_CASE("an item with a number is judged by its rounding", "[audit]") {
  CHECK(words_of(item("query = \"SELECT 20.4 AS number\"\n")) == "consistent");
  CHECK(words_of(item("query = \"SELECT 21 AS number, 0.6 AS slack\"\n")) == "rounding");
  CHECK(words_of(item("query = \"SELECT 21 AS number, 0.4 AS slack\"\n")) == "contradiction");
}

TEST_CASE("each row of a query is an item, lettered with those of its id", "[audit]") {
  const std::string entry =
      "[[items]]\nid = \"2\"\nquery = \"SELECT bats_as_printed, 1 AS holds FROM table_7\"\n"
      "where = \"{bats_as_printed} bats\"\nprinted = \"p\"\nfollows = \"f\"\nwhy = \"W.\"\n";
  const std::vector<AuditItem> all = items(entry + "[[items]]\nid = \"2\"\nholds = \"1\"\n" + texts);
  REQUIRE(all.size() == 5);
  CHECK(all[0].id == "2a");
  CHECK(all[0].where == "12 bats");
  CHECK(all[3].where == "30 bats");
  CHECK(all[4].id == "2e");
}

TEST_CASE("more items than letters have ids of their own", "[audit]") {
  const std::vector<AuditItem> all = items(
      "[[items]]\nid = \"1\"\nquery = \"WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 53) SELECT 1 "
      "AS holds FROM n\"\n" +
      texts);
  REQUIRE(all.size() == 53);
  CHECK(all[25].id == "1z");
  CHECK(all[26].id == "1aa");
  CHECK(all[52].id == "1ba");
}

TEST_CASE("no sample has a mean outside its extremes or a spread that they do not allow", "[audit]") {
  CHECK(impossible(2, 2, 1, 3, 1, 3).empty());  // 1, 2, 3
  CHECK(impossible(4, 2, 1, 3, 1, 3) == "the mean exceeds the maximum");
  CHECK(impossible(0, 2, 1, 3, 1, 3) == "the mean is below the minimum");
  CHECK(impossible(2, 4, 1, 3, 1, 3) == "the median is outside the extremes");
  CHECK(impossible(2, 2, 1.3, 3, 1, 3) == "the standard deviation exceeds what the extremes allow");  // at most 1.22
  CHECK(impossible(2, 2.9, 1, 3, 1, 3) == "mean and median are too far apart");                       // at most 0.82
}

TEST_CASE("a mistake in an item is refused with its line", "[audit]") {
  using Catch::Matchers::StartsWith;
  const auto refused = [](const std::string& lines, const std::string& words) {
    CAPTURE(lines);
    CHECK_THROWS_WITH(items("[[items]]\nid = \"1\"\n" + lines), StartsWith(words));
  };
  refused(texts + "holds = \"rums = 20\"\n", "audit.toml:1:1: no such column: rums");
  refused(texts + "query = \"SELECT\"\n", "audit.toml:1:1: ");
  refused(texts, "audit.toml:1:1: an item without a query or holds");
  refused(texts + "query = \"SELECT half_unit('ten') AS number\"\n", "audit.toml:1:1: 'ten' is no number");
  refused("query = \"SELECT 1 AS number\"\nwhere = \"w\"\nprinted = \"ten\"\nfollows = \"f\"\nwhy = \"W.\"\n",
          "audit.toml:1:1: 'ten' is no number");
  refused(texts + "query = \"SELECT 1 WHERE 0\"\n", "audit.toml:1:1: a query without a row");
  refused(texts + "query = \"SELECT 1\"\n", "audit.toml:1:1: no column {holds}");
  refused("holds = \"1\"\n", "audit.toml:1:1: an item without where");
  refused("holds = \"1\"\nwhere = \"{runns}\"\nprinted = \"p\"\nfollows = \"f\"\nwhy = \"W.\"\n",
          "audit.toml:1:1: no column {runns}");
  refused(texts + "otherwise = \"wrong\"\n", "audit.toml:7:13: items.otherwise is ");
  refused(texts + "colour = \"red\"\n", "audit.toml:7:1: unknown key \"colour\"");
  CHECK_THROWS_WITH(items(""), "audit.toml: no items; expected tables [[items]]");
  CHECK_THROWS_WITH(items("views = \"CREATE\"\n"), StartsWith("audit.toml:1:1: "));
  CHECK_THROWS_AS(audited("nobody1999", "", "audit.toml"), std::invalid_argument);
}
