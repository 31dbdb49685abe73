#include "analysis/report/study_pieces.hpp"

#include <fmt/format.h>

#include "analysis/figures/box_figure.hpp"
#include "analysis/figures/overview_figure.hpp"
#include "analysis/figures/study_figures.hpp"
#include "analysis/report/study_tables.hpp"

namespace ikbench::report {

using namespace inference;
using namespace figures;

StudyPieces study_pieces(const StudyResults& study) {
  const std::vector<Metric> metrics = reported_metrics();
  StudyPieces pieces{.tables = {results_table(study, metrics), status_table(study)}};
  for (const Metric metric : metrics) pieces.tables.push_back(anova_table(study, metric));
  if (study.solves.empty()) return pieces;
  if (std::optional<Figure> joints = joints_figure(study, "joints")) pieces.figures.push_back(std::move(*joints));
  pieces.figures.push_back(overview_figure(study, {}));
  pieces.figures.push_back(path_figure(study, "path"));
  for (const Metric metric : metrics) {
    const std::string name(info_of(metric).slug);
    pieces.figures.push_back(curves_figure(study, metric, name));
    pieces.figures.push_back(box_figure(study, {.name = name + "-boxes", .metric = metric}));
  }
  return pieces;
}

}  // namespace ikbench::report
