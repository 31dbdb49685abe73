#include "analysis/slim2023/companion_claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/inference/text.hpp"
#include "analysis/report/provenance.hpp"
#include "analysis/slim2023/circle.hpp"
#include "analysis/slim2023/claim_comparison.hpp"
#include "analysis/slim2023/published_numbers.hpp"
#include "analysis/slim2023/time_assessment.hpp"

namespace ikbench::slim2023 {

using namespace results;
using namespace statistics;
using namespace inference;
using namespace report;

namespace {

GroupSummary summary_of(const Description& of) { return {.mean = of.mean, .std = of.std, .n = of.n}; }

}  // namespace

// Table 7's first row, as time_assessment judges it.
std::optional<Claim> real_time(const StudyResults& study) {
  const std::vector<PrintedTime> all_printed = printed_table_7(study.published);
  if (all_printed.empty() || !std::isfinite(tolerance_cm(study))) return std::nullopt;
  const PrintedTime printed = all_printed.front();
  const std::vector<TimeAssessment> rows = assess_times(study);
  const auto row = std::ranges::find(rows, fmt::format("{} bats", printed.bats), &TimeAssessment::solver);
  if (row == rows.end() || row->solves == 0) return std::nullopt;
  const bool comparable = times_are_comparable(study);
  const std::string here =
      comparable
          ? fmt::format("Here, in C++: {} of {} targets reach {} cm in less than {} ms; median {} ms, slowest {} ms.",
                        row->in_time, row->solves, tolerance_cm(study), real_time_ms, short_number(row->time_ms.median),
                        short_number(row->undisturbed_ms.max))
          : fmt::format("Not judged, because {} (see the warnings).", times_not_judged);
  return Claim{
      .statement = fmt::format("With {} bats IK-BA answers in real time", printed.bats),
      .verdict = !comparable                               ? Verdict::undecided
                 : row->in_time == row->solves             ? Verdict::holds
                 : row->undisturbed_ms.max >= real_time_ms ? Verdict::fails
                                                           : Verdict::in_part,
      .evidence = fmt::format("{} Printed, in MATLAB on another machine: {}.", here, printed_real_time(printed)),
      .table = "table-7",
      .printed = printed.max_ms < real_time_ms    ? Verdict::holds
                 : printed.mean_ms < real_time_ms ? Verdict::in_part
                                                  : Verdict::fails};
}

// Table 8: errors of the order of rounding, which is a double's step times the length that is computed.
std::optional<Claim> circle(const StudyResults& study) {
  constexpr double step = std::numeric_limits<double>::epsilon(), order = 10;
  const std::vector<PrintedPosture> postures = printed_table_8(study.published);
  if (!is_circle(study) || study.solves.empty() || postures.empty()) return std::nullopt;
  std::vector<double> printed, ours;
  for (const PrintedPosture& posture : postures) printed.push_back(posture.error_cm);
  for (const SolveRecord& solve : study.solves) {
    if (solve.solver == study.solvers.front()) ours.push_back(solve.position_error_cm);
  }
  if (ours.empty()) return std::nullopt;
  const double farthest_cm = farthest_target_cm(study), rounding = step * farthest_cm;
  const auto verdict_of = [&](double error) { return error <= order * rounding ? Verdict::holds : Verdict::fails; };
  return Claim{.statement = "IK-BA moves the Dobot Magician along a circle with an error at rounding level",
               .verdict = verdict_of(mean(ours)),
               .evidence = fmt::format("Mean error {} cm over {} points; printed {} cm. Rounding level: {} cm (2^-52 "
                                       "of {} cm, the farthest target) times at most {}.",
                                       short_number(mean(ours)), ours.size(), short_number(mean(printed)),
                                       short_number(rounding), short_number(farthest_cm), order),
               .table = "table-8",
               .printed = verdict_of(mean(printed))};
}

// The study with limits enforced.
std::optional<Claim> accurate_inside_limits(const StudyResults& study, const JudgedStudy& limits) {
  if (!enforces_limits(limits) || enforces_limits(study) || !same_targets(study, limits)) return std::nullopt;
  const auto ours = description(limits, time_reference, Metric::position_error_cm);
  const auto before = description(study, time_reference, Metric::position_error_cm);
  std::optional<Description> best;
  std::vector<std::string> others;
  std::string best_solver, refused;
  for (const SolverCounts& count : counts(limits)) {
    refused += fmt::format("{}{} {} of {}", refused.empty() ? "" : ", ", count.solver, count.of(Status::refused),
                           count.solves);
    const auto other = description(limits, count.solver, Metric::position_error_cm);
    if (count.solver == time_reference || !other) continue;
    others.push_back(count.solver);
    if (!std::isfinite(other->mean)) continue;
    if (best && best->mean <= other->mean) continue;
    best = other;
    best_solver = count.solver;
  }
  if (!ours || !before || !best) return std::nullopt;
  Smaller here{Verdict::holds, not_defined};
  const Evidence& found = limits.evidence(Metric::position_error_cm);
  for (const std::string& other : others) weaken(here, smaller(judge(found, time_reference, other)));
  return Claim{
      .statement = fmt::format("With enforced joint limits, {} is still the most accurate", time_reference),
      .verdict = here.verdict,
      .evidence = fmt::format("Mean position error {} cm ({} cm without); {} comes to {} cm, {} times as much{}.{} "
                              "Refused answers: {}.",
                              short_number(ours->mean), short_number(before->mean), best_solver,
                              short_number(best->mean), short_number(best->mean / ours->mean), at_most(here.p),
                              study.plan.unit == Unit::run ? how_tested(found, found) : "", refused),
      .table = "limits"};
}

// A solver of the textbooks on the same targets, in error, variation and evaluations.
std::optional<Claim> better_than_classical(const StudyResults& study, const StudyResults& context) {
  constexpr std::string_view classical = "DLS";  // damped least squares
  constexpr std::array<Metric, 3> metrics{Metric::position_error_cm, Metric::variation_deg, Metric::evaluations};
  constexpr std::array<std::string_view, 3> words{"cm of mean position error", "deg of variation", "evaluations"};
  if (!same_targets(study, context)) return std::nullopt;
  int better = 0, worse = 0;
  std::string list, test;
  for (std::size_t i = 0; i < metrics.size(); ++i) {
    const auto ours = description(study, time_reference, metrics[i]);
    const auto other = description(context, classical, metrics[i]);
    if (!ours || !other) return std::nullopt;
    const MeanPair means{summary_of(*ours), summary_of(*other), info_of(metrics[i]).better};
    const Judgement found = study.plan.unit == Unit::run ? judge(means, study.plan) : Judgement{};
    if (!found.test.empty()) test = found.test;
    Smaller here = smaller(found);
    if (info_of(metrics[i]).kind == Kind::count && ours->mean != other->mean) {  // counted, not measured
      here = {ours->mean < other->mean ? Verdict::holds : Verdict::fails, not_defined};
    }
    if (here.verdict == Verdict::holds) ++better;
    if (here.verdict == Verdict::fails) ++worse;
    list += fmt::format("{}{} vs {} {}{}", list.empty() ? "" : ", ", short_number(ours->mean),
                        short_number(other->mean), words[i], in_brackets(here.p));
  }
  return Claim{.statement = fmt::format("{} is better than a classical solver (damped least squares)", time_reference),
               .verdict = better == static_cast<int>(metrics.size()) ? Verdict::holds
                          : better > 0                               ? Verdict::in_part
                          : worse > 0                                ? Verdict::fails
                                                                     : Verdict::undecided,
               .evidence = fmt::format("{} against {}, per point: {}.{}", time_reference, classical, list,
                                       test.empty() ? "" : fmt::format(" p-values: {} on run means.", test)),
               .table = "baselines"};
}

}  // namespace ikbench::slim2023
