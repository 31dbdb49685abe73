#include "tests/experiments/samples.hpp"

namespace {

const Overrides tiny{"runs=2", "path.points=2", "stop.iterations=2", "population=6"};

// Each alternative but the first contradicts the setting `except`.
Dimension dimension(const std::string& name, const std::vector<std::string>& answers, const std::string& except = "") {
  Dimension one;
  for (const std::string& answer : answers)
    one.push_back({.set = name + '=' + answer, .where = "", .except = one.empty() ? "" : except});
  return one;
}

const Dimension bounds = dimension("bounds", {"per_solver", "initial", "clamp"}),
                search = dimension("search", {"wrist", "all_joints"}),
                of_bats = dimension("IK-BA.bounds", {"initial", "clamp"}),
                of_de = dimension("DE.bounds", {"clamp", "reflect", "resample", "initial"}),
                branch = dimension("wrist_branch", {"nearest", "positive", "negative", "inside"}, "search=all_joints");

}  // namespace

TEST_CASE("the first alternative of every dimension is the default, and every other is not", "[multiverse]") {
  const Study usual = load_study("slim2023");
  const auto keys_of = [](const Study& study) {
    std::vector<std::string> keys{to_json(study.plan)};
    for (const SolverEntry& entry : study.solvers) keys.push_back(series_key(study, entry));
    return keys;
  };
  std::set<std::string> names, earlier;  // settings of the dimensions before
  for (const Dimension& dimension : read_dimensions("slim2023")) {
    const std::string& first = dimension.front().set;
    const std::string name = first.substr(0, first.find('=') + 1);
    CHECK(names.insert(name).second);
    std::set<std::string> own;
    for (const Alternative& each : dimension) {
      CAPTURE(each.set);
      CHECK(each.set.starts_with(name));
      CHECK(own.insert(each.set).second);
      CHECK(!each.where.empty());
      CHECK((each.except.empty() || earlier.contains(each.except)));
      const bool is_default = &each == &dimension.front();
      CHECK((keys_of(load_study("slim2023", {each.set})) == keys_of(usual)) == is_default);
    }
    earlier.merge(own);
  }
}

TEST_CASE("a plan has every combination of the alternatives that go together, each series once", "[multiverse]") {
  const MultiversePlan plan = plan_multiverse("slim2023", {bounds, search, of_de, branch}, 2, tiny);
  REQUIRE(plan.solvers.size() == 6);
  CHECK(plan.readings.size() == 3 * 4 * (4 + 1));  // wrist_branch has no effect if all joints are searched
  CHECK(plan.readings.front().settings ==
        Overrides{"bounds=per_solver", "search=wrist", "DE.bounds=clamp", "wrist_branch=nearest"});
  std::set<Overrides> readings;
  std::set<std::size_t> used;
  for (const auto& [settings, parts] : plan.readings) {
    CHECK(readings.insert(settings).second);
    for (std::size_t s = 0; s < parts.size(); ++s) {
      REQUIRE(parts[s].size() == 2);
      for (const std::size_t part : parts[s]) {
        used.insert(part);
        CHECK(plan.parts[part].seed == (part == parts[s][0] ? 1 : 2));
        CHECK(plan.parts[part].solvers.front().label == plan.solvers[s]);
      }
    }
  }
  CHECK(used.size() == plan.parts.size());
  std::set<std::string> keys;
  for (const Study& part : plan.parts) {
    REQUIRE(part.solvers.size() == 1);
    CHECK(keys.insert(series_key(part, part.solvers.front())).second);
  }
}

TEST_CASE("the series of a reading are solved with what its settings say, defaults too", "[multiverse]") {
  Overrides unclamped = tiny;
  unclamped.emplace_back("bounds=initial");
  const MultiversePlan plan = plan_multiverse("slim2023", {of_bats, of_de}, 1, unclamped);
  CHECK(plan.readings.size() == 2 * 4);
  for (const auto& [settings, parts] : plan.readings) {
    for (const std::string& setting : settings) {
      const std::string solver = setting.substr(0, setting.find('.'));
      const auto s = std::ranges::find(plan.solvers, solver) - plan.solvers.begin();
      const Study& part = plan.parts[parts[static_cast<std::size_t>(s)].front()];
      CHECK(setting.ends_with("bounds=" + text_of(effective_options(part, part.solvers.front()).at("bounds"))));
    }
  }
}

TEST_CASE("the parts of a plan have the means of their runs, by any number of jobs; cancelled, none", "[multiverse]") {
  // One search stands for several wrists only if no limit and no wrap changes where the next solve starts.
  const std::string set = GENERATE("limits=recorded", "limits=enforced", "wrap=into_limits");
  const Overrides few{set, "runs=3", "path.points=3", "stop.iterations=6", "population=6"};
  const auto parts = plan_multiverse("slim2023", {branch}, 1, few).parts;
  const std::vector<SeriesMeans> means = solve_multiverse(parts, {.jobs = 1}),
                                 again = solve_multiverse(parts, {.jobs = 3});
  REQUIRE(means.size() == parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    CHECK(again[i].error_cm == means[i].error_cm);
    CHECK(again[i].variation_deg == means[i].variation_deg);
    SeriesMeans by_hand{std::vector<double>(3), std::vector<double>(3)};
    for (const SolveRecord& solve : solve_all(parts[i])) {
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
  CHECK(solve_multiverse(parts, request).empty());
}
