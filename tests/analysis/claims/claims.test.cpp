// The rules that judge claims, by those of slim2023, and mistakes in a file of claims.
#include <algorithm>
#include <functional>
#include <numbers>
#include <set>
#include <stdexcept>

#include "analysis/claims/rules.hpp"
#include "analysis/inference/make_study.hpp"
#include "analysis/papers.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "tests/analysis/folder.hpp"
#include "tests/analysis/synthetic.hpp"
#include "tests/catch.hpp"
#include "tests/contains.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::statistics;
using namespace ikbench::inference;
using namespace ikbench::report;
using namespace ikbench::claims;

namespace {

StudyResults study_of(std::vector<SolveRecord> solves, const std::string& name = "s") {
  StudyResults study = make_study(name, std::move(solves));
  study.facts.published = "slim2023";
  return study;
}

std::vector<Claim> claims_of(StudyResults study, const std::vector<StudyResults>& companions = {}) {
  const JudgedStudy judged(std::move(study));
  const std::vector<JudgedStudy> others(companions.begin(), companions.end());
  return analysis::paper("slim2023").claims({judged, {others.begin(), others.end()}});
}

// Finds a claim by its id.
const Claim& claim_of(const std::vector<Claim>& claims, const std::string& id) {
  const auto found = std::ranges::find(claims, id, &Claim::id);
  REQUIRE(found != claims.end());
  return *found;
}

Verdict verdict_of(const std::vector<Claim>& claims, const std::string& id) { return claim_of(claims, id).verdict; }

// The claims after something is done to every solve.
std::vector<Claim> claims_after(const std::function<void(SolveRecord&)>& change) {
  std::vector<SolveRecord> solves = synthetic::solves({});
  for (SolveRecord& solve : solves) change(solve);
  return claims_of(study_of(std::move(solves)));
}

}  // namespace

TEST_CASE("claims hold, hold in part, are undecided or fail, by the store's numbers", "[claims]") {
  const auto as_printed = claims_of(study_of(synthetic::solves({})));
  CHECK(verdict_of(as_printed, "most_accurate") == Verdict::holds);
  CHECK(verdict_of(as_printed, "accuracy_order") == Verdict::in_part);  // as in print
  CHECK(verdict_of(as_printed, "least_variation") == Verdict::holds);   // of IK-BA and MO-PSO together
  CHECK(contains(claim_of(as_printed, "least_variation").number, ", PSO 2"));
  CHECK(verdict_of(as_printed, "better_than_ba") == Verdict::holds);
  CHECK(verdict_of(as_printed, "solvers_differ") == Verdict::holds);
  CHECK(verdict_of(as_printed, "inside_limits") == Verdict::holds);
  StudyResults by_point = study_of(synthetic::solves({}));
  by_point.plan.unit = Unit::point;
  CHECK(verdict_of(claims_of(by_point), "least_variation") == Verdict::undecided);

  std::vector<SolveRecord> solves = synthetic::solves({});
  for (SolveRecord& solve : solves) {
    if (solve.solver == "IK-BA") {
      solve.position_error_cm *= 2000;
      solve.variation_deg *= 4;
      solve.limit_violation_deg = 1;
    }
    solve.timing = Timing::parallel;
  }
  const auto otherwise = claims_of(study_of(solves));
  CHECK(verdict_of(otherwise, "most_accurate") == Verdict::fails);
  CHECK(verdict_of(otherwise, "least_variation") == Verdict::fails);  // MO-PSO alone is not both
  CHECK(verdict_of(otherwise, "better_than_ba") == Verdict::fails);   // 3.8 against 1.68 cm
  CHECK(verdict_of(otherwise, "inside_limits") == Verdict::fails);
  CHECK(claim_of(otherwise, "inside_limits").number == "400 of 400 outside");

  solves[0].position_error_cm = not_defined;  // an answer of IK-BA that is none
  CHECK(verdict_of(claims_of(study_of(solves)), "most_accurate") == Verdict::fails);
  CHECK(claims_of(make_study("unpublished", synthetic::solves({}))).empty());
}

