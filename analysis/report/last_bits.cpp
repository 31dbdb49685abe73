#include "analysis/report/last_bits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "analysis/inference/design.hpp"
#include "analysis/inference/metrics.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/assessment_words.hpp"
#include "analysis/report/words.hpp"
#include "analysis/statistics/descriptive.hpp"

namespace ikbench::report {

using namespace inference;
using namespace statistics;

namespace {

// exact: a statistic is the same in all copies, in the digits that a table shows. stable: it differs, but each solve
// has its status. chaotic: the status of a solve differs.
enum class Certificate { exact, stable, chaotic };
constexpr std::array<std::string_view, 3> certificate_names{"exact", "stable", "chaotic"};

// Values below the metric's rounding count as that.
double mean_of(const StudyResults& study, std::string_view solver, Metric metric) {
  const double least = info_of(metric).rounding;
  std::vector<double> values;
  for (const Solve& solve : solves_of(study, solver)) {
    const double value = value_of(study, solve, metric);
    values.push_back(value < least ? least : value);
  }
  std::erase_if(values, [](double value) { return std::isnan(value); });
  return values.empty() ? not_defined : mean(values);
}

struct Rounding {
  Certificate certificate = Certificate::exact;
  double as_solved = not_defined;
  Range range = {};
};

Rounding rounding_of(const StudyResults& study, const PerturbedCopies& copies, std::string_view solver, Metric metric) {
  const double as_solved = mean_of(study, solver, metric);
  Rounding found{.as_solved = as_solved, .range = {as_solved, as_solved}};
  for (const StudyResults& copy : copies) {
    const double other = mean_of(copy, solver, metric);
    found.range = {std::min(found.range.low, other), std::max(found.range.high, other)};
    if (readable(other) != readable(as_solved)) found.certificate = Certificate::stable;
  }
  return found;
}

// Metrics of a solve that do not depend on the machine.
std::vector<Metric> exact_metrics() {
  std::vector<Metric> metrics = reported_metrics();
  std::erase_if(metrics, [](Metric metric) { return info_of(metric).kind == Kind::time || is_of_run(metric); });
  return metrics;
}

}  // namespace

std::string name_of_copy(std::string_view study, int number) { return fmt::format("{}-perturbed-{}", study, number); }

bool is_copy_of(const StudyResults& copy, std::string_view study) {
  return copy.facts.perturbed > 0 && copy.name == name_of_copy(study, static_cast<int>(copy.facts.perturbed));
}

std::size_t changed_statuses(const StudyResults& study, const PerturbedCopies& copies, std::string_view solver) {
  std::size_t changed = 0;
  for (const Solve& solve : solves_of(study, solver)) {
    changed += std::ranges::any_of(copies, [&](const StudyResults& copy) {
      const Solve* const other = solve_at(solves_of(copy, solver), {solve.run, solve.point});
      return other != nullptr && other->status != solve.status;
    });
  }
  return changed;
}

Table last_bits_table(const StudyResults& study, const PerturbedCopies& copies) {
  Table table{.name = "last-bits",
              .caption = "What the last bits of the targets change",
              .columns = {"solver", "metric", "certificate", "mean", "smallest mean", "largest mean",
                          "solves with another status"},
              .notes = {fmt::format(words::last_bits_note, fmt::arg("copies", copies.size()))}};
  for (const std::string& solver : study.solvers) {
    const std::size_t changed = changed_statuses(study, copies, solver);
    for (const Metric metric : exact_metrics()) {
      const Rounding found = rounding_of(study, copies, solver, metric);
      if (std::isnan(found.as_solved)) continue;
      const bool is_chaotic = changed > 0 && found.certificate != Certificate::exact;
      table.rows.push_back(
          {solver, quantity(metric),
           std::string(
               certificate_names[static_cast<std::size_t>(is_chaotic ? Certificate::chaotic : found.certificate)]),
           found.as_solved, found.range.low, found.range.high, static_cast<std::int64_t>(changed)});
    }
  }
  return table;
}

std::string last_bits_sentence(const StudyResults& study, const PerturbedCopies& copies) {
  if (copies.empty()) return {};
  std::array<std::vector<std::string>, certificate_names.size()> solvers;
  for (const std::string& solver : study.solvers) {
    const std::size_t changed = changed_statuses(study, copies, solver);
    Certificate worst = changed > 0 ? Certificate::chaotic : Certificate::exact;
    for (const Metric metric : exact_metrics())
      worst = std::max(worst, rounding_of(study, copies, solver, metric).certificate);
    const std::string how_many =
        changed > 0 ? fmt::format(" ({} of {} solves)", changed, solves_of(study, solver).size()) : "";
    solvers[static_cast<std::size_t>(worst)].push_back(solver + how_many);
  }
  constexpr std::array<std::string_view, certificate_names.size()> meanings{words::exact_solvers, words::stable_solvers,
                                                                            words::chaotic_solvers};
  std::string sentence = fmt::format(words::last_bits, fmt::arg("copies", copies.size()));
  for (std::size_t i = 0; i < solvers.size(); ++i) {
    if (!solvers[i].empty())
      sentence += fmt::format(fmt::runtime(meanings[i]), fmt::arg("solvers", listed(solvers[i])));
  }
  return sentence;
}

}  // namespace ikbench::report
