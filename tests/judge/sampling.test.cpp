#include "tests/judge/studies.hpp"

using ikbench::results::Session;
using ikbench::results::StopReason;

namespace {

using Numbers = std::vector<double>;
const Asked chained{}, fixed_targets{.start = "middle"}, drawn{.start = "middle", .targets = "drawn"},
    drawn_runs{.start = "previous", .targets = "drawn"};
const auto as_made = [](SolveRecord&) {};

MetricSamples samples_of(const StudyResults& study, std::string_view metric = "position_error_cm") {
  return make_samples(study, metric_named(metric));
}

const Group& group(const MetricSamples& of, std::string_view name) {
  return *std::ranges::find(of.groups, name, &Group::name);
}

std::optional<Warning> warning_in(const std::vector<Warning>& warnings, WarningKind kind) {
  const auto found = std::ranges::find(warnings, kind, &Warning::kind);
  return found == warnings.end() ? std::nullopt : std::optional(*found);
}

std::optional<Warning> warning_of(const StudyResults& study, WarningKind kind) {
  return warning_in(study_warnings(study), kind);
}

// Error 10 * run + point.
void number_errors(SolveRecord& solve) { solve.position_error_cm = 10 * solve.run + solve.point; }

// As by a clock that stands, which no store has.
StudyResults without_times(StudyResults study) {
  for (SolveSummary& solve : study.solves) solve.seconds = 0;
  return study;
}

}  // namespace

TEST_CASE("A chained run is one observation: the mean, of times the median") {
  const StudyResults of = study(chained, [](SolveRecord& solve) {
    number_errors(solve);
    solve.seconds = solve.point == 4 ? 100 : solve.point;
  });
  const MetricSamples errors = samples_of(of);
  CHECK_FALSE(errors.is_paired);
  CHECK(trials_per_value(make_samples(of, metric_named("solved"))) == 4);
  CHECK(list_of(group(errors, "A")) == Numbers{12.5, 22.5, 32.5, 42.5, 52.5});
  CHECK(std::get<Sample>(group(errors, "A").sample).blocks.empty());
  CHECK(list_of(group(make_samples_by_target(of, metric_named("seconds")), "A")) == Numbers(5, 2.5));
}

TEST_CASE("Else a target is one: a drawn one's only solve, a fixed one's mean over the runs") {
  const MetricSamples of_drawn = samples_of(study(drawn, number_errors));
  CHECK(of_drawn.is_paired);
  CHECK(trials_per_value(make_samples(study(drawn, number_errors), metric_named("solved"))) == 1);
  CHECK(list_of(group(of_drawn, "A")).size() == 20);
  CHECK(list_of(group(of_drawn, "A"))[4] == 21);
  const MetricSamples of_fixed = samples_of(study(fixed_targets, number_errors));
  CHECK(of_fixed.is_paired);
  CHECK(trials_per_value(make_samples(study(fixed_targets, number_errors), metric_named("solved"))) == 5);
  CHECK(list_of(group(of_fixed, "A")) == Numbers{31, 32, 33, 34});
  const Asked path_by_points{.start = "previous", .rest = R"(, "analysis": {"values": "points"})"};
  const MetricSamples of_path = samples_of(study(path_by_points, number_errors));
  CHECK(of_path.is_paired);
  CHECK(list_of(group(of_path, "A")) == Numbers{31, 32, 33, 34});
}

TEST_CASE("Runs are paired where their targets were drawn") {
  const MetricSamples runs = samples_of(study(drawn_runs, number_errors));
  CHECK(runs.is_paired);
  CHECK(list_of(group(runs, "A")) == Numbers{12.5, 22.5, 32.5, 42.5, 52.5});
}

TEST_CASE("One fixed target is no group of one: its runs are observations") {
  const MetricSamples of = samples_of(study({.start = "middle", .points = 1}, number_errors));
  CHECK_FALSE(of.is_paired);
  CHECK(list_of(group(of, "A")) == Numbers{11, 21, 31, 41, 51});
}

TEST_CASE("A chained run that lacks a point gives no observation, and a pair has the blocks that both have") {
  const auto without = [](const Asked& asked) {
    std::vector<SolveRecord> solves = planned_solve_count(asked, {"A", "B"}, number_errors);
    std::erase_if(solves,
                  [](const SolveRecord& solve) { return solve.label == "A" && solve.run == 2 && solve.point == 3; });
    return to_stored(entry_of(asked, {"A", "B"}), solves);
  };
  CHECK(list_of(group(samples_of(without(chained)), "A")) == Numbers{12.5, 32.5, 42.5, 52.5});
  const MetricSamples runs = samples_of(without(drawn_runs));
  CHECK(std::get<Sample>(group(runs, "A").sample).blocks == std::vector<int>{1, 3, 4, 5});
  CHECK(std::get<Sample>(group(runs, "B").sample).blocks == std::vector<int>{1, 2, 3, 4, 5});
  CHECK(missing_in(group(runs, "A")) == 0);
  CHECK(list_of(group(samples_of(without(drawn)), "A")).size() == 19);
  const auto warning = warning_of(without(chained), WarningKind::runs_missing);
  REQUIRE(warning);
  CHECK(warning->solvers == std::vector<std::string>{"A"});
  CHECK(warning->count == 1);
  CHECK(warning->total == 5);
}