TEST_CASE("where all solvers are the same to the bit, nothing that is claimed of one of them is found", "[claims]") {
  std::vector<SolveRecord> solves = synthetic::solves({.runs = 3});
  for (SolveRecord& solve : solves) {
    solve.position_error_cm = solve.claimed_error_cm = 1 + 0.1 * solve.run;
    solve.variation_deg = 10 + solve.run;
    solve.seconds = solve.cpu_seconds = 0.001 * solve.run;
    solve.answer_rad.assign(7, 0.1);
  }
  const auto tied = claims_of(study_of(solves));
  const Claim& accuracy = claim_of(tied, "accuracy_order");
  CHECK(accuracy.verdict == Verdict::undecided);
  CHECK(accuracy.number == "0 of 15 pairs by the test");
  for (const char* id :
       {"most_accurate", "least_variation", "better_than_ba", "best_compromise", "repeatable", "smooth_angles"}) {
    INFO(id);
    CHECK(verdict_of(tied, id) == Verdict::undecided);
  }
  CHECK(verdict_of(tied, "least_error_at_each_point") == Verdict::fails);
  CHECK(claim_of(tied, "least_error_at_each_point").number == "0 of 20 points");
  CHECK(verdict_of(tied, "solvers_differ") == Verdict::fails);
}

TEST_CASE("claims are judged on the printed numbers too, by Tamhane's test", "[claims]") {
  const auto all = claims_of(study_of(synthetic::solves({})));
  const auto printed = [&](const char* id) { return claim_of(all, id).printed; };
  CHECK(printed("most_accurate") == Verdict::holds);
  CHECK(printed("accuracy_order") == Verdict::in_part);  // MO-PSO, PSO and DE cannot be told apart
  CHECK(printed("least_variation") == Verdict::holds);   // 87.1916 and 89.9602 against 274.7692 deg and more
  CHECK(printed("better_than_ba") == Verdict::holds);
  CHECK(printed("best_compromise") == Verdict::in_part);  // PSO is faster, so that neither dominates
  CHECK(contains(evidence_text(claim_of(all, "best_compromise")), "Printed: it dominates 4."));
  CHECK(printed("repeatable") == Verdict::holds);  // 1.8e-4 cm against 0.07 and more
  CHECK(printed("solvers_differ") == Verdict::holds);
  CHECK(!printed("inside_limits"));
}

TEST_CASE("the paper's claims are all there, those without numbers as what cannot be tested", "[claims]") {
  const auto all = claims_of(study_of(synthetic::solves({})));
  CHECK(claims_by(Claimant::us, all).size() == 2);  // the others of ours need companions
  for (const char* id :
       {"elongation_control", "real_time", "only_offline_above_12", "circle", "real_arm", "singularities_avoided"}) {
    CHECK(verdict_of(all, id) == Verdict::untested);
  }
  CHECK(contains(evidence_text(claim_of(all, "real_arm")), "What would decide it: A measurement on the arm"));
  CHECK(contains(evidence_text(claim_of(all, "elongation_control")), "`ikbench reproduce` runs the study"));
  std::set<std::string> ids;
  for (const Claim& claim : all) {
    CHECK(ids.insert(claim.id).second);
    CHECK(!claim.section.empty());
    CHECK(!claim.decides.empty());
  }
  CHECK(all.size() == 20);  // two of them our own
  CHECK(tally(all).starts_with("Of 18 claims, "));
  CHECK(contains(tally(all), ", 6 are untestable and 4 are not comparable. As printed, "));
}

TEST_CASE("a solver that is the most accurate by its mean alone is so in part, where the plan asks for more than means",
          "[claims]") {
  std::vector<SolveRecord> solves = synthetic::solves({});
  for (SolveRecord& solve : solves) {
    if (solve.solver == "PSO" && solve.point != solve.run) solve.position_error_cm *= 1e-6;  // lost once in a run
  }
  StudyResults study = study_of(solves);
  const Claim claim = claim_of(claims_of(study), "most_accurate");
  CHECK(claim.verdict == Verdict::in_part);
  CHECK(claim.printed == Verdict::holds);
  CHECK(contains(evidence_text(claim),
                 "The worst cases decide the mean, which the paper compares; by typical error PSO is better."));
  study.plan.estimands = {Estimand::mean};
  CHECK(verdict_of(claims_of(study), "most_accurate") == Verdict::holds);
}

