#include "analysis/claims/rules_of_solves.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <span>
#include <string>

#include "analysis/claims/times.hpp"
#include "analysis/figures/figure_parts.hpp"
#include "analysis/inference/comparable.hpp"
#include "analysis/inference/design.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/assessment_words.hpp"

namespace ikbench::claims {

using namespace results;
using namespace statistics;
using namespace inference;
using namespace report;

Claims least_at_each_point(const Case& of) {
  const StudyResults& study = of.study();
  if (!of.has_solver()) return {};
  std::map<std::string, int> first;  // number of points
  std::vector<std::vector<double>> means;
  for (const std::string& solver : study.solvers) {
    means.push_back(figures::averages_by_point(study, solver, of.entry.metrics.front()));
  }
  const auto points = static_cast<std::size_t>(study.points);
  for (std::size_t point = 0; point < points; ++point) {
    std::vector<std::string> least;
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t s = 0; s < means.size(); ++s) {
      const double mean = point < means[s].size() ? means[s][point] : not_defined;
      if (mean < smallest) least.clear();
      if (mean <= smallest) least.push_back(study.solvers[s]);
      if (mean < smallest) smallest = mean;
    }
    if (least.size() == 1) ++first[least.front()];  // a tie counts for nobody
  }
  Claim claim = of.begun();
  const int own = first[of.entry.solver];
  claim.verdict = own == study.points ? Verdict::holds : 2 * own > study.points ? Verdict::in_part : Verdict::fails;
  claim.number = fmt::format("{} of {} points", own, study.points);
  std::vector<std::string> words;
  for (const std::string& solver : study.solvers) {
    if (first[solver] > 0) words.push_back(fmt::format("{} at {}", solver, first[solver]));
  }
  claim.evidence = {fmt::format("The smallest error, averaged over the runs: {} of {} points.", listed(words), points)};
  return {claim};
}

Claims inside_limits(const Case& of) {
  if (!of.has_solver()) return {};
  const std::vector<SolverCounts> all = counts(of.study());
  const SolverCounts& count = *std::ranges::find(all, of.entry.solver, &SolverCounts::solver);
  Claim claim = of.begun();
  claim.verdict = count.outside_limits == 0 ? Verdict::holds : Verdict::fails;
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
  std::size_t shared = 0, changed = 0;
  for (const Solve& solve : solves_of(of.study(), solver)) {
    const Solve* const other = solve_at(solves_of(*without, solver), {solve.run, solve.point});
    if (other == nullptr) continue;
    ++shared;
    changed += has_same_answer(solve, *other) ? 0 : 1;
  }
  if (shared == 0) return {};
  Claim claim = of.begun();
  claim.number = fmt::format("{} of {} answers change", changed, shared);
  if (changed == 0) {
    claim.verdict = Verdict::fails;
    claim.evidence = {fmt::format("All {} answers are the same to the last bit {}", shared, of.entry.note)};
    return {claim};
  }
  const Metric metric = of.entry.metrics.front();
  std::array<GroupSummary, 2> means;
  for (std::size_t i = 0; i < means.size(); ++i) {
    for (const Sample& sample : samples(i == 0 ? of.study() : *without, metric)) {
      if (sample.solver == solver) means[i] = summarise(sample.values);
    }
  }
  const Finding found = judge(means[0], means[1], info_of(metric).better, of.study().plan);
  PairCounts one;
  one.add(found.relation);
  claim.verdict = verdict_on(one);
  claim.evidence = {
      fmt::format("{} of {} answers change without it.", changed, shared),
      fmt::format("{}: {} with, {} without{}.", inference::capitalised(info_of(metric).name),
                  with_unit(means[0].mean, metric), number_of(means[1].mean, metric), in_brackets(found.p))};
  return {claim};
}

