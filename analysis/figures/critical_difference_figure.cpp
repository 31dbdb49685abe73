#include "analysis/figures/critical_difference_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "analysis/figures/figure_parts.hpp"
#include "analysis/inference/text.hpp"
#include "numerics/number.hpp"

namespace ikbench::figures {

using namespace numerics;
using namespace statistics;
using namespace inference;

namespace {

constexpr double label_row_cm = 0.45, bar_cm = 0.22, above_cm = 1.35;

struct Ranked {
  std::string label;
  double rank;
};

std::vector<Ranked> sorted_ranks(const CriticalDifference& ranks) {
  std::vector<Ranked> sorted;
  for (std::size_t i = 0; i < ranks.labels.size(); ++i) {
    const double rank = ranks.average_ranks[i];
    if (rank >= 1 && rank <= static_cast<double>(ranks.labels.size())) sorted.push_back({ranks.labels[i], rank});
  }
  std::ranges::stable_sort(sorted, {}, &Ranked::rank);
  return sorted;
}

// First and last of the longest stretches of sorted ranks that differ by no more than the critical difference.
struct Bar {
  std::size_t first, last;
  std::size_t level;  // below the axis, so that no two bars touch
};

std::vector<Bar> bars_of(const std::vector<Ranked>& sorted, double critical_difference) {
  std::vector<Bar> bars;
  std::vector<double> ends;  // per level: the end of its last bar
  for (std::size_t first = 0; first < sorted.size(); ++first) {
    std::size_t last = first;
    while (last + 1 < sorted.size() && sorted[last + 1].rank - sorted[first].rank <= critical_difference) ++last;
    if (last == first || (!bars.empty() && bars.back().last >= last)) continue;
    const auto free = std::ranges::find_if(ends, [&](double end) { return end < sorted[first].rank; });
    bars.push_back({first, last, static_cast<std::size_t>(free - ends.begin())});
    if (free == ends.end()) ends.push_back(0);
    ends[bars.back().level] = sorted[last].rank;
  }
  return bars;
}

}  // namespace

// Below the axis are the bars, then the lines to the labels, half of them, the better, at the right. Heights are in cm.
Figure critical_difference_figure(const CriticalDifference& ranks) {
  const std::vector<Ranked> sorted = sorted_ranks(ranks);
  const double width = ranks.critical_difference;
  const bool has_width = width > 0 && is_drawable(width);
  const std::vector<Bar> bars = has_width ? bars_of(sorted, width) : std::vector<Bar>{};
  std::size_t levels = 0;
  for (const Bar& bar : bars) levels = std::max(levels, bar.level + 1);
  double widest_cm = 0.6, last_rank = std::max(2.0, static_cast<double>(sorted.size()));
  for (const Ranked& one : sorted) {
    widest_cm = std::max(widest_cm, label_cm(row_label(one.label, longest_label)));
    last_rank = std::max(last_rank, std::ceil(one.rank));
  }
  const std::size_t rows = (sorted.size() + 1) / 2;
  const double overhang = 0.03 * (last_rank - 1), side_cm = widest_cm + 1.2;  // and a rank
  const double labels_top_cm = 0.35 + bar_cm * static_cast<double>(levels);
  const double below_cm = labels_top_cm + label_row_cm * static_cast<double>(rows);
  const double left = last_rank + overhang, right = 1 - overhang;

  Figure figure{.name = ranks.name,
                .caption = fmt::format("Average ranks, the best (1) to the right ({}).", ranks.method),
                .width_cm = 2 * side_cm + 6,
                .height_cm = above_cm + below_cm};
  figure.settings = fmt::format(
      "unset key\nunset grid\nunset border\nunset tics\nset tmargin at screen 1\nset bmargin at screen 0\n"
      "side = margin({0}) < 0.4 ? margin({0}) : 0.4\nset lmargin at screen side\nset rmargin at screen 1 - side\n"
      "set xrange [{1}:{2}]\nset yrange [{3}:{4}]\n",
      text_of(side_cm), text_of(left), text_of(right), text_of(below_cm), text_of(-above_cm));
  figure.data = fmt::format(
      "# the axis and its ticks, the critical difference: from rank, height [cm], to rank, height\n1 0 {} 0\n",
      text_of(last_rank));
  const double step = std::max(1.0, std::ceil((last_rank - 1) / 12));
  for (double tick = 1; tick <= last_rank; tick += step) {
    figure.data += fmt::format("{0} 0 {0} -0.1\n", text_of(tick));
    figure.settings += fmt::format("set label '{0}' at {0}, -0.26 center font names\n", text_of(tick));
  }
  if (has_width) {
    const double end = std::min(1 + width, last_rank);
    figure.data += fmt::format("1 -0.66 1 -0.8\n1 -0.73 {0} -0.73\n{0} -0.66 {0} -0.8\n", text_of(end));
    figure.settings += fmt::format("set label 'CD = {}{}' at {}, -1.02 center font names\n", rounded_number(width, 3),
                                   end < 1 + width ? " (longer than the axis)" : "", text_of((1 + end) / 2));
    figure.caption += fmt::format(
        " Bars join groups whose difference is undecided by Nemenyi's test at significance {}: their ranks differ by "
        "at most the critical difference, CD = {}.",
        rounded_number(ranks.significance, 6), rounded_number(width, 4));
    if (!ranks.decides.empty())
      figure.caption += fmt::format(" The report decides pair by pair ({}), so it may differ.", ranks.decides);
  } else {
    figure.caption += " The critical difference is not defined, so the figure does not show which groups differ.";
  }
  figure.data += "\n\n# average ranks and their labels' lines: rank, height [cm]\n";
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const bool is_right = i < rows;
    const std::size_t row = is_right ? i : sorted.size() - 1 - i;
    const std::string x = text_of(sorted[i].rank), end = text_of(is_right ? right : left),
                      y = text_of(labels_top_cm + label_row_cm * static_cast<double>(row)),
                      label = row_label(sorted[i].label, longest_label), rank = fmt::format("{:.2f}", sorted[i].rank);
    figure.data += fmt::format("# {}\n{} 0\n{} {}\n{} {}\n\n", one_line(sorted[i].label), x, x, y, end, y);
    figure.settings += fmt::format("set label {} at {}, {} {} noenhanced font names\n",
                                   gnuplot_string(is_right ? rank + "  " + label : label + "  " + rank), end, y,
                                   is_right ? "left offset 0.5, 0" : "right offset -0.5, 0");
  }
  figure.data += fmt::format("NaN NaN\n\n\n# undecided differences: from rank, height [cm], to rank\n");
  for (const Bar& bar : bars) {
    figure.data += data_line({sorted[bar.first].rank - overhang / 2, 0.2 + bar_cm * static_cast<double>(bar.level),
                              sorted[bar.last].rank + overhang / 2});
  }
  if (bars.empty()) figure.data += "NaN NaN NaN\n";
  if (sorted.empty()) figure.settings += "set label 'nothing to show' at graph 0.5, graph 0.2 center\n";
  if (sorted.size() < ranks.labels.size()) {
    figure.caption +=
        fmt::format(" Only {} of {} are shown; the others have no rank.", sorted.size(), ranks.labels.size());
  }
  figure.plot = plot_command({"data index 1 with lines lw 0.7 lc rgb '#666666'",
                              "data index 0 using 1:2:($3-$1):($4-$2) with vectors nohead lw 1 lc rgb '#000000'",
                              "data index 2 using 1:2:($3-$1):(0) with vectors nohead lw 3.5 lc rgb word(colours, 1)"});
  return figure;
}

}  // namespace ikbench::figures
