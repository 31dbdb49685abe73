#include "analysis/slim2023/ranking_claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

#include "analysis/inference/convergence.hpp"
#include "analysis/inference/ranking.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/slim2023/claim_comparison.hpp"

namespace ikbench::slim2023 {

using namespace results;
using namespace statistics;
using namespace inference;
using namespace report;

namespace {

double our_mean(const Pair& pair) { return pair.ours.mean; }
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

// How our ranking stands to the printed one: holds when every pair stands in the same order, in part when the first is
// the same or most of the pairs that are not tied stand. Times that are not comparable are not ranked.
struct Held {
  Verdict verdict = Verdict::undecided;
  std::string evidence;
};
Held held_against_printed(const StudyResults& study, const std::vector<Pair>& pairs, const Ranked& what) {
  if (what.metric == Metric::seconds && !times_are_comparable(study))
    return {.evidence = fmt::format("Here: not ranked, because {} (see the warnings).", times_not_judged)};
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
                                                                               : Verdict::fails,
          .evidence = fmt::format("Here: {}. {}; first is {}{}.", list, printed_order_words(order), first_words(ours),
                                  same_first ? ", as printed" : "")};
}

// The printed ranking. On the printed numbers it holds when all pairs differ, in part when the first two do.
std::optional<Claim> ranking(const StudyResults& study, const std::vector<Comparison>& rows, const Ranked& what) {
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
  return Claim{.statement = fmt::format("{}: {}", what.name, order_words(standings(printed, printed_mean))),
               .verdict = here.verdict,
               .evidence = fmt::format("{} Printed: {} of {} pairs differ by {}; {} and {} {}{}.", here.evidence,
                                       differ, all, pair_test_words(tested), printed[0].solver, printed[1].solver,
                                       first_two.verdict == Verdict::holds ? "differ" : "do not differ significantly",
                                       in_brackets(first_two.p)),
               .table = "table-3",
               .printed = differ == all                         ? Verdict::holds
                          : first_two.verdict == Verdict::holds ? Verdict::in_part
                                                                : Verdict::undecided};
}

}  // namespace

std::optional<Claim> accuracy(const StudyResults& study, const std::vector<Comparison>& rows) {
  return ranking(study, rows, {Metric::position_error_cm, "Accuracy", "cm"});
}

std::optional<Claim> computing_time(const StudyResults& study, const std::vector<Comparison>& rows) {
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
  return Claim{.statement = fmt::format("{} is the most accurate", first.solver),
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

}  // namespace ikbench::slim2023
