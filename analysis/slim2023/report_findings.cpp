#include "analysis/slim2023/report_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "analysis/figures/figure_parts.hpp"
#include "analysis/inference/convergence.hpp"
#include "analysis/inference/definition.hpp"
#include "analysis/inference/judge.hpp"
#include "analysis/inference/ranking.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/provenance.hpp"
#include "analysis/slim2023/circle.hpp"
#include "analysis/slim2023/paper_tables.hpp"
#include "analysis/slim2023/published_numbers.hpp"
#include "analysis/slim2023/time_assessment.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "results/published.hpp"

namespace ikbench::slim2023 {

using namespace results;
using namespace statistics;
using namespace inference;
using namespace report;

namespace {

// A solver with observations here and a printed row.
struct Pair {
  std::string solver;
  Description ours;
  GroupSummary printed;
};

double our_mean(const Pair& pair) { return pair.ours.mean; }
double printed_mean(const Pair& pair) { return pair.printed.mean; }

std::vector<Standing> standings(const std::vector<Pair>& pairs, double (*mean_of)(const Pair&)) {
  std::vector<Standing> result;
  for (const Pair& pair : pairs) result.push_back({pair.solver, mean_of(pair)});
  return ranked(std::move(result));
}

// In the printed order, the smallest first.
std::vector<Pair> pairs(const StudyResults& study, const std::vector<Comparison>& rows, Metric metric) {
  std::vector<Pair> result;
  for (const Comparison& row : rows) {
    const std::optional<PrintedRow> printed = printed_row(study, row.solver, metric);
    if (row.metric != metric || !printed || row.ours.n == 0) continue;
    result.push_back({row.solver, row.ours, printed->summary});
  }
  std::ranges::stable_sort(result, {}, printed_mean);
  return result;
}

GroupSummary summary_of(const Description& of) { return {.mean = of.mean, .std = of.std, .n = of.n}; }

// Whether one is smaller than another, since two means always differ.
struct Smaller {
  Verdict verdict;
  double p;  // not defined where there is no test
};
Smaller smaller(const Judgement& found) {
  return {found.answer == Answer::better  ? Verdict::holds
          : found.answer == Answer::worse ? Verdict::does_not_hold
                                          : Verdict::undecided,
          found.p};
}

// What the paper printed of those solvers.
Evidence printed_evidence(const std::vector<Pair>& pairs, const AnalysisPlan& plan) {
  Summaries printed;
  for (const Pair& pair : pairs) printed.groups.push_back({pair.solver, pair.printed});
  return evidence(printed, feasible(plan, printed));
}

// A claim about several holds as far as it does for the least certain of them.
void weaken(Smaller& claim, const Smaller& by) {
  claim.verdict = std::max(claim.verdict, by.verdict);
  if (std::isfinite(by.p)) claim.p = std::isfinite(claim.p) ? std::max(claim.p, by.p) : by.p;
}

// " (p = 0.01)"
std::string in_brackets(double p) { return std::isfinite(p) ? fmt::format(" (p = {})", rounded_number(p, 3)) : ""; }

// Against each of the others.
std::string at_most(double p) {
  return std::isfinite(p) ? fmt::format(" (p at most {} against each other solver)", rounded_number(p, 2)) : "";
}

std::string how_tested(const Evidence& here, const Evidence& printed) {
  const std::string_view test = pair_test_words(here), other = pair_test_words(printed);
  if (here.plan.unit == Unit::point)
    return fmt::format(" Points of one run depend on each other: no test here; printed, p by {}.", other);
  const std::string of_printed = test == other ? "" : fmt::format("; printed, by {}", other);
  return fmt::format(" p by {}, for all pairs together, here over run means{}.", test, of_printed);
}

// What is ranked: "Accuracy", in "cm".
struct Ranked {
  Metric metric;
  std::string_view name;
  std::string_view unit;
};

// How our ranking stands to the printed one: holds when every pair stands in the same order, in part when the first is
// the same or most of the pairs that are not tied stand. Times that are not comparable are not ranked.
struct Held {
  Verdict verdict = Verdict::undecided;
  std::string evidence;
};
Held held_against_printed(const StudyResults& study, const std::vector<Pair>& pairs, const Ranked& what) {
  if (what.metric == Metric::seconds && !times_are_comparable(study))
    return {.evidence = fmt::format("Here: not ranked, {} (see the warnings).", times_not_judged)};
  const std::vector<Standing> ours = standings(pairs, our_mean), printed = standings(pairs, printed_mean);
  const PairOrder order = compare_pairs(printed, ours);
  const bool same_first = first_of(ours) == first_of(printed);
  std::string list;
  for (const Standing& standing : ours) {
    list +=
        fmt::format("{}{} {} {}", list.empty() ? "" : ", ", standing.solver, short_number(standing.mean), what.unit);
  }
  return {.verdict = order.tied == order.pairs                                 ? Verdict::undecided
                     : order.same == order.pairs                               ? Verdict::holds
                     : same_first || 2 * order.same > order.pairs - order.tied ? Verdict::in_part
                                                                               : Verdict::does_not_hold,
          .evidence = fmt::format("Here: {}. {}; first is {}{}.", list, printed_order_words(order), first_words(ours),
                                  same_first ? ", as printed" : "")};
}

// The printed ranking. On the printed numbers it holds when all pairs differ, in part when the first two do.
std::optional<Finding> ranking(const StudyResults& study, const std::vector<Comparison>& rows, const Ranked& what) {
  const std::vector<Pair> printed = pairs(study, rows, what.metric);
  if (printed.size() < 2) return std::nullopt;
  const Evidence tested = printed_evidence(printed, study.plan);
  int all = 0, differ = 0;
  for (std::size_t i = 0; i < printed.size(); ++i) {
    for (std::size_t j = i + 1; j < printed.size(); ++j) {
      ++all;
      if (judge(tested, printed[i].solver, printed[j].solver).answer == Answer::better) ++differ;
    }
  }
  const Smaller first_two = smaller(judge(tested, printed[0].solver, printed[1].solver));
  const Held here = held_against_printed(study, printed, what);
  return Finding{
      .claim = fmt::format("{}: {}", what.name, order_words(standings(printed, printed_mean))),
      .verdict = here.verdict,
      .evidence = fmt::format("{} Printed: {} of {} pairs differ by {}, {} and {} {}{}.", here.evidence, differ, all,
                              pair_test_words(tested), printed[0].solver, printed[1].solver,
                              first_two.verdict == Verdict::holds ? "among them" : "do not", in_brackets(first_two.p)),
      .table = "table-3",
      .printed = differ == all                         ? Verdict::holds
                 : first_two.verdict == Verdict::holds ? Verdict::in_part
                                                       : Verdict::undecided};
}

std::optional<Finding> computing_time(const StudyResults& study, const std::vector<Comparison>& rows) {
  std::optional<Finding> finding = ranking(study, rows, {Metric::seconds, "Computing time", "s"});
  if (finding) finding->evidence += " The implementation decides it: the paper timed MATLAB, here it is C++.";
  return finding;
}

std::optional<Finding> most_accurate(const StudyResults& study, const std::vector<Comparison>& rows, Unit unit) {
  std::vector<Pair> all = pairs(study, rows, Metric::position_error_cm);
  if (all.size() < 2 || all[0].solver != time_reference) return std::nullopt;
  const Pair first = all[0], printed_second = all[1];
  const std::vector<Standing> ours = standings(all, our_mean);
  const Standing& other = ours[0].solver == first.solver ? ours[1] : ours[0];
  const Evidence found = evidence_of(study, Metric::position_error_cm, unit);
  const Evidence found_printed = printed_evidence(all, study.plan);
  Smaller here{Verdict::holds, not_defined}, printed{Verdict::holds, not_defined};
  for (const Pair& each : all) {
    if (each.solver == first.solver) continue;
    weaken(here, smaller(judge(found, first.solver, each.solver)));
    weaken(printed, smaller(judge(found_printed, first.solver, each.solver)));
  }
  return Finding{.claim = fmt::format("{} is the most accurate", first.solver),
                 .verdict = here.verdict,
                 .evidence = fmt::format(
                     "Mean position error {} cm; {} comes to {} cm, {} times as much{}. Printed: {} cm; {} {} "
                     "cm{}.{} {}",
                     short_number(first.ours.mean), other.solver, short_number(other.mean),
                     short_number(other.mean / first.ours.mean), at_most(here.p), short_number(first.printed.mean),
                     printed_second.solver, short_number(printed_second.printed.mean), at_most(printed.p),
                     how_tested(found, found_printed), closest_point_by_point(study)),
                 .table = "table-3",
                 .printed = printed.verdict};
}

// The paper's solver moves the joints less than those others: as much as is true of each of them.
struct Others {
  std::vector<Pair> solvers;
  std::string words;
  const Evidence& here;
  const Evidence& printed;
};
Finding moves_less(const Pair& reference, const Others& of) {
  Verdict here = Verdict::holds, printed = Verdict::holds;
  std::string our_list, printed_list;
  for (const Pair& other : of.solvers) {
    const Smaller ours = smaller(judge(of.here, reference.solver, other.solver));
    const Smaller theirs = smaller(judge(of.printed, reference.solver, other.solver));
    here = std::max(here, ours.verdict);
    printed = std::max(printed, theirs.verdict);
    our_list += fmt::format(", {} by {}{}", other.solver, short_number(other.ours.mean), in_brackets(ours.p));
    printed_list += fmt::format(", {} {}{}", other.solver, short_number(other.printed.mean), in_brackets(theirs.p));
  }
  return {.claim = fmt::format("{} moves the joints less than {}", reference.solver, of.words),
          .verdict = here,
          .evidence = fmt::format("{} moves the joints by {} deg a point{}. Printed: {} {}{}.{}", reference.solver,
                                  short_number(reference.ours.mean), our_list, reference.solver,
                                  short_number(reference.printed.mean), printed_list, how_tested(of.here, of.printed)),
          .table = "table-3",
          .printed = printed};
}

std::vector<Finding> variation(const StudyResults& study, const std::vector<Comparison>& rows, Unit unit) {
  const std::vector<Pair> all = pairs(study, rows, Metric::variation_deg);
  if (all.size() < 2 || all.front().solver != time_reference) return {};
  const Evidence here = evidence_of(study, Metric::variation_deg, unit);
  const Evidence printed = printed_evidence(all, study.plan);
  std::vector<Finding> result{moves_less(all[0], {{all[1]}, all[1].solver, here, printed})};
  if (all.size() > 2)
    result.push_back(moves_less(all[0], {{all.begin() + 2, all.end()}, "the other solvers", here, printed}));
  return result;
}

// As many of the metrics as are judged; times that are not comparable are not.
std::optional<Finding> solvers_differ(const StudyResults& study, Unit unit) {
  std::string list;
  int alike = 0, differ = 0, printed_alike = 0;
  for (const Metric metric : paper_metrics) {
    const std::optional<AnovaTable> printed = comparable_printed_anova(study, metric, unit);
    if (!printed) return std::nullopt;
    if (!is_significant(printed->p, study.plan)) ++printed_alike;
    list += fmt::format("{}{} ", list.empty() ? "" : "; ", name_of(metric));
    if (metric == Metric::seconds && !times_are_comparable(study)) {
      list += fmt::format("not tested, {} (see the warnings)", times_not_judged);
      continue;
    }
    const AnovaTable table = anova(study, metric, unit).table;
    if (!std::isfinite(table.p)) return std::nullopt;
    ++(is_significant(table.p, study.plan) ? differ : alike);
    list += fmt::format("F = {}, p = {}", short_number(table.F), rounded_number(table.p, 2));
  }
  const auto verdict_of = [](int number_alike, int number_differing) {
    if (number_differing == static_cast<int>(paper_metrics.size())) return Verdict::holds;
    if (number_differing > 0) return Verdict::in_part;
    return number_alike == static_cast<int>(paper_metrics.size()) ? Verdict::does_not_hold : Verdict::undecided;
  };
  return Finding{.claim = "The solvers differ in error, variation and time (ANOVA)",
                 .verdict = verdict_of(alike, differ),
                 .evidence = list + ".",
                 .table = "table-4",
                 .printed = verdict_of(printed_alike, static_cast<int>(paper_metrics.size()) - printed_alike)};
}

std::optional<Finding> inside_limits(const StudyResults& study) {
  for (const SolverCounts& count : counts(study)) {
    if (count.solver != time_reference || count.solves == 0) continue;
    return Finding{.claim = fmt::format("{}'s answers are inside the joint limits (Eq. 4)", count.solver),
                   .verdict = count.outside_limits == 0 ? Verdict::holds : Verdict::does_not_hold,
                   .evidence = count.outside_limits == 0
                                   ? fmt::format("All of {} are.", count.solves)
                                   : fmt::format("{} of {} are not, the worst joint by {} deg.", count.outside_limits,
                                                 count.solves, short_number(count.worst_outside_deg)),
                   .table = "status"};
  }
  return std::nullopt;
}

bool has_table(const StudyResults& study, std::string_view name) {
  const auto tables = published::tables(study.published);
  return std::ranges::find(tables, name) != tables.end();
}

// Table 7's first row, as time_assessment judges it.
std::optional<Finding> real_time(const StudyResults& study) {
  if (!has_table(study, "table-7") || !std::isfinite(tolerance_cm(study))) return std::nullopt;
  const PrintedTime printed = printed_table_7(study.published).front();
  const std::vector<TimeAssessment> rows = assess_times(study);
  const auto row = std::ranges::find(rows, fmt::format("{} bats", printed.bats), &TimeAssessment::solver);
  if (row == rows.end() || row->solves == 0) return std::nullopt;
  const bool comparable = times_are_comparable(study);
  const std::string here =
      comparable ? fmt::format(
                       "This program on the machine of the run, not MATLAB: {} of {} targets within {} cm in "
                       "less than {} ms; mean {} ms, the slowest {} ms.",
                       row->in_time, row->solves, tolerance_cm(study), real_time_ms, short_number(row->time_ms.mean),
                       short_number(row->time_ms.max))
                 : fmt::format("Not judged: {} (see the warnings).", times_not_judged);
  return Finding{
      .claim = fmt::format("With {} bats IK-BA answers in real time", printed.bats),
      .verdict = !comparable                        ? Verdict::undecided
                 : row->in_time == row->solves      ? Verdict::holds
                 : row->time_ms.max >= real_time_ms ? Verdict::does_not_hold
                                                    : Verdict::in_part,
      .evidence = fmt::format("{} Printed, of MATLAB on another machine, {}.", here, printed_real_time(printed)),
      .table = "table-7",
      .printed = printed.max_ms < real_time_ms    ? Verdict::holds
                 : printed.mean_ms < real_time_ms ? Verdict::in_part
                                                  : Verdict::does_not_hold};
}

// Table 8: errors of the order of rounding, which is a double's step times the length that is computed.
std::optional<Finding> circle(const StudyResults& study) {
  constexpr double step = std::numeric_limits<double>::epsilon(), order = 10, cm_in_m = 100;
  const std::vector<PrintedPosture> postures = printed_table_8(study.published);
  if (!is_circle(study) || study.solves.empty() || postures.empty()) return std::nullopt;
  std::vector<double> printed, ours;
  double farthest_cm = 0;
  for (const PrintedPosture& posture : postures) printed.push_back(posture.error_cm);
  for (const SolveRecord& solve : study.solves) {
    if (solve.solver != study.solvers.front()) continue;
    ours.push_back(solve.position_error_cm);
    double square = 0;
    for (const double coordinate : solve.target_position_m) square += coordinate * coordinate;
    farthest_cm = std::max(farthest_cm, cm_in_m * std::sqrt(square));
  }
  if (ours.empty()) return std::nullopt;
  const double rounding = step * farthest_cm;
  const auto verdict_of = [&](double error) {
    return error <= order * rounding ? Verdict::holds : Verdict::does_not_hold;
  };
  return Finding{.claim = "IK-BA leads the Dobot Magician along a circle to rounding error",
                 .verdict = verdict_of(mean(ours)),
                 .evidence = fmt::format("Mean error {} cm over {} points; printed {} cm. Rounding is {} cm (2^-52 of "
                                         "{} cm, the farthest target); up to {} times that counts as rounding.",
                                         short_number(mean(ours)), ours.size(), short_number(mean(printed)),
                                         short_number(rounding), short_number(farthest_cm), order),
                 .table = "table-8",
                 .printed = verdict_of(mean(printed))};
}

// One solver of a study; none where it has no observations.
std::optional<Description> description(const StudyResults& study, std::string_view solver, Metric metric, Unit unit) {
  for (const Sample& sample : samples(study, metric, unit)) {
    if (sample.solver == solver && !sample.values.empty()) return describe(sample.values);
  }
  return std::nullopt;
}

// The study with limits enforced.
std::optional<Finding> accurate_inside_limits(const StudyResults& study, const StudyResults& limits, Unit unit) {
  const auto are_enforced = [](const StudyResults& of) {
    return Definition(of.definition).text("/limits") == "enforced";
  };
  if (!are_enforced(limits) || are_enforced(study) || !same_targets(study, limits)) return std::nullopt;
  const auto ours = description(limits, time_reference, Metric::position_error_cm, unit);
  const auto before = description(study, time_reference, Metric::position_error_cm, unit);
  std::optional<Description> best;
  std::vector<std::string> others;
  std::string best_solver, refused;
  for (const SolverCounts& count : counts(limits)) {
    refused += fmt::format("{}{} {} of {}", refused.empty() ? "" : ", ", count.solver, count.of(Status::refused),
                           count.solves);
    const auto other = description(limits, count.solver, Metric::position_error_cm, unit);
    if (count.solver == time_reference || !other) continue;
    others.push_back(count.solver);
    if (!std::isfinite(other->mean)) continue;
    if (best && best->mean <= other->mean) continue;
    best = other;
    best_solver = count.solver;
  }
  if (!ours || !before || !best) return std::nullopt;
  Smaller here{Verdict::holds, not_defined};
  const Evidence found = evidence_of(limits, Metric::position_error_cm, unit);
  for (const std::string& other : others) weaken(here, smaller(judge(found, time_reference, other)));
  return Finding{
      .claim = fmt::format("With the joint limits enforced {} stays the most accurate", time_reference),
      .verdict = here.verdict,
      .evidence = fmt::format("Mean position error {} cm ({} cm without); {} comes to {} cm, {} times as much{}.{} "
                              "Refused answers: {}.",
                              short_number(ours->mean), short_number(before->mean), best_solver,
                              short_number(best->mean), short_number(best->mean / ours->mean), at_most(here.p),
                              unit == Unit::run ? how_tested(found, found) : "", refused),
      .table = "limits"};
}

// A solver of the textbooks on the same targets, in error, variation and evaluations.
std::optional<Finding> better_than_classical(const StudyResults& study, const StudyResults& context, Unit unit) {
  constexpr std::string_view classical = "DLS";  // damped least squares
  constexpr std::array<Metric, 3> metrics{Metric::position_error_cm, Metric::variation_deg, Metric::evaluations};
  constexpr std::array<std::string_view, 3> words{"cm of mean position error", "deg of variation", "evaluations"};
  if (!same_targets(study, context)) return std::nullopt;
  int better = 0, worse = 0;
  std::string list, test;
  for (std::size_t i = 0; i < metrics.size(); ++i) {
    const auto ours = description(study, time_reference, metrics[i], unit);
    const auto other = description(context, classical, metrics[i], unit);
    if (!ours || !other) return std::nullopt;
    const MeanPair means{summary_of(*ours), summary_of(*other), info_of(metrics[i]).better};
    const Judgement found = unit == Unit::run ? judge(means, study.plan) : Judgement{};
    if (!found.test.empty()) test = found.test;
    Smaller here = smaller(found);
    if (info_of(metrics[i]).kind == Kind::count && ours->mean != other->mean) {  // counted, not measured
      here = {ours->mean < other->mean ? Verdict::holds : Verdict::does_not_hold, not_defined};
    }
    if (here.verdict == Verdict::holds) ++better;
    if (here.verdict == Verdict::does_not_hold) ++worse;
    list += fmt::format("{}{} against {} {}{}", list.empty() ? "" : ", ", short_number(ours->mean),
                        short_number(other->mean), words[i], in_brackets(here.p));
  }
  return Finding{.claim = fmt::format("{} is better than a classical solver (damped least squares)", time_reference),
                 .verdict = better == static_cast<int>(metrics.size()) ? Verdict::holds
                            : better > 0                               ? Verdict::in_part
                            : worse > 0                                ? Verdict::does_not_hold
                                                                       : Verdict::undecided,
                 .evidence = fmt::format("{} against {}, a point: {}.{}", time_reference, classical, list,
                                         test.empty() ? "" : fmt::format(" p by {} over run means.", test)),
                 .table = "perspective"};
}

}  // namespace

std::string_view name_of(Verdict verdict) {
  constexpr std::array<std::string_view, 4> names{"holds", "in part", "undecided", "does not hold"};
  return names[static_cast<std::size_t>(verdict)];
}

std::string tally(const std::vector<Finding>& findings) {
  const auto count = [&](Verdict verdict) { return std::ranges::count(findings, verdict, &Finding::verdict); };
  std::string text = fmt::format("Of {} findings {} hold here", findings.size(), count(Verdict::holds));
  if (count(Verdict::in_part) > 0) text += fmt::format(", {} in part", count(Verdict::in_part));
  if (count(Verdict::does_not_hold) > 0) text += fmt::format(", {} not", count(Verdict::does_not_hold));
  if (count(Verdict::undecided) > 0) text += fmt::format("; {} cannot be decided", count(Verdict::undecided));
  const auto is_printed = [](const Finding& finding) { return finding.printed.has_value(); };
  if (const auto printed = std::ranges::count_if(findings, is_printed); printed > 0) {
    text += fmt::format(". On the printed numbers {} of {} hold",
                        std::ranges::count(findings, Verdict::holds, &Finding::printed), printed);
  }
  return text + '.';
}

std::vector<Finding> findings(const StudyResults& study, const std::vector<StudyResults>& companions, Unit unit) {
  std::vector<Finding> result;
  const auto add = [&](std::optional<Finding> finding) {
    if (finding) result.push_back(std::move(*finding));
  };
  const std::vector<Comparison> rows = compare(study, unit);
  const auto is_printed = [](const Comparison& row) { return std::isfinite(row.paper_mean); };
  if (std::ranges::any_of(rows, is_printed)) {
    add(most_accurate(study, rows, unit));
    add(ranking(study, rows, {Metric::position_error_cm, "Accuracy", "cm"}));
    for (Finding& finding : variation(study, rows, unit)) result.push_back(std::move(finding));
    add(computing_time(study, rows));
    add(solvers_differ(study, unit));
    add(inside_limits(study));
    for (const StudyResults& companion : companions) {
      if (companion.name == study.name + "-limits") add(accurate_inside_limits(study, companion, unit));
      if (companion.name == study.name + "-context") add(better_than_classical(study, companion, unit));
    }
  }
  add(real_time(study));
  add(circle(study));
  for (const StudyResults& companion : companions) {
    add(real_time(companion));
    add(circle(companion));
  }
  return result;
}

}  // namespace ikbench::slim2023
