#include <algorithm>
#include <atomic>
#include <set>

#include "experiments/multiverse.hpp"
#include "experiments/runner.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/samples.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::experiments;

namespace {

const Overrides few{"runs=2", "path.points=2", "stop.iterations=2", "population=6"};

// The universe with one alternative, in a plan with one at a time.
struct AloneInPlan {
  const MultiversePlan::OfStudy* study;
  std::vector<std::vector<std::size_t>> parts;  // by solver, by seed
};

AloneInPlan alone_in(const MultiversePlan& plan, const std::string& set) {
  std::vector<AloneInPlan> found;
  const auto is_it = [&](const Choice& each) {
    return each.alternative > 0 && plan.dimensions[each.dimension].alternatives[each.alternative].set == set;
  };
  const auto parts_of = [&](const MultiversePlan::OfStudy& study, std::size_t solver, std::size_t own) {
    std::vector<std::vector<std::size_t>> parts;
    for (std::size_t s = 0; s < plan.solvers.size(); ++s)
      parts.push_back(study.solvers[s][s == solver ? own : 0].parts);
    return parts;
  };
  for (const MultiversePlan::OfStudy& study : plan.studies) {
    if (std::ranges::any_of(study.chosen, is_it)) found.push_back({&study, parts_of(study, 0, 0)});
    for (std::size_t s = 0; s < plan.solvers.size(); ++s) {
      for (std::size_t own = 0; own < study.solvers[s].size(); ++own) {
        if (std::ranges::any_of(study.solvers[s][own].chosen, is_it))
          found.push_back({&study, parts_of(study, s, own)});
      }
    }
  }
  REQUIRE(found.size() == 1);
  return found.front();
}

// The solvers whose series an alternative changes.
std::set<std::string> moved(const MultiversePlan& plan, const std::string& set) {
  std::set<std::string> labels;
  for (std::size_t s = 0; s < plan.solvers.size(); ++s) {
    if (alone_in(plan, set).parts[s] != plan.studies.front().solvers[s].front().parts) labels.insert(plan.solvers[s]);
  }
  return labels;
}

}  // namespace

TEST_CASE("one at a time each alternative is in one universe, beside the defaults, and changes a series",
          "[multiverse]") {
  const std::vector<Dimension> all = dimensions("slim2023");
  const MultiversePlan plan = plan_multiverse("slim2023", all, {.combined = Combined::one_at_a_time});
  std::int64_t universes = 1;
  for (const Dimension& dimension : all) {
    for (std::size_t a = 1; a < dimension.alternatives.size(); ++a, ++universes) {
      CAPTURE(dimension.alternatives[a].set);
      CHECK_FALSE(moved(plan, dimension.alternatives[a].set).empty());
    }
  }
  const MultiverseSize size = size_of(all, plan.solvers, Combined::one_at_a_time);
  CHECK(size.universes == universes);
  CHECK(size.studies == static_cast<std::int64_t>(plan.studies.size()));
  CHECK(size.series >= static_cast<std::int64_t>(plan.parts.size()));
  CHECK(moved(plan, "search=all_joints").size() == 6);
  CHECK(moved(plan, "BA.best_of=evaluated") == std::set<std::string>{"BA"});
  CHECK(moved(plan, "bounds=clamp") == std::set<std::string>{"IK-BA"});  // the others are clamped already
  CHECK(alone_in(plan, "bounds=clamp").parts == alone_in(plan, "IK-BA.bounds=clamp").parts);
  CHECK(plan.studies.front().out_of_reach == 0);
  CHECK(alone_in(plan, "path.tool=eq27").study->out_of_reach > 0);
}

TEST_CASE("a multiverse in which nothing varies is the study, with the numbers that it has as a whole",
          "[multiverse]") {
  const MultiversePlan plan = plan_multiverse("slim2023", {}, {.overrides = few});
  const std::vector<SolveRecord> whole = solves_of(load_study("slim2023", few));
  std::vector<SolveRecord> parts;
  for (const Study& part : plan.parts) {
    for (SolveRecord& record : solves_of(part)) parts.push_back(std::move(record));
  }
  REQUIRE(parts.size() == whole.size());
  for (const SolveRecord& record : parts) {
    const auto same = std::ranges::find_if(whole, [&](const SolveRecord& other) {
      return other.solver == record.solver && other.run == record.run && other.point == record.point;
    });
    REQUIRE(same != whole.end());
    CHECK(same->answer_rad == record.answer_rad);
    CHECK(same->series == record.series);
  }
}

TEST_CASE("planning and solving without a store end when they are cancelled", "[multiverse]") {
  std::atomic<bool> cancelled{true};
  CHECK(plan_multiverse("slim2023", dimensions("slim2023"),
                        {.combined = Combined::one_at_a_time, .cancelled = &cancelled})
            .parts.empty());
  cancelled = false;
  int taken = 0;
  solve_study(
      small_study(), 1,
      [&](const SolveRecord&) {
        ++taken;
        cancelled = true;
      },
      &cancelled);
  CHECK(taken == 1);
}
