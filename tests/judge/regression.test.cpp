#include "analysis/judge/data/imported.hpp"
#include "tests/judge/studies.hpp"

namespace {

const Asked of_100{.start = "initial", .runs = 1, .points = 100, .tolerance_cm = 0.1};
const Asked drawn_100{.start = "initial", .targets = "drawn", .runs = 1, .points = 100, .tolerance_cm = 0.1};
// A study of one solver whose numbers are drawn: 70 of 100 targets are solved, with about 100 evaluations, the others
// use up 1000.
StudyResults version(
    int seed, const Asked& asked = of_100, const Change& change = [](SolveRecord&) {}) {
  std::mt19937 random(static_cast<unsigned>(seed));
  std::lognormal_distribution<double> factor(0, 0.3);
  const auto draw = [&](SolveRecord& solve) {
    const bool is_solved = (solve.point * 7) % 10 < 7;
    solve.status = is_solved ? Status::ok : Status::tolerance_missed;
    solve.evaluations = is_solved ? std::lround(100 * factor(random)) : 1000;
    solve.position_error_cm = is_solved ? 0.01 : 5 * factor(random);
    solve.variation_deg = 30 * factor(random);
    solve.seconds = solve.cpu_seconds = 1e-5 * static_cast<double>(solve.evaluations);
    change(solve);
  };
  return study(asked, draw, {"mine"}, {{.id = 1, .environment = {{"cpu", "one"}, {"analysis", "{}"}}}});
}

RegressionCheck check_of(const StudyResults& before, const StudyResults& after, std::size_t labels = 1,
                         const RegressionOptions& options = {}) {
  std::vector<RegressionCheck> checks(labels, check_regression(before, after, options));
  judge_all(checks);
  return checks.front();
}

// Of two labels of one study.
RegressionCheck check_of(StudyResults both, const std::string& candidate, const std::string& baseline,
                         const RegressionOptions& options = {}) {
  std::vector<RegressionCheck> checks{check_regression(std::move(both), candidate, baseline, options)};
  judge_all(checks);
  return checks.front();
}

// Of one study of B and A.
RegressionCheck check_of(const Asked& asked, const Change& change) {
  return check_of(study(asked, change, {"B", "A"}), "B", "A");
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("an unchanged solver passes, also where nothing may be open") {
  const RegressionCheck check = check_of(version(1), version(1));
  CHECK(check.quantities(RegressionOutcome::worse).empty());
  CHECK(check.quantities(RegressionOutcome::inconclusive).empty());
  CHECK(exit_code({check}, true) == 0);
  for (const JudgedMetric& judged : check.judged.metrics)
    if (judged.samples.unit != "s") CHECK(verdict_of(judged.comparisons.front()) == Verdict::equivalent);
}

TEST_CASE("three times the evaluations on the targets that it solves are worse, however many it fails") {
  const auto triple = [](SolveRecord& solve) {
    if (solve.status == Status::ok) solve.evaluations *= 3;
  };
  const RegressionCheck check = check_of(version(1), version(2, of_100, triple));
  CHECK(check.quantities(RegressionOutcome::worse) == Names{"evaluations per success"});
  CHECK(exit_code({check}, false) == 3);
  CHECK(exit_code({check_of(version(2, of_100, triple), version(1))}, false) == 0);
}

TEST_CASE("5 crashes in 100 solves are worse where the baseline had none") {
  for (const double tolerance : {0.0, 0.1}) {
    Asked asked = of_100;
    asked.tolerance_cm = tolerance;
    const auto solved = [](SolveRecord& solve) { solve.status = Status::ok; };
    const auto crash = [](SolveRecord& solve) { solve.status = solve.point % 20 == 0 ? Status::crashed : Status::ok; };
    const RegressionCheck check = check_of(version(1, asked, solved), version(1, asked, crash));
    CHECK(check.quantities(RegressionOutcome::worse).empty());
    CHECK(check.new_failures == 5);
    CHECK(exit_code({check}, false) == 3);
    // As chance may do: its p is not small, and nothing is certain.
    const auto crash_once = [](SolveRecord& solve) { solve.status = solve.point == 7 ? Status::crashed : Status::ok; };
    const RegressionCheck once = check_of(version(1, asked, solved), version(1, asked, crash_once));
    CHECK(once.new_failures == 1);
    CHECK(flat(once.judged.metrics.back().comparisons.front()).p == 1);
    CHECK(exit_code({once}, false) == 3);
    CHECK(exit_code({check_of(version(1, asked, crash), version(1, asked, solved))}, false) == 0);
    CHECK(exit_code({check_of(version(1, asked, crash), version(1, asked, crash))}, false) == 0);
    const auto crash_always = [](SolveRecord& solve) { solve.status = Status::crashed; };
    CHECK(exit_code({check_of(version(1, asked, solved), version(1, asked, crash_always))}, false) == 3);
    asked.points = 4;  // too few for a test
    const auto crash_half = [](SolveRecord& solve) { solve.status = solve.point < 3 ? Status::crashed : Status::ok; };
    CHECK(check_of(version(1, asked, crash_half), version(1, asked, crash_always)).new_failures == 2);
  }
}

TEST_CASE("drawn targets are paired; another task or number of solves is refused") {
  CHECK(check_of(version(1, drawn_100), version(2, drawn_100)).judged.metrics.front().samples.is_paired);
  StudyResults part = version(1);
  part.solves.resize(23);
  Asked looser = of_100, more = of_100, seeded = of_100, started = of_100;
  started.start = "middle";
  looser.tolerance_cm = 0.2;
  more.runs = 2;
  seeded.rest = R"(, "seed": 2)";
  const auto further = [](SolveRecord& solve) { solve.target_position_m[0] += 1000; };
  for (const StudyResults& other : {version(2, of_100, further), version(2, looser), version(1, more), part,
                                    version(1, seeded), version(1, started)}) {
    CHECK_THROWS_AS(check_of(version(1), other), std::invalid_argument);
    CHECK_THROWS_AS(check_of(other, version(1)), std::invalid_argument);
  }
  const std::pair<const char*, std::function<void(results::StudyDefinition&)>> changes[]{
      {"arms", [](auto& definition) { definition.robot = "another"; }},
      {"arms", [](auto& definition) { definition.arm = "another"; }},
      {"targets", [](auto& definition) { definition.path = "another"; }},
      {"searches", [](auto& definition) { definition.search = results::Search::axis; }},
      {"paths, starts", [](auto& definition) { definition.task = "another"; }},
      {"paths, starts", [](auto& definition) { definition.near = 1; }},
      {"paths, starts", [](auto& definition) { definition.rotation_weight = 2; }},
      {"treatments of", [](auto& definition) { definition.limits = results::LimitPolicy::enforced; }},
      {"checks", [](auto& definition) { definition.check.process = {"./check"}; }},
      {"tolerances", [](auto& definition) { definition.stop.angle_tolerance = 1; }}};
  for (const auto& [what, change] : changes) {
    StudyResults other = version(1);
    change(other.definition);
    CHECK_THROWS_WITH(check_of(version(1), other), ContainsSubstring(fmt::format("has other {}", what)));
  }
  CHECK_THROWS_WITH(check_of(version(1), part),
                    StartsWith("not compared: mine has 23 solves, before 100; complete both"));
}

TEST_CASE("times decide nothing, and those of other stores and of solves that are the same are not compared") {
  const Asked in_turns{.start = "initial", .runs = 5, .points = 20, .tolerance_cm = 0.1};
  const auto time_of = [](const RegressionCheck& check) {
    return flat(std::ranges::find(check.judged.metrics, "s", [](const JudgedMetric& each) {
                  return each.samples.unit;
                })->comparisons.front());
  };
  const auto slow = [](SolveRecord& solve) { solve.seconds = solve.cpu_seconds = 3 * solve.seconds; };
  const auto slow_and_other = [&](SolveRecord& solve) {
    slow(solve);
    solve.answer_rad.push_back(1);
  };
  const StudyResults before = version(1, in_turns);
  for (const RegressionCheck& check :
       {check_of(before, version(1, in_turns, slow_and_other)), check_of(before, version(1, in_turns, slow))}) {
    CHECK(time_of(check).why == ResultKind::apart);
    CHECK(check.quantities(RegressionOutcome::worse).empty());
    CHECK(std::ranges::count(check.quantities(RegressionOutcome::inconclusive), "time per success") == 0);
  }
  const RegressionCheck one = check_of(in_turns, [&](SolveRecord& solve) {
    const double noise = solve.label == "B" ? 1 + 0.01 * (solve.run % 2) : 1;
    solve.seconds = solve.cpu_seconds = noise * 1e-5 * (100 * solve.run + solve.point);
    if (solve.label == "B") slow_and_other(solve);
  });
  CHECK(time_of(one).verdict == Verdict::worse);
  CHECK(exit_code({one}, false) == 0);
}

// Turns, as cli/gate.sh makes them; `lag` seconds between the two of one.
StudyResults in_turns(int rounds, int lag, double seconds) {
  const Asked asked{.start = "initial", .runs = rounds, .points = 5, .tolerance_cm = 0.1};
  const auto change = [=](SolveRecord& solve) {
    solve.status = Status::ok;
    const double noise = 1 + 0.004 * ((solve.run * (lag == 0 ? 7 : 3)) % 5 - 2);
    solve.seconds = solve.cpu_seconds = seconds * (100 + solve.run) * noise;
  };
  StudyResults all = study(asked, change, {"mine"});
  int round = 0;
  for (results::Session& session : all.sessions) {
    session.began = fmt::format("{:04}", 10 * ++round + lag);
    session.environment["shard"] = fmt::format("{}/{}", round, rounds);
  }
  return all;
}

TEST_CASE("times of two that solved in turn decide; too few turns and other sessions are no pass") {
  const auto checks_of = [](int rounds, int lag, double factor, std::size_t labels = 1) {
    const RegressionOptions by_times{.time_margin = 0.1};
    std::vector<RegressionCheck> checks(
        labels, check_regression(in_turns(rounds, 0, 1e-5), in_turns(rounds, lag, factor * 1e-5), by_times));
    judge_all(checks);
    return checks;
  };
  CHECK(exit_code(checks_of(6, 1, 1.01), true) == 0);
  CHECK(checks_of(6, 1, 1.3).front().quantities(RegressionOutcome::worse) == Names{"time"});
  CHECK(exit_code(checks_of(6, 1, 1.01, 2), true) == 0);
  const std::vector<RegressionCheck> few = checks_of(3, 1, 1.01);
  CHECK(few.front().quantities(RegressionOutcome::not_tested) == Names{"time"});
  CHECK(exit_code(few, false) == 1);
  CHECK_NOTHROW(checks_of(6, 10, 1));                           // it began in the same second
  CHECK_THROWS_AS(checks_of(6, 11, 1), std::invalid_argument);  // one had begun its next turn
  CHECK_THROWS_AS(checks_of(1, 1, 1), std::invalid_argument);
  StudyResults whole = in_turns(6, 0, 1e-5);  // a study's own turns are those of no other
  for (results::Session& session : whole.sessions) session.environment.erase("shard");
  CHECK_THROWS_AS(check_regression(whole, in_turns(6, 1, 1e-5), {.time_margin = 0.1}), std::invalid_argument);
  StudyResults warm = in_turns(6, 0, 1e-5);
  for (results::Session& session : warm.sessions) session.environment["state"] = "warm";
  CHECK_THROWS_WITH(check_regression(warm, in_turns(6, 1, 1e-5), {.time_margin = 0.1}),
                    ContainsSubstring("second calls on a target before"));
  const RegressionCheck check = check_of(warm, in_turns(6, 1, 1e-5));
  const auto time = std::ranges::find(check.judged.metrics, "s", [](auto& each) { return each.samples.unit; });
  REQUIRE(time->samples.warnings.size() == 1);
  CHECK_THAT(warning_text(time->samples.warnings.front()), ContainsSubstring("second calls on a target before"));
  CHECK(find_metric(check_of(in_turns(6, 0, 1e-5), in_turns(6, 1, 1e-5)).judged, "seconds")->samples.warnings.empty());
}

TEST_CASE("a metric that one of the two lacks is not tested") {
  const auto uncounted = [](SolveRecord& solve) { solve.counted_by = CountedBy::none; };
  CHECK(check_of(version(1), version(2, of_100, uncounted)).quantities(RegressionOutcome::not_tested) ==
        Names{"evaluations per success"});
  CHECK(exit_code({check_of(version(1, of_100, uncounted), version(1))}, false) == 0);
  const RegressionCheck of_two = check_of(of_100, [&](SolveRecord& solve) {
    if (solve.label == "B") uncounted(solve);
  });
  CHECK(of_two.quantities(RegressionOutcome::not_tested) == Names{"evaluations"});
  CHECK(exit_code({of_two}, false) == 0);
}

TEST_CASE("equal solvers are worse in something in at most 5 % of compares") {
  constexpr int compares = 200;
  int red = 0;
  for (int i = 0; i < compares; ++i) {
    const RegressionCheck check = check_of(version(i), version(compares + i));
    for (const JudgedMetric& judged : check.judged.metrics) CHECK(judged.plan.significance == 0.05);  // p is adjusted
    red += !check.quantities(RegressionOutcome::worse).empty();
  }
  CHECK(red <= compares / 20);
}

TEST_CASE("labels and metrics that are compared share the significance") {
  int missed = 0;
  const auto miss_eight = [&](SolveRecord& solve) {
    if (solve.status == Status::ok && missed++ < 8) solve.status = Status::tolerance_missed;
  };
  const StudyResults before = version(1), after = version(1, of_100, miss_eight);
  const RegressionCheck one = check_of(before, after), of_six = check_of(before, after, 6);
  CHECK(std::ranges::count(one.quantities(RegressionOutcome::worse), "targets solved") == 1);
  CHECK(flat(one.judged.metrics.front().comparisons.front()).p == 3 * 2 / 256.0);  // solved, time and evaluations
  CHECK(std::ranges::count(of_six.quantities(RegressionOutcome::worse), "targets solved") == 0);
  CHECK(std::ranges::count(of_six.quantities(RegressionOutcome::inconclusive), "targets solved") == 1);
  CHECK(flat(of_six.judged.metrics.front().comparisons.front()).p == 6 * 3 * 2 / 256.0);
}

TEST_CASE("what the plan names decides, and what it does not name is told") {
  const auto far = [](SolveRecord& solve) {
    solve.answer_rad.push_back(1);  // else the solves are the same
    solve.variation_deg *= 1.5;
  };
  const RegressionCheck one = check_of(version(1), version(1, of_100, far));
  CHECK(one.quantities(RegressionOutcome::worse).empty());
  CHECK(one.quantities(RegressionOutcome::worse, false) == Names{"joint motion"});
  CHECK(exit_code({one}, false) == 0);
  CHECK(check_of(version(1, of_100, far), version(1)).quantities(RegressionOutcome::better, false) ==
        Names{"joint motion"});
  Asked with_motion = of_100;
  with_motion.rest = R"(, "analysis": {"tie_breakers": ["time", "evaluations", "motion"]})";
  const RegressionCheck named = check_of(version(1, with_motion), version(1, with_motion, far));
  CHECK(named.quantities(RegressionOutcome::worse) == Names{"joint motion"});
  CHECK(named.quantities(RegressionOutcome::worse, false).empty());
  CHECK(exit_code({named}, false) == 3);
}

TEST_CASE("no more metrics decide than share the significance") {
  Asked by_evaluations = of_100;
  by_evaluations.rest = R"(, "analysis": {"metric": "evaluations", "tie_breakers": ["time"]})";
  const auto triple = [](SolveRecord& solve) { solve.evaluations *= 3; };
  const RegressionCheck check = check_of(version(1, by_evaluations), version(1, by_evaluations, triple));
  CHECK(check.quantities(RegressionOutcome::worse) == Names{"evaluations"});
  CHECK(check.quantities(RegressionOutcome::worse, false) == Names{"evaluations per success"});
  for (const char* plan :
       {R"("tie_breakers": [])", R"("tie_breakers": ["motion", "time"])", R"("metric": "seconds")", ""}) {
    Asked asked = of_100;
    asked.rest = fmt::format(R"(, "analysis": {{{}}})", plan);
    const JudgedStudy of = judge::judge(version(1, asked));
    const auto is_named = [&](const JudgedMetric& metric) { return !name_in_plan(of, metric).empty(); };
    CHECK(std::ranges::count_if(of.metrics, is_named) <= std::ssize(names_in_plan(of.study.definition)));
  }
}

TEST_CASE("--metric chooses of the plan's metrics those that decide, and changes no p") {
  const auto triple = [](SolveRecord& solve) { solve.evaluations *= 3; };
  const StudyResults before = version(1), after = version(1, of_100, triple);
  const RegressionCheck all = check_of(before, after), one = check_of(before, after, 1, {.metrics = {"solved"}});
  CHECK(all.quantities(RegressionOutcome::worse) == Names{"evaluations per success"});
  CHECK(exit_code({all}, false) == 3);
  CHECK(one.quantities(RegressionOutcome::worse).empty());
  CHECK(one.quantities(RegressionOutcome::worse, false) == all.quantities(RegressionOutcome::worse));
  CHECK(exit_code({one}, false) == 0);
  for (std::size_t i = 0; i < all.judged.metrics.size(); ++i)
    CHECK(flat(all.judged.metrics[i].comparisons.front()).p == flat(one.judged.metrics[i].comparisons.front()).p);
  CHECK_THROWS_WITH(check_regression(before, after, {.metrics = {"motion"}}),
                    ContainsSubstring("names solved, time and evaluations"));
  CHECK_THROWS_WITH(check_regression(before, after, {.metrics = {"time"}}), ContainsSubstring("--time-margin 10%"));
  CHECK_THROWS_WITH(
      check_regression(in_turns(6, 0, 1e-5), in_turns(6, 1, 1e-5), {.time_margin = 0.1, .metrics = {"solved"}}),
      ContainsSubstring("add time to --metric"));
  const auto crash = [](SolveRecord& solve) { solve.status = Status::crashed; };  // is no metric's
  CHECK(exit_code({check_of(before, version(1, of_100, crash), 1, {.metrics = {"evaluations"}})}, false) == 3);
}

// Up to five labels, some of which solve less, take longer or are alike.
StudyResults drawn_study(int seed, const std::string& plan) {
  std::mt19937 random(static_cast<unsigned>(seed));
  const auto draw = [&](int least, int most) { return std::uniform_int_distribution<int>(least, most)(random); };
  const Names labels{"A", "B", "C", "D", "E"};
  const Names some(labels.begin(), labels.begin() + draw(2, 5));
  Asked asked{.start = "initial", .targets = draw(0, 1) == 0 ? "fixed" : "drawn", .runs = 6, .points = draw(3, 12)};
  asked.tolerance_cm = draw(0, 3) == 0 ? 0 : 0.1;
  asked.rest = R"(, "analysis": {)" + plan + "}";
  std::map<std::string, double> rates, costs;
  for (const std::string& label : some) {
    rates[label] = 0.5 + 0.1 * draw(0, 5);
    costs[label] = 1 + 0.2 * draw(0, 3);
  }
  std::lognormal_distribution<double> factor(0, 0.2);
  return study(
      asked,
      [&](SolveRecord& solve) {
        const double cost = costs[solve.label];
        solve.status = std::bernoulli_distribution(rates[solve.label])(random) ? Status::ok : Status::tolerance_missed;
        solve.evaluations = std::lround(100 * cost * factor(random));
        solve.position_error_cm = cost * factor(random);
        solve.variation_deg = 30 * cost * factor(random);
        solve.seconds = solve.cpu_seconds = 1e-5 * cost * factor(random);
      },
      some);
}

TEST_CASE("a pair has one p and one verdict in a metric, whatever tells it") {
  int pairs = 0, decided = 0;
  for (int seed = 0; seed < 100; ++seed) {
    const bool has_control = seed % 5 == 0;
    const StudyResults drawn = drawn_study(seed, has_control ? R"("control": "A")" : "");
    const JudgedStudy report = judge::judge(drawn);
    for (const RegressionOptions& options : {RegressionOptions{}, RegressionOptions{.time_margin = 0.1}}) {
      for (const std::string& candidate : drawn.labels) {
        for (const std::string& baseline : drawn.labels) {
          if (candidate == baseline || (has_control && candidate != "A" && baseline != "A")) continue;
          const RegressionCheck check = check_of(drawn, candidate, baseline, options);
          for (const JudgedMetric& metric : report.metrics) {
            const auto judged = std::ranges::find(check.judged.metrics, metric.samples.metric,
                                                  [](const JudgedMetric& each) { return each.samples.metric; });
            REQUIRE(judged != check.judged.metrics.end());
            REQUIRE(judged->comparisons.size() == 1);
            const FlatComparison here = flat(judged->comparisons.front());
            const Comparison* const found = find_comparison(metric, candidate, baseline);
            REQUIRE(found != nullptr);
            const FlatComparison there = flat(judge::better_first(*found, baseline));
            CAPTURE(seed, candidate, baseline, metric.samples.quantity);
            CHECK(here.first == there.first);
            CHECK(here.p == there.p);
            CHECK(is_difference(here.verdict) == is_difference(there.verdict));
            if (metric.samples.quantity_kind != QuantityKind::time) CHECK(here.verdict == there.verdict);
            ++pairs;
            decided += is_difference(here.verdict);
          }
        }
      }
    }
  }
  CHECK(pairs > 5000);
  CHECK(decided > 1000);
}

TEST_CASE("labels of another machine change no p of a study's own pairs") {
  for (int seed = 0; seed < 20; ++seed) {
    StudyResults own = drawn_study(seed, "");
    const JudgedStudy alone = judge::judge(own);
    StudyResults theirs = drawn_study(seed, "");
    for (std::string& label : theirs.labels) label += " of them";
    for (results::Series& series : theirs.series) series.label += " of them";
    theirs.imported.origin = "elsewhere";
    add_imported(own, theirs);
    const JudgedStudy both = judge::judge(std::move(own));
    for (const JudgedMetric& metric : alone.metrics) {
      const auto judged = std::ranges::find(both.metrics, metric.samples.metric,
                                            [](const JudgedMetric& each) { return each.samples.metric; });
      REQUIRE(judged != both.metrics.end());
      for (const Comparison& comparison : metric.comparisons) {
        if (comparison.first != "A") continue;
        const Comparison* const found = find_comparison(*judged, comparison.first, comparison.second);
        REQUIRE(found != nullptr);
        CHECK(flat(*found).p == flat(comparison).p);
        CHECK(verdict_of(*found) == verdict_of(comparison));
      }
      // Theirs are compared with the control alone, and no own pair takes a part of their significance.
      MetricSamples others = judged->samples;
      std::erase_if(others.groups, [](const Group& group) {
        return group.name != "A" && group.name.find("of them") == std::string::npos;
      });
      for (const Comparison& comparison :
           compare_pairs(others, judged->plan, names_in_plan(both.study.definition).size()))
        CHECK(flat(*find_comparison(*judged, comparison.first, comparison.second)).p == flat(comparison).p);
    }
  }
}

TEST_CASE("a name of the plan is one family, whichever of its metrics a label has") {
  const auto solve_all = [](SolveRecord& solve) { solve.status = Status::ok; };
  const auto take_more = [](SolveRecord& solve) {
    if (solve.evaluations < 1000) solve.evaluations = solve.evaluations * 6 / 5;
  };
  const auto solve_all_by_more = [&](SolveRecord& solve) {
    solve_all(solve);
    take_more(solve);
  };
  const auto p_of = [](const RegressionCheck& check, const char* column) {
    return *flat(find_metric(check.judged, column)->comparisons.front()).p;
  };
  std::vector<RegressionCheck> both{
      check_regression(version(1, of_100, solve_all), version(2, of_100, solve_all_by_more)),
      check_regression(version(1), version(2, of_100, take_more))};
  std::vector<RegressionCheck> alone{both.front()}, other{both.back()};
  for (std::vector<RegressionCheck>* const checks : {&both, &alone, &other}) judge_all(*checks);
  CHECK(p_of(both[0], "evaluations") == std::min(1.0, 2 * p_of(alone[0], "evaluations")));
  CHECK(p_of(both[1], "evaluations_per_success") == std::min(1.0, 2 * p_of(other[0], "evaluations_per_success")));
  CHECK(p_of(alone[0], "evaluations") < 0.5);
}

TEST_CASE("solves that are the same bit for bit leave nothing open, however few") {
  const Asked chained{.runs = 8, .points = 3};
  const auto with = [&](double angle) {
    return study(chained, [=](SolveRecord& solve) { solve.answer_rad.push_back(angle); }, {"mine"});
  };
  const RegressionCheck same = check_of(with(1), with(1)), other = check_of(with(1), with(2));
  CHECK(same.is_identical);
  CHECK(exit_code({same}, true) == 0);
  CHECK_FALSE(other.is_identical);
  CHECK(exit_code({other}, false) == 0);
  CHECK(exit_code({other}, true) == 4);  // equal numbers of so few runs exclude no rare difference
}

TEST_CASE("other budgets are a doubt, and the margin is the baseline's") {
  const auto spend = [](int times) {
    return [=](SolveRecord& solve) {
      solve.evaluations *= times;
      if (solve.status != Status::ok) solve.stop_reason = results::StopReason::evaluations;
    };
  };
  StudyResults before = version(1, of_100, spend(1)), after = version(2, of_100, spend(3));
  after.definition.stop.evaluations = 3000;
  after.definition.plan.margin = 9;
  CHECK_FALSE(check_of(before, after).quantities(RegressionOutcome::worse).empty());
  before.definition.plan.margin = 9;
  const RegressionCheck check = check_of(before, after);
  CHECK(check.quantities(RegressionOutcome::worse).empty());
  REQUIRE(check.judged.warnings.size() == 1);
  CHECK_THAT(warning_text(check.judged.warnings.front()), ContainsSubstring("3000 evaluations"));
}

TEST_CASE("a loss of a solver that repeats itself is a fact") {
  const Asked chained{.runs = 10, .points = 3};
  const auto with = [&](double error) {
    return study(chained,
                 [error](SolveRecord& solve) {
                   solve.answer_rad = {0.5 * solve.point};
                   solve.position_error_cm = error;
                 },
                 {"mine"});
  };
  CHECK(check_of(with(0.5), with(0.6)).quantities(RegressionOutcome::worse) == Names{"position error"});
  CHECK(check_of(with(0.5), with(0.51)).quantities(RegressionOutcome::worse).empty());
  CHECK(exit_code({check_of(with(0.5), with(0.4))}, true) == 0);
}

TEST_CASE("what is not decided fails a strict gate alone") {
  Asked few = of_100;
  few.points = 8;
  const auto shift = [](SolveRecord& solve) { solve.variation_deg *= 1.02; };
  const RegressionCheck check = check_of(version(1, few), version(2, few, shift));
  CHECK(check.quantities(RegressionOutcome::worse).empty());
  CHECK(check.quantities(RegressionOutcome::inconclusive) == Names{"targets solved", "evaluations per success"});
  CHECK(check.quantities(RegressionOutcome::not_tested)
            .empty());  // joint motion has too few targets, and the plan does not name it
  CHECK(exit_code({check}, false) == 0);
  CHECK(exit_code({check}, true) == 4);
}

TEST_CASE("a gate in which too few were compared ends with 1, whatever the answers") {
  const Asked chained{.runs = 3, .points = 3};
  const auto far = [](SolveRecord& solve) {
    if (solve.label == "B") solve.position_error_cm = 25 + solve.run;
  };
  const RegressionCheck check = check_of(chained, far);
  CHECK_FALSE(check.is_compared);
  CHECK(exit_code({check}, false) == 1);
  CHECK(check.quantities(RegressionOutcome::worse).empty());
  const RegressionCheck crashed = check_of(chained, [](SolveRecord& solve) {
    if (solve.label == "B") solve.status = Status::crashed;
  });
  CHECK(exit_code({crashed}, false) == 3);  // answers were lost for sure
  CHECK(exit_code({check_of(version(1), version(1)), check}, false) == 1);
}

TEST_CASE("what the study's time ended in other sessions is not compared") {
  const auto timed = [](int late_from) {
    StudyResults study = version(1, of_100, [=](SolveRecord& solve) {
      const bool is_late = solve.point >= late_from;
      solve.status = is_late ? Status::tolerance_missed : Status::ok;
      solve.seconds = solve.cpu_seconds = is_late ? 0.0049 : 1e-4;
    });
    study.definition.stop.seconds = 0.005;
    return study;
  };
  CHECK(exit_code({check_of(timed(200), timed(200))}, false) == 0);
  const RegressionCheck ended = check_of(timed(200), timed(40));
  CHECK(ended.quantities(RegressionOutcome::worse).empty());
  CHECK_FALSE(ended.is_compared);
  CHECK(exit_code({ended}, false) == 1);
}