TEST_CASE("A solver whose runs repeat each other bit for bit has one observation, times apart") {
  const auto as_one = [](SolveRecord& solve) {
    if (solve.label != "A") return;
    solve.answer_rad[1] = 0;
    solve.evaluations = 100 + solve.run;
    solve.seconds = solve.cpu_seconds = 0.001 * solve.run;
  };
  const StudyResults of = study(chained, as_one);
  const Group alone = group(samples_of(of), "A");
  CHECK(list_of(alone) == Numbers{0.5});
  CHECK(is_deterministic(alone));
  CHECK_FALSE(is_deterministic(group(samples_of(of), "B")));
  CHECK(list_of(group(samples_of(of), "B")).size() == 5);
  CHECK(list_of(group(samples_of(of, "seconds"), "A")).size() == 5);  // sessions
  CHECK(list_of(group(samples_of(of, "evaluations"), "A")).size() == 5);
  const auto warning = warning_of(of, WarningKind::deterministic);
  REQUIRE(warning);
  CHECK(warning->solvers == std::vector<std::string>{"A"});
  CHECK_FALSE(warning_of(study(fixed_targets, as_one), WarningKind::deterministic));
}

TEST_CASE("Numbers that are not finite are lost; a solve without an answer has its error and no cost") {
  const auto fails = [](SolveRecord& solve) {
    if (solve.label != "A" || solve.run != 2 || solve.point > 3) return;
    solve.status = solve.point == 1 ? Status::not_finite : Status::crashed;
    if (solve.point == 1) solve.position_error_cm = ikbench::not_a_number;
  };
  const StudyResults of = study(drawn, fails);
  CHECK(missing_in(group(samples_of(of), "A")) == 1);
  CHECK(list_of(group(samples_of(of), "A")).size() == 19);
  CHECK(missing_in(group(samples_of(of, "variation_deg"), "A")) == 2);
  CHECK(missing_in(group(samples_of(study(chained, fails)), "A")) == 1);
  CHECK(missing_in(group(samples_of(of), "B")) == 0);
  const auto never = study(drawn, [](SolveRecord& solve) { solve.status = Status::crashed; });
  CHECK(missing_in(group(samples_of(never), "B")) ==
        20);  // where the arm stayed is no error of a solver that never moved it
  const auto warning = warning_of(of, WarningKind::no_answer);
  REQUIRE(warning);
  CHECK(warning->count == 3);
  CHECK(warning->total == 20);
  // A refused answer leaves the arm where it was: that has an error, and moved by nothing.
  const StudyResults refused = study(drawn, [](SolveRecord& solve) {
    solve.status = Status::refused;
    solve.variation_deg = 0;
  });
  CHECK(list_of(group(samples_of(refused, "variation_deg"), "A")) == Numbers(20, 0.0));
  CHECK_FALSE(warning_of(refused, WarningKind::no_answer));
}

TEST_CASE("Errors at or below the tolerance count as it, before they are averaged") {
  const Asked asked{.start = "previous", .tolerance_cm = 1};
  const auto small = [](SolveRecord& solve) {
    solve.position_error_cm = solve.label == "A" && solve.point < 4 ? 0.1 * solve.run : 5;
  };
  const MetricSamples of = samples_of(study(asked, small));
  CHECK(list_of(group(of, "A")) == Numbers(5, 2.0));
  CHECK(group(of, "A").tolerance == 1);
  CHECK(group(of, "B").tolerance == 0);
  CHECK(std::isnan(describe(group(of, "A")).sd));
  CHECK(group(samples_of(study(chained, small)), "A").tolerance == 0);
}

TEST_CASE("Solved is a share where there is a tolerance, and else has no value") {
  const auto misses = [](SolveRecord& solve) {
    if (solve.point == 1) solve.status = Status::tolerance_missed;
  };
  const MetricSamples of = samples_of(study({.start = "previous", .tolerance_cm = 1}, misses), "solved");
  CHECK(of.better == Better::larger);
  CHECK(effect_scale(of) == EffectScale::share);
  CHECK(trials_per_value(of) == 4);
  CHECK(list_of(group(of, "A")) == Numbers(5, 0.75));
  CHECK(list_of(group(samples_of(study(chained, misses), "solved"), "A")).empty());
}

TEST_CASE("Where targets have a tolerance, costs are of those that were solved, and blocks say which") {
  const auto misses = [](SolveRecord& solve) {
    if (solve.run == 1 && solve.point == (solve.label == "A" ? 1 : 2)) solve.status = Status::tolerance_missed;
    solve.variation_deg = 100 * solve.run + solve.point;
  };
  const auto moves = [&](Asked asked) {
    asked.tolerance_cm = 1;
    return samples_of(study(asked, misses), "variation_deg");
  };
  const MetricSamples of = moves(drawn);
  CHECK(list_of(group(of, "A")).size() == 19);
  CHECK(std::get<Sample>(group(of, "A").sample).blocks.front() == 2);
  CHECK(std::get<Sample>(group(of, "B").sample).blocks[1] == 3);
  CHECK(list_of(group(moves(fixed_targets), "A")).front() == Approx((201 + 301 + 401 + 501) / 4.0));
  CHECK(list_of(group(moves(chained), "A")).front() == 102.5);
  const auto misses_all = [](SolveRecord& solve) {
    solve.status = solve.label == "A" ? Status::tolerance_missed : Status::ok;
  };
  const MetricSamples of_path =
      samples_of(study({.start = "previous", .tolerance_cm = 1}, misses_all), "variation_deg");
  CHECK(std::get<ExcludedSample>(group(of_path, "A").sample).reason == ExclusionReason::nothing_solved);
  CHECK(list_of(group(of_path, "B")).size() == 5);
}