Claims singularities(const Case& of) {
  if (!of.has_solver()) return {};
  Claim claim = of.begun();
  claim.verdict = Verdict::untested;
  claim.table = "";
  claim.evidence = {of.entry.decides};
  const SolverFacts& facts = solver_facts(of.study(), of.entry.solver);
  if (facts.joints.size() != of.entry.joints.size()) return {claim};
  for (std::size_t joint = 0; joint < facts.joints.size(); ++joint) {
    const auto& [answers, near, nearest_deg] = facts.joints[joint];
    if (of.entry.joints[joint].empty()) continue;
    claim.evidence.push_back(fmt::format("{} of {} answers are within {} deg of {} (the nearest: {} deg).", near,
                                         answers, StraightJoint::near_deg, of.entry.joints[joint],
                                         short_number(nearest_deg)));
  }
  return {claim};
}

namespace {

// The rule's claims about the study itself or the first companion that it can judge.
Claims first_of(const Case& of, const std::function<Claims(const StudyResults&)>& rule) {
  Claims claims = rule(of.study());
  for (const StudyResults& companion : of.reported.companions) {
    if (claims.empty()) claims = rule(companion);
  }
  return claims;
}

// A study's times of a solver in a printed table of times.
struct TimedRow {
  PrintedTime printed;
  TimeAssessment ours;
};
std::vector<TimedRow> timed_rows(const StudyResults& study, const ClaimEntry& entry) {
  std::vector<TimedRow> result;
  if (!std::isfinite(tolerance_cm(study))) return result;
  const std::vector<TimeAssessment> all = assess_times(study, entry.limit_ms);
  for (const PrintedTime& printed : printed_times(study.facts.published, entry.table, entry.row)) {
    const auto ours = std::ranges::find(all, printed.solver, &TimeAssessment::solver);
    const bool is_asked = std::ranges::count(entry.solvers, printed.solver) > 0;
    if (is_asked && ours != all.end() && ours->solves > 0) result.push_back({printed, *ours});
  }
  return result;
}

// " Printed, in MATLAB on another machine: ..."
std::string printed_elsewhere(const Case& of, const std::string& words) {
  return fmt::format("Printed, in {} on another machine: {}.", of.file.implementation, words);
}

std::string not_judged() { return fmt::format("Not judged, because {} (see the warnings).", times_not_judged); }

Verdict within(bool always, bool on_average) {
  return always ? Verdict::holds : on_average ? Verdict::in_part : Verdict::fails;
}

}  // namespace

Claims in_time(const Case& of) {
  return first_of(of, [&](const StudyResults& study) -> Claims {
    const std::vector<TimedRow> rows = timed_rows(study, of.entry);
    if (rows.empty()) return {};
    const auto& [printed, ours] = rows.front();
    const double limit_ms = of.entry.limit_ms;
    Claim claim = of.begun();
    claim.evidence = {not_judged()};
    claim.number = times_not_judged;
    if (times_are_comparable(study)) {
      claim.verdict = within(ours.in_time == ours.solves, ours.time_ms.median < limit_ms);
      claim.number = fmt::format("{} of {} in time", ours.in_time, ours.solves);
      claim.evidence = {
          fmt::format("Here, in C++: {} of {} targets reach {} cm in less than {} ms; median {} ms, slowest {} ms.",
                      ours.in_time, ours.solves, tolerance_cm(study), limit_ms, short_number(ours.time_ms.median),
                      short_number(ours.time_ms.max))};
    }
    claim.evidence.push_back(printed_elsewhere(of, printed_words(printed, limit_ms)));
    claim.printed = within(printed.ms.max < limit_ms, printed.ms.mean < limit_ms);
    return {claim};
  });
}

