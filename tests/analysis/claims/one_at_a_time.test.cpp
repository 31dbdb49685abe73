#include <algorithm>
#include <limits>
#include <stdexcept>

#include "analysis/collections.hpp"
#include "tests/analysis/cells.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::inference;
using namespace ikbench::report;
using namespace ikbench::claims;

namespace {

using Seeds = std::vector<std::vector<double>>;

// Table 3 prints for IK-BA: error 0.0019 0.0019 1.7824e-4 0.0022 0.0016, variation 87.1916 87.5779 7.8247 101.8740
// 72.8021 (mean, median, std, max, min); for BA: error 1.6849, variation 301.5794. BA is worse than IK-BA in both.
const Seeds near_ik_ba{{0.0016, 0.0022, 0.0018}, {0.0014, 0.0020, 0.0018}};

Multiverse::ChosenSolver own(std::vector<Multiverse::Choice> chosen, Seeds error_cm, double variation_deg) {
  const Seeds variation(error_cm.size(), {0.99 * variation_deg, variation_deg, 1.01 * variation_deg});
  return {.chosen = std::move(chosen), .error_cm = std::move(error_cm), .variation_deg = variation};
}

// The study has "x", which makes BA the better one; IK-BA has a step factor.
Multiverse two_alternatives() {
  const Seeds near_ba{{1.6849, 1.7, 1.66}, {1.6849, 1.7, 1.66}}, tenfold{{0.019, 0.018, 0.02}, {0.019, 0.018, 0.02}};
  return {.dimensions = {{"x", "2.1", "", {{"x=0", "it is 0"}, {"x=1", "it is 1"}}},
                         {"IK-BA.k", "2.4", "IK-BA", {{"IK-BA.k=0", "as before"}, {"IK-BA.k=1", "ten times as far"}}}},
          .solvers = {"IK-BA", "BA"},
          .studies = {{.chosen = {{0, 0}},
                       .weight = 0.5,
                       .solvers = {{own({{1, 0}}, near_ik_ba, 87.1916), own({{1, 1}}, tenfold, 87.1916)},
                                   {own({}, near_ba, 301.5794)}}},
                      {.chosen = {{0, 1}},
                       .weight = 0.5,
                       .out_of_reach = 2,
                       .solvers = {{own({}, near_ba, 301.5794)}, {own({}, near_ik_ba, 87.1916)}}}}};
}

std::vector<std::string> row_of(const Table& table, const std::string& alternative, const std::string& algorithm) {
  for (const std::vector<std::string>& row : readable_cells(table)) {
    if (row[0] == alternative && row[3] == algorithm) return row;
  }
  return {};
}

}  // namespace

TEST_CASE("an alternative is scored by the log of our mean by the printed one", "[one_at_a_time]") {
  const Table table = analysis::paper("slim2023").one_at_a_time(two_alternatives(), {});
  const auto moved = row_of(table, "IK-BA.k=1", "IK-BA");
  REQUIRE(moved.size() == 12);
  CHECK(moved[1] == "2.4");
  CHECK(moved[4] == "0.019");
  CHECK(moved[5] == "1");      // log10(0.019 / 0.0019)
  CHECK(moved[6] == "1.023");  // log10(0.019 / 0.0018): the default's mean is 0.0018
  CHECK(moved[9] == "0");
  CHECK(row_of(table, "default", "IK-BA")[5] == "-0.023");  // log10(0.0018 / 0.0019)
  CHECK(row_of(table, "default", "IK-BA")[6].empty());
}

TEST_CASE("an algorithm that an alternative does not move has no row, and counts in the row of all",
          "[one_at_a_time]") {
  const Table table = analysis::paper("slim2023").one_at_a_time(two_alternatives(), {});
  CHECK(row_of(table, "IK-BA.k=1", "BA").empty());
  CHECK(row_of(table, "x=1", "BA").size() == 12);
  // sqrt((1^2 + 0.000^2) / 2): BA's mean is 1.6816, its log ratio -0.001.
  CHECK(row_of(table, "IK-BA.k=1", "all")[5] == "0.707");
  CHECK(row_of(table, "x=1", "all")[2] == "2");  // out of reach
}

TEST_CASE("each alternative says which claims become another, and the default says all", "[one_at_a_time]") {
  const Table table = analysis::paper("slim2023").one_at_a_time(two_alternatives(), {});
  CHECK(row_of(table, "default", "all")[11] ==
        "most_accurate holds; most_accurate_typically holds; smallest_variation holds; better_than_ba holds");
  CHECK(row_of(table, "IK-BA.k=1", "all")[11].empty());  // ten times worse is still better than BA
  CHECK(row_of(table, "x=1", "all")[11] ==
        "most_accurate fails; most_accurate_typically fails; smallest_variation fails; better_than_ba fails");
  Multiverse split = two_alternatives();
  split.studies[1].solvers[0][0].error_cm[0] = near_ik_ba[0];  // no better and no worse for the first seed
  CHECK(row_of(analysis::paper("slim2023").one_at_a_time(split, {}), "x=1", "all")[11].starts_with(
      "most_accurate fails in 50 %, undecided in 50 %; "));
}

TEST_CASE("of a row it is told how many printed numbers it explains, where there are runs enough", "[one_at_a_time]") {
  const Table table = analysis::paper("slim2023").one_at_a_time(two_alternatives(), {});
  const double near = number_at(table, 1, "explained");
  CHECK(std::get<std::string>(table.rows[1][3]) == "IK-BA");
  CHECK(near > 0);
  CHECK(near <= 10);
  CHECK(number_at(table, 0, "explained") == near + number_at(table, 2, "explained"));
  Multiverse few = two_alternatives();
  for (auto& study : few.studies) {
    for (auto& of_solver : study.solvers) {
      for (Multiverse::ChosenSolver& each : of_solver) {
        each.error_cm.resize(1);
        each.variation_deg.resize(1);
      }
    }
  }
  CHECK(is_empty(analysis::paper("slim2023").one_at_a_time(few, {}), 1, "explained"));
}

TEST_CASE("what is not finite is said to be not defined, and claims are told all the same", "[one_at_a_time]") {
  Multiverse multiverse = two_alternatives();
  multiverse.studies[0].solvers[0][1].error_cm[0][0] = std::numeric_limits<double>::infinity();
  const Table table = analysis::paper("slim2023").one_at_a_time(multiverse, {});
  CHECK(row_of(table, "IK-BA.k=1", "IK-BA")[5] == "not defined");
  CHECK(row_of(table, "IK-BA.k=1", "all")[11].starts_with("most_accurate"));
  CHECK_THROWS_AS(analysis::paper("slim2023").one_at_a_time({}, {}), std::invalid_argument);
}
