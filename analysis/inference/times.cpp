#include "analysis/inference/times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

#include "analysis/inference/definition.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/statistics/descriptive.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

constexpr double outlying = 3;   // times as long as usual
constexpr double loaded = 0.05;  // share of a solver's solves that stand out
constexpr double ms_per_second = 1000;

// With an answer, and evaluations that somebody counted.
bool has_pace(const StudyResults& study, const SolveRecord& solve) {
  return value_of(study, solve, Metric::evaluations) > 0 && solve.seconds > 0 && std::isfinite(solve.seconds);
}

// Median seconds per evaluation of each solver.
std::map<std::string, double> paces_of(const StudyResults& study) {
  std::map<std::string, std::vector<double>> all;
  for (const SolveRecord& solve : study.solves) {
    if (has_pace(study, solve)) all[solve.solver].push_back(solve.seconds / static_cast<double>(solve.evaluations));
  }
  std::map<std::string, double> medians;
  for (const auto& [solver, paces] : all) medians[solver] = median(paces);
  return medians;
}

struct Outliers {
  int solves = 0;
  std::map<std::string, int> of_solver = {};
  const SolveRecord* worst = nullptr;
  double seconds = 0;  // of the worst: its longest time, and the usual one
  double usual = 0;
};

Outliers outliers_of(const StudyResults& study) {
  const std::map<std::string, double> paces = paces_of(study);
  Outliers found;
  for (const SolveRecord& solve : study.solves) {
    const bool is_repeated = solve.repeats > 1 && solve.smallest_seconds > 0;
    if (!is_repeated && !has_pace(study, solve)) continue;
    const double usual =
        is_repeated ? solve.smallest_seconds : paces.at(solve.solver) * static_cast<double>(solve.evaluations);
    const double longest = std::fmax(solve.seconds, solve.largest_seconds);
    if (!(longest > outlying * usual)) continue;
    ++found.solves;
    ++found.of_solver[solve.solver];
    if (found.worst != nullptr && longest / usual <= found.seconds / found.usual) continue;
    found.worst = &solve;
    found.seconds = longest;
    found.usual = usual;
  }
  return found;
}

std::string machine_words(const StudyResults& study) {
  double interruptions = 0;
  bool is_known = false;
  for (const SolveRecord& solve : study.solves) {
    if (!std::isfinite(solve.interruptions)) continue;
    is_known = true;
    interruptions += solve.interruptions;
  }
  std::string words;
  if (is_known) words += fmt::format(" The system interrupted the solves {} times.", interruptions);
  if (std::isfinite(study.stolen_seconds)) {
    words += fmt::format(" Meanwhile the host kept {} s of processor time from this machine.",
                         rounded_number(study.stolen_seconds, 3));
  }
  return words;
}

std::string note_on(const Outliers& found, const StudyResults& study) {
  if (found.solves == 0) return "";
  const bool is_repeated = found.worst->repeats > 1;
  return fmt::format(
      "{} of {} solves took more than {} times as long as usual{}. The worst is {}, run {}, point {}: {} ms instead of "
      "{} ms.{} Medians and ranks judge the times, so such a solve decides nothing.",
      found.solves, study.solves.size(), outlying, is_repeated ? " in one of their repeats" : "",
      one_line(found.worst->solver), found.worst->run, found.worst->point,
      rounded_number(ms_per_second * found.seconds, 3), rounded_number(ms_per_second * found.usual, 3),
      machine_words(study));
}

}  // namespace

StudyResults at_median_speed(StudyResults study) {
  const std::map<std::string, double> paces = paces_of(study);
  for (SolveRecord& solve : study.solves) {
    if (!has_pace(study, solve)) continue;
    const double seconds = paces.at(solve.solver) * static_cast<double>(solve.evaluations);
    solve.cpu_seconds *= seconds / solve.seconds;
    solve.seconds = seconds;
  }
  return study;
}

std::string speed_note(const StudyResults& study) {
  const std::string uncounted = uncounted_note(study);
  return uncounted.empty() ? std::string(median_speed_words)
                           : fmt::format("{} {} Their times are as measured.", median_speed_words, uncounted);
}

std::string outliers_note(const StudyResults& study) { return note_on(outliers_of(study), study); }

std::string repeats_note(const StudyResults& study) {
  const Definition definition(study.definition);
  const double defined = definition.number("/repeats");
  if (!std::isfinite(defined) || definition.number("/stop/seconds") > 0) return "";  // those are made once
  std::int64_t others = 0;
  int fewest = std::numeric_limits<int>::max(), most = 0;
  for (const SolveRecord& solve : study.solves) {
    if (solve.timing != Timing::clean || solve.repeats == defined) continue;
    ++others;
    fewest = std::min(fewest, solve.repeats);
    most = std::max(most, solve.repeats);
  }
  if (others == 0) return "";
  return fmt::format("{} of {} solves were timed by another definition of the study: {} repeats each instead of {}.",
                     others, study.solves.size(),
                     fewest == most ? fmt::format("{}", most) : fmt::format("{} to {}", fewest, most), defined);
}

std::string load_warning(const StudyResults& study) {
  const Outliers found = outliers_of(study);
  const bool is_loaded = std::ranges::any_of(found.of_solver, [&](const auto& own) {
    return own.second > 1 &&
           own.second > loaded * static_cast<double>(std::ranges::count(study.solves, own.first, &SolveRecord::solver));
  });
  return is_loaded ? "The machine was loaded. " + note_on(found, study) : "";
}

}  // namespace ikbench::inference
