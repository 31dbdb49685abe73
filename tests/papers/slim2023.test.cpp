#include "tests/papers/studies.hpp"

namespace {

double ours(const show::Cell& cell) { return std::get<show::PublishedNumber>(cell).ours; }
std::string printed(const show::Cell& cell) { return std::get<show::PublishedNumber>(cell).printed; }

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

TEST_CASE("Tables 1 and 2 have what was used beside the printed numbers", "[papers]") {
  JudgedStudy study = helix();
  study.study.series[3].options = R"({"inertia": 0.5, "social": 1.1})";  // PSO's
  study.study.definition.arm = R"({"links": [{"alpha_deg": -90, "a_m": 0, "d_m": 0.36, "limits_deg": [-170, 170]}]})";
  const show::Table settings = slim2023::table_1(study.study), arm = slim2023::table_2(study.study);
  REQUIRE(settings.rows.size() == 22);
  CHECK(ours(settings.rows[13][2]) == 0.5);
  CHECK(printed(settings.rows[13][2]) == "1.1312");
  CHECK(std::isnan(ours(settings.rows[14][2])));  // is not used
  REQUIRE(arm.rows.size() == 1);
  CHECK(ours(arm.rows[0][3]) == 0.36);
  CHECK(printed(arm.rows[0][3]) == "d1");
  CHECK(printed(arm.rows[0][4]) == "170");
}

TEST_CASE("Tables 3 to 6 have ours beside the printed numbers", "[papers]") {
  const show::Table table = slim2023::table_3(repeated(helix()));
  REQUIRE(table.rows.size() == 30);
  CHECK(printed(table.rows[12][2]) == "1.7824e-4");
  CHECK(ours(table.rows[12][2]) == Approx(helix().metrics[0].descriptives[0].sd));
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
  CHECK(contains(angles->notes[0], "3 of 4 angles"));
}

TEST_CASE("the first sentences say whether the conclusion repeats, and on what it hangs", "[papers]") {
  const JudgedStudy context = study_of({.name = "slim2023-context", .solvers = {"DLS"}},
                                       [](SolveRecord& solve) { solve.position_error_cm = 1e-6 * solve.run; });
  const JudgedStudy of_50 = study_of({.name = "slim2023-50"});
  const Repeated of = repeated(helix(), {&of_50, &all_joints(), &context});
  const std::vector<JudgedClaim> claims = judged_claims(of, {{"most_accurate", {.hold = 3, .seeds = 3}}});
  std::vector<papers::SeedCounts> counts{
      {.reading = "20 agents", .all = {39, 37}, .of = 60, .same = {55, 57}, .other_rows = {15, 14}},
      {.reading = "50 agents", .all = {6, 6}, .of = 60}};
  const std::vector<std::string> sentences = slim2023::sentences(claims, counts);
  REQUIRE(sentences.size() == 5);
  CHECK(sentences[0] ==
        "The conclusion of Slim et al. 2023 holds with 20 and with 50 agents; with so few runs, 1 claim is "
        "inconclusive.");
  CHECK(
      sentences[1] ==
      "We reproduce 37 to 39 of the 60 error and motion statistics in Table 3 with 20 agents and 6 with 50 agents, "
      "over 2 seeds. Another solver's row would match 14 to 15, the authors' own program 55 to 57: our program is close to "
      "theirs but not the same.");
  counts[0].all = {15, 12};
  CHECK(
      contains(slim2023::sentences(claims, counts)[1], ": our program is no closer to theirs than another solver is."));
  counts[0].all = {55, 60};
  CHECK(contains(slim2023::sentences(claims, counts)[1], ": our program reproduces as many as theirs would."));
  CHECK(slim2023::sentences(claims, {})[0] ==
        "The conclusion of Slim et al. 2023 holds with 20 and with 50 agents; with so few runs, 1 claim is "
        "inconclusive.");
  CHECK(contains(sentences[2], "the smallest error and, with MO-PSO, the least joint motion."));
  CHECK(contains(sentences[3], "holds in the default interpretation (0.00194 cm, K-ABC"));
  CHECK(contains(sentences[3],
                 "Of 1 interpretation with 3 seeds each (3), it holds in 3, is inconclusive in 0 and fails in 0."));
  CHECK(sentences[4] == "Not in the paper, but more accurate: DLS 1.05e-05 cm.");
  std::vector<show::Blocks> sections = slim2023::sections(of);
  sections.insert(sections.begin(), claims_section(claims));
  std::vector<std::string> headings;
  for (const show::Blocks& blocks : sections) headings.push_back(std::get<show::Heading>(blocks.front()).text);
  CHECK(headings == std::vector<std::string>{"The claims", "Tables 1 and 2", "Table 3", "Tables 4 to 6"});
  REQUIRE(sections[2].size() == 3);
  CHECK(std::get<show::Table>(sections[2].back()).name == "table-3-50");
}