TEST_CASE("Times are compared over whole sessions of this clock in which the machine was not busy") {
  const auto times = [](const StudyResults& of) { return make_samples(of, metric_named("seconds")); };
  const auto apart = [](const MetricSamples& of) {
    std::string names;
    for (const Group& each : of.groups)
      names += excluded(each) && excluded(each)->reason == ExclusionReason::not_comparable ? each.name : "";
    return names;
  };
  const MetricSamples five =
      times(study(chained, [](SolveRecord& solve) { solve.seconds = solve.cpu_seconds = 0.001 * solve.point; }));
  CHECK(apart(five).empty());
  REQUIRE(list_of(group(five, "A")).size() == 5);
  CHECK(list_of(group(five, "A")).front() == Approx(std::log(0.0025)));  // the median of four
  CHECK(list_of(group(times(without_times(study(chained, as_made))), "A")).front() == Approx(std::log(1e-9)));
  const auto one_slow = [](SolveRecord& solve) { solve.seconds = solve.cpu_seconds = solve.run == 1 ? 9 : 1; };
  CHECK(compared(times(study(chained, one_slow)), {}).front().why ==
        ResultKind::tested);  // though other logarithms are 0
  for (const Timing timing : {Timing::parallel, Timing::debug_build}) {
    const MetricSamples all = times(study(chained, [&](SolveRecord& solve) {
      if (solve.label == "A") solve.timing = timing;
    }));
    CHECK(apart(all) == "AB");
    REQUIRE(all.warnings.size() == 1);
    CHECK(all.warnings.front().solvers.empty());
  }
  CHECK(apart(times(study({.runs = 3}, as_made))) == "AB");
  const auto slowed = [](int runs, int slow, double factor) {
    return study({.runs = runs}, [=](SolveRecord& solve) {
      if (solve.label == "B" && solve.run <= slow) solve.seconds = factor * solve.cpu_seconds;
    });
  };
  CHECK(apart(times(slowed(5, 2, 1.09))).empty());
  CHECK(apart(times(slowed(5, 2, 1.11))) == "B");
  for (const int slow : {2, 3}) {  // of 20 points of a session: more than a tenth, and more than one
    const StudyResults of = study({.runs = 5, .points = 20}, [=](SolveRecord& solve) {
      if (solve.label == "B" && solve.run <= 2 && solve.point <= slow) solve.seconds = 2 * solve.cpu_seconds;
    });
    CHECK(apart(times(of)) == (slow == 3 ? "B" : ""));
  }
  const MetricSamples four_left = times(slowed(6, 2, 2));
  CHECK(apart(four_left).empty());
  CHECK(list_of(group(four_left, "A")).size() == 6);
  CHECK(list_of(group(four_left, "B")).size() == 4);
  CHECK(four_left.warnings.empty());
  const auto words_of_apart = [&](const StudyResults& of) { return warning_text(times(of).warnings.front()); };
  const auto other_busy = study({.runs = 6}, [](SolveRecord& solve) {  // four sessions each, but two in common
    const bool is_busy = solve.label == "A" ? solve.run <= 2 : solve.run >= 5;
    solve.seconds = solve.cpu_seconds * (is_busy ? 2 : 1);
  });
  CHECK(apart(times(other_busy)).size() == 1);
  CHECK_THAT(words_of_apart(other_busy), ContainsSubstring("busy"));
  StudyResults disturbed = slowed(5, 2, 2);
  CHECK(apart(samples_of(disturbed)).empty());
  disturbed.definition.stop.seconds = 0.002;  // it ended B's
  CHECK(apart(samples_of(disturbed)) == "B");
  for (const int slow : {2, 3}) {  // of 20 solves
    StudyResults of = study({.runs = 5}, [=](SolveRecord& solve) {
      if (solve.label == "B" && solve.point == 1 && solve.run <= slow) solve.seconds = 2 * solve.cpu_seconds;
    });
    of.definition.stop.seconds = 0.002;
    CHECK(apart(samples_of(of)) == (slow == 3 ? "B" : ""));
  }
  const auto other_sessions = [](SolveRecord& solve) { solve.session += solve.label == "B" ? 10 : 0; };
  std::vector<Session> ten = sample_sessions(5);
  for (Session session : sample_sessions(5)) session.id += 10, ten.push_back(session);
  StudyResults later = study(chained, other_sessions, {"A", "B", "CC"}, ten);
  CHECK(apart(times(later)) == "B");
  CHECK_THAT(words_of_apart(later), ContainsSubstring("too few sessions shared"));
  CHECK(apart(samples_of(later)).empty());
  later.definition.stop.seconds = 0.001;  // it ended all
  CHECK(apart(samples_of(later)) == "ABCC");
  StudyResults cut = study(chained, as_made);
  std::erase_if(cut.solves,
                [](const SolveSummary& solve) { return solve.label == 1 && solve.run == 5 && solve.point == 4; });
  const MetricSamples rest = times(cut);
  CHECK(list_of(group(rest, "B")).size() == 4);
  CHECK(compared(rest, {}).front().n == 4);
  const Asked to_solve{.start = "middle", .targets = "drawn", .tolerance_cm = 1};
  const auto misses_one = [](SolveRecord& solve) {
    solve.status = solve.label == "A" && solve.run == 2 && solve.point == 1 ? Status::tolerance_missed : Status::ok;
  };
  CHECK(list_of(group(times(study(to_solve, misses_one)), "A")).size() == 4);
  const MetricSamples spent = make_samples(study(to_solve, misses_one), metric_named("seconds_per_success"));
  REQUIRE(list_of(group(spent, "A")).size() == 5);
  double sum = 0;  // the mean is that of all spent by all solved
  for (const double value : list_of(group(spent, "A"))) sum += value / 5;
  CHECK(sum == Approx(std::log(0.020 / 19)));
  const auto solves_none_of_a_session = [](SolveRecord& solve) {
    solve.status = solve.label == "A" && solve.run < 5 ? Status::tolerance_missed : Status::ok;
  };
  const MetricSamples few =
      make_samples(study(to_solve, solves_none_of_a_session), metric_named("seconds_per_success"));
  CHECK(list_of(group(few, "A")).size() == 5);  // who fails pays for it
  const auto solves_when_busy =
      study({.start = "middle", .targets = "drawn", .runs = 6, .tolerance_cm = 1}, [](SolveRecord& solve) {
        if (solve.label == "A") return;
        if (solve.run > 4) solve.seconds *= 2;
        if (solve.run < 5) solve.status = Status::tolerance_missed;
      });
  CHECK(warning_text(make_samples(solves_when_busy, metric_named("seconds_per_success")).warnings.front()) ==
        "times of B are not compared: too few targets were solved in the compared sessions");
}

