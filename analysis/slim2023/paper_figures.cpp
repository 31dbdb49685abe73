#include "analysis/slim2023/paper_figures.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "analysis/figures/study_figures.hpp"
#include "analysis/slim2023/circle_figures.hpp"
#include "analysis/slim2023/published_numbers.hpp"

namespace ikbench::slim2023 {

using namespace results;
using namespace statistics;
using namespace inference;
using namespace figures;

Figure printed_box_figure(const StudyResults& study, BoxRequest request) {
  request.name = fmt::format("figure-{}", paper_numbers(request.metric).box_figure);
  if (study.plan.unit == Unit::run && request.metric != Metric::seconds) {  // the printed times are of another machine
    for (const PrintedRow& row : printed_table_3(study, request.metric)) {
      request.printed.push_back({row.algorithm, row.min, row.median, row.max});
    }
  }
  return box_figure(study, request);
}

std::vector<Figure> paper_figures(const StudyResults& study) {
  if (study.solves.empty()) return {};
  std::vector<Figure> figures{path_figure(study, "figure-5")};
  for (const Metric metric : paper_metrics) {
    figures.push_back(curves_figure(study, metric, fmt::format("figure-{}", paper_numbers(metric).curves_figure)));
  }
  if (std::optional<Figure> joints = joints_figure(study, "figure-9")) figures.push_back(std::move(*joints));
  for (const Metric metric : paper_metrics) {
    figures.push_back(printed_box_figure(study, {.metric = metric}));
  }
  for (Figure& figure : circle_figures(study)) figures.push_back(std::move(figure));
  return figures;
}

}  // namespace ikbench::slim2023
