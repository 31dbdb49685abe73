#include "analysis/slim2023/claim_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/inference/comparable.hpp"
#include "analysis/inference/deciding.hpp"
#include "analysis/inference/design.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/assessment_words.hpp"
#include "analysis/report/provenance.hpp"
#include "analysis/slim2023/published_numbers.hpp"

namespace ikbench::slim2023 {

using namespace results;
using namespace statistics;
using namespace inference;
using namespace report;

namespace {

// Those observations of which a claim takes the solvers; of one opponent those two alone.
void keep(Observations& observed, const ClaimEntry& entry) {
  if (entry.against.empty()) return;
  std::erase_if(observed.groups,
                [&](const Group& group) { return group.name != entry.solver && group.name != entry.against; });
}

// The solver's numbers from the one, the others' from the other: they share no block.
Observations mixed(Observations of_solver, Observations of_others, const std::string& solver) {
  std::erase_if(of_others.groups, [&](const Group& group) { return group.name == solver; });
  for (Group& group : of_solver.groups) {
    if (group.name == solver) of_others.groups.insert(of_others.groups.begin(), std::move(group));
  }
  of_others.blocks.clear();
  of_others.block.clear();
  if (of_others.flaw.empty()) of_others.flaw = of_solver.flaw;
  return of_others;
}

}  // namespace

Claim begun(const ClaimEntry& entry) {
  return {.statement = entry.sentence,
          .verdict = Verdict::undecided,
          .evidence = "",
          .table = "table-3",
          .id = entry.id,
          .section = entry.section,
          .by = entry.by,
          .decides = entry.decides};
}

std::vector<Pair> pairs(const StudyResults& study, Metric metric) {
  std::vector<Pair> result;
  for (const Sample& sample : samples(study, metric)) {
    const std::optional<PrintedRow> printed = printed_row(study, sample.solver, metric);
    if (printed && !sample.values.empty()) {
      result.push_back({sample.solver, describe(sample.values), printed->summary});
    }
  }
  std::ranges::stable_sort(result, {}, [](const Pair& pair) { return pair.printed.mean; });
  return result;
}

Evidence printed_evidence(const std::vector<Pair>& pairs, const AnalysisPlan& plan) {
  Summaries printed;
  for (const Pair& pair : pairs) printed.groups.push_back({pair.solver, pair.printed});
  return evidence(printed, feasible(plan, printed));
}

const JudgedStudy* companion_of(const Reported& reported, const ClaimEntry& entry) {
  for (const JudgedStudy& companion : reported.companions) {
    if (companion.name == reported.study.name + '-' + entry.study && same_targets(reported.study, companion)) {
      return &companion;
    }
  }
  return nullptr;
}

std::optional<Evidence> evidence_for(const Reported& reported, const ClaimEntry& entry, Metric metric) {
  const JudgedStudy& study = reported.study;
  const JudgedStudy* const companion = companion_of(reported, entry);
  if (!entry.study.empty() && companion == nullptr) return std::nullopt;
  const JudgedStudy& of_solver = companion != nullptr && entry.take != Take::others ? *companion : study;
  const JudgedStudy& of_others = companion != nullptr && entry.take != Take::solver ? *companion : study;
  std::optional<Evidence> found;
  if (&of_solver == &of_others && entry.against.empty()) {
    found = of_solver.evidence(metric);
  } else {
    Observations observed = &of_solver == &of_others
                                ? observations(of_solver, metric)
                                : mixed(observations(of_solver, metric), observations(of_others, metric), entry.solver);
    keep(observed, entry);
    AnalysisPlan plan = feasible(study.plan, observed);
    if (std::ranges::find(observed.groups, plan.control, &Group::name) == observed.groups.end()) plan.control.clear();
    const bool comparable = is_comparable(of_solver, metric) && is_comparable(of_others, metric);
    found = comparable ? tested(observed, plan) : described(observed, plan);
  }
  const auto is_solver = [&](const GroupEvidence& group) { return group.name == entry.solver; };
  const auto is_empty = [](const GroupEvidence& group) { return group.described.n == 0; };
  const bool complete = found->groups.size() >= 2 && std::ranges::any_of(found->groups, is_solver) &&
                        std::ranges::none_of(found->groups, is_empty);
  return complete ? found : std::nullopt;
}

void Found::add(Relation answer) {
  better += answer == Relation::better ? 1 : 0;
  worse += answer == Relation::worse ? 1 : 0;
  open += is_difference(answer) ? 0 : 1;
}

Verdict verdict_on(const Found& found) {
  if (found.worse > 0) return Verdict::fails;
  if (found.open == 0) return Verdict::holds;
  return found.better > 0 ? Verdict::in_part : Verdict::undecided;
}

Verdict verdict_on(const std::vector<Verdict>& verdicts) {
  const auto count = [&](Verdict verdict) { return static_cast<std::size_t>(std::ranges::count(verdicts, verdict)); };
  if (count(Verdict::holds) == verdicts.size()) return Verdict::holds;
  if (count(Verdict::holds) + count(Verdict::in_part) > 0) return Verdict::in_part;
  return count(Verdict::fails) > 0 ? Verdict::fails : Verdict::undecided;
}

Against against(const Evidence& evidence, const std::string& solver, Should should) {
  Against result;
  const double sign = should == Should::be_smallest ? 1 : -1;
  for (const GroupEvidence& group : evidence.groups) {
    if (group.name == solver) {
      result.own_mean = group.described.mean;
      continue;
    }
    const Judgement found = sign > 0 ? judge(evidence, solver, group.name) : judge(evidence, group.name, solver);
    result.found.add(found.relation);
    if (std::isfinite(found.p)) result.p = std::isfinite(result.p) ? std::max(result.p, found.p) : found.p;
    const double mean = group.described.mean;
    if (!std::isfinite(result.nearest_mean) || sign * mean < sign * result.nearest_mean) {
      result.nearest = group.name;
      result.nearest_mean = mean;
    }
  }
  return result;
}

std::string in_brackets(double p) { return std::isfinite(p) ? fmt::format(" ({})", p_words(p)) : ""; }

std::string how_tested(const Evidence& here, const Evidence& printed) {
  const std::string_view test = pair_test_words(here), other = pair_test_words(printed);
  if (here.plan.unit == Unit::point)
    return fmt::format(" No test here, because points of one run depend on each other; printed p-values: {}.", other);
  const std::string of_printed = test == other ? "" : fmt::format("; printed: {}", other);
  return fmt::format(" p-values: {} on run means, adjusted for all pairs{}.", test, of_printed);
}

}  // namespace ikbench::slim2023
