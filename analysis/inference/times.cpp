#include "analysis/inference/times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "analysis/inference/text.hpp"
#include "analysis/statistics/descriptive.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

constexpr double outlying = 3;   // times as long as usual
constexpr double loaded = 0.05;  // share of solves that stand out
constexpr double ms_per_second = 1000;

bool has_pace(const SolveRecord& solve) {
  return solve.evaluations > 0 && solve.seconds > 0 && std::isfinite(solve.seconds);
}

// Median seconds per evaluation of each solver.
std::map<std::string, double> paces_of(const StudyResults& study) {
  std::map<std::string, std::vector<double>> all;
  for (const SolveRecord& solve : study.solves) {
    if (has_pace(solve)) all[solve.solver].push_back(solve.seconds / static_cast<double>(solve.evaluations));
  }
  std::map<std::string, double> medians;
  for (const auto& [solver, paces] : all) medians[solver] = median(paces);
  return medians;
}

struct Outliers {
  int solves = 0;
  const SolveRecord* worst = nullptr;
  double seconds = 0;  // of the worst: its longest time, and the usual one
  double usual = 0;
};

Outliers outliers_of(const StudyResults& study) {
  const std::map<std::string, double> paces = paces_of(study);
  Outliers found;
  for (const SolveRecord& solve : study.solves) {
    if (!has_pace(solve)) continue;
    const double usual = solve.repeats > 1 && solve.smallest_seconds > 0
                             ? solve.smallest_seconds
                             : paces.at(solve.solver) * static_cast<double>(solve.evaluations);
    const double longest = std::fmax(solve.seconds, solve.largest_seconds);
    if (!(longest > outlying * usual)) continue;
    ++found.solves;
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
    if (!has_pace(solve)) continue;
    const double seconds = paces.at(solve.solver) * static_cast<double>(solve.evaluations);
    solve.cpu_seconds *= seconds / solve.seconds;
    solve.seconds = seconds;
  }
  return study;
}

std::string outliers_note(const StudyResults& study) { return note_on(outliers_of(study), study); }

std::string load_warning(const StudyResults& study) {
  const Outliers found = outliers_of(study);
  const bool is_loaded = found.solves > 1 && found.solves > loaded * static_cast<double>(study.solves.size());
  return is_loaded ? "The machine was loaded. " + note_on(found, study) : "";
}

}  // namespace ikbench::inference
