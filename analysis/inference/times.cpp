#include "analysis/inference/times.hpp"

#include <fmt/format.h>

#include <vector>

#include "analysis/inference/comparable.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/statistics/descriptive.hpp"

namespace ikbench::inference {

using namespace statistics;

namespace {

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

// The usual time of a solve whose own stands out [s]; else not defined.
double usual_seconds(const StudyResults& study, const std::vector<double>& paces, const Solve& solve) {
  if (solve.is_repeated || !has_pace(study, solve)) return not_defined;
  const double usual = paces[solve.solver] * static_cast<double>(solve.evaluations);
  return seconds_of(study, solve) > much_longer * usual ? usual : not_defined;
}

}  // namespace

StudyResults at_median_speed(StudyResults study) {
  study.seconds_per_evaluation = seconds_per_evaluation_of(study);
  return study;
}

ValueOf undisturbed_seconds(const StudyResults& study) {
  return [&study, paces = seconds_per_evaluation_of(study)](const Solve& solve) {
    const double usual = usual_seconds(study, paces, solve);
    return std::isnan(usual) ? value_of(study, solve, Metric::seconds) : usual;
  };
}

Doubts load_doubts(const StudyResults& study) {
  constexpr double many = 0.05;  // share of a solver's solves
  bool is_loaded = false;
  double count = 0;
  for (const std::string& solver : study.solve_data->labels) {
    const double uneven = solver_facts(study, solver).uneven_repeats;
    const auto solves = static_cast<double>(solves_of(study, solver).size());
    is_loaded = is_loaded || (uneven > 1 && uneven > many * solves);
    count += uneven;
  }
  if (!is_loaded) return {};
  return {{.kind = DoubtKind::machine_loaded,
           .count = count,
           .of = static_cast<double>(study.solves.size()),
           .other = much_longer}};
}

Doubts outlier_doubts(const StudyResults& study) {
  constexpr double ms_per_second = 1000;
  const std::vector<double> paces = seconds_per_evaluation_of(study);
  Doubt slow{.kind = DoubtKind::slow_solves, .of = static_cast<double>(study.solves.size()), .other = much_longer};
  for (const Solve& solve : study.solves) {
    const double usual = ms_per_second * usual_seconds(study, paces, solve);
    if (std::isnan(usual)) continue;
    ++slow.count;
    const double took = ms_per_second * seconds_of(study, solve);
    if (slow.count > 1 && took / usual <= slow.value / slow.limit) continue;
    slow.value = took;
    slow.limit = usual;
    slow.what = fmt::format("{}, run {}, point {}", one_line(solver_of(study, solve)), solve.run, solve.point);
  }
  return slow.count > 0 ? Doubts{slow} : Doubts{};
}

}  // namespace ikbench::inference