TEST_CASE("What a program tells is its time, if its processor time leaves room for it") {
  const auto apart = [](const Change& change) {
    const MetricSamples of = make_samples(study(chained, change), metric_named("seconds"));
    std::string names;
    for (const Group& each : of.groups) names += excluded(each) ? each.name : "";
    return names;
  };
  const auto in_process = [](const std::string& solvers) {
    return [solvers](SolveRecord& solve) {
      if (solvers.find(solve.label) != std::string::npos) solve.timing = Timing::process;
    };
  };
  CHECK(apart(in_process("B")) == "B");
  CHECK(apart(in_process("AB")).empty());  // messages are in both
  const auto reported = [](double seconds, double wall, double cpu) {
    return [=](SolveRecord& solve) {
      if (solve.label != "B") return;
      solve.timing = Timing::process;
      solve.seconds = seconds;
      solve.wall_seconds = wall;
      solve.cpu_seconds = cpu;
    };
  };
  CHECK(apart(reported(0.01, 0.02, 0.0105)).empty());
  CHECK(list_of(group(make_samples(study(chained, reported(0.01, 0.02, 0.0105)), metric_named("seconds")), "B"))
            .front() == Approx(std::log(0.01)));
  CHECK(apart(reported(0.02, 0.02, 0.02)) == "B");   // it reports nothing that can be believed
  CHECK(apart(reported(0.01, 0.02, 0.005)) == "B");  // it waited
}

TEST_CASE("answers made elsewhere have self-reported times or none, and change nothing of the others") {
  const Asked to_solve{.start = "middle", .targets = "drawn", .tolerance_cm = 1};
  const auto made = [&](double seconds, double limit) {
    StudyResults of = study(to_solve,
                            [&](SolveRecord& solve) {
                              solve.status = Status::ok;
                              if (solve.label != "C") return;
                              solve.timing = Timing::elsewhere;
                              solve.counted_by = CountedBy::none;
                              solve.seconds = seconds;
                              solve.wall_seconds = unknown;
                              solve.session = 3;  // read in another session than the others
                            },
                            {"A", "B", "C"});
    of.definition.stop.seconds = limit;
    of.definition.plan.deadline = limit;
    return of;
  };
  const auto apart = [](const MetricSamples& samples) {
    std::string names;
    for (const Group& each : samples.groups) names += excluded(each) ? each.name : "";
    return names;
  };
  for (const double seconds : {0.001, unknown}) {
    const StudyResults free = made(seconds, 0);
    CHECK(apart(make_samples(free, metric_named("seconds"))) == "C");
    CHECK(apart(make_samples(free, metric_named("seconds_per_success"))) == "C");
    CHECK(apart(make_samples(free, metric_named("solved"))).empty());
  }
  const MetricSamples timed = make_samples(made(0.001, 0), metric_named("seconds"));
  CHECK(list_of(group(timed, "C")).front() == Approx(std::log(0.001)));  // shown
  CHECK(list_of(group(make_samples(made(unknown, 0), metric_named("seconds")), "C")).empty());
  CHECK(apart(make_samples(made(0.001, 1), metric_named("solved"))).empty());
  CHECK(apart(make_samples(made(0.95, 1), metric_named("solved"))) == "C");  // the limit ended it on another machine
  const MetricSamples no_budget = make_samples(made(unknown, 1), metric_named("solved"));
  CHECK(apart(no_budget) == "C");
  CHECK(list_of(group(no_budget, "C")).size() == 20);  // shown, and in no comparison
  CHECK(clock_warnings(made(unknown, 0)).empty());
  const MetricSamples in_time = make_samples(made(unknown, 1), metric_named("solved_in_time"));
  CHECK(list_of(group(in_time, "C")).empty());
}

