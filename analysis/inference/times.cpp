#include "analysis/inference/times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "analysis/inference/comparable.hpp"
#include "analysis/inference/study_facts.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/statistics/descriptive.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

constexpr double loaded = 0.05;  // share of a solver's solves that stand out
constexpr double ms_per_second = 1000;

// Median seconds per evaluation of each solver.
std::vector<double> seconds_per_evaluation_of(const StudyResults& study) {
  std::vector<double> medians;
  for (const std::string& solver : study.solve_data->labels) {
    std::vector<double> paces;
    for (const Solve& solve : solves_of(study, solver)) {
      if (has_pace(study, solve)) paces.push_back(seconds_of(study, solve) / static_cast<double>(solve.evaluations));
    }
    medians.push_back(median(paces));
  }
  return medians;
}

struct Outliers {
  int solves = 0;
  std::vector<int> of_solver = {};  // one per label
  std::optional<Outlier> worst = {};

  void add(const Outlier& outlier, int count) {
    solves += count;
    of_solver[outlier.solver] += count;
  }
  // Keeps the worst outlier; of equal ones the first.
  void compare(const Outlier& other) {
    const auto place = [](const Outlier& of) { return std::tuple(of.solver, of.run, of.point); };
    const double ratio = other.seconds / other.usual, most = worst ? worst->seconds / worst->usual : 0;
    if (!worst || ratio > most || (ratio == most && place(other) < place(*worst))) worst = other;
  }
};

// Usual time of a solve without repeats: its evaluations at its solver's pace [s].
double usual_seconds(const std::vector<double>& paces, const Solve& solve) {
  return paces[solve.solver] * static_cast<double>(solve.evaluations);
}

bool stands_out(double seconds, double usual) { return seconds > outlying * usual; }

// Compares a solve without repeats with its solver's pace, any other with its own repeats.
Outliers outliers_of(const StudyResults& study) {
  const std::vector<double> paces = seconds_per_evaluation_of(study);
  const SolveData& data = *study.solve_data;
  Outliers found{.of_solver = std::vector<int>(data.labels.size())};
  for (std::uint16_t i = 0; i < data.labels.size(); ++i) {
    found.add({.solver = i}, data.of_solver[i].outlying_repeats);
  }
  if (data.worst_repeat) found.worst = data.worst_repeat;
  for (const Solve& solve : study.solves) {
    if (solve.is_repeated || !has_pace(study, solve)) continue;
    const Outlier one{.solver = solve.solver,
                      .run = solve.run,
                      .point = solve.point,
                      .seconds = seconds_of(study, solve),
                      .usual = usual_seconds(paces, solve)};
    if (!stands_out(one.seconds, one.usual)) continue;
    found.add(one, 1);
    found.compare(one);
  }
  return found;
}

Doubt slow_doubt(const Outliers& found, const StudyResults& study) {
  const Outlier& worst = *found.worst;
  return {.kind = DoubtKind::slow_solves,
          .count = static_cast<double>(found.solves),
          .of = static_cast<double>(study.solves.size()),
          .other = outlying,
          .value = ms_per_second * worst.seconds,
          .limit = ms_per_second * worst.usual,
          .what = fmt::format("{}, run {}, point {}{}", one_line(study.solve_data->labels[worst.solver]), worst.run,
                              worst.point, worst.is_repeated ? ", in one of its repeats" : "")};
}

}  // namespace

StudyResults at_median_speed(StudyResults study) {
  study.seconds_per_evaluation = seconds_per_evaluation_of(study);
  return study;
}

ValueOf undisturbed_seconds(const StudyResults& study) {
  return [&study, paces = seconds_per_evaluation_of(study)](const Solve& solve) {
    const double seconds = value_of(study, solve, Metric::seconds);
    if (solve.is_repeated || !has_pace(study, solve)) return seconds;
    const double usual = usual_seconds(paces, solve);
    return stands_out(seconds, usual) ? usual : seconds;
  };
}

std::string speed_note(const StudyResults& study) {
  const std::string uncounted = words_of(left_out(study, Metric::evaluations));
  return uncounted.empty() ? std::string(median_speed_words)
                           : fmt::format("{} {} Their times are as measured.", median_speed_words, uncounted);
}

Doubts outlier_doubts(const StudyResults& study) {
  const Outliers found = outliers_of(study);
  if (found.solves == 0) return {};
  Doubts doubts{slow_doubt(found, study)};
  if (const auto& count = study.solve_data->interruptions) {
    doubts.push_back({.kind = DoubtKind::interruptions, .count = static_cast<double>(*count)});
  }
  if (std::isfinite(study.stolen_seconds)) {
    doubts.push_back({.kind = DoubtKind::stolen_time, .value = study.stolen_seconds});
  }
  return doubts;
}

