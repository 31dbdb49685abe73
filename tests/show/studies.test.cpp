// Several studies side by side: their table, and what the headline says of them.
#include "analysis/show/studies.hpp"

#include "tests/show/judged.hpp"

namespace {

using namespace ikbench;

// Returns a study in which A and B solve these numbers of 20 targets.
StudyColumn column(const std::string& name, int a, int b) {
  return {.name = name,
          .study = "my " + name,
          .model = make_report_model({judged(shares({{"A", solved(a)}, {"B", solved(b)}}))})};
}

std::string headline_of(std::vector<std::string> keys, std::vector<StudyColumn> columns) {
  return headline(StudiesReport{.title = "my", .keys = std::move(keys), .columns = std::move(columns)});
}

}  // namespace

TEST_CASE("of several studies each is a column, solvers in the order of the first", "[studies]") {
  const StudiesReport report{
      .title = "both",
      .keys = {},
      .columns = {column("on-one", 20, 10),
                  {.name = "on-two",
                   .study = "my",
                   .model = make_report_model({judged(shares({{"B", solved(20)}, {"C", solved(5)}}))})}}};
  const Table table = studies_table(report);
  CHECK(table.columns[2].name == "on-two");
  CHECK(table.rows.size() == 3);
  CHECK(std::get<std::string>(table.rows[0][0]) == "A");
  CHECK(std::get<ValueCell>(table.rows[1][1]).mark == "*");
  CHECK(std::get<ValueCell>(table.rows[1][1]).interval);
  CHECK(std::get<MissingCell>(table.rows[2][1]).reason == "not in the study");
}

TEST_CASE("more than six studies have a row each, without intervals", "[studies]") {
  StudiesReport report{.title = "my", .keys = {"near_deg"}, .columns = {}};
  for (int i = 0; i < 7; ++i) report.columns.push_back(column(std::to_string(i), 20, 10));
  const Table table = studies_table(report);
  CHECK(table.rows.size() == 7);
  CHECK(table.columns[0].name == "near_deg");
  CHECK(std::get<ValueCell>(table.rows[6][2]).mark == "*");
  CHECK_FALSE(std::get<ValueCell>(table.rows[6][2]).interval);
}

TEST_CASE("the headline says where which difference is decided", "[studies]") {
  const std::vector arms{column("ur5e", 19, 20), column("my_arm", 20, 8), column("panda", 20, 20)};
  CHECK(headline_of({"robot"}, arms) ==
        "On my_arm, B (40 %) is worse than A (100 %) in targets solved; on ur5e and panda, no difference is shown.");
  CHECK(headline_of({"near_deg"}, {column("1", 20, 8), column("10", 20, 3)}) ==
        "At near_deg = 1 and 10, B is worse than A in targets solved.");
  CHECK(headline_of({}, {column("one", 20, 20), column("two", 19, 20)}) ==
        "In one and two, no difference in targets solved is shown.");
  std::vector<StudyColumn> many;
  for (int i = 0; i < 9; ++i) many.push_back(column(std::to_string(i), 20, i == 4 ? 20 : 8));
  CHECK(headline_of({"robot"}, many) ==
        "On 8 of the 9 arms, B is worse than A in targets solved; on 4, no difference is shown.");
}

TEST_CASE("with a control the headline says who is better and worse than it", "[studies]") {
  const auto with_control = [](const std::string& name, int a, int b) {
    StudyColumn controlled = column(name, a, b);
    controlled.model =
        make_report_model({judged(shares({{"A", solved(a)}, {"B", solved(b)}, {"C", solved(10)}}), {.control = "B"})});
    return controlled;
  };
  CHECK(headline_of({"near_deg"}, {with_control("1", 20, 8), with_control("10", 20, 8)}) ==
        "At near_deg = 1 and 10, A is better than the control B in targets solved.");
  CHECK(contains(headline_of({"near_deg"}, {with_control("1", 2, 20)}), "worse than the control B (100 %)"));
}

TEST_CASE("of many outcomes the headline counts the studies in which each solver is worse", "[studies]") {
  std::vector<StudyColumn> many;
  for (int i = 0; i < 12; ++i) {
    many.push_back(column(std::to_string(i), 20, 20));
    many.back().model = make_report_model({judged(shares({{"A", solved(20)},
                                                          {"B", solved(i % 2 == 0 ? 3 : 20)},
                                                          {"C", solved(i % 3 == 0 ? 3 : 20)},
                                                          {"D", solved(i == 5 ? 2 : 20)}}))});
  }
  CHECK(contains(
      headline_of({"robot"}, many),
      "In targets solved, B is worse than some other solver on 6 of the 12 arms; C on 0, 3, 6 and 9 and D on 5."));
}

TEST_CASE("a study without a tested pair says why", "[studies]") {
  StudyColumn one{.name = "10", .study = "my 10", .model = make_report_model({judged(shares({{"A", solved(20)}}))})};
  CHECK(headline_of({"near_deg"}, {one}) == "At near_deg = 10, A (100 %) is the only solver.");
}

TEST_CASE("the order changes only where two studies decide opposite differences", "[studies]") {
  const std::string text = headline_of({"near_deg"}, {column("1", 20, 8), column("10", 8, 20), column("45", 20, 20)});
  CHECK(contains(text,
                 "The order changes: A is better than B at near_deg = 1, and B is better than A at near_deg = 10."));
  CHECK_FALSE(contains(headline_of({"near_deg"}, {column("1", 20, 8), column("10", 19, 20)}), "order changes"));
}

TEST_CASE("a study that solves nothing is said to", "[studies]") {
  StudyColumn none{.name = "ur5e", .study = "my ur5e", .model = {}};
  none.model = make_report_model({judged(numbers("position_error_cm", "position error", "mm",
                                                 {{"A", values_around(3, 0.5)}, {"B", values_around(3.02, 0.5)}})),
                                  judged(shares({{"A", solved(0)}, {"B", solved(0)}}))});
  CHECK(headline_of({"robot"}, {column("panda", 20, 8), none}) ==
        "On panda, B (40 %) is worse than A (100 %) in targets solved; on ur5e, no solver reached any target.");
  none.model = make_report_model({judged(numbers("position_error_cm", "position error", "mm",
                                                 {{"A", values_around(3, 0.5)}, {"B", values_around(9, 0.5)}})),
                                  judged(shares({{"A", solved(0)}, {"B", solved(0)}}))});
  CHECK(
      contains(headline_of({"robot"}, {none}), "On ur5e, no solver reached any target, and B (9 mm) is worse than A"));
}
