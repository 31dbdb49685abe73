#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <span>

#include "analysis/claims/rules.hpp"
#include "analysis/inference/comparable.hpp"
#include "analysis/inference/design.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/inference/times.hpp"
#include "analysis/report/assessment_words.hpp"

namespace ikbench::claims {

using namespace results;
using namespace statistics;
using namespace inference;
using namespace report;

Claims least_at_each_point(const Case& of) {
  const StudyResults& study = of.study();
  const Metric metric = of.entry.metrics.front();
  if (!of.has_solver()) return {};
  std::map<int, std::map<std::string, std::vector<double>>> values;  // by point and solver, one per run
  for (const Solve& solve : study.solves) {
    values[solve.point][solver_of(study, solve)].push_back(value_of(study, solve, metric));
  }
  std::map<std::string, int> first;  // number of points; a tie counts for nobody
  for (const auto& [point, of_solvers] : values) {
    std::vector<std::string> least;
    double smallest = std::numeric_limits<double>::infinity();
    for (const auto& [solver, of_runs] : of_solvers) {
      const double average = average_of(metric)(of_runs);
      if (average < smallest) least.clear();
      if (average <= smallest) least.push_back(solver);
      smallest = std::min(smallest, average);
    }
    if (least.size() == 1) ++first[least.front()];
  }
  Claim claim = of.begun();
  const int own = first[of.entry.solver];
  claim.verdict = verdict_of(own == study.points, 2 * own > study.points);
  claim.number = fmt::format("{} of {} points", own, study.points);
  std::vector<std::string> words;
  for (const std::string& solver : study.solvers) {
    if (first[solver] > 0) words.push_back(fmt::format("{} at {}", solver, first[solver]));
  }
  claim.evidence = {
      fmt::format("The smallest error, averaged over the runs: {} of {} points.", listed(words), study.points)};
  return {claim};
}

Claims inside_limits(const Case& of) {
  if (!of.has_solver()) return {};
  const std::vector<SolverCounts> all = counts(of.study());
  const SolverCounts& count = *std::ranges::find(all, of.entry.solver, &SolverCounts::solver);
  Claim claim = of.begun();
  claim.verdict = verdict_of(count.outside_limits == 0);
  claim.number = fmt::format("{} of {} outside", count.outside_limits, count.solves);
  claim.evidence = {count.outside_limits == 0
                        ? fmt::format("All {} are.", count.solves)
                        : fmt::format("{} of {} are not; the worst joint is outside by {}.", count.outside_limits,
                                      count.solves, degrees_words(count.worst_outside_deg))};
  return {claim};
}

Claims has_effect(const Case& of) {
  const JudgedStudy* const without = of.companion();
  const std::string& solver = of.entry.solver;
  if (without == nullptr || !of.has_solver()) return {};
  const Metric metric = of.entry.metrics.front();
  const auto means_in = [&](const StudyResults& study, const std::string& label) {
    const std::vector<Sample> all = samples(study, metric);
    const auto own = std::ranges::find(all, label, &Sample::solver);
    return own == all.end() ? GroupSummary() : summarise(own->values);
  };
  Claim claim = of.begun();
  std::vector<Verdict> verdicts;
  for (const std::string& label : of.entry.own()) {
    std::size_t shared = 0, changed = 0;
    for (const Solve& solve : solves_of(of.study(), solver)) {
      const Solve* const other = solve_at(solves_of(*without, label), {solve.run, solve.point});
      if (other == nullptr) continue;
      ++shared;
      changed += has_same_answer(solve, *other) ? 0 : 1;
    }
    if (shared == 0) return {};
    if (changed == 0) {
      verdicts.push_back(Verdict::fails);
      claim.evidence.push_back(fmt::format("{} all {} answers are the same to the last bit.", of.entry.note, shared));
      continue;
    }
    const GroupSummary with = means_in(of.study(), solver), other = means_in(*without, label);
    const Finding found = judge(with, other, info_of(metric).better, of.study().plan);
    PairCounts one;
    one.add(found.relation);
    verdicts.push_back(verdict_on(one));
    claim.number = fmt::format("mean {}, {} {}", with_unit(with.mean, metric), label, number_of(other.mean, metric));
    claim.evidence.push_back(fmt::format("{}: {} {}, {} of {} {}{}.", title(metric), solver,
                                         with_unit(with.mean, metric), label, without->name,
                                         number_of(other.mean, metric), in_brackets(found.p)));
  }
  claim.verdict = verdict_on(verdicts);
  if (claim.number.empty()) claim.number = "no answer changes";
  return {claim};
}

namespace {

// The rule's claims about the study itself or the first companion that it can judge.
Claims first_judged(const Case& of, const std::function<Claims(const StudyResults&)>& rule) {
  Claims claims = rule(of.study());
  for (const StudyResults& companion : of.reported.companions) {
    if (claims.empty()) claims = rule(companion);
  }
  return claims;
}

// Holds the times of the claim's solvers, and the printed ones, against its limit.
Claims held_against_limit(const Case& of, const StudyResults& study) {
  if (!std::isfinite(tolerance_cm(study))) return {};
  const ClaimEntry& entry = of.entry;
  const double limit = entry.limit_ms;
  const std::vector<TimeAssessment> all = assess_times(study, limit);
  std::vector<Verdict> here, in_print;
  std::vector<std::string> list, printed_list;
  Claim claim = of.begun();
  for (const auto& [solver, printed, digits] : printed_times(study.facts.published, entry.table, entry.row)) {
    const auto ours = std::ranges::find(all, solver, &TimeAssessment::solver);
    if (std::ranges::count(entry.solvers, solver) == 0 || ours == all.end() || ours->solves == 0) continue;
    const double median = ours->time_ms.median;
    here.push_back(verdict_of(ours->in_time == ours->solves, median < limit));
    in_print.push_back(verdict_of(printed.max < limit, printed.mean < limit));
    list.push_back(fmt::format("{}: {} of {} targets reach {} cm in less than {} ms, slowest {} ms, median {} ms",
                               solver, ours->in_time, ours->solves, tolerance_cm(study), limit,
                               short_number(ours->time_ms.max), short_number(median)));
    printed_list.push_back(fmt::format("{} mean {} ms, maximum {} ms", solver, printed.mean, printed.max));
    claim.number = fmt::format("{} of {} in time", ours->in_time, ours->solves);
  }
  if (here.empty()) return {};
  if (times_are_comparable(study)) {
    claim.verdict = verdict_on(here);
    claim.evidence = {fmt::format("Here, in C++: {}.", fmt::join(list, "; "))};
  } else {
    claim.number = times_not_judged;
    claim.evidence = {fmt::format("Not judged, because {} (see the warnings).", times_not_judged)};
  }
  claim.printed = verdict_on(in_print);
  claim.evidence.push_back(
      fmt::format("Printed, in {} on another machine: {}.", of.file.implementation, fmt::join(printed_list, "; ")));
  return {claim};
}

// The largest distance of a study's target from the base [cm]; 0 if no target is known.
double farthest_target_cm(const StudyResults& study) {
  double farthest = 0;
  for (const Solve& solve : study.solves) {
    const std::span<const double> at = problem_of(study, solve).target_position_m;
    const double distance = at.size() == 3 ? std::hypot(100 * at[0], 100 * at[1], 100 * at[2]) : not_defined;
    if (std::isfinite(distance)) farthest = std::max(farthest, distance);
  }
  return farthest;
}

}  // namespace

std::vector<TimeAssessment> assess_times(const StudyResults& measured, double limit_ms) {
  constexpr double ms_in_s = 1000;
  const StudyResults study = at_median_speed(measured);
  constexpr double verifier_rounding_cm = 1e-7;
  const double most = tolerance_cm(study) + verifier_rounding_cm;
  std::vector<TimeAssessment> rows;
  for (const std::string& solver : study.solvers) {
    TimeAssessment& row = rows.emplace_back(TimeAssessment{.solver = solver});
    std::vector<double> times, iterations, evaluations;
    for (const Solve& solve : solves_of(study, solver)) {
      times.push_back(ms_in_s * seconds_of(study, solve));
      iterations.push_back(static_cast<double>(solve.iterations));
      evaluations.push_back(static_cast<double>(solve.evaluations));
      const bool is_reached = solve.position_error_cm <= most;  // never by an answer that is not finite
      row.never_reached += is_reached ? 0 : 1;
      row.in_time += is_reached && times.back() < limit_ms ? 1 : 0;
    }
    row.solves = static_cast<int>(times.size());
    row.time_ms = describe(times);
    row.iterations_median = describe(iterations).median;
    row.evaluations_median = describe(evaluations).median;
  }
  return rows;
}

Claims in_time(const Case& of) {
  return first_judged(of, [&](const StudyResults& study) { return held_against_limit(of, study); });
}

Claims ratios_of_times(const Case& of) {
  const ClaimEntry& entry = of.entry;
  const bool is_of_means = entry.row.empty();
  const auto rule = [&](const StudyResults& study) -> Claims {
    std::map<std::string, double> here;  // medians, which one slow solve does not move
    if (is_of_means) {
      for (const Sample& each : samples(study, Metric::seconds)) here[each.solver] = describe(each.values).median;
    } else {
      for (const TimeAssessment& each : assess_times(study, entry.limit_ms)) here[each.solver] = each.time_ms.median;
    }
    const std::vector<PrintedRow> printed = is_of_means ? printed_rows(of.file, study, Metric::seconds)
                                                        : printed_times(study.facts.published, entry.table, entry.row);
    const auto base = std::ranges::find(printed, entry.solver, &PrintedRow::algorithm);
    if (base == printed.end() || !here.contains(entry.solver)) return {};
    Claim claim = of.begun();
    std::vector<std::string> ratios;
    for (const std::string& solver : entry.solvers) {
      const auto row = std::ranges::find(printed, solver, &PrintedRow::algorithm);
      const double ratio = here.contains(solver) ? here[solver] / here[entry.solver] : not_defined;
      if (row == printed.end() || !std::isfinite(ratio)) continue;
      ratios.push_back(fmt::format("{} {} times {}, printed {}", solver, short_number(ratio), entry.solver,
                                   short_number(row->printed.median / base->printed.median)));
    }
    if (ratios.empty()) return {};
    claim.verdict = Verdict::incomparable;
    claim.number = times_are_comparable(study) ? ratios.front() : std::string();
    claim.evidence = {fmt::format("The printed times are of {}, ours of C++.", of.file.implementation),
                      times_are_comparable(study)
                          ? fmt::format("Median times: {}.", fmt::join(ratios, "; "))
                          : fmt::format("No ratios, because {} (see the warnings).", times_not_judged)};
    return {claim};
  };
  return is_of_means ? rule(of.study()) : first_judged(of, rule);
}

Claims rounding_level(const Case& of) {
  constexpr double step = std::numeric_limits<double>::epsilon(), order = 10;
  return first_judged(of, [&](const StudyResults& study) -> Claims {
    const CsvTable table = printed_table(study.facts.published, of.entry.table);
    if (study.facts.path != of.entry.path || study.solves.empty() || table.rows.empty()) return {};
    std::vector<double> printed, ours;
    for (std::size_t row = 0; row < table.rows.size(); ++row) printed.push_back(table.number(row, "error_cm"));
    for (const Solve& solve : solves_of(study, study.solvers.front())) ours.push_back(solve.position_error_cm);
    if (ours.empty()) return {};
    const double farthest_cm = farthest_target_cm(study), rounding = step * farthest_cm;
    Claim claim = of.begun();
    claim.verdict = verdict_of(mean(ours) <= order * rounding);
    claim.printed = verdict_of(mean(printed) <= order * rounding);
    claim.number = fmt::format("{} cm", short_number(mean(ours)));
    claim.evidence = {fmt::format("Mean error {} cm over {} points; printed {} cm.", short_number(mean(ours)),
                                  ours.size(), short_number(mean(printed))),
                      fmt::format("Rounding level: {} cm (2^-52 of {} cm, the farthest target) times at most {}.",
                                  short_number(rounding), short_number(farthest_cm), order)};
    return {claim};
  });
}

namespace {

bool is_solved_here(const Rate& rate) { return !std::isnan(rate.ours.value); }

// All rates of one arm belong to one number of iterations, which is not printed. So a rate depends on that number only
// if it can be the other's, too.
bool shares_iterations(const Rate& one, const Rate& other) {
  return one.first > 0 && (other.first == 0 || (one.first <= other.last && other.first <= one.last));
}

Claim rate_claim(const Case& of, const RatesOfArm& arm, const Rate& rate) {
  const auto others = [&](const Rate& other) { return is_solved_here(other) && other.solver != rate.solver; };
  const auto other = std::ranges::find_if(arm.rates, others);
  const bool has_other = other != arm.rates.end(), holds = rate.is_as_printed();
  const bool depends = !holds && rate.first > 0 && (!has_other || shares_iterations(rate, *other));
  const auto [estimate, low, high] = rate.ours;
  Claim claim = of.begun();
  claim.id = fmt::format("{}-{}-{}", of.entry.id, rate.solver, arm.arm);
  claim.statement =
      filled(of.entry.sentence,
             {{"solver", rate.solver}, {"arm", arm.arm}, {"share", fmt::format("{:.2f} %", 100 * rate.printed)}});
  claim.verdict = depends ? Verdict::depends : verdict_of(holds);
  claim.number = fmt::format("{:.1f} against {:.2f} %", 100 * estimate, 100 * rate.printed);
  claim.evidence = {fmt::format("Here {:.1f} % are solved in {} iterations ({} interval {:.1f} to {:.1f} %).",
                                100 * estimate, arm.iterations, percent(of.file.rates.level), 100 * low, 100 * high)};
  if (holds) return claim;
  if (rate.first > 0) {
    claim.evidence.push_back(fmt::format(
        "It is the printed share within {} to {} iterations{}", rate.first, rate.last,
        depends ? ". " + of.entry.note
                : fmt::format(", but the other rate on this arm takes {} to {}.", other->first, other->last)));
  }
  const auto reason = of.entry.reasons.find(fmt::format("{} on the {}", rate.solver, arm.arm));
  if (reason != of.entry.reasons.end()) claim.evidence.push_back(reason->second);
  return claim;
}

bool is_rival(const std::string& solver, const ClaimEntry& entry) {
  return entry.against.empty() ? solver != entry.solver : solver == entry.against;
}

// The verdict of the printed table on all of its arms, also those without solves here.
Verdict printed_more(const Case& of) {
  const RatesPlan& plan = of.file.rates;
  const CsvTable table = printed_table(plan.paper, plan.table);
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const double own = table.number(row, plan.columns.at(of.entry.solver));
    for (const auto& [solver, column] : plan.columns) {
      if (is_rival(solver, of.entry) && !(own > table.number(row, column))) return Verdict::fails;
    }
  }
  return Verdict::holds;
}

}  // namespace