Doubts repeat_doubts(const StudyResults& study) {
  const double defined = study.facts.repeats;
  if (!std::isfinite(defined) || study.facts.stop.seconds > 0) return {};  // those solves are not repeated
  std::int64_t others = 0;
  int fewest = std::numeric_limits<int>::max(), most = 0;
  for (const auto& [repeats, solves] : study.solve_data->repeats) {
    if (repeats == defined) continue;
    others += solves;
    fewest = std::min(fewest, repeats);
    most = std::max(most, repeats);
  }
  if (others == 0) return {};
  return {{.kind = DoubtKind::other_repeats,
           .count = static_cast<double>(others),
           .of = static_cast<double>(study.solves.size()),
           .value = defined,
           .what = range_words(fewest, most)}};
}

Doubts load_doubts(const StudyResults& study) {
  const Outliers found = outliers_of(study);
  bool is_loaded = false;
  for (std::size_t i = 0; i < found.of_solver.size(); ++i) {
    const std::size_t solves = solves_of(study, study.solve_data->labels[i]).size();
    is_loaded |= found.of_solver[i] > 1 && found.of_solver[i] > loaded * static_cast<double>(solves);
  }
  if (!is_loaded) return {};
  Doubt doubt = slow_doubt(found, study);
  doubt.kind = DoubtKind::machine_loaded;
  return {doubt};
}

namespace {

constexpr std::size_t fewest = 20;    // fewest solves of a solver
constexpr double least_ratio = 1.15;  // smallest ratio of the two speeds
constexpr double least_share = 0.1;   // smallest share of solves in either group
constexpr double most_between = 0.1;  // largest share of solves in the middle half between the groups' medians

struct TwoSpeeds {
  double ratio = 1;       // slow / fast
  double slow_share = 0;  // share of slow solves
};

// Logarithms of seconds per evaluation, sorted.
std::vector<double> paces_of(const StudyResults& study, const std::string& solver) {
  std::vector<double> evaluations;
  for (const Solve& solve : solves_of(study, solver)) evaluations.push_back(static_cast<double>(solve.evaluations));
  const double usual = median(evaluations);
  std::vector<double> paces;
  for (const Solve& solve : solves_of(study, solver)) {
    const auto count = static_cast<double>(solve.evaluations);
    if (solve.timing != Timing::clean || !has_pace(study, solve) || count < usual / 2) continue;
    paces.push_back(std::log(solve.seconds / count));
  }
  std::ranges::sort(paces);
  return paces;
}

// Size of the first of two groups with the largest variance between them (Otsu 1979).
std::size_t first_group(std::span<const double> sorted) {
  double all = 0;
  for (const double value : sorted) all += value;
  const auto n = static_cast<double>(sorted.size());
  double sum = 0, most = -1;
  std::size_t best = 0;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    sum += sorted[i - 1];
    const auto k = static_cast<double>(i);
    const double apart = sum / k - (all - sum) / (n - k), between = k * (n - k) * apart * apart;
    if (between <= most) continue;
    most = between;
    best = i;
  }
  return best;
}

std::optional<TwoSpeeds> two_speeds(const std::vector<double>& paces) {
  const std::span<const double> all(paces);
  const std::size_t fast = first_group(all);
  const double low = median(all.first(fast)), high = median(all.subspan(fast)), quarter = (high - low) / 4;
  const auto between =
      std::ranges::count_if(all, [&](double pace) { return pace > low + quarter && pace < high - quarter; });
  const auto n = static_cast<double>(all.size());
  const TwoSpeeds found{.ratio = std::exp(high - low), .slow_share = 1 - static_cast<double>(fast) / n};
  const bool are_two = found.ratio >= least_ratio && static_cast<double>(between) <= most_between * n &&
                       std::min(found.slow_share, 1 - found.slow_share) >= least_share;
  return are_two ? std::optional(found) : std::nullopt;
}

}  // namespace

Doubts speed_doubts(const StudyResults& study) {
  std::vector<std::string> shares;
  std::vector<double> ratios;
  for (const std::string& solver : study.solvers) {
    const std::vector<double> paces = paces_of(study, solver);
    if (paces.size() < fewest) continue;
    const std::optional<TwoSpeeds> found = two_speeds(paces);
    if (!found) return {};
    ratios.push_back(found->ratio);
    shares.push_back(fmt::format("{} {}", one_line(solver), percent(found->slow_share)));
  }
  if (shares.size() < 2) return {};
  return {{.kind = DoubtKind::two_speeds, .who = shares, .value = median(ratios)}};
}

}  // namespace ikbench::inference