TEST_CASE("times of another program are not compared: our ratio stands beside the printed one", "[claims]") {
  // PSO 2.1 and MO-PSO 12.8 against IK-BA's 2.4 ms; printed medians: 0.1946 and 1.2222 against 0.2359 s.
  std::vector<SolveRecord> solves = synthetic::solves({});
  for (SolveRecord& solve : solves) {
    const double ms = solve.solver == "IK-BA" ? 2.4 : solve.solver == "PSO" ? 2.1 : 12.8;
    solve.seconds = solve.cpu_seconds = ms / 1000;
  }
  const auto timed = claims_of(study_of(solves));
  CHECK(claim_of(timed, "pso_fastest").number == "PSO 0.875 times IK-BA, printed 0.825");
  CHECK(claim_of(timed, "mo_pso_slowest").number == "MO-PSO 5.33 times IK-BA, printed 5.18");
  for (SolveRecord& solve : solves) solve.timing = Timing::parallel;
  const auto untimed = claims_of(study_of(solves));
  for (const char* id : {"time_order", "pso_fastest", "mo_pso_slowest", "faster_than_challengers"}) {
    INFO(id);
    CHECK(verdict_of(timed, id) == Verdict::incomparable);
    CHECK(verdict_words(claim_of(timed, id)) == "not comparable");
    CHECK(verdict_of(untimed, id) == Verdict::incomparable);
    CHECK(claim_of(untimed, id).number.empty());
    CHECK(contains(evidence_text(claim_of(untimed, id)), "times are not comparable (see the warnings)"));
  }
}

TEST_CASE("an order that most pairs keep holds in part", "[claims]") {
  const auto ordered = [](double of_ik_ba, double of_others) {
    return claim_of(claims_after([=](SolveRecord& solve) {
                      const std::vector<std::string> order{"IK-BA", "K-ABC", "DE", "MO-PSO", "PSO", "BA"};
                      const auto place = static_cast<double>(std::ranges::find(order, solve.solver) - order.begin());
                      solve.position_error_cm = 10 + (place == 0 ? of_ik_ba : of_others * place) + 0.01 * solve.run;
                    }),
                    "accuracy_order");
  };
  CHECK(ordered(0, 1).verdict == Verdict::holds);
  CHECK(ordered(1.5, 1).verdict == Verdict::in_part);  // from the first place to the second
  CHECK(ordered(1.5, 1).number == "14 of 15 pairs by the test");
  CHECK(contains(evidence_text(ordered(1.5, 1)), "Here, by the mean of the runs: K-ABC 11.1 cm, IK-BA 11.6"));
  CHECK(ordered(0, -1).verdict == Verdict::fails);
}

TEST_CASE("a compromise is the best where it dominates every other, and fails where one dominates it", "[claims]") {
  const auto best = claims_after([](SolveRecord& solve) {
    const bool is_first = solve.solver == "IK-BA";
    solve.position_error_cm = (is_first ? 1 : 2) + 0.01 * solve.run;
    solve.variation_deg = 10 + solve.run;  // the same of all
    solve.seconds = solve.cpu_seconds = (is_first ? 1 : 2) + 0.01 * solve.run;
  });
  CHECK(verdict_of(best, "best_compromise") == Verdict::holds);
  CHECK(claim_of(best, "best_compromise").number == "ahead of 5 of 5");
  const auto dominated = claims_after([](SolveRecord& solve) {
    solve.position_error_cm = (solve.solver == "DE" ? 1 : 2) + 0.01 * solve.run;
    solve.variation_deg = 10 + solve.run;
    solve.seconds = solve.cpu_seconds = 1 + 0.01 * solve.run;
  });
  CHECK(verdict_of(dominated, "best_compromise") == Verdict::fails);
  // Times apart: nothing can be the best in all three.
  const auto untimed = claims_after([](SolveRecord& solve) {
    solve.position_error_cm = (solve.solver == "IK-BA" ? 1 : 2) + 0.01 * solve.run;
    solve.timing = Timing::parallel;
  });
  CHECK(verdict_of(untimed, "best_compromise") == Verdict::in_part);
}