TEST_CASE("what was found about answers is told of the series that has them") {
  std::vector<Session> sessions = sample_sessions(5);
  sessions[0].environment[results::cause_fact + "A@1"] = "angles are in degrees";
  sessions[0].environment[results::cause_fact + "A@2"] = "of a former file";
  sessions[4].environment[results::answers_fact + "B@1"] = std::string(1000, 'x');
  StudyResults of = study(chained, as_made, {"A", "B"}, sessions);
  of.series[0].key = "A@1";
  of.series[1].key = "B@1";
  std::vector<std::string> told;
  for (const Warning& warning : study_warnings(of))
    if (warning.kind == WarningKind::wrong_answers || warning.kind == WarningKind::answer_anomalies)
      told.push_back(warning_text(warning));
  REQUIRE(told.size() == 2);
  CHECK(told[0] == "A: angles are in degrees");
  CHECK(told[1].size() < 500);
}

TEST_CASE("Times in batches are of no single call, and those of batches at once of none") {
  const auto batches = [](const char* jobs) {
    std::vector<Session> sessions = sample_sessions(5);
    for (Session& session : sessions) session.environment["jobs"] = jobs;
    return study(
        chained,
        [](SolveRecord& solve) {
          if (solve.label == "B") solve.timing = Timing::batch, solve.batch_size = 10;
        },
        {"A", "B"}, sessions);
  };
  for (const char* metric : {"seconds", "seconds_per_success", "solved_in_time"}) {
    const MetricSamples of = make_samples(batches("1"), metric_named(metric));
    CHECK(excluded(group(of, "B")));
    CHECK(list_of(group(of, "B")).empty());
    REQUIRE(of.warnings.size() == 1);
    CHECK(of.warnings.front().solvers == std::vector<std::string>{"B"});
    CHECK(make_samples(batches("2"), metric_named(metric)).warnings.front().solvers.empty());
  }
  CHECK(solve_times(batches("1"), "B").empty());
  CHECK(batches("1").batch_timings.at("B").first == std::set{10});
  CHECK(std::ssize(batches("1").batch_timings.at("B").second) == std::ssize(batches("1").of("B")));
}

TEST_CASE("Solved in time is a share of all solves, also of busy sessions") {
  const Asked asked{.start = "middle",
                    .targets = "drawn",
                    .runs = 6,
                    .points = 20,
                    .tolerance_cm = 1,
                    .rest = R"(, "analysis": {"deadline_ms": 2})"};
  const auto late = [](SolveRecord& solve) {
    solve.status = solve.point == 20 ? Status::tolerance_missed : Status::ok;
    const bool is_late = solve.label == "B" && solve.point <= 8 + solve.run % 2;
    solve.seconds = solve.cpu_seconds = is_late ? 0.003 : 0.002;
  };
  const JudgedStudy judged = judge::judge(study(asked, late));
  const JudgedMetric* const in_time = find_metric(judged, "solved_in_time");
  REQUIRE(in_time != nullptr);
  CHECK(in_time->descriptives[0].n == 120);
  CHECK(in_time->descriptives[0].mean == Approx(19 / 20.0));
  CHECK(in_time->descriptives[1].mean == Approx((10.5) / 20));
  const FlatComparison found = flat(in_time->comparisons.front());
  CHECK(found.verdict == Verdict::better);
  CHECK(found.n == 6);
  CHECK(found.test == "paired t");
  CHECK(find_metric(judge::judge(study({}, as_made)), "solved_in_time") == nullptr);
  Asked of_a_loop = asked;
  of_a_loop.rest = R"(, "loop": {"period_ms": 2})";
  CHECK(find_metric(judge::judge(study(of_a_loop, late)), "solved_in_time")->descriptives[0].mean == Approx(19 / 20.0));
  const auto late_when_busy = [](SolveRecord& solve) { solve.seconds = solve.run == 1 ? 0.003 : 0.001; };
  const JudgedStudy busy = judge::judge(study(asked, late_when_busy));
  CHECK(find_metric(busy, "solved_in_time")->descriptives[0].n == 120);
  CHECK(find_metric(busy, "solved_in_time")->descriptives[0].mean == Approx(100 / 120.0));
  CHECK(find_metric(busy, "seconds")->descriptives[0].n == 5);  // times are those of quiet sessions
}

