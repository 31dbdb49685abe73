#include "analysis/claims/rules_of_means.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "analysis/inference/comparable.hpp"
#include "analysis/inference/convergence.hpp"
#include "analysis/inference/design.hpp"
#include "analysis/inference/estimand.hpp"
#include "analysis/inference/judge.hpp"
#include "analysis/inference/ranking.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/assessment_words.hpp"
#include "analysis/report/leaders.hpp"
#include "analysis/report/study_tables.hpp"
#include "analysis/statistics/equal_variances.hpp"
#include "analysis/statistics/p_adjust.hpp"

namespace ikbench::claims {

using namespace results;
using namespace statistics;
using namespace inference;
using namespace report;

namespace {

std::string named(Metric metric) { return inference::capitalised(info_of(metric).name); }

// The answers of the plan's other estimands about a solver that is claimed to be the first.
struct OtherEstimands {
  std::string against = {};  // "; by typical error PSO is better": those that find others better; empty where none does
  std::vector<std::string> sentences = {};  // who is first by each
};
OtherEstimands other_estimands(const JudgedStudy& study, const std::string& solver, Metric metric) {
  OtherEstimands result;
  for (const Estimand estimand : estimands_of(study, metric)) {
    if (estimand == average_estimand(metric)) continue;
    const Evidence& found = study.evidence(metric, estimand);
    result.sentences.push_back(words_of(leader_sentence(study, metric, estimand)));
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

// The printed numbers of the claim's solvers; none if the claim is about another study, too.
std::vector<Pair> printed_of(const Case& of, Metric metric) {
  if (!of.entry.study.empty()) return {};
  std::vector<Pair> all = of.pairs(metric);
  std::erase_if(all, [&](const Pair& pair) {
    return !of.entry.against.empty() && pair.solver != of.entry.solver && pair.solver != of.entry.against;
  });
  return all;
}

Claims compared(const Case& of, Extreme claimed) {
  const ClaimEntry& entry = of.entry;
  Claim claim = of.begun();
  std::vector<Verdict> here, in_print;
  std::string printed_lists, test;
  for (const Metric metric : entry.metrics) {
    const std::vector<Pair> printed = printed_of(of, metric);
    const auto found = of.evidence(metric);
    const bool has_print = !of.file.means.empty() && entry.study.empty();
    if (!found || (has_print && printed.size() < 2)) return {};
    const ComparedWithOthers ours = compared_with_others(*found, entry.solver, claimed);
    here.push_back(verdict_on(ours.found));
    const bool is_judged = !found->contrasts.empty() || metric != Metric::seconds;
    if (is_judged) {
      claim.evidence.push_back(fmt::format("{}: {}.", named(metric), list_of(*found, entry.solver, metric)));
      claim.number = fmt::format("{}, {} {}", with_unit(ours.own_mean, metric), ours.nearest,
                                 number_of(ours.nearest_mean, metric));
      test = how_tested(*found, *found);
    } else {
      claim.evidence.push_back(
          fmt::format("{}: not judged, because {} (see the warnings).", named(metric), times_not_judged));
      claim.number = times_not_judged;
    }
    if (printed.empty()) continue;
    const Evidence of_print = of.printed_evidence(printed);
    in_print.push_back(verdict_on(compared_with_others(of_print, entry.solver, claimed).found));
    printed_lists += fmt::format("{}{}", printed_lists.empty() ? "" : "; ", list_of(of_print, entry.solver, metric));
    if (!test.empty()) test = how_tested(*found, of_print);
  }
  claim.verdict = verdict_on(here);
  if (!printed_lists.empty()) claim.evidence.push_back(fmt::format("Printed: {}.", printed_lists));
  if (!test.empty()) claim.evidence.push_back(test);
  if (!in_print.empty()) claim.printed = verdict_on(in_print);
  if (here.size() > 1) {
    claim.number = fmt::format("better in {} of {} means", std::ranges::count(here, Verdict::holds), here.size());
  }
  return {claim};
}

}  // namespace

Claims smallest(const Case& of) {
  Claims claims = compared(of, Extreme::smallest);
  const ClaimEntry& entry = of.entry;
  const bool is_of_all = entry.metrics.size() == 1 && entry.study.empty() && entry.against.empty();
  const Metric metric = entry.metrics.front();
  if (claims.empty() || !is_of_all || !is_comparable(of.study(), metric)) return claims;
  // A paper compares means, so the verdict is by the mean; a claim that only the worst cases support holds in part.
  Claim& claim = claims.front();
  const OtherEstimands others = other_estimands(of.study(), entry.solver, metric);
  std::ranges::copy(others.sentences, std::back_inserter(claim.evidence));
  if (claim.verdict == Verdict::holds && !others.against.empty()) {
    claim.verdict = Verdict::in_part;
    claim.evidence.insert(claim.evidence.begin(),
                          fmt::format("The worst cases decide the mean, which the paper compares{}.", others.against));
  }
  const std::string closest = metric == Metric::position_error_cm ? closest_point_by_point(of.study()) : "";
  if (!closest.empty()) claim.evidence.push_back(closest);
  return claims;
}

Claims alike(const Case& of) {
  const Metric metric = of.entry.metrics.front();
  const auto found = of.evidence(metric);
  if (!found) return {};
  const Finding pair = judge(*found, of.entry.solver, of.entry.against);
  if (pair.relation == Relation::undefined) return {};
  Claim claim = of.begun();
  claim.verdict = pair.relation == Relation::same        ? Verdict::holds
                  : pair.relation == Relation::undecided ? Verdict::undecided
                                                         : Verdict::fails;
  const auto mean_of = [&](const std::string& solver) {
    return std::ranges::find(found->groups, solver, &GroupEvidence::name)->described.mean;
  };
  claim.number = fmt::format("{} and {}", number_of(mean_of(of.entry.solver), metric),
                             with_unit(mean_of(of.entry.against), metric));
  claim.evidence = {
      fmt::format("{}: {} with {}, {} with {}{}.", named(metric), with_unit(mean_of(of.entry.solver), metric),
                  of.entry.solver, number_of(mean_of(of.entry.against), metric), of.entry.against, in_brackets(pair.p)),
      how_tested(*found, *found)};
  return {claim};
}

Claims largest(const Case& of) { return compared(of, Extreme::largest); }

namespace {

// The number of pairs that a test finds in the printed order, and in the reverse one.
struct FoundOrder {
  PairCounts pairs;
  bool first_leads = true;  // the printed first is found ahead of every other
};

// Tests solvers in the printed order.
FoundOrder found_order(const Evidence& tested, const std::vector<Pair>& printed) {
  FoundOrder order;
  for (std::size_t i = 0; i < printed.size(); ++i) {
    for (std::size_t j = i + 1; j < printed.size(); ++j) {
      const Relation relation = judge(tested, printed[i].solver, printed[j].solver).relation;
      order.pairs.add(relation);
      order.first_leads = order.first_leads && (i > 0 || relation == Relation::better);
    }
  }
  return order;
}

// One rule for our numbers and the printed ones.
Verdict verdict_on(const FoundOrder& order) {
  const PairCounts& pairs = order.pairs;
  if (pairs.better == pairs.all()) return Verdict::holds;
  if (order.first_leads || 2 * pairs.better > pairs.all()) return Verdict::in_part;
  return pairs.worse > pairs.better ? Verdict::fails : Verdict::undecided;
}

// "A 1 cm, B 2 cm. 14 of 15 pairs rank as in the paper; first is A, as printed."
std::string our_ranking(const std::vector<Pair>& pairs, Metric metric) {
  std::vector<RankedSolver> ours, printed;
  for (const Pair& pair : pairs) {
    ours.push_back({pair.solver, average_in(pair.ours, metric)});
    printed.push_back({pair.solver, pair.printed.mean});
  }
  ours = ranked(std::move(ours));
  printed = ranked(std::move(printed));
  std::vector<std::string> list;
  for (const RankedSolver& each : ours) list.push_back(fmt::format("{} {}", each.solver, with_unit(each.mean, metric)));
  return fmt::format("{}. {}; first is {}{}.", fmt::join(list, ", "), printed_order_words(compare_pairs(printed, ours)),
                     first_words(ours), first_of(ours) == first_of(printed) ? ", as printed" : "");
}

}  // namespace

Claims ranking(const Case& of) {
  const Metric metric = of.entry.metrics.front();
  const std::vector<Pair> printed = of.pairs(metric);
  if (printed.size() < 2) return {};
  const Evidence tested_print = of.printed_evidence(printed);
  const FoundOrder in_print = found_order(tested_print, printed);
  Claim claim = of.begun();
  claim.printed = verdict_on(in_print);
  if (is_comparable(of.study(), metric)) {
    const Evidence& tested = of.study().evidence(metric);
    const FoundOrder here = found_order(tested, printed);
    claim.verdict = verdict_on(here);
    claim.number = fmt::format("{} of {} pairs by the test", here.pairs.better, here.pairs.all());
    claim.evidence = {
        fmt::format("Here, by the {} of the runs: {}", average_name(metric), our_ranking(printed, metric)),
        fmt::format("Found by {}: {} of {} pairs in the printed order and {} in the reverse.", pair_test_words(tested),
                    here.pairs.better, here.pairs.all(), here.pairs.worse)};
  } else {
    claim.evidence = {fmt::format("Here: not ranked, because {} (see the warnings).", times_not_judged)};
    claim.number = times_not_judged;
  }
  claim.evidence.push_back(fmt::format("Printed, by {}: {} of {} pairs.", pair_test_words(tested_print),
                                       in_print.pairs.better, in_print.pairs.all()));
  if (metric == Metric::seconds && !of.file.implementation.empty()) {
    claim.evidence.push_back(
        fmt::format("Times depend on the implementation: {} there, C++ here.", of.file.implementation));
  }
  return {claim};
}

namespace {

// Better in one metric and worse in none, or the other way round.
Relation dominance(const std::vector<Evidence>& metrics, const std::string& one, const std::string& other) {
  PairCounts found;
  for (const Evidence& evidence : metrics) found.add(judge(evidence, one, other).relation);
  if (found.better > 0 && found.worse == 0) return Relation::better;
  return found.worse > 0 && found.better == 0 ? Relation::worse : Relation::undecided;
}

struct Front {
  PairCounts found;                // of the solver against each other one
  std::vector<std::string> names;  // solvers that nobody dominates
};

Front front_of(const std::vector<Evidence>& metrics, const std::vector<Pair>& solvers, const std::string& solver) {
  Front front;
  for (const Pair& one : solvers) {
    bool is_dominated = false;
    for (const Pair& other : solvers) {
      if (other.solver == one.solver) continue;
      const Relation relation = dominance(metrics, one.solver, other.solver);
      is_dominated = is_dominated || relation == Relation::worse;
      if (one.solver == solver) front.found.add(relation);
    }
    if (!is_dominated) front.names.push_back(one.solver);
  }
  return front;
}

}  // namespace

Claims compromise(const Case& of) {
  std::vector<Evidence> here, in_print;
  std::vector<Pair> solvers;
  Claim claim = of.begun();
  if (!of.has_solver()) return {};
  for (const Metric metric : of.entry.metrics) {
    solvers = of.pairs(metric);
    in_print.push_back(of.printed_evidence(solvers));
    if (is_comparable(of.study(), metric)) {
      here.push_back(of.study().evidence(metric));
    } else {
      claim.evidence = {fmt::format("Without times, because {}.", times_not_judged)};
    }
  }
  const std::string& solver = of.entry.solver;
  const Front ours = front_of(here, solvers, solver), printed = front_of(in_print, solvers, solver);
  const bool is_whole = here.size() == of.entry.metrics.size();
  claim.verdict = verdict_on(ours.found);
  if (!is_whole && claim.verdict == Verdict::holds) claim.verdict = Verdict::in_part;
  claim.printed = verdict_on(printed.found);
  claim.number =
      fmt::format("ahead of {} of {}{}", ours.found.better, ours.found.all(), is_whole ? "" : ", without times");
  std::ranges::move(
      std::vector{
          fmt::format("{} dominates {} of {} solvers, that is, it is better in one mean and worse in none; {} "
                      "dominate it.",
                      solver, ours.found.better, ours.found.all(), ours.found.worse),
          fmt::format("Whom nobody dominates (the Pareto front): {}.", listed(ours.names)),
          fmt::format("Printed: it dominates {}; the front is {}.", printed.found.better, listed(printed.names))},
      std::back_inserter(claim.evidence));
  return {claim};
}

Claims differ(const Case& of) {
  const StudyResults& study = of.study();
  std::vector<std::string> list;
  std::vector<Verdict> here, in_print;
  const auto verdict = [&](double p) { return p < study.plan.significance ? Verdict::holds : Verdict::fails; };
  for (const Metric metric : of.entry.metrics) {
    const std::optional<AnovaTable> printed = printed_anova(of.file, study, metric);
    if (!printed) return {};
    in_print.push_back(verdict(printed->p));
    if (!is_comparable(study, metric)) {
      list.push_back(fmt::format("{}: not tested, because {} (see the warnings)", named(metric), times_not_judged));
      here.push_back(Verdict::undecided);
      continue;
    }
    const AnovaTable table = anova(study, metric).table;
    if (!std::isfinite(table.p)) return {};
    here.push_back(verdict(table.p));
    list.push_back(fmt::format("{}: F({}, {}) = {}, {}", named(metric), table.df_between, table.df_within,
                               short_number(table.F), p_words(table.p)));
  }
  Claim claim = of.begun();
  claim.verdict = verdict_on(here);
  claim.printed = verdict_on(in_print);
  claim.evidence = {fmt::format("{}.", fmt::join(list, "; "))};
  claim.number = fmt::format("{} of {} differ", std::ranges::count(here, Verdict::holds), here.size());
  return {claim};
}

namespace {

// The group with the smaller spread of two, by a test whose p-values are corrected for the others.
struct Spread {
  std::string other;
  double own, others, p;
};

Verdict verdict_on(std::vector<Spread>& spreads, const AnalysisPlan& plan) {
  std::vector<double> p;
  for (const Spread& spread : spreads) p.push_back(spread.p);
  p = adjusted(p, Correction::holm);
  PairCounts found;
  for (std::size_t i = 0; i < spreads.size(); ++i) {
    spreads[i].p = p[i];
    const bool is_smaller = spreads[i].own < spreads[i].others;
    found.add(relation_of(is_smaller ? 1 : -1, p[i], plan.significance));
  }
  return verdict_on(found);
}

std::string spread_words(const std::vector<Spread>& spreads, const std::string& solver, Metric metric) {
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
  if (!of.has_solver() || study.plan.unit == Unit::point) return {};
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
  claim.verdict = verdict_on(here, study.plan);
  claim.printed = verdict_on(printed, study.plan);
  const Spread& nearest = std::ranges::min(here, {}, &Spread::others);
  claim.number =
      fmt::format("{}, {} {}", with_unit(own.ours.std, metric), nearest.other, number_of(nearest.others, metric));
  claim.evidence = {fmt::format("Standard deviation of the run means: {}.", spread_words(here, own.solver, metric)),
                    fmt::format("Printed: {}.", spread_words(printed, own.solver, metric)),
                    "p-values: Brown-Forsythe test of each pair, printed: Bartlett's; after Holm."};
  return {claim};
}

namespace {

// The mean absolute second difference of the joints' angles along each complete run [deg].
std::vector<double> second_differences_deg(const StudyResults& study, const std::string& solver) {
  std::vector<double> means;
  for (const RunShape& shape : study.solve_data->shapes) {
    if (study.solve_data->labels[shape.solver] == solver && shape.points == study.points)
      means.push_back(shape.mean_bend_deg);
  }
  return means;
}

// The largest move of a joint from one point to the next, averaged over each complete run [deg].
std::vector<double> largest_moves_deg(const StudyResults& study, const std::string& solver) {
  for (const Sample& sample : samples(study, averaged([](const Solve& solve) { return solve.largest_move_deg; }))) {
    if (sample.solver == solver) return sample.values;
  }
  return {};
}

}  // namespace

Claims smoothest(const Case& of) {
  const StudyResults& study = of.study();
  if (!of.has_solver() || study.plan.unit == Unit::point || study.points < 3) return {};
  Claim claim = of.begun();
  std::vector<Verdict> verdicts;
  constexpr std::pair<std::string_view, decltype(&second_differences_deg)> measures[]{
      {"Mean second difference of an angle along the path", second_differences_deg},
      {"Mean of the largest move of a joint", largest_moves_deg}};
  for (const auto& [words, values_of] : measures) {
    Observations observed{.name = "smoothness", .quantity = fmt::format("{} [deg]", words), .unit = "deg"};
    for (const std::string& solver : study.solvers) observed.groups.push_back({solver, values_of(study, solver)});
    if (std::ranges::any_of(observed.groups, [](const Group& group) { return group.values.empty(); })) return {};
    const ComparedWithOthers ours =
        compared_with_others(tested(observed, feasible(study.plan, observed)), of.entry.solver);
    verdicts.push_back(verdict_on(ours.found));
    const std::string number =
        fmt::format("{} deg, {} {}", short_number(ours.own_mean), ours.nearest, short_number(ours.nearest_mean));
    claim.evidence.push_back(fmt::format("{}: {} {}; found smaller than {} of {} others, larger than {}.", words,
                                         of.entry.solver, number, ours.found.better, ours.found.all(),
                                         ours.found.worse));
    if (claim.number.empty()) claim.number = number;
  }
  claim.verdict = verdict_on(verdicts);
  if (!of.entry.note.empty()) claim.evidence.push_back(of.entry.note);
  return {claim};
}

}  // namespace ikbench::claims
