#include "analysis/report/study_pieces.hpp"

#include <fmt/format.h>

#include <cmath>

#include "analysis/figures/box_figure.hpp"
#include "analysis/figures/overview_figure.hpp"
#include "analysis/figures/study_figures.hpp"
#include "analysis/inference/shown_metrics.hpp"
#include "analysis/report/study_tables.hpp"

namespace ikbench::report {

using namespace inference;
using namespace figures;

StudyPieces study_pieces(const StudyResults& study) {
  const ShownMetrics metrics = shown_metrics(study);
  StudyPieces pieces{.tables = {results_table(study, metrics.judged), times_table(study), status_table(study)}};
  if (std::isfinite(tolerance_cm(study))) pieces.tables.push_back(solved_table(study));
  if (!metrics.listed.empty()) pieces.tables.push_back(further_table(study, metrics.listed));
  if (!metrics.left_out.empty()) pieces.tables.front().notes.push_back(metrics.left_out);
  for (const Metric metric : metrics.judged) pieces.tables.push_back(anova_table(study, metric));
  if (study.solves.empty()) return pieces;
  const bool has_points = study.points > 1;  // a sequence to draw
  if (std::optional<Figure> joints = joints_figure(study, "joints"); joints && has_points) {
    pieces.figures.push_back(std::move(*joints));
  }
  pieces.figures.push_back(overview_figure(study, {}));
  pieces.figures.push_back(path_figure(study, "path"));
  for (const Metric metric : metrics.judged) {
    const std::string name(info_of(metric).slug);
    if (has_points && !is_of_run(metric)) pieces.figures.push_back(curves_figure(study, metric, name));
    pieces.figures.push_back(box_figure(study, metric, name + "-boxes"));
  }
  return pieces;
}

}  // namespace ikbench::report
