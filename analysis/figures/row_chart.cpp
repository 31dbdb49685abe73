#include "analysis/figures/row_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/figures/figure_parts.hpp"
#include "analysis/inference/text.hpp"
#include "numerics/number.hpp"

namespace ikbench::figures {

using namespace numerics;
using namespace inference;

namespace {

constexpr double widest_in_one_column_cm = 2.8;
constexpr std::size_t longest_row_label = 2 * longest_label;  // two names in a row of a comparison
constexpr double row_spread_for_logarithmic = 30;
constexpr double smallest_range = 1e-290;  // of a linear axis: denormal numbers have no round steps

std::string logarithmic_rows(const RowAxis& axis) {
  const int decades = static_cast<int>(std::lround(std::log10(axis.high) - std::log10(axis.low)));
  const int decades_per_tick = 1 + (decades - 1) / 7;
  return fmt::format(
      "set logscale x\nset format x '10^{{%T}}'\nset xrange [{0}:{1}]\nset xtics 1e{2}\nset mxtics {3}\n"
      "place(x) = x > {0} ? x : (x <= {0} ? {0} : NaN)\n",
      text_of(axis.low), text_of(axis.high), decades_per_tick, decades_per_tick == 1 ? 10 : 1);
}

// Ratios to mark between two: powers of ten; 1, 2 and 5 times these; or round steps, by how far apart they are.
std::vector<double> ratio_ticks(double low, double high) {
  std::vector<double> ticks;
  const double decades = std::log10(high) - std::log10(low);
  if (decades < 0.7) {
    const double step = round_step(high - low);
    for (double tick = std::ceil(low / step); tick * step <= high; ++tick) ticks.push_back(tick * step);
    return ticks;
  }
  const int every = 1 + static_cast<int>(decades / 7);
  for (int exponent = static_cast<int>(std::floor(std::log10(low))); std::pow(10, exponent) <= high; ++exponent) {
    if (exponent % every != 0) continue;
    for (const double multiple : {1.0, 2.0, 5.0}) {
      const double tick = multiple * std::pow(10, exponent);
      if (tick >= low && tick <= high && (multiple == 1 || decades <= 3)) ticks.push_back(tick);
    }
  }
  return ticks;
}

std::string labelled(std::string settings, const std::string& quantity) {
  return std::move(settings) + fmt::format("set xlabel {} noenhanced\n", gnuplot_string(shortened(quantity, 60)));
}

// A round step, and as many digits as tell its multiples apart.
std::string linear_settings(const RowAxis& axis) {
  const double largest = std::max(std::abs(axis.low), std::abs(axis.high));
  const int digits = std::clamp(2 + static_cast<int>(std::ceil(std::log10(largest / (axis.high - axis.low)))), 6, 17);
  const double rough = (axis.high - axis.low) / (digits > 6 ? 2 : 4);
  const double decade = std::pow(10, std::floor(std::log10(rough)));
  const double ratio = rough / decade;
  const double step = decade * (ratio > 7 ? 10 : ratio > 3.5 ? 5 : ratio > 1.5 ? 2 : 1);
  return fmt::format("set format x '%.{}g'\n{}set xrange [{}:{}]\nset xtics {}\nplace(x) = x\n", digits,
                     digits > 6 ? "set rmargin 8\n" : "", text_of(axis.low), text_of(axis.high), text_of(step));
}

}  // namespace

bool is_drawable(double value) { return std::abs(value) <= largest_drawable; }

double label_cm(std::string_view label) {
  constexpr std::string_view narrow = "fijlrt.,:;|!'()[] -";
  constexpr std::string_view wide = "mwMW@%";
  double cm = 0;
  for (const char c : label) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0) == 0x80) continue;
    const bool capital = c >= 'A' && c <= 'Z';
    cm += narrow.find(c) != std::string_view::npos ? 0.09
          : wide.find(c) != std::string_view::npos ? 0.21
          : byte >= 0xE3                           ? 0.25
          : capital                                ? 0.17
                                                   : 0.14;
  }
  return cm;
}

