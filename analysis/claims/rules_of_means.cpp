#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "analysis/claims/rules.hpp"
#include "analysis/inference/comparable.hpp"
#include "analysis/inference/estimand.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/assessment_words.hpp"
#include "analysis/report/study_tables.hpp"
#include "analysis/statistics/equal_variances.hpp"
#include "analysis/statistics/quantile.hpp"

namespace ikbench::claims {

using namespace results;
using namespace statistics;
using namespace inference;
using namespace report;

namespace {

std::string not_judged_words(std::string_view what) {
  return fmt::format("{}, because {} (see the warnings)", what, times_not_judged);
}

double mean_of(const Evidence& evidence, const std::string& solver) {
  return group_named(evidence.groups, solver)->described.mean;
}

struct RankedSolver {
  std::string solver;
  double mean;
};

// Sorts by mean, the smallest first; those that are not finite come last.
std::vector<RankedSolver> ranked(std::vector<RankedSolver> solvers) {
  std::ranges::stable_sort(solvers, {}, [](const RankedSolver& each) {
    return std::isfinite(each.mean) ? each.mean : worse_than_every_number;
  });
  return solvers;
}

// The other solvers by their means, the smallest first.
std::vector<RankedSolver> rivals_of(const std::vector<std::string>& own, const Evidence& evidence) {
  std::vector<RankedSolver> rivals;
  for (const GroupEvidence& group : evidence.groups) {
    if (std::ranges::count(own, group.name) == 0) rivals.push_back({group.name, group.described.mean});
  }
  return ranked(std::move(rivals));
}

// Each solver against each rival; smaller is what is claimed.
PairCounts held_against(const Evidence& evidence, const std::vector<std::string>& own) {
  PairCounts counts;
  for (const std::string& solver : own) {
    for (const RankedSolver& rival : rivals_of(own, evidence)) {
      const Relation relation = judge(evidence, solver, rival.solver).relation;
      counts.add(evidence.better == Better::smaller ? relation : reversed(relation));
    }
  }
  return counts;
}

// "IK-BA 0.0017 cm, K-ABC 0.208 (p = 0.001), DE 0.253 (p = 0.002)" for each solver, the others by their means.
std::string list_of(const Evidence& evidence, const std::vector<std::string>& own, Metric metric) {
  std::string list;
  for (const std::string& solver : own) {
    list += fmt::format("{}{} {}", list.empty() ? "" : "; ", solver, with_unit(mean_of(evidence, solver), metric));
    for (const RankedSolver& rival : rivals_of(own, evidence)) {
      list += fmt::format(", {} {}{}", rival.solver, number_of(rival.mean, metric),
                          in_brackets(judge(evidence, solver, rival.solver).p));
    }
  }
  return list;
}

// "Computing time, geometric mean"
std::string title_of(const Evidence& evidence, Metric metric) {
  return title(metric) + (evidence.scale == ValueScale::log10 ? ", geometric mean" : "");
}

// Names the numbers of a claim, short.
std::string_view average_of(const Evidence& evidence) {
  return evidence.scale == ValueScale::log10 ? "typical" : evidence.scale == ValueScale::share ? "share" : "mean";
}

std::string how_tested(const Evidence& here, const Evidence& printed) {
  const std::string_view test = pair_test_words(here), other = pair_test_words(printed);
  if (here.plan.unit == Unit::point)
    return fmt::format("No test here, because points of one run depend on each other; printed p-values: {}.", other);
  const std::string of_printed = test == other ? "" : fmt::format("; printed: {}", other);
  const bool has_known = std::ranges::any_of(here.groups, [](const GroupEvidence& group) { return group.copies > 0; });
  return fmt::format("p-values: {} on run means, adjusted for all pairs{}{}.", test,
                     has_known ? "; the sign test against a solver whose runs are all equal" : "", of_printed);
}

// "; by typical error PSO is better": the plan's other estimands that find others better than one of the solvers that
// are claimed to be the first; empty where none does.
std::string other_estimands_against(const JudgedStudy& study, const std::vector<std::string>& own, Metric metric) {
  std::string words;
  for (const Estimand estimand : estimands_of(study, metric)) {
    if (estimand == average_estimand(metric)) continue;
    const Evidence& found = study.evidence(metric, estimand);
    std::vector<std::string> better;
    for (const GroupEvidence& other : found.groups) {
      const bool is_other = std::ranges::count(own, other.name) == 0;
      const bool is_better = is_other && std::ranges::any_of(own, [&](const std::string& solver) {
                               return judge(found, solver, other.name).relation == Relation::worse;
                             });
      if (is_better) better.push_back(other.name);
    }
    if (better.empty()) continue;
    words += fmt::format("; by {} {} {} better",
                         estimand == Estimand::typical ? "typical error" : std::string(name_of(estimand)),
                         listed(better), better.size() == 1 ? "is" : "are");
  }
  return words;
}

Claims compared(const Case& of) {
  const ClaimEntry& entry = of.entry;
  const std::vector<std::string> own = entry.own();
  const bool is_here = entry.study.empty();
  if (is_here && !of.is_of_means()) return {};
  Claim claim = of.begun();
  std::vector<Verdict> here, in_print;
  std::string printed_lists, test;
  for (const Metric metric : entry.metrics) {
    const std::vector<Pair> printed = is_here ? of.pairs(metric) : std::vector<Pair>();
    const auto found = of.evidence(metric);
    if (!found || printed.size() == 1) return {};
    here.push_back(verdict_on(held_against(*found, own)));
    claim.evidence.push_back(fmt::format("{}: {}.", title_of(*found, metric), list_of(*found, own, metric)));
    if (claim.number.empty()) {
      const RankedSolver nearest = rivals_of(own, *found).front();
      std::vector<std::string> means;
      for (const std::string& solver : own) means.push_back(with_unit(mean_of(*found, solver), metric));
      claim.number = fmt::format("{} {}, {} {}", average_of(*found), listed(means), nearest.solver,
                                 number_of(nearest.mean, metric));
    }
    test = how_tested(*found, *found);
    if (printed.empty()) continue;
    const Evidence of_print = of.printed_evidence(printed);
    in_print.push_back(verdict_on(held_against(of_print, own)));
    printed_lists += fmt::format("{}{}", printed_lists.empty() ? "" : "; ", list_of(of_print, own, metric));
    test = how_tested(*found, of_print);
  }
  claim.verdict = verdict_on(here);
  if (!printed_lists.empty()) claim.evidence.push_back(fmt::format("Printed: {}.", printed_lists));
  claim.evidence.push_back(test);
  if (!entry.note.empty()) claim.evidence.push_back(entry.note);
  if (!in_print.empty()) claim.printed = verdict_on(in_print);
  return {claim};
}

}  // namespace

Claims smallest(const Case& of) {
  Claims claims = compared(of);
  const ClaimEntry& entry = of.entry;
  const Metric metric = entry.metrics.front();
  const bool is_of_all = entry.metrics.size() == 1 && entry.study.empty() && entry.against.empty();
  if (claims.empty() || claims.front().verdict != Verdict::holds || !is_of_all) return claims;
  // A paper compares means, so the verdict is by the mean; a claim that only the worst cases support holds in part.
  const std::string against = other_estimands_against(of.study(), entry.own(), metric);
  if (against.empty()) return claims;
  Claim& claim = claims.front();
  claim.verdict = Verdict::in_part;
  claim.evidence.insert(claim.evidence.begin(),
                        fmt::format("The worst cases decide the mean, which the paper compares{}.", against));
  return claims;
}

namespace {

// The number of pairs that a test finds in the printed order, and in the reverse one.
struct FoundOrder {
  PairCounts pairs;
  Verdict verdict;
};

// Tests solvers in the printed order: one rule for our numbers and the printed ones.
FoundOrder found_order(const Evidence& tested, const std::vector<Pair>& printed) {
  PairCounts pairs;
  bool first_leads = true;  // the printed first is found ahead of every other
  for (std::size_t i = 0; i < printed.size(); ++i) {
    for (std::size_t j = i + 1; j < printed.size(); ++j) {
      const Relation relation = judge(tested, printed[i].solver, printed[j].solver).relation;
      pairs.add(relation);
      first_leads = first_leads && (i > 0 || relation == Relation::better);
    }
  }
  const bool is_mostly_found = first_leads || 2 * pairs.better > pairs.all();
  return {pairs, pairs.better == pairs.all()  ? Verdict::holds
                 : is_mostly_found            ? Verdict::in_part
                 : pairs.worse > pairs.better ? Verdict::fails
                                              : Verdict::undecided};
}

// "A 1 cm, B 2 cm", the smallest first.
std::string our_ranking(const std::vector<Pair>& pairs, Metric metric) {
  std::vector<RankedSolver> ours;
  for (const Pair& pair : pairs) ours.push_back({pair.solver, average_in(pair.ours, metric)});
  std::vector<std::string> list;
  for (const RankedSolver& each : ranked(std::move(ours))) {
    list.push_back(fmt::format("{} {}", each.solver, with_unit(each.mean, metric)));
  }
  return fmt::format("{}", fmt::join(list, ", "));
}

}  // namespace

Claims ranking(const Case& of) {
  const Metric metric = of.entry.metrics.front();
  const std::vector<Pair> printed = of.pairs(metric);
  if (printed.size() < 2) return {};
  const Evidence tested_print = of.printed_evidence(printed);
  const FoundOrder in_print = found_order(tested_print, printed);
  Claim claim = of.begun();
  const Evidence& tested = of.study().evidence(metric);
  const auto [pairs, verdict] = found_order(tested, printed);
  claim.verdict = verdict;
  claim.printed = in_print.verdict;
  claim.number = fmt::format("{} of {} pairs by the test", pairs.better, pairs.all());
  claim.evidence = {fmt::format("Here, by the {} of the runs: {}.", average_name(metric), our_ranking(printed, metric)),
                    fmt::format("Found by {}: {} of {} pairs in the printed order and {} in the reverse.",
                                pair_test_words(tested), pairs.better, pairs.all(), pairs.worse),
                    fmt::format("Printed, by {}: {} of {} pairs.", pair_test_words(tested_print), in_print.pairs.better,
                                in_print.pairs.all())};
  return {claim};
}

namespace {

// The solver against each other one: better in one metric and worse in none, or the other way round.
PairCounts dominated_by(const std::string& solver, const std::vector<Evidence>& metrics,
                        const std::vector<Pair>& solvers) {
  PairCounts counts;
  for (const Pair& other : solvers) {
    if (other.solver == solver) continue;
    PairCounts found;
    for (const Evidence& evidence : metrics) found.add(judge(evidence, solver, other.solver).relation);
    counts.add(found.better > 0 && found.worse == 0   ? Relation::better
               : found.worse > 0 && found.better == 0 ? Relation::worse
                                                      : Relation::undecided);
  }
  return counts;
}

}  // namespace

Claims compromise(const Case& of) {
  if (!of.is_printed()) return {};
  const std::string& solver = of.entry.solver;
  std::vector<Evidence> here, in_print;
  std::vector<Pair> solvers;
  for (const Metric metric : of.entry.metrics) {
    solvers = of.pairs(metric);
    in_print.push_back(of.printed_evidence(solvers));
    if (is_comparable(of.study(), metric)) here.push_back(of.study().evidence(metric));
  }
  const bool is_whole = here.size() == of.entry.metrics.size();
  const PairCounts ours = dominated_by(solver, here, solvers), printed = dominated_by(solver, in_print, solvers);
  Claim claim = of.begun();
  claim.verdict = verdict_on(ours);
  if (!is_whole && claim.verdict == Verdict::holds) claim.verdict = Verdict::in_part;
  claim.printed = verdict_on(printed);
  claim.number = fmt::format("ahead of {} of {}{}", ours.better, ours.all(), is_whole ? "" : ", without times");
  if (!is_whole) claim.evidence.push_back(fmt::format("Without times, because {}.", times_not_judged));
  claim.evidence.push_back(fmt::format(
      "{} dominates {} of {} solvers, that is, it is found better in one mean and in none found worse (undecided is not "
      "worse); {} dominate it. Printed: it dominates {}.",
      solver, ours.better, ours.all(), ours.worse, printed.better));
  return {claim};
}

Claims differ(const Case& of) {
  const StudyResults& study = of.study();
  std::vector<std::string> list;
  std::vector<Verdict> here, in_print;
  for (const Metric metric : of.entry.metrics) {
    const auto name = of.file.anovas.find(std::string(name_of(metric)));
    if (name == of.file.anovas.end()) return {};
    const auto printed = comparable_anova(study, printed_rows(of.file, study, metric), name->second);
    if (!printed) return {};
    in_print.push_back(verdict_of(printed->p < study.plan.significance));
    if (!is_comparable(study, metric)) {
      list.push_back(not_judged_words(title(metric) + ": not tested"));
      here.push_back(Verdict::undecided);
      continue;
    }
    const AnovaTable table = anova(study, metric).table;
    if (!std::isfinite(table.p)) return {};
    here.push_back(verdict_of(table.p < study.plan.significance));
    list.push_back(fmt::format("{}: F({}, {}) = {}, {}", title(metric), table.df, table.df_within,
                               short_number(table.statistic), p_words(table.p)));
  }
  Claim claim = of.begun();
  claim.verdict = verdict_on(here);
  claim.printed = verdict_on(in_print);
  claim.evidence = {fmt::format("{}.", fmt::join(list, "; "))};
  claim.number = fmt::format("{} of {} differ", std::ranges::count(here, Verdict::holds), here.size());
  return {claim};
}

namespace {

// The spreads of two groups, and the p of their difference.
struct Spread {
  std::string other;
  double own, others, p;
};

// Corrects the p-values for one another.
Verdict verdict_on_spreads(std::vector<Spread>& spreads, const AnalysisPlan& plan) {
  std::vector<double> p;
  for (const Spread& spread : spreads) p.push_back(spread.p);
  p = adjusted(p);
  PairCounts found;
  for (std::size_t i = 0; i < spreads.size(); ++i) {
    spreads[i].p = p[i];
    found.add(relation_of(spreads[i].own < spreads[i].others ? 1 : -1, p[i], plan.significance));
  }
  return verdict_on(found);
}

std::string list_of(const std::vector<Spread>& spreads, const std::string& solver, Metric metric) {
  std::string list = fmt::format("{} {}", solver, with_unit(spreads.front().own, metric));
  for (const Spread& spread : spreads) {
    list += fmt::format(", {} {}{}", spread.other, number_of(spread.others, metric), in_brackets(spread.p));
  }
  return list;
}

}  // namespace

Claims least_spread(const Case& of) {
  const StudyResults& study = of.study();
  const Metric metric = of.entry.metrics.front();
  if (!of.is_printed() || study.plan.unit == Unit::point) return {};
  std::map<std::string, std::vector<double>> values;
  for (Sample& sample : samples(study, metric)) values[sample.solver] = std::move(sample.values);
  const std::vector<Pair> all = of.pairs(metric);
  const Pair own = *std::ranges::find(all, of.entry.solver, &Pair::solver);
  std::vector<Spread> here, printed;
  for (const Pair& other : all) {
    if (other.solver == own.solver) continue;
    const std::array<std::vector<double>, 2> two{values[own.solver], values[other.solver]};
    const std::array<GroupSummary, 2> in_print{own.printed, other.printed};
    here.push_back({other.solver, own.ours.std, other.ours.std, brown_forsythe(two).p});
    printed.push_back({other.solver, own.printed.std, other.printed.std, bartlett(in_print).p});
  }
  Claim claim = of.begun();
  claim.verdict = verdict_on_spreads(here, study.plan);
  claim.printed = verdict_on_spreads(printed, study.plan);
  const Spread& nearest = std::ranges::min(here, {}, &Spread::others);
  claim.number =
      fmt::format("sd {}, {} {}", with_unit(own.ours.std, metric), nearest.other, number_of(nearest.others, metric));
  claim.evidence = {fmt::format("Standard deviation of the run means: {}.", list_of(here, own.solver, metric)),
                    fmt::format("Printed: {}.", list_of(printed, own.solver, metric)),
                    "p-values: Brown-Forsythe test of each pair, printed: Bartlett's; after Holm."};
  return {claim};
}

}  // namespace ikbench::claims
