#include "analysis/figures/share_curves.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "analysis/figures/axis.hpp"
#include "analysis/figures/figure_parts.hpp"
#include "analysis/inference/text.hpp"
#include "numerics/number.hpp"

namespace ikbench::figures {

using namespace numerics;
using namespace results;
using namespace inference;

void add_curve(std::vector<std::string>& clauses, const DrawnCurve& curve) {
  const std::size_t interval = std::max<std::size_t>(1, curve.rows / 9);
  const std::size_t first = std::min(curve.rows - 1, 1 + curve.solver * 5 % interval);
  const std::size_t style = curve.solver + 1;
  clauses.push_back(fmt::format("{} with lines ls {} notitle", curve.source, style));
  clauses.push_back(
      fmt::format("{} every {}::{} with points ls {} dt 1 notitle", curve.source, interval, first, style));
  clauses.push_back(fmt::format("keyentry with linespoints ls {} title {}", style,
                                gnuplot_string(shortened(curve.label, longest_label))));
}

std::string add_missing_curve(std::vector<std::string>& clauses, std::size_t solver, const std::string& label) {
  const std::string entry = shortened(label, longest_label) + " (nothing to show)";
  clauses.push_back(fmt::format("keyentry with linespoints ls {} title {}", solver + 1, gnuplot_string(entry)));
  return entry;
}

namespace {

// A curve as rows of a data file: the corners of its stairs, and those of its band if it has one.
struct Corners {
  std::string rows;
  std::size_t count = 0;
  bool has_band = false;

  void add(double at, const Share& share) {
    rows += fmt::format("{} {}", text_of(at), text_of(share.share));
    if (has_band) rows += fmt::format(" {} {}", data_number(share.low), data_number(share.high));
    rows += '\n';
    ++count;
  }
};

Corners corners_of(const std::vector<Share>& curve, const Axis& axis) {
  Corners corners;
  corners.has_band = std::ranges::any_of(curve, [](const Share& share) { return std::isfinite(share.low); });
  Share before{.at = axis.low, .share = 0, .low = 0, .high = 0};
  corners.add(std::min(axis.low, curve.front().at), before);
  for (const Share& share : curve) {
    corners.add(share.at, before);
    const bool is_step = share.share != before.share;
    before = share;
    if (is_step) corners.add(share.at, before);
  }
  corners.add(axis.high, before);
  return corners;
}

}  // namespace

void draw_shares(Figure& figure, const StudyResults& study, const ShareCurves& shares) {
  double smallest = censored, largest = 0;
  for (const auto& curve : shares.curves) {
    for (const Share& share : curve) {
      if (share.at > 0) smallest = std::min(smallest, share.at);
      largest = std::max(largest, share.at);
    }
  }
  const Axis axis = ratio_axis(smallest, largest, shares.label);
  figure.settings = axis.settings + fmt::format("set ylabel {}\nset yrange [-0.02:1.02]\nset ytics 0.2\n",
                                                gnuplot_string(shares.share_of));
  std::vector<std::string> fills{"NaN notitle"}, lines, labels = study.solvers;
  int block = 0;
  for (std::size_t i = 0; i < shares.curves.size(); ++i) {
    const std::size_t place = place_of(study, study.solvers[i]);
    if (shares.curves[i].empty()) {
      labels[i] = add_missing_curve(lines, place, study.solvers[i]);
      continue;
    }
    const Corners corners = corners_of(shares.curves[i], axis);
    figure.data += fmt::format("{}# {}\n# {}, {}{}: corners of the stairs\n{}", block == 0 ? "" : "\n\n",
                               one_line(study.solvers[i]), shares.label, shares.share_of,
                               corners.has_band ? ", and its interval" : "", corners.rows);
    const std::string source = fmt::format("'{}.dat' index {} using (shown_x($1)):", figure.name, block++);
    if (corners.has_band && study.solvers.size() <= most_bands) {
      fills.push_back(fmt::format("{}3:4 with filledcurves ls {} fillstyle transparent solid 0.13 noborder notitle",
                                  source, place + 1));
    }
    add_curve(lines, {.source = source + "2", .rows = corners.count, .solver = place, .label = study.solvers[i]});
  }
  add_legend(figure, labels);
  fills.insert(fills.end(), lines.begin(), lines.end());
  figure.plot = plot_command(fills);
}

}  // namespace ikbench::figures
