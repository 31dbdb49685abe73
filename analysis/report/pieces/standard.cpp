// The standard pieces of a study: those that papers have too, under other names.
#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "analysis/figures/box_figure.hpp"
#include "analysis/figures/overview_figure.hpp"
#include "analysis/figures/study_figures.hpp"
#include "analysis/report/study_pieces.hpp"
#include "analysis/report/study_tables.hpp"

namespace ikbench::report {

using namespace inference;
using namespace figures;

std::vector<Figure> overview_figures(const StudyResults& study, const std::vector<Metric>&) {
  return {overview_figure(study, {})};
}

std::vector<Table> results_tables(const StudyResults& study, const std::vector<Metric>& metrics) {
  return {results_table(study, metrics)};
}

std::vector<Table> solved_tables(const StudyResults& study, const std::vector<Metric>&) {
  if (!std::isfinite(tolerance_cm(study))) return {};
  return {solved_table(study)};
}

std::vector<Table> times_tables(const StudyResults& study, const std::vector<Metric>&) { return {times_table(study)}; }

std::vector<Figure> path_figures(const StudyResults& study, const std::vector<Metric>&) {
  return {path_figure(study, "path")};
}

std::vector<Figure> boxes_figures(const StudyResults& study, const std::vector<Metric>& metrics) {
  std::vector<Figure> figures;
  for (const Metric metric : metrics) {
    figures.push_back(box_figure(study, metric, fmt::format("{}-boxes", info_of(metric).slug)));
  }
  return figures;
}

std::vector<Figure> curves_figures(const StudyResults& study, const std::vector<Metric>& metrics) {
  std::vector<Figure> figures;
  for (const Metric metric : metrics) {
    if (study.points > 1) figures.push_back(curves_figure(study, metric, std::string(info_of(metric).slug)));
  }
  return figures;
}

std::vector<Figure> joints_figures(const StudyResults& study, const std::vector<Metric>&) {
  const std::optional<Figure> joints = study.points > 1 ? joints_figure(study, "joints") : std::nullopt;
  return joints ? std::vector{*joints} : std::vector<Figure>();
}

std::vector<Table> anova_tables(const StudyResults& study, const std::vector<Metric>& metrics) {
  std::vector<Table> tables;
  for (const Metric metric : metrics) tables.push_back(anova_table(study, metric));
  return tables;
}

}  // namespace ikbench::report