TEST_CASE("the least error at each point is counted point by point", "[claims]") {
  const auto at_points = [](int points) {
    return claim_of(claims_after([points](SolveRecord& solve) {
                      const bool is_first = solve.solver == "IK-BA", is_second = solve.solver == "DE";
                      solve.position_error_cm = is_first && solve.point <= points ? 1 : is_second ? 2 : 3;
                    }),
                    "least_error_at_each_point");
  };
  CHECK(at_points(20).verdict == Verdict::holds);
  CHECK(at_points(11).verdict == Verdict::in_part);
  CHECK(at_points(11).number == "11 of 20 points");
  CHECK(contains(evidence_text(at_points(11)), "IK-BA at 11 and DE at 9 of 20 points"));
  CHECK(at_points(10).verdict == Verdict::fails);
}

TEST_CASE("repeatable is who has the smallest spread over the runs, whatever its mean", "[claims]") {
  const auto spread = [](double of_first, double of_others) {
    return claims_after([=](SolveRecord& solve) {
      solve.position_error_cm = 100 + (solve.solver == "IK-BA" ? of_first : of_others) * (solve.run - 10.5);
    });
  };
  CHECK(verdict_of(spread(0.1, 1), "repeatable") == Verdict::holds);
  CHECK(verdict_of(spread(1, 0.1), "repeatable") == Verdict::fails);
  CHECK(verdict_of(spread(1, 1.01), "repeatable") == Verdict::undecided);
  // The standard deviation of 0.1 (1 to 20) is 0.1 sqrt(35) = 0.592.
  CHECK(claim_of(spread(0.1, 1), "repeatable").number == "sd 0.592 cm, K-ABC 5.92");
}

TEST_CASE("smooth is who bends its joints' angles least and moves no joint far", "[claims]") {
  constexpr double degree = std::numbers::pi / 180;
  // The angles k^2 b of point k have second differences of 2 b everywhere.
  const auto bent = [=](double of_first, double move_of_first) {
    return claims_after([=](SolveRecord& solve) {
      const bool is_first = solve.solver == "IK-BA";
      const double bend = (is_first ? of_first : 2) + 0.01 * solve.run;
      solve.answer_rad.assign(7, bend * solve.point * solve.point * degree);
      solve.largest_move_deg = (is_first ? move_of_first : 30) + 0.1 * solve.run;
    });
  };
  const Claim smooth = claim_of(bent(1, 10), "smooth_angles");
  CHECK(smooth.verdict == Verdict::holds);
  CHECK(smooth.number == "mean 2.21 deg, BA 4.21");  // 2 (1 + 0.01 x 10.5)
  CHECK(verdict_of(bent(1, 60), "smooth_angles") == Verdict::in_part);
  CHECK(verdict_of(bent(3, 60), "smooth_angles") == Verdict::fails);
}

TEST_CASE("elongation is controlled by what changes an answer and without which the joints move more", "[claims]") {
  const StudyResults study = study_of(synthetic::solves({}), "s");
  // Without Eq. 13, and without the pull.
  const auto without = [&](double first, double second) {
    std::vector<SolveRecord> solves = synthetic::solves({.solvers = {"IK-BA"}}), more = solves;
    for (SolveRecord& solve : more) solve.solver = "without the pull";
    solves.insert(solves.end(), more.begin(), more.end());
    for (SolveRecord& solve : solves) {
      const double factor = solve.solver == "IK-BA" ? first : second;
      solve.answer_rad[0] += factor == 1 ? 0 : 0.1;
      solve.variation_deg *= factor;
    }
    return claim_of(claims_of(study, {study_of(solves, "s-elongation")}), "elongation_control");
  };
  CHECK(without(1, 1).verdict == Verdict::fails);
  CHECK(without(1, 1).number == "no answer changes");
  const Claim in_part = without(1, 2);
  CHECK(in_part.verdict == Verdict::in_part);
  CHECK(contains(evidence_text(in_part), "Without Eq. 13 (f_max = 0) all 400 answers are the same to the last bit."));
  CHECK(contains(evidence_text(in_part), "without the pull of s-elongation 17"));  // twice 87 deg
  CHECK(contains(in_part.number, ", without the pull 17"));
  CHECK(without(2, 2).verdict == Verdict::holds);
  CHECK(without(1, 0.5).verdict == Verdict::fails);
}