Claims too_slow(const Case& of) {
  return first_of(of, [&](const StudyResults& study) -> Claims {
    const std::vector<TimedRow> rows = timed_rows(study, of.entry);
    if (rows.empty()) return {};
    std::vector<Verdict> here, in_print;
    std::vector<std::string> list, printed_list;
    for (const auto& [printed, ours] : rows) {
      here.push_back(within(ours.time_ms.median >= of.entry.limit_ms, false));
      in_print.push_back(within(printed.ms.mean >= of.entry.limit_ms, false));
      list.push_back(fmt::format("{} {} ms", ours.solver, short_number(ours.time_ms.median)));
      printed_list.push_back(fmt::format("{} ms", short_number(printed.ms.mean)));
    }
    Claim claim = of.begun();
    claim.evidence = {not_judged()};
    claim.number = times_not_judged;
    if (times_are_comparable(study)) {
      claim.verdict = verdict_on(here);
      claim.evidence = {fmt::format("Here, in C++, median: {}.", fmt::join(list, ", "))};
      const TimeAssessment& last = rows.back().ours;
      claim.number = fmt::format("{} ms with {}", short_number(last.time_ms.median), last.solver);
    }
    claim.printed = verdict_on(in_print);
    claim.evidence.push_back(printed_elsewhere(of, fmt::format("{}", fmt::join(printed_list, ", "))));
    return {claim};
  });
}

double farthest_target_cm(const StudyResults& study) {
  double farthest = 0;
  for (const Solve& solve : study.solves) {
    const std::span<const double> at = problem_of(study, solve).target_position_m;
    const double distance = at.size() == 3 ? std::hypot(100 * at[0], 100 * at[1], 100 * at[2]) : not_defined;
    if (std::isfinite(distance)) farthest = std::max(farthest, distance);
  }
  return farthest;
}

Claims rounding_level(const Case& of) {
  constexpr double step = std::numeric_limits<double>::epsilon(), order = 10;
  return first_of(of, [&](const StudyResults& study) -> Claims {
    const CsvTable table = printed_table(study.facts.published, of.entry.table);
    if (study.facts.path != of.entry.path || study.solves.empty() || table.rows.empty()) return {};
    std::vector<double> printed, ours;
    for (std::size_t row = 0; row < table.rows.size(); ++row) printed.push_back(table.number(row, "error_cm"));
    for (const Solve& solve : solves_of(study, study.solvers.front())) ours.push_back(solve.position_error_cm);
    if (ours.empty()) return {};
    const double farthest_cm = farthest_target_cm(study), rounding = step * farthest_cm;
    Claim claim = of.begun();
    claim.verdict = within(mean(ours) <= order * rounding, false);
    claim.printed = within(mean(printed) <= order * rounding, false);
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
  claim.verdict = holds ? Verdict::holds : depends ? Verdict::depends : Verdict::fails;
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

namespace {

// The compared solver that solves most; null if none is solved here.
const Rate* best_rival(const RatesOfArm& arm, const ClaimEntry& entry) {
  const Rate* best = nullptr;
  for (const Rate& rate : arm.rates) {
    const bool is_rival = entry.against.empty() ? rate.solver != entry.solver : rate.solver == entry.against;
    if (!is_rival || !is_solved_here(rate)) continue;
    if (best == nullptr || rate.ours.value > best->ours.value) best = &rate;
  }
  return best;
}

// The verdict of the printed table on all of its arms, also those without solves here.
Verdict printed_more(const Case& of) {
  const RatesPlan& plan = of.file.rates;
  const results::CsvTable table = printed_table(plan.paper, plan.table);
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const double own = table.number(row, plan.columns.at(of.entry.solver));
    for (const auto& [solver, column] : plan.columns) {
      const bool is_rival = of.entry.against.empty() ? solver != of.entry.solver : solver == of.entry.against;
      if (is_rival && !(own > table.number(row, column))) return Verdict::fails;
    }
  }
  return Verdict::holds;
}

}  // namespace

Claims solves_more(const Case& of) {
  const std::string& solver = of.entry.solver;
  Claim claim = of.begun();
  claim.printed = printed_more(of);
  std::vector<std::string> more, open, fewer;
  const std::vector<RatesOfArm> arms = solve_rates(of.reported, of.file.rates);
  for (const RatesOfArm& arm : arms) {
    const auto own = std::ranges::find(arm.rates, solver, &Rate::solver);
    const Rate* const rival = best_rival(arm, of.entry);
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