TEST_CASE("Where time alone ends solves at the deadline, what is solved is solved in time") {
  const auto judged_with = [](double seconds, int iterations, int evaluations, const std::string& metric = "") {
    StudyResults of = study({.start = "middle",
                             .targets = "drawn",
                             .runs = 6,
                             .points = 5,
                             .tolerance_cm = 1,
                             .rest = R"(, "analysis": {"deadline_ms": 2})"},
                            as_made);
    of.definition.stop.seconds = seconds;
    of.definition.stop.iterations = iterations;
    of.definition.stop.evaluations = evaluations;
    of.definition.plan.metric = metric;
    return judge::judge(std::move(of));
  };
  CHECK(find_metric(judged_with(0.002, 1'000'000, 0), "solved_in_time") == nullptr);
  const JudgedStudy planned = judged_with(0.002, 1'000'000, 0, "solved_in_time");  // whoever asks for it has it
  REQUIRE(find_metric(planned, "solved_in_time") == &planned.metrics[planned.primary]);
  CHECK(find_metric(planned, "solved_in_time")->descriptives[0].mean == 1);
  CHECK(find_metric(judged_with(0.003, 1'000'000, 0), "solved_in_time") != nullptr);
  CHECK(find_metric(judged_with(0.002, 200, 0), "solved_in_time") != nullptr);
  CHECK(find_metric(judged_with(0.002, 1'000'000, 100), "solved_in_time") != nullptr);
}

TEST_CASE("Joint motion that is how a solver rounds makes nobody better") {
  const Asked initial{.start = "initial", .runs = 20, .points = 1, .tolerance_cm = 1};
  const auto judged_with = [&](double of_a, double of_b) {
    const JudgedStudy all = judge::judge(study(initial, [=](SolveRecord& solve) {
      solve.variation_deg = (solve.label == "A" ? of_a : of_b) * (1 + 0.01 * solve.run);
    }));
    return verdict_of(find_metric(all, "variation_deg")->comparisons.front());
  };
  CHECK_FALSE(is_difference(judged_with(6e-8, 1e-4)));
  CHECK(judged_with(6e-3, 1e-1) == Verdict::better);
}

TEST_CASE("Times of 0 per solved are not compared") {
  const Asked asked{.start = "middle", .targets = "drawn", .runs = 6, .points = 20, .tolerance_cm = 1};
  const auto misses = [](SolveRecord& solve) {
    solve.status = solve.point == 20 ? Status::tolerance_missed : Status::ok;
  };
  const MetricSamples of = make_samples(without_times(study(asked, misses)), metric_named("seconds_per_success"));
  CHECK(std::get<ExcludedSample>(group(of, "A").sample).reason == ExclusionReason::not_comparable);
  CHECK(compared(of, {}).front().verdict == Verdict::not_tested);
}

TEST_CASE("Evaluations that nobody counted are lost, and a solver's own count is a doubt") {
  const auto counted = [](CountedBy by) {
    return make_samples(study(chained,
                              [by](SolveRecord& solve) {
                                if (solve.label == "B") solve.counted_by = by, solve.status = Status::not_finite;
                              }),
                        metric_named("evaluations"));
  };
  CHECK(counted(CountedBy::ikbench).warnings.empty());
  const MetricSamples nobody = counted(CountedBy::none), itself = counted(CountedBy::solver);
  CHECK(missing_in(group(nobody, "B")) == 5);
  CHECK(missing_in(group(itself, "B")) == 0);
  for (const MetricSamples& of : {nobody, itself}) {
    REQUIRE(of.warnings.size() == 1);
    CHECK(of.warnings.front().kind == WarningKind::counts_not_comparable);
    CHECK(of.warnings.front().solvers == std::vector<std::string>{"B"});
    CHECK(excluded(group(of, "B")));
    CHECK_FALSE(excluded(group(of, "A")));
  }
}

TEST_CASE("Orientation counts where a pose is searched, bends are of a run") {
  const Asked pose{.rest = R"(, "search": "pose")"};
  const auto turned = [](SolveRecord& solve) {
    solve.orientation_error = 0.1;
    solve.answer_rad = {solve.point == 3 ? ikbench::base::degree : 0.0, 1.0 * solve.run};
  };
  CHECK(list_of(group(samples_of(study(pose, turned), "orientation_error_deg"), "A")).front() ==
        Approx(7.02166).epsilon(1e-6));
  CHECK(list_of(group(samples_of(study(chained, turned), "orientation_error_deg"), "A")).empty());
  CHECK(list_of(group(samples_of(study(chained, turned), "second_difference_deg"), "A")).size() == 5);
  CHECK(list_of(group(samples_of(study(chained, turned), "second_difference_deg"), "A")).back() == Approx(0.75));
  CHECK_FALSE(samples_of(study(fixed_targets, turned), "second_difference_deg").is_paired);
  CHECK_THROWS_WITH(metric_named("bend_deg"), "bend_deg is now called second_difference_deg");
}

