#include "analysis/figures/critical_difference_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

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

// The axis reaches from the best rank to `last_rank`, the labels' lines by the overhang beyond. Below it are the bars,
// then the labels from `labels_top_cm` to `below_cm`, which are as wide as `side_cm` at either side.
struct Frame {
  double last_rank;
  double overhang;
  double labels_top_cm;
  double below_cm;
  double side_cm;
};

Frame frame_of(std::span<const Ranked> sorted, std::span<const Bar> bars) {
  std::size_t levels = 0;
  for (const Bar& bar : bars) levels = std::max(levels, bar.level + 1);
  double widest_cm = 0.6;
  for (const Ranked& one : sorted) widest_cm = std::max(widest_cm, label_cm(row_label(one.label, longest_label)));
  double last_rank = std::max(2.0, static_cast<double>(sorted.size()));
  if (!sorted.empty()) last_rank = std::max(last_rank, std::ceil(sorted.back().rank));
  const double labels_top_cm = 0.35 + bar_cm * static_cast<double>(levels);
  return {.last_rank = last_rank,
          .overhang = 0.03 * (last_rank - best_rank),
          .labels_top_cm = labels_top_cm,
          .below_cm = labels_top_cm + label_row_cm * static_cast<double>((sorted.size() + 1) / 2),
          .side_cm = widest_cm + 1.2};  // and a rank
}

// The bar of the critical difference, from the best rank; it may be cut at the axis' end.
struct Reach {
  double end;
  bool is_cut;
};

Reach reach_of(double critical_difference, const Frame& frame) {
  const double end = std::min(best_rank + critical_difference, frame.last_rank);
  return {.end = end, .is_cut = end < best_rank + critical_difference};
}

// The leader lines from the axis to the labels: half of them, the better, at the right.
struct Leaders {
  std::string lines;
  std::string labels;
};

Leaders leaders_of(std::span<const Ranked> sorted, const Frame& frame) {
  Leaders leaders;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const bool right = i < (sorted.size() + 1) / 2;
    const std::size_t row = right ? i : sorted.size() - 1 - i;
    const double y = frame.labels_top_cm + label_row_cm * static_cast<double>(row);
    const double end = right ? best_rank - frame.overhang : frame.last_rank + frame.overhang;
    const std::string x = data_number(sorted[i].rank);
    leaders.lines += fmt::format("# {}\n{} 0\n{} {}\n{} {}\n\n", one_line(sorted[i].label), x, x, text_of(y),
                                 text_of(end), text_of(y));
    const std::string label = row_label(sorted[i].label, longest_label);
    const std::string rank = fmt::format("{:.2f}", sorted[i].rank);
    leaders.labels += fmt::format("set label {} at {}, {} {} noenhanced offset {}, 0 font ',7'\n",
                                  gnuplot_string(right ? rank + "  " + label : label + "  " + rank), text_of(end),
                                  text_of(y), right ? "left" : "right", right ? "0.5" : "-0.5");
  }
  return leaders;
}

Figure empty_figure(const std::string& name, const Frame& frame) {
  Figure figure{.name = name, .width_cm = 2 * frame.side_cm + plot_cm, .height_cm = above_cm + frame.below_cm};
  figure.settings = fmt::format(
      "unset key\nunset grid\nunset border\nunset tics\nset tmargin at screen 1\nset bmargin at screen 0\n"
      "set lmargin at screen {}\nset rmargin at screen {}\nset xrange [{}:{}]\nset yrange [{}:{}]\n",
      text_of(frame.side_cm / figure.width_cm), text_of(1 - frame.side_cm / figure.width_cm),
      text_of(frame.last_rank + frame.overhang), text_of(best_rank - frame.overhang), text_of(frame.below_cm),
      text_of(-above_cm));
  return figure;
}

void add_axis(Figure& figure, const Frame& frame) {
  figure.data += "# the axis and its ticks, the critical difference: from rank, height [cm], to rank, height\n";
  figure.data += fmt::format("{} 0 {} 0\n", text_of(best_rank), text_of(frame.last_rank));
  const double step = std::max(1.0, std::ceil((frame.last_rank - best_rank) / 12));
  for (double tick = best_rank; tick <= frame.last_rank; tick += step) {
    figure.data += fmt::format("{0} 0 {0} -0.1\n", text_of(tick));
    figure.settings += fmt::format("set label '{0}' at {0}, -0.26 center font ',7'\n", text_of(tick));
  }
}

