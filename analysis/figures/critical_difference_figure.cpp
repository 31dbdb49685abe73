#include "analysis/figures/critical_difference_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "analysis/figures/axis.hpp"
#include "analysis/figures/figure_parts.hpp"
#include "analysis/figures/row_chart.hpp"
#include "analysis/inference/text.hpp"
#include "numerics/number.hpp"

namespace ikbench::figures {

using namespace numerics;
using namespace statistics;
using namespace inference;

namespace {

constexpr double label_row_cm = 0.45;
constexpr double bar_cm = 0.22;
constexpr double plot_cm = 6.0;
constexpr double above_cm = 1.35;
constexpr double best_rank = 1;
constexpr std::size_t most_labels = 60;

struct Ranked {
  std::string label;
  double rank;
};

// First and last of the longest stretches of sorted ranks that differ by no more than the critical difference.
struct Bar {
  std::size_t first;
  std::size_t last;
  std::size_t level = 0;  // below the axis, so that no two bars touch
};

std::vector<Bar> bars_of(std::span<const Ranked> sorted, double critical_difference) {
  std::vector<Bar> bars;
  std::vector<double> ends;  // per level: the end of its last bar
  for (std::size_t first = 0; first < sorted.size(); ++first) {
    std::size_t last = first;
    while (last + 1 < sorted.size() && sorted[last + 1].rank - sorted[first].rank <= critical_difference) ++last;
    if (last == first || (!bars.empty() && bars.back().last >= last)) continue;
    Bar bar{.first = first, .last = last};
    const auto free = std::ranges::find_if(ends, [&](double end) { return end < sorted[first].rank; });
    bar.level = static_cast<std::size_t>(free - ends.begin());
    if (free == ends.end()) ends.push_back(0);
    ends[bar.level] = sorted[last].rank;
    bars.push_back(bar);
  }
  return bars;
}

std::vector<Ranked> sorted_ranks(const CriticalDifference& ranks) {
  std::vector<Ranked> sorted;
  const std::size_t n = std::min(ranks.labels.size(), ranks.average_ranks.size());
  for (std::size_t i = 0; i < n; ++i) {
    const double rank = ranks.average_ranks[i];
    if (rank >= 1 && rank <= static_cast<double>(n)) sorted.push_back({ranks.labels[i], rank});
  }
  std::ranges::stable_sort(sorted, {}, &Ranked::rank);
  if (sorted.size() > most_labels) sorted.resize(most_labels);
  return sorted;
}

}  // namespace

Figure critical_difference_figure(const CriticalDifference& ranks) {
  const std::vector<Ranked> sorted = sorted_ranks(ranks);
  const double critical_difference = ranks.critical_difference;
  const bool has_bar = critical_difference > 0 && is_drawable(critical_difference);
  const std::vector<Bar> bars = has_bar ? bars_of(sorted, critical_difference) : std::vector<Bar>{};
  std::size_t levels = 0;
  for (const Bar& bar : bars) levels = std::max(levels, bar.level + 1);
  double widest_cm = 0.6, last_rank = std::max(2.0, static_cast<double>(sorted.size()));
  for (const Ranked& one : sorted) {
    widest_cm = std::max(widest_cm, label_cm(row_label(one.label, longest_label)));
    last_rank = std::max(last_rank, std::ceil(one.rank));
  }
  // Below the axis are the bars, then the lines to the labels, which are as wide as `side_cm` at either side and reach
  // beyond the axis by the overhang: half of them, the better, at the right.
  const std::size_t rows = (sorted.size() + 1) / 2;
  const double overhang = 0.03 * (last_rank - best_rank), side_cm = widest_cm + 1.2;  // and a rank
  const double labels_top_cm = 0.35 + bar_cm * static_cast<double>(levels);
  const double below_cm = labels_top_cm + label_row_cm * static_cast<double>(rows);
  const double left = last_rank + overhang, right = best_rank - overhang;

  Figure figure{.name = ranks.name, .width_cm = 2 * side_cm + plot_cm, .height_cm = above_cm + below_cm};
  figure.settings = fmt::format(
      "unset key\nunset grid\nunset border\nunset tics\nset tmargin at screen 1\nset bmargin at screen 0\n"
      "side = margin({0}) < 0.4 ? margin({0}) : 0.4\nset lmargin at screen side\nset rmargin at screen 1 - side\nset xrange [{1}:{2}]\nset yrange [{3}:{4}]\n",
      text_of(side_cm), text_of(left), text_of(right), text_of(below_cm), text_of(-above_cm));
  std::string lines;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const bool is_right = i < rows;
    const std::size_t row = is_right ? i : sorted.size() - 1 - i;
    const std::string x = data_number(sorted[i].rank), end = text_of(is_right ? right : left),
                      y = text_of(labels_top_cm + label_row_cm * static_cast<double>(row)),
                      label = row_label(sorted[i].label, longest_label), rank = fmt::format("{:.2f}", sorted[i].rank);
    lines += fmt::format("# {}\n{} 0\n{} {}\n{} {}\n\n", one_line(sorted[i].label), x, x, y, end, y);
    figure.settings += fmt::format("set label {} at {}, {} {} noenhanced offset {}, 0 font names\n",
                                   gnuplot_string(is_right ? rank + "  " + label : label + "  " + rank), end, y,
                                   is_right ? "left" : "right", is_right ? "0.5" : "-0.5");
  }
  figure.data = fmt::format(
      "# the axis and its ticks, the critical difference: from rank, height [cm], to rank, height\n{} 0 {} 0\n",
      text_of(best_rank), text_of(last_rank));
  const double step = std::max(1.0, std::ceil((last_rank - best_rank) / 12));
  for (double tick = best_rank; tick <= last_rank; tick += step) {
    figure.data += fmt::format("{0} 0 {0} -0.1\n", text_of(tick));
    figure.settings += fmt::format("set label '{0}' at {0}, -0.26 center font names\n", text_of(tick));
  }
  figure.caption = fmt::format("Average ranks, the best (1) to the right ({}).", ranks.method);
  if (has_bar) {
    const double end = std::min(best_rank + critical_difference, last_rank);
    const bool is_cut = end < best_rank + critical_difference;
    figure.data +=
        fmt::format("{0} -0.66 {0} -0.8\n{0} -0.73 {1} -0.73\n{1} -0.66 {1} -0.8\n", text_of(best_rank), text_of(end));
    figure.settings +=
        fmt::format("set label 'CD = {}{}' at {}, -1.02 center font names\n", rounded_number(critical_difference, 3),
                    is_cut ? " (longer than the axis)" : "", text_of((best_rank + end) / 2));
    figure.caption += fmt::format(
        " Bars join groups whose difference is undecided by Nemenyi's test at significance {}: their ranks differ by "
        "at most the critical difference, CD = {}.{}",
        rounded_number(ranks.significance, 6), rounded_number(critical_difference, 4),
        is_cut ? " Its bar is cut at the axis' end." : "");
    if (!ranks.decides.empty())
      figure.caption += fmt::format(" The report decides pair by pair ({}), so it may differ.", ranks.decides);
  } else {
    figure.caption += " The critical difference is not defined, so the figure does not show which groups differ.";
  }
  figure.data += "\n\n# average ranks and their labels' lines: rank, height [cm]\n";
  figure.data += lines.empty() ? "NaN NaN\n" : lines;
  figure.data += "\n\n# undecided differences: from rank, height [cm], to rank\n";
  for (const Bar& bar : bars) {
    figure.data += fmt::format("{} {} {}\n", text_of(sorted[bar.first].rank - overhang / 2),
                               text_of(0.2 + bar_cm * static_cast<double>(bar.level)),
                               text_of(sorted[bar.last].rank + overhang / 2));
  }
  if (bars.empty()) figure.data += "NaN NaN NaN\n";
  if (sorted.empty()) figure.settings += "set label 'nothing to show' at graph 0.5, graph 0.2 center\n";
  if (sorted.size() < ranks.labels.size()) {
    figure.caption += fmt::format(" Only {} of {} are shown; the others have no rank or do not fit.", sorted.size(),
                                  ranks.labels.size());
  }
  figure.plot = plot_command(
      {fmt::format("'{}.dat' index 1 with lines lw 0.7 lc rgb '#666666'", ranks.name),
       fmt::format("'{}.dat' index 0 using 1:2:($3-$1):($4-$2) with vectors nohead lw 1 lc rgb '#000000'", ranks.name),
       fmt::format("'{}.dat' index 2 using 1:2:($3-$1):(0) with vectors nohead lw 3.5 lc rgb word(colours, 1)",
                   ranks.name)});
  return figure;
}

}  // namespace ikbench::figures
