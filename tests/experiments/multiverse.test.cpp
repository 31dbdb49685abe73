#include "tests/experiments/samples.hpp"

namespace {

const Overrides tiny{"runs=2", "path.points=2", "stop.iterations=2", "population=6"};

// Each answer contradicts the settings in `except`.
Dimension dimension(const std::string& name, const std::vector<std::string>& answers, const std::string& label = "",
                    const std::vector<std::string>& except = {}) {
  Dimension one{.name = name, .label = label, .alternatives = {}};
  for (const std::string& answer : answers)
    one.alternatives.push_back({.set = name + '=' + answer,
                                .where = "",
                                .except = answer == answers.front() ? std::vector<std::string>() : except});
  return one;
}

const Dimension bounds = dimension("bounds", {"per_solver", "initial", "clamp"}),
                search = dimension("search", {"wrist", "all_joints"}),
                bounds_of_de = dimension("DE.bounds", {"clamp", "reflect", "resample", "initial"}, "DE",
                                         {"bounds=initial", "bounds=clamp"}),
                branch =
                    dimension("wrist_branch", {"nearest", "positive", "negative", "inside"}, "", {"search=all_joints"});

}  // namespace

TEST_CASE("the first alternative of every dimension is the default, and every other is not", "[multiverse]") {
  const Study usual = load_study("slim2023");
  const auto keys_of = [](const Study& study) {
    std::vector<std::string> keys{to_json(study.plan)};
    for (const SolverEntry& entry : study.solvers) keys.push_back(series_key(study, entry));
    return keys;
  };
  std::set<std::string> names, earlier;  // settings of the dimensions before
  for (const Dimension& dimension : dimensions("slim2023")) {
    CHECK(names.insert(dimension.name).second);
    std::set<std::string> own;
    for (const Alternative& each : dimension.alternatives) {
      CAPTURE(each.set);
      CHECK(each.set.starts_with(dimension.name + "="));
      CHECK(own.insert(each.set).second);
      CHECK(!each.where.empty());
      for (const std::string& excepted : each.except) CHECK(earlier.contains(excepted));
      const bool is_default = &each == &dimension.alternatives.front();
      CHECK((keys_of(load_study("slim2023", {each.set})) == keys_of(usual)) == is_default);
    }
    earlier.merge(own);
  }
}

TEST_CASE("a plan has every combination of the alternatives that go together, each series once", "[multiverse]") {
  // wrist_branch has no effect if all joints are searched; DE.bounds contradicts a choice for all solvers.
  const MultiversePlan plan =
      plan_multiverse("slim2023", {bounds, search, bounds_of_de, branch}, {.seeds = 1, .overrides = tiny});
  REQUIRE(plan.solvers.size() == 6);
  CHECK(plan.studies.size() == 3 * (4 + 1));
  const auto de = static_cast<std::size_t>(std::ranges::find(plan.solvers, "DE") - plan.solvers.begin());
  std::int64_t series = 0;
  std::set<std::size_t> used;
  for (const MultiversePlan::OfStudy& study : plan.studies) {
    const auto has = [&](const std::string& set) {
      return std::ranges::any_of(study.chosen, [&](const results::Choice& each) {
        return plan.dimensions[each.dimension].alternatives[each.alternative].set == set;
      });
    };
    const bool has_wrist = has("search=wrist");
    CHECK(study.chosen.size() == (has_wrist ? 3 : 2));
    CHECK(study.solvers[de].size() == (has("bounds=per_solver") ? 4 : 1));
    for (const auto& of_solver : study.solvers) {
      series += static_cast<std::int64_t>(of_solver.size());
      for (const auto& own : of_solver) used.insert(own.parts.begin(), own.parts.end());
    }
  }
  CHECK(used.size() == plan.parts.size());
  std::set<std::string> keys;
  for (const Study& part : plan.parts) {
    REQUIRE(part.solvers.size() == 1);
    CHECK(keys.insert(series_key(part, part.solvers.front())).second);
  }
  CHECK(series > static_cast<std::int64_t>(plan.parts.size()));
  CHECK(plan.studies.front().chosen == Chosen{{0, 0}, {1, 0}, {3, 0}});
}

TEST_CASE("the series of a universe are solved with what its choices say, defaults too", "[multiverse]") {
  Overrides unclamped = tiny;
  unclamped.emplace_back("bounds=initial");
  const Dimension of_bats = dimension("IK-BA.bounds", {"initial", "clamp"}, "IK-BA"),
                  of_de = dimension("DE.bounds", {"clamp", "reflect", "resample", "initial"}, "DE");
  const MultiversePlan plan = plan_multiverse("slim2023", {of_bats, of_de}, {.seeds = 1, .overrides = unclamped});
  int checked = 0;
  for (const auto& of_solver : plan.studies.front().solvers) {
    for (const MultiversePlan::ChosenSolver& own : of_solver) {
      const Study& part = plan.parts[own.parts.front()];
      if (own.chosen.empty()) continue;
      const results::Choice& choice = own.chosen.front();
      CHECK(plan.dimensions[choice.dimension].alternatives[choice.alternative].set.ends_with(
          "bounds=" + text_of(effective_options(part, part.solvers.front()).at("bounds"))));
      ++checked;
    }
  }
  CHECK(checked == 2 + 4);
}

TEST_CASE("the parts of a plan have the means of their runs, by any number of jobs; cancelled, none", "[multiverse]") {
  // One search stands for several wrists only where no limit and no wrap changes where the next one starts.
  const std::string set = GENERATE("limits=recorded", "limits=enforced", "wrap=into_limits");
  const Overrides few{set, "runs=3", "path.points=3", "stop.iterations=6", "population=6"};
  const auto parts = plan_multiverse("slim2023", {branch}, {.seeds = 1, .overrides = few}).parts;
  const std::vector<PartMeans> means = solve_parts(parts, {.jobs = 1}), again = solve_parts(parts, {.jobs = 3});
  REQUIRE(means.size() == parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    CHECK(again[i].error_cm == means[i].error_cm);
    CHECK(again[i].variation_deg == means[i].variation_deg);
    PartMeans by_hand{std::vector<double>(3), std::vector<double>(3)};
    for (const SolveRecord& solve : solves_of(parts[i])) {
      const auto value = static_cast<std::size_t>(solve.run) - 1;
      double squares = 0;
      for (std::size_t j = 0; j < 7; ++j) squares += std::pow((solve.answer_rad[j] - solve.start_rad[j]) / degree, 2);
      by_hand.error_cm[value] += solve.position_error_cm / 3;
      by_hand.variation_deg[value] += std::sqrt(squares) / 3;
    }
    for (std::size_t value = 0; value < 3; ++value) {
      CHECK(means[i].error_cm[value] == Approx(by_hand.error_cm[value]).epsilon(1e-12));
      CHECK(means[i].variation_deg[value] == Approx(by_hand.variation_deg[value]).epsilon(1e-12));
    }
  }
  std::atomic<bool> cancelled{false};
  const RunRequest request{.progress = [&](const Progress& progress) { cancelled = progress.done > 0; },
                           .cancelled = &cancelled};
  CHECK(solve_parts(parts, request).empty());
}
