#include "analysis/slim2023/study_claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "analysis/figures/figure_parts.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/slim2023/claim_comparison.hpp"
#include "analysis/slim2023/published_numbers.hpp"

namespace ikbench::slim2023 {

using namespace results;
using namespace statistics;
using namespace inference;
using namespace report;

namespace {

// The paper's solver moves the joints less than those others: as much as is true of each of them.
struct Others {
  std::vector<Pair> solvers;
  std::string words;
  const Evidence& here;
  const Evidence& printed;
};
Claim moves_less(const Pair& reference, const Others& of) {
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
  return {.statement = fmt::format("{} moves the joints less than {}", reference.solver, of.words),
          .verdict = here,
          .evidence = fmt::format("{} moves the joints by {} deg per point{}. Printed: {} {}{}.{}", reference.solver,
                                  short_number(reference.ours.mean), our_list, reference.solver,
                                  short_number(reference.printed.mean), printed_list, how_tested(of.here, of.printed)),
          .table = "table-3",
          .printed = printed};
}

}  // namespace

std::vector<Claim> variation(const JudgedStudy& study, const std::vector<Comparison>& rows) {
  const std::vector<Pair> all = pairs(study, rows, Metric::variation_deg);
  if (all.size() < 2 || all.front().solver != time_reference) return {};
  const Evidence& here = study.evidence(Metric::variation_deg);
  const Evidence printed = printed_evidence(all, study.plan);
  std::vector<Claim> result{moves_less(all[0], {{all[1]}, all[1].solver, here, printed})};
  if (all.size() > 2)
    result.push_back(moves_less(all[0], {{all.begin() + 2, all.end()}, "the other solvers", here, printed}));
  return result;
}

// As many of the metrics as are judged; times that are not comparable are not.
std::optional<Claim> solvers_differ(const StudyResults& study) {
  std::string list;
  int alike = 0, differ = 0, printed_alike = 0;
  for (const Metric metric : paper_metrics) {
    const std::optional<AnovaTable> printed = comparable_printed_anova(study, metric);
    if (!printed) return std::nullopt;
    if (!is_significant(printed->p, study.plan)) ++printed_alike;
    list += fmt::format("{}{}: ", list.empty() ? "" : "; ", figures::capitalised(info_of(metric).name));
    if (metric == Metric::seconds && !times_are_comparable(study)) {
      list += fmt::format("not tested, because {} (see the warnings)", times_not_judged);
      continue;
    }
    const AnovaTable table = anova(study, metric).table;
    if (!std::isfinite(table.p)) return std::nullopt;
    ++(is_significant(table.p, study.plan) ? differ : alike);
    list += fmt::format("F({}, {}) = {}, p = {}", table.df_between, table.df_within, short_number(table.F),
                        rounded_number(table.p, 2));
  }
  const auto verdict_of = [](int number_alike, int number_differing) {
    if (number_differing == static_cast<int>(paper_metrics.size())) return Verdict::holds;
    if (number_differing > 0) return Verdict::in_part;
    return number_alike == static_cast<int>(paper_metrics.size()) ? Verdict::fails : Verdict::undecided;
  };
  return Claim{.statement = "The solvers differ in error, variation and time (ANOVA)",
               .verdict = verdict_of(alike, differ),
               .evidence = list + ".",
               .table = "table-4",
               .printed = verdict_of(printed_alike, static_cast<int>(paper_metrics.size()) - printed_alike)};
}

std::optional<Claim> inside_limits(const StudyResults& study) {
  for (const SolverCounts& count : counts(study)) {
    if (count.solver != time_reference || count.solves == 0) continue;
    return Claim{
        .statement = fmt::format("{}'s answers are inside the joint limits (Eq. 4)", count.solver),
        .verdict = count.outside_limits == 0 ? Verdict::holds : Verdict::fails,
        .evidence = count.outside_limits == 0
                        ? fmt::format("All {} are.", count.solves)
                        : fmt::format("{} of {} are not; the worst joint is outside by {} deg.", count.outside_limits,
                                      count.solves, short_number(count.worst_outside_deg)),
        .table = "status"};
  }
  return std::nullopt;
}

}  // namespace ikbench::slim2023
