#include <fmt/format.h>

#include <string>
#include <string_view>

#include "analysis/slim2023/slim2023.hpp"
#include "results/published.hpp"

namespace ikbench::slim2023 {

using namespace judge;
using namespace figures;
using base::CsvTable;

namespace {

constexpr std::string_view error = "position_error_cm", motion = "variation_deg", time = "seconds";

std::optional<Figure> numbered(int number, std::optional<Figure> figure) {
  if (!figure) return figure;
  figure->name = fmt::format("figure-{}", number);
  figure->caption = fmt::format("Figure {}. {}", number, figure->caption);
  return figure;
}

papers::PrintedRows in_print(std::string_view column) { return papers::printed_means("slim2023", "table-3", column); }

// The means of Table 3, ours and printed.
std::optional<Figure> overview_figure(const JudgedStudy& judged, const Look& look) {
  std::optional<Figure> figure = overview_of(judged, look, [](Dot& dot) {
    const auto printed = [&](std::string_view column) {
      const papers::PrintedRows rows = in_print(column);
      const auto* const row = papers::row_of(rows, dot.label);
      return row == nullptr ? nowhere : row->numbers.mean;
    };
    dot.printed_x = printed(motion), dot.printed_y = printed(error);
  });
  if (figure) figure->name = "overview", figure->caption += " Rings: as printed.";
  return figure;
}

using Figures = std::vector<std::optional<Figure>>;

Figures of_helix(const JudgedStudy& judged, const Look& look) {
  const StudyResults& study = judged.study;
  Figures figures{overview_figure(judged, look), numbered(5, path_of(study, look, 1, ", with the arm."))};
  for (const PaperMetric& metric : paper_metrics) {
    const bool is_time = metric.column == time;
    const Metric& drawn = metric_named(metric.column);
    const About about = about_of(
        study, drawn, fmt::format("The {} at each point, {} of the runs.", drawn.name, is_time ? "median" : "mean"));
    figures.push_back(numbered(
        metric.curves,
        curves(about, "point", by_point(study, metric.column, look, is_time ? Average::median : Average::mean))));
  }
  figures.push_back(
      numbered(9, joints({.caption = "Joint angles along the path, first run of each solver. Dashed: limits."},
                         joint_rows(study, look))));
  for (const PaperMetric& metric : paper_metrics) {
    const JudgedMetric* const values = judged_of(judged, metric.column);
    if (values == nullptr) continue;
    const Metric& drawn = metric_named(metric.column);
    About about = about_of(
        study, drawn,
        fmt::format("The {}: a dot is the {} of a run; box: quartiles and median; whiskers: smallest and largest.",
                    drawn.name, metric.column == time ? "median" : "mean"));
    if (metric.column == error) about.floor = 0.00005;  // errors are printed with four decimals
    std::vector<BoxRow> boxed =
        box_rows(*values, drawn_unit(study, values->observations.unit), drawn_solvers(study, look), look);
    const papers::PrintedRows printed = metric.column == time ? papers::PrintedRows() : in_print(metric.column);
    for (BoxRow& row : boxed) {
      if (const auto* const its = papers::row_of(printed, row.label))
        row.printed = {its->numbers.smallest, its->numbers.median, its->numbers.largest};
    }
    figures.push_back(numbered(metric.boxes, boxes(about, boxed)));
  }
  return figures;
}

Figures of_circle(const StudyResults& study, const Look& look) {
  Figures figures{numbered(15, path_of(study, look, 3, ", with the arm at three of them."))};
  figures.push_back(
      numbered(16, joints({.caption = "Joint angles along the circle. Dashed: limits."}, joint_rows(study, look))));
  std::vector<Line> errors = by_point(study, error, look, Average::mean);
  const CsvTable printed = results::published::table("slim2023", "table-8");
  Line& beside = errors.emplace_back(Line{.label = "as printed", .style = 0});
  for (std::size_t row = 0; row < printed.rows(); ++row)
    beside.rows.push_back({printed.number(row, "point"), printed.number(row, "error_cm")});
  const auto add = [&](int number, const std::string& caption, const std::string& axis,
                       const std::vector<Line>& lines) {
    About about = about_of(study, metric_named(error), caption);
    about.floor = 0;  // all is rounding
    figures.push_back(numbered(number, curves(about, axis, lines)));
  };
  add(17, "The error at each point, beside Table 8's.", "point", errors);
  add(18, "Best error after each iteration, mean of all solves.", "iteration",
      by_iteration(study, look, Average::mean));
  return figures;
}

}  // namespace

std::vector<Figure> figures_of(const JudgedStudy& judged, const Look& look) {
  if (drawn_solvers(judged.study, look).empty()) return {};
  std::vector<Figure> all;
  for (const auto& figure :
       judged.study.definition.path == "circle" ? of_circle(judged.study, look) : of_helix(judged, look)) {
    if (figure) all.push_back(*figure);
  }
  return all;
}

}  // namespace ikbench::slim2023
