#include "analysis/slim2023/solver_claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/figures/figure_parts.hpp"
#include "analysis/inference/comparable.hpp"
#include "analysis/inference/convergence.hpp"
#include "analysis/inference/deciding.hpp"
#include "analysis/inference/estimand.hpp"
#include "analysis/inference/ranking.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/assessment_words.hpp"
#include "analysis/report/leaders.hpp"
#include "analysis/slim2023/claim_comparison.hpp"
#include "analysis/slim2023/paper_tables.hpp"

namespace ikbench::slim2023 {

using namespace results;
using namespace statistics;
using namespace inference;
using namespace report;

namespace {

std::string with_unit(double value, Metric metric) {
  const std::string_view unit = info_of(metric).unit;
  return fmt::format("{}{}{}", short_number(value), unit.empty() ? "" : " ", unit);
}

// "IK-BA 0.0017 cm, K-ABC 0.208 (p = 0.001), DE 0.253 (p = 0.002)", the others by their means.
std::string list_of(const Evidence& evidence, const std::string& solver, Metric metric) {
  std::vector<Standing> others;
  std::string list;
  for (const GroupEvidence& group : evidence.groups) {
    if (group.name == solver) list = fmt::format("{} {}", solver, with_unit(group.described.mean, metric));
    if (group.name != solver) others.push_back({group.name, group.described.mean});
  }
  for (const Standing& other : ranked(std::move(others))) {
    list += fmt::format(", {} {}{}", other.solver, short_number(other.mean),
                        in_brackets(judge(evidence, solver, other.solver).p));
  }
  return list;
}

// What the other estimands of the study's plan say of a solver that is claimed to be the first.
struct OtherEstimands {
  std::string against = {};  // "; by typical error PSO is better": those that find others better; empty where none does
  std::string sentences = {};  // who is first by each
};
OtherEstimands other_estimands(const JudgedStudy& study, const std::string& solver, Metric metric) {
  OtherEstimands result;
  for (const Estimand estimand : estimands_of(study, metric)) {
    if (estimand == Estimand::mean) continue;
    const Evidence& found = study.evidence(metric, estimand);
    result.sentences += ' ' + leader_sentence(study, metric, estimand);
    std::vector<std::string> better;
    for (const GroupEvidence& other : found.groups) {
      const bool is_other = other.name != solver;
      if (is_other && judge(found, solver, other.name).relation == Relation::worse) better.push_back(other.name);
    }
    if (better.empty()) continue;
    result.against += fmt::format("; by {} {} {} better",
                                  estimand == Estimand::typical ? "typical error" : std::string(name_of(estimand)),
                                  listed(better), better.size() == 1 ? "is" : "are");
  }
  return result;
}

// The printed numbers of the solvers that a claim is about; none where it is about another study's too.
std::vector<Pair> printed_of(const StudyResults& study, const ClaimEntry& entry, Metric metric) {
  if (!entry.study.empty()) return {};
  std::vector<Pair> all = pairs(study, metric);
  if (!entry.against.empty()) {
    std::erase_if(all, [&](const Pair& pair) { return pair.solver != entry.solver && pair.solver != entry.against; });
  }
  return all;
}

std::optional<Claim> compared(const Reported& reported, const ClaimEntry& entry, Should should) {
  const JudgedStudy& study = reported.study;
  Claim claim = begun(entry);
  std::vector<Verdict> here, in_print;
  std::string printed_lists, test;
  std::size_t comparable = 0;
  for (const Metric metric : entry.metrics) {
    const std::vector<Pair> printed = printed_of(study, entry, metric);
    const auto found = evidence_for(reported, entry, metric);
    if (!found || (entry.study.empty() && printed.size() < 2)) return std::nullopt;
    const Against ours = against(*found, entry.solver, should);
    here.push_back(verdict_on(ours.found));
    const std::string name = inference::capitalised(info_of(metric).name);
    if (found->contrasts.empty() && metric == Metric::seconds) {
      claim.evidence += fmt::format("{}: not judged, because {} (see the warnings). ", name, times_not_judged);
      claim.number = times_not_judged;
    } else {
      ++comparable;
      claim.evidence += fmt::format("{}: {}. ", name, list_of(*found, entry.solver, metric));
      claim.number = metric == Metric::seconds ? fmt::format("{} ms, {} {}", short_number(1000 * ours.own_mean),
                                                             ours.nearest, short_number(1000 * ours.nearest_mean))
                                               : fmt::format("{}, {} {}", with_unit(ours.own_mean, metric),
                                                             ours.nearest, short_number(ours.nearest_mean));
      test = how_tested(*found, *found);
    }
    if (printed.empty()) continue;
    const Evidence of_print = printed_evidence(printed, study.plan);
    in_print.push_back(verdict_on(against(of_print, entry.solver, should).found));
    printed_lists += fmt::format("{}{}", printed_lists.empty() ? "" : "; ", list_of(of_print, entry.solver, metric));
    if (comparable > 0) test = how_tested(*found, of_print);
  }
  claim.verdict = verdict_on(here);
  claim.evidence +=
      printed_lists.empty() ? test.substr(test.empty() ? 0 : 1) : fmt::format("Printed: {}.{}", printed_lists, test);
  if (!in_print.empty()) claim.printed = verdict_on(in_print);
  if (here.size() > 1) {
    claim.number = fmt::format("better in {} of {} means", std::ranges::count(here, Verdict::holds), here.size());
  }
  if (entry.study == "limits") claim.table = "limits";
  if (entry.study == "context") claim.table = "baselines";
  return claim;
}

}  // namespace

std::optional<Claim> smallest(const Reported& reported, const ClaimEntry& entry) {
  std::optional<Claim> claim = compared(reported, entry, Should::be_smallest);
  if (!claim || entry.metrics.size() > 1 || !entry.study.empty() || !entry.against.empty()) return claim;
  // The paper compares means, so the verdict is by the mean; what holds by the worst cases alone holds in part.
  const Metric metric = entry.metrics.front();
  if (!is_comparable(reported.study, metric)) return claim;
  const OtherEstimands others = other_estimands(reported.study, entry.solver, metric);
  claim->evidence += others.sentences;
  if (claim->verdict == Verdict::holds && !others.against.empty()) {
    claim->verdict = Verdict::in_part;
    claim->evidence +=
        fmt::format(" It holds by the mean, which the paper compares and which the worst cases decide{}: so in part.",
                    others.against);
  }
  if (metric == Metric::position_error_cm) claim->evidence += ' ' + closest_point_by_point(reported.study);
  return claim;
}

std::optional<Claim> largest(const Reported& reported, const ClaimEntry& entry) {
  return compared(reported, entry, Should::be_largest);
}

namespace {

double our_mean(const Pair& pair) { return pair.ours.mean; }
double our_median(const Pair& pair) { return pair.ours.median; }
double printed_mean(const Pair& pair) { return pair.printed.mean; }

std::vector<Standing> standings(const std::vector<Pair>& pairs, double (*mean_of)(const Pair&)) {
  std::vector<Standing> result;
  for (const Pair& pair : pairs) result.push_back({pair.solver, mean_of(pair)});
  return ranked(std::move(result));
}

// How many pairs a test finds in the printed order, how many in the reverse.
struct FoundOrder {
  Found pairs;
  bool first_leads = true;  // the printed first is found ahead of every other
};

// Of solvers in the printed order.
FoundOrder found_order(const Evidence& tested, const std::vector<Pair>& printed) {
  FoundOrder order;
  for (std::size_t i = 0; i < printed.size(); ++i) {
    for (std::size_t j = i + 1; j < printed.size(); ++j) {
      const Relation answer = judge(tested, printed[i].solver, printed[j].solver).relation;
      order.pairs.add(answer);
      order.first_leads = order.first_leads && (i > 0 || answer == Relation::better);
    }
  }
  return order;
}

// The one rule, for our numbers and the printed ones.
Verdict verdict_on(const FoundOrder& order) {
  const Found& pairs = order.pairs;
  if (pairs.better == pairs.all()) return Verdict::holds;
  if (order.first_leads || 2 * pairs.better > pairs.all()) return Verdict::in_part;
  return pairs.worse > pairs.better ? Verdict::fails : Verdict::undecided;
}

// "A 1 cm, B 2 cm. 14 of 15 pairs rank as in the paper; first is A, as printed."
std::string our_ranking(const std::vector<Pair>& pairs, Metric metric) {
  const std::vector<Standing> ours = standings(pairs, metric == Metric::seconds ? our_median : our_mean),
                              printed = standings(pairs, printed_mean);
  std::string list;
  for (const Standing& standing : ours) {
    list += fmt::format("{}{} {}", list.empty() ? "" : ", ", standing.solver, with_unit(standing.mean, metric));
  }
  return fmt::format("{}. {}; first is {}{}.", list, printed_order_words(compare_pairs(printed, ours)),
                     first_words(ours), first_of(ours) == first_of(printed) ? ", as printed" : "");
}

}  // namespace

// Times that are not comparable are not ranked.
std::optional<Claim> ranking(const Reported& reported, const ClaimEntry& entry) {
  const JudgedStudy& study = reported.study;
  const Metric metric = entry.metrics.front();
  const std::vector<Pair> printed = pairs(study, metric);
  if (printed.size() < 2) return std::nullopt;
  const Evidence tested_print = printed_evidence(printed, study.plan);
  const FoundOrder in_print = found_order(tested_print, printed);
  Claim claim = begun(entry);
  claim.printed = verdict_on(in_print);
  if (!is_comparable(study, metric)) {
    claim.evidence = fmt::format("Here: not ranked, because {} (see the warnings).", times_not_judged);
    claim.number = times_not_judged;
  } else {
    const Evidence& tested = study.evidence(metric);
    const FoundOrder here = found_order(tested, printed);
    claim.verdict = verdict_on(here);
    claim.number = fmt::format("{} of {} pairs by the test", here.pairs.better, here.pairs.all());
    claim.evidence = fmt::format("Here: {} Found by {}: {} of {} pairs in the printed order and {} in the reverse.",
                                 our_ranking(printed, metric), pair_test_words(tested), here.pairs.better,
                                 here.pairs.all(), here.pairs.worse);
  }
  claim.evidence += fmt::format(" Printed, by {}: {} of {} pairs.", pair_test_words(tested_print),
                                in_print.pairs.better, in_print.pairs.all());
  if (metric == Metric::seconds) {
    claim.evidence += " Times depend on the implementation: MATLAB there, C++ here.";
  }
  return claim;
}

namespace {

// Better in one metric and worse in none, or the other way round.
Relation dominance(const std::vector<Evidence>& metrics, const std::string& one, const std::string& other) {
  Found found;
  for (const Evidence& evidence : metrics) found.add(judge(evidence, one, other).relation);
  if (found.better > 0 && found.worse == 0) return Relation::better;
  return found.worse > 0 && found.better == 0 ? Relation::worse : Relation::undecided;
}

struct Front {
  Found found;                     // of the solver against each other
  std::vector<std::string> names;  // whom nobody dominates
};

Front front_of(const std::vector<Evidence>& metrics, const std::vector<Pair>& solvers, const std::string& solver) {
  Front front;
  for (const Pair& one : solvers) {
    bool dominated = false;
    for (const Pair& other : solvers) {
      if (other.solver == one.solver) continue;
      const Relation answer = dominance(metrics, one.solver, other.solver);
      dominated = dominated || answer == Relation::worse;
      if (one.solver == solver) front.found.add(answer);
    }
    if (!dominated) front.names.push_back(one.solver);
  }
  return front;
}

}  // namespace

std::optional<Claim> compromise(const Reported& reported, const ClaimEntry& entry) {
  const JudgedStudy& study = reported.study;
  std::vector<Evidence> here, in_print;
  std::vector<Pair> solvers;
  Claim claim = begun(entry);
  for (const Metric metric : entry.metrics) {
    solvers = pairs(study, metric);
    if (solvers.size() < 2 || std::ranges::find(solvers, entry.solver, &Pair::solver) == solvers.end())
      return std::nullopt;
    in_print.push_back(printed_evidence(solvers, study.plan));
    if (is_comparable(study, metric)) {
      here.push_back(study.evidence(metric));
    } else {
      claim.evidence = fmt::format("Without times, because {}. ", times_not_judged);
    }
  }
  const Front ours = front_of(here, solvers, entry.solver), printed = front_of(in_print, solvers, entry.solver);
  claim.verdict = verdict_on(ours.found);
  if (here.size() < entry.metrics.size() && claim.verdict == Verdict::holds) claim.verdict = Verdict::in_part;
  claim.printed = verdict_on(printed.found);
  claim.number = fmt::format("ahead of {} of {}{}", ours.found.better, ours.found.all(),
                             here.size() < entry.metrics.size() ? ", without times" : "");
  claim.evidence += fmt::format(
      "{} dominates {} of {} solvers, that is, it is better in one mean and worse in none; {} dominate it. Whom nobody "
      "dominates (the Pareto front): {}. Printed: it dominates {}; the front is {}.",
      entry.solver, ours.found.better, ours.found.all(), ours.found.worse, listed(ours.names), printed.found.better,
      listed(printed.names));
  return claim;
}

// As many of the metrics as are judged; times that are not comparable are not.
std::optional<Claim> differ(const Reported& reported, const ClaimEntry& entry) {
  const StudyResults& study = reported.study;
  std::string list;
  std::vector<Verdict> here, in_print;
  for (const Metric metric : entry.metrics) {
    const std::optional<AnovaTable> printed = comparable_printed_anova(study, metric);
    if (!printed) return std::nullopt;
    in_print.push_back(is_significant(printed->p, study.plan) ? Verdict::holds : Verdict::fails);
    list += fmt::format("{}{}: ", list.empty() ? "" : "; ", inference::capitalised(info_of(metric).name));
    if (!is_comparable(study, metric)) {
      list += fmt::format("not tested, because {} (see the warnings)", times_not_judged);
      here.push_back(Verdict::undecided);
      continue;
    }
    const AnovaTable table = anova(study, metric).table;
    if (!std::isfinite(table.p)) return std::nullopt;
    here.push_back(is_significant(table.p, study.plan) ? Verdict::holds : Verdict::fails);
    list +=
        fmt::format("F({}, {}) = {}, {}", table.df_between, table.df_within, short_number(table.F), p_words(table.p));
  }
  Claim claim = begun(entry);
  claim.verdict = verdict_on(here);
  claim.printed = verdict_on(in_print);
  claim.evidence = list + ".";
  claim.number = fmt::format("{} of {} differ", std::ranges::count(here, Verdict::holds), here.size());
  claim.table = "table-4";
  return claim;
}

}  // namespace ikbench::slim2023
