#include "analysis/slim2023/companion_claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "analysis/inference/comparable.hpp"
#include "analysis/inference/text.hpp"
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

// The study itself or the first companion that the rule has something to say of.
std::optional<Claim> first_of(const Reported& reported,
                              const std::function<std::optional<Claim>(const StudyResults&)>& rule) {
  std::optional<Claim> claim = rule(reported.study);
  for (const StudyResults& companion : reported.companions) {
    if (!claim) claim = rule(companion);
  }
  return claim;
}

// What time_assessment says of the printed rows of Table 7 that the study has.
struct TimedRow {
  PrintedTime printed;
  TimeAssessment ours;
};
std::vector<TimedRow> timed_rows(const StudyResults& study) {
  std::vector<TimedRow> result;
  if (!std::isfinite(tolerance_cm(study))) return result;
  const std::vector<TimeAssessment> rows = assess_times(study);
  for (const PrintedTime& printed : printed_table_7(study.facts.published)) {
    const auto row = std::ranges::find(rows, fmt::format("{} bats", printed.bats), &TimeAssessment::solver);
    if (row != rows.end() && row->solves > 0) result.push_back({printed, *row});
  }
  return result;
}

std::string not_judged() { return fmt::format("Not judged, because {} (see the warnings).", times_not_judged); }

std::optional<Claim> real_time_of(const StudyResults& study, const ClaimEntry& entry) {
  const std::vector<TimedRow> rows = timed_rows(study);
  if (rows.empty() || rows.front().printed.bats != printed_table_7(study.facts.published).front().bats)
    return std::nullopt;
  const auto& [printed, row] = rows.front();
  Claim claim = begun(entry);
  claim.table = "table-7";
  if (times_are_comparable(study)) {
    claim.verdict = row.in_time == row.solves           ? Verdict::holds
                    : row.time_ms.median < real_time_ms ? Verdict::in_part
                                                        : Verdict::fails;
    claim.number = fmt::format("{} of {} in time", row.in_time, row.solves);
    claim.evidence = fmt::format(
        "Here, in C++: {} of {} targets reach {} cm in less than {} ms; median {} ms, slowest {} ms.", row.in_time,
        row.solves, tolerance_cm(study), real_time_ms, short_number(row.time_ms.median), short_number(row.time_ms.max));
  } else {
    claim.evidence = not_judged();
    claim.number = times_not_judged;
  }
  claim.evidence += fmt::format(" Printed, in MATLAB on another machine: {}.", printed_real_time(printed));
  claim.printed = printed.max_ms < real_time_ms    ? Verdict::holds
                  : printed.mean_ms < real_time_ms ? Verdict::in_part
                                                   : Verdict::fails;
  return claim;
}

std::optional<Claim> only_offline_of(const StudyResults& study, const ClaimEntry& entry) {
  std::vector<TimedRow> rows = timed_rows(study);
  if (rows.size() < 2) return std::nullopt;
  rows.erase(rows.begin());
  std::vector<Verdict> here, in_print;
  std::string list, printed_list;
  for (const auto& [printed, ours] : rows) {
    const auto slow = [](double mean_ms) { return mean_ms >= real_time_ms ? Verdict::holds : Verdict::fails; };
    here.push_back(slow(ours.time_ms.median));
    in_print.push_back(slow(printed.mean_ms));
    list += fmt::format("{}{} {} ms", list.empty() ? "" : ", ", ours.solver, short_number(ours.time_ms.median));
    printed_list += fmt::format("{}{} ms", printed_list.empty() ? "" : ", ", short_number(printed.mean_ms));
  }
  Claim claim = begun(entry);
  claim.table = "table-7";
  const bool comparable = times_are_comparable(study);
  if (comparable) {
    claim.verdict = verdict_on(here);
    claim.number = fmt::format("{} with {}", fmt::format("{} ms", short_number(rows.back().ours.time_ms.median)),
                               rows.back().ours.solver);
  } else {
    claim.number = times_not_judged;
  }
  claim.printed = verdict_on(in_print);
  claim.evidence =
      fmt::format("{} Printed, in MATLAB on another machine: {}.",
                  comparable ? fmt::format("Here, in C++, median: {}.", list) : not_judged(), printed_list);
  return claim;
}

// Rounding is a double's step times the length that is computed.
std::optional<Claim> circle_of(const StudyResults& study, const ClaimEntry& entry) {
  constexpr double step = std::numeric_limits<double>::epsilon(), order = 10;
  const std::vector<PrintedPosture> postures = printed_table_8(study.facts.published);
  if (!is_circle(study) || study.solves.empty() || postures.empty()) return std::nullopt;
  std::vector<double> printed, ours;
  for (const PrintedPosture& posture : postures) printed.push_back(posture.error_cm);
  for (const Solve& solve : solves_of(study, study.solvers.front())) ours.push_back(solve.position_error_cm);
  if (ours.empty()) return std::nullopt;
  const double farthest_cm = farthest_target_cm(study), rounding = step * farthest_cm;
  const auto verdict_of = [&](double error) { return error <= order * rounding ? Verdict::holds : Verdict::fails; };
  Claim claim = begun(entry);
  claim.table = "table-8";
  claim.verdict = verdict_of(mean(ours));
  claim.printed = verdict_of(mean(printed));
  claim.number = fmt::format("{} cm", short_number(mean(ours)));
  claim.evidence = fmt::format(
      "Mean error {} cm over {} points; printed {} cm. Rounding level: {} cm (2^-52 of {} cm, the farthest target) "
      "times at most {}.",
      short_number(mean(ours)), ours.size(), short_number(mean(printed)), short_number(rounding),
      short_number(farthest_cm), order);
  return claim;
}

}  // namespace

std::optional<Claim> real_time(const Reported& reported, const ClaimEntry& entry) {
  return first_of(reported, [&](const StudyResults& study) { return real_time_of(study, entry); });
}

std::optional<Claim> only_offline(const Reported& reported, const ClaimEntry& entry) {
  return first_of(reported, [&](const StudyResults& study) { return only_offline_of(study, entry); });
}

std::optional<Claim> circle(const Reported& reported, const ClaimEntry& entry) {
  return first_of(reported, [&](const StudyResults& study) { return circle_of(study, entry); });
}

Claim untested(const ClaimEntry& entry) {
  Claim claim = begun(entry);
  claim.verdict = Verdict::untested;
  claim.table = "";
  claim.evidence = fmt::format("What would decide it: {}", entry.decides);
  if (!entry.study.empty())
    claim.evidence += fmt::format(" `ikbench reproduce` runs the study for it ({}).", entry.study);
  return claim;
}

}  // namespace ikbench::slim2023