TEST_CASE("Answers that claim too much or lie outside limits are counted") {
  const StudyResults of = study(chained, [](SolveRecord& solve) {
    if (solve.run == 1 && solve.point == 1) solve.status = Status::misreported;
    if (solve.run == 2 && solve.label == "A") solve.limit_violation_deg = 3;
    if (solve.run == 3 && solve.point == 1 && solve.label == "A") solve.limit_violation_m = 3;
  });
  CHECK(warning_of(of, WarningKind::misreported)->count == 2);
  CHECK(warning_of(of, WarningKind::misreported)->total == 40);
  CHECK(warning_of(of, WarningKind::limit_violations)->count == 5);
  CHECK(warning_of(of, WarningKind::limit_violations)->solvers == std::vector<std::string>{"A"});
}

TEST_CASE("Budgets differ where equal iterations are half as many evaluations again") {
  const auto evaluated = [](double factor, const std::string& stop, StopReason reason = StopReason::iterations) {
    const Asked asked{.rest = R"(, "stop": )" + stop};
    return warning_of(study(asked,
                            [&](SolveRecord& solve) {
                              solve.stop_reason = reason;
                              if (solve.label == "B") solve.evaluations = static_cast<std::int64_t>(100 * factor);
                            }),
                      WarningKind::budgets_differ);
  };
  const auto warning = evaluated(3, R"({"iterations": 9})");
  REQUIRE(warning);
  CHECK(warning->solvers == std::vector<std::string>{"B", "A"});
  CHECK(warning->count == Approx(300));
  CHECK(warning->total == Approx(100));
  CHECK_FALSE(evaluated(1.4, R"({"iterations": 9})"));
  CHECK(evaluated(1.6, R"({"iterations": 9, "evaluations": 300})"));
  CHECK_FALSE(evaluated(3, R"({"iterations": 9})", StopReason::tolerance));
  CHECK_FALSE(evaluated(3, R"({"iterations": 9, "seconds": 1})"));
  // A limit that ends fewer than a tenth of 20 solves is none.
  const auto ended_by_limit = [](int most) {
    int ended = 0;
    return study({.rest = R"(, "stop": {"iterations": 9})"}, [=](SolveRecord& solve) mutable {
      if (solve.label == "A") solve.evaluations = 300;
      if (solve.label == "B" && ++ended <= most) solve.stop_reason = StopReason::iterations;
    });
  };
  for (int most = 0; most <= 4; ++most)
    CHECK(warning_of(ended_by_limit(most), WarningKind::budgets_differ).has_value() == (most >= 2));
}

TEST_CASE("A number of the study's check has no name of a metric, in whatever letters") {
  StudyResults of = study({}, as_made);
  for (const char* name : {"position_error_cm", "Joint-move", "joint motion", "answered"}) {
    of.definition.check.larger = {name};
    CHECK_THROWS_WITH(metrics_of(of.definition), ContainsSubstring("the name of a metric"));
  }
}

TEST_CASE("Targets out of reach and a plan that was changed after the data are told") {
  const Asked asked{
      .rest = R"(, "unreachable_targets": {"points": 2}, "analysis": {"test": "ranks", "margin_percent": 10})"};
  CHECK(warning_of(study(asked, as_made), WarningKind::unreachable_targets)->count == 2);
  CHECK(warning_of(study(asked, as_made), WarningKind::unreachable_targets)->total == 4);
  const auto recorded = [&](const std::string& plan) {
    std::vector<Session> sessions = sample_sessions(asked.runs);
    for (Session& session : sessions) session.environment["analysis"] = plan;
    return warning_of(study(asked, as_made, {"A", "B"}, sessions), WarningKind::plan_changed);
  };
  CHECK_FALSE(recorded(R"({"test": "ranks", "margin_percent": 10})"));
  REQUIRE(recorded(R"({"test": "means", "margin_percent": 5})"));
  CHECK(recorded(R"({"test": "means", "margin_percent": 5})")->detail == "margin_percent, test");
  CHECK(recorded(R"({"test": "means", "margin_percent": 5})")->count == 40);
  CHECK_FALSE(recorded(R"({"margin_cm": 1, "margin_percent": 10})"));  // a field that is gone
  StudyResults of = study(asked, as_made);
  of.stale_solves.solvers = {"B"};
  of.stale_solves.count = 7;
  CHECK(warning_of(of, WarningKind::stale_solves)->count == 7);
}

TEST_CASE("A usual study has no doubts, and every kind has a line of at most 25 words") {
  CHECK(study_warnings(study(chained, as_made)).empty());
  CHECK(study_warnings(study(drawn, as_made)).empty());
  const std::vector<std::string> many{"one", "two", "three", "four", "five", "six"};
  for (int kind = 0; kind <= static_cast<int>(WarningKind::stale_solves); ++kind) {
    const std::string line = warning_text({.kind = static_cast<WarningKind>(kind),
                                           .solvers = many,
                                           .count = 3,
                                           .total = 20,
                                           .detail = "the reason in five words"});
    std::istringstream words(line);
    const auto count = std::distance(std::istream_iterator<std::string>(words), {});
    CAPTURE(line);
    CHECK(count > 4);
    CHECK(count <= 25);
  }
  CHECK(warning_text({.kind = WarningKind::limit_violations, .solvers = {"A", "B", "C", "D"}}).find("A, B, C and D") !=
        std::string::npos);
  CHECK(warning_text(
            {.kind = WarningKind::times_not_comparable, .solvers = {"mine"}, .detail = "the machine was busy"}) ==
        "times of mine are not compared: the machine was busy; rerun with --out NEW");
}

