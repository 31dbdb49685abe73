#include "analysis/slim2023/ranking_claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

#include "analysis/inference/convergence.hpp"
#include "analysis/inference/estimand.hpp"
#include "analysis/inference/ranking.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/assessment_words.hpp"
#include "analysis/report/leaders.hpp"
#include "analysis/slim2023/claim_comparison.hpp"

namespace ikbench::slim2023 {

using namespace results;
using namespace statistics;
using namespace inference;
using namespace report;

namespace {

double our_mean(const Pair& pair) { return pair.ours.mean; }
double our_median(const Pair& pair) { return pair.ours.median; }
double printed_mean(const Pair& pair) { return pair.printed.mean; }

std::vector<Standing> standings(const std::vector<Pair>& pairs, double (*mean_of)(const Pair&)) {
  std::vector<Standing> result;
  for (const Pair& pair : pairs) result.push_back({pair.solver, mean_of(pair)});
  return ranked(std::move(result));
}

// What is ranked: "Accuracy", in "cm".
struct Ranked {
  Metric metric;
  std::string_view name;
  std::string_view unit;
};

// How many pairs a test finds in the printed order, how many in the reverse.
struct FoundOrder {
  int pairs = 0, as_printed = 0, reversed = 0;
  bool first_leads = true;  // the printed first is found ahead of every other
};

// Of solvers in the printed order.
FoundOrder found_order(const Evidence& tested, const std::vector<Pair>& printed) {
  FoundOrder order;
  for (std::size_t i = 0; i < printed.size(); ++i) {
    for (std::size_t j = i + 1; j < printed.size(); ++j) {
      const Answer answer = judge(tested, printed[i].solver, printed[j].solver).answer;
      ++order.pairs;
      order.as_printed += answer == Answer::better ? 1 : 0;
      order.reversed += answer == Answer::worse ? 1 : 0;
      order.first_leads = order.first_leads && (i > 0 || answer == Answer::better);
    }
  }
  return order;
}

// The one rule, for our numbers and the printed ones.
Verdict verdict_on(const FoundOrder& order) {
  if (order.as_printed == order.pairs) return Verdict::holds;
  if (order.first_leads || 2 * order.as_printed > order.pairs) return Verdict::in_part;
  return order.reversed > order.as_printed ? Verdict::fails : Verdict::undecided;
}

// "A 1 cm, B 2 cm. 14 of 15 pairs rank as in the paper; first is A, as printed."
std::string our_ranking(const std::vector<Pair>& pairs, const Ranked& what) {
  const std::vector<Standing> ours = standings(pairs, what.metric == Metric::seconds ? our_median : our_mean),
                              printed = standings(pairs, printed_mean);
  std::string list;
  for (const Standing& standing : ours) {
    list +=
        fmt::format("{}{} {} {}", list.empty() ? "" : ", ", standing.solver, short_number(standing.mean), what.unit);
  }
  return fmt::format("{}. {}; first is {}{}.", list, printed_order_words(compare_pairs(printed, ours)),
                     first_words(ours), first_of(ours) == first_of(printed) ? ", as printed" : "");
}

// The printed ranking, judged by what the test of pairs finds. Times that are not comparable are not ranked.
std::optional<Claim> ranking(const JudgedStudy& study, const std::vector<Comparison>& rows, const Ranked& what) {
  const std::vector<Pair> printed = pairs(study, rows, what.metric);
  if (printed.size() < 2) return std::nullopt;
  const Evidence tested_print = printed_evidence(printed, study.plan);
  const FoundOrder in_print = found_order(tested_print, printed);
  Claim claim{.statement = fmt::format("{}: {}", what.name, order_words(standings(printed, printed_mean))),
              .verdict = Verdict::undecided,
              .table = "table-3",
              .printed = verdict_on(in_print)};
  if (what.metric == Metric::seconds && !times_are_comparable(study)) {
    claim.evidence = fmt::format("Here: not ranked, because {} (see the warnings).", times_not_judged);
  } else {
    const Evidence& tested = study.evidence(what.metric);
    const FoundOrder here = found_order(tested, printed);
    claim.verdict = verdict_on(here);
    claim.evidence =
        fmt::format("Here: {} The {} finds {} of {} pairs in the printed order and {} in the reverse.",
                    our_ranking(printed, what), pair_test_words(tested), here.as_printed, here.pairs, here.reversed);
  }
  claim.evidence += fmt::format(" Printed: the {} finds {} of {} pairs.", pair_test_words(tested_print),
                                in_print.as_printed, in_print.pairs);
  return claim;
}

// What the other estimands of the study's plan say of a solver that is claimed to be the most accurate.
struct OtherEstimands {
  std::string against = {};  // "; by typical error PSO is better": those that find others better; empty where none does
  std::string sentences = {};  // who is first by each
};
OtherEstimands other_estimands(const JudgedStudy& study, const std::string& solver) {
  OtherEstimands result;
  for (const Estimand estimand : estimands_of(study, Metric::position_error_cm)) {
    if (estimand == Estimand::mean) continue;
    const Evidence& found = study.evidence(Metric::position_error_cm, estimand);
    result.sentences += ' ' + leader_sentence(study, Metric::position_error_cm, estimand);
    std::vector<std::string> better;
    for (const GroupEvidence& other : found.groups) {
      const bool is_other = other.name != solver;
      if (is_other && judge(found, solver, other.name).answer == Answer::worse) better.push_back(other.name);
    }
    if (better.empty()) continue;
    result.against += fmt::format("; by {} {} {} better",
                                  estimand == Estimand::typical ? "typical error" : std::string(name_of(estimand)),
                                  listed(better), better.size() == 1 ? "is" : "are");
  }
  return result;
}

}  // namespace

std::optional<Claim> accuracy(const JudgedStudy& study, const std::vector<Comparison>& rows) {
  return ranking(study, rows, {Metric::position_error_cm, "Accuracy", "cm"});
}

std::optional<Claim> computing_time(const JudgedStudy& study, const std::vector<Comparison>& rows) {
  std::optional<Claim> claim = ranking(study, rows, {Metric::seconds, "Computing time", "s"});
  if (claim) claim->evidence += " Times depend on the implementation: MATLAB there, C++ here.";
  return claim;
}

std::optional<Claim> most_accurate(const JudgedStudy& study, const std::vector<Comparison>& rows) {
  std::vector<Pair> all = pairs(study, rows, Metric::position_error_cm);
  if (all.size() < 2 || all[0].solver != time_reference) return std::nullopt;
  const Pair first = all[0], printed_second = all[1];
  const std::vector<Standing> ours = standings(all, our_mean);
  const Standing& other = ours[0].solver == first.solver ? ours[1] : ours[0];
  const Evidence& found = study.evidence(Metric::position_error_cm);
  const Evidence found_printed = printed_evidence(all, study.plan);
  Smaller here{Verdict::holds, not_defined}, printed{Verdict::holds, not_defined};
  for (const Pair& each : all) {
    if (each.solver == first.solver) continue;
    weaken(here, smaller(judge(found, first.solver, each.solver)));
    weaken(printed, smaller(judge(found_printed, first.solver, each.solver)));
  }
  // The paper compares means, so the verdict is by the mean; what holds by the worst cases alone holds in part.
  const OtherEstimands others = other_estimands(study, first.solver);
  const bool in_part = here.verdict == Verdict::holds && !others.against.empty();
  return Claim{.statement = fmt::format("{} is the most accurate", first.solver),
               .verdict = in_part ? Verdict::in_part : here.verdict,
               .evidence = fmt::format(
                   "Mean position error {} cm; {} comes to {} cm, {} times as much{}{}. Printed: {} cm; {} {} "
                   "cm{}.{}{}{} {}",
                   short_number(first.ours.mean), other.solver, short_number(other.mean),
                   short_number(other.mean / first.ours.mean), at_most(here.p), others.against,
                   short_number(first.printed.mean), printed_second.solver, short_number(printed_second.printed.mean),
                   at_most(printed.p), how_tested(found, found_printed), others.sentences,
                   in_part ? " The claim holds by the mean, which the paper compares and which the worst cases decide, "
                             "but not by every estimand: so in part."
                           : "",
                   closest_point_by_point(study)),
               .table = "table-3",
               .printed = printed.verdict};
}

}  // namespace ikbench::slim2023
