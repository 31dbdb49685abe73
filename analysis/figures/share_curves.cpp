#include "analysis/figures/share_curves.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "analysis/figures/figure_parts.hpp"
#include "analysis/inference/text.hpp"
#include "numerics/number.hpp"

namespace ikbench::figures {

using namespace numerics;
using namespace results;
using namespace inference;

namespace {

constexpr double cost_spread_for_logarithmic = 4;
constexpr double decades_for_powers = 2;  // these contain at least two powers
constexpr double margin = 0.02;           // of the axis

CostAxis axis_between(double left, double right, std::string ticks) {
  return {.left = left,
          .right = right,
          .settings = fmt::format("{0}set xrange [{1}:{2}]\nshown_x(x) = x < {1} ? {1} : (x > {2} ? {2} : x)\n", ticks,
                                  text_of(left), text_of(right))};
}

// Ticks at 1, 2 and 5 times every power of ten within the axis.
std::string round_ticks(double smallest, double largest) {
  std::vector<std::string> ticks;
  for (int decade = static_cast<int>(std::floor(std::log10(smallest))); std::pow(10, decade) <= largest; ++decade) {
    for (const int digit : {1, 2, 5}) ticks.push_back(fmt::format("{}e{}", digit, decade));
  }
  return fmt::format("set format x '%g'\nset xtics ({})\n", fmt::join(ticks, ", "));
}

}  // namespace

CostAxis cost_axis(double smallest, double largest) {
  if (!(smallest > 0) || !(largest >= smallest) || !std::isfinite(largest)) return axis_between(1, 10, "unset xtics\n");
  // gnuplot works in doubles: 300 decades either way.
  smallest = std::clamp(smallest, 1e-300, 1e300);
  largest = std::clamp(largest, 1e-300, 1e300);
  if (largest < cost_spread_for_logarithmic * smallest) {
    const double room = largest > smallest ? margin * (largest - smallest) : 0.5 * smallest;
    const double left = smallest - room, right = largest + room;
    return axis_between(left, right,
                        fmt::format("set format x '%g'\nset xtics {}\n", text_of(round_step(right - left))));
  }
  const double decades = std::log10(largest) - std::log10(smallest);
  const double room = std::pow(10, margin * decades);
  if (decades <= decades_for_powers) {
    return axis_between(smallest / room, largest * room, "set logscale x\n" + round_ticks(smallest, largest));
  }
  const int step = 1 + static_cast<int>(decades / 8);
  // From a decade below the axis on: gnuplot 5.4 counts ticks without a start from the wrong place.
  const int first = step * static_cast<int>(std::floor((std::log10(smallest) - 1) / step));
  return axis_between(
      smallest / room, largest * room,
      fmt::format("set logscale x\nset xtics enhanced 1e{}, 1e{}\nset format x '10^{{%T}}'\nset mxtics {}\n", first,
                  step, step == 1 ? 10 : 1));
}

CostAxis ratio_axis(double largest) {
  constexpr double powers_of_two = 12;  // beyond, powers of ten are easier to read
  const double powers = std::clamp(std::ceil(std::log2(std::max(largest, 1.0))), 1.0, 990.0);
  const double decades = std::ceil(std::log10(std::max(largest, 10.0)));
  if (powers > powers_of_two) {
    return axis_between(std::pow(10, -margin * decades), std::pow(10, std::min(decades, 299.0)),
                        fmt::format("set logscale x\nset xtics enhanced 1, 1e{}\nset format x '10^{{%T}}'\n",
                                    1 + static_cast<int>(decades) / 8));
  }
  return axis_between(std::exp2(-margin * powers), std::exp2(powers),
                      fmt::format("set logscale x 2\nset xtics enhanced 1, 2**{}\nset format x '2^{{%L}}'\n",
                                  1 + static_cast<int>(powers) / 8));
}

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

Corners corners_of(const std::vector<Share>& curve, const CostAxis& axis) {
  Corners corners;
  corners.has_band = std::ranges::any_of(curve, [](const Share& share) { return std::isfinite(share.low); });
  Share before{.at = axis.left, .share = 0, .low = 0, .high = 0};
  corners.add(std::min(axis.left, curve.front().at), before);
  for (const Share& share : curve) {
    corners.add(share.at, before);
    const bool is_step = share.share != before.share;
    before = share;
    if (is_step) corners.add(share.at, before);
  }
  corners.add(axis.right, before);
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
  const CostAxis axis = shares.is_ratio ? ratio_axis(largest) : cost_axis(smallest, largest);
  figure.settings =
      axis.settings + fmt::format("set xlabel {}\nset ylabel {}\nset yrange [-0.02:1.02]\nset ytics 0.2\n",
                                  gnuplot_string(shares.label), gnuplot_string(shares.share_of));
  std::vector<std::string> fills{"NaN notitle"}, lines, labels = study.solvers;
  int block = 0;
  for (std::size_t i = 0; i < shares.curves.size(); ++i) {
    if (shares.curves[i].empty()) {
      labels[i] = add_missing_curve(lines, i, study.solvers[i]);
      continue;
    }
    const Corners corners = corners_of(shares.curves[i], axis);
    figure.data += fmt::format("{}# {}\n# {}, {}{}: corners of the stairs\n{}", block == 0 ? "" : "\n\n",
                               one_line(study.solvers[i]), shares.label, shares.share_of,
                               corners.has_band ? ", and its interval" : "", corners.rows);
    const std::string source = fmt::format("'{}.dat' index {} using (shown_x($1)):", figure.name, block++);
    if (corners.has_band && study.solvers.size() <= most_bands) {
      fills.push_back(fmt::format("{}3:4 with filledcurves ls {} fillstyle transparent solid 0.13 noborder notitle",
                                  source, i + 1));
    }
    add_curve(lines, {.source = source + "2", .rows = corners.count, .solver = i, .label = study.solvers[i]});
  }
  add_legend(figure, labels);
  fills.insert(fills.end(), lines.begin(), lines.end());
  figure.plot = plot_command(fills);
}

}  // namespace ikbench::figures
