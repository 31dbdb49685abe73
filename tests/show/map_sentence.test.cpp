// The sentence about a grid of targets, and a report without any test.
#include "analysis/show/map_sentence.hpp"

#include "tests/show/judged.hpp"

namespace {

// Returns a study of a grid. A solver is given by the targets that it solves: "++-+-".
judge::JudgedStudy grid_study(const std::vector<std::pair<std::string, std::string>>& solvers) {
  judge::JudgedStudy judged;
  results::StudyDefinition& study = judged.study.definition;
  study.search = results::Search::pose;
  study.points = static_cast<int>(solvers.front().second.size());
  study.grid = {.step = 0.05, .across = {1, 0, 0}, .up = {0, 0, 1}, .shoulder = {0, 0, 0.2}, .reach = 1, .left_out = 7};
  judge::SolvedTargets& all = judged.targets;
  all.is_complete = true;
  for (int point = 1; point <= study.points; ++point) {
    judge::SolvedTarget& target = all.targets.emplace_back(judge::SolvedTarget{.point = point});
    for (const auto& [name, solved] : solvers) {
      const bool is_solved = solved[static_cast<std::size_t>(point - 1)] == '+';
      all.is_solved.push_back(is_solved);
      if (is_solved) ++target.solvers;
    }
  }
  for (const auto& [name, solved] : solvers) all.solvers.push_back(name);
  return judged;
}

}  // namespace

TEST_CASE("a grid has a sentence for each case", "[show]") {
  std::string all;
  const auto add = [&](const judge::JudgedStudy& judged) {
    all += map_sentence(judged, judged.targets.solvers) + '\n';
  };
  add(grid_study({{"LM", "+++--"}, {"DLS", "+++--"}, {"Newton", "++---"}, {"KDL", "-----"}}));
  add(grid_study({{"LM", "++++-"}, {"DLS", "+-++-"}}));
  add(grid_study({{"LM", "++--+"}, {"DLS", "++-+-"}}));
  add(grid_study({{"LM", "++++-"}, {"DLS", "++++-"}}));
  add(grid_study({{"LM", "+++++"}, {"DLS", "++++-"}}));
  add(grid_study({{"LM", "-----"}, {"DLS", "-----"}}));
  add(grid_study({{"LM", "++---"}}));
  add(grid_study({{"LM", "-----"}}));
  const std::vector<std::pair<std::string, std::string>> many{{"LM", "+++++"},   {"full", "++++-"}, {"twice", "++++-"},
                                                              {"less", "+++--"}, {"PSO", "++---"},  {"DE", "-----"}};
  add(grid_study(many));
  judge::JudgedStudy partial = grid_study(many);
  partial.targets.is_complete = false;
  add(partial);
  add(grid_study({{"LM", "+---"}, {"DLS", "+---"}}));
  add(grid_study({{"LM", "+---"}, {"DLS", "----"}}));
  add(grid_study({{"LM", "+---"}}));
  add(grid_study({{"LM", "-"}}));
  add(grid_study({{"LM", "-"}, {"DLS", "-"}}));
  judge::JudgedStudy judged = grid_study({{"LM", "+++--"}, {"DLS", "+----"}});
  judged.targets.is_complete = false;
  add(judged);
  judged.targets.is_complete = true;
  judged.study.definition.grid.shoulder = {0, -0.1234, 0};
  judged.study.definition.grid.tool = results::TargetGrid::Tool::directions;
  judged.study.definition.grid.directions = 8;
  add(judged);
  judged.study.definition.search = results::Search::all_joints;
  judged.study.definition.grid.tool = results::TargetGrid::Tool::zero;
  judged.study.definition.grid.up = {0, 1, 0};
  judged.study.definition.grid.shoulder = {0, 0, 0.5};
  add(judged);
  judged.study.definition.search = results::Search::pose;
  judged.study.definition.grid.up = {0, 0.6, 0.8};
  add(judged);
  check_golden("map-sentence.txt", all);
}

TEST_CASE("below its table a grid says that nothing is tested, what was left out, and who has a limit", "[show]") {
  judge::JudgedStudy judged = grid_study({{"LM", "+++--"}, {"KDL", "+----"}});
  judged.study.series.push_back({.label = "LM", .options = "{}"});
  judged.study.series.push_back({.label = "KDL", .options = R"({"iterations": 100})"});
  const std::vector<std::string> notes = map_notes(judged.study);
  REQUIRE(notes.size() == 3);
  CHECK(contains(notes[1], "7 "));
  CHECK(contains(notes[2], "KDL stops after its own 100 iterations"));
}

TEST_CASE("samples of a grid have neither intervals nor marks", "[show]") {
  judge::MetricSamples samples = shares({{"LM", solved(18)}, {"PSO", solved(3)}});
  samples.is_random = false;
  ReportModel model = make_report_model({judge::judge(samples, {}, {})});
  model.verdict = "LM reaches 18 poses.";
  const std::string screen = terminal_report(model);
  CHECK(!contains(screen, "("));
  CHECK(!contains(screen, "*"));
  CHECK(!contains(screen, "p <"));
  CHECK(contains(headline(model), "LM reaches 18 poses."));
  CHECK(to_json(model)["comparisons"].empty());
  CHECK(to_json(model)["tests"].empty());
}
