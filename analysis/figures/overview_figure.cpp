#include "analysis/figures/overview_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/figures/dark.hpp"
#include "analysis/figures/figure_parts.hpp"
#include "analysis/inference/comparable.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "numerics/number.hpp"

namespace ikbench::figures {

using namespace numerics;
using namespace statistics;
using namespace inference;

namespace {

std::vector<OverviewMark> means_of(const StudyResults& study) {
  const auto errors = samples(study, Metric::position_error_cm), variations = samples(study, Metric::variation_deg),
             times = samples(study, Metric::seconds);
  std::vector<OverviewMark> marks;
  for (std::size_t i = 0; i < study.solvers.size(); ++i) {
    marks.push_back({.solver = study.solvers[i],
                     .error_cm = describe(errors[i].values).mean,
                     .variation_deg = describe(variations[i].values).mean,
                     .seconds = describe(times[i].values).median});
  }
  return marks;
}

// The printed means of the same solvers, in their order.
std::vector<OverviewMark> beside(const std::vector<OverviewMark>& ours, const std::vector<OverviewMark>& printed) {
  std::vector<OverviewMark> marks;
  for (const OverviewMark& mark : ours) {
    const auto found = std::ranges::find(printed, mark.solver, &OverviewMark::solver);
    marks.push_back(found != printed.end() ? *found : OverviewMark{mark.solver, not_defined, not_defined, not_defined});
  }
  return marks;
}

constexpr double largest_size = 1.6, smallest_size = 0.4;

// Lines of variation, error and size. The area is in proportion to the time, but never too small to see.
std::string disc_lines(const std::vector<OverviewMark>& marks, bool has_times) {
  double slowest = 0;
  for (const OverviewMark& mark : marks) slowest = std::max(slowest, mark.seconds);
  std::string lines;
  for (const OverviewMark& mark : marks) {
    const double size = has_times && slowest > 0 && mark.seconds >= 0
                            ? std::max(smallest_size, largest_size * std::sqrt(mark.seconds / slowest))
                            : largest_size / 2;
    lines += data_line({mark.variation_deg, mark.error_cm, size});
  }
  return lines;
}

std::string words_of_sizes(const std::vector<OverviewMark>& marks, bool has_times) {
  if (!has_times) return "Without times.";
  const double longest = std::ranges::max(marks, {}, &OverviewMark::seconds).seconds;
  const double least = longest * smallest_size * smallest_size / (largest_size * largest_size);
  const bool is_cut = std::ranges::any_of(marks, [&](const OverviewMark& mark) { return mark.seconds < least; });
  return is_cut ? "Size of a dot: median time; all times below a sixteenth of the longest look the same."
                : "Size of a dot: median time.";
}

}  // namespace

Figure overview_figure(const StudyResults& study, const std::vector<OverviewMark>& printed) {
  const std::vector<OverviewMark> ours = means_of(study), rings = beside(ours, printed);
  const bool has_times = times_are_comparable(study), has_rings = !printed.empty();
  Figure figure{.name = "overview", .caption = words_of_sizes(ours, has_times), .height_cm = 6.6};
  std::vector<double> errors;
  double widest = 1e-9;
  for (const auto* marks : {&ours, &rings}) {
    for (const OverviewMark& mark : *marks) {
      errors.insert(errors.end(), {mark.error_cm / 1.3, mark.error_cm * 1.3});  // a disc has a size
      if (std::isfinite(mark.variation_deg)) widest = std::max(widest, mark.variation_deg);
    }
  }
  const Axis axis =
      value_axis(errors, {fmt::format("mean {}", info_of(Metric::position_error_cm).name), "cm"}, Scale::logarithmic);
  if (axis.shows_at_edge) figure.caption += " Values of zero are drawn at the lower edge.";
  figure.settings =
      axis.settings + fmt::format("set xlabel {}\nset xrange [0:{}]\n",
                                  gnuplot_string("mean " + quantity(Metric::variation_deg)), text_of(1.12 * widest));
  figure.data =
      fmt::format("# a line a solver: angles variation, position error, size\n{}", disc_lines(ours, has_times));
  std::vector<std::string> clauses{"NaN"}, labels;
  if (has_rings) {
    figure.caption += " Rings: the paper's numbers.";
    figure.data += "\n\n# as printed\n" + disc_lines(rings, has_times) + "\n\n# from ours to the printed\n";
    for (std::size_t i = 0; i < ours.size(); ++i) {
      figure.data += data_line({ours[i].variation_deg, ours[i].error_cm, rings[i].variation_deg, rings[i].error_cm});
    }
    clauses.emplace_back(
        "data index 2 using 1:(shown($2)):($3-$1):(shown($4)-shown($2)) with vectors nohead lw 0.7 lc rgb '#808080'");
    labels.emplace_back("as printed");
    clauses.emplace_back("keyentry with points pt 6 ps 0.8 lc rgb '#666666' title 'as printed'");
  }
  constexpr std::array shapes{7, 5, 9, 11, 13};  // filled; colours repeat after seven, shapes after five times seven
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const int shape = shapes[i / series_colours.size() % shapes.size()];
    labels.push_back(shortened(ours[i].solver, longest_label));
    const auto points = [&](int index, int type) {
      return fmt::format("data index {0} every ::{1}::{1} using 1:(shown($2)):3 with points ls {2} pt {3} ps variable",
                         index, i, i + 1, type);
    };
    if (has_rings) clauses.push_back(points(1, shape - 1) + " lw 1.2");
    clauses.push_back(fmt::format("{} title {}", points(0, shape), gnuplot_string(labels.back())));
    if (!std::isfinite(ours[i].error_cm) || !std::isfinite(ours[i].variation_deg)) continue;
    figure.hover_texts.push_back({.series = labels.back(),
                                  .words = {fmt::format("error {}, variation {}, time {}",
                                                        value_words(Metric::position_error_cm, ours[i].error_cm),
                                                        value_words(Metric::variation_deg, ours[i].variation_deg),
                                                        value_words(Metric::seconds, ours[i].seconds))}});
  }
  add_legend(figure, labels);
  figure.plot = plot_command(clauses);
  return figure;
}

}  // namespace ikbench::figures