void add_rows(Figure& figure, std::span<const std::string> labels, double row_cm) {
  std::string ticks;
  double widest_cm = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const std::string label = row_label(labels[i], longest_row_label);
    widest_cm = std::max(widest_cm, label_cm(label));
    ticks += fmt::format("{}{} {}", i == 0 ? "" : ", ", tick_label(label), i + 1);
  }
  if (widest_cm > widest_in_one_column_cm) figure.width_cm = two_columns_cm;
  figure.height_cm = 1.4 + row_cm * static_cast<double>(std::max<std::size_t>(labels.size(), 1));
  figure.settings += fmt::format(
      "unset key\nset yrange [{}.5:0.5]\nset ytics noenhanced font ',7' ({})\nset border 1\nset ytics scale 0\n"
      "set grid noytics\nset xtics enhanced\n",
      std::max<std::size_t>(labels.size(), 1), ticks);
  if (labels.empty()) figure.settings += "unset ytics\nset label 'nothing to show' at graph 0.5, graph 0.5 center\n";
}

RowAxis row_axis(std::span<const double> values, const NameWithUnit& quantity, Scale scale) {
  std::vector<double> drawable;
  std::ranges::copy_if(values, std::back_inserter(drawable), is_drawable);
  RowAxis axis;
  const auto [unit, factor] = drawn_unit(quantity.unit, drawable.empty() ? 0 : std::ranges::max(drawable));
  for (double& value : drawable) value *= factor;
  if (drawable.empty()) {
    axis.settings = "set xrange [0:1]\nset xtics scale 0 format ' '\nunset grid\nplace(x) = x\n";
  } else {
    const auto [smallest, largest] = std::ranges::minmax(drawable);
    std::vector<double> positive;
    std::ranges::copy_if(drawable, std::back_inserter(positive), [](double value) { return value > 0; });
    const double least = positive.empty() ? 0 : std::ranges::min(positive);
    axis.logarithmic = scale != Scale::linear && smallest >= 0 && least > 0 &&
                       (scale == Scale::logarithmic || largest > row_spread_for_logarithmic * least);
    if (axis.logarithmic) {
      const double low = std::floor(std::log10(std::max(least, 1 / largest_drawable)));
      axis.shows_at_edge = smallest < std::pow(10, low);
      axis.low = std::pow(10, low - (axis.shows_at_edge ? 1 : 0));
      axis.high = std::pow(10, std::max(low + 1, std::ceil(std::log10(largest))));
      axis.settings = logarithmic_rows(axis);
    } else {
      const double magnitude = std::max(std::abs(smallest), std::abs(largest));
      const double room = std::max({0.06 * (largest - smallest), 1e-13 * magnitude, smallest_range});
      const double around =
          largest > smallest ? room : (magnitude > 0 ? std::max(0.1 * magnitude, smallest_range) : 1.0);
      axis.low = smallest - around;
      axis.high = largest + around;
      axis.settings = linear_settings(axis);
    }
  }
  axis.settings += fmt::format("shown(x) = place({} * x)\n", text_of(factor));
  axis.settings = labelled(std::move(axis.settings), text_of({quantity.name, unit}));
  return axis;
}

RowAxis ratio_axis(std::span<const double> ratios, const std::string& quantity) {
  double smallest = 1, largest = 1;
  for (const double ratio : ratios) {
    if (!is_drawable(ratio) || ratio < 1 / largest_drawable) continue;
    smallest = std::min(smallest, ratio);
    largest = std::max(largest, ratio);
  }
  const double room = std::max(1.01, std::pow(largest, 0.06) * std::pow(smallest, -0.06));
  RowAxis axis{.logarithmic = true,
               .low = std::max(smallest / room, 1 / largest_drawable),
               .high = std::min(largest * room, largest_drawable)};
  std::string ticks;
  const bool has_many_decades = axis.high / 1e3 > axis.low;
  for (const double tick : ratio_ticks(axis.low, axis.high)) {
    const std::string label =
        has_many_decades ? fmt::format("10^{{{:.0f}}}", std::log10(tick)) : fmt::format("{:.4g}", tick);
    ticks += fmt::format("{}'{}' {}", ticks.empty() ? "" : ", ", tick == 1 ? "1" : label, text_of(tick));
  }
  axis.settings = labelled(fmt::format("set logscale x\nset xrange [{}:{}]\nset xtics ({})\nshown(x) = x\n",
                                       text_of(axis.low), text_of(axis.high), ticks),
                           quantity);
  return axis;
}

}  // namespace ikbench::figures