TEST_CASE("our own questions stand apart and are not counted", "[claims]") {
  const StudyResults study = study_of(synthetic::solves({}), "s");
  StudyResults limits = study_of(synthetic::solves({}), "s-limits");
  limits.facts = facts_of(R"({"published": "slim2023", "limits": "enforced"})");
  StudyResults context = make_study("s-context", synthetic::solves({.solvers = {"DLS"}}));
  for (Solve& solve : context.solves.to_change()) {
    solve.position_error_cm *= 1e-4;
    solve.variation_deg /= 2;
    solve.evaluations = 11;
  }
  auto all = claims_of(study, {limits, context});
  CHECK(verdict_of(all, "accurate_inside_limits") == Verdict::holds);
  CHECK(verdict_of(all, "better_than_classical") == Verdict::fails);
  CHECK(claims_by(Claimant::us, all).size() == 4);
  CHECK(tally(all) == tally(claims_of(study)));

  for (Solve& solve : context.solves.to_change()) solve.evaluations = 20000;
  for (Solve& solve : limits.solves.to_change())
    solve.position_error_cm *= solver_of(limits, solve) == "IK-BA" ? 1000 : 1;
  all = claims_of(study, {limits, context});
  CHECK(verdict_of(all, "accurate_inside_limits") == Verdict::fails);
  CHECK(verdict_of(all, "better_than_classical") == Verdict::in_part);
  CHECK(claims_of(study).size() + 2 == all.size());
}

TEST_CASE("with all clamped or none, each solver's numbers come from the study that has them so", "[claims]") {
  const StudyResults study = study_of(synthetic::solves({}), "s");  // IK-BA 0.0019 cm, K-ABC 0.232 and so on
  StudyResults bounds = study_of(synthetic::solves({}), "s-bounds");
  for (Solve& solve : bounds.solves.to_change()) {
    if (solver_of(bounds, solve) == "IK-BA") solve.position_error_cm *= 40;
    if (solver_of(bounds, solve) == "PSO") solve.position_error_cm *= 1e-6;
  }
  auto all = claims_of(study, {bounds});
  CHECK(verdict_of(all, "accurate_all_clamped") == Verdict::holds);   // 0.076 cm against 0.232
  CHECK(verdict_of(all, "accurate_none_clamped") == Verdict::fails);  // 0.0019 cm against 4e-7
  CHECK(contains(evidence_text(claim_of(all, "accurate_none_clamped")), "Position error: IK-BA 0.00"));
  for (Solve& solve : bounds.solves.to_change()) {
    if (solver_of(bounds, solve) == "IK-BA") solve.position_error_cm *= 100;
    if (solver_of(bounds, solve) == "PSO") solve.position_error_cm *= 1e6;
  }
  all = claims_of(study, {bounds});
  CHECK(verdict_of(all, "accurate_all_clamped") == Verdict::fails);
  CHECK(verdict_of(all, "accurate_none_clamped") == Verdict::holds);
}

TEST_CASE("a circle is led to rounding error where its errors are of the order of rounding", "[claims]") {
  StudyResults circle = study_of(synthetic::solves({.solvers = {"IK-BA", "BA"}, .runs = 1}));
  circle.facts = facts_of(R"({"published": "slim2023", "path": {"kind": "circle"}})");
  const auto verdict = [&](double first, double second) {
    for (Solve& solve : circle.solves.to_change())
      solve.position_error_cm = solver_of(circle, solve) == "IK-BA" ? first : second;
    return verdict_of(claims_of(circle), "circle");
  };
  // The targets are 60 to 100 cm away, so that rounding is some 2e-14 cm.
  CHECK(verdict(3e-14, 1) == Verdict::holds);  // the second solver does not count
  CHECK(verdict(3e-12, 0) == Verdict::fails);
}

