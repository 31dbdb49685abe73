// Which targets which solvers solve, and the solvers that together solve most.
#include "analysis/judge/solved_targets.hpp"

#include "tests/judge/studies.hpp"

namespace {

using Names = std::vector<std::string>;

// A study of one run, in which each solver solves the points of its row that are marked.
std::optional<HardTargets> hard_of(const std::vector<std::pair<std::string, std::string>>& rows) {
  Names solvers;
  for (const auto& [solver, solved] : rows) solvers.push_back(solver);
  const Asked asked{
      .start = "middle", .runs = 1, .points = static_cast<int>(rows.front().second.size()), .tolerance_cm = 1};
  const StudyResults of_rows = study(
      asked,
      [&](SolveRecord& solve) {
        const auto& solved = std::ranges::find(rows, solve.label, &std::pair<std::string, std::string>::first)->second;
        if (solved[static_cast<std::size_t>(solve.point - 1)] != '#') solve.status = Status::tolerance_missed;
      },
      solvers);
  return hard_targets(solved_targets(of_rows), solvers);
}

}  // namespace

TEST_CASE("each drawn target is one of its run, and a fixed one is solved if it is in any run", "[solved_targets]") {
  const auto solved_once = [](SolveRecord& solve) {
    solve.evaluations = 10 * solve.run + (solve.label == "B" ? 1 : 0);
    solve.seconds = solve.label == "B" ? 0.001 : 0.002;
    if (solve.point > 2 || solve.run != (solve.label == "A" ? 3 : 2)) solve.status = Status::tolerance_missed;
  };
  Asked asked{.start = "middle", .runs = 4, .points = 3, .tolerance_cm = 1};
  const SolvedTargets fixed = solved_targets(study(asked, solved_once));
  CHECK(fixed.targets.size() == 3);
  CHECK(fixed.are_repeated);
  CHECK(fixed.is_complete);
  CHECK(fixed.targets[0].run == 0);
  CHECK(fixed.targets[0].solvers == 2);
  CHECK(fixed.targets[2].solvers == 0);
  CHECK(fixed.targets[0].fewest_evaluations == std::pair(std::size_t{1}, std::int64_t{21}));
  CHECK(fixed.targets[0].least_seconds == std::pair(std::size_t{1}, 0.001));
  CHECK(!fixed.targets[2].least_seconds);
  CHECK(!do_solvers_differ(fixed));
  asked.targets = "drawn";
  const SolvedTargets drawn = solved_targets(study(asked, solved_once));
  CHECK(drawn.targets.size() == 12);
  CHECK(!drawn.are_repeated);
  CHECK(drawn.targets[3].run == 2);
  CHECK(drawn.targets[3].solvers == 1);
  CHECK(drawn.solves(1, 3));
  CHECK(!drawn.solves(0, 3));
  CHECK(do_solvers_differ(drawn));
  asked.tolerance_cm = 0;
  CHECK(solved_targets(study(asked, solved_once)).targets.empty());
}

TEST_CASE("evaluations that no one counts and times of elsewhere are not the least", "[solved_targets]") {
  const SolvedTargets all =
      solved_targets(study({.start = "middle", .runs = 1, .points = 2, .tolerance_cm = 1}, [](SolveRecord& solve) {
        if (solve.label == "A") solve.evaluations = 1;
        if (solve.label == "A") solve.counted_by = CountedBy::none;
        solve.timing = solve.point == 1 ? Timing::elsewhere : Timing::parallel;
      }));
  CHECK(all.targets[0].fewest_evaluations->first == 1);
  CHECK(!all.targets[0].least_seconds);
  CHECK(!all.targets[1].least_seconds);
}

TEST_CASE("the smallest set of solvers that solves all solvable targets is named", "[solved_targets]") {
  const auto two = hard_of({{"A", "###..."}, {"B", "#.##.."}});
  REQUIRE(two);
  CHECK(two->targets == 6);
  CHECK(two->unsolved == 2);
  CHECK(two->alone.empty());
  CHECK(two->together == Names{"A", "B"});
  CHECK(two->solved_together == 4);
  const auto alone = hard_of({{"A", "#...."}, {"B", "###.."}, {"C", "###.."}});
  CHECK(alone->alone == Names{"B", "C"});
  CHECK(alone->together.empty());
  // Of pairs that solve as many, the first.
  CHECK(hard_of({{"A", "##.."}, {"B", "..##"}, {"C", "..##"}})->together == Names{"A", "B"});
  const auto three = hard_of({{"A", "##..."}, {"B", "..##."}, {"C", "#...#"}, {"D", "....."}});
  CHECK(three->together == Names{"A", "B", "C"});
  CHECK(three->solved_together == 5);
  const auto four = hard_of({{"A", "##..."}, {"B", "..#.."}, {"C", "...#."}, {"D", "....#"}});
  CHECK(four->together == Names{"A", "B"});
  CHECK(four->solved_together == 3);
}

TEST_CASE("nothing is said of targets where solvers do not differ, or one solves all", "[solved_targets]") {
  CHECK(!hard_of({{"A", "##.."}}));
  CHECK(!hard_of({{"A", "##.."}, {"B", "##.."}}));
  CHECK(!hard_of({{"A", "...."}, {"B", "...."}}));
  CHECK(!hard_of({{"A", "####"}, {"B", "##.."}}));
  // A solver that lacks solves may still solve the others.
  StudyResults incomplete =
      study({.start = "middle", .runs = 1, .points = 4, .tolerance_cm = 1}, [](SolveRecord& solve) {
        if (solve.point % 2 == (solve.label == "A" ? 0 : 1)) solve.status = Status::tolerance_missed;
      });
  CHECK(hard_targets(solved_targets(incomplete), {"A", "B"}));
  incomplete.solves.pop_back();
  CHECK(!hard_targets(solved_targets(incomplete), {"A", "B"}));
}

TEST_CASE("many solvers and targets are searched in a bounded time", "[solved_targets]") {
  SolvedTargets all{.targets = std::vector<SolvedTarget>(2000, SolvedTarget{.solvers = 1}), .is_complete = true};
  for (int i = 0; i < 400; ++i) all.solvers.push_back(fmt::format("S{}", i));
  all.is_solved.resize(all.targets.size() * all.solvers.size());
  for (std::size_t i = 0; i < all.targets.size(); ++i) all.is_solved[i * 400 + i % 400] = true;
  CHECK(hard_targets(all, all.solvers)->solved_together == 10);
}