TEST_CASE("one solve that takes most of the time decides no cost per solved target") {
  const Asked drawn_20{.start = "middle", .targets = "drawn", .runs = 20, .points = 1, .tolerance_cm = 0.1};
  const auto judged_with = [&](std::int64_t slowest, int solved = 16, int of_b = 100) {
    const StudyResults of = study(drawn_20, [&](SolveRecord& solve) {
      solve.status = solve.run > solved ? Status::tolerance_missed : Status::ok;
      solve.evaluations = (solve.label == "A" ? 50 : of_b) + solve.run;
      if (solve.label == "B" && solve.run == 8) solve.evaluations = slowest;
    });
    return *find_metric(judge::judge(of), "evaluations_per_success");
  };
  const JudgedMetric slow = judged_with(100'000);
  CHECK(flat(slow.comparisons.front()).why == ResultKind::few_decide);
  CHECK(slow.samples.warnings.front().solvers == std::vector<std::string>{"B"});
  const FlatComparison even = flat(judged_with(100).comparisons.front());
  CHECK((even.verdict == Verdict::better && even.estimate && !even.interval));  // of 16 solved ones
  CHECK(flat(judged_with(61, 16, 50).comparisons.front()).verdict == Verdict::inconclusive);
  CHECK(flat(judged_with(100, 3).comparisons.front()).why == ResultKind::few_decide);
}

TEST_CASE("what attempts spent is by what they solved, and the spread of its parts is its error") {
  // Of 100 targets A solves 80 with 10 evaluations each, and spends 1000 on each of the others; B solves all with 50.
  const Asked drawn_100{.start = "middle",
                        .targets = "drawn",
                        .runs = 100,
                        .points = 1,
                        .tolerance_cm = 0.1,
                        .rest = R"(, "analysis": {"tie_breakers": []})"};
  const StudyResults of = study(drawn_100, [](SolveRecord& solve) {
    const bool fails = solve.label == "A" && solve.run % 5 == 0;
    solve.status = fails ? Status::tolerance_missed : Status::ok;
    solve.evaluations = fails ? 1000 : solve.label == "A" ? 10 : 50;
  });
  const JudgedStudy all = judge::judge(of);
  const JudgedMetric& spent = *find_metric(all, "evaluations_per_success");
  CHECK(find_metric(all, "evaluations") == nullptr);
  CHECK(spent.descriptives[0].mean == Approx((80 * 10 + 20 * 1000) / 80.0));
  CHECK(spent.descriptives[1].mean == Approx(50));
  const FlatComparison found = flat(spent.comparisons.front());
  CHECK(*found.estimate == Approx(260 / 50.0));
  CHECK(found.verdict == Verdict::worse);
  // The delta method by hand: the variance of each target's part of log(spent) - log(solved), by n.
  double square = 0;
  for (int i = 0; i < 100; ++i) {
    const double part = i % 5 == 0 ? 1000 / 208.0 : 10 / 208.0 - 1 / 0.8;
    square += part * part;
  }
  // A's sum is worth 20 800^2 / 20 008 000 = 21.6 values.
  CHECK(std::log(found.interval->high / *found.estimate) == Approx(2.081 * std::sqrt(square / 99 / 100)).epsilon(1e-3));
}

TEST_CASE("calls through a pipe are told apart in a warm study, and not compared with warm ones") {
  const auto warm_study = [](Timing of_a, Timing of_b) {
    StudyResults warm = study({.runs = 6}, [=](SolveRecord& solve) {
      solve.timing = solve.label == "A" ? of_a : of_b;
      if (solve.timing != Timing::clean) solve.wall_seconds = 2 * solve.seconds;
    });
    for (Session& session : warm.sessions) session.environment["state"] = "warm";
    return warm;
  };
  const StudyResults one_cold = warm_study(Timing::process, Timing::process_warm);
  REQUIRE(time_warnings(one_cold).size() == 1);
  CHECK(time_warnings(one_cold).front().solvers == std::vector<std::string>{"A"});
  CHECK(timed_calls_text(one_cold) == "second calls on a target, but those of A through a pipe, which are not warm");
  StudyResults all_cold = warm_study(Timing::process, Timing::process);
  CHECK(time_warnings(all_cold).empty());
  CHECK(timed_calls_text(all_cold) == "calls through a pipe, which are not warm");
  all_cold.imported.labels = {"B"};  // which is then the only solver with a warning
  REQUIRE(time_warnings(all_cold).size() == 1);
  CHECK(time_warnings(all_cold).front().solvers == std::vector<std::string>{"B"});
  CHECK(timed_calls_text(all_cold) == "calls through a pipe, which are not warm");
  const StudyResults none_cold = warm_study(Timing::clean, Timing::process_warm);
  CHECK(time_warnings(none_cold).empty());
  CHECK(timed_calls_text(none_cold) == "second calls on a target");
}