TEST_CASE("real time holds for every target or in part on average", "[claims]") {
  const StudyResults study = study_of(synthetic::solves({.runs = 2}));
  std::vector<SolveRecord> solves = synthetic::solves({.solvers = {"12 bats", "15 bats", "30 bats"}, .runs = 1});
  for (SolveRecord& solve : solves) solve.position_error_cm = 0.05;
  const auto claim = [&](const char* id) {
    StudyResults companion = study_of(solves, "s-time");
    companion.facts = facts_of(R"({"published": "slim2023", "stop": {"tolerance_cm": 0.1}})");
    return claim_of(claims_of(study, {companion}), id);
  };
  const auto verdict = [&](const char* id) { return claim(id).verdict; };
  CHECK(verdict("real_time") == Verdict::holds);
  CHECK(verdict("only_offline_above_12") == Verdict::incomparable);
  CHECK(contains(claim("only_offline_above_12").number, "30 bats"));
  CHECK(contains(claim("only_offline_above_12").number, " times 12 bats, printed 2.21"));  // 101.29 by 45.8 ms
  solves[3].position_error_cm = 0.2;
  CHECK(verdict("real_time") == Verdict::in_part);
  solves[4].seconds = 0.06;  // 60 ms, but for as many evaluations as the others: the program was interrupted
  CHECK(verdict("real_time") == Verdict::in_part);
  solves[4].cpu_seconds = 0.06;
  solves[4].evaluations *= 25;
  CHECK(verdict("real_time") == Verdict::in_part);  // one slow solve
  for (SolveRecord& solve : solves) {
    if (solve.solver == "12 bats") solve.seconds = solve.cpu_seconds = 0.06;
  }
  CHECK(verdict("real_time") == Verdict::fails);
}

TEST_CASE("a claim whose own verdict is not clear over all interpretations depends on what decides it", "[claims]") {
  auto all = claims_of(study_of(synthetic::solves({})));
  const std::string before = tally(all);
  const std::vector<ClaimShares> shares{{"most_accurate",
                                         0.61,
                                         0.30,
                                         0.09,
                                         {"who obeys limits", "when a bat is kept", "how many there are"},
                                         "It holds in 3 % where nobody is clamped, in 90 % where all are.",
                                         0.90,
                                         0.04},
                                        {"accuracy_order", 0.02, 0.01, 0.97},
                                        {"better_than_ba", 0.01, 0.96, 0.03, {"how many there are"}},
                                        {"real_arm", 0.5, 0.5, 0},
                                        {"no_such_claim", 0.5, 0.5, 0, {"who obeys limits"}}};
  join(all, shares);
  const Claim& accurate = claim_of(all, "most_accurate");
  CHECK(accurate.verdict == Verdict::depends);
  CHECK(verdict_words(accurate) == "depends on who obeys limits etc.");
  CHECK(accurate.number == "holds in 61 %, fails in 30 % (of those that fit: 90 %, 4 %)");
  CHECK(evidence_text(accurate).starts_with("By our default: holds. Position error: "));
  CHECK(evidence_text(accurate).ends_with(" It holds in 3 % where nobody is clamped, in 90 % where all are."));
  const Claim& order = claim_of(all, "accuracy_order");
  CHECK(order.verdict == Verdict::in_part);  // as before: what holds in part is undecided, and that is clear
  CHECK(
      contains(evidence_text(order), "Over all interpretations it holds in 2 %, fails in 1 %, is undecided in 97 %."));
  const Claim& ba = claim_of(all, "better_than_ba");
  CHECK(verdict_words(ba) == "depends on how many there are");  // clear, but not what the default says
  CHECK(evidence_text(ba).starts_with("By our default: holds. "));
  CHECK(verdict_of(all, "real_arm") == Verdict::untested);
  CHECK(tally(all) != before);
  CHECK(contains(tally(all), ", 2 depend on the interpretation, "));
}

