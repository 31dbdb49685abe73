#include "analysis/share_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/figure_parts.hpp"
#include "analysis/text.hpp"
#include "results/number.hpp"

namespace ikbench {
namespace {

std::string ratio_axis(double largest) {
  const int powers = std::clamp(static_cast<int>(std::ceil(std::log2(largest))), 1, 1000);
  const int step = 1 + powers / 8;
  return fmt::format(
      "set logscale x 2\nset xrange [1:2**{}]\nset xtics enhanced 2**{}\nset format x '2^{{%L}}'\n"
      "left_edge = 1\n",
      powers, step);
}

}  // namespace

std::string horizontal_axis(double smallest, double largest) {
  if (!(smallest > 0) || !std::isfinite(largest)) return "set xrange [1:10]\nunset xtics\nleft_edge = 1\n";
  if (!(largest > smallest)) {
    smallest /= 2;
    largest *= 2;
  }
  const double decades = std::log10(largest) - std::log10(smallest);
  std::string settings =
      fmt::format("set logscale x\nset xrange [{0}:{1}]\nleft_edge = {0}\n", text_of(smallest), text_of(largest));
  if (decades > 2.5) {
    const int step = 1 + static_cast<int>(decades / 8);
    settings +=
        fmt::format("set xtics enhanced 1e{}\nset format x '10^{{%T}}'\nset mxtics {}\n", step, step == 1 ? 10 : 1);
    return settings;
  }
  settings += "set format x '%g'\nset xtics (";
  std::string separator;
  for (int decade = static_cast<int>(std::floor(std::log10(smallest))); std::pow(10, decade) <= largest; ++decade) {
    for (const int digit : {1, 2, 5}) {
      settings += fmt::format("{}{}e{}", separator, digit, decade);
      separator = ", ";
    }
  }
  return settings + ")\n";
}

std::string legend_entry(std::size_t solver, const std::string& name) {
  return fmt::format("keyentry with linespoints ls {} title {}", solver + 1,
                     gnuplot_string(shortened(name, longest_label) + " (nothing to show)"));
}

void draw_shares(Figure& figure, const StudyResults& study, const ShareCurves& shares) {
  double smallest = never, largest = 0;
  for (const auto& curve : shares.curves) {
    for (const Share& share : curve) {
      if (share.at > 0) smallest = std::min(smallest, share.at);
      largest = std::max(largest, share.at);
    }
  }
  figure.settings = (shares.is_ratio ? ratio_axis(largest) : horizontal_axis(smallest, largest)) +
                    fmt::format(
                        "set xlabel {}\nset ylabel {}\nset yrange [0:1.02]\nset ytics 0.2\n"
                        "shown_x(x) = x > left_edge ? x : left_edge\n",
                        gnuplot_string(shares.label), gnuplot_string(shares.share_of));
  const double left = shares.is_ratio ? 1 : 0;
  std::vector<std::string> clauses{"NaN notitle"};
  int block = 0;
  for (std::size_t i = 0; i < shares.curves.size(); ++i) {
    const std::vector<Share>& curve = shares.curves[i];
    if (curve.empty()) {
      clauses.push_back(legend_entry(i, study.solvers[i]));
      continue;
    }
    figure.data += fmt::format("{}# {}\n# {}, {}: corners of the stairs\n", block == 0 ? "" : "\n\n",
                               one_line(study.solvers[i]), shares.label, shares.share_of);
    double before = 0;
    figure.data += fmt::format("{} 0\n", text_of(left));
    for (const auto& [at, share] : curve) {
      figure.data += fmt::format("{0} {1}\n{0} {2}\n", text_of(at), text_of(before), text_of(share));
      before = share;
    }
    figure.data += fmt::format("{} {}\n", text_of(std::max(largest, left)), text_of(before));
    if (shares.is_ratio) figure.data += fmt::format("1e301 {}\n", text_of(before));
    clauses.push_back(fmt::format(
        "'{}.dat' index {} using (shown_x($1)):2 with linespoints ls {} pointinterval {} title {}", figure.name,
        block++, i + 1, 2 + 2 * curve.size() / 9, gnuplot_string(shortened(study.solvers[i], longest_label))));
  }
  add_legend(figure, study.solvers);
  figure.plot = plot_command(clauses);
}

}  // namespace ikbench