Claims rate_as_printed(const Case& of) {
  Claims claims;
  for (const RatesOfArm& arm : solve_rates(of.reported, of.file.rates)) {
    for (const Rate& rate : arm.rates) {
      if (is_solved_here(rate)) claims.push_back(rate_claim(of, arm, rate));
    }
  }
  return claims;
}

Claims solves_more(const Case& of) {
  const std::string& solver = of.entry.solver;
  Claim claim = of.begun();
  claim.printed = printed_more(of);
  std::vector<std::string> more, open, fewer;
  const std::vector<RatesOfArm> arms = solve_rates(of.reported, of.file.rates);
  for (const RatesOfArm& arm : arms) {
    const auto own = std::ranges::find(arm.rates, solver, &Rate::solver);
    const Rate* rival = nullptr;  // that solves most
    for (const Rate& rate : arm.rates) {
      if (!is_rival(rate.solver, of.entry) || !is_solved_here(rate)) continue;
      if (rival == nullptr || rate.ours.value > rival->ours.value) rival = &rate;
    }
    if (rival == nullptr || own == arm.rates.end() || !is_solved_here(*own)) continue;
    const Relation relation = judge(arm.study->evidence(Metric::solved), solver, rival->solver).relation;
    auto& list = relation == Relation::better ? more : relation == Relation::worse ? fewer : open;
    list.push_back(fmt::format("{} ({} to {})", arm.arm, percent(rival->ours.value), percent(own->ours.value)));
  }
  if (more.empty() && open.empty() && fewer.empty()) {
    claim.verdict = Verdict::untested;
    claim.evidence = {fmt::format("{} is not among the solvers.", solver)};
    return {claim};
  }
  claim.verdict = !fewer.empty() ? Verdict::fails : !open.empty() ? Verdict::undecided : Verdict::holds;
  claim.number = fmt::format("on {} of {} arms", more.size(), arms.size());
  for (const auto& [words, list] :
       {std::pair("More are solved", more), std::pair("Not decided", open), std::pair("Fewer are solved", fewer)}) {
    if (!list.empty()) claim.evidence.push_back(fmt::format("{}: {}.", words, fmt::join(list, ", ")));
  }
  return {claim};
}

}  // namespace ikbench::claims