namespace {

const std::string good = "[[claims]]\nid = \"a_claim\"\nsentence = \"S\"\ndecides = \"D.\"\nrule = \"inside_limits\"\n";
const std::string of_metrics =
    "[[claims]]\nid = \"a_claim\"\nsentence = \"S\"\ndecides = \"D.\"\nrule = \"smallest\"\n";

std::vector<ClaimEntry> entries(const std::string& text) {
  return read_claims("slim2023", text, "claims.toml").entries;
}

std::string complaint(const std::string& text) {
  try {
    entries(text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a mistake among the claims is refused with file and line", "[claims]") {
  CHECK(entries(good).size() == 1);
  const auto refused = [](const std::string& text, const std::string& place, const std::string& words) {
    CAPTURE(text);
    const std::string said = complaint(text);
    CHECK(said.starts_with("claims.toml" + place));
    CHECK(contains(said, words));
  };
  refused(good + "metrics = [\"beauty\"]\n", ":6:", "\"position_error_cm\"");
  refused(good + "by = \"them\"\n", ":6:", "one of \"paper\", \"us\"");
  const std::string of_one = of_metrics + "solver = \"A\"\nmetrics = [\"variation_deg\"]\n";
  CHECK(entries(of_one + "universes = [\"mean\"]\n").front().universes.size() == 1);
  refused(of_one + "universes = [\"median\"]\n", ":8:", "\"mean\", \"typical\"");
  refused(good + "universes = [\"mean\"]\n", ":6:", "a solver with one metric");
  refused(of_metrics, ":1:", "the rule smallest without metrics; expected one at least");
  refused(good + "colour = \"red\"\n", ":6:", "unknown key \"colour\"");
  refused(good + "solver = \"\\u001b[2J\"\n", ":6:", "without control characters");
  refused(good + "section = \"" + std::string(201, 'x') + "\"\n", ":6:", "at most 200 bytes");
  refused(good + good, ":6:", "the claim a_claim is there twice");
  refused("[[claims]]\nid = \"A claim\"\nsentence = \"S\"\ndecides = \"D\"\nrule = \"smallest\"\n",
          ":2:", "lower-case letters");
  refused("[[claims]]\nid = \"a\"\nsentence = \"S\"\ndecides = \"D\"\nrule = \"smalest\"\n",
          ":1:", "did you mean \"smallest\"?");
  refused("\n[[claims]]\nid = \"a\"\n", ":2:", "a claim without sentence");
  refused("[[claims]\n", ":1:", "not TOML");
  refused("claims = 3\n", ":", "expected tables [[claims]]");
  refused("claims = []\n", ":", "expected tables [[claims]]");
  refused("", ":", "expected tables [[claims]]");
  refused("[[other]]\n", ":1:", "unknown key \"other\"");
}

TEST_CASE("a paper that prints no means has claims on its solver's answers too", "[claims]") {
  ClaimsFile file = read_claims("slim2023", good + "solver = \"IK-BA\"\n", "claims.toml");
  const auto verdicts = [&](std::vector<SolveRecord> solves) {
    const JudgedStudy study(make_study("s", std::move(solves)));
    std::vector<Verdict> all;
    for (const Claim& claim : claims::judged(file, {study, {}})) all.push_back(claim.verdict);
    return all;
  };
  std::vector<SolveRecord> solves = synthetic::solves({});
  for (SolveRecord& solve : solves) solve.limit_violation_deg = 0;
  CHECK(verdicts(solves) == std::vector{Verdict::holds});
  std::erase_if(solves, [](const SolveRecord& solve) { return solve.solver != "DE" && solve.solver != "PSO"; });
  CHECK(verdicts(solves) == std::vector{Verdict::untested});
  file = read_claims("slim2023", of_metrics + "solver = \"DE\"\nmetrics = [\"position_error_cm\"]\n", "claims.toml");
  file.entries.front().rule = "least_spread";  // it compares with printed spreads
  CHECK(verdicts(solves) == std::vector{Verdict::untested});
}

TEST_CASE("a claim is of the paper's own solver where it names none", "[claims]") {
  CHECK(entries("solver = \"A\"\n" + good).front().solver == "A");
  CHECK(entries("solver = \"A\"\n" + good + "solver = \"B\"\n").front().solver == "B");
}

TEST_CASE("every rule judges a claim of some paper", "[claims]") {
  std::set<std::string> used;
  for (const std::string paper : {"slim2023", "beeson2015"}) {
    const std::string file = "analysis/" + paper + "/claims.toml";
    for (const ClaimEntry& entry : read_claims(paper, text_of_file(file), file).entries) used.insert(entry.rule);
  }
  for (const std::string& rule : rule_names()) CHECK(used.count(rule) == 1);
}
