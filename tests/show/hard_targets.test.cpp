// The table of targets, and the sentence about hard ones.
#include "analysis/show/hard_targets.hpp"

#include "tests/show/judged.hpp"

namespace {

judge::SolvedTargets some_targets(std::size_t count) {
  judge::SolvedTargets all{.solvers = {"LM", "DE"}, .is_complete = true};
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t solvers = (i + 2) % 3;
    judge::SolvedTarget& target =
        all.targets.emplace_back(judge::SolvedTarget{.run = 1, .point = static_cast<int>(i + 1), .solvers = solvers});
    if (solvers > 0) target.fewest_evaluations = {0, 12};
    if (solvers > 1) target.least_seconds = {1, 0.0005};
    all.is_solved.push_back(solvers > 0);
    all.is_solved.push_back(solvers > 1);
  }
  return all;
}

}  // namespace

TEST_CASE("hard targets have a sentence for each case", "[show]") {
  using judge::HardTargets;
  std::string all;
  const auto add = [&](HardTargets hard) {
    for (const bool are_repeated : {false, true}) {
      hard.are_repeated = are_repeated;
      all += hard_targets_sentence(hard) + '\n';
    }
  };
  const std::vector<std::string> two{"DE", "IK-BA"};
  add({.targets = 30, .unsolved = 12, .together = two, .solved_together = 18});
  add({.targets = 30, .unsolved = 12, .together = {"DE", "IK-BA", "LM"}, .solved_together = 18});
  add({.targets = 30, .unsolved = 12, .together = two, .solved_together = 17});
  add({.targets = 30, .unsolved = 12, .alone = {"DE"}});
  add({.targets = 30, .unsolved = 12, .alone = two});
  add({.targets = 30, .unsolved = 29, .alone = {"A", "B", "C", "D", "E"}});
  add({.targets = 30, .together = two, .solved_together = 30});
  add({.targets = 30, .together = two, .solved_together = 29});
  check_golden("hard-targets.txt", all);
}

TEST_CASE("the table of targets has the hardest first, and its files have all", "[show]") {
  const Table table = targets_table(some_targets(13));
  CHECK(to_csv(table) ==
        "run,target,solvers,solved by,fewest evaluations,fewest by,least time [ms],fastest\n"
        "1,2,0,,,,,\n1,5,0,,,,,\n1,8,0,,,,,\n1,11,0,,,,,\n"
        "1,3,1,LM,12,LM,,\n1,6,1,LM,12,LM,,\n1,9,1,LM,12,LM,,\n1,12,1,LM,12,LM,,\n"
        "1,1,2,LM; DE,12,LM,0.5,DE\n1,4,2,LM; DE,12,LM,0.5,DE\n1,7,2,LM; DE,12,LM,0.5,DE\n"
        "1,10,2,LM; DE,12,LM,0.5,DE\n1,13,2,LM; DE,12,LM,0.5,DE\n");
  CHECK(table.visible_rows == 10);
  CHECK(targets_table(some_targets(1)).rows.empty());
  const Table many = targets_table(some_targets(10'002));
  CHECK(many.rows.size() == 10'000);
  CHECK(many.notes.size() == 2);
}

TEST_CASE("a report has the sentence on its screen, its page and in its data, only if there is one", "[show]") {
  judge::JudgedStudy study = judged_study();
  const auto is_in = [](const judge::JudgedStudy& judged) {
    const Report report = make_report(judged, {});
    const std::string sentence = "No solver solves 4 of the 13 targets; DLS solves the other 9.";
    const bool is_on_screen = contains(terminal_report(report.model), sentence);
    CHECK(contains(to_markdown(report_sections(report), "none"), sentence) == is_on_screen);
    CHECK(to_json(report.model).contains("hard_targets") == is_on_screen);
    if (is_on_screen) CHECK(to_json(report.model)["hard_targets"]["sentence"] == sentence);
    return is_on_screen;
  };
  CHECK(!is_in(study));
  study.targets = some_targets(13);
  study.targets.solvers = {"DLS", "PSO"};
  CHECK(is_in(study));
}
