#include "analysis/inference/variants.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <stdexcept>
#include <utility>

#include "analysis/inference/comparable.hpp"
#include "analysis/inference/estimand.hpp"
#include "analysis/inference/make_study.hpp"
#include "analysis/inference/variant_decision.hpp"
#include "analysis/inference/variant_design.hpp"
#include "analysis/inference/variant_differences.hpp"

namespace ikbench::inference {

using namespace results;

namespace {

// Where none is named: of poses the orientation too.
std::vector<Metric> by_default(const std::vector<VariantPair>& pairs) {
  std::vector<Metric> result = compared_metrics();
  const auto is_of_poses = [](const VariantPair& pair) { return pair.a.study.facts.pose; };
  if (std::ranges::any_of(pairs, is_of_poses)) result.insert(result.begin() + 1, Metric::orientation_error_deg);
  return result;
}

// In the order in which they were asked for, once each.
std::vector<Metric> chosen(std::span<const std::string> names) {
  const std::vector<Metric> all = all_metrics();
  const auto column = [](Metric metric) { return name_of(metric); };
  std::vector<Metric> result;
  for (const std::string& name : names) {
    const auto found = std::ranges::find(all, name, column);
    if (found == all.end()) {
      std::vector<std::string_view> known;
      for (const Metric metric : all) known.push_back(name_of(metric));
      throw std::invalid_argument(
          fmt::format("unknown metric \"{}\" (there are: {})", name.substr(0, 100), fmt::join(known, ", ")));
    }
    if (std::ranges::find(result, *found) == result.end()) result.push_back(*found);
  }
  return result;
}

void note_missing_runs(VariantComparison& comparison, const Variant& side, std::string_view name, int used) {
  if (const int all = side.study.runs; used < all) {
    comparison.notes.push_back(
        fmt::format("{}: {} of {} runs are left out, because they or their partners are missing or incomplete.", name,
                    all - used, all));
  }
}

// One observation has no variation, so that nothing is tested.
void note_single(VariantComparison& comparison, const VariantDesign& design) {
  for (const auto& [name, observed] : {std::pair("A", &design.a), std::pair("B", &design.b)}) {
    if (observed->size() != 1) continue;
    comparison.notes.push_back(
        fmt::format("{} has a single run, which shows no variation; use more runs (--set runs=20).", name));
  }
}

// "3 of B's 16 (crashed 1, timed_out 2)"
std::string failures_of(const Variant& side, std::string_view name) {
  int solves = 0, failures = 0;
  std::vector<std::string> kinds;
  for (const SolverCounts& count : counts(side.study)) {
    solves += count.solves;
    for (const Status status : shown_statuses(side.study)) {
      if (!is_without_answer(status) || count.of(status) == 0) continue;
      failures += count.of(status);
      kinds.push_back(fmt::format("{} {}", name_of(status), count.of(status)));
    }
  }
  if (kinds.empty()) return fmt::format("none of {}'s {}", name, solves);
  return fmt::format("{} of {}'s {} ({})", failures, name, solves, fmt::join(kinds, ", "));
}

void note_failures(VariantComparison& comparison, const Variant& a, const Variant& b) {
  const auto has_failed = [](const Solve& solve) { return is_without_answer(solve.status); };
  if (std::ranges::none_of(a.study.solves, has_failed) && std::ranges::none_of(b.study.solves, has_failed)) return;
  comparison.notes.push_back(
      fmt::format("Solves without an answer: {}; {}.", failures_of(a, "A"), failures_of(b, "B")));
}

bool are_counted(const StudyResults& study) {
  return std::ranges::find(study.solves, CountedBy::nobody, &Solve::counted_by) == study.solves.end();
}

std::string repeats_note(std::string_view side) {
  return fmt::format(
      "{} gave the same answers in every run, so its runs are one observation. No test compares it with runs that "
      "differ.",
      side);
}

VariantComparison examined(const VariantPair& pair, const std::vector<Metric>& asked, const MarginQuestion& question,
                           std::size_t tests) {
  const auto& [a, b] = pair;
  const VariantDesign design = variant_design(a, b);
  StudyResults study_of_b = b.study;  // judged as A's is
  study_of_b.plan = a.study.plan;
  study_of_b.facts = a.study.facts;
  const bool is_of_targets = design.pairs == Blocks::drawn_targets || design.pairs == Blocks::path_targets;
  VariantComparison comparison{.label = a.series.label == b.series.label
                                            ? b.series.label
                                            : fmt::format("{} against {}", b.series.label, a.series.label),
                               .paired = design.pairs != Blocks::none,
                               .design = sentence_of(design, a.study.points)};
  const std::string why_not_timed = why_times_differ(a, b);
  const bool is_counted = are_counted(a.study) && are_counted(b.study);
  const std::string why_not_counted = why_counts_differ(a, b);
  // All solves of two may succeed, and be different solves: of shares, the errors have to be the same too.
  const auto is_same = [&](Metric metric) {
    const auto has_same = [&](Metric one) { return has_same_bits(a.study, study_of_b, design, one); };
    return has_same(metric) && (info_of(metric).kind != Kind::share || has_same(Metric::position_error_cm));
  };
  const bool a_repeats = design.pairs == Blocks::none && repeats_itself(a.study, a.series.label),
             b_repeats = design.pairs == Blocks::none && repeats_itself(b.study, b.series.label);
  for (const Metric metric : asked) {
    const double limit = is_penalised(a.study, metric) ? std::max(limit_of(a.study, metric), limit_of(b.study, metric))
                                                       : statistics::not_defined;
    const std::vector<double> of_a = values_of(a.study, design.a, metric, limit);
    const std::vector<double> of_b = values_of(study_of_b, design.b, metric, limit);
    // Where one of the two has a single value, however often it repeats it, no test holds it against runs that differ.
    const bool a_is_one = a_repeats && is_constant(statistics::describe(of_a)),
               b_is_one = b_repeats && is_constant(statistics::describe(of_b));
    const std::string why_not = info_of(metric).kind == Kind::time ? why_not_timed
                                : metric == Metric::evaluations    ? why_not_counted
                                : a_is_one != b_is_one             ? repeats_note(a_is_one ? "A" : "B")
                                                                   : "";
    comparison.metrics.push_back(compare_metric({.metric = metric,
                                                 .a = of_a,
                                                 .b = of_b,
                                                 .observation = is_of_targets ? "target" : "run",
                                                 .paired = comparison.paired,
                                                 .same_bits = is_same(metric),
                                                 .are_copies = a_is_one && b_is_one,
                                                 .tests = static_cast<int>(tests),
                                                 .not_compared = why_not.empty() ? "" : "see below",
                                                 .is_counted = is_counted || metric != Metric::evaluations},
                                                question));
    if (!why_not.empty() && std::ranges::find(comparison.notes, why_not) == comparison.notes.end())
      comparison.notes.push_back(why_not);
  }
  if (std::ranges::any_of(asked, [&](Metric metric) { return is_penalised(a.study, metric); })) {
    comparison.notes.push_back(fmt::format(
        "A cost of a solve that is not ok counts {:g} times the limit, the study's or that of the dearest solve (PAR10).",
        penalty));
  }
  note_failures(comparison, a, b);
  note_single(comparison, design);
  note_missing_runs(comparison, a, "A", design.runs_of_a);
  note_missing_runs(comparison, b, "B", design.runs_of_b);
  if (std::ranges::find(asked, Metric::solved) != asked.end() && !std::isfinite(tolerance_cm(a.study))) {
    comparison.notes.emplace_back(
        "solved: the study has no tolerance, so ok means inside the joint limits, however far from the target.");
  }
  comparison.notes.push_back(differences(a, b));
  return comparison;
}

}  // namespace

std::vector<Variant> variants(const Store& store, const StudyEntry& study) {
  const StudyResults whole = read_study(store, study);
  const std::vector<Session> sessions = store.sessions();
  std::vector<Variant> result;
  for (const Series& series : study.series) {
    const auto is_this = [&](std::string_view solver) { return solver == series.label; };
    Variant variant{.series = series, .study = of_solvers(whole, is_this), .timing = timing_note(whole, series.label)};
    const SolvesOfSessions used = solves_of_sessions(variant.study);
    for (const Session& session : sessions) {
      if (used.contains(session.id)) variant.sessions.push_back(session);
    }
    result.push_back(std::move(variant));
  }
  return result;
}

std::vector<VariantComparison> examine_variants(const std::vector<VariantPair>& pairs,
                                                std::span<const std::string> metrics, const MarginQuestion& question) {
  const std::vector<Metric> asked = metrics.empty() ? by_default(pairs) : chosen(metrics);
  std::vector<VariantComparison> result;
  for (const VariantPair& pair : pairs) result.push_back(examined(pair, asked, question, asked.size() * pairs.size()));
  return result;
}

std::vector<VariantComparison> compare_variants(const std::vector<VariantPair>& pairs,
                                                std::span<const std::string> metrics, const MarginQuestion& question) {
  std::vector<VariantComparison> result = examine_variants(pairs, metrics, question);
  decide(result, question);
  return result;
}

int count(std::span<const VariantComparison> comparisons, Outcome outcome) {
  std::int64_t result = 0;
  for (const VariantComparison& comparison : comparisons) {
    result += std::ranges::count(comparison.metrics, outcome, &MetricComparison::outcome);
  }
  return static_cast<int>(result);
}

}  // namespace ikbench::inference