void add_critical_difference(Figure& figure, double critical_difference, const Frame& frame) {
  const Reach reach = reach_of(critical_difference, frame);
  figure.data += fmt::format("{0} -0.66 {0} -0.8\n{0} -0.73 {1} -0.73\n{1} -0.66 {1} -0.8\n", text_of(best_rank),
                             text_of(reach.end));
  figure.settings +=
      fmt::format("set label 'CD = {}{}' at {}, -1.02 center font ',7'\n", rounded_number(critical_difference, 3),
                  reach.is_cut ? " (longer than the axis)" : "", text_of((best_rank + reach.end) / 2));
}

std::string lines_of(std::span<const Bar> bars, std::span<const Ranked> sorted, const Frame& frame) {
  std::string lines;
  for (const Bar& bar : bars) {
    const std::string y = text_of(0.2 + bar_cm * static_cast<double>(bar.level));
    lines += fmt::format("{} {} {}\n", text_of(sorted[bar.first].rank - frame.overhang / 2), y,
                         text_of(sorted[bar.last].rank + frame.overhang / 2));
  }
  return lines.empty() ? "NaN NaN NaN\n" : lines;
}

bool has_critical_difference(const CriticalDifference& ranks) {
  return ranks.critical_difference > 0 && is_drawable(ranks.critical_difference);
}

std::string caption_of(const CriticalDifference& ranks, std::size_t shown, const Frame& frame) {
  std::string caption = fmt::format("Average ranks, the best (1) to the right ({}).", ranks.method);
  if (has_critical_difference(ranks)) {
    caption += fmt::format(
        " Bars join groups whose difference is undecided by Nemenyi's test at significance {}: their ranks differ by "
        "at most the critical difference, CD = {}.",
        rounded_number(ranks.significance, 6), rounded_number(ranks.critical_difference, 4));
    if (reach_of(ranks.critical_difference, frame).is_cut) caption += " Its bar is cut at the axis' end.";
  } else {
    caption += " The critical difference is not defined, so the figure does not show which groups differ.";
  }
  if (shown < ranks.labels.size()) {
    caption +=
        fmt::format(" Only {} of {} are shown; the others have no rank or do not fit.", shown, ranks.labels.size());
  }
  return caption;
}

}  // namespace

Figure critical_difference_figure(const CriticalDifference& ranks) {
  const std::vector<Ranked> sorted = sorted_ranks(ranks);
  const bool has_bar = has_critical_difference(ranks);
  const std::vector<Bar> bars = has_bar ? bars_of(sorted, ranks.critical_difference) : std::vector<Bar>{};
  const Frame frame = frame_of(sorted, bars);
  const Leaders leaders = leaders_of(sorted, frame);

  Figure figure = empty_figure(ranks.name, frame);
  figure.settings += leaders.labels;
  add_axis(figure, frame);
  if (has_bar) add_critical_difference(figure, ranks.critical_difference, frame);
  figure.data += "\n\n# average ranks and their labels' lines: rank, height [cm]\n";
  figure.data += leaders.lines.empty() ? "NaN NaN\n" : leaders.lines;
  figure.data += "\n\n# undecided differences: from rank, height [cm], to rank\n" + lines_of(bars, sorted, frame);
  if (sorted.empty()) figure.settings += "set label 'nothing to show' at graph 0.5, graph 0.2 center\n";
  figure.plot = plot_command(
      {fmt::format("'{}.dat' index 1 with lines lw 0.7 lc rgb '#666666'", ranks.name),
       fmt::format("'{}.dat' index 0 using 1:2:($3-$1):($4-$2) with vectors nohead lw 1 lc rgb '#000000'", ranks.name),
       fmt::format("'{}.dat' index 2 using 1:2:($3-$1):(0) with vectors nohead lw 3.5 lc rgb word(colours, 1)",
                   ranks.name)});
  figure.caption = caption_of(ranks, sorted.size(), frame);
  return figure;
}

}  // namespace ikbench::figures
