#include "tests/papers/studies.hpp"

namespace {

double ours(const show::Cell& cell) { return std::get<show::Printed>(cell).ours; }
std::string printed(const show::Cell& cell) { return std::get<show::Printed>(cell).printed; }

const JudgedStudy& helix() {
  static const JudgedStudy study = study_of({});
  return study;
}

// IK-BA is beaten by DE.
const JudgedStudy& all_joints() {
  static const JudgedStudy study = study_of({.name = "slim2023-all-joints"}, [](SolveRecord& solve) {
    if (solve.label == "DE") solve.position_error_cm = 1e-5 * solve.run;
  });
  return study;
}

}  // namespace

TEST_CASE("Tables 3 to 6 have ours beside the printed numbers", "[papers]") {
  const show::Table table = slim2023::table_3(repeated(helix()));
  REQUIRE(table.rows.size() == 30);
  CHECK(printed(table.rows[12][2]) == "1.7824e-4");
  CHECK(ours(table.rows[12][2]) == Approx(helix().metrics[0].described[0].sd));
  CHECK(printed(table.rows[0][4]) == "0.2439");
  CHECK(table.name == "table-3");
  CHECK(table.caption.starts_with("Table 3 with 20 agents"));
  const std::vector<show::Table> anovas = slim2023::anova_tables(repeated(helix()));
  REQUIRE(anovas.size() == 3);
  CHECK(anovas[0].name == "table-4");
  CHECK(printed(anovas[0].rows[0][5]) == "7.2225e-24");
  CHECK(ours(anovas[0].rows[2][2]) == 119);
  CHECK(ours(anovas[0].rows[0][1]) + ours(anovas[0].rows[1][1]) == Approx(ours(anovas[0].rows[2][1])));
}

TEST_CASE("Tables 7 and 8 are of random targets and of the circle", "[papers]") {
  const JudgedStudy times = study_of(
      {.name = "slim2023-time", .path = "random", .solvers = {"12 bats"}, .runs = 1, .points = 20, .tolerance_cm = 0.1},
      [](SolveRecord& solve) {
        solve.position_error_cm = solve.point < 4 ? 0.5 : 0.05;
        solve.seconds = 0.001 * solve.point;
      });
  const auto table = slim2023::table_7(times.study);
  REQUIRE(table);
  CHECK(std::get<std::int64_t>(table->rows[0][2]) == 17);
  CHECK(ours(table->rows[0][7]) == 20);  // the slowest [ms]
  CHECK(printed(table->rows[0][7]) == "67.2");
  CHECK_FALSE(slim2023::table_7(helix().study));

  constexpr double degree = 0.017453292519943295;
  const JudgedStudy circle =
      study_of({.name = "slim2023-dobot", .path = "circle", .solvers = {"IK-BA"}, .points = 1}, [](SolveRecord& solve) {
        solve.answer_rad = {34.84 * degree, 66.5 * degree, 49.6 * degree};
      });
  const auto angles = slim2023::table_8(circle.study);
  REQUIRE(angles);
  CHECK(angles->rows.size() == 1);
  CHECK(printed(angles->rows[0][5]) == "2.04e-14");
  CHECK(contains(angles->notes[0], "3 of 4 printed angles"));
}

TEST_CASE("the first sentences say whether the conclusion repeats, and on what it hangs", "[papers]") {
  const JudgedStudy context = study_of({.name = "slim2023-context", .solvers = {"DLS"}},
                                       [](SolveRecord& solve) { solve.position_error_cm = 1e-6 * solve.run; });
  const JudgedStudy of_50 = study_of({.name = "slim2023-50"});
  const Repeated of = repeated(helix(), {&of_50, &all_joints(), &context});
  const std::vector<JudgedClaim> claims = judged_claims(of, {{"most_accurate", {.hold = 3}}});
  const std::vector<std::string> sentences =
      slim2023::sentences(claims, {{"20 agents", 7, 60, {"error 1 cm", "motion 2 deg"}}, {"50 agents", 6, 60, {}}});
  REQUIRE(sentences.size() == 5);
  CHECK(sentences[0] ==
        "Slim et al. 2023 repeats in its conclusion by both readings, and in 7 of the 60 statistics of error and joint "
        "motion in Table 3 with 20 agents, 6 with 50 agents; the paper's own program would repeat about 55.");
  CHECK(sentences[1] == "IK-BA's mean error 1 cm and mean motion 2 deg do not repeat with 20 agents.");
  CHECK(slim2023::sentences(claims, {{}})[0] ==
        "Slim et al. 2023 repeats in its conclusion by both readings; so few runs leave 1 claim open.");
  CHECK(contains(sentences[2], "the least error, and with MO-PSO the least joint motion."));
  CHECK(contains(sentences[3], "holds in the default reading (0.00194 cm, K-ABC"));
  CHECK(contains(sentences[3], "It holds in 3 of 3 readings, is open in 0 and fails in 0."));
  CHECK(sentences[4] == "More accurate, and not in the paper: DLS 1.05e-05 cm.");
  std::vector<show::Blocks> sections = slim2023::sections(of);
  sections.insert(sections.begin(), claims_section(claims));
  std::vector<std::string> headings;
  for (const show::Blocks& blocks : sections) headings.push_back(std::get<show::Heading>(blocks.front()).text);
  CHECK(headings == std::vector<std::string>{"The claims", "Table 3", "Tables 4 to 6"});
  REQUIRE(sections[1].size() == 3);
  CHECK(std::get<show::Table>(sections[1].back()).name == "table-3-50");
}
